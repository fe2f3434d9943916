/* Bytes of a sphere as voxels, as an octree and as a mesh (problem 4.1). Computed here, not from
 * the run. */
#include "graders/report/bench/figures.h"

#include "reference/mesh/generate.h"
#include "reference/representation/octree.h"

#include <math.h>

enum { K_LEAST = 8, K_MOST = 1024, K_BUILT_MOST = 512 };

static double voxel_bytes(int64_t k)
{
    int64_t whole_bytes = (k * k * k + 7) / 8;
    return (double)whole_bytes;
}

/* k meridians and k parallels as k x k vertices, 2 k (k - 1) triangles: about 36 k^2. */
static double grid_sphere_bytes(int64_t k)
{
    return (double)mesh_bytes(k * k, 2 * k * (k - 1));
}

/* Bytes of a sphere that is really made, with shared poles; NaN when out of memory. */
static double built_bytes(int64_t k)
{
    struct mesh mesh = {0};
    struct error ignored = {""};
    double bytes = (double)NAN;
    if (generate_uv_sphere(&mesh, k, k - 2, &ignored) == 0)
        bytes = (double)mesh_bytes(mesh.vertex_count, mesh.triangle_count);
    mesh_release(&mesh);
    return bytes;
}

/* Bytes of the octree with 2^levels cells a side; NaN when out of memory. */
static double tree_bytes(int levels)
{
    struct octree tree = {0};
    struct error ignored = {""};
    double bytes = (double)NAN;
    if (octree_sphere(&tree, levels, &ignored) == 0)
        bytes = (double)octree_bytes(&tree);
    octree_release(&tree);
    return bytes;
}

/* The first k for which the mesh takes less. */
static int64_t crossing(void)
{
    int64_t k = K_LEAST;
    while (k < K_MOST && grid_sphere_bytes(k) >= voxel_bytes(k))
        k++;
    return k;
}

static json_t *scene(const struct study *study)
{
    (void)study;
    char label[32];
    json_t *panel = figure_panel("", "k, cells or meridians a side", "bytes");
    json_t *voxels = figure_series("voxels, k³/8", LOOK_BLUE, false);
    json_t *mesh = figure_series("mesh, 36k² − 24k", LOOK_ORANGE, false);
    json_t *built = figure_series("mesh as made", LOOK_GREEN, true);
    json_t *octree = figure_series("octree as made", LOOK_PURPLE, false);
    int levels = 3; /* K_LEAST = 2^3 */
    for (int64_t k = K_LEAST; k <= K_MOST; k *= 2) {
        figure_point(octree, (double)k, tree_bytes(levels++));
        figure_point(voxels, (double)k, voxel_bytes(k));
        figure_point(mesh, (double)k, grid_sphere_bytes(k));
        if (k <= K_BUILT_MOST)
            figure_point(built, (double)k, built_bytes(k));
    }
    snprintf(label, sizeof label, "k = %lld", (long long)crossing());
    json_array_append_new(json_object_get(panel, "guides"),
                          figure_guide("x", (double)crossing(), label));
    json_t *series = json_object_get(panel, "series");
    json_array_append_new(series, voxels);
    json_array_append_new(series, mesh);
    json_array_append_new(series, built);
    json_array_append_new(series, octree);
    return json_pack("{s:s, s:s, s:s, s:i, s:[o]}", "kind", "panels", "title",
                     "A sphere as voxels, as an octree and as a mesh", "subtitle",
                     "problem 4.1: one bit a voxel; 12 bytes a vertex and a triangle", "columns", 1,
                     "panels", panel);
}

static void finding(const struct study *study, FILE *to)
{
    (void)study;
    fprintf(to,
            "Voxels take less up to k = %lld, the mesh from k = %lld on. At k = 16 the voxels take "
            "%.1f KB and the mesh %.1f KB; at k = 1024 they take %.0f MB and %.0f MB.",
            (long long)crossing() - 1, (long long)crossing(), voxel_bytes(16) / 1024,
            grid_sphere_bytes(16) / 1024, voxel_bytes(1024) / 1048576,
            grid_sphere_bytes(1024) / 1048576);
}

const struct figure figure_voxels = {.name = "voxels",
                                     .label = "Bytes of a sphere as voxels, octree and mesh",
                                     .width = 1200,
                                     .height = 780,
                                     .scene = scene,
                                     .finding = finding,
                                     .absent = "memory ran out"};
