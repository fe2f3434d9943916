/* Calls the functions of memory-voxels-vs-mesh. Both builders are called from run_call itself,
 * because that is whose calls are counted. */
#include "memory-voxels-vs-mesh.h"

#include "graders/runner/questions.h"
#include "graders/runner/shapes.h"

#include <string.h>

static const struct asked asked[] = {
    ASKED_FORMULA_OF_ONE(voxel_sphere_bytes), ASKED_FORMULA_OF_ONE(mesh_sphere_bytes),
    ASKED_NUMBER(voxel_sphere_kilobytes),     ASKED_NUMBER(mesh_sphere_kilobytes),
    ASKED_NUMBER(voxel_sphere_megabytes),     ASKED_NUMBER(mesh_sphere_megabytes),
    ASKED_COUNT(smallest_k_for_mesh),         ASKED_END};

void run_call(struct reader *input, struct writer *answer)
{
    const char *builder = ask(asked, input, answer);
    if (!builder)
        return;
    bool of_voxels = strcmp(builder, "voxel_sphere_build") == 0;
    int32_t k = (int32_t)read_int(input);
    struct voxel_sphere voxels = {0};
    struct mesh_sphere mesh = {0};
    measure_begin();
    int status = of_voxels ? voxel_sphere_build(k, &voxels) : mesh_sphere_build(k, &mesh);
    measure_end();
    look_at_result(&status, sizeof status);
    if (status == OUT_OF_MEMORY) {
        call_out_of_memory();
        return;
    }
    write_int(answer, status);
    if (status != 0)
        return;
    if (of_voxels) {
        answer_table(answer, voxels.byte_count, voxels.bits, 1);
    } else {
        answer_table(answer, mesh.vertex_count, mesh.vertices, 3 * sizeof *mesh.vertices);
        answer_table(answer, mesh.triangle_count, mesh.triangles, 3 * sizeof *mesh.triangles);
    }
    write_int(answer, of_voxels ? voxel_sphere_bytes(k) : mesh_sphere_bytes(k));
}
