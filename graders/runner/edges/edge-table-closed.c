/* Calls edge_table_closed once. */
#include "edge-table-closed.h"

#include "graders/runner/shapes.h"

CALL_TABLE(edge_table_closed, TRIANGLES, int32_t, 2)
