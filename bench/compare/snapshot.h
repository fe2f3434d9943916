/* A mesh in a file as it lies in memory, with what is known of it: made once, read by every process
 * that is measured on it.
 *
 *     bytes  0  "MGMESH1\n"
 *            8  int64: triangles, vertices, edges, boundary edges, highest valence
 *           48  uint64: hash of all that follows and of the numbers above
 *           56  reserved, 0
 *           64  positions, 12 bytes a vertex; then triangles, 12 bytes each
 *
 * in the byte order of the machine: the file is a cache, not an exchange format. */
#ifndef BENCH_COMPARE_SNAPSHOT_H
#define BENCH_COMPARE_SNAPSHOT_H

#include "reference/base/error.h"
#include "reference/mesh/mesh.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct snapshot {
    struct mesh mesh; /* in memory of the snapshot's: not to be released on its own */
    int64_t edge_count, boundary_edge_count;
    int64_t highest_valence; /* of edges at a vertex */
    void *memory;
    size_t memory_bytes;
};

/* Writes the mesh (valid) and counts its edges for that. An existing file is replaced, when all is
 * written. Returns 0, or -1 and *err. Cost: a sort of the sides. */
int snapshot_write(const char *path, const struct mesh *mesh, struct error *err) MUST_CHECK;

/* Reads it into fresh memory, on huge pages where the kernel gives them, and checks all of it: a
 * damaged or cut file, or one with bad indices, is refused. The caller owns it (snapshot_release).
 * Returns 0, or -1 and *err; then it is empty. */
int snapshot_read(const char *path, struct snapshot *snapshot, struct error *err) MUST_CHECK;

/* Reads only the numbers: the mesh has its counts and no tables. Returns 0, or -1 and *err. */
int snapshot_read_counts(const char *path, struct snapshot *snapshot, struct error *err) MUST_CHECK;

void snapshot_release(struct snapshot *snapshot);

#ifdef __cplusplus
}
#endif

#endif
