/* The quality of right answers: a number that a judge measures ("indices per triangle"), shown in
 * reports, and bands that classes may set.
 *
 *     .quality = {.name = {"indices per triangle", "índices por triángulo"},
 *                 .less_is_better = true,
 *                 .bands = {{"quality-fair", 1.6}, {"quality-good", 1.25}}},
 *
 * and, in judge(), of a right answer:
 *
 *     judge_quality(out, (double)index_count / triangle_count);
 *     judge_accept(out);
 *
 * The library rejects what lies beyond the band of the case's class, with number and limit in both
 * languages; no judge does. Of the cases of all other classes the number is shown only, so that a
 * right but poor answer keeps its points of correctness. The cases of a band's class are usually
 * those of a class of correctness once more. What a judge marked in the scene before it accepted is
 * shown when the band rejects (else the input): the worst elements.
 *
 * A right answer without a number where a band asks for one, or with a number that is not finite,
 * is a fault of the judge. */
#ifndef GRADERS_LIBRARY_QUALITY_H
#define GRADERS_LIBRARY_QUALITY_H

#include "graders/library/judgement.h"
#include "reference/base/error.h"

#include <stdbool.h>

enum { QUALITY_BANDS = 4 };

/* The limit of a class: the number itself is within. */
struct quality_band {
    const char *class_name; /* NULL ends the list */
    double limit;
    struct phrase name; /* "fair"; left out: known for quality-fair, -good and -best, and else the
                           class's title stands for it */
};

struct quality_rule {
    struct phrase name; /* left out: the exercise measures no quality */
    struct phrase unit; /* {"degrees", "grados"}; left out: the name says it. "1.31 indices per
                           triangle", with a unit "smallest angle 23.1 degrees" */
    bool less_is_better;
    struct quality_band bands[QUALITY_BANDS]; /* any order */
};

/* The cause of a rejection by a band. */
extern const struct cause quality_poor;

/* Whether an exercise measures quality. */
bool quality_is_measured(const struct quality_rule *rule);

/* Bands that are set. */
int quality_band_count(const struct quality_rule *rule);

/* The band of a class, NULL when it has none. */
const struct quality_band *quality_band_of(const struct quality_rule *rule, const char *class_name);

/* What reports call a band. */
struct phrase quality_band_name(const struct quality_band *band, struct phrase class_title);

/* Whether `a` is worse than `b`. */
bool quality_is_worse(const struct quality_rule *rule, double a, double b);

/* Holds an accepted answer to the band of `class_name` (NULL: to none), and rejects it when it is
 * beyond. Returns 0, or -1 and *err: the judge told no number where one is needed, or one that is
 * not finite or not declared. */
int quality_judge(const struct quality_rule *rule, const char *class_name, struct judgement *out,
                  struct error *err) MUST_CHECK;

#endif
