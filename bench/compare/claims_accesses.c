/* The accesses that course document 001 gives the queries on winged edges; see claims.h. */
#include "bench/compare/claims_rows.h"
#include "bench/compare/counted_winged_edge.h"

#include "reference/representation/winged_edge_queries.h"

#include <stdlib.h>

enum { START_ROWS = 2 }; /* say only where a walk starts; the document does not count them */

static const struct {
    enum counted_query query;
    bool is_square; /* claimed is the square of what is met */
    const char *name, *text;
} claimed[] = {
    {COUNTED_EDGES_OF_EDGE, false, "accesses-edges-of-edge", "the n edges at an edge: n accesses"},
    {COUNTED_EDGES_OF_FACE, false, "accesses-edges-of-face", "the k edges of a face: k accesses"},
    {COUNTED_EDGES_OF_VERTEX, false, "accesses-edges-of-vertex",
     "the n edges of a vertex: n accesses"},
    {COUNTED_VERTICES_OF_FACE, true, "accesses-vertices-of-face",
     "the k vertices of a face: k^2 accesses"},
    {COUNTED_FACES_OF_FACE, true, "accesses-faces-of-face", "the k faces at a face: k^2 accesses"},
    {COUNTED_FACES_OF_VERTEX, false, "accesses-faces-of-vertex",
     "the n faces of a vertex: n accesses"},
};

static int32_t element_count(const struct winged_edge_mesh *we, enum counted_query query)
{
    switch (query) {
    case COUNTED_EDGES_OF_EDGE:
        return we->edge_count;
    case COUNTED_EDGES_OF_FACE:
    case COUNTED_VERTICES_OF_FACE:
    case COUNTED_FACES_OF_FACE:
        return we->face_count;
    case COUNTED_EDGES_OF_VERTEX:
    case COUNTED_FACES_OF_VERTEX:
    case COUNTED_QUERY_COUNT:
        break;
    }
    return we->vertex_count;
}

/* k of a face, whether or not it has a neighbour everywhere; n elsewhere. */
static int64_t size_of(const struct winged_edge_mesh *we, enum counted_query query, int32_t element)
{
    switch (query) {
    case COUNTED_EDGES_OF_EDGE:
        return winged_edge_edges_of_edge(we, element, NULL, 0);
    case COUNTED_EDGES_OF_FACE:
    case COUNTED_VERTICES_OF_FACE:
    case COUNTED_FACES_OF_FACE:
        return winged_edge_edges_of_face(we, element, NULL, 0);
    case COUNTED_EDGES_OF_VERTEX:
    case COUNTED_FACES_OF_VERTEX:
    case COUNTED_QUERY_COUNT:
        break;
    }
    return winged_edge_edges_of_vertex(we, element, NULL, 0);
}

/* Asks about every element and adds the means. */
static int add_query(struct claims *claims, const char *mesh, const struct winged_edge_mesh *we,
                     size_t which, struct error *err)
{
    enum counted_query query = claimed[which].query;
    double claimed_sum = 0.0, measured_sum = 0.0;
    int64_t asked = 0;
    bool holds = true;
    for (int32_t i = 0; i < element_count(we, query); i++) {
        bool is_vertex = query == COUNTED_EDGES_OF_VERTEX || query == COUNTED_FACES_OF_VERTEX;
        if (is_vertex && we->vertex_edge[i] < 0)
            continue;
        double size = (double)size_of(we, query, i);
        double bound = claimed[which].is_square ? size * size : size;
        double accesses = (double)counted_winged_edge(we, query, i).accesses;
        holds = holds && accesses <= bound + START_ROWS;
        claimed_sum += bound;
        measured_sum += accesses;
        asked++;
    }
    struct claim row = {.name = claimed[which].name,
                        .source = "001",
                        .text = claimed[which].text,
                        .claimed = asked ? claimed_sum / (double)asked : 0.0,
                        .measured = asked ? measured_sum / (double)asked : 0.0,
                        .holds = holds};
    return claims_add(claims, &row, mesh, err);
}

int claims_about_accesses(struct claims *claims, const char *name, const struct polygons *polygons,
                          struct error *err)
{
    struct winged_edge_mesh we;
    float *positions = calloc(3 * (size_t)polygons->vertex_count + 1, sizeof *positions);
    if (!positions)
        return error_set(err, "out of memory: %d vertices", polygons->vertex_count);
    int result = winged_edge_build(&we, polygons, positions, err);
    free(positions);
    for (size_t i = 0; result == 0 && i < sizeof claimed / sizeof *claimed; i++)
        result = add_query(claims, name, &we, i, err);
    winged_edge_release(&we);
    return result;
}
