/* Meshes by their recipes; see recipe.h. */
#include "graders/library/recipe.h"

#include "reference/base/random.h"
#include "reference/formats/mesh_file.h"
#include "reference/mesh/edges.h"
#include "reference/mesh/generate.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { HIGH_UNUSED = 66000, VAST_UNUSED = (1 << 21) + 1000, PATH_BYTES = 1024 };

/* ------------------------------------------------------------------ shapes that are only cases */

/* Tetrahedra (0, 1, p, q) around the edge {0,1}: every edge has an even number of triangles, and
 * {0,1} has two of each tetrahedron. */
static int make_round_an_edge(struct mesh *mesh, int64_t count, struct error *err)
{
    if (mesh_init(mesh, 2 + 2 * count, 4 * count, err))
        return -1;
    mesh->positions[2] = -0.5F;
    mesh->positions[5] = 0.5F;
    for (int64_t i = 0; i < count; i++) {
        int32_t p = (int32_t)(2 + 2 * i), q = p + 1;
        int32_t faces[12] = {1, 0, p, 0, 1, q, p, 0, q, q, 1, p};
        memcpy(mesh->triangles + 12 * i, faces, sizeof faces);
        for (int side = 0; side < 2; side++) {
            double angle = 2 * M_PI * ((double)i + 0.6 * side) / (double)count;
            float *position = mesh->positions + 3 * (int64_t)(p + side);
            position[0] = (float)(0.5 * cos(angle));
            position[1] = (float)(0.5 * sin(angle));
        }
    }
    return 0;
}

/* Vertices along a helix; with triangles, one (v,v,v) each. */
static int make_points(struct mesh *mesh, int64_t count, bool with_triangles, struct error *err)
{
    if (mesh_init(mesh, count, with_triangles ? count : 0, err))
        return -1;
    for (int64_t v = 0; v < count; v++) {
        mesh->positions[3 * v] = (float)(0.5 * cos((double)v));
        mesh->positions[3 * v + 1] = (float)(0.5 * sin((double)v));
        mesh->positions[3 * v + 2] = (float)((double)v / (double)count - 0.5);
        for (int corner = 0; with_triangles && corner < 3; corner++)
            mesh->triangles[3 * v + corner] = (int32_t)v;
    }
    return 0;
}

static int read_model(const char *models, const char *name, struct mesh *mesh, struct error *err)
{
    char path[PATH_BYTES];
    int length = snprintf(path, sizeof path, "%s/%s", models, name);
    if (length < 0 || length >= (int)sizeof path)
        return error_set(err, "the path of the models is too long: %s", models);
    return mesh_file_read(path, mesh, err);
}

/* A ring of quads between two circles, cut into triangles. */
static int make_annulus(struct mesh *mesh, int64_t sectors, struct error *err)
{
    if (sectors < 3 || mesh_init(mesh, 2 * sectors, 2 * sectors, err))
        return error_set(err, "an annulus has 3 sectors or more");
    for (int64_t i = 0; i < sectors; i++) {
        double angle = 2 * M_PI * (double)i / (double)sectors;
        for (int64_t ring = 0; ring < 2; ring++) {
            float *position = mesh->positions + 3 * (2 * i + ring);
            position[0] = (float)((ring ? 0.5 : 0.25) * cos(angle));
            position[1] = (float)((ring ? 0.5 : 0.25) * sin(angle));
        }
        int32_t in = (int32_t)(2 * i), next = (int32_t)(2 * ((i + 1) % sectors));
        const int32_t faces[6] = {in, in + 1, next + 1, in, next + 1, next};
        memcpy(mesh->triangles + 6 * i, faces, sizeof faces);
    }
    return 0;
}

/* Fans of two triangles round vertex 0, with gaps between them. */
static int make_bow_tie(struct mesh *mesh, int64_t fans, struct error *err)
{
    if (mesh_init(mesh, 1 + 3 * fans, 2 * fans, err))
        return -1;
    for (int64_t i = 0; i < fans; i++) {
        int32_t first = (int32_t)(1 + 3 * i);
        for (int32_t k = 0; k < 3; k++) {
            double angle = 2 * M_PI * ((double)i + 0.2 * k) / (double)fans;
            float *position = mesh->positions + 3 * (int64_t)(first + k);
            position[0] = (float)(0.5 * cos(angle));
            position[1] = (float)(0.5 * sin(angle));
        }
        const int32_t faces[6] = {0, first, first + 1, 0, first + 1, first + 2};
        memcpy(mesh->triangles + 6 * i, faces, sizeof faces);
    }
    return 0;
}

/* Triangles in rows, no two of which touch. */
static int make_separate(struct mesh *mesh, int64_t count, struct error *err)
{
    int64_t side = (int64_t)ceil(sqrt((double)count)) + 1;
    if (mesh_init(mesh, 3 * count, count, err))
        return -1;
    for (int64_t t = 0; t < count; t++) {
        int64_t column = t % side, row = t / side;
        for (int64_t corner = 0; corner < 3; corner++) {
            float *position = mesh->positions + 3 * (3 * t + corner);
            double x = (double)column + (corner == 1 ? 0.8 : 0);
            double y = (double)row + (corner == 2 ? 0.8 : 0);
            position[0] = (float)(x / (double)side - 0.5);
            position[1] = (float)(y / (double)side - 0.5);
            mesh->triangles[3 * t + corner] = (int32_t)(3 * t + corner);
        }
    }
    return 0;
}

static int make_surface(const struct mesh_recipe *r, struct mesh *mesh, struct error *err)
{
    switch (r->shape) {
    case SHAPE_GRID:
        return generate_grid(mesh, r->rows, r->columns, err);
    case SHAPE_UV_SPHERE:
        return generate_uv_sphere(mesh, r->meridians, r->parallels, err);
    case SHAPE_ICO:
        return generate_icosphere(mesh, r->levels, err);
    case SHAPE_TORUS:
        return generate_torus(mesh, r->genus, r->triangles, err);
    case SHAPE_DISC:
        return generate_disc(mesh, r->rings, r->sectors, err);
    case SHAPE_ANNULUS:
        return make_annulus(mesh, r->sectors, err);
    case SHAPE_FAN:
        return generate_fan(mesh, r->count, err);
    case SHAPE_BIPYRAMID:
        return generate_bipyramid(mesh, r->count, err);
    case SHAPE_MOEBIUS:
        return generate_moebius(mesh, r->count, err);
    default:
        return error_set(err, "no triangle mesh has shape number %d of recipe.h", (int)r->shape);
    }
}

static int make_shape(const struct mesh_recipe *r, uint64_t seed, const char *models,
                      struct mesh *mesh, struct error *err)
{
    switch (r->shape) {
    case SHAPE_EMPTY:
        return generate_empty(mesh, err);
    case SHAPE_ONE_TRIANGLE:
        return generate_one_triangle(mesh, err);
    case SHAPE_TETRAHEDRON:
        return generate_tetrahedron(mesh, err);
    case SHAPE_CUBE:
        return generate_cube(mesh, err);
    case SHAPE_TWO_CONES:
        return generate_two_cones(mesh, r->count, err);
    case SHAPE_TWO_CUBES:
        return generate_two_cubes(mesh, err);
    case SHAPE_BOOK:
        return generate_book(mesh, r->count, err);
    case SHAPE_ROUND_AN_EDGE:
        return make_round_an_edge(mesh, r->count, err);
    case SHAPE_BOW_TIE:
        return make_bow_tie(mesh, r->count, err);
    case SHAPE_SEPARATE:
        return make_separate(mesh, r->count, err);
    case SHAPE_NEEDLES:
        return generate_needles(mesh, r->count, pow(10, -(double)r->exponent), seed, err);
    case SHAPE_ISOLATED:
        return make_points(mesh, r->count, false, err);
    case SHAPE_POINT_TRIANGLES:
        return make_points(mesh, r->count, true, err);
    case SHAPE_BUNNY:
        return read_model(models, "bunny.ply", mesh, err);
    case SHAPE_HORSE:
        return read_model(models, "horse.ply", mesh, err);
    case SHAPE_MUG:
        return read_model(models, "mug.ply", mesh, err);
    default:
        return make_surface(r, mesh, err);
    }
}

/* ------------------------------------------------------------------------------------- changes */

static int64_t part(int64_t count, int64_t divisor)
{
    return count / divisor > 0 ? count / divisor : 1;
}

/* A tetrahedron, a cube and an icosphere in a row beside the mesh. */
static int append_components(struct mesh *mesh, struct error *err)
{
    for (int i = 0; i < 3; i++) {
        struct mesh other;
        int failed = i == 0   ? generate_tetrahedron(&other, err)
                     : i == 1 ? generate_cube(&other, err)
                              : generate_icosphere(&other, 1, err);
        if (failed)
            return -1;
        failed = change_append(mesh, &other, 1.5F * (float)(i + 1), 0, 0, err);
        mesh_release(&other);
        if (failed)
            return -1;
    }
    return 0;
}

/* Replaces the mesh by one with more vertices, in front or behind, and more triangles at the end,
 * all of them zero. */
static int grow(struct mesh *mesh, int64_t vertices_before, int64_t vertices_after,
                int64_t triangles_after, struct error *err)
{
    struct mesh grown;
    if (mesh_init(&grown, vertices_before + mesh->vertex_count + vertices_after,
                  mesh->triangle_count + triangles_after, err))
        return -1;
    for (int64_t i = 0; i < 3 * (int64_t)mesh->vertex_count; i++)
        grown.positions[3 * vertices_before + i] = mesh->positions[i];
    for (int64_t i = 0; i < 3 * (int64_t)mesh->triangle_count; i++)
        grown.triangles[i] = mesh->triangles[i] + (int32_t)vertices_before;
    mesh_release(mesh);
    *mesh = grown;
    return 0;
}

/* Adds `count` degenerate triangles with a new vertex each: spikes (a,a,m), with m beside a, the
 * only triangle of that edge; or collinear ones (a,m,b), with m halfway from a to b. */
static int add_flat_triangles(struct mesh *mesh, int64_t count, bool collinear, struct error *err)
{
    int64_t vertex_count = mesh->vertex_count, triangle_count = mesh->triangle_count;
    if (grow(mesh, 0, count, count, err))
        return -1;
    for (int64_t i = 0; i < count; i++) {
        const int32_t *from = mesh->triangles + 3 * (i * triangle_count / count);
        int32_t a = from[0], b = collinear ? from[1] : a, m = (int32_t)(vertex_count + i);
        for (int axis = 0; axis < 3; axis++) {
            float pa = mesh->positions[3 * (int64_t)a + axis];
            float pb = mesh->positions[3 * (int64_t)b + axis];
            mesh->positions[3 * (int64_t)m + axis] = collinear ? 0.5F * (pa + pb) : 1.1F * pa;
        }
        int32_t *triangle = mesh->triangles + 3 * (triangle_count + i);
        triangle[i % 3] = m;
        triangle[(i + 1) % 3] = a;
        triangle[(i + 2) % 3] = b;
    }
    return 0;
}

/* Turns by 1 radian around (1,2,3): p' = p cos + (n x p) sin + n (n . p)(1 - cos), by Rodrigues. */
static void tilt(struct mesh *mesh)
{
    const double length = sqrt(14), n[3] = {1 / length, 2 / length, 3 / length};
    const double cosine = cos(1), sine = sin(1);
    for (int64_t v = 0; v < mesh->vertex_count; v++) {
        float *position = mesh->positions + 3 * v;
        double p[3] = {(double)position[0], (double)position[1], (double)position[2]};
        double along = (n[0] * p[0] + n[1] * p[1] + n[2] * p[2]) * (1 - cosine);
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3, k = (i + 2) % 3;
            double cross = n[j] * p[k] - n[k] * p[j];
            position[i] = (float)(p[i] * cosine + cross * sine + n[i] * along);
        }
    }
}

/* Marks the ends of every side that has no twin. */
static void mark_boundary(const struct edge_list *edges, uint8_t *taken)
{
    for (int64_t e = 0; e < edges->edge_count; e++)
        if (edge_use_count(&edges->edges[e]) == 1)
            taken[edges->edges[e].low] = taken[edges->edges[e].high] = 1;
}

/* Removes up to `count` triangles, no two of which share a vertex, none at the boundary: every hole
 * is a loop of its own, and all vertices stay manifold. */
static int cut_windows(struct mesh *mesh, int64_t count, uint64_t seed, struct error *err)
{
    struct edge_list edges;
    if (edge_list_init(&edges, mesh, err))
        return -1;
    uint8_t *taken = calloc((size_t)mesh->vertex_count + 1, 1);
    uint8_t *removed = calloc((size_t)mesh->triangle_count + 1, 1);
    int32_t *order = malloc(sizeof *order * ((size_t)mesh->triangle_count + 1));
    int failed = taken && removed && order ? 0 : error_set(err, "out of memory for windows");
    if (!failed) {
        struct random rng;
        random_init(&rng, seed ^ 0x57494E44U);
        mark_boundary(&edges, taken);
        random_permutation(&rng, order, mesh->triangle_count);
        for (int32_t i = 0; i < mesh->triangle_count && count > 0; i++) {
            const int32_t *v = mesh->triangles + 3 * (int64_t)order[i];
            if (taken[v[0]] || taken[v[1]] || taken[v[2]])
                continue;
            taken[v[0]] = taken[v[1]] = taken[v[2]] = removed[order[i]] = 1;
            count--;
        }
        int32_t kept = 0;
        for (int32_t t = 0; t < mesh->triangle_count; t++)
            if (!removed[t])
                memmove(mesh->triangles + 3 * (int64_t)kept++, mesh->triangles + 3 * (int64_t)t,
                        3 * sizeof(int32_t));
        mesh->triangle_count = kept;
    }
    free(taken);
    free(removed);
    free(order);
    edge_list_release(&edges);
    return failed;
}

static int change_elements(struct mesh *mesh, uint32_t changes, uint64_t seed, struct error *err)
{
    int64_t triangles = mesh->triangle_count, vertices = mesh->vertex_count;
    if ((changes & WITH_HOLES) && change_remove_triangles(mesh, part(triangles, 16), seed, err))
        return -1;
    if ((changes & WITH_WINDOWS) && cut_windows(mesh, part(triangles, 16), seed, err))
        return -1;
    if ((changes & WITH_COMPONENTS) && append_components(mesh, err))
        return -1;
    if ((changes & WITH_ISOLATED) &&
        change_add_isolated_vertices(mesh, part(vertices, 4), seed, err))
        return -1;
    if ((changes & WITH_DUPLICATES) &&
        change_add_duplicate_triangles(mesh, part(triangles, 8), seed, err))
        return -1;
    if ((changes & WITH_DEGENERATE) &&
        change_add_degenerate_triangles(mesh, part(triangles, 8), seed, err))
        return -1;
    if ((changes & WITH_COLLINEAR) && add_flat_triangles(mesh, part(triangles, 8), true, err))
        return -1;
    if ((changes & WITH_SPIKES) && add_flat_triangles(mesh, part(triangles, 8), false, err))
        return -1;
    return 0;
}

static void change_positions(struct mesh *mesh, uint32_t changes)
{
    if (changes & TILTED)
        tilt(mesh);
    if (changes & TINY)
        change_scale(mesh, 0x1p-40F);
    if (changes & HUGE_SIZE)
        change_scale(mesh, 0x1p40F);
    if (changes & FAR) {
        change_scale(mesh, 32);
        change_translate(mesh, 1e6F, -1e6F, 1e6F);
    }
}

int recipe_change_order(struct mesh *mesh, uint32_t changes, uint64_t seed, struct error *err)
{
    if ((changes & FLIPPED) && change_flip(mesh, 0.5, seed, err))
        return -1;
    if ((changes & REVERSED) && change_flip(mesh, 1, seed, err))
        return -1;
    if ((changes & SCRAMBLED) && change_scramble(mesh, seed, err))
        return -1;
    if ((changes & ADVERSARIAL) && change_adversarial_numbering(mesh, seed, err))
        return -1;
    return 0;
}

int32_t recipe_unused_vertices(const struct mesh_recipe *recipe)
{
    return recipe->changes & VAST_NUMBERS   ? VAST_UNUSED
           : recipe->changes & HIGH_NUMBERS ? HIGH_UNUSED
                                            : 0;
}

int recipe_make(const struct mesh_recipe *recipe, uint64_t seed, const char *models,
                struct mesh *mesh, struct error *err)
{
    uint32_t changes = recipe->changes;
    if (make_shape(recipe, seed, models, mesh, err))
        return -1;
    int32_t unused = recipe_unused_vertices(recipe);
    if (change_elements(mesh, changes, seed, err) ||
        recipe_change_order(mesh, changes, seed, err) ||
        (unused > 0 && grow(mesh, unused, 0, 0, err))) {
        mesh_release(mesh);
        return -1;
    }
    change_positions(mesh, changes);
    return 0;
}
