/* Scenes: what is kept, what is cut, and that the JSON holds the same bytes. */
#include "graders/scene/cut.h"
#include "graders/scene/scene.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const float square_positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
static const int32_t square_triangles[] = {0, 1, 2, 2, 1, 3};

static void set_square(struct scene *scene)
{
    assert_int_equal(scene_set_mesh(scene, square_positions, 4, square_triangles, 2, NULL), 0);
}

/* An independent base64 decoder, so that the encoder is not judged by itself. */
static size_t decode(const char *text, uint8_t *bytes)
{
    size_t count = 0;
    uint32_t group = 0;
    int bits = 0;
    for (; *text && *text != '='; text++) {
        int c = *text;
        int digit = c >= 'A' && c <= 'Z'   ? c - 'A'
                    : c >= 'a' && c <= 'z' ? c - 'a' + 26
                    : c >= '0' && c <= '9' ? c - '0' + 52
                    : c == '+'             ? 62
                                           : 63;
        group = group << 6 | (uint32_t)digit;
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes[count++] = (uint8_t)(group >> bits);
        }
    }
    return count;
}

static const char *text_of(const json_t *json, const char *key)
{
    const char *text = json_string_value(json_object_get(json, key));
    assert_non_null(text);
    return text;
}

static void a_mesh_keeps_its_bytes(void **state)
{
    (void)state;
    struct scene scene = {0};
    set_square(&scene);
    json_t *json = scene_to_json(&scene);
    assert_string_equal(text_of(json, "kind"), "mesh");
    json_t *mesh = json_object_get(json, "mesh");
    assert_int_equal(json_integer_value(json_object_get(mesh, "vertex_count")), 4);
    assert_int_equal(json_integer_value(json_object_get(mesh, "triangle_count")), 2);
    uint8_t bytes[sizeof square_positions];
    assert_int_equal(decode(text_of(mesh, "positions"), bytes), sizeof square_positions);
    assert_memory_equal(bytes, square_positions, sizeof square_positions);
    assert_int_equal(decode(text_of(mesh, "triangles"), bytes), sizeof square_triangles);
    assert_memory_equal(bytes, square_triangles, sizeof square_triangles);
    assert_null(json_object_get(json, "cut"));
    json_decref(json);
    scene_release(&scene);
}

/* One and two bytes over a multiple of three; none over is in the mesh above. */
static void base64_ends_rightly(void **state)
{
    (void)state;
    static const char *const texts[] = {NULL, "AQ==", "/w==", "/wD/Bw==", "/wD/D/AAAAA="};
    const uint8_t bits[8] = {0xff, 0x00, 0xff, 0x0f, 0xf0};
    for (int32_t side = 1; side <= 4; side++) {
        struct scene scene = {0};
        assert_int_equal(scene_set_voxels(&scene, bits, side, NULL), 0);
        json_t *json = scene_to_json(&scene);
        assert_string_equal(text_of(json_object_get(json, "voxels"), "bits"), texts[side]);
        json_decref(json);
        scene_release(&scene);
    }
}

static void bad_meshes_are_refused_and_leave_the_scene_valid(void **state)
{
    (void)state;
    struct scene scene = {0};
    set_square(&scene);
    const int32_t out_of_range[] = {0, 1, 4};
    const float not_finite[] = {0, 0, 0, 1, NAN, 0, 0, 1, 0};
    const int32_t one[] = {0, 1, 2};
    struct error err = {""};
    assert_int_equal(scene_set_mesh(&scene, square_positions, 4, out_of_range, 1, &err), -1);
    assert_non_null(strstr(err.text, "vertex 4"));
    err.text[0] = '\0';
    assert_int_equal(scene_set_mesh(&scene, not_finite, 3, one, 1, &err), -1);
    assert_non_null(strstr(err.text, "vertex 1"));
    assert_int_equal(scene_set_mesh(&scene, square_positions, -1, one, 1, NULL), -1);
    assert_int_equal(scene.mesh.triangle_count, 2);
    scene_release(&scene);
}

static void the_empty_mesh_is_a_scene(void **state)
{
    (void)state;
    struct scene scene = {0};
    assert_int_equal(scene_set_mesh(&scene, NULL, 0, NULL, 0, NULL), 0);
    json_t *json = scene_to_json(&scene);
    json_t *mesh = json_object_get(json, "mesh");
    assert_string_equal(text_of(mesh, "positions"), "");
    json_decref(json);
    scene_release(&scene);
    json = scene_to_json(&scene);
    assert_string_equal(text_of(json, "kind"), "none");
    json_decref(json);
}

static void marks_are_all_counted_and_some_kept(void **state)
{
    (void)state;
    struct scene scene = {.ok_count = 3};
    set_square(&scene);
    for (int i = 0; i < SCENE_MARK_LIMIT - 1; i++)
        scene_mark_edge(&scene, MARK_MISSING, i % 4, (i + 1) % 4);
    scene_mark_vertex(&scene, MARK_EXTRA, -1);
    scene_mark_triangle(&scene, MARK_FLIPPED, 0, 1, 99);
    assert_int_equal(scene.kept_mark_count, SCENE_MARK_LIMIT);
    json_t *json = scene_to_json(&scene);
    json_t *counts = json_object_get(json, "mark_counts");
    assert_int_equal(json_integer_value(json_object_get(counts, "missing")), SCENE_MARK_LIMIT - 1);
    assert_int_equal(json_integer_value(json_object_get(counts, "extra")), 1);
    assert_int_equal(json_integer_value(json_object_get(counts, "flipped")), 1);
    assert_null(json_object_get(counts, "wrong"));
    assert_int_equal(json_array_size(json_object_get(json, "marks")), SCENE_MARK_LIMIT - 1);
    assert_int_equal(json_integer_value(json_object_get(json, "ok_count")), 3);
    json_t *mark = json_array_get(json_object_get(json, "marks"), 3);
    assert_string_equal(text_of(mark, "kind"), "missing");
    assert_string_equal(text_of(mark, "element"), "edge");
    assert_int_equal(json_array_size(json_object_get(mark, "vertex")), 2);
    assert_int_equal(json_integer_value(json_array_get(json_object_get(mark, "vertex"), 0)), 3);
    json_decref(json);
    scene_release(&scene);
}

/* What is kept of many marks lies all over them; the first and the rare ones stay. */
static void many_marks_are_thinned_out_evenly(void **state)
{
    (void)state;
    enum { COUNT = 68400, PARTS = 10 };
    struct scene scene = {0};
    scene_mark_edge(&scene, MARK_DUPLICATE, 7, 8);
    for (int32_t i = 0; i < COUNT; i++)
        scene_mark_triangle(&scene, MARK_FLIPPED, i, i + 1, i + 2);
    for (int32_t i = 0; i < COUNT; i++)
        scene_mark_edge(&scene, MARK_BOUNDARY, i, i + 1);
    assert_int_equal(scene.mark_count[MARK_FLIPPED], COUNT);
    assert_in_range(scene.kept_mark_count, SCENE_MARK_LIMIT / 3, SCENE_MARK_LIMIT);
    assert_int_equal(scene.marks[0].kind, MARK_DUPLICATE);
    assert_int_equal(scene.marks[1].kind, MARK_FLIPPED);
    assert_int_equal(scene.marks[1].vertex[0], 0);
    int flipped_in[PARTS] = {0}, flipped = 0;
    for (int m = 0; m < scene.kept_mark_count; m++)
        if (scene.marks[m].kind == MARK_FLIPPED) {
            flipped_in[(int64_t)scene.marks[m].vertex[0] * PARTS / COUNT]++;
            flipped++;
        }
    assert_true(flipped > SCENE_MARK_LIMIT / 8);
    for (int part = 0; part < PARTS; part++)
        assert_in_range(flipped_in[part], flipped / PARTS / 2, 2 * flipped / PARTS);
    scene_release(&scene);
}

static void marks_outside_of_the_mesh_are_not_written(void **state)
{
    (void)state;
    struct scene scene = {0};
    scene_mark_triangle(&scene, MARK_WRONG, 0, 1, 4);
    scene_mark_triangle(&scene, MARK_WRONG, 0, 1, 3);
    set_square(&scene);
    json_t *json = scene_to_json(&scene);
    assert_int_equal(json_array_size(json_object_get(json, "marks")), 1);
    json_decref(json);
    scene_release(&scene);
}

/* A sheet of side x side pairs of triangles. */
static void make_sheet(struct mesh *mesh, int32_t side)
{
    struct error err = {""};
    int32_t row = side + 1;
    assert_int_equal(mesh_init(mesh, (int64_t)row * row, 2 * (int64_t)side * side, &err), 0);
    for (int32_t v = 0; v < row * row; v++) {
        mesh->positions[3 * v] = (float)(v % row);
        mesh->positions[3 * v + 1] = (float)(v / row);
    }
    for (int32_t q = 0; q < side * side; q++) {
        int32_t corner = q / side * row + q % side;
        const int32_t pair[6] = {corner,     corner + 1,       corner + row,
                                 corner + 1, corner + row + 1, corner + row};
        memcpy(mesh->triangles + 6 * (size_t)q, pair, sizeof pair);
    }
}

static void big_meshes_are_cut_to_what_surrounds_the_marks(void **state)
{
    (void)state;
    const int32_t side = 300;
    struct mesh mesh;
    make_sheet(&mesh, side);
    struct scene scene = {0}, cut = {0};
    assert_int_equal(scene_set_mesh(&scene, mesh.positions, mesh.vertex_count, mesh.triangles,
                                    mesh.triangle_count, NULL),
                     0);
    assert_true(scene_needs_cut(&scene));
    const int32_t middle = side / 2 * (side + 1) + side / 2;
    scene_mark_edge(&scene, MARK_EXTRA, middle, 0);
    struct error err = {""};
    assert_int_equal(scene_cut(&scene, &cut, &err), 0);
    assert_int_equal(cut.mesh.triangle_count, SCENE_CUT_TRIANGLES);
    assert_int_equal(mesh_check(&cut.mesh, &err), 0);
    assert_int_equal(cut.kept_mark_count, 1);
    const float *end = cut.mesh.positions + 3 * (size_t)cut.marks[0].vertex[0];
    assert_true(end[0] == (float)(side / 2) && end[1] == (float)(side / 2));
    for (int32_t v = 0; v < cut.mesh.vertex_count; v++) {
        const float *p = cut.mesh.positions + 3 * (size_t)v;
        float from_middle = fmaxf(fabsf(p[0] - (float)(side / 2)), fabsf(p[1] - (float)(side / 2)));
        assert_true(fminf(from_middle, fmaxf(p[0], p[1])) < 90);
    }
    scene_release(&cut);
    json_t *json = scene_to_json(&scene);
    assert_true(json_is_true(json_object_get(json, "cut")));
    assert_int_equal(json_array_size(json_object_get(json, "marks")), 1);
    json_decref(json);
    scene_release(&scene);
    mesh_release(&mesh);
}

static void a_big_mesh_without_marks_is_cut_from_its_first_triangle(void **state)
{
    (void)state;
    struct mesh mesh;
    make_sheet(&mesh, 230);
    struct scene scene = {0}, cut = {0};
    assert_int_equal(scene_set_mesh(&scene, mesh.positions, mesh.vertex_count, mesh.triangles,
                                    mesh.triangle_count, NULL),
                     0);
    struct error err = {""};
    assert_int_equal(scene_cut(&scene, &cut, &err), 0);
    assert_int_equal(cut.mesh.triangle_count, SCENE_CUT_TRIANGLES);
    assert_memory_equal(cut.mesh.positions, mesh.positions, 3 * sizeof(float));
    scene_release(&cut);
    scene_release(&scene);
    mesh_release(&mesh);
}

static void strips_add_up_and_are_cut_when_too_long(void **state)
{
    (void)state;
    struct scene scene = {0};
    assert_int_equal(scene_add_strip(&scene, square_positions, 4, NULL), 0);
    assert_int_equal(scene_add_strip(&scene, NULL, 0, NULL), 0);
    float *zeros = calloc(3 * 299999, sizeof *zeros);
    assert_non_null(zeros);
    assert_int_equal(scene_add_strip(&scene, zeros, 299999, NULL), 0);
    zeros[7] = INFINITY;
    assert_int_equal(scene_add_strip(&scene, zeros, 299999, NULL), -1);
    assert_int_equal(scene_add_strip(&scene, zeros, -1, NULL), -1);
    free(zeros);
    json_t *json = scene_to_json(&scene);
    assert_string_equal(text_of(json, "kind"), "strips");
    assert_int_equal(json_array_size(json_object_get(json, "strips")), 2);
    assert_true(json_is_true(json_object_get(json, "cut")));
    uint8_t bytes[sizeof square_positions];
    json_t *strip = json_array_get(json_object_get(json, "strips"), 0);
    assert_int_equal(decode(text_of(strip, "positions"), bytes), sizeof square_positions);
    assert_memory_equal(bytes, square_positions, sizeof square_positions);
    json_decref(json);
    scene_release(&scene);
}

static void many_voxels_are_sampled(void **state)
{
    (void)state;
    enum { SIDE = 256, SHOWN = 128 };
    uint8_t *bits = calloc(SIDE * SIDE * SIDE / 8, 1);
    assert_non_null(bits);
    for (size_t z = 0; z < SIDE / 2; z++)
        memset(bits + z * SIDE * SIDE / 8, 0xff, SIDE * SIDE / 8);
    struct scene scene = {0};
    assert_int_equal(scene_set_voxels(&scene, bits, SIDE, NULL), 0);
    assert_int_equal(scene_set_voxels(&scene, bits, 0, NULL), -1);
    free(bits);
    json_t *json = scene_to_json(&scene);
    json_t *voxels = json_object_get(json, "voxels");
    assert_int_equal(json_integer_value(json_object_get(voxels, "per_side")), SHOWN);
    uint8_t *shown = malloc(SHOWN * SHOWN * SHOWN / 8 + 3);
    assert_non_null(shown);
    assert_int_equal(decode(text_of(voxels, "bits"), shown), SHOWN * SHOWN * SHOWN / 8);
    for (size_t i = 0; i < SHOWN * SHOWN * SHOWN / 8; i++)
        assert_int_equal(shown[i], i < SHOWN * SHOWN * SHOWN / 16 ? 0xff : 0);
    free(shown);
    json_decref(json);
    scene_release(&scene);
}

static void curves_are_positive_and_few(void **state)
{
    (void)state;
    const double x[] = {128, 256}, y[] = {1000, 4100}, zero[] = {1, 0};
    struct scene scene = {.x_label = "triangles", .y_label = "instr\xffuctions"};
    assert_int_equal(scene_add_curve(&scene, "submission", x, zero, 2, 2, NULL), -1);
    assert_int_equal(scene_add_curve(&scene, "submission", x, y, 2, 2.03, NULL), 0);
    for (int i = 1; i < SCENE_CURVE_LIMIT; i++)
        assert_int_equal(scene_add_curve(&scene, "reference", x, y, 2, 0, NULL), 0);
    struct error err = {""};
    assert_int_equal(scene_add_curve(&scene, "one more", x, y, 2, 0, &err), -1);
    assert_true(err.text[0] != '\0');
    json_t *json = scene_to_json(&scene);
    assert_string_equal(text_of(json, "kind"), "chart");
    assert_string_equal(text_of(json, "x_label"), "triangles");
    assert_string_equal(text_of(json, "y_label"), "?");
    json_t *curve = json_array_get(json_object_get(json, "curves"), 0);
    assert_true(json_real_value(json_object_get(curve, "exponent")) == 2.03);
    assert_true(json_real_value(json_array_get(json_object_get(curve, "y"), 1)) == 4100);
    assert_null(json_object_get(json_array_get(json_object_get(json, "curves"), 1), "exponent"));
    json_decref(json);
    scene_release(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mesh_keeps_its_bytes),
        cmocka_unit_test(base64_ends_rightly),
        cmocka_unit_test(bad_meshes_are_refused_and_leave_the_scene_valid),
        cmocka_unit_test(the_empty_mesh_is_a_scene),
        cmocka_unit_test(marks_are_all_counted_and_some_kept),
        cmocka_unit_test(many_marks_are_thinned_out_evenly),
        cmocka_unit_test(marks_outside_of_the_mesh_are_not_written),
        cmocka_unit_test(big_meshes_are_cut_to_what_surrounds_the_marks),
        cmocka_unit_test(a_big_mesh_without_marks_is_cut_from_its_first_triangle),
        cmocka_unit_test(strips_add_up_and_are_cut_when_too_long),
        cmocka_unit_test(many_voxels_are_sampled),
        cmocka_unit_test(curves_are_positive_and_few),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
