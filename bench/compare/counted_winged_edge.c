/* The winged-edge queries with accesses counted; see counted_winged_edge.h. */
#include "bench/compare/counted_winged_edge.h"

static const void *last_row;
static int64_t accesses;

static inline void count_access(const void *row)
{
    accesses += row != last_row;
    last_row = row;
}

#define WINGED_EDGE_ACCESS(row) count_access(row)
#define winged_edge_edges_of_edge counted_edges_of_edge
#define winged_edge_edges_of_face counted_edges_of_face
#define winged_edge_edges_of_vertex counted_edges_of_vertex
#define winged_edge_vertices_of_face counted_vertices_of_face
#define winged_edge_faces_of_face counted_faces_of_face
#define winged_edge_faces_of_vertex counted_faces_of_vertex
#include "reference/representation/winged_edge_queries.c"

struct counted_answer counted_winged_edge(const struct winged_edge_mesh *we,
                                          enum counted_query query, int32_t element)
{
    static int32_t (*const queries[COUNTED_QUERY_COUNT])(const struct winged_edge_mesh *, int32_t,
                                                         int32_t *, int32_t) = {
        [COUNTED_EDGES_OF_EDGE] = counted_edges_of_edge,
        [COUNTED_EDGES_OF_FACE] = counted_edges_of_face,
        [COUNTED_EDGES_OF_VERTEX] = counted_edges_of_vertex,
        [COUNTED_VERTICES_OF_FACE] = counted_vertices_of_face,
        [COUNTED_FACES_OF_FACE] = counted_faces_of_face,
        [COUNTED_FACES_OF_VERTEX] = counted_faces_of_vertex};
    struct counted_answer answer;
    last_row = 0;
    accesses = 0;
    answer.count = queries[query](we, element, 0, 0);
    answer.accesses = accesses;
    return answer;
}
