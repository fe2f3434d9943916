/* Half edges: the table of course document 001 (renumbered), holes, walks, and damage found. */
#include "reference/mesh/generate.h"
#include "reference/representation/half_edge.h"
#include "tests/unit/course_prism.h"
#include "tests/unit/damage.h"
#include "tests/unit/mesh_measures.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

static struct half_edge_mesh built(const struct mesh *mesh)
{
    struct half_edge_mesh he;
    struct polygons polygons = polygons_of_mesh(mesh);
    assert_int_equal(half_edge_build(&he, &polygons, mesh->positions, NULL), 0);
    return he;
}

/* Number in the document's table of the half edge from `start` to `end`. */
static int32_t document_number(int32_t start, int32_t end)
{
    for (int32_t h = 0; h < PRISM_HALF_EDGES; h++)
        if (prism_half_edges[h][0] == start && prism_half_edges[h][1] == end)
            return h;
    fail_msg("no half edge %d -> %d", start, end);
    return -1;
}

static int32_t renumbered(const struct half_edge_mesh *he, int32_t h)
{
    return document_number(he->half_edges[h].origin, half_edge_end(he, h));
}

static void the_table_of_document_001_is_built(void **state)
{
    (void)state;
    struct half_edge_mesh he;
    assert_int_equal(half_edge_build(&he, &prism_polygons, prism_positions, NULL), 0);
    assert_int_equal(half_edge_check(&he, NULL), 0);
    assert_int_equal(he.half_edge_count, PRISM_HALF_EDGES);
    for (int32_t h = 0; h < PRISM_HALF_EDGES; h++) {
        int32_t number = renumbered(&he, h);
        const int32_t *row = prism_half_edges[number], *links = prism_half_edge_links[number];
        assert_int_equal(renumbered(&he, he.half_edges[h].twin), row[2]);
        assert_int_equal(prism_reading[he.half_edges[h].face], row[3]);
        assert_int_equal(renumbered(&he, half_edge_previous(&he, h)), links[0]);
        assert_int_equal(renumbered(&he, he.half_edges[h].next), links[1]);
    }
    half_edge_release(&he);
}

/* Every entry of the document's Aa and As names the edge of the right half edge. */
static void the_document_links_edges_where_we_link_half_edges(void **state)
{
    (void)state;
    for (int h = 0; h < PRISM_HALF_EDGES; h++)
        for (int i = 0; i < 2; i++)
            assert_int_equal(prism_half_edge_links[h][i] % PRISM_EDGES, prism_half_edges[h][4 + i]);
    assert_int_equal(prism_half_edge_links[9][0], 13); /* 1 -> 0 */
    assert_int_equal(prism_half_edge_links[9][1], 17);
}

static void holes_are_loops_with_the_hole_to_their_left(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_disc(&mesh, 1, 7, NULL), 0);
    struct half_edge_mesh he = built(&mesh);
    int32_t inner = 3 * mesh.triangle_count;
    assert_int_equal(he.half_edge_count, inner + 7);
    int32_t h = inner, length = 0;
    do {
        assert_int_equal(he.half_edges[h].face, -1);
        assert_int_equal(half_edge_previous(&he, he.half_edges[h].next), h);
        assert_true(half_edge_on_boundary(&he, he.half_edges[h].origin));
        length++;
        h = he.half_edges[h].next;
    } while (h != inner);
    assert_int_equal(length, 7);
    half_edge_release(&he);
    mesh_release(&mesh);
}

/* Document 004's exercise 2, on a vertex inside, one on the boundary, and one without faces. */
static void half_edges_that_leave_a_vertex_are_listed(void **state)
{
    (void)state;
    float positions[18] = {0};
    int32_t triangles[12] = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
    struct mesh mesh = {positions, triangles, 6, 4};
    struct half_edge_mesh he = built(&mesh);
    int32_t found[8];
    assert_int_equal(half_edge_outgoing(&he, 0, found, 8), 4);
    for (int i = 0; i < 4; i++) {
        assert_int_equal(he.half_edges[found[i]].origin, 0);
        assert_int_equal(half_edge_end(&he, found[i]), 1 + i); /* counter-clockwise */
    }
    assert_int_equal(half_edge_outgoing(&he, 2, found, 8), 3);
    assert_int_equal(half_edge_end(&he, found[0]), 3);
    assert_int_equal(half_edge_end(&he, found[1]), 0);
    assert_int_equal(half_edge_end(&he, found[2]), 1);
    assert_int_equal(he.half_edges[found[2]].face, -1);
    assert_int_equal(half_edge_outgoing(&he, 5, found, 8), 0);
    found[1] = -7;
    assert_int_equal(half_edge_outgoing(&he, 0, found, 1), 4); /* no room for more than one */
    assert_int_equal(found[1], -7);
    half_edge_release(&he);
}

/* -- damage --------------------------------------------------------------------------------- */

static int check(const void *self, struct error *err)
{
    return half_edge_check(self, err);
}

static uint64_t shape_of(const void *self)
{
    struct mesh mesh;
    assert_int_equal(half_edge_to_mesh(self, &mesh, NULL), 0);
    uint64_t hash = surface_hash(&mesh);
    mesh_release(&mesh);
    return hash;
}

static void damage_is_found(void **state)
{
    (void)state;
    for (int i = 0; i < DAMAGE_MESHES; i++) {
        struct mesh mesh = damage_mesh(i);
        struct half_edge_mesh he = built(&mesh);
        const struct damage damage = {&he, check, shape_of};
        damage_every_number(&damage, "half_edges", &he.half_edges->origin,
                            4 * (int64_t)he.half_edge_count, NO_CHOICE);
        damage_every_number(&damage, "vertex_half_edge", he.vertex_half_edge, he.vertex_count,
                            SOME_CHOICE);
        damage_every_number(&damage, "face_half_edge", he.face_half_edge, he.face_count,
                            SOME_CHOICE);
        half_edge_release(&he);
        mesh_release(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_table_of_document_001_is_built),
        cmocka_unit_test(the_document_links_edges_where_we_link_half_edges),
        cmocka_unit_test(holes_are_loops_with_the_hole_to_their_left),
        cmocka_unit_test(half_edges_that_leave_a_vertex_are_listed),
        cmocka_unit_test(damage_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
