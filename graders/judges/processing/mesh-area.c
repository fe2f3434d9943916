/* Problem 4.6: the area of a mesh.
 *
 * An answer is right when it differs from the exact area by no more than 10^-6 of it; the
 * comparison is written so that NaN fails it. A wrong answer is compared with what the usual
 * mistakes give on the same mesh, and the one that fits is named.
 *
 * Classes are pure: only the tori of `closed` have more than 2 (V - 2) triangles, only `open` has
 * odd numbers of them (and `single-triangle`), only `many-triangles` has more than 400. */
#include "graders/library/judge.h"
#include "graders/library/mesh_area.h"

#include <math.h>
#include <stdio.h>

enum { SHOWN_TRIANGLES = 1000000 };

static const double ALLOWED = 1e-6;

static const struct judge_case cases[] = {
    {"tetrahedron", "closed", 1, PUBLIC | QUICK, .mesh = {SHAPE_TETRAHEDRON}},
    {"cube", "closed", 2, PUBLIC | QUICK, .mesh = {SHAPE_CUBE}},
    {"icosphere", "closed", 3, QUICK,
     .mesh = {SHAPE_ICO, .levels = 2, .changes = TILTED | SCRAMBLED}},
    {"torus", "closed", 4, QUICK,
     .mesh = {SHAPE_TORUS, .genus = 1, .triangles = 300, .changes = TILTED | SCRAMBLED}},
    {"torus-genus-2", "closed", 5, HIDDEN,
     .mesh = {SHAPE_TORUS, .genus = 2, .triangles = 400, .changes = SCRAMBLED}},

    {"one-triangle", "single-triangle", 11, PUBLIC | QUICK, .mesh = {SHAPE_ONE_TRIANGLE}},
    {"one-triangle-tilted", "single-triangle", 12, QUICK,
     .mesh = {SHAPE_ONE_TRIANGLE, .changes = TILTED}},

    {"grid", "open", 21, PUBLIC | QUICK, .mesh = {SHAPE_GRID, .rows = 4, .columns = 8}},
    {"fan", "open", 22, PUBLIC | QUICK, .mesh = {SHAPE_FAN, .count = 7, .changes = TILTED}},
    {"disc", "open", 23, QUICK,
     .mesh = {SHAPE_DISC, .rings = 8, .sectors = 11, .changes = TILTED | SCRAMBLED}},

    {"cube-flipped", "orientation", 31, PUBLIC | QUICK, .mesh = {SHAPE_CUBE, .changes = FLIPPED}},
    {"grid-flipped", "orientation", 32, QUICK,
     .mesh = {SHAPE_GRID, .rows = 10, .columns = 12, .changes = FLIPPED | SCRAMBLED}},
    {"moebius-strip", "orientation", 33, QUICK,
     .mesh = {SHAPE_MOEBIUS, .count = 30, .changes = FLIPPED | SCRAMBLED}},

    {"cube-repeated", "degenerate", 41, PUBLIC | QUICK,
     .mesh = {SHAPE_CUBE, .changes = WITH_DEGENERATE | WITH_SPIKES}},
    {"icosphere-repeated", "degenerate", 42, HIDDEN,
     .mesh = {SHAPE_ICO, .levels = 2, .changes = WITH_DEGENERATE}},
    {"cube-collinear", "degenerate", 43, QUICK, .mesh = {SHAPE_CUBE, .changes = WITH_COLLINEAR}},
    {"icosphere-collinear", "degenerate", 44, HIDDEN,
     .mesh = {SHAPE_ICO, .levels = 2, .changes = WITH_COLLINEAR | TILTED}},
    {"only-points", "degenerate", 45, QUICK, .mesh = {SHAPE_POINT_TRIANGLES, .count = 6}},

    {"needles-1000", "needles", 51, PUBLIC | QUICK,
     .mesh = {SHAPE_NEEDLES, .count = 200, .exponent = 3, .changes = TILTED}},
    {"needles-1000000", "needles", 52, QUICK,
     .mesh = {SHAPE_NEEDLES, .count = 200, .exponent = 6, .changes = TILTED}},
    {"long-needles", "needles", 53, QUICK,
     .mesh = {SHAPE_NEEDLES, .count = 8, .exponent = 6, .changes = TILTED}},

    {"icosphere-far", "far-from-origin", 61, PUBLIC | QUICK,
     .mesh = {SHAPE_ICO, .levels = 2, .changes = FAR}},
    {"grid-far", "far-from-origin", 62, QUICK,
     .mesh = {SHAPE_GRID, .rows = 10, .columns = 12, .changes = FAR | SCRAMBLED}},

    {"icosphere-tiny", "scale", 71, PUBLIC | QUICK,
     .mesh = {SHAPE_ICO, .levels = 2, .changes = TINY | TILTED}},
    {"icosphere-huge", "scale", 72, QUICK,
     .mesh = {SHAPE_ICO, .levels = 2, .changes = HUGE_SIZE | TILTED}},

    {"nothing", "empty", 91, PUBLIC | QUICK, .mesh = {SHAPE_EMPTY}},
    {"only-vertices", "empty", 92, QUICK, .mesh = {SHAPE_ISOLATED, .count = 7}},

    /* Last, because cases after two that do not end in time are not run. */
    {"bunny", "many-triangles", 84, PUBLIC | QUICK, .mesh = {SHAPE_BUNNY}},
    {"horse", "many-triangles", 85, HIDDEN, .mesh = {SHAPE_HORSE, .changes = SCRAMBLED}},
    {"100000-triangles", "many-triangles", 81, QUICK,
     .mesh = {SHAPE_GRID, .rows = 250, .columns = 200, .changes = SCRAMBLED}},
    {"1000000-triangles", "many-triangles", 82, HIDDEN,
     .mesh = {SHAPE_UV_SPHERE, .meridians = 1000, .parallels = 500}},
    {"10000000-triangles", "many-triangles", 83, HIDDEN,
     .mesh = {SHAPE_GRID, .rows = 1600, .columns = 3125}},
};

static const struct size_family families[] = {
    {"grid-scrambled", FAMILY_GRID, SCRAMBLED},
    {"sphere-scrambled", FAMILY_SPHERE, SCRAMBLED},
    {NULL},
};

static const struct answer_rule answer = {.function = "mesh_area", .result = RESULT_REAL};

static const struct phrase triangle_noun = {"triangle", "triángulo"};
static const struct cause not_a_number = {"not-a-number", {"not a number", "no es un número"}};
static const struct cause negative_area = {"negative-area", {"negative area", "área negativa"}};
static const struct cause wrong_area = {"wrong-area", {"wrong area", "área incorrecta"}};

/* ---------------------------------------------------------------------------------------- hints */

static bool is_close(double value, double wanted)
{
    return fabs(value - wanted) <= ALLOWED * fabs(wanted);
}

/* What of the mesh explains a mistake. */
enum focus { ON_ALL, ON_LAST_TRIANGLE, ON_FIRST_TRIANGLE, ON_FACING_UP };

struct guess {
    struct phrase hint;
    enum focus focus;
};

/* The usual mistakes. */
enum mistake {
    TWICE,
    HALF,
    NEGATED,
    MEAN,
    SQUARED,
    HALF_SQUARED,
    WITHOUT_LAST,
    WITHOUT_FIRST,
    ADDED_AS_VECTORS,
    FACING_UP,
    PROJECTED,
    SUM_IN_FLOAT,
    ALL_IN_FLOAT,
    PRODUCTS_IN_FLOAT,
    MISTAKE_COUNT
};

/* What each mistake gives on a mesh. */
static void find_values(const struct area_sums *sums, int32_t triangle_count,
                        double values[MISTAKE_COUNT])
{
    values[TWICE] = 2 * sums->exact;
    values[HALF] = sums->exact / 2;
    values[NEGATED] = -sums->exact;
    values[MEAN] = sums->exact / triangle_count;
    values[SQUARED] = sums->squares;
    values[HALF_SQUARED] = sums->squares / 2;
    values[WITHOUT_LAST] = sums->without_last;
    values[WITHOUT_FIRST] = sums->without_first;
    values[ADDED_AS_VECTORS] = sums->vector;
    values[FACING_UP] = sums->facing_up;
    values[PROJECTED] = sums->seen_from_z;
    values[SUM_IN_FLOAT] = sums->by_float;
    values[ALL_IN_FLOAT] = sums->all_float;
    values[PRODUCTS_IN_FLOAT] = sums->absolute_float;
}

static const struct guess guesses[MISTAKE_COUNT] = {
    [TWICE] = {{"It is twice the area: half of the cross product's length is the area.",
                "Es el doble del área: el área es la mitad de la longitud del producto vectorial."},
               ON_ALL},
    [HALF] = {{"It is half of the area.", "Es la mitad del área."}, ON_ALL},
    [NEGATED] = {{"It is the area with its sign reversed.", "Es el área con el signo cambiado."},
                 ON_ALL},
    [MEAN] = {{"It is the mean area of a triangle, not the sum.",
               "Es el área media de un triángulo, no la suma."},
              ON_ALL},
    [SQUARED] = {{"The square root of the cross product's squared length is missing.",
                  "Falta la raíz cuadrada del cuadrado de la longitud del producto vectorial."},
                 ON_ALL},
    [HALF_SQUARED] =
        {{"The square root of the cross product's squared length is missing.",
          "Falta la raíz cuadrada del cuadrado de la longitud del producto vectorial."},
         ON_ALL},
    [WITHOUT_LAST] = {{"The last triangle is missing: does the loop stop one too early?",
                       "Falta el último triángulo: ¿acaba el bucle uno antes de tiempo?"},
                      ON_LAST_TRIANGLE},
    [WITHOUT_FIRST] = {{"The first triangle is missing.", "Falta el primer triángulo."},
                       ON_FIRST_TRIANGLE},
    [ADDED_AS_VECTORS] =
        {{"The cross products were added as vectors: triangles that face opposite ways cancel.",
          "Se sumaron los productos como vectores: los triángulos de caras opuestas se anulan."},
         ON_ALL},
    [FACING_UP] = {{"Only triangles that face upwards (z) are counted.",
                    "Solo se cuentan los triángulos que miran hacia arriba (z)."},
                   ON_FACING_UP},
    [PROJECTED] = {{"It is the area of the projection onto the plane z = 0.",
                    "Es el área de la proyección sobre el plano z = 0."},
                   ON_ALL},
    [SUM_IN_FLOAT] = {{"The sum is kept in a float: with this many terms its 24 bits run out.",
                       "La suma se guarda en un float: con tantos términos sus 24 bits no bastan."},
                      ON_ALL},
    [ALL_IN_FLOAT] = {{"Everything is computed in float; 24 bits do not suffice here.",
                       "Todo se calcula en float; aquí no bastan 24 bits."},
                      ON_ALL},
    [PRODUCTS_IN_FLOAT] =
        {{"Products of positions are taken in float: subtract positions first, and in double.",
          "Se multiplican posiciones en float: hay que restarlas antes, y en double."},
         ON_ALL},
};

/* The mistake whose result the area is; no hint when it is none of them. A mistake that
 * this mesh does not show is no guess. */
static struct guess guess_mistake(const struct area_sums *sums, int32_t triangle_count, double area)
{
    double values[MISTAKE_COUNT];
    find_values(sums, triangle_count, values);
    if (is_close(area, sums->exact / 2) && is_close(area, sums->facing_up))
        return (struct guess){
            {"It is half of the area, which is that of the triangles facing upwards (z).",
             "Es la mitad del área, que es la de los triángulos que miran hacia arriba (z)."},
            ON_FACING_UP};
    for (size_t i = 0; i < MISTAKE_COUNT; i++) {
        double value = values[i];
        bool is_told_apart =
            isfinite(value) && fabs(value) > ALLOWED * sums->exact && !is_close(value, sums->exact);
        if (is_told_apart && is_close(area, value))
            return guesses[i];
    }
    return (struct guess){{NULL, NULL}, ON_ALL};
}

/* -------------------------------------------------------------------------------------- judging */

static int show_triangle(const struct mesh_view *view, enum mark_kind kind, int32_t triangle,
                         struct judgement *out, struct error *err)
{
    const int32_t *v = view->triangles + 3 * (int64_t)triangle;
    judge_name_one(out, triangle_noun, "%d (%d,%d,%d)", triangle, v[0], v[1], v[2]);
    if (mesh_input_show(view, &out->scene, err))
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
    if (mesh_input_show(view, scene, err))
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
    if (!judge_reject_for(out, &not_a_number))
        return 0;
    judge_en(out, "the area is %s instead of %.9g.", isnan(area) ? "NaN" : "infinity", sums->exact);
    judge_es(out, "el área es %s en lugar de %.9g.", isnan(area) ? "NaN" : "infinito", sums->exact);
    if (sums->first_flat < 0)
        return 0;
    message_add(
        &out->message,
        " Triangle %d has area 0: is something divided by a length of 0, or a root taken of "
        "a number below 0?",
        " El triángulo %d tiene área 0: ¿se divide por una longitud 0, o se toma la raíz de "
        "un número negativo?",
        sums->first_flat);
    return show_triangle(view, MARK_DEGENERATE, sums->first_flat, out, err);
}

static int reject_area(const struct mesh_view *view, double area, struct judgement *out,
                       struct error *err)
{
    struct area_sums sums = mesh_area_sums(view);
    if (!isfinite(area))
        return reject_not_finite(view, &sums, area, out, err);
    struct guess guess = guess_mistake(&sums, view->triangle_count, area);
    judge_name(out, "total area", "área total");
    if (sums.exact > 0)
        judge_reject(out, area < 0 ? &negative_area : &wrong_area,
                     "the area is %.9g instead of %.9g: relative error %.2g, allowed 1e-06.",
                     "el área es %.9g en lugar de %.9g: error relativo %.2g, permitido 1e-06.",
                     area, sums.exact, fabs(area - sums.exact) / sums.exact);
    else
        judge_reject(out, &wrong_area, "the area is %.9g, but there is no area: it must be 0",
                     "el área es %.9g, pero no hay área ninguna: debe ser 0", area);
    judge_hint(out, guess.hint);
    if (view->triangle_count > 0 && guess.focus == ON_LAST_TRIANGLE)
        return show_triangle(view, MARK_MISSING, view->triangle_count - 1, out, err);
    if (view->triangle_count > 0 && guess.focus == ON_FIRST_TRIANGLE)
        return show_triangle(view, MARK_MISSING, 0, out, err);
    return show_area(view, sums.exact, area, guess.focus == ON_FACING_UP, &out->scene, err);
}

static int judge_area(const struct task *task, struct judgement *out, struct error *err)
{
    double area = task->answer.real, exact = mesh_area_exact(&task->mesh);
    out->scene.ok_count = -1;
    if (fabs(area - exact) <= ALLOWED * exact) {
        judge_accept(out);
        return 0;
    }
    return reject_area(&task->mesh, area, out, err);
}

const struct judge judge_mesh_area = {
    .exercise = "mesh-area",
    .cases = cases,
    .case_count = sizeof cases / sizeof *cases,
    .input = INPUT_MESH,
    .families = families,
    .answer = &answer,
    .answers_reals = true,
    .judge = judge_area,
};
