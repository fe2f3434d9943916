/* Half-winged edges: the table of course document 001, normals and textures per corner, damage. */
#include "reference/mesh/generate.h"
#include "reference/representation/half_winged_edge.h"
#include "tests/unit/course_prism.h"
#include "tests/unit/damage.h"
#include "tests/unit/mesh_measures.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

static struct half_winged_edge_mesh built(const struct mesh *mesh)
{
    struct half_winged_edge_mesh hw;
    struct polygons polygons = polygons_of_mesh(mesh);
    assert_int_equal(half_winged_edge_build(&hw, &polygons, mesh->positions, NULL, NULL, NULL), 0);
    return hw;
}

/* The numbering is the document's; its Aa and As are the edges of ours. */
static void the_table_of_document_001_is_built(void **state)
{
    (void)state;
    struct half_winged_edge_mesh hw;
    assert_int_equal(
        half_winged_edge_build(&hw, &prism_polygons, prism_positions, NULL, NULL, NULL), 0);
    assert_int_equal(half_winged_edge_check(&hw, NULL), 0);
    assert_int_equal(hw.half_edge_count, PRISM_HALF_EDGES);
    for (int32_t h = 0; h < PRISM_HALF_EDGES; h++) {
        const struct half_winged_edge *half = hw.half_edges + h;
        const int32_t got[6] = {half->start,
                                half->end,
                                half->twin,
                                prism_reading[half->face],
                                half->previous % PRISM_EDGES,
                                half->next % PRISM_EDGES};
        assert_memory_equal(got, prism_half_edges[h], sizeof got);
        assert_int_equal(half->previous, prism_half_edge_links[h][0]);
        assert_int_equal(half->next, prism_half_edge_links[h][1]);
    }
    half_winged_edge_release(&hw);
}

/* -- normals and textures ------------------------------------------------------------------- */

static void a_cube_needs_24_vertices_to_look_like_one(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_cube(&mesh, NULL), 0);
    struct half_winged_edge_mesh hw = built(&mesh);
    assert_int_equal(half_winged_edge_render_vertices(&hw), 8);
    assert_int_equal(half_winged_edge_shade(&hw, 30.0, NULL), 0);
    assert_int_equal(half_winged_edge_render_vertices(&hw), 24);
    for (int32_t h = 0; h < hw.half_edge_count; h++) {
        double area[3], length = 0.0;
        half_winged_edge_area_vector(&hw, hw.half_edges[h].face, area);
        for (int axis = 0; axis < 3; axis++)
            length += area[axis] * area[axis];
        for (int axis = 0; axis < 3; axis++)
            assert_true(fabs((double)hw.half_edges[h].normal[axis] - area[axis] / sqrt(length)) <
                        1e-6);
    }
    assert_int_equal(half_winged_edge_shade(&hw, 120.0, NULL), 0);
    assert_int_equal(half_winged_edge_render_vertices(&hw), 8);
    half_winged_edge_release(&hw);
    mesh_release(&mesh);
}

/* Two squares that meet at a right angle, open: smooth or creased along the common edge. */
static void groups_end_at_boundaries(void **state)
{
    (void)state;
    const float positions[18] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, -1, 1, 1, -1};
    const int32_t corners[8] = {0, 1, 2, 3, 1, 4, 5, 2}, starts[3] = {0, 4, 8};
    const struct polygons polygons = {corners, starts, 6, 2};
    struct half_winged_edge_mesh hw;
    assert_int_equal(half_winged_edge_build(&hw, &polygons, positions, NULL, NULL, NULL), 0);
    assert_int_equal(half_winged_edge_render_vertices(&hw), 6);
    assert_true(fabs((double)hw.half_edges[1].normal[0] - sqrt(0.5)) < 1e-6); /* 1 -> 2 */
    assert_true(fabs((double)hw.half_edges[1].normal[2] - sqrt(0.5)) < 1e-6);
    assert_int_equal(half_winged_edge_shade(&hw, 60.0, NULL), 0);
    assert_int_equal(half_winged_edge_render_vertices(&hw), 8);
    assert_true(hw.half_edges[1].normal[2] == 1.0F);
    half_winged_edge_release(&hw);
}

static void textures_may_have_a_seam(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_tetrahedron(&mesh, NULL), 0);
    struct polygons polygons = polygons_of_mesh(&mesh);
    float textures[24], normals[36] = {0};
    for (int side = 0; side < 12; side++) {
        textures[2 * side] = (float)mesh.triangles[side];
        textures[2 * side + 1] = side < 3 ? 1.0F : 0.0F; /* the first face looks different */
        normals[3 * side] = 1.0F;
    }
    struct half_winged_edge_mesh hw;
    assert_int_equal(
        half_winged_edge_build(&hw, &polygons, mesh.positions, normals, textures, NULL), 0);
    assert_int_equal(half_winged_edge_check(&hw, NULL), 0);
    assert_int_equal(half_winged_edge_render_vertices(&hw), 4 + 3);
    for (int32_t h = 0; h < hw.half_edge_count; h++) {
        const struct half_winged_edge *half = hw.half_edges + h;
        assert_true(half->texture[0] == (float)half->start);
        assert_true(half->texture[1] == (half->face == 0 ? 1.0F : 0.0F));
        assert_true(half->normal[0] == 1.0F);
    }
    half_winged_edge_release(&hw);
    mesh_release(&mesh);
}

/* -- damage --------------------------------------------------------------------------------- */

static int check(const void *self, struct error *err)
{
    return half_winged_edge_check(self, err);
}

static uint64_t shape_of(const void *self)
{
    struct mesh mesh;
    assert_int_equal(half_winged_edge_to_mesh(self, &mesh, NULL), 0);
    uint64_t hash = surface_hash(&mesh);
    mesh_release(&mesh);
    return hash;
}

static void damage_is_found(void **state)
{
    (void)state;
    for (int i = 0; i < DAMAGE_MESHES; i++) {
        struct mesh mesh = damage_mesh(i);
        struct half_winged_edge_mesh hw = built(&mesh);
        const struct damage damage = {&hw, check, shape_of};
        for (int32_t h = 0; h < hw.half_edge_count; h++)
            damage_every_number(&damage, "half edge", &hw.half_edges[h].start, 6, NO_CHOICE);
        damage_every_number(&damage, "vertex_half_edge", hw.vertex_half_edge, hw.vertex_count,
                            SOME_CHOICE);
        damage_every_number(&damage, "face_half_edge", hw.face_half_edge, hw.face_count,
                            SOME_CHOICE);
        hw.half_edges[1].normal[0] += 0.5F;
        assert_int_equal(half_winged_edge_check(&hw, NULL), -1);
        hw.half_edges[1].normal[0] = NAN;
        assert_int_equal(half_winged_edge_check(&hw, NULL), -1);
        hw.half_edges[1].normal[0] = hw.half_edges[1].normal[1] = hw.half_edges[1].normal[2] = 0;
        assert_int_equal(half_winged_edge_check(&hw, NULL), 0);
        hw.half_edges[2].texture[1] = INFINITY;
        assert_int_equal(half_winged_edge_check(&hw, NULL), -1);
        half_winged_edge_release(&hw);
        mesh_release(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_table_of_document_001_is_built),
        cmocka_unit_test(a_cube_needs_24_vertices_to_look_like_one),
        cmocka_unit_test(groups_end_at_boundaries),
        cmocka_unit_test(textures_may_have_a_seam),
        cmocka_unit_test(damage_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
