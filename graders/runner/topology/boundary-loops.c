/* Calls boundary_loops once. */
#include "boundary-loops.h"

#include "graders/runner/shapes.h"

CALL_ROWS(boundary_loops, TRIANGLES)
