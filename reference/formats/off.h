/* OFF, the Object File Format of Geomview: text form, three dimensions.
 *
 * Read: the keyword OFF, in capitals or not, with any of the prefixes ST, C and N, whose texture
 * coordinates, colours and normals are skipped; the counts on the same line (as "OFF4 2 0" too) or
 * a later one, the edge count optional; a line a vertex, a line a face, whose colour is skipped; such
 * a row may be broken over lines between its coordinates or corners. Polygons are cut into fans
 * around their first corner. Comments start with #. */
#ifndef REFERENCE_FORMATS_OFF_H
#define REFERENCE_FORMATS_OFF_H

#include "reference/formats/reading.h"
#include "reference/mesh/mesh.h"

#include <stddef.h>
#include <stdio.h>

/* Reads a file that lies in memory; arguments, errors and cost as ply_read. */
int off_read(const void *bytes, size_t byte_count, const char *name, struct mesh *mesh,
             struct reading *reading, struct error *err) MUST_CHECK;

/* Writes a valid mesh; what off_read reads back is the same bit for bit. Returns 0, or -1 and *err.
 */
int off_write(FILE *out, const struct mesh *mesh, struct error *err) MUST_CHECK;

#endif
