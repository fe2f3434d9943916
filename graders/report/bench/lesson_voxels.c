/* Picture: a sphere as voxels, as an octree and as a mesh, the solids cut open. */
#include "graders/report/bench/lesson.h"

#include "graders/scene/scene.h"
#include "reference/mesh/generate.h"
#include "reference/representation/octree.h"

enum { LEVELS = 5, K = 1 << LEVELS };

/* The quarter towards the eye is left out, so that the inside is seen. */
static bool is_cut_away(int32_t x, int32_t y)
{
    return x >= K / 2 && y < K / 2;
}

/* A cube of the tree: its lowest cell, its side and its node. */
struct cube {
    int32_t x, y, z, side, node;
};

static void add_leaves(json_t *boxes, const struct octree *tree, struct cube cube)
{
    if (cube.node == OCTREE_FULL && !is_cut_away(cube.x, cube.y))
        json_array_append_new(boxes, json_pack("[i, i, i, i]", (int)cube.x, (int)cube.y,
                                               (int)cube.z, (int)cube.side));
    if (cube.node < 0)
        return;
    int32_t half = cube.side / 2;
    for (int32_t i = 0; i < 8; i++)
        add_leaves(boxes, tree,
                   (struct cube){cube.x + half * (i & 1), cube.y + half * (i >> 1 & 1),
                                 cube.z + half * (i >> 2), half, tree->nodes[cube.node + i]});
}

static void cut_voxels(struct voxel_grid *grid)
{
    for (int32_t z = 0; z < K; z++)
        for (int32_t y = 0; y < K; y++)
            for (int32_t x = 0; x < K; x++)
                if (is_cut_away(x, y)) {
                    int64_t bit = x + (int64_t)K * (y + (int64_t)K * z);
                    grid->bits[bit / 8] &= (uint8_t) ~(1U << bit % 8);
                }
}

static json_t *captions(const struct octree *tree, const struct mesh *mesh)
{
    char voxels[80], octree[80], triangles[80], divided[80];
    snprintf(voxels, sizeof voxels, "one bit each: %.1f KB", (double)voxel_grid_bytes(K) / 1024);
    snprintf(divided, sizeof divided, "octree, %d cubes divided", tree->divided_count);
    snprintf(octree, sizeof octree, "%.1f KB", (double)octree_bytes(tree) / 1024);
    snprintf(triangles, sizeof triangles, "%d vertices, %d triangles: %.1f KB", mesh->vertex_count,
             mesh->triangle_count,
             (double)mesh_bytes(mesh->vertex_count, mesh->triangle_count) / 1024);
    return json_pack("[{s:s, s:s}, {s:s, s:s}, {s:s, s:s}]", "name", "32 × 32 × 32 voxels", "note",
                     voxels, "name", divided, "note", octree, "name", "indexed mesh", "note",
                     triangles);
}

struct sphere {
    struct voxel_grid grid;
    struct octree tree;
    struct mesh mesh;
};

static int make(struct sphere *sphere)
{
    struct error ignored = {""};
    return voxel_grid_sphere(&sphere->grid, K, &ignored) == 0 &&
                   octree_sphere(&sphere->tree, LEVELS, &ignored) == 0 &&
                   generate_uv_sphere(&sphere->mesh, K, K - 2, &ignored) == 0
               ? 0
               : -1;
}

static void release(struct sphere *sphere)
{
    voxel_grid_release(&sphere->grid);
    octree_release(&sphere->tree);
    mesh_release(&sphere->mesh);
}

static json_t *scene_of(struct sphere *sphere)
{
    struct scene scene = {0};
    struct error ignored = {""};
    json_t *json = NULL, *boxes = json_array();
    cut_voxels(&sphere->grid);
    add_leaves(boxes, &sphere->tree, (struct cube){0, 0, 0, K, sphere->tree.root});
    if (scene_set_voxels(&scene, sphere->grid.bits, K, &ignored) == 0 &&
        scene_set_mesh(&scene, sphere->mesh.positions, sphere->mesh.vertex_count,
                       sphere->mesh.triangles, sphere->mesh.triangle_count, &ignored) == 0)
        json = scene_to_json(&scene);
    scene_release(&scene);
    if (!json) {
        json_decref(boxes);
        return NULL;
    }
    json_object_set_new(json, "boxes", boxes);
    json_object_set_new(json, "captions", captions(&sphere->tree, &sphere->mesh));
    json_object_set_new(json, "title",
                        json_string("One sphere: as voxels, as an octree and as a mesh"));
    json_object_set_new(json, "subtitle",
                        json_string("the solids are cut open; the octree's cubes are coloured by "
                                    "their size; a mesh has no inside"));
    return json;
}

static json_t *scene(const struct study *study)
{
    struct sphere sphere = {0};
    (void)study;
    json_t *json = make(&sphere) == 0 ? scene_of(&sphere) : NULL;
    release(&sphere);
    return json;
}

static void finding(const struct study *study, FILE *to)
{
    struct sphere sphere = {0};
    (void)study;
    if (make(&sphere) == 0)
        fprintf(to,
                "Voxels, octree, mesh. At k = %d the sphere takes %.1f KB as voxels, %.1f KB as an "
                "octree and %.1f KB as a mesh. The octree divides only what the surface passes; "
                "voxels and octree know the inside, the mesh only the surface.",
                K, (double)voxel_grid_bytes(K) / 1024, (double)octree_bytes(&sphere.tree) / 1024,
                (double)mesh_bytes(sphere.mesh.vertex_count, sphere.mesh.triangle_count) / 1024);
    release(&sphere);
}

const struct figure lesson_voxels = {.name = "sphere",
                                     .label = "A sphere as voxels, as an octree and as a mesh",
                                     .width = 1440,
                                     .height = 760,
                                     .scene = scene,
                                     .finding = finding,
                                     .absent = "memory ran out"};
