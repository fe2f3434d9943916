/* The bytes of problems 4.1 to 4.3, by building; see claims.h. */
#include "bench/compare/claims_rows.h"

#include "reference/mesh/generate.h"
#include "reference/representation/representation.h"
#include "reference/representation/voxel_grid.h"

#include <malloc.h>
#include <math.h>

enum { SMALL_SPHERE = 16, GRID_SIDE = 128, CROSSING_FROM = 256, CROSSING_TO = 320 };

/* Bytes that the tables take of the heap: up to some bytes more than was asked for. */
static double mesh_heap_bytes(const struct mesh *mesh)
{
    return (double)(malloc_usable_size(mesh->positions) + malloc_usable_size(mesh->triangles));
}

static int voxel_sphere_bytes(int32_t k, double *bytes, struct error *err)
{
    struct voxel_grid grid;
    if (voxel_grid_sphere(&grid, k, err) != 0)
        return -1;
    *bytes = (double)malloc_usable_size(grid.bits);
    voxel_grid_release(&grid);
    return 0;
}

/* k meridians of k vertices each, and the poles. */
static int mesh_sphere_bytes(int32_t k, double *bytes, struct error *err)
{
    struct mesh mesh;
    if (generate_uv_sphere(&mesh, k, k, err) != 0)
        return -1;
    *bytes = mesh_heap_bytes(&mesh);
    mesh_release(&mesh);
    return 0;
}

/* The first k for which the mesh is the smaller one; CROSSING_TO when there is none before. */
static int find_crossing(int32_t *k, struct error *err)
{
    for (*k = CROSSING_FROM; *k < CROSSING_TO; ++*k) {
        double voxels, mesh;
        if (voxel_sphere_bytes(*k, &voxels, err) != 0 || mesh_sphere_bytes(*k, &mesh, err) != 0)
            return -1;
        if (mesh < voxels)
            break;
    }
    return 0;
}

static int grid_bytes(double *indexed, double *strips, struct error *err)
{
    const struct representation *kind = representation_find("triangle-strips");
    struct mesh mesh;
    void *self;
    if (generate_grid(&mesh, GRID_SIDE, GRID_SIDE, err) != 0)
        return -1;
    *indexed = mesh_heap_bytes(&mesh);
    int result = representation_new(kind, &self, &mesh, err);
    if (result == 0) {
        *strips = (double)kind->bytes(self);
        representation_delete(kind, self);
    }
    mesh_release(&mesh);
    return result;
}

static int add_size(struct claims *claims, struct claim row, const char *mesh, struct error *err)
{
    row.holds = fabs(row.measured - row.claimed) <= 0.1 * row.claimed;
    return claims_add(claims, &row, mesh, err);
}

int claims_about_sizes(struct claims *claims, struct error *err)
{
    double voxels, sphere, indexed, strips;
    int32_t crossing;
    if (voxel_sphere_bytes(SMALL_SPHERE, &voxels, err) != 0 ||
        mesh_sphere_bytes(SMALL_SPHERE, &sphere, err) != 0 || find_crossing(&crossing, err) != 0 ||
        grid_bytes(&indexed, &strips, err) != 0)
        return -1;
    const struct {
        const char *mesh;
        struct claim row;
    } found[] = {{"sphere-k16",
                  {.name = "voxel-sphere-bytes",
                   .source = "000, 4.1",
                   .text = "voxels of a sphere, k = 16: 0.5 KB",
                   .claimed = 0.5,
                   .measured = voxels / 1024}},
                 {"sphere-k16",
                  {.name = "mesh-sphere-bytes",
                   .source = "000, 4.1",
                   .text = "indexed mesh of it, k = 16: 9 KB",
                   .claimed = 9.0,
                   .measured = sphere / 1024}},
                 {"sphere",
                  {.name = "mesh-beats-voxels-from",
                   .source = "000, 4.1",
                   .text = "the mesh is smaller than voxels from k on",
                   .claimed = 288.0,
                   .measured = crossing}},
                 {"grid-128x128",
                  {.name = "indexed-grid-bytes",
                   .source = "000, 4.2",
                   .text = "indexed grid, m = n = 128: 579.01 KB",
                   .claimed = 579.01,
                   .measured = indexed / 1024}},
                 {"grid-128x128",
                  {.name = "strips-grid-bytes",
                   .source = "000, 4.3",
                   .text = "the grid as 128 strips: 388.00 KB",
                   .claimed = 388.0,
                   .measured = strips / 1024}}};
    for (size_t i = 0; i < sizeof found / sizeof *found; i++)
        if (add_size(claims, found[i].row, found[i].mesh, err) != 0)
            return -1;
    return 0;
}
