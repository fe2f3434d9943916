/* Closed surfaces of any genus: tori in a row, joined by necks. See generate.h.
 *
 * Each torus is a grid of `around` x `across` quads: column i goes the long way around the hole,
 * row j around the tube. A neck takes a patch of `patch` x `patch` quads out of the facing sides of
 * two tori and joins the two square loops by a ring of quads. Rows and columns are placed so that
 * column and row 0 ... patch are centred on the +x side; the -x side is its mirror image. */
#include "reference/mesh/generate.h"

#include "reference/mesh/builder.h"
#include "reference/mesh/circle.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

struct tori {
    int64_t count;
    int64_t around, across; /* quads; around is even */
    int64_t patch;          /* quads along the side of a removed square */
    int32_t *number;        /* [count * around * across]: vertex number, -1 inside a patch */
};

/* Whether columns `first` ... `last` lie within a patch, at least `margin` away from its sides. The
 * +x side of every torus but the last has one, and the -x side of every torus but the first. */
static bool columns_in_patch(const struct tori *t, int64_t torus, int64_t first, int64_t last,
                             int64_t margin)
{
    int64_t half = t->around / 2;
    return (torus + 1 < t->count && first >= margin && last + margin <= t->patch) ||
           (torus > 0 && first >= half + margin && last + margin <= half + t->patch);
}

/* Strictly inside a patch: the vertex goes. */
static bool vertex_is_removed(const struct tori *t, int64_t torus, int64_t i, int64_t j)
{
    return j >= 1 && j < t->patch && columns_in_patch(t, torus, i, i, 1);
}

/* The quad from (i, j) to (i + 1, j + 1) goes. */
static bool quad_is_removed(const struct tori *t, int64_t torus, int64_t i, int64_t j)
{
    return j < t->patch && columns_in_patch(t, torus, i, i + 1, 0);
}

static int32_t vertex_at(const struct tori *t, int64_t torus, int64_t i, int64_t j)
{
    return t->number[(torus * t->around + i % t->around) * t->across + j % t->across];
}

static void add_vertices(struct builder *b, const struct tori *t)
{
    const double major = 1.0, minor = 0.42, reach = major + minor;
    double scale = 0.5 / (reach * (double)t->count); /* the whole row is one unit long */
    for (int64_t torus = 0; torus < t->count; torus++) {
        double centre = reach * (double)(2 * torus + 1 - t->count);
        for (int64_t i = 0; i < t->around; i++)
            for (int64_t j = 0; j < t->across; j++) {
                int64_t slot = (torus * t->around + i) * t->across + j;
                t->number[slot] = -1;
                if (vertex_is_removed(t, torus, i, j))
                    continue;
                t->number[slot] = (int32_t)b->vertex_count;
                struct circle_point u = circle_point(2 * i - t->patch, 2 * t->around);
                struct circle_point v = circle_point(2 * j - t->patch, 2 * t->across);
                double radius = major + minor * v.cosine;
                add_vertex(b, scale * (centre + radius * u.cosine), scale * radius * u.sine,
                           scale * minor * v.sine);
            }
    }
}

static void add_quads(struct builder *b, const struct tori *t)
{
    for (int64_t torus = 0; torus < t->count; torus++)
        for (int64_t i = 0; i < t->around; i++)
            for (int64_t j = 0; j < t->across; j++)
                if (!quad_is_removed(t, torus, i, j))
                    add_quad(b, vertex_at(t, torus, i, j), vertex_at(t, torus, i + 1, j),
                             vertex_at(t, torus, i + 1, j + 1), vertex_at(t, torus, i, j + 1));
}

/* Corner `step` of the counter-clockwise walk around a square of the given side. */
static void walk_square(int64_t side, int64_t step, int64_t *i, int64_t *j)
{
    int64_t along = step % side;
    switch (step / side % 4) {
    case 0:
        *i = along, *j = 0;
        break;
    case 1:
        *i = side, *j = along;
        break;
    case 2:
        *i = side - along, *j = side;
        break;
    default:
        *i = 0, *j = side - along;
    }
}

static void add_neck(struct builder *b, const struct tori *t, int64_t torus)
{
    for (int64_t step = 0; step < 4 * t->patch; step++) {
        int64_t i, j, next_i, next_j, mirror = t->around / 2 + t->patch;
        walk_square(t->patch, step, &i, &j);
        walk_square(t->patch, step + 1, &next_i, &next_j);
        add_quad(b, vertex_at(t, torus, i, j), vertex_at(t, torus, next_i, next_j),
                 vertex_at(t, torus + 1, mirror - next_i, next_j),
                 vertex_at(t, torus + 1, mirror - i, j));
    }
}

static int64_t at_least(int64_t least, double value)
{
    return value > (double)least ? (int64_t)value : least;
}

int generate_torus(struct mesh *mesh, int genus, int64_t triangles, struct error *err)
{
    *mesh = (struct mesh){0};
    if (genus < 0 || genus > 1000000)
        return error_set(err, "generating a torus: the genus is %d and must be 0 to 1000000",
                         genus);
    if (triangles < 1 || triangles > INT32_MAX / 3)
        return error_set(err, "generating a torus: %lld triangles, it must be 1 to %d",
                         (long long)triangles, INT32_MAX / 3);
    if (genus == 0) {
        int64_t parallels = at_least(2, sqrt((double)triangles / 4.0));
        return generate_uv_sphere(mesh, 2 * parallels, parallels, err);
    }
    struct tori t = {.count = genus};
    t.across = at_least(3, sqrt((double)triangles / (4.0 * genus)) + 0.5);
    t.around = 2 * at_least(2, (double)triangles / (4.0 * genus * (double)t.across) + 0.5);
    t.patch = at_least(1, (double)t.across / 4.0);
    int64_t slots = t.count * t.around * t.across, necks = t.count - 1, side = t.patch;
    if (mesh_init(mesh, slots - 2 * necks * (side - 1) * (side - 1),
                  2 * slots - 4 * necks * side * side + 8 * necks * side, err))
        return -1;
    t.number = calloc((size_t)slots, sizeof *t.number);
    if (!t.number) {
        mesh_release(mesh);
        return error_set(err, "out of memory: a torus of %lld triangles", (long long)triangles);
    }
    struct builder b = {.mesh = mesh};
    add_vertices(&b, &t);
    add_quads(&b, &t);
    for (int64_t torus = 0; torus < necks; torus++)
        add_neck(&b, &t, torus);
    free(t.number);
    return 0;
}
