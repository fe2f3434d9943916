/* What a judge says of an answer: accepted, or rejected with a cause, the element at fault, a
 * sentence and a scene, for people in English and Spanish. */
#ifndef GRADERS_LIBRARY_JUDGEMENT_H
#define GRADERS_LIBRARY_JUDGEMENT_H

#include "graders/scene/scene.h"
#include "reference/base/phrase.h"

#include <stdbool.h>

/* Starts zeroed, that is: rejected, without a reason. */
struct judgement {
    bool accepted;
    char cause[CAUSE_SLUG];    /* when rejected: a slug, "duplicate-edge" */
    struct message cause_name; /* the same for people, "duplicate edge" */
    struct message element;    /* when rejected: the first and smallest element at fault,
                                  "edge 1041 (12,977)"; empty when there is none to name */
    struct message message;    /* for the student: what is wrong, where, what is right; the first
                                  sentence is of this case, what follows it is a hint, by which the
                                  mistakes of a class are grouped */
    struct scene scene;        /* what to show; filled only when rejected */
    double quality;            /* of an answer that was right, though a band may have rejected it:
                                  quality.h */
    bool has_quality;
};

/* Accepts. */
void judge_accept(struct judgement *out);

/* Tells the quality of a right answer, a finite number (quality.h). Before or after judge_accept. */
void judge_quality(struct judgement *out, double quality);

/* Rejects with a cause and the same sentence in English and Spanish, printf style; both formats
 * take the same arguments in the same order (use %1$d positions to change the order in one
 * language). Only the first rejection of a judgement counts. */
void judge_reject(struct judgement *out, const struct cause *cause, const char *en, const char *es,
                  ...) __attribute__((format(printf, 3, 5), format(printf, 4, 5)));

/* Rejects with a cause; the sentence is then put together by judge_en and judge_es, where words and
 * not only their order differ. Returns whether it counts: false when rejected already. */
bool judge_reject_for(struct judgement *out, const struct cause *cause);
void judge_en(struct judgement *out, const char *format, ...) __attribute__((format(printf, 2, 3)));
void judge_es(struct judgement *out, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Appends a hint, with a space before it; no phrase, nothing. */
void judge_hint(struct judgement *out, struct phrase hint);

/* Names the element at fault, printf style; both formats take the same arguments. */
void judge_name(struct judgement *out, const char *en, const char *es, ...)
    __attribute__((format(printf, 2, 4), format(printf, 3, 4)));

/* Names it by a noun and what tells it apart, the same in both languages: "edge 4 (3,9)". */
void judge_name_one(struct judgement *out, struct phrase noun, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
