/* What holds for every representation: the mesh comes back, sizes are as promised, sweeps agree
 * with the plain truth. test_representation_queries.c has the queries. */
#include "reference/mesh/generate.h"
#include "reference/mesh/soup.h"
#include "tests/unit/representation_trial.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { RANDOM_MESHES = 120 };

/* -- coming back ------------------------------------------------------------------------------ */

static void require_same(const struct representation_trial *trial)
{
    require(same_surface(&trial->mesh, &trial->back), "the same triangles come back");
    if (!trial->kind->vertex_names) {
        require(same_numbered_mesh(&trial->mesh, &trial->back), "with the same numbers");
        return;
    }
    struct soup soup;
    struct mesh welded;
    require(soup_from_mesh(&soup, &trial->mesh, NULL) == 0 &&
                soup_to_mesh(&welded, &soup, NULL) == 0,
            "there is memory");
    require(welded.vertex_count == trial->back.vertex_count, "equal positions are one vertex");
    soup_release(&soup);
    mesh_release(&welded);
}

static void one_mesh_comes_back(struct representation_trial *trial)
{
    require_same(trial);
}

static void every_mesh_that_can_be_held_comes_back(void **state)
{
    (void)state;
    for_each_trial(RANDOM_MESHES, one_mesh_comes_back);
}

/* Large enough to hang or burst when something is quadratic. */
static void large_meshes_come_back(void **state)
{
    (void)state;
    for (int kind = 0; representation_table[kind]; kind++)
        for (int which = 0; which < 3; which++) {
            const struct representation *r = representation_table[kind];
            struct mesh mesh, back;
            void *self;
            assert_int_equal(which == 0   ? generate_torus(&mesh, 2, 40000, NULL)
                             : which == 1 ? generate_bipyramid(&mesh, 20000, NULL)
                                          : generate_grid(&mesh, 100, 150, NULL),
                             0);
            if (which != 2)
                assert_int_equal(change_scramble(&mesh, 3, NULL), 0);
            int code = representation_new(r, &self, &mesh, NULL);
            assert_true(code == 0 || (which == 2 && !(r->holds & FEATURE_BOUNDARY)));
            if (code == 0) {
                assert_int_equal(r->check(self, NULL), 0);
                assert_int_equal(r->to_mesh(self, &back, NULL), 0);
                assert_true(same_surface(&mesh, &back));
                mesh_release(&back);
            }
            representation_delete(r, self);
            mesh_release(&mesh);
        }
}

static void released_ones_can_be_released_again(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_cube(&mesh, NULL), 0);
    for (int kind = 0; representation_table[kind]; kind++) {
        const struct representation *r = representation_table[kind];
        void *self = malloc(r->struct_bytes);
        assert_non_null(self);
        memset(self, 0x5a, r->struct_bytes); /* build does not look at what was there */
        assert_int_equal(r->build(self, &mesh, NULL), 0);
        r->release(self);
        r->release(self);
        free(self);
    }
    mesh_release(&mesh);
}

/* -- what the table says ---------------------------------------------------------------------- */

static void descriptions_are_whole(void **state)
{
    (void)state;
    assert_non_null(representation_table[0]);
    for (int i = 0; representation_table[i]; i++) {
        const struct representation *r = representation_table[i];
        assert_ptr_equal(representation_find(r->name), r);
        assert_true(r->title && r->documents && r->struct_bytes > 0);
        assert_true(i == 0 || representation_table[i - 1]->order < r->order);
        for (int q = 0; q < QUERY_COUNT; q++)
            assert_non_null(r->cost[q]);
        assert_true(r->build && r->release && r->check && r->to_mesh && r->vertex_count);
        assert_true(r->face_count && r->bytes && r->formula_bytes && r->transform && r->area);
        assert_true(r->face_normals && r->vertex_normals && r->edges && r->boundary_loops);
        assert_true(r->smooth && r->face_vertices && r->face_neighbours && r->is_edge);
        assert_true(r->faces_around_vertex && r->vertices_around_vertex);
    }
    assert_null(representation_find("no such representation"));
}

static void one_formula_gives_the_bytes(struct representation_trial *trial)
{
    struct topology topology;
    require(mesh_topology(&trial->mesh, &topology, NULL) == 0, "there is memory");
    struct mesh_counts counts = representation_counts(trial->kind, trial->self, &topology);
    require(trial->kind->formula_bytes(&counts) == trial->kind->bytes(trial->self),
            "the formula gives the bytes");
}

static void formulas_give_the_bytes(void **state)
{
    (void)state;
    for_each_trial(RANDOM_MESHES, one_formula_gives_the_bytes);
}

/* -- sweeps ----------------------------------------------------------------------------------- */

static bool is_near(double a, double b, double scale)
{
    return fabs(a - b) <= 2e-6 * scale + 1e-30;
}

/* Exact in binary32, so that nothing welds that did not, and then one that is not. */
static void one_is_transformed(struct representation_trial *trial)
{
    static const float exact[12] = {0, 2, 0, 0, 0, 0, -1, 0, 0.5F, 0, 0, 0};
    static const float shear[12] = {1, 0.5F, 0, 3, 0, 1, 0, -2, 0.25F, 0, 1, 5};
    const float *const matrices[2] = {exact, shear};
    for (int m = 0; m < 2; m++) {
        struct mesh before, after;
        require(trial->kind->to_mesh(trial->self, &before, NULL) == 0, "to_mesh works");
        require(trial->kind->transform(trial->self, matrices[m]) == trial->number_count,
                "every position is processed once");
        require(trial->kind->to_mesh(trial->self, &after, NULL) == 0, "to_mesh works");
        for (int64_t c = 0; c < 3 * (int64_t)before.triangle_count; c++)
            for (int axis = 0; axis < 3; axis++) {
                const float *p = before.positions + 3 * (int64_t)before.triangles[c];
                const float *row = matrices[m] + 4 * axis;
                float want = row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
                float got = after.positions[3 * (int64_t)after.triangles[c] + axis];
                require(is_near((double)got, (double)want, 1.0 + fabs((double)want)),
                        "corners go where the matrix sends them");
            }
        require(m == 1 || before.vertex_count == after.vertex_count, "no vertex is lost");
        mesh_release(&before);
        mesh_release(&after);
    }
}

static void positions_are_transformed(void **state)
{
    (void)state;
    for_each_trial(RANDOM_MESHES / 3, one_is_transformed);
}

static double length_of(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* Whether `normal` is `vector` made one long, up to rounding relative to what was summed up. */
static bool is_direction(const float normal[3], const double vector[3], double scale)
{
    double length = length_of(vector);
    const double wide[3] = {(double)normal[0], (double)normal[1], (double)normal[2]};
    if (length <= 1e-6 * scale) /* the sum cancels: any direction, or none */
        return length_of(wide) < 1.0 + 1e-5;
    for (int axis = 0; axis < 3; axis++)
        if (fabs(wide[axis] * length - vector[axis]) > 4e-6 * scale)
            return false;
    return true;
}

static void one_has_area_and_normals(struct representation_trial *trial)
{
    double sum = 0.0;
    int32_t face_count = trial->back.triangle_count,
            largest = face_count > trial->number_count ? face_count : trial->number_count;
    float *normals = malloc(3 * (size_t)largest * sizeof *normals + 1);
    require(normals, "there is memory");
    trial->kind->face_normals(trial->self, normals);
    for (int32_t f = 0; f < face_count; f++) {
        double vector[3];
        oracle_area_vector(&trial->oracle, f, vector);
        sum += length_of(vector);
        require(is_direction(normals + 3 * (int64_t)f, vector, length_of(vector)),
                "face normals are right");
    }
    require(is_near(trial->kind->area(trial->self), sum, sum), "the area is right");
    require(trial->kind->vertex_normals(trial->self, normals, NULL) == 0, "there is memory");
    for (int32_t v = 0; v < trial->number_count; v++) {
        double vector[3], scale;
        oracle_vertex_vector(&trial->oracle, trial->vertex_of[v], vector, &scale);
        require(is_direction(normals + 3 * (int64_t)v, vector, scale), "vertex normals are right");
    }
    free(normals);
}

static void area_and_normals_are_right(void **state)
{
    (void)state;
    for_each_trial(RANDOM_MESHES, one_has_area_and_normals);
}

static void one_has_edges(struct representation_trial *trial)
{
    int32_t *pairs = malloc(6 * (size_t)trial->back.triangle_count * sizeof *pairs + 1);
    uint8_t *seen =
        calloc((size_t)trial->back.vertex_count * (size_t)trial->back.vertex_count + 1, 1);
    require(pairs && seen, "there is memory");
    int64_t count = trial->kind->edges(trial->self, pairs, NULL);
    require(count == oracle_edge_count(&trial->oracle, 0), "the number of edges is right");
    for (int64_t e = 0; e < count; e++) {
        int32_t low = pairs[2 * e], high = pairs[2 * e + 1];
        require(low >= 0 && low < high && high < trial->number_count, "smaller numbers come first");
        int32_t u = trial->vertex_of[low], v = trial->vertex_of[high];
        require(trial->names[u] == low && trial->names[v] == high, "edges name the lowest numbers");
        require(oracle_uses(&trial->oracle, u, v) > 0, "every edge is one");
        uint8_t *mark =
            seen + (u < v ? u : v) * (int64_t)trial->back.vertex_count + (u < v ? v : u);
        require(!*mark, "no edge comes twice");
        *mark = 1;
    }
    free(pairs);
    free(seen);
}

static void every_edge_is_listed_once(void **state)
{
    (void)state;
    for_each_trial(RANDOM_MESHES, one_has_edges);
}

/* Every boundary edge once, closed, and along its face where faces agree. */
static void require_loops(struct representation_trial *trial, const int32_t *vertices,
                          const int32_t *starts, int32_t loop_count, uint8_t *seen)
{
    bool is_coherent = oracle_is_coherent(&trial->oracle);
    int64_t n = trial->back.vertex_count;
    for (int32_t loop = 0; loop < loop_count; loop++) {
        require(starts[loop + 1] > starts[loop], "no loop is empty");
        for (int32_t i = starts[loop]; i < starts[loop + 1]; i++) {
            int32_t from = vertices[i];
            int32_t to = vertices[i + 1 < starts[loop + 1] ? i + 1 : starts[loop]];
            require(from >= 0 && from < trial->number_count && to >= 0, "loops are of vertices");
            int32_t u = trial->vertex_of[from], v = trial->vertex_of[to];
            require(trial->names[u] == from, "loops name the lowest numbers");
            require(oracle_uses(&trial->oracle, u, v) == 1, "loops run along boundary edges");
            require(!seen[u * n + v] && !seen[v * n + u], "each boundary edge comes once");
            seen[u * n + v] = 1;
            require(!is_coherent || trial->oracle.sides[u * n + v] == 1,
                    "loops run as the faces do");
        }
    }
}

static void one_has_loops(struct representation_trial *trial)
{
    int64_t boundary = oracle_edge_count(&trial->oracle, 1);
    int32_t *vertices = malloc((size_t)boundary * sizeof *vertices + 1);
    int32_t *starts = malloc(((size_t)boundary + 1) * sizeof *starts);
    uint8_t *seen =
        calloc((size_t)trial->back.vertex_count * (size_t)trial->back.vertex_count + 1, 1);
    require(vertices && starts && seen, "there is memory");
    struct error err = {0};
    int32_t count = trial->kind->boundary_loops(trial->self, vertices, starts, &err);
    if (oracle_has_crowded_edge(&trial->oracle)) {
        require(count == -1 && strstr(err.text, "edge {"), "crowded edges are named");
    } else {
        require(count >= 0 && starts[0] == 0 && starts[count] == boundary,
                "loops have all boundary edges");
        require_loops(trial, vertices, starts, count, seen);
        struct topology topology;
        require(mesh_topology(&trial->back, &topology, NULL) == 0, "there is memory");
        require(topology.nonmanifold_vertex.count > 0 || count == topology.boundary_loop_count,
                "the number of loops is right");
    }
    free(vertices);
    free(starts);
    free(seen);
}

static void boundary_edges_make_loops(void **state)
{
    (void)state;
    for_each_trial(RANDOM_MESHES, one_has_loops);
}

static void one_is_smoothed(struct representation_trial *trial)
{
    struct mesh after;
    require(trial->kind->smooth(trial->self, NULL) == 0, "there is memory");
    require(trial->kind->check(trial->self, NULL) == 0, "it is still in order");
    require(trial->kind->to_mesh(trial->self, &after, NULL) == 0, "to_mesh works");
    int32_t *around = malloc((size_t)trial->back.vertex_count * sizeof *around + 1);
    require(around, "there is memory");
    for (int64_t c = 0; c < 3 * (int64_t)after.triangle_count; c++) {
        int32_t v = trial->back.triangles[c];
        int32_t count = oracle_vertices_around(&trial->oracle, v, around);
        bool stays = count == 0 || oracle_is_boundary_vertex(&trial->oracle, v);
        for (int axis = 0; axis < 3; axis++) {
            double want = stays ? (double)trial->back.positions[3 * (int64_t)v + axis] : 0.0;
            for (int32_t i = 0; i < count && !stays; i++)
                want += (double)trial->back.positions[3 * (int64_t)around[i] + axis] / count;
            double got = (double)after.positions[3 * (int64_t)after.triangles[c] + axis];
            require(is_near(got, want, 4.0), "vertices move to the mean of their neighbours");
        }
    }
    free(around);
    mesh_release(&after);
}

static void smoothing_takes_means(void **state)
{
    (void)state;
    for_each_trial(RANDOM_MESHES, one_is_smoothed);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_mesh_that_can_be_held_comes_back),
        cmocka_unit_test(large_meshes_come_back),
        cmocka_unit_test(released_ones_can_be_released_again),
        cmocka_unit_test(descriptions_are_whole),
        cmocka_unit_test(formulas_give_the_bytes),
        cmocka_unit_test(positions_are_transformed),
        cmocka_unit_test(area_and_normals_are_right),
        cmocka_unit_test(every_edge_is_listed_once),
        cmocka_unit_test(boundary_edges_make_loops),
        cmocka_unit_test(smoothing_takes_means),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
