/* Winged edges: the worked table of course document 001, holes, refusals, and damage found. */
#include "reference/mesh/generate.h"
#include "reference/representation/winged_edge.h"
#include "tests/unit/course_prism.h"
#include "tests/unit/damage.h"
#include "tests/unit/mesh_measures.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

static struct winged_edge_mesh built(const struct mesh *mesh)
{
    struct winged_edge_mesh we;
    struct polygons polygons = polygons_of_mesh(mesh);
    assert_int_equal(winged_edge_build(&we, &polygons, mesh->positions, NULL), 0);
    return we;
}

static void the_table_of_document_001_is_built(void **state)
{
    (void)state;
    struct winged_edge_mesh we;
    assert_int_equal(winged_edge_build(&we, &prism_polygons, prism_positions, NULL), 0);
    assert_int_equal(winged_edge_check(&we, NULL), 0);
    assert_int_equal(we.edge_count, PRISM_EDGES);
    for (int e = 0; e < PRISM_EDGES; e++) {
        const struct winged_edge *edge = we.edges + e;
        const int32_t *want = prism_winged_edges[e];
        const int32_t got[8] = {edge->vertex[0],
                                edge->vertex[1],
                                prism_reading[edge->face[0]],
                                prism_reading[edge->face[1]],
                                edge->previous[0],
                                edge->next[0],
                                edge->previous[1],
                                edge->next[1]};
        assert_memory_equal(got, want, sizeof got);
    }
    winged_edge_release(&we);
}

/* The document names any edge of a face or vertex; so do we. */
static void the_documents_choice_of_edges_is_accepted(void **state)
{
    (void)state;
    struct winged_edge_mesh we;
    assert_int_equal(winged_edge_build(&we, &prism_polygons, prism_positions, NULL), 0);
    for (int f = 0; f < PRISM_FACES; f++)
        we.face_edge[f] = prism_face_edge[prism_reading[f]];
    memcpy(we.vertex_edge, prism_vertex_edge, sizeof prism_vertex_edge);
    assert_int_equal(winged_edge_check(&we, NULL), 0);
    winged_edge_release(&we);
}

static void links_on_a_boundary_lead_along_the_hole(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_one_triangle(&mesh, NULL), 0);
    struct winged_edge_mesh we = built(&mesh);
    struct winged_side first = {0, 1}, side = first;
    assert_int_equal(winged_edge_face(&we, side), -1);
    for (int i = 0; i < 3; i++) {
        struct winged_side next = winged_edge_next(&we, side);
        assert_int_equal(winged_edge_start(&we, next), winged_edge_end(&we, side));
        assert_int_equal(winged_edge_face(&we, next), -1);
        side = next;
    }
    assert_int_equal(side.edge, first.edge);
    winged_edge_release(&we);
    mesh_release(&mesh);
}

static void faces_of_other_sizes_do_not_become_triangles(void **state)
{
    (void)state;
    struct winged_edge_mesh we;
    struct mesh mesh;
    struct error err = {0};
    assert_int_equal(winged_edge_build(&we, &prism_polygons, prism_positions, NULL), 0);
    assert_int_equal(winged_edge_to_mesh(&we, &mesh, &err), -1);
    assert_string_equal(err.text, "face 0 is no triangle");
    winged_edge_release(&we);
}

static void edges_are_found(void **state)
{
    (void)state;
    struct winged_edge_mesh we;
    assert_int_equal(winged_edge_build(&we, &prism_polygons, prism_positions, NULL), 0);
    int found = 0;
    for (int32_t u = 0; u < PRISM_VERTICES; u++)
        for (int32_t v = 0; v < PRISM_VERTICES; v++) {
            int32_t e = winged_edge_find(&we, u, v);
            assert_int_equal(e, winged_edge_find(&we, v, u));
            if (e < 0)
                continue;
            assert_true(we.edges[e].vertex[0] == u || we.edges[e].vertex[1] == u);
            assert_true(we.edges[e].vertex[0] == v || we.edges[e].vertex[1] == v);
            found++;
        }
    assert_int_equal(found, 2 * PRISM_EDGES);
    winged_edge_release(&we);
}

/* -- damage --------------------------------------------------------------------------------- */

static int check(const void *self, struct error *err)
{
    return winged_edge_check(self, err);
}

static uint64_t shape_of(const void *self)
{
    struct mesh mesh;
    assert_int_equal(winged_edge_to_mesh(self, &mesh, NULL), 0);
    uint64_t hash = surface_hash(&mesh);
    mesh_release(&mesh);
    return hash;
}

static void damage_is_found(void **state)
{
    (void)state;
    for (int i = 0; i < DAMAGE_MESHES; i++) {
        struct mesh mesh = damage_mesh(i);
        struct winged_edge_mesh we = built(&mesh);
        const struct damage damage = {&we, check, shape_of};
        damage_every_number(&damage, "edges", &we.edges->vertex[0], 8 * (int64_t)we.edge_count,
                            NO_CHOICE);
        damage_every_number(&damage, "vertex_edge", we.vertex_edge, we.vertex_count, SOME_CHOICE);
        damage_every_number(&damage, "face_edge", we.face_edge, we.face_count, SOME_CHOICE);
        winged_edge_release(&we);
        mesh_release(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_table_of_document_001_is_built),
        cmocka_unit_test(the_documents_choice_of_edges_is_accepted),
        cmocka_unit_test(links_on_a_boundary_lead_along_the_hole),
        cmocka_unit_test(faces_of_other_sizes_do_not_become_triangles),
        cmocka_unit_test(edges_are_found),
        cmocka_unit_test(damage_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
