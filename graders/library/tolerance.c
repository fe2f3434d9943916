/* Comparing real numbers; see tolerance.h. */
#include "graders/library/tolerance.h"

#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

static const double PI = 3.14159265358979323846;

/* -------------------------------------------------------------------------------- single numbers
 */

double float_ulp(double x)
{
    float near = (float)fabs(x);
    if (!(near < FLT_MAX))
        near = FLT_MAX;
    float above = nextafterf(near, INFINITY);
    return isfinite(above) ? (double)above - (double)near
                           : (double)FLT_MAX - (double)nextafterf(FLT_MAX, 0);
}

double double_ulp(double x)
{
    double near = fabs(x);
    double above = nextafter(near, INFINITY);
    return isfinite(above) ? above - near : DBL_MAX - nextafter(DBL_MAX, 0);
}

double tolerance_at(const struct tolerance *tolerance, double right, double scale)
{
    double allowed = tolerance->absolute + tolerance->relative * fabs(scale);
    if (tolerance->float_ulps > 0)
        allowed += tolerance->float_ulps * float_ulp(right);
    if (tolerance->double_ulps > 0)
        allowed += tolerance->double_ulps * double_ulp(right);
    return allowed;
}

bool tolerance_allows(const struct tolerance *tolerance, double found, double right)
{
    return isfinite(found) && fabs(found - right) <= tolerance_at(tolerance, right, right);
}

double angle_between(const double a[3], const double b[3])
{
    double most_a = fmax(fmax(fabs(a[0]), fabs(a[1])), fabs(a[2]));
    double most_b = fmax(fmax(fabs(b[0]), fabs(b[1])), fabs(b[2]));
    if (!(most_a > 0 && most_b > 0))
        return NAN;
    /* Divided, so that no square overflows or vanishes. */
    const double u[3] = {a[0] / most_a, a[1] / most_a, a[2] / most_a};
    const double v[3] = {b[0] / most_b, b[1] / most_b, b[2] / most_b};
    const double cross[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                             u[0] * v[1] - u[1] * v[0]};
    double along = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    return atan2(sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]), along);
}

double angle_difference(double a, double b)
{
    return fabs(remainder(a - b, 2 * PI));
}

/* ----------------------------------------------------------------------------------------- tables
 */

/* A row of an answer beside what it should be. */
struct real_row {
    double found[REAL_WIDTH_MOST], right[REAL_WIDTH_MOST];
    double scale; /* NaN: the right value */
    int width;
};

static void load_row(const struct reals *found, const double *right, int64_t number,
                     const struct real_rule *rule, struct real_row *row)
{
    row->scale = rule->scale ? rule->scale[number] : (double)NAN;
    for (int i = 0; i < row->width; i++) {
        int64_t at = number * row->width + i;
        row->found[i] = found->floats ? (double)found->floats[at] : found->doubles[at];
        row->right[i] = right[at];
    }
}

/* What is the matter with a number of a row, or with all of a direction. */
struct deviation {
    double error; /* infinity where it is not finite */
    double allowed;
};

static struct deviation deviation_of(const struct real_row *row, int column,
                                     const struct real_rule *rule, double slack)
{
    double found = row->found[column], right = row->right[column];
    double scale = isnan(row->scale) ? right : row->scale;
    struct deviation d = {INFINITY, rule->tolerance.absolute};
    if (rule->kind == REAL_DIRECTIONS)
        d.error = angle_between(row->found, row->right);
    else if (rule->kind == REAL_ANGLES)
        d.error = angle_difference(found, right);
    else
        d.error = fabs(found - right);
    if (rule->kind != REAL_DIRECTIONS)
        d.allowed = tolerance_at(&rule->tolerance, right, scale);
    d.allowed += slack * fabs(right);
    if (!isfinite(found) || isnan(d.error))
        d.error = INFINITY;
    return d;
}

static bool is_wrong(struct deviation d)
{
    return !(d.error <= d.allowed);
}

/* How many tolerances a number is off; infinity where nothing is allowed. */
static double excess_of(struct deviation d)
{
    return d.allowed > 0 ? d.error / d.allowed : (double)INFINITY;
}

static void note_wrong(struct real_fault *fault, int64_t number, const struct real_row *row,
                       int column)
{
    if (fault->wrong_count == 0) {
        fault->row = number;
        fault->column = column;
        fault->found = row->found[column];
        fault->right = row->right[column];
    }
    fault->wrong_count += !fault->marks[number];
    fault->marks[number] = 1;
}

static void look_at_row(const struct real_row *row, int64_t number, const struct real_rule *rule,
                        double *worst, struct real_fault *fault)
{
    bool is_finite = true;
    int count = rule->kind == REAL_DIRECTIONS ? 1 : row->width;
    for (int column = 0; column < row->width; column++)
        is_finite = is_finite && isfinite(row->found[column]);
    for (int column = 0; column < count; column++) {
        struct deviation d = deviation_of(row, column, rule, 0);
        if (rule->kind == REAL_DIRECTIONS && !is_finite)
            d.error = INFINITY;
        if (!is_wrong(d))
            continue;
        note_wrong(fault, number, row, column);
        bool is_alike = excess_of(d) == *worst && isinf(*worst); /* where nothing is allowed */
        bool is_worse = excess_of(d) > *worst || (is_alike && d.error > fault->worst_error);
        if (fault->worst_row < 0 || is_worse) {
            *worst = excess_of(d);
            fault->worst_row = number;
            fault->worst_column = column;
            fault->worst_error = d.error;
        }
    }
    if (!is_finite && fault->not_finite_count++ == 0)
        fault->not_finite_row = number;
}

int reals_compare(const struct reals *found, const double *right, int64_t row_count, int width,
                  const struct real_rule *rule, struct real_fault *fault, struct error *err)
{
    *fault = (struct real_fault){.row = -1, .worst_row = -1, .not_finite_row = -1};
    if (row_count < 0 || width < 1 || width > REAL_WIDTH_MOST ||
        (rule->kind == REAL_DIRECTIONS && width != 3))
        return error_set(err, "%" PRId64 " rows of %d numbers cannot be compared", row_count,
                         width);
    fault->marks = calloc((size_t)row_count + 1, 1);
    if (!fault->marks)
        return error_set(err, "out of memory: comparing %" PRId64 " rows", row_count);
    double worst = 0;
    for (int64_t number = 0; number < row_count; number++) {
        struct real_row row = {.width = width};
        load_row(found, right, number, rule, &row);
        look_at_row(&row, number, rule, &worst, fault);
    }
    return 0;
}

void real_fault_release(struct real_fault *fault)
{
    free(fault->marks);
    *fault = (struct real_fault){0};
}

/* --------------------------------------------------------------------------------------- mistakes
 */

/* Puts what a mistake leads to in the place of what is right. */
static void make_mistake(const struct mistake *mistake, struct real_row *row, int64_t number,
                         const void *context)
{
    for (int i = 0; i < row->width; i++) {
        struct mistake_place place = {row->right[i], number, i, context};
        row->right[i] = mistake->value ? mistake->value(&place) : mistake->factor * place.right;
    }
}

static bool explains(const struct mistake *mistake, const struct reals *found, const double *right,
                     int64_t row_count, int width, const struct real_rule *rule,
                     const void *context)
{
    for (int64_t number = 0; number < row_count; number++) {
        struct real_row row = {.width = width};
        load_row(found, right, number, rule, &row);
        make_mistake(mistake, &row, number, context);
        for (int column = 0; column < width; column++)
            if (is_wrong(deviation_of(&row, column, rule, mistake->slack)))
                return false;
    }
    return row_count > 0;
}

const struct mistake *reals_mistake(const struct reals *found, const double *right,
                                    int64_t row_count, int width, const struct real_rule *rule,
                                    const struct mistake *list, const void *context)
{
    if (width < 1 || width > REAL_WIDTH_MOST || (rule->kind == REAL_DIRECTIONS && width != 3))
        return NULL;
    for (const struct mistake *mistake = list; mistake->cause.slug; mistake++)
        if (explains(mistake, found, right, row_count, width, rule, context))
            return mistake;
    return NULL;
}

static double zero(const struct mistake_place *place)
{
    (void)place;
    return 0;
}

static double magnitude(const struct mistake_place *place)
{
    return fabs(place->right);
}

static double square(const struct mistake_place *place)
{
    return place->right * place->right;
}

static double square_root(const struct mistake_place *place)
{
    return sqrt(place->right); /* NaN for negative values: agrees with nothing */
}

static double reciprocal(const struct mistake_place *place)
{
    return 1 / place->right;
}

static double other_angle(const struct mistake_place *place)
{
    return PI - place->right;
}

/* Rounding errors of some hundred operations in binary32. */
static const double FLOAT_ROUNDING = 1e-5;

const struct mistake tolerance_usual_mistakes[] = {
    {.cause = {"zero-everywhere", {"zero everywhere", "cero en todas partes"}},
     .value = zero,
     .hint = {"It is 0 everywhere: is anything written?",
              "Es 0 en todas partes: ¿se escribe algo?"}},
    {.cause = {"opposite-sign", {"opposite sign", "signo contrario"}},
     .factor = -1,
     .hint = {"It has the opposite sign everywhere.", "Tiene el signo contrario en todas partes."}},
    {.cause = {"sign-lost", {"sign lost", "se pierde el signo"}},
     .value = magnitude,
     .hint = {"It is right but for the sign: negative values come out positive.",
              "Es correcto salvo el signo: los valores negativos salen positivos."}},
    {.cause = {"twice", {"twice the value", "el doble"}},
     .factor = 2,
     .hint = {"It is twice the right value everywhere.",
              "Es el doble del valor correcto en todas partes."}},
    {.cause = {"half", {"half the value", "la mitad"}},
     .factor = 0.5,
     .hint = {"It is half the right value everywhere.",
              "Es la mitad del valor correcto en todas partes."}},
    {.cause = {"three-times", {"three times the value", "el triple"}},
     .factor = 3,
     .hint = {"It is three times the right value everywhere.",
              "Es el triple del valor correcto en todas partes."}},
    {.cause = {"one-third", {"one third of the value", "un tercio"}},
     .factor = 1.0 / 3,
     .hint = {"It is one third of the right value everywhere.",
              "Es un tercio del valor correcto en todas partes."}},
    {.cause = {"six-times", {"six times the value", "seis veces el valor"}},
     .factor = 6,
     .hint = {"It is six times the right value everywhere.",
              "Es seis veces el valor correcto en todas partes."}},
    {.cause = {"degrees", {"degrees for radians", "grados por radianes"}},
     .factor = 57.295779513082320877,
     .hint = {"It is in degrees; radians are asked.", "Está en grados; se piden radianes."}},
    {.cause = {"radians", {"radians for degrees", "radianes por grados"}},
     .factor = 0.017453292519943295769,
     .hint = {"It is in radians; degrees are asked.", "Está en radianes; se piden grados."}},
    {.cause = {"squared", {"squared value", "valor al cuadrado"}},
     .value = square,
     .hint = {"It is the square of the right value.", "Es el cuadrado del valor correcto."}},
    {.cause = {"square-root", {"square root of the value", "raíz cuadrada del valor"}},
     .value = square_root,
     .hint = {"It is the square root of the right value.",
              "Es la raíz cuadrada del valor correcto."}},
    {.cause = {"reciprocal", {"reciprocal of the value", "inverso del valor"}},
     .value = reciprocal,
     .hint = {"It is 1 divided by the right value.", "Es 1 dividido por el valor correcto."}},
    {.cause = {"other-angle", {"the other angle", "el otro ángulo"}},
     .value = other_angle,
     .hint = {"It is pi minus the right angle: both vectors must begin at the same point.",
              "Es pi menos el ángulo correcto: ambos vectores deben partir del mismo punto."}},
    {.cause = {"float-precision", {"precision of float", "precisión de float"}},
     .factor = 1,
     .slack = FLOAT_ROUNDING,
     .hint = {"It is right but for rounding: compute in double.",
              "Es correcto salvo el redondeo: calcula en double."}},
    {.cause = {NULL, {NULL, NULL}}},
};
