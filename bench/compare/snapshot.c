/* A mesh in a file as it lies in memory; see snapshot.h. */
#include "bench/compare/snapshot.h"

#include "reference/mesh/edges.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

struct header {
    char magic[8];
    int64_t triangle_count, vertex_count, edge_count, boundary_edge_count, highest_valence;
    uint64_t hash;
    uint64_t reserved;
};
_Static_assert(sizeof(struct header) == 64, "the header has no padding");

static const char magic[8] = "MGMESH1\n";

/* Not against forgers, only against accidents. `bytes`: a multiple of 4. */
static uint64_t hash_words(uint64_t hash, const void *words, int64_t bytes)
{
    const char *at = words;
    for (int64_t i = 0; i + 4 <= bytes; i += 4) {
        uint32_t word;
        memcpy(&word, at + i, sizeof word);
        hash = (hash ^ word) * UINT64_C(0x9E3779B97F4A7C15);
        hash ^= hash >> 29;
    }
    return hash;
}

static uint64_t hash_of(const struct header *header, const float *positions,
                        const int32_t *triangles)
{
    uint64_t hash = hash_words(1, &header->triangle_count, 5 * (int64_t)sizeof(int64_t));
    hash = hash_words(hash, positions, 12 * header->vertex_count);
    return hash_words(hash, triangles, 12 * header->triangle_count);
}

/* ---- writing ---- */

static int count_edges(const struct mesh *mesh, struct header *header, struct error *err)
{
    struct edge_list list;
    int32_t *valence = calloc((size_t)mesh->vertex_count + 1, sizeof *valence);
    if (!valence)
        return error_set(err, "out of memory: valences");
    if (edge_list_init(&list, mesh, err) != 0) {
        free(valence);
        return -1;
    }
    header->edge_count = list.edge_count;
    for (int64_t i = 0; i < list.edge_count; i++) {
        header->boundary_edge_count += edge_use_count(&list.edges[i]) == 1;
        valence[list.edges[i].low]++;
        valence[list.edges[i].high]++;
    }
    for (int32_t v = 0; v < mesh->vertex_count; v++)
        if (valence[v] > header->highest_valence)
            header->highest_valence = valence[v];
    edge_list_release(&list);
    free(valence);
    return 0;
}

/* `count` rows of 12 bytes; rows may be NULL when there is none. */
static bool write_rows(FILE *file, const void *rows, int32_t count)
{
    return count == 0 || fwrite(rows, 12, (size_t)count, file) == (size_t)count;
}

static int write_to(FILE *file, const struct header *header, const struct mesh *mesh)
{
    return fwrite(header, sizeof *header, 1, file) == 1 &&
                   write_rows(file, mesh->positions, mesh->vertex_count) &&
                   write_rows(file, mesh->triangles, mesh->triangle_count)
               ? 0
               : -1;
}

int snapshot_write(const char *path, const struct mesh *mesh, struct error *err)
{
    char partial[PATH_MAX];
    struct header header = {.triangle_count = mesh->triangle_count,
                            .vertex_count = mesh->vertex_count};
    memcpy(header.magic, magic, sizeof magic);
    if (count_edges(mesh, &header, err) != 0)
        return -1;
    header.hash = hash_of(&header, mesh->positions, mesh->triangles);
    if (snprintf(partial, sizeof partial, "%s.%ld", path, (long)getpid()) >= (int)sizeof partial)
        return error_set(err, "%s: too long a name", path);
    FILE *file = fopen(partial, "we");
    if (!file)
        return error_set(err, "%s: %s", partial, strerror(errno));
    int result = write_to(file, &header, mesh);
    if (fclose(file) != 0 || result != 0 || rename(partial, path) != 0) {
        error_set(err, "%s: cannot be written: %s", path, strerror(errno));
        unlink(partial);
        return -1;
    }
    return 0;
}

/* ---- reading ---- */

static int read_whole(int file, void *to, int64_t bytes)
{
    char *at = to;
    while (bytes > 0) {
        ssize_t got = read(file, at, (size_t)(bytes < (1 << 30) ? bytes : 1 << 30));
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return -1;
        at += got;
        bytes -= got;
    }
    return 0;
}

/* Reads the header and holds it against the size of the file. */
static int read_header(int file, const char *path, struct header *header, struct error *err)
{
    struct stat status;
    if (fstat(file, &status) != 0 || !S_ISREG(status.st_mode) ||
        read_whole(file, header, sizeof *header) != 0 || memcmp(header->magic, magic, 8) != 0)
        return error_set(err, "%s: not a mesh snapshot", path);
    if (header->triangle_count < 0 || header->triangle_count > INT32_MAX / 3 ||
        header->vertex_count < 0 || header->vertex_count > INT32_MAX / 3 ||
        status.st_size !=
            (int64_t)sizeof *header + mesh_bytes(header->vertex_count, header->triangle_count))
        return error_set(err, "%s: a damaged mesh snapshot: %lld bytes do not fit its counts", path,
                         (long long)status.st_size);
    return 0;
}

static void describe(struct snapshot *snapshot, const struct header *header)
{
    *snapshot = (struct snapshot){.mesh = {.vertex_count = (int32_t)header->vertex_count,
                                           .triangle_count = (int32_t)header->triangle_count},
                                  .edge_count = header->edge_count,
                                  .boundary_edge_count = header->boundary_edge_count,
                                  .highest_valence = header->highest_valence};
}

static int read_tables(int file, const char *path, const struct header *header,
                       struct snapshot *snapshot, struct error *err)
{
    int64_t bytes = mesh_bytes(header->vertex_count, header->triangle_count);
    size_t position_bytes = 12 * (size_t)header->vertex_count;
    position_bytes = (position_bytes + 63) / 64 * 64; /* triangles start at a cache line */
    snapshot->memory_bytes = position_bytes + 12 * (size_t)header->triangle_count + 64;
    char *memory = mmap(NULL, snapshot->memory_bytes, PROT_READ | PROT_WRITE,
                        MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
        return error_set(err, "out of memory: a mesh of %lld bytes", (long long)bytes);
    madvise(memory, snapshot->memory_bytes, MADV_HUGEPAGE);
    snapshot->memory = memory;
    snapshot->mesh.positions = (float *)(void *)memory;
    snapshot->mesh.triangles = (int32_t *)(void *)(memory + position_bytes);
    if (read_whole(file, snapshot->mesh.positions, 12 * header->vertex_count) != 0 ||
        read_whole(file, snapshot->mesh.triangles, 12 * header->triangle_count) != 0 ||
        hash_of(header, snapshot->mesh.positions, snapshot->mesh.triangles) != header->hash)
        return error_set(err, "%s: a damaged mesh snapshot; remove it to have it made anew", path);
    return mesh_check(&snapshot->mesh, err);
}

static int read_snapshot(const char *path, struct snapshot *snapshot, bool tables,
                         struct error *err)
{
    struct header header = {.triangle_count = 0};
    *snapshot = (struct snapshot){0};
    int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0)
        return error_set(err, "%s: %s", path, strerror(errno));
    int result = read_header(file, path, &header, err);
    if (result == 0) {
        describe(snapshot, &header);
        if (tables)
            result = read_tables(file, path, &header, snapshot, err);
    }
    close(file);
    if (result != 0)
        snapshot_release(snapshot);
    return result;
}

int snapshot_read(const char *path, struct snapshot *snapshot, struct error *err)
{
    return read_snapshot(path, snapshot, true, err);
}

int snapshot_read_counts(const char *path, struct snapshot *snapshot, struct error *err)
{
    return read_snapshot(path, snapshot, false, err);
}

void snapshot_release(struct snapshot *snapshot)
{
    if (snapshot->memory)
        munmap(snapshot->memory, snapshot->memory_bytes);
    *snapshot = (struct snapshot){0};
}
