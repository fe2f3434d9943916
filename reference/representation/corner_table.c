/* The corner table: building, checking, and back; see corner_table.h. */
#include "reference/representation/corner_table.h"

#include "reference/representation/sides.h"

#include <stdlib.h>
#include <string.h>

void corner_table_release(struct corner_table *table)
{
    free(table->positions);
    free(table->vertex_corner);
    free(table->vertex);
    free(table->opposite);
    *table = (struct corner_table){0};
}

static int allocate(struct corner_table *table, const struct mesh *mesh, struct error *err)
{
    size_t vertex_count = (size_t)mesh->vertex_count;
    size_t corner_count = 3 * (size_t)mesh->triangle_count;
    *table = (struct corner_table){.positions = malloc(12 * vertex_count + 1),
                                   .vertex_corner = malloc(4 * vertex_count + 1),
                                   .vertex = malloc(4 * corner_count + 1),
                                   .opposite = malloc(4 * corner_count + 1),
                                   .vertex_count = mesh->vertex_count,
                                   .triangle_count = mesh->triangle_count};
    if (table->positions && table->vertex_corner && table->vertex && table->opposite)
        return 0;
    corner_table_release(table);
    error_set(err, "out of memory: corner table of %d triangles", mesh->triangle_count);
    return -1;
}

/* The side that faces corner c starts at the next corner; its twin is faced by the corner before
 * the one where the twin starts. Side numbers are corner numbers (sides.h). */
static void fill_opposites(struct corner_table *table, const int32_t *twin)
{
    for (int32_t c = 0; c < 3 * table->triangle_count; c++) {
        int32_t across = twin[corner_next(c)];
        table->opposite[c] = across < 0 ? -1 : corner_previous(across);
    }
}

int corner_table_build(struct corner_table *table, const struct mesh *mesh, struct error *err)
{
    if (allocate(table, mesh, err))
        return -1;
    struct polygons polygons = polygons_of_mesh(mesh);
    int32_t *twin = malloc(12 * (size_t)mesh->triangle_count + 1);
    if (!twin || sides_match(&polygons, twin, err) ||
        sides_fans(&polygons, twin, table->vertex_corner, err)) {
        if (!twin)
            error_set(err, "out of memory: corner table of %d triangles", mesh->triangle_count);
        free(twin);
        corner_table_release(table);
        return -1;
    }
    fill_opposites(table, twin);
    free(twin);
    if (mesh->vertex_count)
        memcpy(table->positions, mesh->positions, 12 * (size_t)mesh->vertex_count);
    if (mesh->triangle_count)
        memcpy(table->vertex, mesh->triangles, 12 * (size_t)mesh->triangle_count);
    return 0;
}

/* -- checking ------------------------------------------------------------------------------- */

static int check_corner(const struct corner_table *table, int32_t c, struct error *err)
{
    const int32_t *vertex = table->vertex;
    int32_t o = table->opposite[c];
    if (vertex[c] < 0 || vertex[c] >= table->vertex_count || table->vertex_corner[vertex[c]] < 0)
        return error_set(err, "corner %d is at %d, which is no vertex in use", c, vertex[c]);
    if (vertex[c] == vertex[corner_next(c)])
        return error_set(err, "triangle %d is degenerate: it names vertex %d twice", c / 3,
                         vertex[c]);
    if (o == -1)
        return 0;
    if (o < 0 || o >= 3 * table->triangle_count || o == c || table->opposite[o] != c)
        return error_set(err, "corner %d is not the opposite of its opposite %d", c, o);
    if (vertex[corner_next(c)] != vertex[corner_previous(o)] ||
        vertex[corner_previous(c)] != vertex[corner_next(o)])
        return error_set(err, "corners %d and %d are opposite but face different edges", c, o);
    return 0;
}

/* Counts the corners that swinging from the vertex's own corner meets; -1 when they are no fan. */
static int32_t fan_length(const struct corner_table *table, int32_t vertex)
{
    int32_t first = table->vertex_corner[vertex], c = first, length = 0;
    do {
        if (table->vertex[c] != vertex || ++length > 3 * table->triangle_count)
            return -1;
        c = corner_table_swing(table, c);
    } while (c >= 0 && c != first);
    return c < 0 && !corner_table_on_boundary(table, vertex) ? -1 : length;
}

static int check_fans(const struct corner_table *table, int32_t *left, struct error *err)
{
    for (int32_t c = 0; c < 3 * table->triangle_count; c++)
        left[table->vertex[c]]++;
    for (int32_t v = 0; v < table->vertex_count; v++) {
        int32_t corner = table->vertex_corner[v];
        if (corner == -1)
            continue;
        if (corner < 0 || corner >= 3 * table->triangle_count || table->vertex[corner] != v)
            return error_set(err, "vertex %d has corner %d, which is not at it", v, corner);
        if (fan_length(table, v) != left[v])
            return error_set(err, "vertex %d: swinging from corner %d does not meet its %d corners",
                             v, corner, left[v]);
    }
    return 0;
}

int corner_table_check(const struct corner_table *table, struct error *err)
{
    for (int32_t c = 0; c < 3 * table->triangle_count; c++)
        if (check_corner(table, c, err))
            return -1;
    int32_t *left = calloc((size_t)table->vertex_count + 1, sizeof *left);
    if (!left)
        return error_set(err, "out of memory: checking %d vertices", table->vertex_count);
    int result = check_fans(table, left, err);
    free(left);
    return result;
}

int corner_table_to_mesh(const struct corner_table *table, struct mesh *mesh, struct error *err)
{
    if (mesh_init(mesh, table->vertex_count, table->triangle_count, err))
        return -1;
    if (table->vertex_count)
        memcpy(mesh->positions, table->positions, 12 * (size_t)table->vertex_count);
    if (table->triangle_count)
        memcpy(mesh->triangles, table->vertex, 12 * (size_t)table->triangle_count);
    return 0;
}
