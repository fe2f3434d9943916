/* Meshes of polygons as inputs; see polygons.h. */
#include "graders/library/polygons.h"

#include "reference/base/random.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------------------------- making */

static int polygon_mesh_init(struct polygon_mesh *mesh, int64_t vertex_count, int64_t face_count,
                             int64_t corner_count, struct error *err)
{
    memset(mesh, 0, sizeof *mesh);
    if (vertex_count > INT32_MAX / 3 || corner_count > INT32_MAX / 3)
        return error_set(err, "a mesh of polygons is too large");
    mesh->positions = calloc(3 * (size_t)vertex_count + 1, sizeof *mesh->positions);
    mesh->first_corner = calloc((size_t)face_count + 1, sizeof *mesh->first_corner);
    mesh->corners = calloc((size_t)corner_count + 1, sizeof *mesh->corners);
    mesh->vertex_count = (int32_t)vertex_count;
    mesh->face_count = (int32_t)face_count;
    if (mesh->positions && mesh->first_corner && mesh->corners)
        return 0;
    polygon_mesh_release(mesh);
    return error_set(err, "out of memory for %lld faces", (long long)face_count);
}

void polygon_mesh_release(struct polygon_mesh *mesh)
{
    free(mesh->positions);
    free(mesh->first_corner);
    free(mesh->corners);
    memset(mesh, 0, sizeof *mesh);
}

static void set_position(struct polygon_mesh *mesh, int64_t vertex, double x, double y, double z)
{
    mesh->positions[3 * vertex] = (float)x;
    mesh->positions[3 * vertex + 1] = (float)y;
    mesh->positions[3 * vertex + 2] = (float)z;
}

/* All faces have `sides` corners: the offsets follow. */
static void set_even_offsets(struct polygon_mesh *mesh, int32_t sides)
{
    for (int32_t f = 0; f <= mesh->face_count; f++)
        mesh->first_corner[f] = sides * f;
}

static int from_triangles(const struct mesh *triangles, struct polygon_mesh *mesh,
                          struct error *err)
{
    int64_t vertices = triangles->vertex_count, faces = triangles->triangle_count;
    if (polygon_mesh_init(mesh, vertices, faces, 3 * faces, err))
        return -1;
    set_even_offsets(mesh, 3);
    if (vertices > 0)
        memcpy(mesh->positions, triangles->positions, 3 * sizeof(float) * (size_t)vertices);
    if (faces > 0)
        memcpy(mesh->corners, triangles->triangles, 3 * sizeof(int32_t) * (size_t)faces);
    return 0;
}

static int from_tables(const float *positions, int32_t vertex_count, const int32_t *first_corner,
                       const int32_t *corners, int32_t face_count, struct polygon_mesh *mesh,
                       struct error *err)
{
    int32_t corner_count = first_corner[face_count];
    if (polygon_mesh_init(mesh, vertex_count, face_count, corner_count, err))
        return -1;
    memcpy(mesh->positions, positions, 3 * sizeof *positions * (size_t)vertex_count);
    memcpy(mesh->first_corner, first_corner, sizeof *corners * ((size_t)face_count + 1));
    memcpy(mesh->corners, corners, sizeof *corners * (size_t)corner_count);
    return 0;
}

/* The prism that course document 001 works out, faces in the order of its face numbers. */
static int make_course_prism(struct polygon_mesh *mesh, struct error *err)
{
    static const float positions[18] = {0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1, 1, 1, 0, 1, 0, 0};
    static const int32_t corners[18] = {3, 2, 4, 1, 5, 4, 2, 0, 1, 2, 3, 0, 3, 4, 5, 1, 0, 5};
    static const int32_t first[6] = {0, 3, 7, 11, 15, 18};
    return from_tables(positions, 6, first, corners, 5, mesh, err);
}

static int make_quad_cube(struct polygon_mesh *mesh, struct error *err)
{
    static const int32_t corners[24] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4,
                                        2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    static const int32_t first[7] = {0, 4, 8, 12, 16, 20, 24};
    float positions[24];
    for (int v = 0; v < 8; v++)
        for (int axis = 0; axis < 3; axis++)
            positions[3 * v + axis] = (v >> axis & 1) ? 0.5F : -0.5F;
    return from_tables(positions, 8, first, corners, 6, mesh, err);
}

/* rows x columns quads; `wrapped` in both directions they are a torus. */
static int make_quads(int64_t rows, int64_t columns, bool wrapped, struct polygon_mesh *mesh,
                      struct error *err)
{
    int64_t high = wrapped ? rows : rows + 1, wide = wrapped ? columns : columns + 1;
    if (rows < (wrapped ? 3 : 1) || columns < (wrapped ? 3 : 1))
        return error_set(err, "%lld x %lld quads are too few", (long long)rows, (long long)columns);
    if (polygon_mesh_init(mesh, high * wide, rows * columns, 4 * rows * columns, err))
        return -1;
    set_even_offsets(mesh, 4);
    for (int64_t r = 0; r < high; r++)
        for (int64_t c = 0; c < wide; c++) {
            double u = 2 * M_PI * (double)c / (double)columns;
            double v = 2 * M_PI * (double)r / (double)rows;
            if (wrapped)
                set_position(mesh, r * wide + c, (0.35 + 0.15 * cos(v)) * cos(u),
                             (0.35 + 0.15 * cos(v)) * sin(u), 0.15 * sin(v));
            else
                set_position(mesh, r * wide + c, (double)c / (double)columns - 0.5,
                             (double)r / (double)rows - 0.5, 0);
        }
    for (int64_t f = 0; f < rows * columns; f++) {
        int64_t r = f / columns, c = f % columns;
        int64_t up = (r + 1) % high, right = (c + 1) % wide;
        const int64_t quad[4] = {r * wide + c, r * wide + right, up * wide + right, up * wide + c};
        for (int i = 0; i < 4; i++)
            mesh->corners[4 * f + i] = (int32_t)quad[i];
    }
    return 0;
}

/* Two faces of `sides` corners, and as many quads between them; `flat`: only one of the two. */
static int make_prism(int64_t sides, bool flat, struct polygon_mesh *mesh, struct error *err)
{
    int64_t faces = flat ? 1 : sides + 2, corners = flat ? sides : 6 * sides;
    if (sides < 3)
        return error_set(err, "a polygon has 3 corners or more, not %lld", (long long)sides);
    if (polygon_mesh_init(mesh, flat ? sides : 2 * sides, faces, corners, err))
        return -1;
    for (int64_t i = 0; i < mesh->vertex_count; i++) {
        double angle = 2 * M_PI * (double)(i % sides) / (double)sides;
        set_position(mesh, i, 0.5 * cos(angle), 0.5 * sin(angle), i < sides && !flat ? -0.4 : 0.4);
    }
    int32_t at = 0;
    for (int64_t i = 0; i < sides; i++)
        mesh->corners[at++] = (int32_t)(flat ? i : sides - 1 - i);
    mesh->first_corner[1] = at;
    if (flat)
        return 0;
    for (int64_t i = 0; i < sides; i++)
        mesh->corners[at++] = (int32_t)(sides + i);
    mesh->first_corner[2] = at;
    for (int64_t i = 0; i < sides; i++) {
        int64_t next = (i + 1) % sides;
        const int64_t quad[4] = {i, next, sides + next, sides + i};
        for (int k = 0; k < 4; k++)
            mesh->corners[at++] = (int32_t)quad[k];
        mesh->first_corner[3 + i] = at;
    }
    return 0;
}

/* ------------------------------------------------------------------------------------ changing */

static int append(struct polygon_mesh *mesh, const struct polygon_mesh *other, float dx,
                  struct error *err)
{
    struct polygon_mesh both;
    int32_t corners = mesh->first_corner[mesh->face_count];
    int32_t more = other->first_corner[other->face_count];
    if (polygon_mesh_init(&both, (int64_t)mesh->vertex_count + other->vertex_count,
                          (int64_t)mesh->face_count + other->face_count, (int64_t)corners + more,
                          err))
        return -1;
    memcpy(both.positions, mesh->positions, 3 * sizeof(float) * (size_t)mesh->vertex_count);
    memcpy(both.corners, mesh->corners, sizeof(int32_t) * (size_t)corners);
    memcpy(both.first_corner, mesh->first_corner, sizeof(int32_t) * (size_t)mesh->face_count);
    for (int64_t i = 0; i < 3 * (int64_t)other->vertex_count; i++)
        both.positions[3 * (int64_t)mesh->vertex_count + i] =
            other->positions[i] + (i % 3 == 0 ? dx : 0);
    for (int32_t i = 0; i < more; i++)
        both.corners[corners + i] = other->corners[i] + mesh->vertex_count;
    for (int32_t f = 0; f <= other->face_count; f++)
        both.first_corner[mesh->face_count + f] = corners + other->first_corner[f];
    polygon_mesh_release(mesh);
    *mesh = both;
    return 0;
}

static int append_components(struct polygon_mesh *mesh, struct error *err)
{
    for (int i = 0; i < 3; i++) {
        struct polygon_mesh other;
        int failed = i == 0   ? make_course_prism(&other, err)
                     : i == 1 ? make_quad_cube(&other, err)
                              : make_prism(5, false, &other, err);
        if (failed || append(mesh, &other, 1.5F * (float)(i + 1), err))
            return -1;
        polygon_mesh_release(&other);
    }
    return 0;
}

/* Puts `before` and `after` unused vertices round the others. */
static int add_vertices(struct polygon_mesh *mesh, int64_t before, int64_t after, struct error *err)
{
    int32_t corners = mesh->first_corner[mesh->face_count];
    int64_t count = before + mesh->vertex_count + after;
    float *positions = calloc(3 * (size_t)count + 1, sizeof *positions);
    if (!positions)
        return error_set(err, "out of memory for %lld vertices", (long long)count);
    memcpy(positions + 3 * before, mesh->positions,
           3 * sizeof *positions * (size_t)mesh->vertex_count);
    free(mesh->positions);
    mesh->positions = positions;
    mesh->vertex_count = (int32_t)count;
    for (int32_t i = 0; i < corners; i++)
        mesh->corners[i] += (int32_t)before;
    return 0;
}

static void reverse_face(int32_t *corners, int32_t count)
{
    for (int32_t i = 0, j = count - 1; i < j; i++, j--) {
        int32_t kept = corners[i];
        corners[i] = corners[j];
        corners[j] = kept;
    }
}

static void flip_faces(struct polygon_mesh *mesh, double probability, struct random *rng)
{
    for (int32_t f = 0; f < mesh->face_count; f++)
        if (random_real(rng) < probability)
            reverse_face(mesh->corners + mesh->first_corner[f],
                         mesh->first_corner[f + 1] - mesh->first_corner[f]);
}

/* Renumbers the vertices, permutes the faces and rotates their corners. */
static int scramble(struct polygon_mesh *mesh, struct random *rng, struct error *err)
{
    struct polygon_mesh old = *mesh;
    int32_t corner_count = old.first_corner[old.face_count], at = 0;
    int32_t *number = malloc(sizeof *number * ((size_t)old.vertex_count + 1));
    int32_t *order = malloc(sizeof *order * ((size_t)old.face_count + 1));
    if (!number || !order ||
        polygon_mesh_init(mesh, old.vertex_count, old.face_count, corner_count, err)) {
        *mesh = old;
        free(number);
        free(order);
        return error_set(err, "out of memory for %d faces", old.face_count);
    }
    random_permutation(rng, number, old.vertex_count);
    random_permutation(rng, order, old.face_count);
    for (int32_t v = 0; v < old.vertex_count; v++)
        memcpy(mesh->positions + 3 * (int64_t)number[v], old.positions + 3 * (int64_t)v,
               3 * sizeof(float));
    for (int32_t f = 0; f < old.face_count; f++) {
        int32_t first = old.first_corner[order[f]];
        int32_t count = old.first_corner[order[f] + 1] - first;
        int32_t turn = (int32_t)random_below(rng, (uint64_t)count);
        for (int32_t i = 0; i < count; i++)
            mesh->corners[at++] = number[old.corners[first + (i + turn) % count]];
        mesh->first_corner[f + 1] = at;
    }
    polygon_mesh_release(&old);
    free(number);
    free(order);
    return 0;
}

static int change(struct polygon_mesh *mesh, uint32_t changes, uint64_t seed, struct error *err)
{
    struct random rng;
    random_init(&rng, seed);
    if ((changes & WITH_COMPONENTS) && append_components(mesh, err))
        return -1;
    if ((changes & WITH_ISOLATED) && add_vertices(mesh, 0, mesh->vertex_count / 4 + 1, err))
        return -1;
    if (changes & (FLIPPED | REVERSED))
        flip_faces(mesh, changes & REVERSED ? 1 : 0.5, &rng);
    return changes & (SCRAMBLED | ADVERSARIAL) ? scramble(mesh, &rng, err) : 0;
}

/* -------------------------------------------------------------------------------- by recipes */

static int make_shape(const struct mesh_recipe *recipe, uint64_t seed, const char *models,
                      struct polygon_mesh *mesh, uint32_t *left, struct error *err)
{
    const uint32_t own = WITH_COMPONENTS | WITH_ISOLATED | FLIPPED | REVERSED | SCRAMBLED;
    *left = recipe->changes & own;
    switch (recipe->shape) {
    case SHAPE_QUAD_CUBE:
        return make_quad_cube(mesh, err);
    case SHAPE_QUAD_GRID:
        return make_quads(recipe->rows, recipe->columns, false, mesh, err);
    case SHAPE_QUAD_TORUS:
        return make_quads(recipe->rows, recipe->columns, true, mesh, err);
    case SHAPE_PRISM:
        return make_prism(recipe->count, false, mesh, err);
    case SHAPE_POLYGON:
        return make_prism(recipe->count, true, mesh, err);
    case SHAPE_COURSE_PRISM:
        return make_course_prism(mesh, err);
    default:
        break;
    }
    struct mesh triangles;
    struct mesh_recipe shape = *recipe;
    shape.changes &= ~(own | HIGH_NUMBERS | VAST_NUMBERS);
    if (recipe_make(&shape, seed, models, &triangles, err))
        return -1;
    int failed = from_triangles(&triangles, mesh, err);
    mesh_release(&triangles);
    return failed;
}

int polygon_mesh_make(const struct mesh_recipe *recipe, uint64_t seed, const char *models,
                      struct polygon_mesh *mesh, struct error *err)
{
    uint32_t left;
    if (make_shape(recipe, seed, models, mesh, &left, err))
        return -1;
    int32_t unused = recipe_unused_vertices(recipe);
    if (change(mesh, left, seed, err) == 0 && add_vertices(mesh, unused, 0, err) == 0)
        return 0;
    polygon_mesh_release(mesh);
    return -1;
}

int polygon_mesh_make_sized(const struct size_family *family, int64_t corner_count, uint64_t seed,
                            struct polygon_mesh *mesh, struct error *err)
{
    enum { QUAD_COLUMNS = 8 };
    if (family->shape == FAMILY_QUADS) {
        if (make_quads(corner_count / 4 / QUAD_COLUMNS, QUAD_COLUMNS, true, mesh, err))
            return -1;
        if (change(mesh, family->changes, seed, err) == 0)
            return 0;
        polygon_mesh_release(mesh);
        return -1;
    }
    struct mesh triangles;
    if (family_make(family, corner_count / 3, seed, &triangles, err))
        return -1;
    int failed = from_triangles(&triangles, mesh, err);
    mesh_release(&triangles);
    return failed;
}

/* ------------------------------------------------------------------------------------- packets */

int polygon_mesh_write(const struct polygon_mesh *mesh, struct writer *input, struct error *err)
{
    write_int(input, mesh->vertex_count);
    write_int(input, mesh->face_count);
    write_array(input, mesh->first_corner, (int64_t)mesh->face_count + 1, sizeof(int32_t));
    write_array(input, mesh->corners, mesh->first_corner[mesh->face_count], sizeof(int32_t));
    write_array(input, mesh->positions, mesh->vertex_count, 3 * sizeof(float));
    if (input->failed)
        return error_set(err, "out of memory: writing %d faces", mesh->face_count);
    return 0;
}

struct polygon_view polygon_view_read(struct reader *input)
{
    struct polygon_view view = {0};
    view.vertex_count = (int32_t)read_int(input);
    view.face_count = (int32_t)read_int(input);
    view.first_corner = read_array(input, (int64_t)view.face_count + 1, sizeof(int32_t));
    view.corners = read_array(input, view.first_corner ? view.first_corner[view.face_count] : 0,
                              sizeof(int32_t));
    view.positions = read_array(input, view.vertex_count, 3 * sizeof(float));
    return view;
}

int polygon_view_show(const struct polygon_view *view, struct scene *scene, struct error *err)
{
    return scene_set_polygons(scene, view->positions, view->vertex_count, view->first_corner,
                              view->corners, view->face_count, err);
}
