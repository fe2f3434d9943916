/* The same mesh in the formats that readers are compared on, beside its snapshot: x.mesh has x.ply,
 * x.ascii.ply, x.obj and x.off. */
#ifndef BENCH_COMPARE_MESH_FILES_H
#define BENCH_COMPARE_MESH_FILES_H

#include "reference/base/error.h"
#include "reference/mesh/mesh.h"

enum { MESH_FILE_COUNT = 4 };
struct mesh_file {
    const char *operation; /* "read-ply-binary" */
    const char *extension; /* ".ply" */
};
extern const struct mesh_file mesh_files[MESH_FILE_COUNT];

/* Path of the file beside a snapshot. Returns 0, or -1 when it does not fit. */
int mesh_file_path(const char *snapshot_path, const char *extension, char *path,
                   int capacity) MUST_CHECK;

/* Writes those that are not there. Returns 0, or -1 and *err. */
int mesh_files_write(const char *snapshot_path, struct error *err) MUST_CHECK;

#endif
