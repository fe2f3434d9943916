/* The judge of winged-edge-build: the table that course document 001 prints is right, and no entry
 * of it can be another one. */
#include "graders/library/judge.h"
#include "tests/unit/course_prism.h"

#include <setjmp.h>
#include <stdarg.h>
#include <string.h>

#include <cmocka.h>

extern const struct judge judge_winged_edge_build;

enum { COLUMNS = 8 };

/* The faces as document 001 numbers them, and an answer to them. */
struct trial {
    struct writer input;
    int32_t edges[PRISM_EDGES][COLUMNS];
    int32_t vertex_edge[PRISM_VERTICES], face_edge[PRISM_FACES];
    int64_t result;
};

static const int32_t corners[18] = {3, 2, 4, 1, 5, 4, 2, 0, 1, 2, 3, 0, 3, 4, 5, 1, 0, 5};
static const int32_t first_corner[PRISM_FACES + 1] = {0, 3, 7, 11, 15, 18};

static int setup(void **state)
{
    static struct trial trial;
    struct error err;
    struct polygon_mesh mesh;
    const struct mesh_recipe recipe = {.shape = SHAPE_COURSE_PRISM};
    trial = (struct trial){.input = writer_growing(), .result = PRISM_EDGES};
    assert_int_equal(polygon_mesh_make(&recipe, 1, NULL, &mesh, &err), 0);
    assert_memory_equal(mesh.corners, corners, sizeof corners);
    assert_memory_equal(mesh.first_corner, first_corner, sizeof first_corner);
    assert_int_equal(polygon_mesh_write(&mesh, &trial.input, &err), 0);
    polygon_mesh_release(&mesh);
    memcpy(trial.edges, prism_winged_edges, sizeof trial.edges);
    memcpy(trial.vertex_edge, prism_vertex_edge, sizeof trial.vertex_edge);
    memcpy(trial.face_edge, prism_face_edge, sizeof trial.face_edge);
    *state = &trial;
    return 0;
}

static int teardown(void **state)
{
    struct trial *trial = *state;
    writer_release(&trial->input);
    return 0;
}

/* Whether the judge takes the answer; each rejection says why in both languages and shows it. */
static bool is_taken(const struct trial *trial)
{
    struct writer answer = writer_growing();
    struct judgement out = {0};
    struct usage usage = {0};
    struct error err;
    write_int(&answer, trial->result);
    write_table(&answer, trial->edges, PRISM_EDGES, sizeof trial->edges[0]);
    write_table(&answer, trial->vertex_edge, PRISM_VERTICES, sizeof(int32_t));
    write_table(&answer, trial->face_edge, PRISM_FACES, sizeof(int32_t));
    assert_int_equal(judge_answer(&judge_winged_edge_build,
                                  (struct span){trial->input.bytes, trial->input.count},
                                  (struct span){answer.bytes, answer.count}, &usage, &out, &err),
                     0);
    bool taken = out.accepted;
    if (!taken) {
        assert_true(out.cause[0] && out.message.en[0] && out.message.es[0]);
        assert_int_not_equal(out.scene.kind, SCENE_NONE);
    }
    scene_release(&out.scene);
    writer_release(&answer);
    return taken;
}

static bool table_of_edges_has(int32_t edge, int from, int to, int32_t number)
{
    return edge >= 0 && edge < PRISM_EDGES &&
           (prism_winged_edges[edge][from] == number || prism_winged_edges[edge][to] == number);
}

static void test_printed_table_is_right(void **state)
{
    assert_true(is_taken(*state));
}

/* Values from below NONE to above every number that occurs. */
static void test_every_entry_matters(void **state)
{
    struct trial *trial = *state;
    int refused = 0;
    for (int row = 0; row < PRISM_EDGES; row++)
        for (int column = 0; column < COLUMNS; column++)
            for (int32_t value = -3; value < 13; value++) {
                int32_t *entry = &trial->edges[row][column];
                if (value == prism_winged_edges[row][column])
                    continue;
                *entry = value;
                if (is_taken(trial))
                    fail_msg("edge %d, column %d is taken with %d", row, column, value);
                refused++;
                *entry = prism_winged_edges[row][column];
            }
    assert_int_equal(refused, PRISM_EDGES * COLUMNS * 15);
}

static void test_tables_of_vertices_and_faces(void **state)
{
    struct trial *trial = *state;
    for (int32_t value = -3; value < 13; value++) {
        for (int v = 0; v < PRISM_VERTICES; v++) {
            trial->vertex_edge[v] = value;
            assert_int_equal(is_taken(trial), table_of_edges_has(value, 0, 1, v));
            trial->vertex_edge[v] = prism_vertex_edge[v];
        }
        for (int f = 0; f < PRISM_FACES; f++) {
            trial->face_edge[f] = value;
            assert_int_equal(is_taken(trial), table_of_edges_has(value, 2, 3, f));
            trial->face_edge[f] = prism_face_edge[f];
        }
    }
}

/* vi and vf, and with them the two sides, may change places in any row. */
static void test_every_edge_may_run_either_way(void **state)
{
    static const int other[COLUMNS] = {1, 0, 3, 2, 6, 7, 4, 5};
    struct trial *trial = *state;
    for (int row = 0; row < PRISM_EDGES; row++) {
        for (int column = 0; column < COLUMNS; column++)
            trial->edges[row][column] = prism_winged_edges[row][other[column]];
        assert_true(is_taken(trial));
    }
}

static void test_counts_and_refusals_are_wrong_here(void **state)
{
    struct trial *trial = *state;
    for (int64_t result = -5; result < PRISM_EDGES + 3; result++) {
        trial->result = result;
        assert_int_equal(is_taken(trial), result == PRISM_EDGES);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_printed_table_is_right, setup, teardown),
        cmocka_unit_test_setup_teardown(test_every_entry_matters, setup, teardown),
        cmocka_unit_test_setup_teardown(test_tables_of_vertices_and_faces, setup, teardown),
        cmocka_unit_test_setup_teardown(test_every_edge_may_run_either_way, setup, teardown),
        cmocka_unit_test_setup_teardown(test_counts_and_refusals_are_wrong_here, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
