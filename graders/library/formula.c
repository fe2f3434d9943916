/* Formulas, numbers and sizes; see formula.h. */
#include "graders/library/formula.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { PLACE_BYTES = 96 };

static const struct cause wrong_formula = {"wrong-formula",
                                           {"wrong formula", "fórmula incorrecta"}};
static const struct cause wrong_number = {"wrong-number", {"wrong number", "número incorrecto"}};
static const struct cause measured_size = {"measured-size",
                                           {"measured size differs", "tamaño medido distinto"}};
static const struct cause formula_differs = {
    "formula-differs",
    {"formula differs from what was built", "fórmula distinta de lo construido"}};

/* ----------------------------------------------------------------- formulas */

static int64_t right_at(const struct formula *formula, const int32_t *rows, int64_t row)
{
    return formula->value(rows[2 * row], rows[2 * row + 1]);
}

static bool all_wrapped(const struct formula *formula, const int32_t *rows, int64_t row_count,
                        const int64_t *answers)
{
    for (int64_t i = 0; i < row_count; i++) {
        uint32_t low = (uint32_t)((uint64_t)right_at(formula, rows, i) & UINT32_MAX);
        int64_t as_signed = low > INT32_MAX ? (int64_t)low - ((int64_t)1 << 32) : (int64_t)low;
        if (answers[i] != low && answers[i] != as_signed)
            return false;
    }
    return true;
}

static bool all_rounded(const struct formula *formula, const int32_t *rows, int64_t row_count,
                        const int64_t *answers)
{
    for (int64_t i = 0; i < row_count; i++) {
        double right = (double)right_at(formula, rows, i);
        if (!(fabs((double)answers[i] - right) <= 1e-6 * right))
            return false;
    }
    return true;
}

static const struct formula_mistake *find_mistake(const struct formula *formula,
                                                  const int32_t *rows, int64_t row_count,
                                                  const int64_t *answers)
{
    static const struct formula_mistake wrapped = {
        {"overflow", {"overflow", "desbordamiento"}},
        NULL,
        {"The value does not fit into 32 bits: multiply after widening to int64_t.",
         "El valor no cabe en 32 bits: convierte a int64_t antes de multiplicar."}};
    static const struct formula_mistake rounded = {
        {"rounded", {"rounded", "redondeado"}},
        NULL,
        {"It is almost right: it was rounded, perhaps by float or double. Use only int64_t.",
         "Es casi correcto: se ha redondeado, quizá por usar float o double. Usa solo int64_t."}};
    const struct formula_mistake *mistake = formula->mistakes;
    for (; mistake && mistake->cause.slug; mistake++) {
        int64_t i = 0;
        while (i < row_count && answers[i] == mistake->value(rows[2 * i], rows[2 * i + 1]))
            i++;
        if (i == row_count)
            return mistake;
    }
    if (all_wrapped(formula, rows, row_count, answers))
        return &wrapped;
    return all_rounded(formula, rows, row_count, answers) ? &rounded : NULL;
}

static void name_place(const struct formula *formula, const int32_t *row, char *place)
{
    if (formula->parameter[1])
        snprintf(place, PLACE_BYTES, "%s = %d, %s = %d", formula->parameter[0], row[0],
                 formula->parameter[1], row[1]);
    else
        snprintf(place, PLACE_BYTES, "%s = %d", formula->parameter[0], row[0]);
}

struct point {
    double x, y;
};

static int compare_points(const void *left, const void *right)
{
    const struct point *a = left, *b = right;
    return a->x < b->x ? -1 : a->x > b->x;
}

static bool on_diagonal(const struct formula *formula, const int32_t *row)
{
    return !formula->parameter[1] || row[0] == row[1];
}

/* Whether the first parameter can be the x axis: a row where both parameters are equal is wrong. */
static bool diagonal_tells(const struct formula *formula, const int32_t *rows, int64_t row_count,
                           const int64_t *answers)
{
    for (int64_t i = 0; i < row_count; i++)
        if (on_diagonal(formula, rows + 2 * i) && answers[i] != right_at(formula, rows, i))
            return true;
    return false;
}

/* Adds one curve: over the first parameter, of the rows on the diagonal, or else over the right
 * value, of all rows. A value that is not positive has no place on the axes and is left out. */
static int add_curve(struct scene *scene, const char *name, const struct formula *formula,
                     const int32_t *rows, int64_t row_count, const int64_t *answers, bool diagonal,
                     struct error *err)
{
    struct point *points = calloc((size_t)row_count + 1, sizeof *points);
    double *x = calloc(2 * (size_t)row_count + 1, sizeof *x);
    int count = 0, failed = 0;
    for (int64_t i = 0; points && i < row_count; i++) {
        int64_t right = right_at(formula, rows, i), value = answers ? answers[i] : right;
        if ((diagonal && !on_diagonal(formula, rows + 2 * i)) || value <= 0 || right <= 0)
            continue;
        points[count++] = (struct point){diagonal ? rows[2 * i] : (double)right, (double)value};
    }
    if (!points || !x) {
        failed = error_set(err, "out of memory for a chart of %" PRId64 " points", row_count);
    } else if (count > 0) {
        qsort(points, (size_t)count, sizeof *points, compare_points);
        for (int i = 0; i < count; i++) {
            x[i] = points[i].x;
            x[row_count + i] = points[i].y;
        }
        failed = scene_add_curve(scene, name, x, x + row_count, count, 0, err);
    }
    free(points);
    free(x);
    return failed;
}

static int show_curves(const struct formula *formula, const int32_t *rows, int64_t row_count,
                       const int64_t *answers, struct scene *scene, struct error *err)
{
    bool diagonal = diagonal_tells(formula, rows, row_count, answers);
    if (!diagonal)
        snprintf(scene->x_label, sizeof scene->x_label, "right %s", formula->unit.en);
    else if (formula->parameter[1])
        snprintf(scene->x_label, sizeof scene->x_label, "%s = %s", formula->parameter[0],
                 formula->parameter[1]);
    else
        snprintf(scene->x_label, sizeof scene->x_label, "%s", formula->parameter[0]);
    snprintf(scene->y_label, sizeof scene->y_label, "%s", formula->unit.en);
    if (add_curve(scene, "submission", formula, rows, row_count, answers, diagonal, err))
        return -1;
    return add_curve(scene, "right", formula, rows, row_count, NULL, diagonal, err);
}

int formula_judge(const struct formula *formula, const int32_t *rows, int64_t row_count,
                  const int64_t *answers, struct judgement *out, struct error *err)
{
    int64_t first = 0;
    while (first < row_count && answers[first] == right_at(formula, rows, first))
        first++;
    if (first == row_count) {
        judge_accept(out);
        return 0;
    }
    const struct formula_mistake *mistake = find_mistake(formula, rows, row_count, answers);
    char place[PLACE_BYTES];
    name_place(formula, rows + 2 * first, place);
    judge_name(out, "%s", "%s", place);
    int64_t right = right_at(formula, rows, first);
    if (judge_reject_for(out, mistake ? &mistake->cause : &wrong_formula)) {
        judge_en(out, "%s for %s: %" PRId64 " %s, right is %" PRId64 ".", formula->function, place,
                 answers[first], formula->unit.en, right);
        judge_es(out, "%s para %s: %" PRId64 " %s, lo correcto es %" PRId64 ".", formula->function,
                 place, answers[first], formula->unit.es, right);
        judge_hint(out, mistake ? mistake->hint : (struct phrase){NULL, NULL});
    }
    return show_curves(formula, rows, row_count, answers, &out->scene, err);
}

/* ------------------------------------------------------------------ numbers */

void formula_judge_number(const struct number *number, double answer, struct judgement *out)
{
    if (fabs(answer - number->value) <= number->tolerance) {
        judge_accept(out);
        return;
    }
    const struct number_mistake *mistake = number->mistakes;
    while (mistake && mistake->cause.slug && !(fabs(answer - mistake->value) <= number->tolerance))
        mistake++;
    bool known = mistake && mistake->cause.slug;
    judge_name(out, "%s", "%s", number->function);
    if (!judge_reject_for(out, known ? &mistake->cause : &wrong_number))
        return;
    judge_en(out, "%s says %.10g. %s", number->function, answer, number->rule.en);
    judge_es(out, "%s dice %.10g. %s", number->function, answer, number->rule.es);
    if (known)
        judge_hint(out, mistake->hint);
}

/* -------------------------------------------------------------------- sizes */

void formula_judge_size(const struct size_claim *claim, const struct usage *usage,
                        struct judgement *out)
{
    int64_t measured = 0;
    bool fits = true;
    if (usage->known)
        fits = !__builtin_sub_overflow(usage->heap_held_bytes, usage->heap_left_bytes, &measured) &&
               !__builtin_add_overflow(measured, claim->outside_bytes, &measured);
    if (usage->known && (!fits || measured != claim->right_bytes)) {
        judge_reject(out, &measured_size,
                     "%s built a structure of %" PRId64 " bytes (measured); %s says %" PRId64
                     ", and the tables take %" PRId64 ".",
                     "%s ha construido una estructura de %" PRId64
                     " bytes (medidos); %s dice %" PRId64 " y las tablas ocupan %" PRId64 ".",
                     claim->builder, measured, claim->formula, claim->own_bytes,
                     claim->right_bytes);
        return;
    }
    if (claim->own_bytes != claim->right_bytes) {
        judge_reject(out, &formula_differs,
                     "%s says %" PRId64 " bytes, but what %s built takes %" PRId64 ".",
                     "%s dice %" PRId64 " bytes, pero lo que %s ha construido ocupa %" PRId64 ".",
                     claim->formula, claim->own_bytes, claim->builder, claim->right_bytes);
        return;
    }
    judge_accept(out);
}
