/* What a mesh is and what is wrong with it: generators whose answer is known, faults that were put in,
 * random meshes against the plainest way, and the models. */
#include "reference/survey/survey.h"

#include "reference/formats/mesh_file.h"
#include "reference/mesh/generate.h"
#include "reference/mesh/soup.h"
#include "reference/survey/crossing.h"
#include "reference/survey/exact.h"
#include "reference/survey/sizes.h"
#include "tests/unit/mesh_measures.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct mesh_survey survey_of(const struct mesh *mesh)
{
    struct mesh_survey survey;
    struct error err = {0};
    if (mesh_survey_make(&survey, mesh, &(struct survey_wish){0}, &err))
        fail_msg("%s", err.text);
    return survey;
}

/* All kinds but `kind` are absent, and of that one there are `count`. */
static void assert_only(const struct mesh_survey *survey, enum survey_kind kind, int64_t count)
{
    for (int k = 0; k < SURVEY_KINDS; k++)
        if (survey->faults[k].count != (k == (int)kind ? count : 0))
            fail_msg("%s: %d", survey_kind_slug((enum survey_kind)k), (int)survey->faults[k].count);
}

static void assert_clean(const struct mesh_survey *survey)
{
    assert_only(survey, SURVEY_KINDS, 0);
    assert_int_equal(mesh_survey_fault_count(survey), 0);
}

static void assert_near(double value, double expected, double share)
{
    if (!(fabs(value - expected) <= share * fabs(expected)))
        fail_msg("%.17g, expected %.17g", value, expected);
}

/* A mesh from numbers in the source. */
static struct mesh make_mesh(const float *positions, int32_t vertex_count, const int32_t *triangles,
                             int32_t triangle_count)
{
    struct mesh mesh;
    assert_int_equal(mesh_init(&mesh, vertex_count, triangle_count, NULL), 0);
    memcpy(mesh.positions, positions, 12 * (size_t)vertex_count);
    memcpy(mesh.triangles, triangles, 12 * (size_t)triangle_count);
    return mesh;
}

/* -- generators ------------------------------------------------------------------------------- */

static void a_torus_has_its_genus(void **state)
{
    (void)state;
    for (int genus = 0; genus < 5; genus++) {
        struct mesh mesh;
        assert_int_equal(generate_torus(&mesh, genus, 4000, NULL), 0);
        for (int round = 0; round < 2; round++) {
            struct mesh_survey survey = survey_of(&mesh);
            assert_clean(&survey);
            assert_true(survey.is_closed && survey.is_manifold && survey.is_coherent);
            assert_true(survey.has_genus && survey.has_volume && survey.volume > 0);
            assert_int_equal(survey.genus, genus);
            assert_int_equal(survey.topology.euler_characteristic, 2 - 2 * genus);
            assert_near(survey.volume, signed_volume(&mesh), 1e-9);
            mesh_survey_release(&survey);
            assert_int_equal(change_scramble(&mesh, 9, NULL), 0);
        }
        mesh_release(&mesh);
    }
}

static void a_cube_has_its_measures(void **state)
{
    (void)state;
    struct mesh cube;
    assert_int_equal(generate_cube(&cube, NULL), 0);
    change_scale(&cube, 2);
    change_translate(&cube, 1000, 0, 0);
    struct mesh_survey survey = survey_of(&cube);
    assert_clean(&survey);
    double side = (double)survey.box.high[1] - (double)survey.box.low[1];
    assert_near(survey.area, 6 * side * side, 1e-12);
    assert_near(survey.volume, side * side * side, 1e-12);
    assert_int_equal(survey.topology.edge_count, 18);
    assert_near(survey.mean_valence, 36.0 / 8, 1e-15);
    int64_t vertices = 0;
    for (int v = 0; v <= SURVEY_VALENCES; v++)
        vertices += survey.valence_counts[v];
    assert_int_equal(vertices, 8);
    mesh_survey_release(&survey);
    mesh_release(&cube);
}

static void open_surfaces_have_loops(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_disc(&mesh, 6, 40, NULL), 0);
    struct mesh_survey survey = survey_of(&mesh);
    assert_clean(&survey);
    assert_true(!survey.is_closed && !survey.has_volume && survey.has_genus && survey.genus == 0);
    assert_int_equal(survey.topology.boundary_loop_count, 1);
    assert_int_equal(survey.most_valence, 40);
    mesh_survey_release(&survey);
    mesh_release(&mesh);
    assert_int_equal(generate_grid(&mesh, 5, 7, NULL), 0);
    survey = survey_of(&mesh);
    assert_clean(&survey);
    assert_int_equal(survey.topology.boundary.count, 24);
    assert_int_equal(survey.least_valence, 2);
    mesh_survey_release(&survey);
    mesh_release(&mesh);
}

static void a_moebius_strip_is_not_orientable(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_moebius(&mesh, 12, NULL), 0);
    struct mesh_survey survey = survey_of(&mesh);
    assert_true(survey.is_manifold && !survey.topology.is_orientable && !survey.has_genus);
    assert_only(&survey, SURVEY_INCOHERENT, 1);
    assert_int_equal(survey.topology.boundary_loop_count, 1);
    mesh_survey_release(&survey);
    mesh_release(&mesh);
}

static void nothing_at_all_is_clean(void **state)
{
    (void)state;
    struct mesh mesh = {0};
    struct mesh_survey survey = survey_of(&mesh);
    assert_clean(&survey);
    assert_true(!survey.is_closed && !survey.has_genus && !survey.has_volume);
    mesh_survey_release(&survey);
    mesh_survey_release(&survey);
}

/* -- faults that were put in ------------------------------------------------------------------ */

static void what_was_put_in_is_found(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_icosphere(&mesh, 3, NULL), 0);
    assert_int_equal(change_add_degenerate_triangles(&mesh, 5, 1, NULL), 0);
    struct mesh_survey survey = survey_of(&mesh);
    assert_only(&survey, SURVEY_DEGENERATE, 5);
    assert_false(survey.has_genus);
    mesh_survey_release(&survey);
    mesh_release(&mesh);

    assert_int_equal(generate_icosphere(&mesh, 3, NULL), 0);
    assert_int_equal(change_add_isolated_vertices(&mesh, 9, 2, NULL), 0);
    survey = survey_of(&mesh);
    assert_only(&survey, SURVEY_ISOLATED, 9);
    assert_int_equal(survey.faults[SURVEY_ISOLATED].kept[0].at[0], survey.topology.isolated.first);
    mesh_survey_release(&survey);
    mesh_release(&mesh);

    assert_int_equal(generate_one_triangle(&mesh, NULL), 0);
    assert_int_equal(change_add_duplicate_triangles(&mesh, 1, 3, NULL), 0);
    survey = survey_of(&mesh);
    assert_int_equal(survey.faults[SURVEY_DUPLICATE].count, 1);
    assert_int_equal(survey.faults[SURVEY_CROSSING].count, 0); /* that is told already */
    mesh_survey_release(&survey);
    mesh_release(&mesh);
}

static void what_is_no_manifold_is_named(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_two_cones(&mesh, 8, NULL), 0);
    struct mesh_survey survey = survey_of(&mesh);
    assert_only(&survey, SURVEY_NONMANIFOLD_VERTEX, 1);
    mesh_survey_release(&survey);
    mesh_release(&mesh);
    assert_int_equal(generate_book(&mesh, 5, NULL), 0);
    survey = survey_of(&mesh);
    const struct survey_element *edge = survey.faults[SURVEY_NONMANIFOLD_EDGE].kept;
    assert_int_equal(survey.faults[SURVEY_NONMANIFOLD_EDGE].count, 1);
    assert_int_equal(edge->at[2], 5);
    assert_int_equal(survey.faults[SURVEY_NONMANIFOLD_VERTEX].count, 2);
    struct message message;
    survey_say(SURVEY_NONMANIFOLD_EDGE, edge, &message);
    assert_string_equal(message.en, "Edge {0,1} has 5 triangles.");
    assert_string_equal(message.es, "La arista {0,1} tiene 5 triángulos.");
    mesh_survey_release(&survey);
    mesh_release(&mesh);
}

static void a_vertex_on_an_edge_is_a_t_vertex(void **state)
{
    (void)state;
    /* Vertex 3 lies on {0,1}, which the triangles below do not share. */
    float positions[] = {0, 0, 0, 2, 0, 0, 1, 1, 0, 1, 0, 0, 0, -1, 0, 2, -1, 0};
    const int32_t triangles[] = {0, 1, 2, 0, 4, 3, 3, 5, 1, 3, 4, 5};
    struct mesh mesh = make_mesh(positions, 6, triangles, 4);
    struct mesh_survey survey = survey_of(&mesh);
    assert_int_equal(survey.faults[SURVEY_T_VERTEX].count, 1);
    const int32_t *at = survey.faults[SURVEY_T_VERTEX].kept->at;
    assert_true(at[0] == 3 && at[1] == 0 && at[2] == 1);
    assert_int_equal(survey.faults[SURVEY_CROSSING].count, 0); /* it only touches */
    mesh_survey_release(&survey);
    /* Near is enough, within the tolerance; farther is a gap. */
    mesh.positions[10] = -1e-6F;
    survey = survey_of(&mesh);
    assert_int_equal(survey.faults[SURVEY_T_VERTEX].count, 1);
    mesh_survey_release(&survey);
    mesh.positions[10] = -1e-4F;
    survey = survey_of(&mesh);
    assert_int_equal(survey.faults[SURVEY_T_VERTEX].count, 0);
    mesh_survey_release(&survey);
    struct survey_wish wish = {.tolerance = 1e-3};
    assert_int_equal(mesh_survey_make(&survey, &mesh, &wish, NULL), 0);
    assert_int_equal(survey.faults[SURVEY_T_VERTEX].count, 1);
    mesh_survey_release(&survey);
    mesh_release(&mesh);
}

static void edges_that_were_not_sewn_are_cracks(void **state)
{
    (void)state;
    struct mesh cube, apart;
    struct soup soup;
    assert_int_equal(generate_cube(&cube, NULL), 0);
    assert_int_equal(soup_from_mesh(&soup, &cube, NULL), 0);
    assert_int_equal(mesh_init(&apart, 36, 12, NULL), 0);
    memcpy(apart.positions, soup.corners, 36 * 12);
    for (int i = 0; i < 36; i++)
        apart.triangles[i] = i;
    struct mesh_survey survey = survey_of(&apart);
    assert_only(&survey, SURVEY_CRACK, 36);
    mesh_survey_release(&survey);
    soup_release(&soup);
    mesh_release(&apart);
    mesh_release(&cube);
    /* Two triangles that share a vertex (the tip) and lie along each other; 0 and -0 are one place. */
    const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, -0.0F, -0.0F, 0, -1, 0};
    const int32_t triangles[] = {0, 1, 2, 0, 4, 3};
    struct mesh tip = make_mesh(positions, 5, triangles, 2);
    survey = survey_of(&tip);
    assert_int_equal(survey.faults[SURVEY_CRACK].count, 2);
    const int32_t expected[4] = {0, 1, 0, 3};
    assert_memory_equal(survey.faults[SURVEY_CRACK].kept[0].at, expected, sizeof expected);
    mesh_survey_release(&survey);
    mesh_release(&tip);
}

static void spheres_that_run_into_each_other_cross(void **state)
{
    (void)state;
    struct mesh one, two;
    assert_int_equal(generate_icosphere(&one, 3, NULL), 0);
    assert_int_equal(mesh_copy(&two, &one, NULL), 0);
    assert_int_equal(change_append(&one, &two, 0.4F, 0.1F, 0.03F, NULL), 0);
    struct mesh_survey survey = survey_of(&one);
    assert_true(survey.faults[SURVEY_CROSSING].count > 50);
    for (int32_t i = 0; i < survey.faults[SURVEY_CROSSING].kept_count; i++) {
        const int32_t *at = survey.faults[SURVEY_CROSSING].kept[i].at;
        assert_true(at[0] < two.triangle_count && at[1] >= two.triangle_count);
    }
    mesh_survey_release(&survey);
    struct survey_wish wish = {.without_crossings = true};
    assert_int_equal(mesh_survey_make(&survey, &one, &wish, NULL), 0);
    assert_clean(&survey);
    assert_false(survey.crossings_were_searched);
    mesh_survey_release(&survey);
    mesh_release(&one);
    mesh_release(&two);
}

static void a_search_that_is_cut_says_so(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_soup(&mesh, 300, 1, NULL), 0);
    struct mesh_survey survey, whole = survey_of(&mesh);
    struct survey_wish wish = {.pair_limit = 50};
    assert_int_equal(mesh_survey_make(&survey, &mesh, &wish, NULL), 0);
    assert_true(survey.is_cut[SURVEY_CROSSING]);
    assert_true(survey.faults[SURVEY_CROSSING].count <= 50);
    assert_false(whole.is_cut[SURVEY_CROSSING]);
    mesh_survey_release(&survey);
    mesh_survey_release(&whole);
    mesh_release(&mesh);
}

static void the_first_of_many_are_kept_in_order(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_icosphere(&mesh, 1, NULL), 0);
    assert_int_equal(change_add_isolated_vertices(&mesh, 3 * SURVEY_KEPT, 5, NULL), 0);
    struct mesh_survey survey = survey_of(&mesh);
    const struct survey_fault *fault = &survey.faults[SURVEY_ISOLATED];
    assert_int_equal(fault->count, 3 * SURVEY_KEPT);
    assert_int_equal(fault->kept_count, SURVEY_KEPT);
    assert_int_equal(fault->kept[0].at[0], survey.topology.isolated.first);
    for (int i = 1; i < SURVEY_KEPT; i++)
        assert_true(fault->kept[i - 1].at[0] < fault->kept[i].at[0]);
    mesh_survey_release(&survey);
    mesh_release(&mesh);
}

/* -- random meshes ---------------------------------------------------------------------------- */

static bool is_flat(const struct mesh *mesh, int32_t t, const float *corner[3])
{
    for (int i = 0; i < 3; i++)
        corner[i] = mesh->positions + 3 * (int64_t)mesh->triangles[3 * t + i];
    return exact_on_line(corner[0], corner[1], corner[2]);
}

static bool has_vertex(const struct mesh *mesh, int32_t t, int32_t v)
{
    const int32_t *c = mesh->triangles + 3 * (int64_t)t;
    return c[0] == v || c[1] == v || c[2] == v;
}

static int64_t count_crossings(const struct mesh *mesh)
{
    int64_t count = 0;
    const float *p[3], *q[3];
    for (int32_t s = 0; s < mesh->triangle_count; s++)
        for (int32_t t = s + 1; t < mesh->triangle_count; t++) {
            if (is_flat(mesh, s, p) || is_flat(mesh, t, q))
                continue;
            const int32_t *c = mesh->triangles + 3 * (int64_t)t;
            bool is_same =
                has_vertex(mesh, s, c[0]) && has_vertex(mesh, s, c[1]) && has_vertex(mesh, s, c[2]);
            count += !is_same && triangles_cross(p, q);
        }
    return count;
}

static void assert_as_topology(const struct mesh_survey *survey, const struct topology *t)
{
    const struct {
        enum survey_kind kind;
        int64_t count;
    } pairs[] = {{SURVEY_DEGENERATE, t->degenerate.count},
                 {SURVEY_DUPLICATE, t->duplicate.count},
                 {SURVEY_ISOLATED, t->isolated.count},
                 {SURVEY_NONMANIFOLD_EDGE, t->nonmanifold_edge.count},
                 {SURVEY_NONMANIFOLD_VERTEX, t->nonmanifold_vertex.count},
                 {SURVEY_INCOHERENT, t->incoherent.count}};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
        assert_int_equal(survey->faults[pairs[i].kind].count, pairs[i].count);
    assert_memory_equal(&survey->topology, t, sizeof *t);
}

static void random_meshes_are_as_the_plain_way_finds_them(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 400; seed++) {
        struct mesh mesh = random_mesh(seed);
        struct topology topology;
        struct mesh_survey survey = survey_of(&mesh), again;
        memset(&topology, 0, sizeof topology);
        assert_int_equal(mesh_topology(&mesh, &topology, NULL), 0);
        assert_as_topology(&survey, &topology);
        if (mesh.triangle_count < 400)
            assert_int_equal(survey.faults[SURVEY_CROSSING].count, count_crossings(&mesh));
        int64_t first_duplicate = topology.duplicate.first;
        if (first_duplicate >= 0)
            assert_int_equal(survey.faults[SURVEY_DUPLICATE].kept[0].at[0], first_duplicate);
        /* Other numbers change no count. */
        assert_int_equal(change_scramble(&mesh, seed, NULL), 0);
        again = survey_of(&mesh);
        for (int kind = 0; kind < SURVEY_KINDS; kind++)
            assert_int_equal(survey.faults[kind].count, again.faults[kind].count);
        assert_int_equal(survey.genus, again.genus);
        assert_true(fabs(survey.area - again.area) <= 1e-9 * survey.area);
        mesh_survey_release(&survey);
        mesh_survey_release(&again);
        mesh_release(&mesh);
    }
}

static void sizes_are_those_of_what_is_built(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 120; seed++) {
        struct mesh mesh = random_mesh(seed);
        struct topology topology;
        struct representation_size sizes[SURVEY_SIZES];
        assert_int_equal(mesh_topology(&mesh, &topology, NULL), 0);
        int count = survey_sizes(&mesh, &topology, sizes, NULL);
        assert_int_equal(count, 14);
        for (int i = 0; i < count; i++) {
            void *self;
            bool is_held = representation_new(sizes[i].kind, &self, &mesh, NULL) == 0;
            assert_int_equal(is_held, sizes[i].bytes >= 0);
            assert_int_equal(is_held, survey_obstacle(sizes[i].obstacle).en[0] == '\0');
            if (is_held)
                assert_int_equal(sizes[i].bytes, sizes[i].kind->bytes(self));
            representation_delete(sizes[i].kind, self);
        }
        mesh_release(&mesh);
    }
}

/* -- the models ------------------------------------------------------------------------------- */

static void the_models_are_what_they_are(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        int64_t genus, loops, components, crossings, cracks, flat, incoherent;
    } models[] = {{"bunny", 0, 2, 1, 4, 0, 0, 0},
                  {"horse", 0, 0, 1, 3, 0, 0, 0},
                  {"mug", 1, 0, 1, 0, 0, 0, 0},
                  {"spider", 0, 8, 19, 317, 24, 56, 10}};
    for (size_t i = 0; i < sizeof models / sizeof *models; i++) {
        char path[100];
        struct mesh mesh;
        snprintf(path, sizeof path, "exercises/models/%s.ply", models[i].name);
        assert_int_equal(mesh_file_read(path, &mesh, NULL), 0);
        struct mesh_survey survey = survey_of(&mesh);
        assert_int_equal(survey.genus, models[i].genus);
        assert_int_equal(survey.topology.boundary_loop_count, models[i].loops);
        assert_int_equal(survey.topology.component_count, models[i].components);
        assert_int_equal(survey.faults[SURVEY_CROSSING].count, models[i].crossings);
        assert_int_equal(survey.faults[SURVEY_CRACK].count, models[i].cracks);
        assert_int_equal(survey.faults[SURVEY_FLAT].count, models[i].flat);
        assert_int_equal(survey.faults[SURVEY_INCOHERENT].count, models[i].incoherent);
        assert_int_equal(mesh_survey_fault_count(&survey), models[i].crossings + models[i].cracks +
                                                               models[i].flat +
                                                               models[i].incoherent);
        mesh_survey_release(&survey);
        mesh_release(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_torus_has_its_genus),
        cmocka_unit_test(a_cube_has_its_measures),
        cmocka_unit_test(open_surfaces_have_loops),
        cmocka_unit_test(a_moebius_strip_is_not_orientable),
        cmocka_unit_test(nothing_at_all_is_clean),
        cmocka_unit_test(what_was_put_in_is_found),
        cmocka_unit_test(what_is_no_manifold_is_named),
        cmocka_unit_test(a_vertex_on_an_edge_is_a_t_vertex),
        cmocka_unit_test(edges_that_were_not_sewn_are_cracks),
        cmocka_unit_test(spheres_that_run_into_each_other_cross),
        cmocka_unit_test(a_search_that_is_cut_says_so),
        cmocka_unit_test(the_first_of_many_are_kept_in_order),
        cmocka_unit_test(random_meshes_are_as_the_plain_way_finds_them),
        cmocka_unit_test(sizes_are_those_of_what_is_built),
        cmocka_unit_test(the_models_are_what_they_are),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
