/* PLY, the Stanford polygon file format by Greg Turk: ASCII, binary little-endian, binary
 * big-endian.
 *
 * Read: element "vertex" with scalar properties x, y, z of any type; element "face" with a list
 * "vertex_indices" or "vertex_index" of any type; both in any order. Polygons are cut into fans
 * around their first corner. Other properties and elements are skipped. Rows of text may be broken over
 * lines. */
#ifndef REFERENCE_FORMATS_PLY_H
#define REFERENCE_FORMATS_PLY_H

#include "reference/formats/reading.h"
#include "reference/mesh/mesh.h"

#include <stddef.h>
#include <stdio.h>

enum ply_encoding { PLY_ASCII, PLY_LITTLE_ENDIAN, PLY_BIG_ENDIAN };

/* Reads a file that lies in memory; the bytes may be anything.
 *
 * bytes    the whole file; may be NULL when byte_count is 0
 * name     names it in errors: "name:line: what is wrong", in binary data "name: byte offset: ..."
 * reading  starts zeroed, and is told what was left out; NULL: nothing may be left out
 * mesh     on success valid (mesh_check) and owned by the caller; on failure the empty mesh
 * returns  0, or -1 and *err
 * cost     linear; memory too, at most 40 bytes a byte of the file */
int ply_read(const void *bytes, size_t byte_count, const char *name, struct mesh *mesh,
             struct reading *reading, struct error *err) MUST_CHECK;

/* Writes a valid mesh with float positions and int indices; what ply_read reads back is the same
 * bit for bit. Returns 0, or -1 and *err when `out` takes no more. */
int ply_write(FILE *out, const struct mesh *mesh, enum ply_encoding encoding,
              struct error *err) MUST_CHECK;

#endif
