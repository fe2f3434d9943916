/* Checks that the tests of the file formats share; they fail the running cmocka test. */
#ifndef TESTS_UNIT_FORMAT_CHECKS_H
#define TESTS_UNIT_FORMAT_CHECKS_H

#include "reference/formats/reading.h"
#include "reference/mesh/mesh.h"

#include <stddef.h>
#include <stdio.h>

/* The functions of one format. */
struct format_under_test {
    int (*read)(const void *bytes, size_t byte_count, const char *name, struct mesh *mesh,
                struct reading *reading, struct error *err);
    int (*write)(FILE *out, const struct mesh *mesh, struct error *err);
};

/* Reads a text that must be good and have nothing to be left out; the caller owns the mesh. */
struct mesh read_text(const struct format_under_test *format, const char *text);

/* Reads bytes that must be good where something may be left out, and refused where not. Exactly
 * `note` must be said, or nothing when it is NULL; then they need not be refused. The caller owns
 * the mesh. */
struct mesh read_told(const struct format_under_test *format, const void *bytes, size_t byte_count,
                      const char *note);

/* The bytes must be refused with exactly this error (the file is called "file"), leaving the empty
 * mesh. */
void assert_bytes_refused(const struct format_under_test *format, const void *bytes,
                          size_t byte_count, const char *error);
void assert_refused(const struct format_under_test *format, const char *text, const char *error);

/* Many random meshes, with coordinates of every magnitude, come back bit for bit. */
void assert_round_trips(const struct format_under_test *format);

/* The file cut at every length, and with bytes changed at random: it is refused with an error that
 * names the file, or read as a valid mesh. */
void assert_survives_damage(const struct format_under_test *format, const void *bytes,
                            size_t byte_count);

/* The plain rows of a text, damaged at random, are read as they are token by token: with the same
 * mesh, or the same error. */
void assert_plain_rows_are_as_others(const struct format_under_test *format, const char *text);

/* What write gives for a mesh; the caller frees it. */
char *written(const struct format_under_test *format, const struct mesh *mesh, size_t *byte_count);

#endif
