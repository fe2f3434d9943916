/* Calls mesh_area once. */
#include "mesh-area.h"

#include "graders/runner/shapes.h"

CALL_REAL(mesh_area, MESH)
