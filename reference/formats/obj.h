/* OBJ, the Wavefront object format: vertices and faces of it.
 *
 * Read: v (x y z, then a weight or colours, ignored), f with corners v, v/t, v//n, v/t/n, where v
 * counts from 1, or from -1 backwards from the latest vertex. Texture and normal numbers must be
 * whole numbers and are ignored otherwise. Polygons are cut into fans around their first corner.
 * Comments, lines continued by a backslash and the format's other statements are skipped, and so are
 * unknown ones where there is a reading to tell it. A backslash at the end of a name ("mtllib C:\maps\")
 * belongs to the name; one that stands alone continues its line. */
#ifndef REFERENCE_FORMATS_OBJ_H
#define REFERENCE_FORMATS_OBJ_H

#include "reference/formats/reading.h"
#include "reference/mesh/mesh.h"

#include <stddef.h>
#include <stdio.h>

/* Reads a file that lies in memory; arguments, errors and cost as ply_read. */
int obj_read(const void *bytes, size_t byte_count, const char *name, struct mesh *mesh,
             struct reading *reading, struct error *err) MUST_CHECK;

/* Writes a valid mesh; what obj_read reads back is the same bit for bit. Returns 0, or -1 and *err.
 */
int obj_write(FILE *out, const struct mesh *mesh, struct error *err) MUST_CHECK;

#endif
