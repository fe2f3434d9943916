/* Judges memory-strips (problem 4.3). A strip is decoded triangle by triangle and judged by where
 * its vertices lie, so that strips may stand in any order, run either way and cut by either
 * diagonal. */
#include "graders/judges/judge.h"
#include "graders/library/formula.h"
#include "graders/library/lattice.h"
#include "graders/runner/memory/questions.h"
#include "graders/scene/show.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

/* What of the built strips decides about a case. */
enum aspect { LOOK_AT_COVER = 1, LOOK_AT_WINDING = 2, LOOK_AT_MEMORY = 4, LOOK_AT_PROCESSED = 8 };
enum { SHAPE = LOOK_AT_COVER | LOOK_AT_WINDING, SHOWN_STRIP_LIMIT = 256, COUNT_BYTES = 4 };

static const double PLACE_TOLERANCE = 1e-5;

/* ----------------------------------------------------------------- formulas */

static int64_t processed_in_strips(int64_t m, int64_t n)
{
    return 2 * m * (n + 1);
}

static int64_t processed_indexed(int64_t m, int64_t n)
{
    return (m + 1) * (n + 1);
}

static int64_t right_bytes(int64_t m, int64_t n)
{
    return 4 + 8 * m + 24 * m * (n + 1);
}

static int64_t bytes_with_short_pointers(int64_t m, int64_t n)
{
    return 4 + 4 * m + 24 * m * (n + 1);
}

static int64_t bytes_without_table(int64_t m, int64_t n)
{
    return 24 * m * (n + 1);
}

static int64_t bytes_without_count(int64_t m, int64_t n)
{
    return 8 * m + 24 * m * (n + 1);
}

static int64_t bytes_with_2n_vertices(int64_t m, int64_t n)
{
    return 4 + 8 * m + 24 * m * n;
}

static int64_t bytes_exchanged(int64_t m, int64_t n)
{
    return right_bytes(n, m);
}

static int64_t processed_with_2n(int64_t m, int64_t n)
{
    return 2 * m * n;
}

static int64_t processed_each_corner(int64_t m, int64_t n)
{
    return 6 * m * n;
}

static const struct formula_mistake byte_mistakes[] = {
    {"short-pointers", bytes_with_short_pointers, "A pointer takes 8 bytes, not 4.",
     "Un puntero ocupa 8 bytes, no 4."},
    {"table-forgotten", bytes_without_table,
     "The table of strips (one int and m pointers) counts too.",
     "La tabla de tiras (un entero y m punteros) también cuenta."},
    {"count-forgotten", bytes_without_count, "The int of the table counts too.",
     "El entero de la tabla también cuenta."},
    {"fence-post", bytes_with_2n_vertices, "A strip of 2n triangles has 2n + 2 vertices.",
     "Una tira de 2n triángulos tiene 2n + 2 vértices."},
    {"exchanged", bytes_exchanged, "m and n are exchanged: there are m strips of n cells.",
     "m y n están cambiados: hay m tiras de n celdas."},
    {0}};
static const struct formula_mistake strips_processed_mistakes[] = {
    {"fence-post", processed_with_2n, "A strip of 2n triangles has 2n + 2 vertices.",
     "Una tira de 2n triángulos tiene 2n + 2 vértices."},
    {"each-corner", processed_each_corner, "That is three vertices for each triangle.",
     "Eso son tres vértices por cada triángulo."},
    {0}};
static const struct formula_mistake indexed_processed_mistakes[] = {
    {"each-corner", processed_each_corner,
     "An indexed mesh processes each vertex of its table once, not once for each triangle.",
     "Una malla indexada procesa cada vértice de su tabla una vez, no una por triángulo."},
    {0}};

static const struct formula bytes_formula = {"strips_bytes", {"m", "n"},  "bytes",
                                             "bytes",        right_bytes, byte_mistakes};
static const struct formula strips_processed = {
    "strips_processed_vertices", {"m", "n"}, "vertices", "vértices", processed_in_strips,
    strips_processed_mistakes};
static const struct formula indexed_processed = {
    "indexed_processed_vertices", {"m", "n"}, "vertices", "vértices", processed_indexed,
    indexed_processed_mistakes};

static const int32_t course_rows[] = {1, 1, 4, 8};
static const int32_t small_rows[] = {
    1, 1,   1,   2,   2,   1,   2,   2,   1,   10,  3,    5,  5,    3,    4,    4,  4,  8,
    8, 4,   8,   8,   10,  1,   16,  16,  31,  7,   32,   32, 20,   50,   64,   64, 99, 1,
    1, 300, 128, 128, 100, 257, 256, 256, 512, 512, 1000, 3,  1024, 1024, 2000, 700};
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

/* ------------------------------------------------------------------ numbers */

static const struct number_mistake kilobyte_mistakes[] = {
    {"kilobyte-of-1000", 397.316, "1 KB is 1024 bytes.", "1 KB son 1024 bytes."},
    {"short-pointers", 396804.0 / 1024, "A pointer takes 8 bytes, not 4.",
     "Un puntero ocupa 8 bytes, no 4."},
    {"table-forgotten", 387, "The table of strips counts too.",
     "La tabla de tiras también cuenta."},
    {"fence-post", 394244.0 / 1024, "A strip of 256 triangles has 258 vertices.",
     "Una tira de 256 triángulos tiene 258 vértices."},
    {"bytes", 397316, "That is in bytes, not in KB.", "Eso está en bytes, no en KB."},
    {0}};
static const struct number_mistake memory_mistakes[] = {
    {"upside-down", 2.0 / 3, "That is strips / indexed.", "Eso es tiras / indexada."},
    {"wrong-ratio", 2, "Compare the bytes of both formulas, not their vertices.",
     "Compara los bytes de ambas fórmulas, no sus vértices."},
    {0}};
static const struct number_mistake time_mistakes[] = {
    {"upside-down", 0.5, "That is indexed / strips.", "Eso es indexada / tiras."},
    {"each-corner", 6, "The strips share vertices between their triangles.",
     "Los triángulos de una tira comparten vértices."},
    {0}};
static const struct number kilobytes = {"strips_kilobytes",
                                        397316.0 / 1024,
                                        TWO_DECIMALS,
                                        "It is not the size in KB for m = n = 128.",
                                        "No es el tamaño en KB para m = n = 128.",
                                        kilobyte_mistakes};
static const struct number memory_ratio = {
    "strips_memory_ratio",
    1.5,
    1e-3,
    "It is not bytes of the indexed mesh / bytes of the strips for very large m and n.",
    "No es bytes de la malla indexada / bytes de las tiras para m y n muy grandes.",
    memory_mistakes};
static const struct number time_ratio = {
    "strips_time_ratio",
    2,
    1e-3,
    "It is not vertices processed for strips / for the indexed mesh for very large m and n.",
    "No es vértices procesados con tiras / con malla indexada para m y n muy grandes.",
    time_mistakes};

/* -------------------------------------------------------------------- cases */

/* parameter: question, then m, n and aspect, or the set of rows */
static const struct judge_case cases[] = {
    {"course-figure", "strips", 1, {ASK_STRIPS_BUILD, 4, 8, LOOK_AT_COVER}, true, true},
    {"wide-grid", "strips", 2, {ASK_STRIPS_BUILD, 3, 17, LOOK_AT_COVER}, false, false},
    {"tall-grid", "strips", 3, {ASK_STRIPS_BUILD, 40, 9, LOOK_AT_COVER}, false, false},
    {"one-column", "strips", 4, {ASK_STRIPS_BUILD, 6, 1, LOOK_AT_COVER}, false, false},
    {"very-wide-grid", "strips", 5, {ASK_STRIPS_BUILD, 2, 5000, LOOK_AT_COVER}, false, false},
    {"course-figure-winding", "winding", 6, {ASK_STRIPS_BUILD, 4, 8, LOOK_AT_WINDING}, true, true},
    {"tall-grid-winding", "winding", 7, {ASK_STRIPS_BUILD, 40, 9, LOOK_AT_WINDING}, false, false},
    {"one-column-winding", "winding", 8, {ASK_STRIPS_BUILD, 6, 1, LOOK_AT_WINDING}, false, false},
    {"one-cell", "smallest", 9, {ASK_STRIPS_BUILD, 1, 1, SHAPE}, true, true},
    {"one-row", "smallest", 10, {ASK_STRIPS_BUILD, 1, 6, SHAPE}, false, false},
    {"memory-of-8", "measured-memory", 11, {ASK_STRIPS_BUILD, 8, 8, LOOK_AT_MEMORY}, true, true},
    {"memory-of-23",
     "measured-memory",
     12,
     {ASK_STRIPS_BUILD, 23, 23, LOOK_AT_MEMORY},
     false,
     false},
    {"memory-of-128",
     "measured-memory",
     13,
     {ASK_STRIPS_BUILD, 128, 128, LOOK_AT_MEMORY},
     false,
     false},
    {"bytes-of-course-figure", "formula", 14, {ASK_STRIPS_BYTES, 0, 0, 0}, true, true},
    {"bytes-of-many", "formula", 15, {ASK_STRIPS_BYTES, 1, 0, 0}, false, true},
    {"bytes-of-large", "formula-large", 16, {ASK_STRIPS_BYTES, 2, 0, 0}, false, true},
    {"kilobytes-of-128", "kilobytes", 17, {ASK_STRIPS_KILOBYTES, 0, 0, 0}, true, true},
    {"processed-in-course-figure",
     "vertices-processed",
     18,
     {ASK_STRIPS_PROCESSED, 0, 0, 0},
     true,
     true},
    {"processed-in-many", "vertices-processed", 19, {ASK_STRIPS_PROCESSED, 1, 0, 0}, false, true},
    {"processed-in-built",
     "vertices-processed",
     20,
     {ASK_STRIPS_BUILD, 9, 14, LOOK_AT_PROCESSED},
     false,
     false},
    {"limit-of-memory", "limits", 21, {ASK_STRIPS_MEMORY_RATIO, 0, 0, 0}, true, true},
    {"limit-of-time", "limits", 22, {ASK_STRIPS_TIME_RATIO, 0, 0, 0}, true, true}};

static bool asks_rows(int64_t question)
{
    return question == ASK_STRIPS_BYTES || question == ASK_STRIPS_PROCESSED;
}

static void write_build(struct writer *input, int64_t m, int64_t n, int64_t aspect)
{
    write_int(input, ASK_STRIPS_BUILD);
    write_int(input, m);
    write_int(input, n);
    write_int(input, aspect);
}

static int make(const struct judge_case *c, const char *models, struct writer *input,
                struct error *err)
{
    (void)models;
    if (c->parameter[0] == ASK_STRIPS_BUILD) {
        write_build(input, c->parameter[1], c->parameter[2], c->parameter[3]);
    } else {
        write_int(input, c->parameter[0]);
        if (asks_rows(c->parameter[0])) {
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

/* ------------------------------------------------------------- built strips */

/* Built strips as the answer tells them; each strip is borrowed from the packet. */
struct built {
    int32_t m, n;
    int64_t own_bytes, own_processed, strip_count, vertices_per_strip;
    const float **strips; /* m of them, owned; NULL until all counts are right */
    int32_t first_shown;  /* SHOWN_STRIP_LIMIT strips from this one on are in the picture */
};

static void reject_malformed(struct judgement *out)
{
    judge_reject(out, "malformed-answer", "The answer is incomplete.",
                 "La respuesta está incompleta.");
}

/* Reads the strips themselves. Returns whether every strip is there. */
static bool read_strips(struct reader *answer, struct built *built, struct judgement *out)
{
    int64_t kept = read_int(answer);
    if (!answer->failed && kept != built->m) {
        judge_reject(out, "table-missing", "The table of strips is NULL.",
                     "La tabla de tiras es NULL.");
        return false;
    }
    for (int32_t i = 0; i < built->m; i++) {
        int64_t count;
        built->strips[i] = read_table(answer, &count, 3 * sizeof(float));
        if (answer->failed || (built->strips[i] && count != built->vertices_per_strip)) {
            reject_malformed(out);
            return false;
        }
        if (!built->strips[i]) {
            judge_name_element(out, "strip %d", i);
            judge_reject(out, "strip-missing", "Strip %d is NULL.", "La tira %d es NULL.", i);
            return false;
        }
    }
    return true;
}

/* Reads and checks the counts. Returns whether the strips can be looked at. */
static bool read_counts(struct reader *answer, struct built *built, struct judgement *out)
{
    int64_t status = read_int(answer);
    if (!answer->failed && status != 0) {
        judge_reject(out, "unknown-status", "The builder returned %" PRId64 ", not 0.",
                     "El constructor ha devuelto %" PRId64 ", no 0.", status);
        return false;
    }
    built->own_bytes = read_int(answer);
    built->own_processed = read_int(answer);
    built->vertices_per_strip = read_int(answer);
    built->strip_count = read_int(answer);
    int64_t vertex_count = 2 * ((int64_t)built->n + 1);
    if (answer->failed)
        reject_malformed(out);
    else if (built->strip_count != built->m)
        judge_reject(out, "strip-count",
                     "strip_count is %" PRId64 "; there must be %d strips, one a row.",
                     "strip_count es %" PRId64 "; tiene que haber %d tiras, una por fila.",
                     built->strip_count, built->m);
    else if (built->vertices_per_strip != vertex_count)
        judge_reject(out, "vertices-per-strip",
                     "vertices_per_strip is %" PRId64 "; a strip of %d triangles has %" PRId64
                     " vertices.",
                     "vertices_per_strip es %" PRId64 "; una tira de %d triángulos tiene %" PRId64
                     " vértices.",
                     built->vertices_per_strip, 2 * built->n, vertex_count);
    return !out->cause[0];
}

/* --------------------------------------------------------------------- shape */

/* The three corners of triangle i of a strip, as places among its vertices, in drawing order. */
static void corners_of(int32_t i, int32_t corner[3])
{
    corner[0] = i % 2 == 0 ? i : i + 1;
    corner[1] = i % 2 == 0 ? i + 1 : i;
    corner[2] = i + 2;
}

/* The first fault decides which strips the picture shows, when it cannot show all. */
static void show_around(struct built *built, int32_t strip)
{
    int32_t last = built->m - SHOWN_STRIP_LIMIT;
    built->first_shown = strip < SHOWN_STRIP_LIMIT ? 0 : strip < last ? strip : last;
}

/* The number of a strip's vertex in the scene's mesh, -1 when the strip is not shown. */
static int32_t shown_vertex(const struct built *built, int32_t strip, int32_t vertex)
{
    int32_t place = strip - built->first_shown;
    bool is_shown = place >= 0 && place < SHOWN_STRIP_LIMIT;
    return is_shown ? place * (int32_t)built->vertices_per_strip + vertex : -1;
}

/* A vertex that is no lattice point is rejected. */
static void judge_place(const struct lattice *lattice, struct built *built, int32_t strip,
                        int32_t vertex, struct judgement *out)
{
    const float *p = built->strips[strip] + 3 * (int64_t)vertex;
    int32_t point = lattice_nearest(lattice, p);
    if (point >= 0 && lattice_is_at(lattice, point, p, PLACE_TOLERANCE))
        return;
    judge_name_element(out, "strip %d, vertex %d (%.6g, %.6g, %.6g)", strip, vertex, (double)p[0],
                       (double)p[1], (double)p[2]);
    show_around(built, strip);
    scene_mark_vertex(&out->scene, MARK_WRONG, shown_vertex(built, strip, vertex));
    judge_reject(
        out, "vertex-off-grid",
        "Vertex %d of strip %d is at (%.6g, %.6g, %.6g), which is not within 0.00001 of a place"
        " x = column / %d, y = row / %d, z = 0.",
        "El vértice %d de la tira %d está en (%.6g, %.6g, %.6g), que no está a menos de 0.00001"
        " de un punto x = columna / %d, y = fila / %d, z = 0.",
        vertex, strip, (double)p[0], (double)p[1], (double)p[2], built->n, built->m);
}

static void reject_triangle(enum lattice_fit fit, int32_t strip, int32_t triangle,
                            struct judgement *out)
{
    static const struct {
        const char *cause, *text, *text_es;
    } faults[] = {[LATTICE_HALF] = {"strip-leaves-row", "is in another row than the strip's first.",
                                    "está en otra fila que el primero de la tira."},
                  [LATTICE_HALF_FLIPPED] = {"triangle-flipped",
                                            "is clockwise seen from above; all must be"
                                            " counter-clockwise (odd ones change their first two).",
                                            "va en sentido horario visto desde arriba; todos van en"
                                            " antihorario (los impares cambian sus dos primeros)."},
                  [LATTICE_REPEATED] = {"triangle-repeated", "covers what an earlier one covers.",
                                        "cubre lo mismo que otro anterior."},
                  [LATTICE_CROSSED] = {"triangles-overlap",
                                       "overlaps an earlier one: both diagonals cut its cell.",
                                       "se solapa con otro: las dos diagonales parten su celda."},
                  [LATTICE_OUTSIDE] = {"triangle-not-in-cell", "is not half of one cell.",
                                       "no es la mitad de una celda."}};
    judge_name_element(out, "strip %d, triangle %d", strip, triangle);
    judge_reject(out, faults[fit].cause,
                 "Triangle %d of strip %d (vertices %d, %d, %d of it) %s%.0s",
                 "El triángulo %d de la tira %d (sus vértices %d, %d, %d) %.0s%s", triangle, strip,
                 triangle, triangle + 1, triangle + 2, faults[fit].text, faults[fit].text_es);
}

static enum mark_kind mark_of(enum lattice_fit fit)
{
    if (fit == LATTICE_HALF_FLIPPED)
        return MARK_FLIPPED;
    return fit == LATTICE_REPEATED ? MARK_DUPLICATE : MARK_WRONG;
}

/* Adds a strip's triangles to the lattice; the first fault is named, all are marked. */
static void judge_strip(struct lattice *lattice, struct built *built, int32_t strip, int64_t aspect,
                        struct judgement *out)
{
    int32_t vertex_count = (int32_t)built->vertices_per_strip;
    int32_t strip_row = -1;
    for (int32_t v = 0; v < vertex_count && (aspect & LOOK_AT_COVER) && !out->cause[0]; v++)
        judge_place(lattice, built, strip, v, out);
    for (int32_t i = 0; i + 2 < vertex_count; i++) {
        int32_t corner[3], point[3], cell;
        corners_of(i, corner);
        for (int j = 0; j < 3; j++)
            point[j] = lattice_nearest(lattice, built->strips[strip] + 3 * (int64_t)corner[j]);
        enum lattice_fit fit = lattice_add(lattice, point[0], point[1], point[2], &cell);
        int32_t row = cell < 0 ? -1 : cell / built->n;
        if (strip_row < 0)
            strip_row = row;
        bool turned = fit == LATTICE_HALF_FLIPPED && (aspect & LOOK_AT_WINDING);
        bool misplaced = fit > LATTICE_HALF_FLIPPED || row != strip_row;
        if (!turned && !misplaced) {
            out->scene.ok_count++;
            continue;
        }
        if (!turned && fit == LATTICE_HALF_FLIPPED)
            fit = LATTICE_HALF; /* it only leaves the row */
        if (!out->cause[0]) {
            reject_triangle(fit, strip, i, out);
            show_around(built, strip);
        }
        scene_mark_triangle(&out->scene, mark_of(fit), shown_vertex(built, strip, corner[0]),
                            shown_vertex(built, strip, corner[1]),
                            shown_vertex(built, strip, corner[2]));
    }
}

/* The strips, and the mesh that the marks speak of: all strips' vertices one after the other, and
 * the triangles as they are decoded. */
static int show_strips(const struct built *built, struct scene *scene, struct error *err)
{
    int64_t per_strip = built->vertices_per_strip;
    int32_t shown = built->m < SHOWN_STRIP_LIMIT ? built->m : SHOWN_STRIP_LIMIT;
    struct mesh mesh;
    if (mesh_init(&mesh, per_strip * shown, (per_strip - 2) * shown, err))
        return -1;
    int failed = 0;
    int32_t *triangle = mesh.triangles;
    for (int32_t s = 0; s < shown && !failed; s++) {
        const float *positions = built->strips[built->first_shown + s];
        for (int64_t i = 0; i < 3 * per_strip; i++)
            mesh.positions[3 * per_strip * s + i] = positions[i];
        for (int32_t i = 0; i < per_strip - 2; i++, triangle += 3) {
            corners_of(i, triangle);
            for (int j = 0; j < 3; j++)
                triangle[j] += s * (int32_t)per_strip;
        }
        failed = show_strip(scene, positions, per_strip, err);
    }
    if (!failed)
        failed = show_mesh(scene, mesh.positions, mesh.vertex_count, mesh.triangles,
                           mesh.triangle_count, err);
    mesh_release(&mesh);
    return failed;
}

static int judge_shape(struct built *built, int64_t aspect, struct judgement *out,
                       struct error *err)
{
    struct lattice lattice;
    if (lattice_init(&lattice, built->m, built->n, err))
        return -1;
    for (int32_t s = 0; s < built->m; s++)
        judge_strip(&lattice, built, s, aspect, out);
    int32_t bare = lattice_first_uncovered(&lattice);
    if (!out->cause[0] && bare >= 0) {
        judge_name_element(out, "cell row %d, column %d", bare / built->n, bare % built->n);
        judge_reject(out, "cell-uncovered", "The cell of row %d, column %d is not covered.",
                     "La celda de la fila %d, columna %d no está cubierta.", bare / built->n,
                     bare % built->n);
    }
    lattice_release(&lattice);
    if (out->cause[0])
        return show_strips(built, &out->scene, err);
    judge_accept(out);
    return 0;
}

/* -------------------------------------------------------------------- judge */

static int judge_built(struct built *built, int64_t aspect, const struct usage *usage,
                       struct judgement *out, struct error *err)
{
    if (aspect & LOOK_AT_MEMORY) {
        struct size_claim claim = {"strips_build", "strips_bytes", COUNT_BYTES, built->own_bytes,
                                   right_bytes(built->m, built->n)};
        size_judge(&claim, usage, out);
        return 0;
    }
    if (aspect & LOOK_AT_PROCESSED) {
        int64_t present = built->strip_count * built->vertices_per_strip;
        if (built->own_processed == present)
            judge_accept(out);
        else
            judge_reject(out, "processed-differs",
                         "strips_processed_vertices says %" PRId64
                         ", but the strips that were built"
                         " hold %" PRId64 " vertices.",
                         "strips_processed_vertices dice %" PRId64 ", pero las tiras construidas"
                         " tienen %" PRId64 " vértices.",
                         built->own_processed, present);
        return 0;
    }
    return judge_shape(built, aspect, out, err);
}

static int judge_build(struct reader *input, struct reader *answer, const struct usage *usage,
                       struct judgement *out, struct error *err)
{
    struct built built = {0};
    built.m = (int32_t)read_int(input);
    built.n = (int32_t)read_int(input);
    int64_t aspect = read_int(input);
    built.strips = calloc((size_t)built.m + 1, sizeof *built.strips);
    if (!built.strips)
        return error_set(err, "out of memory for %d strips", built.m);
    int failed = 0;
    if (read_counts(answer, &built, out) && read_strips(answer, &built, out))
        failed = judge_built(&built, aspect, usage, out, err);
    free(built.strips);
    return failed;
}

static int judge_rows(int64_t question, struct reader *input, struct reader *answer,
                      struct judgement *out, struct error *err)
{
    int64_t row_count = read_int(input);
    const int32_t *rows = read_array(input, row_count, 2 * sizeof *rows);
    const int64_t *first = read_array(answer, row_count, sizeof *first);
    bool has_second = question == ASK_STRIPS_PROCESSED;
    const int64_t *second = has_second ? read_array(answer, row_count, sizeof *second) : NULL;
    if (!rows)
        return error_set(err, "the input of memory-strips is broken");
    if (!first || (has_second && !second)) {
        reject_malformed(out);
        return 0;
    }
    if (!has_second)
        return formula_judge(&bytes_formula, rows, row_count, first, out, err);
    if (formula_judge(&strips_processed, rows, row_count, first, out, err))
        return -1;
    return out->cause[0] ? 0 : formula_judge(&indexed_processed, rows, row_count, second, out, err);
}

static int judge(struct span input, struct span answer, const struct usage *usage,
                 struct judgement *out, struct error *err)
{
    struct reader in = reader_of(input.bytes, input.count);
    struct reader said = reader_of(answer.bytes, answer.count);
    int64_t question = read_int(&in);
    if (asks_rows(question))
        return judge_rows(question, &in, &said, out, err);
    if (question == ASK_STRIPS_BUILD)
        return judge_build(&in, &said, usage, out, err);
    double value = read_real(&said);
    const struct number *number = question == ASK_STRIPS_KILOBYTES      ? &kilobytes
                                  : question == ASK_STRIPS_MEMORY_RATIO ? &memory_ratio
                                                                        : &time_ratio;
    number_judge(number, said.failed ? (double)NAN : value, out);
    return 0;
}

static size_t answer_bound(struct span input)
{
    struct reader in = reader_of(input.bytes, input.count);
    int64_t question = read_int(&in);
    int64_t first = read_int(&in);
    int64_t second = read_int(&in);
    if (question == ASK_STRIPS_BUILD) /* a strip takes up to 24 bytes beside its vertices */
        return (size_t)(right_bytes(first, second) + 24 * first) + 64;
    return asks_rows(question) ? 2 * sizeof(int64_t) * (size_t)first : sizeof(double);
}

const struct judge judge_memory_strips = {.exercise = "memory-strips",
                                          .cases = cases,
                                          .case_count = sizeof cases / sizeof *cases,
                                          .make = make,
                                          .families = families,
                                          .make_sized = make_sized,
                                          .judge = judge,
                                          .answer_bound = answer_bound};
