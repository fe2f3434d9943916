/* Calls the functions of memory-voxels-vs-mesh. */
#include "memory-voxels-vs-mesh.h"
#include "graders/runner/call.h"
#include "graders/runner/memory/questions.h"

#include <stdlib.h>

static void ask_bytes(struct reader *input, struct writer *answer, int64_t (*bytes)(int32_t k))
{
    int64_t row_count = read_int(input);
    const int32_t *rows = read_array(input, row_count, 2 * sizeof *rows);
    measure_begin();
    for (int64_t i = 0; rows && i < row_count; i++)
        write_int(answer, bytes(rows[2 * i]));
    measure_end();
}

static void ask_number(double (*number)(void), struct writer *answer)
{
    measure_begin();
    double value = number();
    measure_end();
    write_real(answer, value);
}

static void ask_crossover(struct writer *answer)
{
    measure_begin();
    int32_t k = smallest_k_for_mesh();
    measure_end();
    write_real(answer, k);
}

static void build_voxels(int32_t k, struct writer *answer)
{
    struct voxel_sphere sphere = {0};
    measure_begin();
    int status = voxel_sphere_build(k, &sphere);
    measure_end();
    if (status == OUT_OF_MEMORY) {
        call_out_of_memory();
        return;
    }
    write_int(answer, status);
    if (status != 0)
        return;
    write_table(answer, sphere.bits, sphere.byte_count, 1);
    write_int(answer, voxel_sphere_bytes(k));
    free(sphere.bits);
}

static void build_mesh(int32_t k, struct writer *answer)
{
    struct mesh_sphere sphere = {0};
    measure_begin();
    int status = mesh_sphere_build(k, &sphere);
    measure_end();
    if (status == OUT_OF_MEMORY) {
        call_out_of_memory();
        return;
    }
    write_int(answer, status);
    if (status != 0)
        return;
    write_table(answer, sphere.vertices, sphere.vertex_count, 3 * sizeof *sphere.vertices);
    write_table(answer, sphere.triangles, sphere.triangle_count, 3 * sizeof *sphere.triangles);
    write_int(answer, mesh_sphere_bytes(k));
    free(sphere.vertices);
    free(sphere.triangles);
}

void run_call(struct reader *input, struct writer *answer)
{
    switch (read_int(input)) {
    case ASK_VOXEL_BYTES:
        ask_bytes(input, answer, voxel_sphere_bytes);
        break;
    case ASK_MESH_BYTES:
        ask_bytes(input, answer, mesh_sphere_bytes);
        break;
    case ASK_VOXEL_KILOBYTES:
        ask_number(voxel_sphere_kilobytes, answer);
        break;
    case ASK_MESH_KILOBYTES:
        ask_number(mesh_sphere_kilobytes, answer);
        break;
    case ASK_VOXEL_MEGABYTES:
        ask_number(voxel_sphere_megabytes, answer);
        break;
    case ASK_MESH_MEGABYTES:
        ask_number(mesh_sphere_megabytes, answer);
        break;
    case ASK_CROSSOVER:
        ask_crossover(answer);
        break;
    case ASK_VOXEL_BUILD:
        build_voxels((int32_t)read_int(input), answer);
        break;
    case ASK_MESH_BUILD:
        build_mesh((int32_t)read_int(input), answer);
        break;
    }
}
