/* A mesh in the formats that readers are compared on; see mesh_files.h. */
#include "bench/compare/mesh_files.h"

#include "bench/compare/snapshot.h"
#include "reference/formats/obj.h"
#include "reference/formats/off.h"
#include "reference/formats/ply.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

const struct mesh_file mesh_files[MESH_FILE_COUNT] = {{"read-ply-binary", ".ply"},
                                                      {"read-ply-ascii", ".ascii.ply"},
                                                      {"read-obj", ".obj"},
                                                      {"read-off", ".off"}};

int mesh_file_path(const char *snapshot_path, const char *extension, char *path, int capacity)
{
    size_t length = strlen(snapshot_path);
    if (length > 5 && strcmp(snapshot_path + length - 5, ".mesh") == 0)
        length -= 5;
    return snprintf(path, (size_t)capacity, "%.*s%s", (int)length, snapshot_path, extension) <
                   capacity
               ? 0
               : -1;
}

static int write_as(const char *extension, FILE *file, const struct mesh *mesh, struct error *err)
{
    if (strcmp(extension, ".ply") == 0)
        return ply_write(file, mesh, PLY_LITTLE_ENDIAN, err);
    if (strcmp(extension, ".ascii.ply") == 0)
        return ply_write(file, mesh, PLY_ASCII, err);
    if (strcmp(extension, ".obj") == 0)
        return obj_write(file, mesh, err);
    return off_write(file, mesh, err);
}

static int write_file(const char *path, const char *extension, const struct mesh *mesh,
                      struct error *err)
{
    char partial[PATH_MAX];
    if (snprintf(partial, sizeof partial, "%s.partial", path) >= (int)sizeof partial)
        return error_set(err, "%s: too long a name", path);
    FILE *file = fopen(partial, "we");
    if (!file)
        return error_set(err, "%s: %s", partial, strerror(errno));
    int result = write_as(extension, file, mesh, err);
    if (fclose(file) == 0 && result == 0 && rename(partial, path) == 0)
        return 0;
    unlink(partial);
    return error_set(err, "%s cannot be written: %s", path, strerror(errno));
}

int mesh_files_write(const char *snapshot_path, struct error *err)
{
    struct snapshot snapshot = {.memory = NULL};
    char path[PATH_MAX];
    int result = 0;
    for (int i = 0; i < MESH_FILE_COUNT && result == 0; i++) {
        if (mesh_file_path(snapshot_path, mesh_files[i].extension, path, sizeof path) != 0)
            result = error_set(err, "%s: too long a name", snapshot_path);
        if (result != 0 || access(path, R_OK) == 0)
            continue;
        if (!snapshot.memory)
            result = snapshot_read(snapshot_path, &snapshot, err);
        if (result == 0)
            result = write_file(path, mesh_files[i].extension, &snapshot.mesh, err);
    }
    snapshot_release(&snapshot);
    return result;
}
