/* Queries of every representation against the plain truth; see test_representation.c. */
#include "tests/unit/representation_trial.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { RANDOM_MESHES = 120, UNTOUCHED = -12345 };

static int compare_numbers(const void *a, const void *b)
{
    const int32_t *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/* -- faces ------------------------------------------------------------------------------------ */

static void one_has_faces(struct representation_trial *trial)
{
    int32_t face_count = trial->back.triangle_count;
    int32_t *all = malloc(3 * (size_t)face_count * sizeof *all + 1);
    require(all, "there is memory");
    if (face_count > 0)
        trial->kind->face_vertices(trial->self, 0, face_count, all);
    for (int32_t f = 0; f < face_count; f++) {
        int32_t some[6], count = f % 2 && f + 1 < face_count ? 2 : 1;
        trial->kind->face_vertices(trial->self, f, count, some);
        require(memcmp(some, all + 3 * (int64_t)f, 12 * (size_t)count) == 0,
                "faces are the same alone and together");
        for (int i = 0; i < 3; i++)
            require(trial->vertex_of[some[i]] == trial->back.triangles[3 * (int64_t)f + i],
                    "faces have the corners that to_mesh gives them");
        int32_t neighbours[3], truth[3];
        int32_t found = trial->kind->face_neighbours(trial->self, f, neighbours);
        oracle_face_neighbours(&trial->oracle, f, truth);
        require(memcmp(neighbours, truth, sizeof truth) == 0, "neighbours are right");
        require(found == (truth[0] >= 0) + (truth[1] >= 0) + (truth[2] >= 0),
                "the number of neighbours is right");
    }
    free(all);
}

static void faces_know_vertices_and_neighbours(void **state)
{
    (void)state;
    for_each_trial(RANDOM_MESHES, one_has_faces);
}

/* -- vertices --------------------------------------------------------------------------------- */

/* Successive faces share an edge at the vertex. */
static void require_ring(const struct representation_trial *trial, int32_t vertex,
                         const int32_t *faces, int32_t count)
{
    for (int32_t i = 0; i + 1 < count; i++) {
        const int32_t *a = trial->back.triangles + 3 * (int64_t)faces[i];
        const int32_t *b = trial->back.triangles + 3 * (int64_t)faces[i + 1];
        int corner_a = a[0] == vertex ? 0 : a[1] == vertex ? 1 : 2;
        int corner_b = b[0] == vertex ? 0 : b[1] == vertex ? 1 : 2;
        require(a[(corner_a + 2) % 3] == b[(corner_b + 1) % 3],
                "faces go around the vertex counter-clockwise");
    }
}

static void require_vertex_ring(const struct representation_trial *trial, int32_t vertex,
                                const int32_t *around, int32_t count)
{
    for (int32_t i = 0; i + 1 < count; i++)
        require(oracle_uses(&trial->oracle, trial->vertex_of[around[i]],
                            trial->vertex_of[around[i + 1]]) > 0 ||
                    oracle_is_boundary_vertex(&trial->oracle, vertex),
                "vertices go around the vertex");
}

struct answer {
    int32_t *numbers, *truth;
    int32_t count;
};

/* Compares as sets; and a query that has no room writes nothing but counts the same. */
static void require_answer(struct answer *answer, int32_t truth_count, const char *what)
{
    require(answer->count == truth_count, what);
    qsort(answer->numbers, (size_t)truth_count, sizeof *answer->numbers, compare_numbers);
    qsort(answer->truth, (size_t)truth_count, sizeof *answer->truth, compare_numbers);
    require(truth_count == 0 ||
                memcmp(answer->numbers, answer->truth, (size_t)truth_count * sizeof(int32_t)) == 0,
            what);
}

static void require_faces_around(struct representation_trial *trial, int32_t number,
                                 struct answer *answer)
{
    int32_t vertex = trial->vertex_of[number], room = trial->back.triangle_count;
    answer->numbers[0] = UNTOUCHED;
    int32_t counted = trial->kind->faces_around_vertex(trial->self, number, answer->numbers, 0);
    require(answer->numbers[0] == UNTOUCHED, "nothing is written without room");
    answer->count = trial->kind->faces_around_vertex(trial->self, number, answer->numbers, room);
    require(answer->count == counted, "the count does not depend on the room");
    if (trial->kind->rings_in_order)
        require_ring(trial, vertex, answer->numbers, answer->count);
    require_answer(answer, oracle_faces_around(&trial->oracle, vertex, answer->truth),
                   "faces around a vertex are right");
}

static void require_vertices_around(struct representation_trial *trial, int32_t number,
                                    struct answer *answer)
{
    int32_t vertex = trial->vertex_of[number], room = trial->number_count;
    answer->numbers[0] = UNTOUCHED;
    int32_t counted = trial->kind->vertices_around_vertex(trial->self, number, answer->numbers, 0);
    require(answer->numbers[0] == UNTOUCHED, "nothing is written without room");
    answer->count = trial->kind->vertices_around_vertex(trial->self, number, answer->numbers, room);
    require(answer->count == counted, "the count does not depend on the room");
    if (trial->kind->rings_in_order)
        require_vertex_ring(trial, vertex, answer->numbers, answer->count);
    int32_t truth_count = oracle_vertices_around(&trial->oracle, vertex, answer->truth);
    for (int32_t i = 0; i < truth_count; i++)
        answer->truth[i] = trial->names[answer->truth[i]];
    require_answer(answer, truth_count, "vertices around a vertex are right");
}

static void one_has_vertices(struct representation_trial *trial)
{
    size_t room = (size_t)trial->back.triangle_count + (size_t)trial->number_count + 1;
    struct answer answer = {malloc(room * sizeof(int32_t)), malloc(room * sizeof(int32_t)), 0};
    require(answer.numbers && answer.truth, "there is memory");
    int32_t step = 1 + trial->number_count / 30;
    for (int32_t v = 0; v < trial->number_count; v += step) {
        require_faces_around(trial, v, &answer);
        require_vertices_around(trial, v, &answer);
    }
    free(answer.numbers);
    free(answer.truth);
}

static void vertices_know_faces_and_vertices(void **state)
{
    (void)state;
    for_each_trial(RANDOM_MESHES, one_has_vertices);
}

static void require_told(struct representation_trial *trial, int32_t u, int32_t v)
{
    require(trial->kind->is_edge(trial->self, u, v) ==
                (oracle_uses(&trial->oracle, trial->vertex_of[u], trial->vertex_of[v]) > 0),
            "pairs of vertices are told from edges");
}

static void one_tells_edges(struct representation_trial *trial)
{
    int32_t step = 1 + trial->number_count / 12, other_step = 1 + trial->number_count / 60;
    for (int32_t u = 0; u < trial->number_count; u += step)
        for (int32_t v = u % other_step; v < trial->number_count; v += other_step)
            require_told(trial, u, v);
    for (int32_t f = 0; f < trial->back.triangle_count; f += step) {
        int32_t corners[3];
        trial->kind->face_vertices(trial->self, f, 1, corners);
        for (int i = 0; i < 3; i++) {
            require_told(trial, corners[i], corners[(i + 1) % 3]);
            require_told(trial, corners[(i + 1) % 3], corners[i]);
        }
    }
}

static void edges_are_told_from_other_pairs(void **state)
{
    (void)state;
    for_each_trial(RANDOM_MESHES, one_tells_edges);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faces_know_vertices_and_neighbours),
        cmocka_unit_test(vertices_know_faces_and_vertices),
        cmocka_unit_test(edges_are_told_from_other_pairs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
