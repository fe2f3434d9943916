/* The tables of course document 001; see course_prism.h. */
#include "tests/unit/course_prism.h"

const float prism_positions[3 * PRISM_VERTICES] = {0, 0, 1, 1, 0, 1, 1, 1, 1,
                                                   0, 1, 1, 1, 1, 0, 1, 0, 0};

static const int32_t corners[18] = {0,      1, 2, 3,      /**/ 1, 5, 4, 2, /**/ 3, 4, 5, 0,
                                    /**/ 3, 2, 4, /**/ 1, 0,      5};
static const int32_t starts[PRISM_FACES + 1] = {0, 4, 8, 12, 15, 18};

const struct polygons prism_polygons = {corners, starts, PRISM_VERTICES, PRISM_FACES};
const int32_t prism_reading[PRISM_FACES] = {2, 1, 3, 0, 4};

const int32_t prism_winged_edges[PRISM_EDGES][8] = {
    {0, 1, 2, 4, 3, 1, 4, 8}, {1, 2, 2, 1, 0, 2, 6, 4}, {2, 3, 2, 0, 1, 3, 7, 6},
    {3, 0, 2, 3, 2, 0, 8, 7}, {1, 5, 1, 4, 1, 5, 8, 0}, {5, 4, 1, 3, 4, 6, 7, 8},
    {4, 2, 1, 0, 5, 1, 2, 7}, {3, 4, 3, 0, 3, 5, 6, 2}, {5, 0, 3, 4, 5, 3, 0, 4},
};

const int32_t prism_face_edge[PRISM_FACES] = {2, 5, 1, 3, 4};
const int32_t prism_vertex_edge[PRISM_VERTICES] = {0, 1, 2, 3, 6, 8};

const int32_t prism_half_edges[PRISM_HALF_EDGES][6] = {
    {0, 1, 9, 2, 3, 1},  {1, 2, 10, 2, 0, 2}, {2, 3, 11, 2, 1, 3}, {3, 0, 12, 2, 2, 0},
    {1, 5, 13, 1, 1, 5}, {5, 4, 14, 1, 4, 6}, {4, 2, 15, 1, 5, 1}, {3, 4, 16, 3, 3, 5},
    {5, 0, 17, 3, 5, 3}, {1, 0, 0, 4, 4, 8},  {2, 1, 1, 1, 6, 4},  {3, 2, 2, 0, 7, 6},
    {0, 3, 3, 3, 8, 7},  {5, 1, 4, 4, 8, 0},  {4, 5, 5, 3, 7, 8},  {2, 4, 6, 0, 2, 7},
    {4, 3, 7, 0, 6, 2},  {0, 5, 8, 4, 0, 4},
};

const int32_t prism_half_edge_links[PRISM_HALF_EDGES][2] = {
    {3, 1},   {0, 2}, {1, 3},   {2, 0}, {10, 5}, {4, 6}, {5, 10},  {12, 14}, {14, 12},
    {13, 17}, {6, 4}, {16, 15}, {8, 7}, {17, 9}, {7, 8}, {11, 16}, {15, 11}, {9, 13},
};
