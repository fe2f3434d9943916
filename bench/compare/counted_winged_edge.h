/* The queries of winged_edge_queries.h with every access to a row of a table counted. They are the
 * same source, compiled a second time under other names, so that nothing that is timed counts. */
#ifndef BENCH_COMPARE_COUNTED_WINGED_EDGE_H
#define BENCH_COMPARE_COUNTED_WINGED_EDGE_H

#include <stdint.h>

struct winged_edge_mesh;

enum counted_query {
    COUNTED_EDGES_OF_EDGE,
    COUNTED_EDGES_OF_FACE,
    COUNTED_EDGES_OF_VERTEX,
    COUNTED_VERTICES_OF_FACE,
    COUNTED_FACES_OF_FACE,
    COUNTED_FACES_OF_VERTEX,
    COUNTED_QUERY_COUNT
};

struct counted_answer {
    int64_t count;    /* elements found */
    int64_t accesses; /* rows read; a row read again while it is the last one read counts once */
};

/* Asks about one element: an edge, a face or a vertex, not isolated. Not for several threads. */
struct counted_answer counted_winged_edge(const struct winged_edge_mesh *we,
                                          enum counted_query query, int32_t element);

#endif
