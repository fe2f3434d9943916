/* Sizes of the spheres of problem 4.1; see sphere_sizes.h. */
#include "graders/library/sphere_sizes.h"

/* --------------------------------------------------------------------------------------- voxels */

static int64_t cells(int64_t k, int64_t unused)
{
    (void)unused;
    return k * k * k;
}

int64_t sphere_voxel_bytes(int64_t k, int64_t unused)
{
    return (cells(k, unused) + 7) / 8;
}

static int64_t rounded_down(int64_t k, int64_t unused)
{
    return cells(k, unused) / 8;
}

static int64_t padded_slices(int64_t k, int64_t unused)
{
    (void)unused;
    return (k * k + 7) / 8 * k;
}

const struct formula_mistake sphere_voxel_mistakes[] = {
    MISTAKE_BYTE_A_CELL(cells),
    MISTAKE(CAUSE("rounded-down", "rounded down", "redondeado hacia abajo"), rounded_down,
            "The last byte counts even when it is not full.",
            "El último byte cuenta aunque no esté lleno."),
    MISTAKE(CAUSE("padded-slices", "padded slices", "capas con relleno"), padded_slices,
            "Only the last byte of all may be partly used.",
            "Solo el último byte de todos puede quedar a medias."),
    MISTAKES_END};

const struct built_count sphere_byte_count =
    COUNT("byte_count", CAUSE("byte-count", "number of bytes", "número de bytes"),
          sphere_voxel_bytes, sphere_voxel_mistakes, "Each of the k^3 cells takes a bit.",
          "Cada una de las k^3 celdas ocupa un bit.");

/* ----------------------------------------------------------------------------------------- mesh */

static int64_t right_vertices(int64_t k, int64_t unused)
{
    (void)unused;
    return k * k;
}

static int64_t vertices_with_shared_poles(int64_t k, int64_t unused)
{
    (void)unused;
    return k * (k - 2) + 2;
}

static int64_t vertices_with_meridian_more(int64_t k, int64_t unused)
{
    (void)unused;
    return k * (k + 1);
}

static int64_t vertices_of_larger_grid(int64_t k, int64_t unused)
{
    (void)unused;
    return (k + 1) * (k + 1);
}

static int64_t right_triangles(int64_t k, int64_t unused)
{
    (void)unused;
    return 2 * k * (k - 1);
}

static int64_t triangles_of_closed_grid(int64_t k, int64_t unused)
{
    (void)unused;
    return 2 * k * k;
}

static int64_t triangles_without_seam(int64_t k, int64_t unused)
{
    (void)unused;
    return 2 * (k - 1) * (k - 1);
}

static int64_t triangles_without_flat(int64_t k, int64_t unused)
{
    (void)unused;
    return 2 * k * (k - 2);
}

int64_t sphere_mesh_bytes(int64_t k, int64_t unused)
{
    return 12 * right_vertices(k, unused) + 12 * right_triangles(k, unused);
}

static int64_t bytes_of_closed_grid(int64_t k, int64_t unused)
{
    return 12 * right_vertices(k, unused) + 12 * triangles_of_closed_grid(k, unused);
}

static int64_t bytes_with_shared_poles(int64_t k, int64_t unused)
{
    return 12 * vertices_with_shared_poles(k, unused) + 12 * triangles_without_flat(k, unused);
}

static int64_t bytes_without_seam(int64_t k, int64_t unused)
{
    return 12 * right_vertices(k, unused) + 12 * triangles_without_seam(k, unused);
}

static int64_t bytes_without_flat(int64_t k, int64_t unused)
{
    return 12 * right_vertices(k, unused) + 12 * triangles_without_flat(k, unused);
}

const struct formula_mistake sphere_mesh_mistakes[] = {
    MISTAKE_CLOSED_GRID(bytes_of_closed_grid), MISTAKE_SHARED_POLES(bytes_with_shared_poles),
    MISTAKE_REPLICATED_SEAM(bytes_without_seam), MISTAKE_NO_FLAT_TRIANGLES(bytes_without_flat),
    MISTAKES_END};

#define MERIDIAN_TWICE(value)                                                                      \
    MISTAKE(                                                                                       \
        CAUSE("meridian-stored-twice", "meridian stored twice", "meridiano guardado dos veces"),   \
        value, "The last meridian is not a copy of the first: there are k in all.",                \
        "El último meridiano no es una copia del primero: hay k en total.")

static const struct formula_mistake vertex_mistakes[] = {
    MISTAKE_SHARED_POLES(vertices_with_shared_poles), MERIDIAN_TWICE(vertices_with_meridian_more),
    MERIDIAN_TWICE(vertices_of_larger_grid), MISTAKES_END};
static const struct formula_mistake triangle_mistakes[] = {
    MISTAKE_CLOSED_GRID(triangles_of_closed_grid), MISTAKE_REPLICATED_SEAM(triangles_without_seam),
    MISTAKE_NO_FLAT_TRIANGLES(triangles_without_flat), MISTAKES_END};

const struct built_count sphere_vertex_count =
    COUNT("vertex_count", CAUSE_VERTEX_COUNT, right_vertices, vertex_mistakes,
          "There are k meridians of k vertices.", "Hay k meridianos de k vértices.");
const struct built_count sphere_triangle_count = COUNT(
    "triangle_count", CAUSE_TRIANGLE_COUNT, right_triangles, triangle_mistakes,
    "There are k times k - 1 cells of two triangles.", "Hay k por k - 1 celdas de dos triángulos.");
