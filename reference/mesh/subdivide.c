/* Flat and Loop subdivision over the edge list; see subdivide.h. */
#include "reference/mesh/subdivide.h"

#include "reference/mesh/edges.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PARTS_LIMIT = 30000 };

/* The edges of the mesh, and the number of the edge of each side 3 * triangle + corner. */
struct sides {
    struct edge_list list;
    int32_t *edge;
};

static void sides_release(struct sides *sides)
{
    edge_list_release(&sides->list);
    free(sides->edge);
}

static int sides_init(struct sides *sides, const struct mesh *mesh, struct error *err)
{
    *sides = (struct sides){0};
    for (int64_t t = 0; t < mesh->triangle_count; t++)
        if (triangle_is_degenerate(mesh->triangles + 3 * t))
            return error_set(err,
                             "triangle %lld is degenerate: remove it before the mesh is subdivided",
                             (long long)t);
    if (edge_list_init(&sides->list, mesh, err))
        return -1;
    sides->edge = malloc(3 * (size_t)mesh->triangle_count * sizeof *sides->edge + 1);
    if (!sides->edge) {
        sides_release(sides);
        return error_set(err, "out of memory: subdividing %d triangles", mesh->triangle_count);
    }
    for (int64_t e = 0; e < sides->list.edge_count; e++) {
        const struct edge *edge = &sides->list.edges[e];
        for (int64_t use = 0; use < edge_use_count(edge); use++)
            sides->edge[sides->list.uses[edge->first_use + use]] = (int32_t)e;
    }
    return 0;
}

/* -- flat ------------------------------------------------------------------------------------- */

/* Old vertices, then parts - 1 an edge, from its lower vertex to its higher, then those inside
 * triangles, row by row. Rows go from side 0 (p to q) towards corner r; row j has parts + 1 - j
 * vertices. */
struct flat {
    const struct mesh *from;
    const struct sides *sides;
    struct mesh to;
    int64_t parts, first_edge_vertex, first_inner_vertex;
};

static void place_on_edges(struct flat *f)
{
    float *to = f->to.positions + 3 * f->first_edge_vertex;
    for (int64_t e = 0; e < f->sides->list.edge_count; e++) {
        const float *p = f->from->positions + 3 * (int64_t)f->sides->list.edges[e].low;
        const float *q = f->from->positions + 3 * (int64_t)f->sides->list.edges[e].high;
        for (int64_t i = 1; i < f->parts; i++)
            for (int axis = 0; axis < 3; axis++)
                *to++ = (float)(((double)p[axis] * (double)(f->parts - i) +
                                 (double)q[axis] * (double)i) /
                                (double)f->parts);
    }
}

static void place_inside(struct flat *f)
{
    float *to = f->to.positions + 3 * f->first_inner_vertex;
    for (int64_t t = 0; t < f->from->triangle_count; t++) {
        const float *corner[3];
        for (int c = 0; c < 3; c++)
            corner[c] = f->from->positions + 3 * (int64_t)f->from->triangles[3 * t + c];
        for (int64_t j = 1; j < f->parts - 1; j++)
            for (int64_t i = 1; i < f->parts - j; i++)
                for (int axis = 0; axis < 3; axis++)
                    *to++ = (float)(((double)corner[0][axis] * (double)(f->parts - i - j) +
                                     (double)corner[1][axis] * (double)i +
                                     (double)corner[2][axis] * (double)j) /
                                    (double)f->parts);
    }
}

/* Vertex `step` (0 ... parts) along a side, in the direction of its triangle. */
static int64_t on_side(const struct flat *f, int64_t t, int corner, int64_t step)
{
    int32_t start = f->from->triangles[3 * t + corner];
    int32_t end = f->from->triangles[3 * t + (corner + 1) % 3];
    if (step == 0)
        return start;
    if (step == f->parts)
        return end;
    int64_t e = f->sides->edge[3 * t + corner];
    int64_t from_low = start < end ? step : f->parts - step;
    return f->first_edge_vertex + e * (f->parts - 1) + from_low - 1;
}

/* Vertex i of row j of triangle t. */
static int32_t lattice_vertex(const struct flat *f, int64_t t, int64_t i, int64_t j)
{
    if (j == 0)
        return (int32_t)on_side(f, t, 0, i);
    if (i == 0)
        return (int32_t)on_side(f, t, 2, f->parts - j);
    if (i + j == f->parts)
        return (int32_t)on_side(f, t, 1, j);
    int64_t inner = (f->parts - 1) * (f->parts - 2) / 2;
    /* Rows 1 ... j - 1 have parts - 2, parts - 3, ... vertices inside. */
    int64_t rows_before = (j - 1) * (2 * f->parts - 2 - j) / 2;
    return (int32_t)(f->first_inner_vertex + t * inner + rows_before + i - 1);
}

static void split_triangle(struct flat *f, int64_t t)
{
    int32_t *to = f->to.triangles + 3 * t * f->parts * f->parts;
    for (int64_t j = 0; j < f->parts; j++) {
        int32_t low = lattice_vertex(f, t, 0, j), high = lattice_vertex(f, t, 0, j + 1);
        for (int64_t i = 0; i < f->parts - j; i++) {
            int32_t next_low = lattice_vertex(f, t, i + 1, j);
            int32_t up[3] = {low, next_low, high};
            memcpy(to, up, sizeof up);
            to += 3;
            if (i + 1 < f->parts - j) {
                int32_t next_high = lattice_vertex(f, t, i + 1, j + 1);
                int32_t down[3] = {next_low, next_high, high};
                memcpy(to, down, sizeof down);
                to += 3;
                high = next_high;
            }
            low = next_low;
        }
    }
}

static int split_flat(struct mesh *mesh, const struct sides *sides, int64_t parts,
                      struct error *err)
{
    struct flat f = {.from = mesh, .sides = sides, .parts = parts};
    f.first_edge_vertex = mesh->vertex_count;
    f.first_inner_vertex = f.first_edge_vertex + (parts - 1) * sides->list.edge_count;
    int64_t inner = (parts - 1) * (parts - 2) / 2;
    if (mesh_init(&f.to, f.first_inner_vertex + inner * mesh->triangle_count,
                  parts * parts * mesh->triangle_count, err))
        return -1;
    if (mesh->vertex_count > 0)
        memcpy(f.to.positions, mesh->positions, 12 * (size_t)mesh->vertex_count);
    place_on_edges(&f);
    place_inside(&f);
    for (int64_t t = 0; t < mesh->triangle_count; t++)
        split_triangle(&f, t);
    mesh_release(mesh);
    *mesh = f.to;
    return 0;
}

int subdivide_flat(struct mesh *mesh, int parts, struct error *err)
{
    if (parts < 1 || parts > PARTS_LIMIT)
        return error_set(err, "splitting edges in %d parts, it must be 1 to %d", parts,
                         PARTS_LIMIT);
    struct sides sides;
    if (sides_init(&sides, mesh, err))
        return -1;
    int result = split_flat(mesh, &sides, parts, err);
    sides_release(&sides);
    return result;
}

int subdivide_to(struct mesh *mesh, int64_t triangles, struct error *err)
{
    if (triangles < 1 || mesh->triangle_count < 1)
        return error_set(err, "subdividing %d triangles to %lld: both must be 1 or more",
                         mesh->triangle_count, (long long)triangles);
    double exact = sqrt((double)triangles / (double)mesh->triangle_count);
    double parts = floor(exact);
    /* The nearer of parts^2 and (parts + 1)^2. */
    if (exact * exact - parts * parts > (parts + 1) * (parts + 1) - exact * exact)
        parts++;
    if (parts > PARTS_LIMIT)
        return error_set(err, "subdividing %d triangles to %lld: too many", mesh->triangle_count,
                         (long long)triangles);
    return parts <= 1 ? 0 : subdivide_flat(mesh, (int)parts, err);
}

/* -- Loop ------------------------------------------------------------------------------------- */

/* What a vertex gathers from its edges, for its new position. */
struct gathered {
    double all[3];    /* sum of all neighbours */
    double border[3]; /* sum of the neighbours along edges that have not two triangles */
    int32_t count, border_count;
};

static bool is_border(const struct edge *edge)
{
    return edge_use_count(edge) != 2;
}

static void gather(const struct mesh *mesh, const struct edge_list *list, struct gathered *sums)
{
    for (int64_t e = 0; e < list->edge_count; e++) {
        const struct edge *edge = &list->edges[e];
        for (int end = 0; end < 2; end++) {
            struct gathered *sum = &sums[end ? edge->high : edge->low];
            const float *p = mesh->positions + 3 * (int64_t)(end ? edge->low : edge->high);
            for (int axis = 0; axis < 3; axis++) {
                sum->all[axis] += (double)p[axis];
                if (is_border(edge))
                    sum->border[axis] += (double)p[axis];
            }
            sum->count++;
            sum->border_count += is_border(edge);
        }
    }
}

static void move_vertices(const struct mesh *mesh, const struct gathered *sums, float *to)
{
    for (int64_t v = 0; v < mesh->vertex_count; v++) {
        const struct gathered *sum = &sums[v];
        const float *p = mesh->positions + 3 * v;
        double weight = sum->count == 3 ? 3.0 / 16.0 : 3.0 / 8.0 / (double)sum->count;
        for (int axis = 0; axis < 3; axis++) {
            double old = (double)p[axis], moved = old;
            if (sum->border_count == 2)
                moved = 0.75 * old + 0.125 * sum->border[axis];
            else if (sum->border_count == 0 && sum->count > 0)
                moved = (1.0 - (double)sum->count * weight) * old + weight * sum->all[axis];
            to[3 * v + axis] = (float)moved;
        }
    }
}

/* The corner of a side's triangle that the side does not touch. */
static const float *opposite(const struct mesh *mesh, int32_t side)
{
    int32_t corner = side % 3 == 0 ? side + 2 : side - 1;
    return mesh->positions + 3 * (int64_t)mesh->triangles[corner];
}

static void place_edge_vertices(const struct mesh *mesh, const struct edge_list *list, float *to)
{
    for (int64_t e = 0; e < list->edge_count; e++) {
        const struct edge *edge = &list->edges[e];
        const int32_t *uses = list->uses + edge->first_use;
        const float *p = mesh->positions + 3 * (int64_t)edge->low;
        const float *q = mesh->positions + 3 * (int64_t)edge->high;
        for (int axis = 0; axis < 3; axis++) {
            double ends = (double)p[axis] + (double)q[axis];
            double placed = 0.5 * ends;
            if (!is_border(edge))
                placed = 0.375 * ends + 0.125 * ((double)opposite(mesh, uses[0])[axis] +
                                                 (double)opposite(mesh, uses[1])[axis]);
            to[3 * e + axis] = (float)placed;
        }
    }
}

int subdivide_loop(struct mesh *mesh, struct error *err)
{
    struct sides sides;
    if (sides_init(&sides, mesh, err))
        return -1;
    struct gathered *sums = calloc((size_t)mesh->vertex_count + 1, sizeof *sums);
    float *moved = malloc(12 * ((size_t)mesh->vertex_count + (size_t)sides.list.edge_count) + 1);
    int result = -1;
    if (!sums || !moved) {
        error_set(err, "out of memory: subdividing %d triangles", mesh->triangle_count);
    } else {
        gather(mesh, &sides.list, sums);
        move_vertices(mesh, sums, moved);
        place_edge_vertices(mesh, &sides.list, moved + 3 * (int64_t)mesh->vertex_count);
        /* Two parts an edge number the vertices as `moved` does. */
        result = split_flat(mesh, &sides, 2, err);
        if (result == 0 && mesh->vertex_count > 0)
            memcpy(mesh->positions, moved, 12 * (size_t)mesh->vertex_count);
    }
    free(sums);
    free(moved);
    sides_release(&sides);
    return result;
}
