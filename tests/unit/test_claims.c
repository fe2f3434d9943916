/* The course's claims against measurement: counts of accesses that are known exactly, ratios that
 * follow from the table in exercises/models/README.md, and that the whole can be collected. */
#include "bench/compare/claims.h"
#include "bench/compare/counted_winged_edge.h"
#include "reference/mesh/generate.h"
#include "reference/representation/winged_edge_queries.h"
#include "tests/unit/course_prism.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

static const struct claim *find(const struct claims *claims, const char *name, const char *mesh)
{
    for (int i = 0; i < claims->count; i++)
        if (strcmp(claims->rows[i].name, name) == 0 && strcmp(claims->rows[i].mesh, mesh) == 0)
            return claims->rows + i;
    fail_msg("no claim %s on %s", name, mesh);
    return NULL;
}

static void require_claim(const struct claims *claims, const char *name, const char *mesh,
                          double claimed, double measured, bool holds)
{
    const struct claim *claim = find(claims, name, mesh);
    assert_true(fabs(claim->claimed - claimed) < 1e-9);
    if (fabs(claim->measured - measured) >= 1e-9)
        fail_msg("%s on %s: %g, not %g", name, mesh, claim->measured, measured);
    assert_int_equal(claim->holds, holds);
}

/* -- queries of document 001 ---------------------------------------------------------------- */

static bool is_among(int32_t number, const int32_t *numbers, int32_t count)
{
    for (int32_t i = 0; i < count; i++)
        if (numbers[i] == number)
            return true;
    return false;
}

/* On the document's own example: faces 0 and 4 of it are triangles, the others have four corners;
 * every vertex has three edges. Faces here are numbered as they are read. */
static void queries_on_the_documents_example(void **state)
{
    (void)state;
    struct winged_edge_mesh we;
    int32_t found[16];
    assert_int_equal(winged_edge_build(&we, &prism_polygons, prism_positions, NULL), 0);
    for (int32_t f = 0; f < PRISM_FACES; f++) {
        int32_t first = prism_polygons.face_starts[f];
        int32_t k = prism_polygons.face_starts[f + 1] - first;
        assert_int_equal(winged_edge_vertices_of_face(&we, f, found, 16), k);
        assert_memory_equal(found, prism_polygons.corners + first, 4 * (size_t)k);
        assert_int_equal(winged_edge_edges_of_face(&we, f, found, 16), k);
        for (int32_t i = 0; i < k; i++)
            assert_true(we.edges[found[i]].face[0] == f || we.edges[found[i]].face[1] == f);
        assert_int_equal(winged_edge_faces_of_face(&we, f, found, 16), k);
        assert_false(is_among(f, found, k));
    }
    for (int32_t v = 0; v < PRISM_VERTICES; v++) {
        assert_int_equal(winged_edge_edges_of_vertex(&we, v, found, 16), 3);
        for (int i = 0; i < 3; i++)
            assert_true(we.edges[found[i]].vertex[0] == v || we.edges[found[i]].vertex[1] == v);
        assert_int_equal(winged_edge_faces_of_vertex(&we, v, found, 16), 3);
    }
    for (int32_t e = 0; e < PRISM_EDGES; e++) {
        assert_int_equal(winged_edge_edges_of_edge(&we, e, found, 16), 4);
        for (int way = 0; way < 2; way++)
            assert_true(is_among(we.edges[e].next[way], found, 4) &&
                        is_among(we.edges[e].previous[way], found, 4));
    }
    winged_edge_release(&we);
}

static void queries_stop_at_boundaries(void **state)
{
    (void)state;
    struct mesh mesh;
    struct winged_edge_mesh we;
    int32_t found[16] = {0};
    assert_int_equal(generate_fan(&mesh, 3, NULL), 0); /* vertex 0 has three triangles */
    struct polygons polygons = polygons_of_mesh(&mesh);
    assert_int_equal(winged_edge_build(&we, &polygons, mesh.positions, NULL), 0);
    assert_int_equal(winged_edge_edges_of_vertex(&we, 0, found, 16), 4);
    assert_int_equal(winged_edge_faces_of_vertex(&we, 0, found, 16), 3);
    assert_int_equal(winged_edge_faces_of_face(&we, 0, found, 16), 1);
    assert_int_equal(winged_edge_faces_of_face(&we, 1, found, 1), 2); /* room for one */
    winged_edge_release(&we);
    mesh_release(&mesh);
}

/* -- accesses ------------------------------------------------------------------------------- */

/* What winged_edge_queries.h says: k + 1, n + 1, and n + 2 of an edge. */
static void accesses_are_what_the_header_says(void **state)
{
    (void)state;
    struct winged_edge_mesh we;
    assert_int_equal(winged_edge_build(&we, &prism_polygons, prism_positions, NULL), 0);
    for (int query = 0; query < COUNTED_QUERY_COUNT; query++) {
        bool of_edge = query == COUNTED_EDGES_OF_EDGE;
        bool of_vertex = query == COUNTED_EDGES_OF_VERTEX || query == COUNTED_FACES_OF_VERTEX;
        int32_t elements = of_edge ? PRISM_EDGES : of_vertex ? PRISM_VERTICES : PRISM_FACES;
        for (int32_t i = 0; i < elements; i++) {
            struct counted_answer answer = counted_winged_edge(&we, (enum counted_query)query, i);
            assert_int_equal(answer.accesses, answer.count + (of_edge ? 2 : 1));
        }
    }
    winged_edge_release(&we);
}

static void accesses_grow_with_faces_and_valences(void **state)
{
    (void)state;
    struct claims claims = {0};
    assert_int_equal(claims_about_accesses(&claims, "the example", &prism_polygons, NULL), 0);
    assert_int_equal(claims.count, COUNTED_QUERY_COUNT);
    /* two triangles and three quads; three edges at every vertex, four at every edge */
    require_claim(&claims, "accesses-edges-of-edge", "the example", 4.0, 6.0, true);
    require_claim(&claims, "accesses-edges-of-face", "the example", 18 / 5.0, 23 / 5.0, true);
    require_claim(&claims, "accesses-edges-of-vertex", "the example", 3.0, 4.0, true);
    require_claim(&claims, "accesses-vertices-of-face", "the example", 66 / 5.0, 23 / 5.0, true);
    require_claim(&claims, "accesses-faces-of-face", "the example", 66 / 5.0, 23 / 5.0, true);
    require_claim(&claims, "accesses-faces-of-vertex", "the example", 3.0, 4.0, true);
    claims_release(&claims);
    claims_release(&claims);
}

/* -- ratios --------------------------------------------------------------------------------- */

static void ratios_of_a_grid_are_known(void **state)
{
    (void)state;
    struct mesh mesh;
    struct claims claims = {0};
    assert_int_equal(generate_grid(&mesh, 40, 60, NULL), 0);
    assert_int_equal(claims_about_mesh(&claims, "grid", &mesh, NULL), 0);
    const double vertices = 41 * 61, faces = 2 * 40 * 60, edges = vertices + faces - 1;
    require_claim(&claims, "faces-are-twice-vertices", "grid", 2, faces / vertices, true);
    require_claim(&claims, "edges-are-three-times-vertices", "grid", 3, edges / vertices, true);
    require_claim(&claims, "valence-is-six", "grid", 6, 2 * edges / vertices, true);
    require_claim(&claims, "isolated-triangles-process-six-times", "grid", 6, 3 * faces / vertices,
                  true);
    require_claim(&claims, "indexed-mesh-processes-once", "grid", 1, 1, true);
    const struct claim *search = find(&claims, "adjacency-in-an-indexed-mesh-is-a-search", "grid");
    assert_true(search->claimed == faces && search->holds);
    mesh_release(&mesh);
    claims_release(&claims);
}

static void one_triangle_is_no_large_mesh(void **state)
{
    (void)state;
    struct mesh mesh;
    struct claims claims = {0};
    assert_int_equal(generate_tetrahedron(&mesh, NULL), 0);
    assert_int_equal(claims_about_mesh(&claims, "tetrahedron", &mesh, NULL), 0);
    require_claim(&claims, "faces-are-twice-vertices", "tetrahedron", 2, 1, false);
    require_claim(&claims, "valence-is-six", "tetrahedron", 6, 3, false);
    mesh_release(&mesh);
    claims_release(&claims);
}

/* Heap blocks are up to a page larger than what was asked for. */
static void sizes_are_those_of_the_problems(void **state)
{
    static const struct {
        const char *name, *mesh;
        double claimed, off;
    } sizes[] = {{"voxel-sphere-bytes", "sphere-k16", 0.5, 0.02},
                 {"mesh-sphere-bytes", "sphere-k16", 9, 0.1},
                 {"mesh-beats-voxels-from", "sphere", 288, 2},
                 {"indexed-grid-bytes", "grid-128x128", 579.01, 8.1},
                 {"strips-grid-bytes", "grid-128x128", 388, 4}};
    (void)state;
    struct claims claims = {0};
    assert_int_equal(claims_about_sizes(&claims, NULL), 0);
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const struct claim *claim = find(&claims, sizes[i].name, sizes[i].mesh);
        assert_true(claim->claimed == sizes[i].claimed && claim->holds);
        if (fabs(claim->measured - claim->claimed) > sizes[i].off)
            fail_msg("%s is %g", claim->name, claim->measured);
    }
    claims_release(&claims);
}

static void all_claims_are_collected(void **state)
{
    (void)state;
    struct claims claims = {0};
    struct error err = {0};
    if (claims_collect(&claims, "exercises/models", &err))
        fail_msg("%s", err.text);
    require_claim(&claims, "edges-are-three-times-vertices", "horse", 3, 12000 / 4002.0, true);
    require_claim(&claims, "faces-are-twice-vertices", "bunny", 2, 3712 / 1877.0, true);
    require_claim(&claims, "edges-are-three-times-vertices", "spider", 3, 2100 / 762.0, true);
    require_claim(&claims, "accesses-edges-of-face", "mug", 3, 4, true);
    require_claim(&claims, "accesses-vertices-of-face", "mug", 9, 4, true);
    for (int i = 2; i < claims.count; i++) /* rows of one claim stand together */
        for (int j = 0; j < i - 1; j++)
            assert_true(strcmp(claims.rows[i].name, claims.rows[j].name) != 0 ||
                        strcmp(claims.rows[i].name, claims.rows[i - 1].name) == 0);
    json_t *json = claims_to_json(&claims);
    assert_int_equal(json_array_size(json), claims.count);
    json_t *first = json_array_get(json, 0);
    assert_string_equal(json_string_value(json_object_get(first, "name")), claims.rows[0].name);
    assert_true(json_is_boolean(json_object_get(first, "holds")));
    json_decref(json);
    claims_release(&claims);
    assert_int_equal(claims_collect(&claims, "/nowhere", &err), -1);
    assert_non_null(strstr(err.text, "/nowhere"));
    claims_release(&claims);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(queries_on_the_documents_example),
        cmocka_unit_test(queries_stop_at_boundaries),
        cmocka_unit_test(accesses_are_what_the_header_says),
        cmocka_unit_test(accesses_grow_with_faces_and_valences),
        cmocka_unit_test(ratios_of_a_grid_are_known),
        cmocka_unit_test(one_triangle_is_no_large_mesh),
        cmocka_unit_test(sizes_are_those_of_the_problems),
        cmocka_unit_test(all_claims_are_collected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
