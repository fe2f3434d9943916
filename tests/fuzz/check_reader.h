/* What must hold for every reader of a mesh format and any bytes. Aborts when it does not. */
#ifndef TESTS_FUZZ_CHECK_READER_H
#define TESTS_FUZZ_CHECK_READER_H

#include "reference/formats/reading.h"
#include "reference/mesh/mesh.h"

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* The entry point of a fuzz target, called by libFuzzer or by replay.c. Returns 0. */
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t byte_count);

/* Reads the bytes, with and without leave to leave out what reading.h lists. Either the reader fails with an error that names the file and leaves the empty
 * mesh; or the mesh is valid, no larger than the file can justify, and written and read again is
 * the same. */
void check_reader(int (*read)(const void *, size_t, const char *, struct mesh *, struct reading *,
                              struct error *),
                  int (*write)(FILE *, const struct mesh *, struct error *), const uint8_t *bytes,
                  size_t byte_count);

#endif
