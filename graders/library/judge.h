/* What a judge is: one file an exercise, graders/judges/<group>/<name>.c, which defines
 *
 *     const struct judge judge_<name with _ for ->;
 *
 * The build finds it there. A judge says what the inputs are (cases and families of sizes), what is
 * answered, and judges answers by properties of input and answer. It never calls the reference
 * answer; reference/mesh and reference/representation, the library, it may use.
 *
 * It runs in a process of its own, without the student's code; an answer may hold anything. What is
 * declared (input, answer) is read, bounded and looked through before judge() is called; the rest
 * it reads through a struct reader and checks before use. A judge that crashes is our fault, never
 * the student's.
 *
 * graders/library/library.h leads through the library, with an example of each part. */
#ifndef GRADERS_LIBRARY_JUDGE_H
#define GRADERS_LIBRARY_JUDGE_H

#include "graders/library/answer.h"
#include "graders/library/attributes.h"
#include "graders/library/families.h"
#include "graders/library/fields.h"
#include "graders/library/judgement.h"
#include "graders/library/lines.h"
#include "graders/library/mesh_input.h"
#include "graders/library/polygons.h"
#include "graders/library/quality.h"
#include "graders/library/recipe.h"
#include "reference/base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* When a case runs. */
enum case_runs {
    HIDDEN = 0,      /* only in grading */
    PUBLIC = 1 << 0, /* students see it and `check` runs it at home */
    QUICK = 1 << 1   /* part of `check --quick` (when public) and of quick trials */
};

struct question; /* questions.h: for exercises that ask several functions */

/* A case: one input, one call, one judgement. */
struct judge_case {
    const char *name;       /* unique in the exercise, lower case with dashes: "torus-genus-2" */
    const char *class_name; /* one of the classes in exercise.json, which carry the points */
    uint64_t seed; /* unique in the exercise; printed in reports; decides all that is random */
    unsigned runs; /* enum case_runs */
    struct mesh_recipe mesh;    /* INPUT_MESH, _TOPOLOGY, _POLYGONS, _SOUP: the input */
    struct line_recipe line;    /* INPUT_LINE */
    struct field_recipe field;  /* INPUT_FIELD */
    const struct question *ask; /* INPUT_QUESTION: the function that is asked */
    int64_t number[4];          /* given beside the mesh, or the judge's own */
};

/* What the runner's side measured around the call: exact, but written by the student's process, so
 * a claim until the engine has checked it (it is checked before judge() sees it). */
struct usage {
    int64_t heap_peak_bytes; /* most bytes requested and not yet freed, during the call */
    int64_t heap_held_bytes; /* bytes that the call allocated and had not freed when it returned */
    int64_t heap_left_bytes; /* of these, not freed after all that was returned was freed: leaked */
    int64_t allocation_count;
    bool known;           /* false: not measured in this run, judge without it */
    int64_t access_count; /* calls of the functions that the exercise gives; counted in every run,
                             but only a claim: judges look whether it can be true (accesses.h) */
};

/* What an exercise's function gets. */
enum judge_input {
    INPUT_OWN,      /* make() writes it */
    INPUT_MESH,     /* triangles and positions */
    INPUT_TOPOLOGY, /* the same; vast meshes come without positions, which no function reads */
    INPUT_POLYGONS, /* faces of any size */
    INPUT_SOUP,     /* triangles of a mesh recipe, nine floats each */
    INPUT_LINE,     /* points, a polyline or a polygon: lines.h */
    INPUT_FIELD,    /* heights or a volume: fields.h */
    INPUT_QUESTION  /* questions.h */
};

struct judge;

/* One answer to judge. */
struct task {
    const struct judge *judge;
    const struct usage *usage;
    struct span input, said; /* all bytes; the input may be trusted */
    struct input_sizes sizes;
    struct mesh_view mesh;        /* INPUT_MESH, INPUT_TOPOLOGY */
    struct polygon_view polygons; /* INPUT_POLYGONS */
    struct soup_view soup;        /* INPUT_SOUP */
    struct line_view line;        /* INPUT_LINE */
    struct field_view field;      /* INPUT_FIELD */
    int64_t number[4];            /* what the case gives beside the mesh */
    struct attribute_view attribute[ATTRIBUTES_MOST];
    struct reader beside; /* what write_beside wrote; a copy of it reads */
    struct answer answer; /* when the judge declares one: read and bounded */
};

struct judge {
    const char *exercise; /* "edge-table-any" */
    const struct judge_case *cases;
    size_t case_count;

    enum judge_input input;
    int numbers; /* how many of a case's numbers are given with the input */
    struct attribute_rule attributes[ATTRIBUTES_MOST]; /* given with the mesh: attributes.h */
    const struct size_family *families; /* ended by a name NULL; NULL: no growth is counted */
    const struct answer_rule *answer;   /* NULL: judge() reads task->said itself */

    /* Judges an answer. Allocation failures are reported by returning -1 and *err (a fault);
     * otherwise returns 0 and fills `out`. */
    int (*judge)(const struct task *task, struct judgement *out, struct error *err);

    /* Answers hold computed reals. Valgrind computes long double with the precision of double, so
     * that there a right program may answer worse than by itself. */
    bool answers_reals;

    /* A right answer's quality, a number that is shown in reports and that classes may bound. */
    struct quality_rule quality;

    /* INPUT_OWN: writes the input of a case. `models` is the folder exercises/models. Same case,
     * same bytes. */
    int (*make)(const struct judge_case *c, const char *models, struct writer *input,
                struct error *err);

    /* Inputs of FAMILY_OWN: `size` elements of family families[family]. Each seed gives an input of
     * the same shape, renumbered and permuted anew. */
    int (*make_sized)(int family, int64_t size, uint64_t seed, struct writer *input,
                      struct error *err);

    /* The size near `size`, which may be any number, that make_sized can make. NULL: all of them. */
    int64_t (*size_near)(int family, int64_t size);

    /* What is given beside an input that is declared, and must be computed from it: a structure of
     * the mesh, the elements that are asked for. `task` has the input and the numbers, of which
     * all four are then given. What is written here the judge reads by task->beside, and the runner
     * after what it was given. NULL: nothing. */
    int (*write_beside)(const struct task *task, uint64_t seed, struct writer *beside,
                        struct error *err);

    /* Without `answer`: bytes that an answer to `input` can take at most, wrong ones included. */
    size_t (*bound)(struct span input);
};

/* -- for the engine ---------------------------------------------------------------------------- */

static inline bool judge_case_is_public(const struct judge_case *c)
{
    return c->runs & PUBLIC;
}

static inline bool judge_case_is_quick(const struct judge_case *c)
{
    return c->runs & QUICK;
}

int judge_family_count(const struct judge *judge);
const char *judge_family_name(const struct judge *judge, int family);

/* The size near `size` that a family of the judge has. */
int64_t judge_size_near(const struct judge *judge, int family, int64_t size);

/* Writes the input of a case, or of a size of a family. Return 0, or -1 and *err. */
int judge_make(const struct judge *judge, const struct judge_case *c, const char *models,
               struct writer *input, struct error *err) MUST_CHECK;
int judge_make_sized(const struct judge *judge, int family, int64_t size, uint64_t seed,
                     struct writer *input, struct error *err) MUST_CHECK;

/* Bytes that an answer to `input` can take at most: the size of the answer's region. */
size_t judge_answer_bound(const struct judge *judge, struct span input);

/* Memory that a program needs that has a table entry for each vertex of the input, though the
 * packet may be small: what tools that slow programs down should look at. */
size_t judge_input_weight(const struct judge *judge, struct span input);

/* Judges `answer` to `input` (which this judge made: it may be trusted), whether it is right: bands
 * of quality belong to the classes of cases. Returns 0 and fills `out`, or -1 and *err: our own
 * failure. */
int judge_answer(const struct judge *judge, struct span input, struct span answer,
                 const struct usage *usage, struct judgement *out, struct error *err) MUST_CHECK;

/* The same of the answer to case `c` (NULL: to no case), which is held to the band of the case's
 * class too. */
int judge_case_answer(const struct judge *judge, const struct judge_case *c, struct span input,
                      struct span answer, const struct usage *usage, struct judgement *out,
                      struct error *err) MUST_CHECK;

/* -- for judges -------------------------------------------------------------------------------- */

/* Puts the input's mesh or polygons into the scene of a rejection. Returns 0, or -1 and *err. */
int task_show(const struct task *task, struct judgement *out, struct error *err) MUST_CHECK;

#endif
