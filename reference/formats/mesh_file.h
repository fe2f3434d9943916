/* Meshes in files: the format follows from the extension, in any case: .ply, .obj, .off. */
#ifndef REFERENCE_FORMATS_MESH_FILE_H
#define REFERENCE_FORMATS_MESH_FILE_H

#include "reference/formats/reading.h"
#include "reference/mesh/mesh.h"

#include <stdio.h>

/* Reads a mesh. The caller owns it (mesh_release); it is valid (mesh_check).
 *
 * path     a regular file, at most 8 GiB; anything else is refused without being read
 * returns  0, or -1 and *err, which names the file, the place in it and what is wrong; then the
 *          mesh is empty. What would have to be left out of the file is an error, too */
int mesh_file_read(const char *path, struct mesh *mesh, struct error *err) MUST_CHECK;

/* The same, leaving out what reading.h lists and telling it in *reading, which starts zeroed; NULL:
 * nothing may be left out. */
int mesh_file_read_told(const char *path, struct mesh *mesh, struct reading *reading,
                        struct error *err) MUST_CHECK;

/* The same from a stream, up to its end. The format follows from the first word: "ply"; OFF with its
 * prefixes, or a number; else it is OBJ. `name` names it in errors. */
int mesh_file_read_stream(FILE *in, const char *name, struct mesh *mesh, struct reading *reading,
                          struct error *err) MUST_CHECK;

/* Writes a valid mesh; .ply as little-endian binary. An existing file is replaced. Returns 0, or -1
 * and *err; then the file may be incomplete. */
int mesh_file_write(const char *path, const struct mesh *mesh, struct error *err) MUST_CHECK;

#endif
