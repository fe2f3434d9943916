/* Our readers of mesh files, to be measured; see subjects.h. A call reads the whole file, from the
 * system's cache, into a mesh that is checked. */
#include "bench/compare/answers.h"
#include "bench/compare/mesh_files.h"
#include "bench/compare/subject.h"

#include "reference/formats/mesh_file.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

struct timed_reading {
    char path[PATH_MAX];
    struct mesh mesh;
};

static int run_reading(void *context, struct error *err)
{
    struct timed_reading *reading = context;
    return mesh_file_read(reading->path, &reading->mesh, err);
}

static void reset_reading(void *context)
{
    mesh_release(&((struct timed_reading *)context)->mesh);
}

static int answer_reading(void *context, struct worker_answer *answer, struct error *err)
{
    const struct timed_reading *reading = context;
    const struct mesh *mesh = &reading->mesh;
    struct stat status;
    float *corners = malloc(36 * (size_t)mesh->triangle_count + 1);
    if (!corners)
        return error_set(err, "out of memory: corners");
    for (int64_t i = 0; i < 3 * (int64_t)mesh->triangle_count; i++)
        memcpy(corners + 3 * i, mesh->positions + 3 * (int64_t)mesh->triangles[i], 12);
    answer_read_mesh(answer, corners, mesh->triangle_count);
    free(corners);
    if (stat(reading->path, &status) == 0)
        worker_fact(answer, "file_bytes", (double)status.st_size);
    return 0;
}

int subject_serve_reader(const char *snapshot_path, FILE *in, FILE *out, struct error *err)
{
    static struct timed_reading readings[MESH_FILE_COUNT];
    struct worker_operation operations[MESH_FILE_COUNT];
    for (int i = 0; i < MESH_FILE_COUNT; i++) {
        if (mesh_file_path(snapshot_path, mesh_files[i].extension, readings[i].path,
                           sizeof readings[i].path) != 0)
            return error_set(err, "%s: too long a name", snapshot_path);
        operations[i] = (struct worker_operation){.name = mesh_files[i].operation,
                                                  .context = &readings[i],
                                                  .run = run_reading,
                                                  .reset = reset_reading,
                                                  .answer = answer_reading};
    }
    struct worker_subject subject = {
        .operations = operations, .operation_count = MESH_FILE_COUNT, .thread_count = 1};
    return worker_serve(&subject, in, out, err);
}
