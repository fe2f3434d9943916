/* Marks, labels and polygons of scenes: what is kept of an answer that may be anything. */
#include "graders/scene/cut.h"
#include "graders/scene/polygon.h"
#include "graders/scene/show.h"

#include <limits.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* A pentagon with one corner pushed in (a concave one), and a triangle above its top side. */
static const float house[] = {0, 0, 0, 1, .2F, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 1, 3, 0};
enum { HOUSE_VERTICES = 6, HOUSE_FACES = 2 };
static const int32_t house_first[] = {0, 5, 8}, house_corners[] = {0, 1, 2, 3, 4, 4, 3, 5};

static void set_house(struct scene *scene)
{
    assert_int_equal(scene_set_polygons(scene, house, HOUSE_VERTICES, house_first, house_corners,
                                        HOUSE_FACES, NULL),
                     0);
}

static const char *text_of(const json_t *json, const char *key)
{
    const char *text = json_string_value(json_object_get(json, key));
    assert_non_null(text);
    return text;
}

static int64_t number_of(const json_t *json, const char *key)
{
    assert_true(json_is_integer(json_object_get(json, key)));
    return json_integer_value(json_object_get(json, key));
}

static void assert_vertices(const json_t *json, int count, const int32_t *vertices)
{
    const json_t *list = json_object_get(json, "vertex");
    assert_int_equal(json_array_size(list), count);
    for (int i = 0; i < count; i++)
        assert_int_equal(json_integer_value(json_array_get(list, (size_t)i)), vertices[i]);
}

static void every_element_is_written_by_its_vertices(void **state)
{
    (void)state;
    struct scene scene = {0};
    set_house(&scene);
    scene_mark_arrow(&scene, MARK_WRONG, 4, 3);
    scene_mark_half_edge(&scene, MARK_RIGHT, house_corners, 5, 3);
    scene_mark_path(&scene, mark_turn(0), house_corners, 5, true);
    scene_mark_path(&scene, mark_turn(7), house_corners, 4, false);
    scene_mark_face(&scene, MARK_EXTRA, house_corners, 5);
    scene_mark_face(&scene, MARK_MISSING, house_corners + 5, 3);
    static const struct {
        const char *kind, *element;
        int count;
        int32_t vertices[5];
    } expected[] = {
        {"wrong", "arrow", 2, {4, 3}},          {"right", "half-edge", 5, {3, 4, 0, 1, 2}},
        {"turn-0", "loop", 5, {0, 1, 2, 3, 4}}, {"turn-1", "path", 4, {0, 1, 2, 3}},
        {"extra", "face", 5, {0, 1, 2, 3, 4}},  {"missing", "triangle", 3, {4, 3, 5}},
    };
    json_t *json = scene_to_json(&scene);
    const json_t *marks = json_object_get(json, "marks");
    assert_int_equal(json_array_size(marks), sizeof expected / sizeof *expected);
    for (size_t m = 0; m < sizeof expected / sizeof *expected; m++) {
        const json_t *mark = json_array_get(marks, m);
        assert_string_equal(text_of(mark, "kind"), expected[m].kind);
        assert_string_equal(text_of(mark, "element"), expected[m].element);
        assert_vertices(mark, expected[m].count, expected[m].vertices);
    }
    assert_int_equal(number_of(json_object_get(json, "mark_counts"), "turn-1"), 1);
    assert_int_equal(json_array_size(json_object_get(json_array_get(marks, 4), "fill")), 9);
    assert_null(json_object_get(json_array_get(marks, 2), "fill"));
    json_decref(json);
    scene_release(&scene);
}

static void marks_of_an_answer_may_name_anything(void **state)
{
    (void)state;
    struct scene scene = {0};
    set_house(&scene);
    const int32_t wild[] = {0, INT32_MAX, 2, INT32_MIN, -1}, outside[] = {0, 1, 2, 6};
    scene_mark_arrow(&scene, MARK_WRONG, -1, 2);
    scene_mark_path(&scene, MARK_WRONG, wild, 5, true);
    scene_mark_path(&scene, MARK_WRONG, NULL, 3, true);
    scene_mark_path(&scene, MARK_WRONG, wild, -7, false);
    scene_mark_path(&scene, MARK_WRONG, wild, INT64_MIN, true);
    scene_mark_face(&scene, MARK_WRONG, outside, 4);
    scene_mark_face(&scene, MARK_WRONG, NULL, 3);
    scene_mark_face(&scene, MARK_WRONG, outside, 2);
    scene_mark_half_edge(&scene, MARK_WRONG, outside, 3, 3);
    scene_mark_half_edge(&scene, MARK_WRONG, outside, 3, -1);
    scene_mark_half_edge(&scene, MARK_WRONG, outside, 2, 0);
    scene_mark_half_edge(&scene, MARK_WRONG, NULL, 3, 0);
    scene_label_vertex(&scene, -1, 4);
    scene_label_edge(&scene, 0, 6, 4);
    scene_label_face(&scene, NULL, 4, 4);
    scene_label_face(&scene, outside, INT64_MAX, 4);
    json_t *json = scene_to_json(&scene);
    assert_int_equal(number_of(json_object_get(json, "mark_counts"), "wrong"), 12);
    assert_int_equal(json_array_size(json_object_get(json, "marks")), 0);
    assert_int_equal(json_array_size(json_object_get(json, "labels")), 0);
    json_decref(json);
    scene_release(&scene);
    assert_int_equal(mark_turn(-1), MARK_TURN_LAST);
    assert_int_equal(mark_turn(INT64_MIN), MARK_TURN_0 + 4);
}

/* A loop longer than is kept becomes a path of its first vertices; what all marks keep is bounded,
 * and what is dropped makes room again. */
static void long_paths_are_bounded(void **state)
{
    (void)state;
    enum { COUNT = 3 * SCENE_PATH_LIMIT, LOOPS = 5000, LOOP = 100 };
    int32_t *vertices = malloc(COUNT * sizeof *vertices);
    assert_non_null(vertices);
    for (int32_t i = 0; i < COUNT; i++)
        vertices[i] = i;
    struct scene scene = {0};
    scene_mark_path(&scene, MARK_WRONG, vertices, COUNT, true);
    scene_mark_face(&scene, MARK_EXTRA, vertices, COUNT);
    assert_int_equal(scene.kept_mark_count, 1);
    assert_int_equal(scene.marks[0].count, SCENE_PATH_LIMIT);
    assert_int_equal(scene.marks[0].element, ELEMENT_PATH);
    for (int64_t loop = 0; loop < LOOPS; loop++)
        scene_mark_path(&scene, mark_turn(loop), vertices, LOOP, true);
    int64_t listed = 0;
    for (int m = 0; m < scene.kept_mark_count; m++)
        listed += scene.marks[m].list ? scene.marks[m].count : 0;
    assert_int_equal(listed, scene.listed_vertex_count);
    assert_true(listed <= SCENE_PATH_LIMIT_ALL);
    assert_true(listed > SCENE_PATH_LIMIT_ALL - LOOP);
    assert_int_equal(scene.mark_count[MARK_TURN_0], (LOOPS + 5) / 6);
    for (int32_t v = 0; v < 3 * SCENE_MARK_LIMIT; v++)
        scene_mark_path(&scene, MARK_RIGHT, vertices + v, 4, false);
    assert_in_range(scene.kept_mark_count, SCENE_MARK_LIMIT / 3, SCENE_MARK_LIMIT);
    scene_release(&scene);
    free(vertices);
}

static void labels_carry_their_numbers(void **state)
{
    (void)state;
    struct scene scene = {0};
    scene_label_face(&scene, house_corners, 5, 0);
    scene_label_edge(&scene, 4, 3, INT64_MAX);
    scene_label_vertex(&scene, 5, 5);
    set_house(&scene);
    json_t *json = scene_to_json(&scene);
    const json_t *labels = json_object_get(json, "labels");
    assert_int_equal(json_array_size(labels), 3);
    assert_string_equal(text_of(json_array_get(labels, 0), "element"), "face");
    assert_vertices(json_array_get(labels, 0), 5, house_corners);
    assert_string_equal(text_of(json_array_get(labels, 1), "element"), "edge");
    assert_true(number_of(json_array_get(labels, 1), "number") == INT64_MAX);
    json_decref(json);
    for (int i = 0; i < 2 * SCENE_LABEL_LIMIT; i++)
        scene_label_vertex(&scene, 0, i);
    assert_int_equal(scene.label_count, SCENE_LABEL_LIMIT);
    scene_release(&scene);
}

static void names_are_written_in_both_languages(void **state)
{
    (void)state;
    struct scene scene = {0};
    set_house(&scene);
    scene_name_marks(&scene, MARK_WRONG, (struct phrase){"next edge", "arista siguiente"});
    scene_name_turns(&scene, (struct phrase){"loops", "bucles"}, 12);
    json_t *json = scene_to_json(&scene);
    const json_t *names = json_object_get(json, "mark_names");
    assert_int_equal(json_object_size(names), 2);
    assert_string_equal(text_of(json_object_get(names, "wrong"), "es"), "arista siguiente");
    assert_string_equal(text_of(json_object_get(names, "turns"), "en"), "loops");
    assert_int_equal(number_of(json, "turn_count"), 12);
    json_decref(json);
    scene_release(&scene);
}

/* ------------------------------------------------------------------------------------ polygons */

static double area_of(const float *positions, const int32_t *corners, int32_t count)
{
    double sum = 0;
    for (int32_t i = 0; i < count; i++) {
        const float *p = positions + 3 * (size_t)corners[i];
        const float *q = positions + 3 * (size_t)corners[(i + 1) % count];
        sum += (double)p[0] * (double)q[1] - (double)p[1] * (double)q[0];
    }
    return sum / 2;
}

/* The triangles of a polygon are all counter-clockwise and cover just its area. */
static void assert_filled(const float *positions, const int32_t *corners, int32_t count)
{
    int32_t rest[64], triangles[3 * 64];
    assert_true(count <= 64);
    polygon_triangles(positions, corners, count, rest, triangles);
    double sum = 0;
    for (int32_t t = 0; t < count - 2; t++) {
        double area = area_of(positions, triangles + 3 * (size_t)t, 3);
        assert_true(area >= 0);
        sum += area;
    }
    assert_true(fabs(sum - area_of(positions, corners, count)) < 1e-5);
}

static void concave_polygons_are_filled_by_their_own_area(void **state)
{
    (void)state;
    assert_filled(house, house_corners, 5);
    enum { TEETH = 15, COMB = 2 * TEETH + 2 };
    float comb[3 * COMB] = {0};
    int32_t corners[COMB];
    for (int32_t i = 0; i < 2 * TEETH; i++) { /* a saw from right to left, over a flat ground */
        comb[3 * i] = (float)(2 * TEETH - i);
        comb[3 * i + 1] = i % 2 ? 1 : 9;
        corners[i] = i;
    }
    comb[3 * (COMB - 2)] = 1;
    comb[3 * (COMB - 1)] = 2 * TEETH;
    corners[COMB - 2] = COMB - 2;
    corners[COMB - 1] = COMB - 1;
    assert_filled(comb, corners, COMB);
    for (int32_t turn = 1; turn < COMB; turn++) {
        int32_t turned[COMB];
        for (int32_t i = 0; i < COMB; i++)
            turned[i] = corners[(i + turn) % COMB];
        assert_filled(comb, turned, COMB);
    }
}

/* A corner in the middle of a straight side, a corner twice, a bow tie: still n - 2 triangles. */
static void degenerate_polygons_get_their_triangles_too(void **state)
{
    (void)state;
    const float points[] = {0, 0, 0, 1, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0};
    const int32_t straight[] = {0, 1, 2, 3, 4};
    assert_filled(points, straight, 5);
    const int32_t odd[][5] = {{0, 2, 2, 3, 4}, {0, 3, 2, 4, 1}, {1, 1, 1, 1, 1}, {0, 1, 2, 1, 0}};
    for (size_t i = 0; i < sizeof odd / sizeof *odd; i++) {
        int32_t rest[5], triangles[9];
        memset(triangles, -1, sizeof triangles);
        polygon_triangles(points, odd[i], 5, rest, triangles);
        for (int c = 0; c < 9; c++)
            assert_in_range(triangles[c], 0, 4);
    }
}

static void polygons_are_written_beside_their_triangles(void **state)
{
    (void)state;
    struct scene scene = {0};
    set_house(&scene);
    assert_int_equal(scene.mesh.triangle_count, 4);
    json_t *json = scene_to_json(&scene);
    const json_t *polygons = json_object_get(json, "polygons");
    assert_int_equal(number_of(polygons, "face_count"), 2);
    assert_int_equal(number_of(polygons, "corner_count"), 8);
    assert_string_equal(text_of(polygons, "sizes"), "BQAAAAMAAAA=");
    assert_int_equal(strlen(text_of(polygons, "corners")), (8 * 4 + 2) / 3 * 4);
    json_decref(json);
    const int32_t triangle[] = {0, 2, 3}; /* another mesh is one of triangles again */
    assert_int_equal(scene_set_mesh(&scene, house, HOUSE_VERTICES, triangle, 1, NULL), 0);
    json = scene_to_json(&scene);
    assert_null(json_object_get(json, "polygons"));
    json_decref(json);
    scene_release(&scene);
}

static void bad_polygons_are_refused_and_shown_as_far_as_they_go(void **state)
{
    (void)state;
    static const struct {
        int32_t first[4], corners[8];
        int sound; /* faces that can be shown */
    } bad[] = {
        {{0, 2, 5, 8}, {0, 1, 2, 3, 4, 4, 3, 5}, 2},         /* a face of two corners */
        {{0, 3, 6, 5}, {0, 1, 2, 3, 4, 4, 3, 5}, 2},         /* out of order */
        {{0, 3, 6, 9}, {0, 1, 2, 3, 4, 6, 3, 5}, 1},         /* vertex 6 of 6, corner 9 of 8 */
        {{-1, 3, 6, 8}, {0, 1, 2, 3, 4, 4, 3, 5}, 0},        /* before the table */
        {{0, 3, INT32_MAX, 8}, {0, 1, 2, 3, 4, 4, 3, 5}, 1}, /* beyond it */
        {{0, 3, INT32_MIN, 8}, {0, 1, 2, 3, 4, 4, 3, 5}, 1}, /* far before it */
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct scene scene = {0};
        struct error err = {""};
        if (i != 2 && i != 4)
            assert_int_equal(scene_set_polygons(&scene, house, HOUSE_VERTICES, bad[i].first,
                                                bad[i].corners, 3, &err),
                             -1);
        assert_int_equal(scene.mesh.triangle_count, 0);
        assert_int_equal(
            show_polygons(&scene, house, HOUSE_VERTICES, bad[i].first, bad[i].corners, 8, 3, &err),
            0);
        assert_int_equal(scene.faces.count, bad[i].sound);
        scene_release(&scene);
    }
    struct scene scene = {0};
    assert_int_equal(scene_set_polygons(&scene, NULL, 0, NULL, NULL, 0, NULL), 0);
    assert_int_equal(scene_set_polygons(&scene, NULL, 0, NULL, NULL, -1, NULL), -1);
    scene_release(&scene);
}

/* A wide sheet of quads is cut to whole quads round the mark, and marks and labels follow. */
static void big_polygon_meshes_are_cut_to_whole_faces(void **state)
{
    (void)state;
    enum { SIDE = 240, ROW = SIDE + 1, FACES = SIDE * SIDE };
    float *positions = calloc((size_t)3 * ROW * ROW, sizeof *positions);
    int32_t *first = calloc(FACES + 1, sizeof *first);
    int32_t *corners = calloc((size_t)4 * FACES, sizeof *corners);
    assert_true(positions && first && corners);
    for (int32_t v = 0; v < ROW * ROW; v++) {
        positions[3 * v] = (float)(v % ROW);
        positions[3 * v + 1] = (float)(v / ROW);
    }
    for (int32_t f = 0; f < FACES; f++) {
        int32_t corner = f / SIDE * ROW + f % SIDE;
        const int32_t quad[] = {corner, corner + 1, corner + ROW + 1, corner + ROW};
        memcpy(corners + 4 * (size_t)f, quad, sizeof quad);
        first[f + 1] = 4 * (f + 1);
    }
    struct scene scene = {0}, cut = {0};
    assert_int_equal(scene_set_polygons(&scene, positions, ROW * ROW, first, corners, FACES, NULL),
                     0);
    const int32_t face = SIDE / 2 * SIDE + SIDE / 2;
    scene_mark_face(&scene, MARK_WRONG, corners + 4 * (size_t)face, 4);
    scene_label_face(&scene, corners + 4 * (size_t)face, 4, face);
    scene_label_vertex(&scene, 0, 0);
    float *numbers = calloc(FACES, sizeof *numbers);
    int32_t *groups = calloc(FACES, sizeof *groups);
    assert_true(numbers && groups);
    numbers[face] = 5;
    groups[face] = 3;
    const struct phrase none = {NULL, NULL};
    assert_int_equal(scene_set_values(&scene, SCENE_PER_FACE, numbers, 0, 5, none, face, NULL), 0);
    assert_int_equal(scene_set_groups(&scene, groups, NULL), 0);
    assert_int_equal(scene_add_vectors(&scene, MARK_WRONG, positions, NULL), 0);
    free(numbers);
    free(groups);
    assert_true(scene_needs_cut(&scene));
    assert_int_equal(scene_cut(&scene, &cut, NULL), 0);
    assert_int_equal(cut.mesh.triangle_count, SCENE_CUT_TRIANGLES);
    int64_t high = 0, parts = 0;
    for (int32_t t = 0; t < cut.mesh.triangle_count; t++) {
        high += cut.values.numbers[t] == 5;
        parts += cut.groups[t] == 3;
    }
    assert_true(high == 2 && parts == 2 && cut.values.count == SCENE_CUT_TRIANGLES);
    assert_memory_equal(cut.vectors[0].xyz, cut.mesh.positions,
                        3 * sizeof(float) * (size_t)cut.mesh.vertex_count);
    assert_int_equal(cut.faces.count, SCENE_CUT_TRIANGLES / 2);
    assert_int_equal(polygons_check(cut.faces.first_corner, cut.faces.corners, cut.faces.count,
                                    cut.mesh.vertex_count, NULL),
                     0);
    assert_int_equal(cut.kept_mark_count, 2);
    assert_int_equal(cut.label_count, 1); /* vertex 0 is far away */
    const float *corner = cut.mesh.positions + 3 * (size_t)cut.marks[0].list[0];
    assert_true(corner[0] == SIDE / 2 && corner[1] == SIDE / 2);
    for (int32_t f = 0; f < cut.faces.count; f++) {
        const int32_t *quad = cut.faces.corners + 4 * (size_t)f;
        assert_true(area_of(cut.mesh.positions, quad, 4) == 1);
    }
    scene_release(&cut);
    scene_release(&scene);
    free(positions);
    free(first);
    free(corners);
}

/* -------------------------------------------------------------------- values, vectors, answer */

static void values_of_polygons_become_those_of_their_triangles(void **state)
{
    (void)state;
    static const struct phrase unit = {"degrees", "grados"};
    const float values[] = {3, NAN};
    struct scene scene = {0};
    assert_int_equal(scene_set_values(&scene, SCENE_PER_FACE, values, 0, 9, unit, 0, NULL), -1);
    set_house(&scene);
    assert_int_equal(scene_set_values(&scene, SCENE_PER_FACE, values, 9, 0, unit, 0, NULL), -1);
    assert_int_equal(scene_set_values(&scene, SCENE_PER_FACE, values, 0, NAN, unit, 0, NULL), -1);
    assert_int_equal(scene_set_values(&scene, SCENE_PER_FACE, values, 0, 9, unit, 0, NULL), 0);
    json_t *json = scene_to_json(&scene);
    const json_t *written = json_object_get(json, "values");
    assert_string_equal(text_of(written, "of"), "triangle");
    assert_string_equal(text_of(written, "numbers"), "AABAQAAAQEAAAEBAAADAfw==");
    assert_string_equal(text_of(json_object_get(written, "unit"), "es"), "grados");
    assert_true(json_real_value(json_object_get(written, "worst")) == 3);
    const json_t *mark = json_array_get(json_object_get(json, "marks"), 0);
    assert_string_equal(text_of(mark, "element"), "face");
    assert_vertices(mark, 5, house_corners);
    assert_string_equal(
        text_of(json_object_get(json_object_get(json, "mark_names"), "wrong"), "en"), "worst");
    json_decref(json);
    set_house(&scene); /* another mesh has no values */
    assert_null(scene.values.numbers);
    scene_release(&scene);
}

static void values_of_vertices_name_the_worst(void **state)
{
    (void)state;
    const float values[HOUSE_VERTICES] = {0, 1, 2, INFINITY, 4, 5};
    const struct phrase none = {NULL, NULL};
    const int64_t worst[] = {5, 3, -1, 6, INT64_MAX};
    for (size_t i = 0; i < sizeof worst / sizeof *worst; i++) {
        struct scene scene = {0};
        set_house(&scene);
        assert_int_equal(
            scene_set_values(&scene, SCENE_PER_VERTEX, values, 2, 2, none, worst[i], NULL), 0);
        json_t *json = scene_to_json(&scene);
        const json_t *told = json_object_get(json_object_get(json, "values"), "worst");
        assert_int_equal(told != NULL, worst[i] == 5);
        assert_int_equal(scene.mark_count[MARK_WRONG], i < 2);
        json_decref(json);
        scene_release(&scene);
    }
}

static void parts_and_vectors_are_written(void **state)
{
    (void)state;
    const int32_t groups[] = {7, -1};
    const float vectors[3 * HOUSE_VERTICES] = {0, 0, 1, NAN, 0, 0};
    struct scene scene = {0};
    assert_int_equal(scene_set_groups(&scene, groups, NULL), -1);
    assert_int_equal(scene_add_vectors(&scene, MARK_WRONG, vectors, NULL), -1);
    set_house(&scene);
    assert_int_equal(scene_set_groups(&scene, groups, NULL), 0);
    assert_int_equal(scene_set_groups(&scene, groups, NULL), 0);
    for (int i = 0; i < SCENE_VECTORS_LIMIT; i++)
        assert_int_equal(scene_add_vectors(&scene, MARK_RIGHT, vectors, NULL), 0);
    assert_int_equal(scene_add_vectors(&scene, MARK_RIGHT, vectors, NULL), -1);
    json_t *json = scene_to_json(&scene);
    assert_string_equal(text_of(json, "groups"), "AQEB/w==");
    const json_t *sets = json_object_get(json, "vectors");
    assert_int_equal(json_array_size(sets), SCENE_VECTORS_LIMIT);
    assert_string_equal(text_of(json_array_get(sets, 1), "kind"), "right");
    assert_int_equal(strlen(text_of(json_array_get(sets, 1), "xyz")),
                     3 * HOUSE_VERTICES * 4 / 3 * 4);
    json_decref(json);
    scene_release(&scene);
}

static void the_answer_is_a_scene_beside(void **state)
{
    (void)state;
    const float wild[] = {0, 0, 0, 1, 0, 0, 0, 1, NAN};
    const int32_t triangles[] = {0, 1, 2, 0, 1, 3};
    struct scene scene = {0};
    assert_int_equal(scene_set_answer_mesh(&scene, wild, 3, triangles, 2, NULL), 0);
    set_house(&scene);
    struct scene *answer = scene_answer(&scene, NULL);
    assert_non_null(answer);
    scene_mark_triangle(answer, MARK_EXTRA, 0, 1, 2);
    scene_mark_vertex(&scene, MARK_MISSING, 5);
    scene_name_marks(answer, MARK_EXTRA, (struct phrase){"new", "nuevo"});
    json_t *json = scene_to_json(&scene);
    assert_string_equal(text_of(json, "kind"), "mesh");
    const json_t *written = json_object_get(json, "answer");
    assert_int_equal(number_of(json_object_get(written, "mesh"), "triangle_count"), 1);
    assert_int_equal(number_of(json_object_get(json, "mesh"), "triangle_count"), 4);
    assert_int_equal(json_array_size(json_object_get(written, "marks")), 1);
    assert_int_equal(number_of(json_object_get(written, "mark_counts"), "extra"), 1);
    assert_null(json_object_get(json_object_get(json, "mark_counts"), "extra"));
    json_decref(json);
    scene_release(&scene);
    assert_null(scene.answer);
}

static void an_answer_without_a_mesh_is_written_as_empty(void **state)
{
    (void)state;
    struct scene scene = {0};
    assert_int_equal(scene_set_answer_mesh(&scene, NULL, 0, NULL, 0, NULL), 0);
    assert_int_equal(
        scene_set_values(scene.answer, SCENE_PER_VERTEX, NULL, 0, 1, (struct phrase){0}, -1, NULL),
        0);
    json_t *json = scene_to_json(&scene);
    const json_t *written = json_object_get(json_object_get(json, "answer"), "mesh");
    assert_int_equal(number_of(written, "vertex_count"), 0);
    json_decref(json);
    scene_release(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_element_is_written_by_its_vertices),
        cmocka_unit_test(marks_of_an_answer_may_name_anything),
        cmocka_unit_test(long_paths_are_bounded),
        cmocka_unit_test(labels_carry_their_numbers),
        cmocka_unit_test(names_are_written_in_both_languages),
        cmocka_unit_test(concave_polygons_are_filled_by_their_own_area),
        cmocka_unit_test(degenerate_polygons_get_their_triangles_too),
        cmocka_unit_test(polygons_are_written_beside_their_triangles),
        cmocka_unit_test(bad_polygons_are_refused_and_shown_as_far_as_they_go),
        cmocka_unit_test(big_polygon_meshes_are_cut_to_whole_faces),
        cmocka_unit_test(values_of_polygons_become_those_of_their_triangles),
        cmocka_unit_test(values_of_vertices_name_the_worst),
        cmocka_unit_test(parts_and_vectors_are_written),
        cmocka_unit_test(the_answer_is_a_scene_beside),
        cmocka_unit_test(an_answer_without_a_mesh_is_written_as_empty),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
