/* Problem 4.6: the area of a mesh.
 *
 * An answer is right when it differs from the exact area by no more than 10^-6 of it; the
 * comparison is written so that NaN fails it. A wrong answer is compared with what the usual
 * mistakes give on the same mesh, and the one that fits is named.
 *
 * Classes are pure: only the tori of `closed` have more than 2 (V - 2) triangles, only `open` has
 * odd numbers of them (and `single-triangle`), only `many-triangles` has more than 400. */
#include "graders/library/mesh_area.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

enum { HIDDEN = false, PUBLIC = true, QUICK = true, FULL = false };
enum { LARGE_GRID = 1000 }; /* a shape of this exercise alone: a rows, b columns, b odd */
enum { SHOWN_TRIANGLES = 1000000 };

static const double ALLOWED = 1e-6;

static const char CLOSED[] = "closed";
static const char SINGLE[] = "single-triangle";
static const char OPEN[] = "open";
static const char FLIPS[] = "orientation";
static const char FLAT[] = "degenerate";
static const char NEEDLES[] = "needles";
static const char DISTANT[] = "far-from-origin";
static const char SCALE[] = "scale";
static const char MANY[] = "many-triangles";
static const char EMPTY[] = "empty";

static const struct judge_case cases[] = {
    {"tetrahedron", CLOSED, 1, {SHAPE_TETRAHEDRON}, PUBLIC, QUICK},
    {"cube", CLOSED, 2, {SHAPE_CUBE}, PUBLIC, QUICK},
    {"icosphere", CLOSED, 3, {SHAPE_ICO, 2, 0, TILTED | SCRAMBLED}, HIDDEN, QUICK},
    {"torus", CLOSED, 4, {SHAPE_TORUS, 1, 300, TILTED | SCRAMBLED}, HIDDEN, QUICK},
    {"torus-genus-2", CLOSED, 5, {SHAPE_TORUS, 2, 400, SCRAMBLED}, HIDDEN, FULL},

    {"one-triangle", SINGLE, 11, {SHAPE_ONE_TRIANGLE}, PUBLIC, QUICK},
    {"one-triangle-tilted", SINGLE, 12, {SHAPE_ONE_TRIANGLE, 0, 0, TILTED}, HIDDEN, QUICK},

    {"grid", OPEN, 21, {SHAPE_GRID, 4, 8}, PUBLIC, QUICK},
    {"fan", OPEN, 22, {SHAPE_FAN, 7, 0, TILTED}, PUBLIC, QUICK},
    {"disc", OPEN, 23, {SHAPE_DISC, 8, 11, TILTED | SCRAMBLED}, HIDDEN, QUICK},

    {"cube-flipped", FLIPS, 31, {SHAPE_CUBE, 0, 0, FLIPPED}, PUBLIC, QUICK},
    {"grid-flipped", FLIPS, 32, {SHAPE_GRID, 10, 12, FLIPPED | SCRAMBLED}, HIDDEN, QUICK},
    {"moebius-strip", FLIPS, 33, {SHAPE_MOEBIUS, 30, 0, FLIPPED | SCRAMBLED}, HIDDEN, QUICK},

    {"cube-repeated", FLAT, 41, {SHAPE_CUBE, 0, 0, WITH_DEGENERATE | WITH_SPIKES}, PUBLIC, QUICK},
    {"icosphere-repeated", FLAT, 42, {SHAPE_ICO, 2, 0, WITH_DEGENERATE}, HIDDEN, FULL},
    {"cube-collinear", FLAT, 43, {SHAPE_CUBE, 0, 0, WITH_COLLINEAR}, HIDDEN, QUICK},
    {"icosphere-collinear", FLAT, 44, {SHAPE_ICO, 2, 0, WITH_COLLINEAR | TILTED}, HIDDEN, FULL},
    {"only-points", FLAT, 45, {SHAPE_POINT_TRIANGLES, 6}, HIDDEN, QUICK},

    {"needles-1000", NEEDLES, 51, {SHAPE_NEEDLES, 200, 3, TILTED}, PUBLIC, QUICK},
    {"needles-1000000", NEEDLES, 52, {SHAPE_NEEDLES, 200, 6, TILTED}, HIDDEN, QUICK},
    {"long-needles", NEEDLES, 53, {SHAPE_NEEDLES, 8, 6, TILTED}, HIDDEN, QUICK},

    {"icosphere-far", DISTANT, 61, {SHAPE_ICO, 2, 0, FAR}, PUBLIC, QUICK},
    {"grid-far", DISTANT, 62, {SHAPE_GRID, 10, 12, FAR | SCRAMBLED}, HIDDEN, QUICK},

    {"icosphere-tiny", SCALE, 71, {SHAPE_ICO, 2, 0, TINY | TILTED}, PUBLIC, QUICK},
    {"icosphere-huge", SCALE, 72, {SHAPE_ICO, 2, 0, HUGE_SIZE | TILTED}, HIDDEN, QUICK},

    {"nothing", EMPTY, 91, {SHAPE_EMPTY}, PUBLIC, QUICK},
    {"only-vertices", EMPTY, 92, {SHAPE_ISOLATED, 7}, HIDDEN, QUICK},

    /* Last, because cases after two that do not end in time are not run. */
    {"bunny", MANY, 84, {SHAPE_BUNNY}, PUBLIC, QUICK},
    {"horse", MANY, 85, {SHAPE_HORSE, 0, 0, SCRAMBLED}, HIDDEN, FULL},
    {"100000-triangles", MANY, 81, {SHAPE_GRID, 250, 200, SCRAMBLED}, HIDDEN, QUICK},
    {"1000000-triangles", MANY, 82, {SHAPE_UV_SPHERE, 1000, 500}, HIDDEN, FULL},
    {"10000000-triangles", MANY, 83, {LARGE_GRID, 1600, 3125}, HIDDEN, FULL},
};

/* --------------------------------------------------------------------------------------- inputs */

static float wave(int64_t step, int64_t steps)
{
    return 0.08F * (float)sin(6 * (double)step / (double)steps);
}

static void write_grid_vertices(struct writer *input, int64_t row, int64_t rows, int64_t columns)
{
    enum { ROOM = 64 };
    float positions[3 * ROOM];
    int64_t filled = 0;
    for (int64_t c = 0; c <= columns; c++) {
        positions[3 * filled] = (float)((double)c / (double)columns - 0.5);
        positions[3 * filled + 1] = (float)((double)row / (double)rows - 0.5);
        positions[3 * filled + 2] = wave(c, columns) + wave(row, rows);
        if (++filled == ROOM || c == columns) {
            write_array(input, positions, filled, 3 * sizeof(float));
            filled = 0;
        }
    }
}

static void write_grid_triangles(struct writer *input, int64_t row, int64_t columns)
{
    for (int64_t c = 0; c < columns; c++) {
        int32_t low = (int32_t)(row * (columns + 1) + c), high = low + (int32_t)columns + 1;
        int32_t pair[6] = {low, low + 1, high + 1, low, high + 1, high};
        write_array(input, pair, 2, 3 * sizeof(int32_t));
    }
}

/* The packet of a grid, without the mesh beside it: ten million triangles take 180 MB once. All
 * pieces but the last of each table are multiples of 8 bytes, so that no padding comes between;
 * `columns` must be odd. */
static int write_large_grid(int64_t rows, int64_t columns, struct writer *input, struct error *err)
{
    write_int(input, (rows + 1) * (columns + 1));
    write_int(input, 2 * rows * columns);
    for (int64_t row = 0; row <= rows; row++)
        write_grid_vertices(input, row, rows, columns);
    for (int64_t row = 0; row < rows; row++)
        write_grid_triangles(input, row, columns);
    if (input->failed)
        return error_set(err, "out of memory: a grid of %" PRId64 " by %" PRId64 " cells", rows,
                         columns);
    return 0;
}

static int make(const struct judge_case *c, const char *models, struct writer *input,
                struct error *err)
{
    if (c->parameter[0] == LARGE_GRID)
        return write_large_grid(c->parameter[1], c->parameter[2], input, err);
    return mesh_case_write_input(c, models, input, err);
}

static const char *const families[] = {"grid-scrambled", "sphere-scrambled", NULL};

enum { FAMILY_WIDTH = 8 };

static int make_sized(int family, int64_t size, uint64_t seed, struct writer *input,
                      struct error *err)
{
    int64_t length = size / 2 / FAMILY_WIDTH;
    const struct judge_case of_family[] = {
        {.seed = seed, .parameter = {SHAPE_GRID, length, FAMILY_WIDTH, SCRAMBLED}},
        {.seed = seed, .parameter = {SHAPE_UV_SPHERE, FAMILY_WIDTH, length, SCRAMBLED}},
    };
    return mesh_case_write_input(&of_family[family], NULL, input, err);
}

/* ---------------------------------------------------------------------------------------- hints */

static bool is_close(double value, double wanted)
{
    return fabs(value - wanted) <= ALLOWED * fabs(wanted);
}

struct guess {
    double value; /* what the mistake gives on this mesh */
    const char *english, *spanish;
};

/* The mistake whose result the area is; empty sentences when it is none of them. A mistake that
 * this mesh does not show is no guess. */
static struct guess guess_mistake(const struct area_sums *sums, int32_t triangle_count, double area)
{
    const struct guess guesses[] = {
        {2 * sums->exact, " It is twice the area: half of the cross product's length is the area.",
         " Es el doble del área: el área es la mitad de la longitud del producto vectorial."},
        {sums->exact / 2, " It is half of the area.", " Es la mitad del área."},
        {-sums->exact, " It is the area with its sign reversed.",
         " Es el área con el signo cambiado."},
        {sums->exact / triangle_count, " It is the mean area of a triangle, not the sum.",
         " Es el área media de un triángulo, no la suma."},
        {sums->squares, " The square root of the cross product's squared length is missing.",
         " Falta la raíz cuadrada del cuadrado de la longitud del producto vectorial."},
        {sums->squares / 2, " The square root of the cross product's squared length is missing.",
         " Falta la raíz cuadrada del cuadrado de la longitud del producto vectorial."},
        {sums->without_last, " The last triangle is missing: does the loop stop one too early?",
         " Falta el último triángulo: ¿acaba el bucle uno antes de tiempo?"},
        {sums->without_first, " The first triangle is missing.", " Falta el primer triángulo."},
        {sums->vector,
         " The cross products were added as vectors: triangles that face opposite ways cancel.",
         " Se sumaron los productos como vectores: los triángulos de caras opuestas se anulan."},
        {sums->facing_up, " Only triangles that face upwards (z) are counted.",
         " Solo se cuentan los triángulos que miran hacia arriba (z)."},
        {sums->seen_from_z, " It is the area of the projection onto the plane z = 0.",
         " Es el área de la proyección sobre el plano z = 0."},
        {sums->by_float, " The sum is kept in a float: with this many terms its 24 bits run out.",
         " La suma se guarda en un float: con tantos términos sus 24 bits no bastan."},
        {sums->all_float, " Everything is computed in float; 24 bits do not suffice here.",
         " Todo se calcula en float; aquí no bastan 24 bits."},
        {sums->absolute_float,
         " Products of positions are taken in float: subtract positions first, and in double.",
         " Se multiplican posiciones en float: hay que restarlas antes, y en double."},
    };
    if (is_close(area, sums->exact / 2) && is_close(area, sums->facing_up))
        return (struct guess){
            sums->facing_up,
            " It is half of the area, which is that of the triangles facing upwards (z).",
            " Es la mitad del área, que es la de los triángulos que miran hacia arriba (z)."};
    for (size_t i = 0; i < sizeof guesses / sizeof *guesses; i++) {
        double value = guesses[i].value;
        bool is_told_apart =
            isfinite(value) && fabs(value) > ALLOWED * sums->exact && !is_close(value, sums->exact);
        if (is_told_apart && is_close(area, value))
            return guesses[i];
    }
    return (struct guess){0, "", ""};
}

/* -------------------------------------------------------------------------------------- judging */

static int show_triangle(const struct mesh_view *view, enum mark_kind kind, int32_t triangle,
                         struct judgement *out, struct error *err)
{
    const int32_t *v = view->triangles + 3 * (int64_t)triangle;
    judge_name_element(out, "triangle %d (%d,%d,%d)", triangle, v[0], v[1], v[2]);
    if (mesh_case_show(view, &out->scene, err))
        return -1;
    scene_mark_triangle(&out->scene, kind, v[0], v[1], v[2]);
    return 0;
}

/* Shows the mesh with both areas in the legend. What is not counted is marked, when that is known
 * (facing_up); else the triangles without area. */
static int show_area(const struct mesh_view *view, double exact, double area, bool facing_up,
                     struct scene *scene, struct error *err)
{
    char text[32];
    int64_t counted = 0;
    if (view->triangle_count == 0 || view->triangle_count > SHOWN_TRIANGLES)
        return 0;
    if (mesh_case_show(view, scene, err))
        return -1;
    for (int32_t t = 0; t < view->triangle_count; t++) {
        const int32_t *v = view->triangles + 3 * (int64_t)t;
        enum area_facing facing = mesh_area_facing(view, t);
        counted += facing == AREA_UPWARDS;
        if (facing_up && facing == AREA_NOT_UPWARDS)
            scene_mark_triangle(scene, MARK_MISSING, v[0], v[1], v[2]);
        if (!facing_up && facing == AREA_FLAT)
            scene_mark_triangle(scene, MARK_DEGENERATE, v[0], v[1], v[2]);
    }
    scene->ok_count = facing_up ? counted : -1;
    snprintf(text, sizeof text, "%.6g", exact);
    scene_add_fact(scene, "expected area", text);
    snprintf(text, sizeof text, "%.6g", area);
    scene_add_fact(scene, "answered", text);
    return 0;
}

static int reject_not_finite(const struct mesh_view *view, const struct area_sums *sums,
                             double area, struct judgement *out, struct error *err)
{
    const char *kind = isnan(area) ? "NaN" : "infinity";
    const char *kind_es = isnan(area) ? "NaN" : "infinito";
    if (sums->first_flat < 0) {
        judge_reject(out, "not-a-number", "the area is %s%.0s instead of %.9g.",
                     "el área es %.0s%s en lugar de %.9g.", kind, kind_es, sums->exact);
        return 0;
    }
    judge_reject(out, "not-a-number",
                 "the area is %s%.0s instead of %.9g. Triangle %d has area 0: is something divided "
                 "by a length of 0, or a root taken of a number below 0?",
                 "el área es %.0s%s en lugar de %.9g. El triángulo %d tiene área 0: ¿se divide por "
                 "una longitud 0, o se toma la raíz de un número negativo?",
                 kind, kind_es, sums->exact, sums->first_flat);
    return show_triangle(view, MARK_DEGENERATE, sums->first_flat, out, err);
}

static int reject_area(const struct mesh_view *view, double area, struct judgement *out,
                       struct error *err)
{
    struct area_sums sums = mesh_area_sums(view);
    if (!isfinite(area))
        return reject_not_finite(view, &sums, area, out, err);
    struct guess guess = guess_mistake(&sums, view->triangle_count, area);
    double error = sums.exact > 0 ? fabs(area - sums.exact) / sums.exact : HUGE_VAL;
    judge_name_element(out, "total area");
    if (sums.exact > 0)
        judge_reject(
            out, area < 0 ? "negative-area" : "wrong-area",
            "the area is %.9g instead of %.9g: relative error %.2g, allowed 1e-06.%s%.0s",
            "el área es %.9g en lugar de %.9g: error relativo %.2g, permitido 1e-06.%.0s%s", area,
            sums.exact, error, guess.english, guess.spanish);
    else
        judge_reject(out, "wrong-area", "the area is %.9g, but there is no area: it must be 0",
                     "el área es %.9g, pero no hay área ninguna: debe ser 0", area);
    if (view->triangle_count > 0 && guess.value == sums.without_last)
        return show_triangle(view, MARK_MISSING, view->triangle_count - 1, out, err);
    if (view->triangle_count > 0 && guess.value == sums.without_first)
        return show_triangle(view, MARK_MISSING, 0, out, err);
    bool facing_up = guess.english[0] && guess.value == sums.facing_up;
    return show_area(view, sums.exact, area, facing_up, &out->scene, err);
}

static int judge_area(struct span input, struct span answer, const struct usage *usage,
                      struct judgement *out, struct error *err)
{
    (void)usage;
    struct mesh_view view = mesh_case_read(input);
    struct reader reader = reader_of(answer.bytes, answer.count);
    double area = read_real(&reader);
    out->scene.ok_count = -1;
    if (reader.failed) {
        judge_reject(out, "malformed-answer", "the answer is not a number",
                     "la respuesta no es un número");
        return 0;
    }
    double exact = mesh_area_exact(&view);
    if (fabs(area - exact) <= ALLOWED * exact) {
        judge_accept(out);
        return 0;
    }
    return reject_area(&view, area, out, err);
}

static size_t answer_bound(struct span input)
{
    (void)input;
    return sizeof(double);
}

const struct judge judge_mesh_area = {
    .exercise = "mesh-area",
    .cases = cases,
    .case_count = sizeof cases / sizeof *cases,
    .make = make,
    .families = families,
    .make_sized = make_sized,
    .answers_reals = true,
    .judge = judge_area,
    .answer_bound = answer_bound,
};
