/* Comparing real numbers and tables of them: how near is near enough, which row is wrong first and
 * which is worst, and whether all rows agree with a mistake that people make.
 *
 *     struct real_rule rule = {.tolerance = {.relative = 1e-6}};
 *     struct real_fault fault;
 *     if (reals_compare(&found, right, vertex_count, 1, &rule, &fault, err))
 *         return -1;
 *     if (fault.wrong_count > 0) {
 *         const struct mistake *mistake =
 *             reals_mistake(&found, right, vertex_count, 1, &rule, tolerance_usual_mistakes, NULL);
 *         ... row fault.row is fault.found; right is fault.right; mistake->hint if there is one ...
 *     }
 *     real_fault_release(&fault);
 *
 * NaN and infinity are never right. */
#ifndef GRADERS_LIBRARY_TOLERANCE_H
#define GRADERS_LIBRARY_TOLERANCE_H

#include "reference/base/error.h"
#include "reference/base/phrase.h"

#include <stdbool.h>
#include <stdint.h>

/* What is allowed is the sum of the parts that are not 0. */
struct tolerance {
    double absolute;
    double relative;    /* of the right value, or of the row's scale (struct real_rule) */
    double float_ulps;  /* steps of binary32 at the right value */
    double double_ulps; /* steps of binary64 there */
};

/* How far from a right value a number may be; scale: what `relative` is relative to. */
double tolerance_at(const struct tolerance *tolerance, double right, double scale);

/* Whether a number is near enough to the right one. */
bool tolerance_allows(const struct tolerance *tolerance, double found, double right);

/* The next step up from |x|: of binary32 and of binary64. x finite. */
double float_ulp(double x);
double double_ulp(double x);

/* The angle between two vectors in radians, 0 ... pi, exact also where it is small or near pi; NaN
 * when one is (0,0,0) or not finite. */
double angle_between(const double a[3], const double b[3]);

/* How far apart two angles in radians are around the circle, 0 ... pi. */
double angle_difference(double a, double b);

/* -- tables ---------------------------------------------------------------------------------- */

/* The numbers of an answer, borrowed: one of the two is not NULL. */
struct reals {
    const float *floats;
    const double *doubles;
};

enum real_kind {
    REAL_NUMBERS,
    REAL_ANGLES,    /* radians, around the circle */
    REAL_DIRECTIONS /* rows of 3: the angle between them is compared with `absolute`; lengths are
                       not looked at */
};

struct real_rule {
    enum real_kind kind;
    struct tolerance tolerance;
    const double *scale; /* an entry a row: what `relative` is relative to; NULL: the right value */
};

struct real_fault {
    int64_t row; /* the first wrong row; -1: none */
    int column;  /* its first wrong number */
    double found, right;
    int64_t wrong_count; /* rows */
    int64_t
        worst_row; /* the row that is wrong by the most of its tolerance, the first of several */
    int worst_column;
    double worst_error; /* there: the difference (REAL_DIRECTIONS: the angle); infinity where the
                           number is not finite */
    int64_t not_finite_row, not_finite_count; /* rows with NaN or infinity; -1 and 0: none */
    uint8_t *marks;                           /* of each row: 0 fine, 1 wrong */
};

/* Compares rows of `width` numbers.
 *
 * right     finite
 * fault     on success the caller owns it (real_fault_release)
 * returns   0, or -1 and *err (out of memory, a negative count, width out of 1 ... REAL_WIDTH_MOST)
 * cost      linear */
enum { REAL_WIDTH_MOST = 32 };
int reals_compare(const struct reals *found, const double *right, int64_t row_count, int width,
                  const struct real_rule *rule, struct real_fault *fault,
                  struct error *err) MUST_CHECK;
void real_fault_release(struct real_fault *fault);

/* -- mistakes --------------------------------------------------------------------------------- */

/* Where a mistake is tried. */
struct mistake_place {
    double right;
    int64_t row;
    int column;
    const void *context; /* of the caller of reals_mistake */
};

/* A mistake and the value that it leads to: a function of the place, or else a factor. */
struct mistake {
    struct cause cause; /* slug NULL ends a list */
    struct phrase hint; /* a sentence */
    double factor;
    double (*value)(const struct mistake_place *place);
    double slack; /* what is allowed in addition, relative to the value */
};

/* Half, double, a third, three and six times, the other sign, the sign lost, degrees for radians
 * and the reverse, squared, square root, reciprocal, the other angle (pi - x), zero everywhere,
 * and right but for rounding as by float. For angles and areas and lengths alike; make a list of
 * your own where some of these cannot be. */
extern const struct mistake tolerance_usual_mistakes[];

/* The first mistake of a list with which every row agrees within the tolerance; NULL: none, or no
 * rows. Ask only when something is wrong: then the mistake explains it. */
const struct mistake *reals_mistake(const struct reals *found, const double *right,
                                    int64_t row_count, int width, const struct real_rule *rule,
                                    const struct mistake *list, const void *context);

#endif
