/* Files as the world's programs write them: what the formats' definitions do not foresee is read,
 * or left out and told, or refused with its name; never is anything lost in silence. */
#include "reference/formats/mesh_file.h"
#include "reference/formats/obj.h"
#include "reference/formats/off.h"
#include "reference/formats/ply.h"
#include "tests/unit/format_checks.h"
#include "tests/unit/mesh_measures.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static int write_ascii(FILE *out, const struct mesh *mesh, struct error *err)
{
    return ply_write(out, mesh, PLY_ASCII, err);
}

static const struct format_under_test off = {off_read, off_write};
static const struct format_under_test obj = {obj_read, obj_write};
static const struct format_under_test ply = {ply_read, write_ascii};

#define CORNERS "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
#define TWO "3 0 1 2\n3 0 2 3\n"
#define V_CORNERS "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
#define PLY_HEAD(vertices, faces)                                                                  \
    "ply\nformat ascii 1.0\nelement vertex " vertices                                              \
    "\nproperty float x\nproperty float y\nproperty float z\nelement face " faces                  \
    "\nproperty list uchar int vertex_indices\nend_header\n"
#define PLY_BINARY(end)                                                                            \
    "ply" end "format binary_little_endian 1.0" end "element vertex 3" end "property uchar x" end  \
    "property uchar y" end "property uchar z" end "element face 1" end                             \
    "property list uchar uchar vertex_indices" end "end_header" end

/* The square of two triangles, with or without its fourth vertex and second triangle. */
static void assert_square(struct mesh mesh, int32_t vertex_count, int32_t triangle_count)
{
    const float positions[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const int32_t triangles[6] = {0, 1, 2, 0, 2, 3};
    assert_int_equal(mesh.vertex_count, vertex_count);
    assert_int_equal(mesh.triangle_count, triangle_count);
    assert_memory_equal(mesh.positions, positions, 12 * (size_t)vertex_count);
    assert_memory_equal(mesh.triangles, triangles, 12 * (size_t)triangle_count);
    mesh_release(&mesh);
}

static void assert_read(const struct format_under_test *format, const char *text, const char *note)
{
    assert_square(read_told(format, text, strlen(text), note), 4, 2);
}

/* -- OFF -------------------------------------------------------------------------------------- */

static void off_counts_may_be_glued_to_the_keyword(void **state)
{
    (void)state;
    assert_read(&off, "OFF4 2 0\n" CORNERS TWO, NULL);
    assert_read(&off, "OFF4 2\r\n" CORNERS TWO, NULL);
    assert_read(&off, "COFF4 2 0\n0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n" TWO, NULL);
    assert_refused(&off, "OFF4x 2 0\n" CORNERS TWO,
                   "file:1: an OFF file starts with \"OFF\" (or COFF, NOFF, ...), this one with "
                   "\"OFF4x\"");
}

static void off_keywords_may_be_lower_case_or_absent(void **state)
{
    (void)state;
    assert_read(&off, "off\n4 2 0\n" CORNERS TWO, NULL);
    assert_read(&off, "Off 4 2 0\n" CORNERS TWO, NULL);
    assert_read(&off, "coff\n4 2 0\n0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n" TWO, NULL);
    assert_read(&off, "noff\n4 2 0\n0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n" TWO, NULL);
    assert_refused(&off, "nOFF\n3 4 2 0\n", "file:1: nOFF: only three dimensions are read");
    assert_refused(&off, "CnOFF\n3 4 2 0\n", "file:1: CnOFF: only three dimensions are read");
    assert_read(&off, "# bare\n4 2 0\n" CORNERS TWO,
                "The file begins without the word OFF and is read as one that has it, in line 2.");
    assert_refused(&off, "4 2 0\n" CORNERS TWO,
                   "file:1: an OFF file starts with \"OFF\" (or COFF, NOFF, ...), this one with "
                   "\"4\"");
}

static void off_rows_may_be_broken_over_lines(void **state)
{
    (void)state;
    assert_read(&off, "OFF\n4 2 0\n0 0\n0\n1\n0 0\n1 1 0\n0 1 # its z:\n\n0\n3 0 1\n2\n3\n0 2 3\n",
                NULL);
    /* A value that was forgotten is named where it is missing, not where that is noticed. */
    assert_refused(&off, "OFF\n4 2 0\n0 0 0\n1 0\n1 1 0\n0 1 0\n" TWO,
                   "file:4: z is missing: the line ends before it");
    assert_refused(&off, "OFF\n1 0 0\n0 0\n", "file:3: z is missing: the line ends before it");
}

/* -- PLY -------------------------------------------------------------------------------------- */

#define COLOURED                                                                                   \
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"                \
    "property float z\nproperty uchar red\nproperty uchar green\nelement face 2\n"                 \
    "property list uchar int vertex_indices\nend_header\n"

static void ply_rows_may_be_broken_over_lines(void **state)
{
    (void)state;
    assert_read(&ply,
                COLOURED "0 0 0\n255 0\n1 0 0 0 255\n1\n1 0 0\n\n0\n0 1 0\n0 0\n3 0 1\n2\n"
                         "3 0 2 3\n",
                NULL);
    assert_refused(&ply, COLOURED "0 0 0 255 0\n1 0 0 255\n1 1 0 0 0\n0 1 0 0 0\n" TWO,
                   "file:13: vertex 1 ends before all of its values");
    assert_refused(&ply, PLY_HEAD("4", "2") "0 0 0\n1 0\n1 1 0\n0 1 0\n" TWO,
                   "file:11: z is missing: vertex 1 ends before it");
    assert_refused(&ply, PLY_HEAD("4", "2") CORNERS "4 0 1 2\n3 0 2 3\n",
                   "file:14: the index of a vertex is missing: face 0 ends before it");
}

static void ply_lines_may_end_in_other_ways(void **state)
{
    (void)state;
    const char data[] = "\0\0\0\1\0\0\1\1\0\3\0\1\2";
    static const char *const heads[] = {PLY_BINARY("\n\r"), PLY_BINARY("\r\r\n"), PLY_BINARY("\r"),
                                        PLY_BINARY("\r\n"), PLY_BINARY("\n")};
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++) {
        char file[400];
        size_t length = strlen(heads[i]);
        memcpy(file, heads[i], length);
        memcpy(file + length, data, sizeof data - 1);
        assert_square(read_told(&ply, file, length + sizeof data - 1, NULL), 3, 1);
        /* Data that looks like the rest of a line end is data all the same. */
        file[length] = '\r';
        file[length + 1] = '\n';
        struct mesh mesh = read_told(&ply, file, length + sizeof data - 1, NULL);
        assert_true(mesh.positions[0] == 13.0F && mesh.positions[1] == 10.0F);
        mesh_release(&mesh);
    }
    assert_refused(&ply, "ply\n\rformat ascii 1.0\n\rvertices\n\r",
                   "file:3: \"vertices\" in a PLY header: format, comment, element, property or "
                   "end_header expected");
    assert_read(&obj, "v 0 0 0\n\rv 1 0 0\n\rv 1 1 0\n\rv 0 1 0\n\rf 1 2 3 4\n\r", NULL);
    assert_refused(&obj, "v 0 0 0\n\rv 1 0 0\n\rv 1 1\n\r",
                   "file:3: z is missing: the line ends before it");
    assert_read(&off, "OFF\r\r\n4 1 0\r\r\n0 0 0\r\r\n1 0 0\r\r\n1 1 0\r\r\n0 1 0\r\r\n4 0 1 2 3",
                NULL);
}

static void bytes_behind_the_end_are_told(void **state)
{
    (void)state;
    assert_read(&ply, PLY_HEAD("4", "2") CORNERS TWO "# done\n",
                "7 bytes behind the end of the mesh are not read, first in line 16.");
    assert_read(&ply, PLY_HEAD("4", "2") CORNERS TWO "\x1a",
                "1 byte behind the end of the mesh is not read, in line 16.");
    assert_read(&ply, PLY_HEAD("4", "2") CORNERS TWO "\n\n  \n", NULL);
    assert_read(&off, "OFF\n4 2 0\n" CORNERS TWO "3 0 1 2\n",
                "8 bytes behind the end of the mesh are not read, first in line 9.");
    assert_read(&obj, V_CORNERS "f 1 2 3 4\r\n\x1a",
                "1 byte behind the end of the mesh is not read, in line 6.");
    const char zeros[] = PLY_BINARY("\n") "\0\0\0\1\0\0\1\1\0\3\0\1\2\0\0\0\0";
    char note[100];
    snprintf(note, sizeof note,
             "4 bytes behind the end of the mesh are not read, first at byte %zu.",
             sizeof zeros - 1 - 4);
    assert_square(read_told(&ply, zeros, sizeof zeros - 1, note), 3, 1);
    const char newline[] = PLY_BINARY("\n") "\0\0\0\1\0\0\1\1\0\3\0\1\2\r\n";
    assert_square(read_told(&ply, newline, sizeof newline - 1, NULL), 3, 1);
    assert_refused(&ply, PLY_HEAD("4", "2") CORNERS TWO "# done\n",
                   "file:16: the file goes on behind its last element: the header lies");
}

static void eight_byte_integers_are_refused_with_the_types_there_are(void **state)
{
    (void)state;
    assert_refused(&ply, "ply\nformat ascii 1.0\nelement vertex 1\nproperty int64 x\n",
                   "file:4: \"int64\" is no type: char, uchar, short, ushort, int, uint, float or "
                   "double expected");
}

/* -- OBJ -------------------------------------------------------------------------------------- */

static void obj_statements_of_others_are_skipped_and_told(void **state)
{
    (void)state;
    assert_read(&obj,
                V_CORNERS "f 1 2 3 4\nt crease 2/1/0 0 1 2.0\nt interpolateboundary 1/0/0 1\n",
                "2 lines with other statements (\"t\") are skipped, first in line 6.");
    assert_read(&obj, "v 0 0 0\nv 1 0 0\nvw 0 0 1.0 1 0.0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n",
                "1 line with another statement (\"vw\") is skipped, in line 3.");
    assert_read(&obj, V_CORNERS "f 1 2 3 4\nbsp 1 2 3\nres 1 2 3\n",
                "2 lines with other statements (\"bsp\") are skipped, first in line 6.");
    assert_refused(&obj, V_CORNERS "f 1 2 3 4\nbsp 1 2 3\n",
                   "file:6: \"bsp\" is no statement of an OBJ file (v, f, vt, ...)");
}

static void what_is_no_obj_is_not_skipped_to_its_end(void **state)
{
    (void)state;
    struct reading reading = {0};
    struct mesh mesh;
    struct error err = {0};
    const char stl[] = "solid cube\nfacet normal 0 0 1\nouter loop\nendloop\nendsolid\n";
    assert_int_equal(obj_read(stl, sizeof stl - 1, "file", &mesh, &reading, &err), -1);
    assert_string_equal(err.text,
                        "file:1: \"solid\" is no statement of an OBJ file (v, f, vt, ...)");
    err = (struct error){0};
    const char binary[] = "\x7f"
                          "ELF\1\2\n";
    assert_int_equal(obj_read(binary, sizeof binary - 1, "file", &mesh, &reading, &err), -1);
    assert_string_equal(err.text,
                        "file:1: \"?ELF??\" is no statement of an OBJ file (v, f, vt, ...)");
}

static void a_name_that_ends_in_a_backslash_swallows_nothing(void **state)
{
    (void)state;
    assert_read(&obj, "mtllib C:\\maps\\\n" V_CORNERS "f 1 2 3 4\n", NULL);
    assert_read(&obj, "# head\\\n" V_CORNERS "usemtl a\\\ng b\\\r\no c\\\nf 1 2 3 4\n", NULL);
    assert_read(&obj, V_CORNERS "tex C:\\\nf 1 2 3 4\n",
                "1 line with another statement (\"tex\") is skipped, in line 5.");
    /* A lone backslash continues names too, and any backslash continues numbers. */
    assert_read(&obj, "g one \\\ntwo\n" V_CORNERS "f 1 2\\\n3 4\nparm u 0\\\n1 2\n", NULL);
}

/* -- every format ----------------------------------------------------------------------------- */

static void faces_of_too_few_corners_are_left_out_and_told(void **state)
{
    (void)state;
    assert_read(&obj, V_CORNERS "f 1 2 3\nf 1 2\nf 4\nf 1 3 4\n",
                "2 faces of fewer than 3 corners are left out, first in line 6.");
    assert_read(&off, "OFF\n4 3 0\n" CORNERS "3 0 1 2\n2 0 1\n3 0 2 3\n",
                "1 face of fewer than 3 corners is left out, in line 8.");
    assert_read(&ply, PLY_HEAD("4", "4") CORNERS "3 0 1 2\n2 0 1\n0\n3 0 2 3\n",
                "2 faces of fewer than 3 corners are left out, first in line 15.");
    const char binary[] = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n"
                          "property uchar x\nproperty uchar y\nproperty uchar z\nelement face 2\n"
                          "property list uchar uchar vertex_indices\nend_header\n"
                          "\0\0\0\1\0\0\1\1\0\2\0\1\3\0\1\2";
    char note[100];
    snprintf(note, sizeof note, "1 face of fewer than 3 corners is left out, at byte %zu.",
             sizeof binary - 1 - 7);
    assert_square(read_told(&ply, binary, sizeof binary - 1, note), 3, 1);
    /* What it names is looked at all the same. */
    struct reading reading = {0};
    struct mesh mesh;
    struct error err = {0};
    const char text[] = V_CORNERS "f 1 5\n";
    assert_int_equal(obj_read(text, sizeof text - 1, "file", &mesh, &reading, &err), -1);
    assert_string_equal(err.text, "file:5: a face names vertex 5, the file has 4");
}

static void vertices_that_are_not_finite_are_left_out_and_told(void **state)
{
    (void)state;
    const char *note = "1 vertex that is not finite and that no face uses is left out, in line 5.";
    assert_read(&off, "OFF\n5 2 0\n0 0 0\n1 0 0\nnan 0 0\n1 1 0\n0 1 0\n3 0 1 3\n3 0 3 4\n", note);
    assert_read(&obj, "\n\nv 0 0 0\nv 1 0 0\nv -inf 0 0 1\nv 1 1 0\nv 0 1 0\nf 1 2 -2\nf 1 4 5\n",
                note);
    assert_read(&ply,
                PLY_HEAD("6", "2") "0 0 0\nNaN -1.#IND 1.#INF\n1 0 0\n1 1 0\n0 1 0\n0 0 -nan(ind)\n"
                                   "3 0 2 3\n3 0 3 4\n",
                "2 vertices that are not finite and that no face uses are left out, first in line "
                "11.");
    static const char *const used[] = {"OFF\n3 1 0\n0 0 0\n1 0 0\nnan 0 0\n3 0 1 2\n",
                                       "OFF\n4 1 0\nnan 0 0\n1 0 0\n0 0 inf\n1 1 1\n3 1 3 2\n"};
    for (int i = 0; i < 2; i++) {
        struct reading reading = {0};
        struct mesh mesh;
        struct error err = {0};
        assert_int_equal(off_read(used[i], strlen(used[i]), "file", &mesh, &reading, &err), -1);
        assert_string_equal(err.text,
                            "file:5: a face uses this vertex, which has a coordinate that "
                            "is not finite: give it a place, or take out the face");
        assert_null(mesh.positions);
    }
}

static void a_binary_vertex_that_is_not_finite_is_told_with_its_byte(void **state)
{
    (void)state;
    const char file[] = "ply\nformat binary_big_endian 1.0\nelement vertex 2\nproperty float x\n"
                        "property float y\nproperty float z\nend_header\n"
                        "\0\0\0\0\x7f\xc0\0\0\0\0\0\0"
                        "\0\0\0\0\0\0\0\0\0\0\0\0";
    struct mesh mesh =
        read_told(&ply, file, sizeof file - 1,
                  "1 vertex that is not finite and that no face uses is left out, at byte 120.");
    assert_int_equal(mesh.vertex_count, 1);
    mesh_release(&mesh);
}

static void marks_of_unicode_are_named(void **state)
{
    (void)state;
    assert_read(&off, "\xef\xbb\xbfOFF\n4 2 0\n" CORNERS TWO, NULL);
    static const char wide[] = "file:1: the file is text in UTF-16 or UTF-32: save it as UTF-8 or "
                               "ASCII";
    assert_bytes_refused(&obj, "\xff\xfev\0 \0", 6, wide);
    assert_bytes_refused(&ply, "\xfe\xff\0p\0l", 6, wide);
    assert_bytes_refused(&off, "O\0F\0", 4, wide);
    assert_bytes_refused(&off, "\0\0\0O", 4,
                         "file:1: an OFF file starts with \"OFF\" (or COFF, NOFF, ...), this one "
                         "with \"???O\"");
    assert_refused(
        &ply,
        PLY_HEAD("1", "0") "\xef\xbb\xbf"
                           "0 0 0\n",
        "file:10: a byte order mark (BOM) stands before x: take it out (bytes EF BB BF)");
    assert_refused(&off,
                   "OFF\n\xef\xbb\xbf"
                   "4 2 0\n",
                   "file:2: a byte order mark (BOM) stands before the number of vertices: take it "
                   "out (bytes EF BB BF)");
    struct reading reading = {0};
    struct mesh mesh;
    struct error err = {0};
    const char joined[] = V_CORNERS "\xef\xbb\xbfv 0 0 0\n";
    assert_int_equal(obj_read(joined, sizeof joined - 1, "file", &mesh, &reading, &err), -1);
    assert_string_equal(err.text, "file:5: a byte order mark (BOM) stands before the statement "
                                  "\"v\": take it out (bytes EF BB BF)");
}

static void notes_are_said_in_spanish_too(void **state)
{
    (void)state;
    struct reading reading = {0};
    reading.notes[READING_STATEMENT] = (struct reading_note){2, 7, false, "bsp"};
    reading.notes[READING_REST] = (struct reading_note){1, 80, true, ""};
    struct message message;
    reading_say(&reading, READING_STATEMENT, &message);
    assert_string_equal(message.es,
                        "Se saltan 2 líneas con otras sentencias («bsp»), primero en la línea 7.");
    reading_say(&reading, READING_REST, &message);
    assert_string_equal(message.es,
                        "No se lee 1 byte que sigue al final de la malla, en el byte 80.");
    for (int kind = 0; kind < READING_KINDS; kind++)
        assert_non_null(reading_slug((enum reading_kind)kind));
}

/* -- streams ---------------------------------------------------------------------------------- */

static struct mesh read_stream(const char *text)
{
    FILE *in = fmemopen((void *)(uintptr_t)text, strlen(text), "r");
    struct mesh mesh;
    struct error err = {0};
    assert_non_null(in);
    if (mesh_file_read_stream(in, "-", &mesh, NULL, &err))
        fail_msg("%s", err.text);
    assert_int_equal(fclose(in), 0);
    return mesh;
}

static void the_format_of_a_stream_follows_from_its_first_word(void **state)
{
    (void)state;
    assert_square(read_stream("# c\n\nOFF4 2 0\n" CORNERS TWO), 4, 2);
    assert_square(read_stream("coff 4 2 0\n" CORNERS TWO), 4, 2);
    assert_square(read_stream("# OFF\n" V_CORNERS "f 1 2 3 4\n"), 4, 2);
    assert_square(read_stream("\xef\xbb\xbf" PLY_HEAD("4", "2") CORNERS TWO), 4, 2);
    struct mesh mesh;
    struct error err = {0};
    FILE *in = fopen("/dev/null", "r");
    assert_int_equal(mesh_file_read_stream(in, "-", &mesh, NULL, &err), 0); /* an empty OBJ */
    assert_int_equal(mesh.vertex_count, 0);
    assert_int_equal(fclose(in), 0);
    in = fopen("/", "r"); /* a folder can be opened and not read */
    assert_non_null(in);
    assert_int_equal(mesh_file_read_stream(in, "-", &mesh, NULL, &err), -1);
    assert_string_equal(err.text, "-: Is a directory");
    assert_int_equal(fclose(in), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(off_counts_may_be_glued_to_the_keyword),
        cmocka_unit_test(off_keywords_may_be_lower_case_or_absent),
        cmocka_unit_test(off_rows_may_be_broken_over_lines),
        cmocka_unit_test(ply_rows_may_be_broken_over_lines),
        cmocka_unit_test(ply_lines_may_end_in_other_ways),
        cmocka_unit_test(bytes_behind_the_end_are_told),
        cmocka_unit_test(eight_byte_integers_are_refused_with_the_types_there_are),
        cmocka_unit_test(obj_statements_of_others_are_skipped_and_told),
        cmocka_unit_test(what_is_no_obj_is_not_skipped_to_its_end),
        cmocka_unit_test(a_name_that_ends_in_a_backslash_swallows_nothing),
        cmocka_unit_test(faces_of_too_few_corners_are_left_out_and_told),
        cmocka_unit_test(vertices_that_are_not_finite_are_left_out_and_told),
        cmocka_unit_test(a_binary_vertex_that_is_not_finite_is_told_with_its_byte),
        cmocka_unit_test(marks_of_unicode_are_named),
        cmocka_unit_test(notes_are_said_in_spanish_too),
        cmocka_unit_test(the_format_of_a_stream_follows_from_its_first_word),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
