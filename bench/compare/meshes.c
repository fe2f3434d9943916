/* The meshes that comparisons run on; see meshes.h. */
#include "bench/compare/meshes.h"

#include "reference/formats/mesh_file.h"
#include "reference/kernels/vertex_cache.h"
#include "reference/mesh/check.h"
#include "reference/mesh/generate.h"
#include "reference/mesh/subdivide.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { SCRAMBLE_SEED = 20260101, FLIP_SEED = 20260102 };

static const struct {
    const char *name;
    bool is_closed;
} kinds[MESH_KIND_COUNT + 1] = {[MESH_GRID] = {"grid", false},
                                [MESH_DISC] = {"disc", false},
                                [MESH_UV_SPHERE] = {"uv-sphere", true},
                                [MESH_TORUS] = {"torus", true},
                                [MESH_ICOSPHERE] = {"icosphere", true},
                                [MESH_BIPYRAMID] = {"bipyramid", true},
                                [MESH_BUNNY] = {"bunny", false},
                                [MESH_HORSE] = {"horse", true},
                                [MESH_MUG] = {"mug", true},
                                [MESH_FILE] = {"file", false}};

static const char *const orders[MESH_ORDER_COUNT] = {"generated", "scrambled", "cache", "flipped"};

const char *mesh_kind_name(enum mesh_kind kind)
{
    return kinds[kind].name;
}

const char *mesh_order_name(enum mesh_order order)
{
    return orders[order];
}

bool mesh_kind_is_closed(enum mesh_kind kind)
{
    return kinds[kind].is_closed;
}

void bench_mesh_name(const struct bench_mesh *which, char *name, int capacity)
{
    int64_t size = which->triangles;
    const char *unit = "";
    if (which->kind == MESH_FILE) {
        snprintf(name, (size_t)capacity, "%s", which->label);
        return;
    }
    if (size >= 1000000 && size % 1000000 == 0) {
        size /= 1000000;
        unit = "M";
    } else if (size >= 1000 && size % 1000 == 0) {
        size /= 1000;
        unit = "k";
    }
    snprintf(name, (size_t)capacity, "%s-%lld%s-%s", kinds[which->kind].name, (long long)size, unit,
             orders[which->order]);
}

/* Reads "-100k-" at *text and moves behind it; -1 when it is none. */
static int64_t take_size(const char **text)
{
    char *end;
    if (**text != '-' || (*text)[1] < '1' || (*text)[1] > '9')
        return -1;
    long long size = strtoll(*text + 1, &end, 10);
    long long factor = *end == 'k' ? 1000 : *end == 'M' ? 1000000 : 1;
    end += factor > 1;
    if (size > 200000000 / factor || *end != '-')
        return -1;
    *text = end + 1;
    return size * factor;
}

/* -- files ------------------------------------------------------------------------------------ */

static bool is_file_name(const char *name)
{
    static const char *const extensions[] = {".ply", ".obj", ".off"};
    const char *extension = strrchr(name, '.');
    for (size_t i = 0; extension && i < sizeof extensions / sizeof *extensions; i++)
        if (strcasecmp(extension, extensions[i]) == 0)
            return true;
    return false;
}

/* FNV-1a. */
static uint32_t hash_bytes(const void *bytes, size_t count, uint32_t hash)
{
    const unsigned char *at = bytes;
    for (size_t i = 0; i < count; i++)
        hash = (hash ^ at[i]) * 0x01000193U;
    return hash;
}

/* The file's name without its folder and extension, cut, and with '-' for what is no letter or digit; and a
 * hash of the tables. */
static void set_label(struct bench_mesh *which, const struct mesh *mesh)
{
    enum { STEM = 28 };
    const char *slash = strrchr(which->path, '/'), *stem = slash ? slash + 1 : which->path;
    size_t length = (size_t)(strrchr(stem, '.') - stem);
    uint32_t hash = hash_bytes(mesh->positions, 12 * (size_t)mesh->vertex_count, 0x811C9DC5U);
    hash = hash_bytes(mesh->triangles, 12 * (size_t)mesh->triangle_count, hash);
    snprintf(which->label, sizeof which->label, "%.*s-%08x", (int)(length < STEM ? length : STEM),
             stem, hash);
    for (char *c = which->label; *c; c++)
        if (!(*c >= '0' && *c <= '9') && !((*c | 0x20) >= 'a' && (*c | 0x20) <= 'z'))
            *c = '-';
}

static int find_file(const char *path, struct bench_mesh *which, struct error *err)
{
    struct mesh mesh;
    struct topology topology;
    *which = (struct bench_mesh){.kind = MESH_FILE, .order = MESH_GENERATED};
    if (snprintf(which->path, sizeof which->path, "%s", path) >= (int)sizeof which->path)
        return error_set(err, "%.100s: too long a path", path);
    if (mesh_file_read_told(path, &mesh, &which->reading, err))
        return -1;
    int result = mesh_topology(&mesh, &topology, err);
    if (result == 0 && mesh.triangle_count == 0)
        result = error_set(err, "%.100s has no triangle: there is nothing to measure", path);
    if (result == 0) {
        which->triangles = mesh.triangle_count;
        which->is_irregular = topology.incoherent.count + topology.nonmanifold_edge.count +
                                  topology.nonmanifold_vertex.count + topology.degenerate.count >
                              0;
        set_label(which, &mesh);
    }
    mesh_release(&mesh);
    return result;
}

static int make_file(const struct bench_mesh *which, struct mesh *mesh, struct error *err)
{
    struct reading ignored = {0}; /* find_file has told it */
    return mesh_file_read_told(which->path, mesh, &ignored, err);
}

int bench_mesh_find(const char *name, struct bench_mesh *which, struct error *err)
{
    if (is_file_name(name))
        return find_file(name, which, err);
    for (int kind = 0; kind < MESH_KIND_COUNT; kind++) {
        size_t length = strlen(kinds[kind].name);
        const char *rest = name + length;
        if (strncmp(name, kinds[kind].name, length) != 0)
            continue;
        int64_t size = take_size(&rest);
        for (int order = 0; size > 0 && order < MESH_ORDER_COUNT; order++)
            if (strcmp(rest, orders[order]) == 0) {
                *which = (struct bench_mesh){.kind = kind, .order = order, .triangles = size};
                return 0;
            }
    }
    return error_set(
        err,
        "there is no mesh \"%.60s\": write a file's name, which ends with .ply, .obj or .off, or "
        "KIND-SIZE-ORDER, as in torus-100k-scrambled; "
        "kinds: grid disc uv-sphere torus icosphere bipyramid bunny horse mug; orders: "
        "generated scrambled cache flipped",
        name);
}

static int make_icosphere(struct mesh *mesh, int64_t triangles, struct error *err)
{
    int level = (int)lround(log2((double)triangles / 20) / 2);
    return generate_icosphere(mesh, level < 0 ? 0 : level > 9 ? 9 : level, err);
}

static int make_model(struct mesh *mesh, const char *models, const char *name, int64_t triangles,
                      struct error *err)
{
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/%s.ply", models, name);
    if (mesh_file_read(path, mesh, err) != 0)
        return -1;
    if (subdivide_to(mesh, triangles, err) == 0)
        return 0;
    mesh_release(mesh);
    return -1;
}

static int make_kind(const struct bench_mesh *which, const char *models, struct mesh *mesh,
                     struct error *err)
{
    int64_t half = which->triangles / 2, side = llround(sqrt((double)half));
    if (side < 3)
        side = 3;
    switch (which->kind) {
    case MESH_GRID:
        return generate_grid(mesh, side, side, err);
    case MESH_DISC:
        return generate_disc(mesh, side, side, err);
    case MESH_UV_SPHERE:
        return generate_uv_sphere(mesh, side, side, err);
    case MESH_TORUS:
        return generate_torus(mesh, 1, which->triangles, err);
    case MESH_ICOSPHERE:
        return make_icosphere(mesh, which->triangles, err);
    case MESH_BIPYRAMID:
        return generate_bipyramid(mesh, half < 3 ? 3 : half, err);
    case MESH_BUNNY:
    case MESH_HORSE:
    case MESH_MUG:
        return make_model(mesh, models, kinds[which->kind].name, which->triangles, err);
    case MESH_FILE:
        return make_file(which, mesh, err);
    }
    return error_set(err, "there is no such kind of mesh");
}

int bench_mesh_make(const struct bench_mesh *which, const char *models, struct mesh *mesh,
                    struct error *err)
{
    if (make_kind(which, models, mesh, err) != 0)
        return -1;
    int result = 0;
    if (which->order == MESH_SCRAMBLED)
        result = change_scramble(mesh, SCRAMBLE_SEED, err);
    else if (which->order == MESH_CACHE)
        result = vertex_cache_order(mesh, err);
    else if (which->order == MESH_FLIPPED)
        result = change_flip(mesh, 0.5, FLIP_SEED, err);
    if (result != 0)
        mesh_release(mesh);
    return result;
}
