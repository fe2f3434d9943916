/* Calls winged_edge_build once. */
#include "winged-edge-build.h"

#include "graders/runner/shapes.h"

CALL_TABLE_GIVEN_TWO(winged_edge_build, POLYGONS, struct winged_edge, 1, int32_t,
                     given.vertex_count, int32_t, given.face_count)
