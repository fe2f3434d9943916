/* Judges memory-indexed-grid (problem 4.2). Vertices and triangles are judged by where they lie, so
 * that any numbering, any order and either diagonal is right. */
#include "graders/judges/judge.h"
#include "graders/library/formula.h"
#include "graders/library/lattice.h"
#include "graders/runner/memory/questions.h"
#include "graders/scene/show.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What of a built grid decides about a case. */
enum aspect { LOOK_AT_VERTICES = 1, LOOK_AT_TRIANGLES = 2, LOOK_AT_MEMORY = 4 };
enum { SHAPE = LOOK_AT_VERTICES | LOOK_AT_TRIANGLES };

static const double PLACE_TOLERANCE = 1e-5;

/* ------------------------------------------------------------------ formula */

static int64_t vertex_count_of(int64_t m, int64_t n)
{
    return (m + 1) * (n + 1);
}

static int64_t right_bytes(int64_t m, int64_t n)
{
    return 12 * vertex_count_of(m, n) + 24 * m * n;
}

static int64_t bytes_without_last_row(int64_t m, int64_t n)
{
    return 36 * m * n;
}

static int64_t bytes_one_triangle_a_cell(int64_t m, int64_t n)
{
    return 12 * vertex_count_of(m, n) + 12 * m * n;
}

static int64_t bytes_of_square(int64_t m, int64_t n)
{
    (void)m;
    return right_bytes(n, n);
}

static int64_t bytes_without_triangles(int64_t m, int64_t n)
{
    return 12 * vertex_count_of(m, n);
}

static const struct formula_mistake mistakes[] = {
    {"fence-post", bytes_without_last_row, "n cells in a row have n + 1 vertices, not n.",
     "n celdas en una fila tienen n + 1 vértices, no n."},
    {"half-the-triangles", bytes_one_triangle_a_cell, "Every cell has two triangles.",
     "Cada celda tiene dos triángulos."},
    {"square-only", bytes_of_square, "That is the size of an n x n grid: m is not looked at.",
     "Ese es el tamaño de una rejilla de n x n: no se tiene en cuenta m."},
    {"triangles-forgotten", bytes_without_triangles, "The table of triangles counts too.",
     "La tabla de triángulos también cuenta."},
    {0}};

static const struct formula bytes_formula = {"indexed_grid_bytes", {"m", "n"}, "bytes", "bytes",
                                             right_bytes,          mistakes};

static const int32_t small_rows[] = {
    1, 1,   1,   2,   2,   1,   2,   2,   1,    10, 3,   5,   5,    3,    4,    4,  4,  8,
    8, 4,   8,   8,   10,  1,   16,  16,  31,   7,  32,  32,  20,   50,   64,   64, 99, 1,
    1, 300, 128, 128, 100, 257, 256, 256, 1000, 3,  512, 512, 1024, 1024, 2000, 700};
static const int32_t course_rows[] = {1, 1, 4, 8};
static const int32_t large_rows[] = {10000,   10000,   20000,    20000,    65535,     65535,
                                     65536,   65536,   100000,   100000,   1000000,   1000000,
                                     7654321, 7654321, 50000000, 50000000, 100000000, 100000000};

struct rows {
    const int32_t *pairs;
    int64_t count;
};
static const struct rows row_sets[] = {{course_rows, sizeof course_rows / 8},
                                       {small_rows, sizeof small_rows / 8},
                                       {large_rows, sizeof large_rows / 8}};

static const struct number_mistake kilobyte_mistakes[] = {
    {"kilobyte-of-1000", 592.908, "1 KB is 1024 bytes.", "1 KB son 1024 bytes."},
    {"fence-post", 576, "128 cells in a row have 129 vertices.",
     "128 celdas en una fila tienen 129 vértices."},
    {"bytes", 592908, "That is in bytes, not in KB.", "Eso está en bytes, no en KB."},
    {0}};
static const struct number kilobytes = {"indexed_grid_kilobytes",
                                        592908.0 / 1024,
                                        TWO_DECIMALS,
                                        "It is not the size in KB for m = n = 128.",
                                        "No es el tamaño en KB para m = n = 128.",
                                        kilobyte_mistakes};

static const struct number_mistake limit_mistakes[] = {
    {"upside-down", 0.5, "That is vertices for each face.", "Eso son vértices por cada cara."},
    {"half-the-triangles", 1, "Every cell has two triangles.", "Cada celda tiene dos triángulos."},
    {0}};
static const struct number limit = {"indexed_grid_faces_per_vertex",
                                    2,
                                    1e-3,
                                    "It is not F / V when m and n are very large.",
                                    "No es F / V cuando m y n son muy grandes.",
                                    limit_mistakes};

/* -------------------------------------------------------------------- cases */

/* parameter: question, then m, n and aspect, or the set of rows */
static const struct judge_case cases[] = {
    {"course-figure", "vertices", 1, {ASK_GRID_BUILD, 4, 8, LOOK_AT_VERTICES}, true, true},
    {"wide-grid", "vertices", 2, {ASK_GRID_BUILD, 3, 17, LOOK_AT_VERTICES}, false, false},
    {"tall-grid", "vertices", 3, {ASK_GRID_BUILD, 40, 9, LOOK_AT_VERTICES}, false, false},
    {"very-wide-grid", "vertices", 4, {ASK_GRID_BUILD, 2, 5000, LOOK_AT_VERTICES}, false, false},
    {"course-figure-triangles",
     "triangles",
     5,
     {ASK_GRID_BUILD, 4, 8, LOOK_AT_TRIANGLES},
     true,
     true},
    {"two-cells-a-side", "triangles", 6, {ASK_GRID_BUILD, 2, 2, LOOK_AT_TRIANGLES}, true, false},
    {"wide-grid-triangles",
     "triangles",
     7,
     {ASK_GRID_BUILD, 3, 17, LOOK_AT_TRIANGLES},
     false,
     false},
    {"tall-grid-triangles",
     "triangles",
     8,
     {ASK_GRID_BUILD, 40, 9, LOOK_AT_TRIANGLES},
     false,
     false},
    {"large-grid-triangles",
     "triangles",
     9,
     {ASK_GRID_BUILD, 190, 180, LOOK_AT_TRIANGLES},
     false,
     false},
    {"one-cell", "smallest", 10, {ASK_GRID_BUILD, 1, 1, SHAPE}, true, true},
    {"one-row", "smallest", 11, {ASK_GRID_BUILD, 1, 6, SHAPE}, false, false},
    {"one-column", "smallest", 12, {ASK_GRID_BUILD, 6, 1, SHAPE}, false, false},
    {"memory-of-8", "measured-memory", 13, {ASK_GRID_BUILD, 8, 8, LOOK_AT_MEMORY}, true, true},
    {"memory-of-23", "measured-memory", 14, {ASK_GRID_BUILD, 23, 23, LOOK_AT_MEMORY}, false, false},
    {"memory-of-128",
     "measured-memory",
     15,
     {ASK_GRID_BUILD, 128, 128, LOOK_AT_MEMORY},
     false,
     false},
    {"bytes-of-course-figure", "formula", 16, {ASK_GRID_BYTES, 0, 0, 0}, true, true},
    {"bytes-of-many", "formula", 17, {ASK_GRID_BYTES, 1, 0, 0}, false, true},
    {"bytes-of-large", "formula-large", 18, {ASK_GRID_BYTES, 2, 0, 0}, false, true},
    {"kilobytes-of-128", "kilobytes", 19, {ASK_GRID_KILOBYTES, 0, 0, 0}, true, true},
    {"limit-of-faces", "limit", 20, {ASK_GRID_FACES_PER_VERTEX, 0, 0, 0}, true, true}};

static void write_build(struct writer *input, int64_t m, int64_t n, int64_t aspect)
{
    write_int(input, ASK_GRID_BUILD);
    write_int(input, m);
    write_int(input, n);
    write_int(input, aspect);
}

static int make(const struct judge_case *c, const char *models, struct writer *input,
                struct error *err)
{
    (void)models;
    if (c->parameter[0] == ASK_GRID_BUILD) {
        write_build(input, c->parameter[1], c->parameter[2], c->parameter[3]);
    } else {
        write_int(input, c->parameter[0]);
        if (c->parameter[0] == ASK_GRID_BYTES) {
            const struct rows *rows = &row_sets[c->parameter[1]];
            write_int(input, rows->count);
            write_array(input, rows->pairs, rows->count, 2 * sizeof *rows->pairs);
        }
    }
    return input->failed ? error_set(err, "out of memory for case %s", c->name) : 0;
}

static const char *const families[] = {"square", "one-row", "one-column", NULL};

/* A grid of exactly `size` vertices. There is one grid of each shape: the seed changes nothing. */
static int make_sized(int family, int64_t size, uint64_t seed, struct writer *input,
                      struct error *err)
{
    (void)seed;
    int64_t rows = 2;
    if (family == 0)
        for (int64_t r = 2; r * r <= size; r++)
            rows = size % r == 0 ? r : rows;
    if (size < 4 || size % rows != 0)
        return error_set(err, "no grid has %" PRId64 " vertices in %" PRId64 " rows", size, rows);
    int64_t m = rows - 1, n = size / rows - 1;
    write_build(input, family == 2 ? n : m, family == 2 ? m : n, SHAPE);
    return input->failed ? error_set(err, "out of memory for %" PRId64 " vertices", size) : 0;
}

/* --------------------------------------------------------------- built grid */

/* A built grid as the answer tells it; tables are borrowed from the packet. */
struct built {
    int32_t m, n;
    int64_t vertex_count, triangle_count, own_bytes;
    const float *vertices;
    const int32_t *triangles;
};

/* Reads the tables and rejects those that cannot be looked at. Returns whether they can. */
static bool read_built(struct reader *answer, struct built *built, struct judgement *out)
{
    int64_t status = read_int(answer);
    if (!answer->failed && status != 0) {
        judge_reject(out, "unknown-status", "The builder returned %" PRId64 ", not 0.",
                     "El constructor ha devuelto %" PRId64 ", no 0.", status);
        return false;
    }
    built->vertices = read_table(answer, &built->vertex_count, 3 * sizeof *built->vertices);
    built->triangles = read_table(answer, &built->triangle_count, 3 * sizeof *built->triangles);
    built->own_bytes = read_int(answer);
    if (answer->failed) {
        judge_reject(out, "malformed-answer", "The answer is incomplete.",
                     "La respuesta está incompleta.");
        return false;
    }
    int64_t vertex_count = vertex_count_of(built->m, built->n);
    int64_t triangle_count = 2 * (int64_t)built->m * built->n;
    if (built->vertex_count != vertex_count) {
        judge_reject(out, "vertex-count",
                     "vertex_count is %" PRId64 "; this grid has %" PRId64 " vertices.",
                     "vertex_count es %" PRId64 "; esta rejilla tiene %" PRId64 " vértices.",
                     built->vertex_count, vertex_count);
        return false;
    }
    if (built->triangle_count != triangle_count) {
        judge_reject(out, "triangle-count",
                     "triangle_count is %" PRId64 "; this grid has %" PRId64 " triangles.",
                     "triangle_count es %" PRId64 "; esta rejilla tiene %" PRId64 " triángulos.",
                     built->triangle_count, triangle_count);
        return false;
    }
    if (!built->vertices || !built->triangles) {
        judge_reject(out, "table-missing", "A table is NULL.", "Una tabla es NULL.");
        return false;
    }
    return true;
}

/* Shows what there is of a grid with wrong counts. */
static int show_unusable(const struct built *built, struct scene *scene, struct error *err)
{
    if (!built->vertices || built->vertex_count == 0)
        return 0;
    return show_mesh(scene, built->vertices, built->vertex_count, built->triangles,
                     built->triangles ? built->triangle_count : 0, err);
}

/* Whether the whole grid is right after x and y are exchanged: rows taken for columns. */
static bool is_transposed(const struct lattice *lattice, const struct built *built)
{
    for (int64_t v = 0; v < built->vertex_count; v++) {
        const float *p = built->vertices + 3 * v;
        const float swapped[3] = {p[1], p[0], p[2]};
        int32_t point = lattice_nearest(lattice, swapped);
        if (point < 0 || !lattice_is_at(lattice, point, swapped, PLACE_TOLERANCE))
            return false;
    }
    return true;
}

static void reject_place(const struct lattice *lattice, const struct built *built, int64_t v,
                         struct judgement *out)
{
    const float *p = built->vertices + 3 * v;
    judge_name_element(out, "vertex %" PRId64 " (%.6g, %.6g, %.6g)", v, (double)p[0], (double)p[1],
                       (double)p[2]);
    if (is_transposed(lattice, built))
        judge_reject(
            out, "transposed",
            "Rows and columns are exchanged: vertex %" PRId64 " is at x = %.6g, y = %.6g, but x"
            " goes along the n columns and y along the m rows.",
            "Filas y columnas están cambiadas: el vértice %" PRId64 " está en x = %.6g, y = %.6g,"
            " pero x recorre las n columnas e y las m filas.",
            v, (double)p[0], (double)p[1]);
    else
        judge_reject(out, "vertex-off-grid",
                     "Vertex %" PRId64 " is at (%.6g, %.6g, %.6g), which is not within 0.00001 of a"
                     " place x = column / %d, y = row / %d, z = 0.",
                     "El vértice %" PRId64
                     " está en (%.6g, %.6g, %.6g), que no está a menos de 0.00001"
                     " de un punto x = columna / %d, y = fila / %d, z = 0.",
                     v, (double)p[0], (double)p[1], (double)p[2], built->n, built->m);
}

static int show_wrong_vertices(const struct lattice *lattice, const struct built *built,
                               struct scene *scene, struct error *err)
{
    if (show_mesh(scene, built->vertices, built->vertex_count, built->triangles,
                  built->triangle_count, err))
        return -1;
    for (int64_t v = 0; v < built->vertex_count; v++) {
        int32_t point = lattice_nearest(lattice, built->vertices + 3 * v);
        if (point < 0 || !lattice_is_at(lattice, point, built->vertices + 3 * v, PLACE_TOLERANCE))
            scene_mark_vertex(scene, MARK_WRONG, (int32_t)v);
        else
            scene->ok_count++;
    }
    return 0;
}

/* Every lattice point has exactly one vertex. */
static int judge_vertices(const struct lattice *lattice, const struct built *built,
                          struct judgement *out, struct error *err)
{
    int32_t *vertex_at = malloc(sizeof *vertex_at * (size_t)built->vertex_count);
    if (!vertex_at)
        return error_set(err, "out of memory for %" PRId64 " vertices", built->vertex_count);
    memset(vertex_at, 0xFF, sizeof *vertex_at * (size_t)built->vertex_count);
    int failed = 0;
    for (int64_t v = 0; v < built->vertex_count && !out->cause[0]; v++) {
        const float *p = built->vertices + 3 * v;
        int32_t point = lattice_nearest(lattice, p);
        if (point < 0 || !lattice_is_at(lattice, point, p, PLACE_TOLERANCE)) {
            reject_place(lattice, built, v, out);
            failed = show_wrong_vertices(lattice, built, &out->scene, err);
        } else if (vertex_at[point] >= 0) {
            judge_name_element(out, "vertex %" PRId64, v);
            judge_reject(
                out, "vertex-repeated", "Vertices %d and %" PRId64 " are at the same place.",
                "Los vértices %d y %" PRId64 " están en el mismo lugar.", vertex_at[point], v);
            failed = show_mesh(&out->scene, built->vertices, built->vertex_count, built->triangles,
                               built->triangle_count, err);
            if (!failed)
                scene_mark_vertex(&out->scene, MARK_DUPLICATE, (int32_t)v);
        } else {
            vertex_at[point] = (int32_t)v;
        }
    }
    free(vertex_at);
    return failed;
}

/* ---------------------------------------------------------------- triangles */

static void reject_triangle(enum lattice_fit fit, int64_t t, const int32_t *corner,
                            struct judgement *out)
{
    static const struct {
        const char *cause, *text, *text_es;
    } faults[] = {
        [LATTICE_HALF_FLIPPED] =
            {"triangle-flipped", "is clockwise seen from above; all must be counter-clockwise.",
             "va en sentido horario visto desde arriba; todos deben ir en antihorario."},
        [LATTICE_REPEATED] = {"triangle-repeated", "covers what an earlier triangle covers.",
                              "cubre lo mismo que un triángulo anterior."},
        [LATTICE_CROSSED] =
            {"triangles-overlap", "overlaps an earlier one: its cell is cut by both diagonals.",
             "se solapa con otro anterior: su celda está partida por las dos diagonales."},
        [LATTICE_OUTSIDE] = {"triangle-not-in-cell", "is not half of one cell.",
                             "no es la mitad de una celda."}};
    judge_name_element(out, "triangle %" PRId64 " (%d, %d, %d)", t, corner[0], corner[1],
                       corner[2]);
    judge_reject(out, faults[fit].cause, "Triangle %" PRId64 " (%d, %d, %d) %s%.0s",
                 "El triángulo %" PRId64 " (%d, %d, %d) %.0s%s", t, corner[0], corner[1], corner[2],
                 faults[fit].text, faults[fit].text_es);
}

static enum mark_kind mark_of(enum lattice_fit fit)
{
    if (fit == LATTICE_HALF_FLIPPED)
        return MARK_FLIPPED;
    return fit == LATTICE_REPEATED ? MARK_DUPLICATE : MARK_WRONG;
}

/* Adds every triangle to the lattice; the first that does not fit is named, all such are marked. */
static void judge_each_triangle(struct lattice *lattice, const struct built *built,
                                struct judgement *out)
{
    for (int64_t t = 0; t < built->triangle_count; t++) {
        const int32_t *corner = built->triangles + 3 * t;
        if (!triangle_in_range(corner, built->vertex_count)) {
            judge_name_element(out, "triangle %" PRId64 " (%d, %d, %d)", t, corner[0], corner[1],
                               corner[2]);
            judge_reject(out, "index-out-of-range",
                         "Triangle %" PRId64
                         " (%d, %d, %d) names a vertex that is not in 0 ... %" PRId64 ".",
                         "El triángulo %" PRId64
                         " (%d, %d, %d) nombra un vértice fuera de 0 ... %" PRId64 ".",
                         t, corner[0], corner[1], corner[2], built->vertex_count - 1);
            return;
        }
        int32_t point[3], cell;
        for (int i = 0; i < 3; i++)
            point[i] = lattice_nearest(lattice, built->vertices + 3 * (int64_t)corner[i]);
        enum lattice_fit fit = lattice_add(lattice, point[0], point[1], point[2], &cell);
        if (fit == LATTICE_HALF) {
            out->scene.ok_count++;
            continue;
        }
        if (!out->cause[0])
            reject_triangle(fit, t, corner, out);
        scene_mark_triangle(&out->scene, mark_of(fit), corner[0], corner[1], corner[2]);
    }
}

static int judge_triangles(struct lattice *lattice, const struct built *built,
                           struct judgement *out, struct error *err)
{
    judge_each_triangle(lattice, built, out);
    int32_t bare = lattice_first_uncovered(lattice);
    if (!out->cause[0] && bare >= 0) {
        judge_name_element(out, "cell row %d, column %d", bare / built->n, bare % built->n);
        judge_reject(out, "cell-uncovered", "The cell of row %d, column %d is not covered.",
                     "La celda de la fila %d, columna %d no está cubierta.", bare / built->n,
                     bare % built->n);
    }
    if (!out->cause[0])
        return 0;
    return show_mesh(&out->scene, built->vertices, built->vertex_count, built->triangles,
                     built->triangle_count, err);
}

/* -------------------------------------------------------------------- judge */

static int judge_built(struct built *built, int64_t aspect, const struct usage *usage,
                       struct judgement *out, struct error *err)
{
    struct lattice lattice;
    if (aspect & LOOK_AT_MEMORY) {
        struct size_claim claim = {"indexed_grid_build", "indexed_grid_bytes", 0, built->own_bytes,
                                   right_bytes(built->m, built->n)};
        size_judge(&claim, usage, out);
        return 0;
    }
    if (lattice_init(&lattice, built->m, built->n, err))
        return -1;
    int failed = 0;
    if (aspect & LOOK_AT_VERTICES)
        failed = judge_vertices(&lattice, built, out, err);
    if (!failed && !out->cause[0] && (aspect & LOOK_AT_TRIANGLES))
        failed = judge_triangles(&lattice, built, out, err);
    lattice_release(&lattice);
    if (!failed && !out->cause[0])
        judge_accept(out);
    return failed;
}

static int judge_bytes(struct reader *input, struct reader *answer, struct judgement *out,
                       struct error *err)
{
    int64_t row_count = read_int(input);
    const int32_t *rows = read_array(input, row_count, 2 * sizeof *rows);
    const int64_t *answers = read_array(answer, row_count, sizeof *answers);
    if (!rows)
        return error_set(err, "the input of memory-indexed-grid is broken");
    if (answers)
        return formula_judge(&bytes_formula, rows, row_count, answers, out, err);
    judge_reject(out, "malformed-answer", "The answer is incomplete.",
                 "La respuesta está incompleta.");
    return 0;
}

static int judge(struct span input, struct span answer, const struct usage *usage,
                 struct judgement *out, struct error *err)
{
    struct reader in = reader_of(input.bytes, input.count);
    struct reader said = reader_of(answer.bytes, answer.count);
    int64_t question = read_int(&in);
    if (question == ASK_GRID_BYTES)
        return judge_bytes(&in, &said, out, err);
    if (question == ASK_GRID_BUILD) {
        struct built built = {0};
        built.m = (int32_t)read_int(&in);
        built.n = (int32_t)read_int(&in);
        int64_t aspect = read_int(&in);
        if (read_built(&said, &built, out))
            return judge_built(&built, aspect, usage, out, err);
        return show_unusable(&built, &out->scene, err);
    }
    double value = read_real(&said);
    number_judge(question == ASK_GRID_KILOBYTES ? &kilobytes : &limit,
                 said.failed ? (double)NAN : value, out);
    return 0;
}

static size_t answer_bound(struct span input)
{
    struct reader in = reader_of(input.bytes, input.count);
    int64_t question = read_int(&in);
    int64_t first = read_int(&in);
    int64_t second = read_int(&in);
    if (question == ASK_GRID_BUILD)
        return (size_t)right_bytes(first, second) + 256;
    return question == ASK_GRID_BYTES ? sizeof(int64_t) * (size_t)first : sizeof(double);
}

const struct judge judge_memory_indexed_grid = {.exercise = "memory-indexed-grid",
                                                .cases = cases,
                                                .case_count = sizeof cases / sizeof *cases,
                                                .make = make,
                                                .families = families,
                                                .make_sized = make_sized,
                                                .judge = judge,
                                                .answer_bound = answer_bound};
