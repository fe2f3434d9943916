/* The grid of problems 4.2 and 4.3; see lattice.h. */
#include "graders/library/lattice.h"

#include "graders/library/mistakes.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double PLACE_TOLERANCE = 1e-5;

static const struct phrase vertex_noun = {"vertex", "vértice"};
static const struct cause off_grid = {"vertex-off-grid",
                                      {"vertex off the grid", "vértice fuera de la rejilla"}};
static const struct cause repeated = {"vertex-repeated", {"repeated vertex", "vértice repetido"}};
static const struct cause transposed = {"transposed",
                                        {"rows and columns exchanged", "filas por columnas"}};
static const struct cause uncovered = {"cell-uncovered", {"uncovered cell", "celda sin cubrir"}};

/* ---------------------------------------------------------------------------------------- sizes */

static const int32_t few[] = {1, 1, 4, 8};
static const int32_t many[] = {1,   1,   1,   2,   2,   1,    2,  2,   1,   10,   3,    5,    5,
                               3,   4,   4,   4,   8,   8,    4,  8,   8,   10,   1,    16,   16,
                               31,  7,   32,  32,  20,  50,   64, 64,  99,  1,    1,    300,  128,
                               128, 100, 257, 256, 256, 1000, 3,  512, 512, 1024, 1024, 2000, 700};
static const int32_t large[] = {10000,   10000,   20000,    20000,    65535,     65535,
                                65536,   65536,   100000,   100000,   1000000,   1000000,
                                7654321, 7654321, 50000000, 50000000, 100000000, 100000000};
const struct question_rows lattice_few = QUESTION_ROWS(few);
const struct question_rows lattice_many = QUESTION_ROWS(many);
const struct question_rows lattice_large = QUESTION_ROWS(large);

int64_t lattice_vertices(int64_t m, int64_t n)
{
    return (m + 1) * (n + 1);
}

int64_t lattice_triangles(int64_t m, int64_t n)
{
    return 2 * m * n;
}

int64_t lattice_mesh_bytes(int64_t m, int64_t n)
{
    return 12 * lattice_vertices(m, n) + 12 * lattice_triangles(m, n);
}

const struct built_count lattice_vertex_count =
    COUNT("vertex_count", CAUSE_VERTEX_COUNT, lattice_vertices, NULL,
          "There are m + 1 rows of n + 1 vertices.", "Hay m + 1 filas de n + 1 vértices.");
const struct built_count lattice_triangle_count =
    COUNT("triangle_count", CAUSE_TRIANGLE_COUNT, lattice_triangles, NULL,
          "Every cell has two triangles.", "Cada celda tiene dos triángulos.");

enum { SQUARE, ONE_ROW, ONE_COLUMN };
const struct size_family lattice_families[] = {[SQUARE] = {"square", FAMILY_OWN, 0},
                                               [ONE_ROW] = {"one-row", FAMILY_OWN, 0},
                                               [ONE_COLUMN] = {"one-column", FAMILY_OWN, 0},
                                               {NULL}};

int64_t lattice_size_near(int family, int64_t vertex_count)
{
    int64_t rows = family == SQUARE ? (int64_t)sqrt((double)vertex_count) : 2;
    return vertex_count / rows * rows;
}

int lattice_make_sized(const struct question *build, int64_t looks, int family,
                       int64_t vertex_count, struct writer *input, struct error *err)
{
    int64_t rows = 2;
    if (family == SQUARE)
        for (int64_t r = 2; r * r <= vertex_count; r++)
            rows = vertex_count % r == 0 ? r : rows;
    if (vertex_count < 4 || vertex_count % rows != 0)
        return error_set(err, "no grid has %" PRId64 " vertices in %" PRId64 " rows", vertex_count,
                         rows);
    int64_t columns = vertex_count / rows;
    const int64_t tall[4] = {columns - 1, rows - 1, looks},
                  wide[4] = {rows - 1, columns - 1, looks};
    return question_write(build, family == ONE_COLUMN ? tall : wide, input, err);
}

int lattice_init(struct lattice *lattice, int32_t m, int32_t n, struct error *err)
{
    *lattice = (struct lattice){.m = m, .n = n};
    lattice->halves = calloc((size_t)m * (size_t)n, 1);
    if (!lattice->halves)
        return error_set(err, "out of memory for a grid of %d rows of %d cells", m, n);
    return 0;
}

void lattice_release(struct lattice *lattice)
{
    free(lattice->halves);
    *lattice = (struct lattice){0};
}

/* --------------------------------------------------------------------------------------- places */

/* The whole number next to `at` when it is within a quarter and in 0 ... last, else -1. */
static int32_t nearest_step(double at, int32_t last)
{
    if (!(at >= -0.25 && at <= last + 0.25))
        return -1;
    double step = round(at);
    return fabs(at - step) <= 0.25 ? (int32_t)step : -1;
}

int32_t lattice_nearest(const struct lattice *lattice, const float position[3])
{
    int32_t column = nearest_step((double)position[0] * lattice->n, lattice->n);
    int32_t row = nearest_step((double)position[1] * lattice->m, lattice->m);
    return column < 0 || row < 0 ? -1 : row * (lattice->n + 1) + column;
}

int32_t lattice_point_at(const struct lattice *lattice, const float position[3])
{
    int32_t point = lattice_nearest(lattice, position);
    int32_t row = point / (lattice->n + 1), column = point % (lattice->n + 1);
    double x = (double)column / lattice->n, y = (double)row / lattice->m;
    bool is_near = fabs((double)position[0] - x) <= PLACE_TOLERANCE &&
                   fabs((double)position[1] - y) <= PLACE_TOLERANCE &&
                   fabs((double)position[2]) <= PLACE_TOLERANCE;
    return point >= 0 && is_near ? point : -1;
}

void lattice_reject_place(const struct lattice *lattice, const struct message *subject,
                          const float position[3], struct judgement *out)
{
    double x = (double)position[0], y = (double)position[1], z = (double)position[2];
    if (!judge_reject_for(out, &off_grid))
        return;
    judge_en(out,
             "%s is at (%.6g, %.6g, %.6g), which is not within 0.00001 of a place x = column / %d, "
             "y = row / %d, z = 0.",
             subject->en, x, y, z, lattice->n, lattice->m);
    judge_es(out,
             "%s está en (%.6g, %.6g, %.6g), que no está a menos de 0.00001 de un punto "
             "x = columna / %d, y = fila / %d, z = 0.",
             subject->es, x, y, z, lattice->n, lattice->m);
}

/* ------------------------------------------------------------------------------------ triangles */

static int32_t smallest(const int32_t value[3])
{
    int32_t least = value[0] < value[1] ? value[0] : value[1];
    return least < value[2] ? least : value[2];
}

enum cell_fit lattice_add(struct lattice *lattice, const int32_t point[3], int32_t *cell)
{
    int32_t row[3], column[3];
    *cell = -1;
    if (smallest(point) < 0)
        return CELL_OUTSIDE;
    for (int i = 0; i < 3; i++) {
        row[i] = point[i] / (lattice->n + 1);
        column[i] = point[i] % (lattice->n + 1);
    }
    int32_t first_row = smallest(row), first_column = smallest(column);
    if (first_row == lattice->m || first_column == lattice->n)
        return CELL_OUTSIDE;
    for (int i = 0; i < 3; i++) {
        row[i] -= first_row;
        column[i] -= first_column;
    }
    int32_t number = first_row * lattice->n + first_column;
    enum cell_fit fit = cell_add(&lattice->halves[number], column, row);
    if (fit != CELL_OUTSIDE)
        *cell = number;
    return fit;
}

void lattice_judge_cover(const struct lattice *lattice, struct judgement *out)
{
    int64_t cell_count = (int64_t)lattice->m * lattice->n, cell = 0;
    while (cell < cell_count && cell_is_covered(lattice->halves[cell]))
        cell++;
    if (cell == cell_count || out->cause[0])
        return;
    int row = (int)(cell / lattice->n), column = (int)(cell % lattice->n);
    judge_name(out, "cell row %d, column %d", "celda de la fila %d, columna %d", row, column);
    judge_reject(out, &uncovered, "The cell of row %d, column %d is not covered.",
                 "La celda de la fila %d, columna %d no está cubierta.", row, column);
}

/* A mesh on a lattice, for cells_judge. */
struct laid_mesh {
    struct lattice *lattice;
    const struct built_mesh *mesh;
};

static enum cell_fit add_corners(void *cells, const int32_t corner[3])
{
    const struct laid_mesh *laid = cells;
    int32_t point[3], cell;
    for (int i = 0; i < 3; i++)
        point[i] = lattice_nearest(laid->lattice, laid->mesh->vertices + 3 * (int64_t)corner[i]);
    return lattice_add(laid->lattice, point, &cell);
}

static int judge_triangles(struct lattice *lattice, const struct built_mesh *mesh,
                           struct judgement *out, struct error *err)
{
    struct laid_mesh laid = {lattice, mesh};
    const struct cell_cover cover = {
        .cells = &laid, .add = add_corners, .seen_from = {"above", "arriba"}};
    cells_judge(mesh, &cover, out);
    lattice_judge_cover(lattice, out);
    return out->cause[0] ? built_mesh_show(mesh, &out->scene, err) : 0;
}

/* ------------------------------------------------------------------------------------- vertices */

/* Whether the whole mesh is right after x and y are exchanged: rows taken for columns. */
static bool is_transposed(const struct lattice *lattice, const struct built_mesh *mesh)
{
    for (int64_t v = 0; v < mesh->vertex_count; v++) {
        const float *p = mesh->vertices + 3 * v;
        const float swapped[3] = {p[1], p[0], p[2]};
        if (lattice_point_at(lattice, swapped) < 0)
            return false;
    }
    return true;
}

static void reject_vertex(const struct lattice *lattice, const struct built_mesh *mesh, int64_t v,
                          struct judgement *out)
{
    const float *p = mesh->vertices + 3 * v;
    double x = (double)p[0], y = (double)p[1], z = (double)p[2];
    struct message subject = {0};
    judge_name_one(out, vertex_noun, "%" PRId64 " (%.6g, %.6g, %.6g)", v, x, y, z);
    if (is_transposed(lattice, mesh))
        judge_reject(out, &transposed,
                     "Rows and columns are exchanged: vertex %" PRId64 " is at x = %.6g, y = %.6g, "
                     "but x goes along the n columns and y along the m rows.",
                     "Filas y columnas están cambiadas: el vértice %" PRId64 " está en x = %.6g, "
                     "y = %.6g, pero x recorre las n columnas e y las m filas.",
                     v, x, y);
    message_say(&subject, "Vertex %" PRId64, "El vértice %" PRId64, v);
    lattice_reject_place(lattice, &subject, p, out);
}

static void reject_second(int64_t v, int32_t earlier, struct judgement *out)
{
    judge_name_one(out, vertex_noun, "%" PRId64, v);
    judge_reject(out, &repeated, "Vertices %d and %" PRId64 " are at the same place.",
                 "Los vértices %d y %" PRId64 " están en el mismo lugar.", earlier, v);
}

static int judge_vertices(const struct lattice *lattice, const struct built_mesh *mesh,
                          struct judgement *out, struct error *err)
{
    int32_t *vertex_at = malloc(sizeof *vertex_at * (size_t)mesh->vertex_count);
    if (!vertex_at)
        return error_set(err, "out of memory for %" PRId64 " vertices", mesh->vertex_count);
    memset(vertex_at, 0xFF, sizeof *vertex_at * (size_t)mesh->vertex_count);
    for (int64_t v = 0; v < mesh->vertex_count; v++) {
        int32_t point = lattice_point_at(lattice, mesh->vertices + 3 * v);
        if (point >= 0 && vertex_at[point] < 0) {
            vertex_at[point] = (int32_t)v;
            out->scene.ok_count++;
            continue;
        }
        if (!out->cause[0] && point < 0)
            reject_vertex(lattice, mesh, v, out);
        else if (!out->cause[0])
            reject_second(v, vertex_at[point], out);
        scene_mark_vertex(&out->scene, point < 0 ? MARK_WRONG : MARK_DUPLICATE, (int32_t)v);
    }
    free(vertex_at);
    if (out->cause[0])
        return built_mesh_show(mesh, &out->scene, err);
    out->scene.ok_count = 0; /* triangles are counted next */
    return 0;
}

int lattice_judge_mesh(const int64_t asked[3], const struct built_mesh *mesh, struct judgement *out,
                       struct error *err)
{
    struct lattice lattice;
    int failed = 0;
    if (lattice_init(&lattice, (int32_t)asked[0], (int32_t)asked[1], err))
        return -1;
    if (asked[2] & LATTICE_VERTICES)
        failed = judge_vertices(&lattice, mesh, out, err);
    if (!failed && !out->cause[0] && (asked[2] & LATTICE_TRIANGLES))
        failed = judge_triangles(&lattice, mesh, out, err);
    lattice_release(&lattice);
    out->accepted = !failed && !out->cause[0];
    return failed;
}
