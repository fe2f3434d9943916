/* OFF: the variants of keyword and counts, and hostile files. */
#include "reference/formats/off.h"
#include "reference/mesh/generate.h"
#include "tests/unit/format_checks.h"
#include "tests/unit/mesh_measures.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const struct format_under_test off = {off_read, off_write};

static void assert_square(struct mesh mesh)
{
    const float positions[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const int32_t triangles[6] = {0, 1, 2, 0, 2, 3};
    assert_int_equal(mesh.vertex_count, 4);
    assert_int_equal(mesh.triangle_count, 2);
    assert_memory_equal(mesh.positions, positions, sizeof positions);
    assert_memory_equal(mesh.triangles, triangles, sizeof triangles);
    mesh_release(&mesh);
}

#define SQUARE "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"

static void the_variants_of_the_counts_are_read(void **state)
{
    (void)state;
    assert_square(read_text(&off, "OFF\n4 1 4\n" SQUARE "4 0 1 2 3\n"));
    assert_square(read_text(&off, "OFF 4 1 4\n" SQUARE "4 0 1 2 3\n"));
    assert_square(read_text(&off, "OFF 4 1\n" SQUARE "4 0 1 2 3"));
    assert_square(read_text(&off, "# a square\n\nOFF # the keyword\n\n# counts:\n4 1 0 # V F E\n"
                                  "\n" SQUARE "# the face\n4 0 1 2 3 # done\n\n"));
    assert_square(read_text(&off, "OFF\r\n4 1 4\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n"
                                  "4  0\t1 2 3\r\n"));
}

static void colours_and_normals_are_skipped(void **state)
{
    (void)state;
    assert_square(read_text(&off, "COFF\n4 2 0\n0 0 0 255 0 0 255\n1 0 0 0 0 0 1\n1 1 0 1 1 1 1\n"
                                  "0 1 0 0.5 0.5 0.5 0\n3 0 1 2 0.5 0.5 0.5\n3 0 2 3 7\n"));
    assert_square(read_text(&off, "NOFF\n4 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n"
                                  "0 1 0 0 0 1\n4 0 1 2 3\n"));
    assert_square(read_text(&off, "STCNOFF\n4 1 0\n0 0 0 nan\n1 0 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"));
}

static void meshes_come_back_bit_for_bit(void **state)
{
    (void)state;
    assert_round_trips(&off);
}

static void bad_files_are_named_with_their_line(void **state)
{
    (void)state;
    static const char *const cases[][2] = {
        {"", "file:1: an OFF file starts with \"OFF\" (or COFF, NOFF, ...), this one with \"\""},
        {"ply\n",
         "file:1: an OFF file starts with \"OFF\" (or COFF, NOFF, ...), this one with \"ply\""},
        {"4OFF\n1 1 1\n", "file:1: 4OFF: only three dimensions are read"},
        {"OFF BINARY\n", "file:1: binary OFF files are not read: write it as text"},
        {"OFF\n# nothing\n",
         "file:3: the file ends before its counts: \"VERTICES FACES EDGES\" expected"},
        {"OFF\n4\n", "file:2: the number of faces is missing: the line ends before it"},
        {"OFF\n4 1 4 4\n", "file:2: \"4\" behind the counts of vertices, faces and edges"},
        {"OFF\n-4 1 4\n", "file:2: vertex count -4 is negative"},
        {"OFF\n0 -1\n", "file:2: face count -1 is negative"},
        {"OFF\n4000000000 1 4\n" SQUARE,
         "file:2: vertex count 4000000000 is more than the file can hold (it has 43 bytes): the "
         "header lies or the file is cut"},
        {"OFF\n4 5 4\n" SQUARE "4 0 1 2 3\n",
         "file:2: face count 5 is more than the file can hold (it has 44 bytes): the header lies "
         "or the file is cut"},
        {"OFF\n4 2 4\n" SQUARE "4 0 1 2 3\n",
         "file:8: the file ends before face 1 of 2: it is cut, or its counts lie"},
        {"OFF\n4 0 0\n0 0 0\n1 0 0\n1 1 0 # only three\n",
         "file:6: the file ends before vertex 3 of 4: it is cut, or its counts lie"},
        {"OFF\n4 1 4\n" SQUARE "4 0 1 2 3\n3 0 1 2\n",
         "file:8: the file goes on behind its last face: its counts lie"},
        {"OFF\n1 0 0\n0 0 0 1 1 1\n",
         "file:3: \"1\" behind the z of vertex 0: a file with colours starts with COFF, one with "
         "normals with NOFF"},
        {"OFF\n1 0 0\n0 nan 0\n", "file:3: y must be a finite decimal number, \"nan\" is none"},
        {"OFF\n1 0 0\n0 0 # z\n", "file:3: z is missing: the line ends before it"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 1\n",
         "file:4: face 0: corner 2 names vertex 1, the file has 1, counted from 0"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0\n\n\n",
         "file:4: the index of a vertex is missing: the line ends before it"},
        {"OFF\n1 1 0\n0 0 0\n2 0 0 0\n", "file:4: face 0 has 2 corners: at least 3 expected"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_refused(&off, cases[i][0], cases[i][1]);
}

static void damaged_files_are_refused_or_valid(void **state)
{
    (void)state;
    const char text[] = "COFF # x\n4 2 4\n0 0 0 1\n1.5 0e0 -0\n1 1 0\n0 1 0\n3 0 1 2 9\n3 0 2 3\n";
    assert_survives_damage(&off, text, sizeof text - 1);
}

static void plain_rows_are_read_as_others(void **state)
{
    (void)state;
    assert_plain_rows_are_as_others(&off, "OFF\n5 3 0\n0 0 0\n1.5 -0 1e-7\r\n1 1 0\n0 1 0.25\n"
                                          "16777217 1e3 .5\n3 0 1 2\n4 0 2 3 4\n3 4 3 2 7 7 7\n"
                                          "         \n");
    assert_plain_rows_are_as_others(&off, "CNOFF\n3 1 0\n0 0 0 0 0 1 1 1 1\n1 0 0 0 0 1 1 1 1\n"
                                          "0 1 0 0 0 1 1 1 1\n3 0 1 2\n         \n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_variants_of_the_counts_are_read),
        cmocka_unit_test(colours_and_normals_are_skipped),
        cmocka_unit_test(meshes_come_back_bit_for_bit),
        cmocka_unit_test(bad_files_are_named_with_their_line),
        cmocka_unit_test(damaged_files_are_refused_or_valid),
        cmocka_unit_test(plain_rows_are_read_as_others),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
