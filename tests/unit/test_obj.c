/* OBJ: every form of a corner, and hostile files. */
#include "reference/formats/obj.h"
#include "reference/mesh/generate.h"
#include "tests/unit/format_checks.h"
#include "tests/unit/mesh_measures.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const struct format_under_test obj = {obj_read, obj_write};

#define SQUARE "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"

static void assert_triangles(struct mesh mesh, int32_t count, const int32_t *expected)
{
    assert_int_equal(mesh.triangle_count, count);
    assert_memory_equal(mesh.triangles, expected, 12 * (size_t)count);
    mesh_release(&mesh);
}

static void every_form_of_a_corner_is_read(void **state)
{
    (void)state;
    const int32_t one[3] = {0, 1, 2};
    assert_triangles(read_text(&obj, SQUARE "f 1 2 3\n"), 1, one);
    assert_triangles(read_text(&obj, SQUARE "f 1/7 2/8 3/9\n"), 1, one);
    assert_triangles(read_text(&obj, SQUARE "f 1//7 2//8 3//9\n"), 1, one);
    assert_triangles(read_text(&obj, SQUARE "f 1/34/0 2/45/0 3/-1/1\n"), 1, one);
    assert_triangles(read_text(&obj, SQUARE "f -4 -3 -2\n"), 1, one);
    const int32_t two[6] = {0, 1, 2, 0, 2, 3};
    assert_triangles(read_text(&obj, SQUARE "f 1 2 3 4\n"), 2, two);
    assert_triangles(read_text(&obj, SQUARE "f -4//-1 2 3 4\n"), 2, two);
}

static void negative_numbers_count_from_the_latest_vertex(void **state)
{
    (void)state;
    const int32_t expected[6] = {0, 1, 2, 3, 4, 5};
    assert_triangles(read_text(&obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n"
                                     "v 0 0 1\nv 1 0 1\nv 0 1 1\nf -3 -2 -1\n"),
                     2, expected);
}

static void a_face_may_stand_before_its_vertices(void **state)
{
    (void)state;
    const int32_t expected[3] = {3, 1, 0};
    assert_triangles(read_text(&obj, "f 4 2 1\n" SQUARE), 1, expected);
}

static void the_rest_of_the_format_is_skipped(void **state)
{
    (void)state;
    const int32_t expected[6] = {0, 1, 2, 0, 2, 3};
    assert_triangles(
        read_text(&obj, "\xef\xbb\xbf# a square\r\nmtllib paint.mtl\r\no square\r\n"
                        "v 0 0 0 1.0\r\nv 1 0 0 0.5 0.5 0.5\r\n\tv 1 1 0 # third\r\nv 0 1 0\r\n"
                        "vt 0.5 1 0\r\nvn 0.7 0 0.7\r\ng one two\r\ns off\r\nusemtl red\r\n"
                        "l 1 2\r\np 3\r\n  f 1/1/1 \\\r\n 2/1/1\\\r\n  3/1/1 4/1/1#end\r\n# bye"),
        2, expected);
    struct mesh mesh = read_text(&obj, "# nothing at all\n");
    assert_int_equal(mesh.vertex_count + mesh.triangle_count, 0);
    mesh_release(&mesh);
}

static void meshes_come_back_bit_for_bit(void **state)
{
    (void)state;
    assert_round_trips(&obj);
}

static void bad_files_are_named_with_their_line(void **state)
{
    (void)state;
    static const char *const cases[][2] = {
        {"ply\n", "file:1: \"ply\" is no statement of an OBJ file (v, f, vt, ...)"},
        {"\x7f"
         "ELF\1\2\n",
         "file:1: \"?ELF??\" is no statement of an OBJ file (v, f, vt, ...)"},
        {"v 0 0\n", "file:1: z is missing: the line ends before it"},
        {"# x\nv 0 0,5 0\n", "file:2: y must be a finite decimal number, \"0,5\" is none"},
        {"v 0 0 inf\n", "file:1: z must be a finite decimal number, \"inf\" is none"},
        {"v 0 0 -1e40\n", "file:1: z is -1e40, which is too large for a float (3.4e38)"},
        {"v 0 0 0 red\n",
         "file:1: a weight or colour must be a finite decimal number, \"red\" is none"},
        {SQUARE "f 0 1 2\n", "file:5: vertex 0: OBJ files count from 1 (or back from -1)"},
        {SQUARE "f 1 2 -5\n", "file:5: vertex -5 counts back behind the first of 4 vertices"},
        {SQUARE "f 1 2 5\nf 1 2 3\n", "file:5: a face names vertex 5, the file has 4"},
        {SQUARE "f 1 2\n", "file:5: a face of 2 corners: at least 3 expected"},
        {SQUARE "f\n", "file:5: a face of 0 corners: at least 3 expected"},
        {SQUARE "f 1 2 3.0\n",
         "file:5: the number of a vertex must be a whole number, \"3.0\" is none"},
        {SQUARE "f 1 2 /3\n",
         "file:5: the number of a vertex must be a whole number, \"\" is none"},
        {SQUARE "f 1 2 3/x\n",
         "file:5: the number of a texture vertex must be a whole number, \"x\" is none"},
        {SQUARE "f 1 2 3/1/1/1\n", "file:5: corner \"3/1/1/1\": at most two slashes expected"},
        {SQUARE "f 1 2 4000000000\n", "file:5: vertex 4000000000 is more than the possible "
                                      "715827882"},
        {SQUARE "f 1 2 700000000\n", "file:5: a face names vertex 700000000, the file has 4"},
        {SQUARE "f 1 2 \\\n -9223372036854775807\n",
         "file:6: vertex -9223372036854775807 counts back behind the first of 4 vertices"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_refused(&obj, cases[i][0], cases[i][1]);
}

static void a_long_token_is_cut_in_the_message(void **state)
{
    (void)state;
    char text[3000] = "v 0 0 ";
    memset(text + 6, '7', 2000);
    assert_refused(&obj, text,
                   "file:1: z must be a finite decimal number, "
                   "\"7777777777777777777777777777777777777777...\" is none");
}

static void damaged_files_are_refused_or_valid(void **state)
{
    (void)state;
    const char text[] =
        "# x\nv 0 0 0\nv 1.5 0e0 -0\nv 1 1 0 1\nv 0 1 0\nvt 0 0\nf 1/1/1 2//1 -2\\\n 4\n";
    assert_survives_damage(&obj, text, sizeof text - 1);
}

static void plain_rows_are_read_as_others(void **state)
{
    (void)state;
    assert_plain_rows_are_as_others(
        &obj, "v 0 -0 1.5\nv 1e-3 0.12345678 2\r\nv 1 1 0 1\nv 0 1 0 0.5 0.5 0.5\n"
              "vt 0.5 0.5\nvn 0 0 1\ng a\nf 1 2 3\nf 1/1 2/1 -2/1\nf 1//1 2//1 3//1 4//1\n"
              "f 1/1/1 2/1/1 3/1/1 \nv  16777217 1e39 .5\nf 5 4 -1\n# done\n       \n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_form_of_a_corner_is_read),
        cmocka_unit_test(negative_numbers_count_from_the_latest_vertex),
        cmocka_unit_test(a_face_may_stand_before_its_vertices),
        cmocka_unit_test(the_rest_of_the_format_is_skipped),
        cmocka_unit_test(meshes_come_back_bit_for_bit),
        cmocka_unit_test(bad_files_are_named_with_their_line),
        cmocka_unit_test(a_long_token_is_cut_in_the_message),
        cmocka_unit_test(damaged_files_are_refused_or_valid),
        cmocka_unit_test(plain_rows_are_read_as_others),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
