/* What a judge is: one file an exercise, graders/judges/<group>/<name>.c, which defines
 *
 *     const struct judge judge_<name with _ for ->;
 *
 * The build finds it there. A judge makes the inputs of its cases and judges answers by properties
 * of input and answer. It never calls the reference. It runs in a process of its own, without the
 * student's code; the answer's bytes may be anything, so it reads them through a struct reader and
 * checks every index before use. A judge that crashes is our fault, never the student's. */
#ifndef GRADERS_JUDGES_JUDGE_H
#define GRADERS_JUDGES_JUDGE_H

#include "graders/scene/scene.h"
#include "graders/wire/packet.h"
#include "reference/base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A case: one input, one call, one judgement. */
struct judge_case {
    const char *name;       /* unique in the exercise, lower case with dashes: "torus-genus-2" */
    const char *class_name; /* one of the classes in exercise.json, which carry the points */
    uint64_t seed;          /* printed in every report; the input depends on nothing else */
    int64_t parameter[4];   /* the judge's own: sizes, which function is asked, ... */
    bool is_public;         /* students see it and `check` runs it at home */
    bool is_quick;          /* part of `check --quick` */
};

/* What the runner's side measured around the call: exact, but written by the student's process, so
 * a claim until the engine has checked it (it is checked before judge() sees it). */
struct usage {
    int64_t heap_peak_bytes; /* most bytes requested and not yet freed, during the call */
    int64_t heap_held_bytes; /* bytes that the call allocated and had not freed when it returned */
    int64_t heap_left_bytes; /* of these, not freed after all that was returned was freed: leaked */
    int64_t allocation_count;
    bool known; /* false: not measured in this run, judge without it */
};

enum { JUDGEMENT_TEXT = 400 };

/* What judge() says. Starts zeroed, that is: rejected, without a reason. */
struct judgement {
    bool accepted;
    char cause[48];                  /* when rejected: a slug, "duplicate-edge" */
    char element[96];                /* when rejected: the first and smallest element at fault,
                                        "edge 1041 (12,977)"; empty when there is none to name */
    char message[JUDGEMENT_TEXT];    /* one sentence for the student: what, where, what is right */
    char message_es[JUDGEMENT_TEXT]; /* the same in Spanish */
    struct scene scene;              /* what to show; filled only when rejected */
};

struct judge {
    const char *exercise; /* "edge-table-any" */
    const struct judge_case *cases;
    size_t case_count;

    /* Writes the input of a case. `models` is the folder exercises/models. Same case, same bytes.
     */
    int (*make)(const struct judge_case *c, const char *models, struct writer *input,
                struct error *err);

    /* Inputs for counting work: `size` elements (the exercise's n: triangles, ...) of family
     * families[family]. Each seed gives a mesh of the same shape, renumbered and permuted anew.
     * The answer is judged like every other. NULL families: this exercise counts no growth. */
    const char *const *families; /* NULL-terminated: "grid-scrambled", "fan", ... */
    int (*make_sized)(int family, int64_t size, uint64_t seed, struct writer *input,
                      struct error *err);

    /* Judges `answer` to `input` (which this judge made: it may be trusted). Allocation failures
     * are reported by returning -1 and *err (a fault); otherwise returns 0 and fills `out`. */
    int (*judge)(struct span input, struct span answer, const struct usage *usage,
                 struct judgement *out, struct error *err);

    /* Answers hold computed reals. Valgrind computes long double with the precision of double, so
     * that there a right program may answer worse than by itself. */
    bool answers_reals;

    /* Bytes that a right answer to `input` can take at most: the size of the answer's region. */
    size_t (*answer_bound)(struct span input);
};

/* Accepts. */
void judge_accept(struct judgement *out);

/* Rejects with a cause and the same sentence in English and Spanish. Only the first rejection of a
 * judgement counts. Both formats take the same arguments in the same order (use %1$d positions to
 * change the order in one language). */
void judge_reject(struct judgement *out, const char *cause, const char *english,
                  const char *spanish, ...) __attribute__((format(printf, 3, 5)));

/* Names the element at fault, printf style. */
void judge_name_element(struct judgement *out, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

#endif
