/* PLY: both samples of the course, every type and encoding, and hostile files. */
#include "reference/formats/ply.h"
#include "reference/mesh/check.h"
#include "reference/mesh/generate.h"
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

static int write_little(FILE *out, const struct mesh *mesh, struct error *err)
{
    return ply_write(out, mesh, PLY_LITTLE_ENDIAN, err);
}

static int write_big(FILE *out, const struct mesh *mesh, struct error *err)
{
    return ply_write(out, mesh, PLY_BIG_ENDIAN, err);
}

static const struct format_under_test ascii = {ply_read, write_ascii};
static const struct format_under_test little = {ply_read, write_little};
static const struct format_under_test big = {ply_read, write_big};

#define HEADER(vertices, faces)                                                                    \
    "ply\nformat ascii 1.0\nelement vertex " vertices                                              \
    "\nproperty float x\nproperty float y\nproperty float z\nelement face " faces                  \
    "\nproperty list uchar int vertex_index\nend_header\n"
#define THREE_VERTICES "0 0 0\n1 0 0\n0 1 0\n"

/* -- the samples of the course ---------------------------------------------------------------- */

static void the_cube_of_the_lecture_is_read(void **state)
{
    (void)state;
    /* The lecture shows the first five vertices and four faces; the rest completes the cube's
     * corners and two of its sides. */
    struct mesh mesh =
        read_text(&ascii, "ply\nformat ascii 1.0\ncomment eight corners, six triangles\n"
                          "element vertex 8\nproperty float x\nproperty float y\n"
                          "property float z\nelement face 6\n"
                          "property list uchar int vertex_index\nend_header\n"
                          "0.0 0.0 0.0\n0.0 0.0 1.0\n0.0 1.0 0.0\n0.0 1.0 1.0\n1.0 0.0 0.0\n"
                          "1.0 0.0 1.0\n1.0 1.0 0.0\n1.0 1.0 1.0\n"
                          "3 0 1 2\n3 0 3 1\n3 4 0 1\n3 4 1 5\n3 4 5 6\n3 5 7 6\n");
    assert_int_equal(mesh.vertex_count, 8);
    assert_int_equal(mesh.triangle_count, 6);
    for (int v = 0; v < 8; v++) {
        assert_true(mesh.positions[3 * v] == (float)(v >> 2));
        assert_true(mesh.positions[3 * v + 1] == (float)(v >> 1 & 1));
        assert_true(mesh.positions[3 * v + 2] == (float)(v & 1));
    }
    const int32_t fourth[3] = {4, 1, 5};
    assert_memory_equal(mesh.triangles + 9, fourth, sizeof fourth);
    mesh_release(&mesh);
}

static void the_solid_of_quads_of_the_notes_is_read(void **state)
{
    (void)state;
    struct mesh mesh = read_text(
        &ascii, "ply\nformat ascii 1.0\ncomment eight vertices, six quads\nelement vertex 8\n"
                "property float x\nproperty float y\nproperty float z\nelement face 6\n"
                "property list uchar int vertex_index\nend_header\n"
                "0.0 0.0 0.0\n0.0 0.0 2.0\n0.0 1.3 1.0\n0.0 1.4 0.0\n"
                "1.1 0.0 0.0\n1.0 0.0 2.0\n1.0 0.8 1.5\n0.5 1.0 0.0\n"
                "4 0 1 2 3\n4 7 6 5 4\n4 0 4 5 1\n4 1 5 6 2\n4 2 6 7 3\n4 3 7 4 0\n");
    struct topology found;
    assert_int_equal(mesh_topology(&mesh, &found, NULL), 0);
    assert_int_equal(mesh.triangle_count, 12);
    assert_int_equal(found.euler_characteristic, 2);
    assert_int_equal(found.boundary.count + found.incoherent.count, 0);
    const int32_t fan[6] = {7, 6, 5, 7, 5, 4};
    assert_memory_equal(mesh.triangles + 6, fan, sizeof fan);
    assert_true(mesh.positions[3 * 2 + 1] == 1.3F);
    mesh_release(&mesh);
}

/* -- what may differ between files ------------------------------------------------------------ */

static void line_ends_and_blanks_do_not_matter(void **state)
{
    (void)state;
    struct mesh plain = read_text(&ascii, HEADER("3", "1") THREE_VERTICES "3 0 1 2\n");
    static const char *const ends[] = {"\r\n", "\r", "\n\n", " \t\n"};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        const char *from = HEADER("3", "1") THREE_VERTICES "3 0 1 2\n";
        char text[1000];
        size_t length = 0;
        for (; *from; from++)
            length += (size_t)snprintf(text + length, sizeof text - length, "%.*s",
                                       *from == '\n' ? 3 : 1, *from == '\n' ? ends[i] : from);
        struct mesh mesh = read_text(&ascii, text);
        assert_true(same_mesh(&mesh, &plain));
        mesh_release(&mesh);
    }
    struct mesh mesh = read_text(&ascii, HEADER("3", "1") THREE_VERTICES "3\t0  1 2");
    assert_true(same_mesh(&mesh, &plain)); /* no end of the last line */
    mesh_release(&mesh);
    mesh_release(&plain);
}

static void other_elements_and_properties_are_skipped(void **state)
{
    (void)state;
    struct mesh mesh = read_text(
        &ascii, "ply\nformat ascii 1.0\nobj_info made by hand\nelement camera 2\n"
                "property list ushort double matrix\nproperty float32 focus\n"
                "element face 2\nproperty uchar flags\nproperty list uint8 uint32 vertex_indices\n"
                "property list int float texcoord\n"
                "element vertex 4\nproperty double nx\nproperty int16 z\nproperty float64 y\n"
                "property uchar x\nproperty list char float weights\n"
                "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
                "2 nan 1e9 5\n0 inf\n"
                "1 3 0 1 2 2 0.5 0.5\n0 4 3 2 1 0 0\n"
                "nan -1 1.5 7 0\n0 -2 2.5 8 1 9\n0 -3 3.5 9 0\n0 -4 1e-3 255 0\n"
                "0 1\n");
    assert_int_equal(mesh.vertex_count, 4);
    assert_int_equal(mesh.triangle_count, 3);
    const float last[3] = {255.0F, 0.001F, -4.0F};
    assert_memory_equal(mesh.positions + 9, last, sizeof last);
    const int32_t indices[9] = {0, 1, 2, 3, 2, 1, 3, 1, 0};
    assert_memory_equal(mesh.triangles, indices, sizeof indices);
    mesh_release(&mesh);
}

static size_t append(unsigned char *to, size_t at, const void *bytes, size_t count)
{
    memcpy(to + at, bytes, count);
    return at + count;
}

/* Appends an integer of the given bytes in the given order. */
static size_t append_integer(unsigned char *to, size_t at, uint64_t value, int count, bool is_big)
{
    for (int i = 0; i < count; i++)
        to[at + (size_t)i] = (unsigned char)(value >> 8 * (is_big ? count - 1 - i : i));
    return at + (size_t)count;
}

static void binary_types_are_read_in_both_orders(void **state)
{
    (void)state;
    for (int is_big = 0; is_big < 2; is_big++) {
        unsigned char file[600];
        char header[500];
        int length = snprintf(
            header, sizeof header,
            "ply\nformat binary_%s_endian 1.0\nelement vertex 3\nproperty char x\n"
            "property ushort y\nproperty double z\nproperty list short uint extra\n"
            "element face 1\nproperty list uint16 int16 vertex_index\nproperty float quality\n"
            "end_header\n",
            is_big ? "big" : "little");
        size_t at = append(file, 0, header, (size_t)length);
        for (uint64_t v = 0; v < 3; v++) {
            at = append_integer(file, at, 0xff - v, 1, is_big);               /* -1 - v */
            at = append_integer(file, at, 0xff00 + v, 2, is_big);             /* 65280 + v */
            at = append_integer(file, at, UINT64_C(0x3ff8) << 48, 8, is_big); /* 1.5 */
            at = append_integer(file, at, v, 2, is_big);
            for (uint64_t i = 0; i < v; i++)
                at = append_integer(file, at, 0xdeadbeef, 4, is_big);
        }
        at = append_integer(file, at, 3, 2, is_big);
        for (uint64_t i = 0; i < 3; i++)
            at = append_integer(file, at, 2 - i, 2, is_big);
        at =
            append_integer(file, at, 0x7fc00000, 4, is_big); /* NaN in a property that is skipped */
        struct mesh mesh;
        struct error err = {0};
        assert_int_equal(ply_read(file, at, "file", &mesh, NULL, &err), 0);
        const float last[3] = {-3.0F, 65282.0F, 1.5F};
        assert_memory_equal(mesh.positions + 6, last, sizeof last);
        const int32_t triangle[3] = {2, 1, 0};
        assert_memory_equal(mesh.triangles, triangle, sizeof triangle);
        mesh_release(&mesh);
        assert_survives_damage(&little, file, at);
    }
}

static void binary_data_may_start_with_any_byte(void **state)
{
    (void)state;
    /* After a header whose lines end with CR alone, an LF is the first byte of data: 10. */
    const char file[] = "ply\rformat binary_little_endian 1.0\relement vertex 1\r"
                        "property uchar x\rproperty uchar y\rproperty uchar z\rend_header\r"
                        "\n\r ";
    struct mesh mesh;
    struct error err = {0};
    assert_int_equal(ply_read(file, sizeof file - 1, "file", &mesh, NULL, &err), 0);
    const float expected[3] = {10.0F, 13.0F, 32.0F};
    assert_memory_equal(mesh.positions, expected, sizeof expected);
    mesh_release(&mesh);
}

static void meshes_come_back_bit_for_bit(void **state)
{
    (void)state;
    assert_round_trips(&ascii);
    assert_round_trips(&little);
    assert_round_trips(&big);
}

static void binary_files_have_the_expected_size(void **state)
{
    (void)state;
    struct mesh cube;
    size_t size;
    assert_int_equal(generate_cube(&cube, NULL), 0);
    char *bytes = written(&little, &cube, &size);
    const char *data = strstr(bytes, "end_header\n") + strlen("end_header\n");
    assert_int_equal(size - (size_t)(data - bytes), 12 * 8 + 13 * 12);
    free(bytes);
    mesh_release(&cube);
}

/* -- hostile files ---------------------------------------------------------------------------- */

static void bad_headers_are_named_with_their_line(void **state)
{
    (void)state;
    static const char *const cases[][2] = {
        {"", "file:1: a PLY file starts with the line \"ply\", this one with \"\""},
        {"solid \1x\n", "file:1: a PLY file starts with the line \"ply\", this one with \"solid\""},
        {"ply\n", "file:2: the file ends within the header: it is cut, or end_header is missing"},
        {"ply\nformat ascii 2.0\n", "file:2: format version \"2.0\": only 1.0 exists"},
        {"ply\nformat utf8 1.0\n", "file:2: format \"utf8\": ascii, binary_little_endian or "
                                   "binary_big_endian expected"},
        {"ply\nformat\n", "file:2: the format is missing: the line ends before it"},
        {"ply\ncomment x\nelement vertex 1 2\n", "file:3: \"2\" behind the end of the statement"},
        {"ply\nelement vertex\n",
         "file:2: the count of the element is missing: the line ends before it"},
        {"ply\nelement vertex -4\n", "file:2: vertex count -4 is negative"},
        {"ply\nelement vertex 99999999999999999999\n",
         "file:2: the count of the element must be a whole number, \"99999999999999999999\" is "
         "none"},
        {"ply\nelement vertex 1\nelement vertex 1\n", "file:3: element vertex is declared twice"},
        {"ply\nproperty float x\n",
         "file:2: a property before any element: \"element vertex COUNT\" expected"},
        {"ply\nelement vertex 1\nproperty real x\n",
         "file:3: \"real\" is no type: char, uchar, short, ushort, int, uint, float or double "
         "expected"},
        {"ply\nelement vertex 1\nproperty list float int x\n",
         "file:3: the length of a list cannot be a float: an integer type expected"},
        {"ply\nelement vertex 1\nproperty list uchar int x\n",
         "file:3: property x must not be a list"},
        {"ply\nelement face 1\nproperty int vertex_index\n",
         "file:3: property vertex_index must be a list"},
        {"ply\nelement vertex 1\nproperty int x\nproperty int x\n",
         "file:4: property x is declared twice"},
        {"ply\nelement tristrips 1\n",
         "file:2: the faces are triangle strips (tristrips), which are not read: write the file "
         "with single faces"},
        {"ply\nvertices 8\n", "file:2: \"vertices\" in a PLY header: format, comment, element, "
                              "property or end_header expected"},
        {"ply\nelement vertex 0\nend_header\n",
         "file:3: the header has no format line: \"format ascii 1.0\" expected"},
        {"ply\nformat ascii 1.0\nend_header\n", "file:3: the header has no element vertex"},
        {"ply\nformat ascii 1.0\nelement vertex 1\nend_header\n0 0 0\n",
         "file:3: the element has no property"},
        {"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float z\n"
         "end_header\n0 0 0\n",
         "file:3: the vertices have no property y"},
        {"ply\nformat ascii 1.0\nelement vertex 0\nelement face 1\nproperty int flags\n"
         "end_header\n0\n",
         "file:4: the faces have no list vertex_indices or vertex_index"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_refused(&ascii, cases[i][0], cases[i][1]);
}

static void lying_counts_cost_nothing_and_are_named(void **state)
{
    (void)state;
    assert_refused(&ascii, HEADER("4000000000", "1") THREE_VERTICES "3 0 1 2\n",
                   "file:3: vertex count 4000000000 is more than the file can hold (it has 187 "
                   "bytes): the header lies or the file is cut");
    assert_refused(&ascii, HEADER("3", "9223372036854775807") THREE_VERTICES "3 0 1 2\n",
                   "file:7: face count 9223372036854775807 is more than the file can hold (it has "
                   "196 bytes): the header lies or the file is cut");
    assert_refused(&ascii, HEADER("4", "1") THREE_VERTICES "3 0 1 2\n",
                   "file:13: \"2\" behind the last value of vertex 3");
    assert_refused(&ascii, HEADER("3", "2") THREE_VERTICES "3 0 1 2\n",
                   "file:14: the file ends in face 1 of 2: it is cut, or the header lies");
    assert_refused(&ascii, HEADER("2", "1") THREE_VERTICES "3 0 1 1\n",
                   "file:12: face 0 has 0 corners: at least 3 expected");
    assert_refused(&ascii, HEADER("3", "0") THREE_VERTICES "3 0 1 2\n",
                   "file:13: the file goes on behind its last element: the header lies");
    const char binary[] = "ply\nformat binary_little_endian 1.0\nelement vertex 0\nelement face 1\n"
                          "property list uint int vertex_index\nend_header\n"
                          "\xff\xff\xff\xff";
    assert_bytes_refused(&little, binary, sizeof binary - 1,
                         "file: byte 119: the file ends in face 0 of 1: it is cut, or the header "
                         "lies");
}

static void bad_rows_are_named_with_their_line(void **state)
{
    (void)state;
    assert_refused(&ascii, HEADER("1", "0") "0 zero 0\n",
                   "file:10: y must be a finite decimal number, \"zero\" is none");
    assert_refused(&ascii, HEADER("1", "0") "0 0 nan\n",
                   "file:10: z must be a finite decimal number, \"nan\" is none");
    assert_refused(&ascii, HEADER("1", "0") "0 0x1p3 0\n",
                   "file:10: y must be a finite decimal number, \"0x1p3\" is none");
    assert_refused(&ascii, HEADER("1", "0") "0 0 1e39\n",
                   "file:10: z is 1e39, which is too large for a float (3.4e38)");
    assert_refused(&ascii, HEADER("1", "0") "0 0 1-2\n",
                   "file:10: z must be a finite decimal number, \"1-2\" is none");
    assert_refused(&ascii, HEADER("1", "0") "0 1e5 \n",
                   "file:10: z is missing: vertex 0 ends before it");
    assert_refused(&ascii, HEADER("3", "1") THREE_VERTICES "3 0 1 3\n",
                   "file:13: face 0: corner 2 names vertex 3, the file has 3, counted from 0");
    assert_refused(&ascii, HEADER("3", "1") THREE_VERTICES "3 0 -1 2\n",
                   "file:13: face 0: corner 1 names vertex -1, the file has 3, counted from 0");
    assert_refused(&ascii, HEADER("3", "1") THREE_VERTICES "3 0 1.5 2\n",
                   "file:13: the index of a vertex must be a whole number, \"1.5\" is none");
    assert_refused(&ascii, HEADER("3", "1") THREE_VERTICES "300 0 1 2\n",
                   "file:13: the length of the list is 300, its type reaches from 0 to 255");
    assert_refused(&ascii, HEADER("3", "1") THREE_VERTICES "2 0 1\n",
                   "file:13: face 0 has 2 corners: at least 3 expected");
    assert_refused(&ascii, HEADER("3", "1") THREE_VERTICES "4 0 1 2\n",
                   "file:13: the index of a vertex is missing: face 0 ends before it");
}

static void bad_binary_values_are_named_with_their_byte(void **state)
{
    (void)state;
    const char nan[] = "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float x\n"
                       "property float y\nproperty float z\nend_header\n"
                       "\0\0\0\0\x7f\xc0\0\0\0\0\0\0";
    assert_bytes_refused(&big, nan, sizeof nan - 1,
                         "file: byte 116: y of vertex 0 is NaN: a finite number expected");
    const char huge[] = "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty double x\n"
                        "property char y\nproperty char z\nend_header\n"
                        "\x7f\xe0\0\0\0\0\0\0\0\0";
    assert_bytes_refused(&big, huge, sizeof huge - 1,
                         "file: byte 111: x of vertex 0 is too large for a float: a finite number "
                         "expected");
    const char index[] = "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty char x\n"
                         "property char y\nproperty char z\nelement face 1\n"
                         "property list char float vertex_index\nend_header\n"
                         "abc\3\x7f\xc0\0\0";
    assert_bytes_refused(&big, index, sizeof index - 1,
                         "file: byte 166: face 0: corner 0 names vertex nan, the file has 1, "
                         "counted from 0");
    const char length[] = "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty char x\n"
                          "property char y\nproperty char z\nproperty list char int w\nend_header\n"
                          "abc\xff";
    assert_bytes_refused(&big, length, sizeof length - 1,
                         "file: byte 137: vertex 0: a list of length -1");
}

static void damaged_files_are_refused_or_valid(void **state)
{
    (void)state;
    const struct format_under_test *const encodings[] = {&ascii, &little, &big};
    for (int i = 0; i < 3; i++) {
        struct mesh tetrahedron;
        size_t byte_count;
        assert_int_equal(generate_tetrahedron(&tetrahedron, NULL), 0);
        char *bytes = written(encodings[i], &tetrahedron, &byte_count);
        assert_survives_damage(encodings[i], bytes, byte_count);
        free(bytes);
        mesh_release(&tetrahedron);
    }
}

static void plain_rows_are_read_as_others(void **state)
{
    (void)state;
    assert_plain_rows_are_as_others(&ascii, HEADER("4", "3") "0 0 0\n1.5 -0 1e-7\r\n0 1 0.25\n"
                                                             "16777217 1e3 .5\n3 0 1 2\n"
                                                             "4 0 1 2 3\n3 3 2 1\n         \n");
    assert_plain_rows_are_as_others(
        &ascii, "ply\nformat ascii 1.0\nelement face 1\nproperty list char uchar vertex_indices\n"
                "element vertex 3\nproperty double z\nproperty uchar red\nproperty float x\n"
                "property double y\nend_header\n3 2 1 0\n0.1 255 1 2\n0.2 0 1 2\n0.3 7 1 2\n"
                "         \n");
}

static void bad_plain_binary_rows_are_named_with_their_byte(void **state)
{
    (void)state;
    struct mesh square;
    size_t byte_count;
    assert_int_equal(generate_grid(&square, 1, 1, NULL), 0);
    const struct format_under_test *const encodings[] = {&little, &big};
    for (int i = 0; i < 2; i++) {
        char *bytes = written(encodings[i], &square, &byte_count), error[200];
        /* The last index of the last triangle, and the y of the last vertex. */
        memset(bytes + byte_count - 4, 0x7f, 4);
        snprintf(
            error, sizeof error,
            "file: byte %zu: face 1: corner 2 names vertex 2139062143, the file has 4, counted "
            "from 0",
            byte_count - 4);
        assert_bytes_refused(encodings[i], bytes, byte_count, error);
        memset(bytes + byte_count - 4, 0xff, 4);
        snprintf(error, sizeof error,
                 "file: byte %zu: face 1: corner 2 names vertex -1, the file has 4, counted from 0",
                 byte_count - 4);
        assert_bytes_refused(encodings[i], bytes, byte_count, error);
        size_t y = byte_count - 26 - 8;
        memset(bytes + y, 0xff, 4);
        snprintf(error, sizeof error,
                 "file: byte %zu: y of vertex 3 is NaN: a finite number expected", y);
        assert_bytes_refused(encodings[i], bytes, byte_count, error);
        free(bytes);
    }
    mesh_release(&square);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_cube_of_the_lecture_is_read),
        cmocka_unit_test(the_solid_of_quads_of_the_notes_is_read),
        cmocka_unit_test(line_ends_and_blanks_do_not_matter),
        cmocka_unit_test(other_elements_and_properties_are_skipped),
        cmocka_unit_test(binary_types_are_read_in_both_orders),
        cmocka_unit_test(binary_data_may_start_with_any_byte),
        cmocka_unit_test(meshes_come_back_bit_for_bit),
        cmocka_unit_test(binary_files_have_the_expected_size),
        cmocka_unit_test(bad_headers_are_named_with_their_line),
        cmocka_unit_test(lying_counts_cost_nothing_and_are_named),
        cmocka_unit_test(bad_rows_are_named_with_their_line),
        cmocka_unit_test(bad_binary_values_are_named_with_their_byte),
        cmocka_unit_test(damaged_files_are_refused_or_valid),
        cmocka_unit_test(plain_rows_are_read_as_others),
        cmocka_unit_test(bad_plain_binary_rows_are_named_with_their_byte),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
