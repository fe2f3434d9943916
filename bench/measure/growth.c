/* The growth fit; see growth.h.
 *
 * Non-negative least squares of at most six unknowns: the best non-negative solution is the plain
 * least-squares solution on the terms that are not zero in it, so all 2^6 choices of terms are
 * tried. No iteration, no tolerance, nothing to converge. */
#include "bench/measure/growth.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { CLASSES = GROWTH_CLASS_COUNT, SIZES = GROWTH_SIZES_MAX };

/* Terms beside the classes: work that begins at one of the sizes. */
enum { STEPS = 2, TERMS = CLASSES + STEPS };

static const double FIRST_SHARE = 0.02, FIRST_RESIDUAL = 0.05;
static const double PASS_SHARE = 0.10, FAIL_SHARE = 0.15;
static const double CONSTANT_SHARE_MAX = 0.20, RESIDUAL_MAX = 0.03, ROUGH_MARGIN = 0.25,
                    STEEP_MARGIN = 0.5;

/* What a failure needs: see has_evidence. */
static const double EXPONENT_OF_EXCESS = 0.3, STEPS_TO_CURVE = 3, STEPS_LEAST = 0.003;
enum { FREEDOM_LEAST = 3 };

/* Better by less than this (of the residual's square, which is at most 1 a size) is no better: then
 * fewer terms win. Rounding is some 1e-20. */
static const double RESIDUAL_STEP = 1e-13;

static const struct {
    const char *name;
    double exponent;
} classes[CLASSES] = {{"1", 0}, {"n", 1}, {"n lg n", 1}, {"n^1.5", 1.5}, {"n^2", 2}, {"n^3", 3}};

const char *growth_class_name(enum growth_class class)
{
    return classes[class].name;
}

int growth_class_find(const char *name, enum growth_class *class)
{
    for (int i = 0; i < GROWTH_N_CUBED; i++)
        if (strcmp(name, classes[i].name) == 0) {
            *class = (enum growth_class)i;
            return 0;
        }
    return -1;
}

double growth_term(enum growth_class class, double n)
{
    switch (class) {
    case GROWTH_CONSTANT:
        return 1;
    case GROWTH_N:
        return n;
    case GROWTH_N_LG_N:
        return n * log2(n);
    case GROWTH_N_SQRT_N:
        return n * sqrt(n);
    case GROWTH_N_SQUARED:
        return n * n;
    default:
        return n * n * n;
    }
}

/* The measured points and the mixture that was found for them. */
struct mixture {
    int count;
    double n[SIZES], y[SIZES];
    int step[STEPS];              /* the index of the size where it begins ... */
    enum growth_class step_class; /* ... and its class */
    double coefficient[TERMS];
    double residual; /* sum of squared relative residuals */
};

/* Columns of a least-squares problem, made orthonormal one by one (modified Gram-Schmidt). */
struct basis {
    int terms, points;
    int term[TERMS];
    double column[TERMS][SIZES]; /* orthonormal */
    double r[TERMS][TERMS];      /* what they were made of */
    double scale[TERMS];         /* of the original column, to length 1 */
    double projection[TERMS];    /* of the right-hand side on each */
    double left[SIZES];          /* of the right-hand side */
};

static double dot(const double *a, const double *b, int count)
{
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += a[i] * b[i];
    return sum;
}

static double term_at(const struct mixture *m, int term, int i)
{
    if (term < CLASSES)
        return growth_term((enum growth_class)term, m->n[i]);
    return i >= m->step[term - CLASSES] ? growth_term(m->step_class, m->n[i]) : 0;
}

/* Adds the column of a term. Returns false when it depends on those before. */
static bool add_column(struct basis *basis, const struct mixture *m, int term)
{
    const int k = basis->terms, points = basis->points;
    double *q = basis->column[k];
    for (int i = 0; i < points; i++)
        q[i] = term_at(m, term, i) / m->y[i];
    basis->scale[k] = 1 / sqrt(dot(q, q, points));
    for (int i = 0; i < points; i++)
        q[i] *= basis->scale[k];
    for (int j = 0; j < k; j++) {
        basis->r[j][k] = dot(basis->column[j], q, points);
        for (int i = 0; i < points; i++)
            q[i] -= basis->r[j][k] * basis->column[j][i];
    }
    double square = dot(q, q, points);
    if (!(square > 1e-20))
        return false;
    basis->r[k][k] = sqrt(square);
    for (int i = 0; i < points; i++)
        q[i] /= basis->r[k][k];
    basis->projection[k] = dot(q, basis->left, points);
    for (int i = 0; i < points; i++)
        basis->left[i] -= basis->projection[k] * q[i];
    basis->term[basis->terms++] = term;
    return true;
}

/* Least squares of sum_k c_k column_k against 1 for the terms in `chosen`. Returns false when the
 * columns are dependent or a coefficient is not positive. */
static bool solve(const struct mixture *m, unsigned chosen, double coefficient[TERMS],
                  double *residual)
{
    struct basis basis = {.points = m->count};
    for (int i = 0; i < m->count; i++)
        basis.left[i] = 1;
    for (int k = 0; k < TERMS; k++)
        if ((chosen >> k & 1) && !add_column(&basis, m, k))
            return false;
    *residual = dot(basis.left, basis.left, m->count);
    memset(coefficient, 0, TERMS * sizeof *coefficient);
    double x[TERMS];
    for (int k = basis.terms - 1; k >= 0; k--) {
        x[k] = basis.projection[k];
        for (int j = k + 1; j < basis.terms; j++)
            x[k] -= basis.r[k][j] * x[j];
        x[k] /= basis.r[k][k];
        if (!(x[k] > 0))
            return false;
        coefficient[basis.term[k]] = x[k] * basis.scale[k];
    }
    return true;
}

/* Finds the best mixture of the terms in `offered`. */
static void fit_mixture(struct mixture *m, unsigned offered)
{
    m->residual = DBL_MAX;
    for (int terms = 1; terms <= TERMS; terms++)
        for (unsigned chosen = 1; chosen < 1U << TERMS; chosen++) {
            double coefficient[TERMS], residual;
            if ((chosen & ~offered) || __builtin_popcount(chosen) != terms || terms > m->count)
                continue;
            if (solve(m, chosen, coefficient, &residual) &&
                residual < m->residual - RESIDUAL_STEP) {
                m->residual = residual;
                memcpy(m->coefficient, coefficient, sizeof coefficient);
            }
        }
}

static void take_points(struct mixture *m, const int64_t *sizes, const int64_t *counts, int first,
                        int count)
{
    *m = (struct mixture){.count = count - first};
    for (int i = first; i < count; i++) {
        m->n[i - first] = (double)sizes[i];
        m->y[i - first] = (double)counts[i];
    }
}

/* Slope of log count over log n, over the top four sizes. */
static double top_slope(const struct mixture *m)
{
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    int first = m->count - GROWTH_SIZES_MIN;
    for (int i = first; i < m->count; i++) {
        mean_x += log(m->n[i]) / GROWTH_SIZES_MIN;
        mean_y += log(m->y[i]) / GROWTH_SIZES_MIN;
    }
    for (int i = first; i < m->count; i++) {
        double x = log(m->n[i]) - mean_x;
        xx += x * x;
        xy += x * (log(m->y[i]) - mean_y);
    }
    return xy / xx;
}

/* n and n lg n are one class. */
static int upper_bound(enum growth_class allowed)
{
    return allowed == GROWTH_N ? GROWTH_N_LG_N : (int)allowed;
}

/* The best that the allowed terms reach together with two steps: what programs do that read their
 * input once more from some size on, whose table grows, or whose data leave a cache. */
static double residual_with_steps(const struct mixture *m, int bound)
{
    struct mixture stepped = *m;
    double least = DBL_MAX;
    unsigned allowed = (2U << bound) - 1, offered = allowed | 3U << CLASSES;
    stepped.step_class = bound == GROWTH_N_LG_N ? GROWTH_N : (enum growth_class)bound;
    for (int first = 1; first < m->count; first++)
        for (int second = first + 1; second <= m->count; second++) { /* count: no second one */
            stepped.step[0] = first;
            stepped.step[1] = second;
            fit_mixture(&stepped, second < m->count ? offered : offered & ~(2U << CLASSES));
            least = fmin(least, stepped.residual);
        }
    return sqrt(least / m->count);
}

static int count_terms(const struct mixture *m)
{
    int count = 0;
    for (int k = 0; k < TERMS; k++)
        count += m->coefficient[k] > 0;
    return count;
}

/* Whether a share above what passes is more than an accident: more sizes than terms, a slope that
 * goes with the share, and no explanation by steps that is nearly as good. */
static bool has_evidence(const struct growth_fit *fit, const struct mixture *m, int bound)
{
    double rise = fit->exponent - classes[bound].exponent;
    if (m->count - count_terms(m) < FREEDOM_LEAST || rise < EXPONENT_OF_EXCESS * fit->excess)
        return false;
    if (fit->residual > RESIDUAL_MAX && rise < ROUGH_MARGIN)
        return false;
    double stepped = residual_with_steps(m, bound);
    bool is_steep = rise >= STEEP_MARGIN && stepped > RESIDUAL_MAX; /* also where no curve fits */
    return is_steep || (stepped > STEPS_LEAST && stepped > STEPS_TO_CURVE * fit->residual);
}

static enum growth_decision decide(const struct growth_fit *fit, const struct mixture *m, int bound,
                                   enum growth_look look)
{
    if (look == GROWTH_FIRST_LOOK)
        return fit->excess <= FIRST_SHARE && fit->residual <= FIRST_RESIDUAL ? GROWTH_PASS
                                                                             : GROWTH_UNDECIDED;
    if (fit->excess <= PASS_SHARE)
        return GROWTH_PASS;
    if (look == GROWTH_FULL_LOOK)
        return GROWTH_UNDECIDED;
    return fit->excess >= FAIL_SHARE && has_evidence(fit, m, bound) ? GROWTH_FAIL : GROWTH_PASS;
}

/* The largest class that, with those above it, does enough of the work to matter. More than the
 * share that passes is never below the bound, so the label contradicts a decision only when doubt
 * made it PASS. */
static enum growth_class label(const struct growth_fit *fit, int bound)
{
    int highest = GROWTH_N_CUBED;
    double share = fit->share[highest];
    while (highest > GROWTH_CONSTANT && share < PASS_SHARE)
        share += fit->share[--highest];
    if (fit->decision == GROWTH_PASS && highest > bound)
        highest = bound;
    return (enum growth_class)highest;
}

static int check(const int64_t *sizes, const int64_t *counts, int count, enum growth_class allowed,
                 struct error *err)
{
    if (count < GROWTH_SIZES_MIN || count > GROWTH_SIZES_MAX)
        return error_set(err, "growth: %d sizes; %d to %d are needed", count, GROWTH_SIZES_MIN,
                         GROWTH_SIZES_MAX);
    if (allowed >= GROWTH_N_CUBED)
        return error_set(err, "growth: n^2 is the largest class that can be allowed");
    for (int i = 0; i < count; i++)
        if (sizes[i] <= (i ? sizes[i - 1] : 0) || counts[i] <= 0)
            return error_set(err, "growth: size %d of %d: sizes must rise and counts be positive",
                             i + 1, count);
    return 0;
}

int growth_fit(const int64_t *sizes, const int64_t *counts, int count, enum growth_class allowed,
               enum growth_look look, struct growth_fit *fit, struct error *err)
{
    *fit = (struct growth_fit){0};
    if (check(sizes, counts, count, allowed, err))
        return -1;
    unsigned offered = (1U << (allowed >= GROWTH_N_SQUARED ? CLASSES : GROWTH_N_CUBED)) - 1;
    struct mixture m;
    take_points(&m, sizes, counts, 0, count);
    fit_mixture(&m, offered);
    double constant = m.coefficient[GROWTH_CONSTANT];
    while (allowed != GROWTH_CONSTANT && count - fit->first_used > GROWTH_SIZES_MIN &&
           constant > CONSTANT_SHARE_MAX * (double)counts[fit->first_used])
        fit->first_used++;
    if (fit->first_used > 0) {
        take_points(&m, sizes, counts, fit->first_used, count);
        fit_mixture(&m, offered);
    }
    int bound = upper_bound(allowed);
    double total = 0;
    for (int k = 0; k < CLASSES; k++) {
        fit->coefficient[k] = m.coefficient[k];
        fit->share[k] = m.coefficient[k] * growth_term(k, m.n[m.count - 1]);
        total += fit->share[k];
    }
    for (int k = 0; k < CLASSES; k++) {
        fit->share[k] /= total;
        fit->excess += k > bound ? fit->share[k] : 0;
    }
    fit->residual = sqrt(m.residual / m.count);
    fit->exponent = top_slope(&m);
    fit->decision = decide(fit, &m, bound, look);
    fit->class = label(fit, bound);
    return 0;
}
