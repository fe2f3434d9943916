/* A benchmark run as its page sees it: bench.json (bench/compare/README.md), checked and cleaned.
 *
 * What stands in the file is believed as little as any other: texts are cut at STUDY_TEXT_BYTES and
 * cleaned when it is read, numbers that are none are NaN here, and whatever is missing makes a
 * chart or a table smaller, never a page fail. */
#ifndef GRADERS_REPORT_BENCH_STUDY_H
#define GRADERS_REPORT_BENCH_STUDY_H

#include "reference/base/error.h"

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

enum { STUDY_TEXT_BYTES = 160, STUDY_NAMES_MAX = 40 };

struct study {
    json_t *document;
    const json_t *rows; /* borrowed from it; an array of objects */
    const char *root;   /* the tree that holds exercises/models, or NULL; set by its owner */
};

/* Takes a document over; the caller ends with study_release, also after an error. Returns 0, or -1
 * and *err: not of the schema meshgrade-bench-1. NULL as the document is an error. */
int study_take(struct study *study, json_t *document, struct error *err) MUST_CHECK;
void study_release(struct study *study);

/* -- values ------------------------------------------------------------------------------------ */

/* A text, "" when there is none; a finite number, NaN when there is none. Borrowed. */
const char *study_text(const json_t *object, const char *key);
double study_number(const json_t *object, const char *key);

/* Median time of a row, ns: of a query where the operation is one, else of a triangle. NaN when it
 * has none. */
double study_time(const json_t *row);

/* What an interval's confidence must be to decide anything. */
#define STUDY_CONFIDENCE 0.95

/* Whether a ratio can be told as a number: not too noisy, and with confidence. */
bool study_is_decided(const json_t *ratio);

/* -- rows -------------------------------------------------------------------------------------- */

/* What rows are wanted; NULL: any. */
struct wanted {
    const char *what, *kind, *subject, *variant, *operation, *mesh, *mesh_kind, *order;
};

bool study_matches(const json_t *row, const struct wanted *wanted);

/* The first row wanted, or NULL; how many there are. */
const json_t *study_find(const struct study *study, const struct wanted *wanted);
size_t study_count(const struct study *study, const struct wanted *wanted);

/* The mesh on which most rows wanted were measured; of equally many a real model, then the larger
 * one, then one in its own order. NULL when there is none. Borrowed. */
const char *study_mesh(const struct study *study, const struct wanted *wanted);

/* Different values of a key among the rows wanted, in their order. Returns how many. Borrowed. */
size_t study_names(const struct study *study, const struct wanted *wanted, const char *key,
                   const char *names[STUDY_NAMES_MAX]);

/* -- words ------------------------------------------------------------------------------------- */

/* "faces around a vertex" for faces-around-vertex, "edge table, any orientation" for edges-any; of
 * an unknown operation its name. */
const char *study_operation(const char *operation);

/* The same in a word or two, for heads of narrow columns. */
const char *study_operation_short(const char *operation);

/* The title of a subject, from its first row. */
const char *study_title(const struct study *study, const char *what, const char *subject);

/* "torus-100k-scrambled" as "torus (100k triangles, scrambled)". */
void study_mesh_words(const char *mesh, char *text, size_t capacity);

/* "1.80 ns", "246 µs", "11.3 ms"; "11.3", "246", "1.4k", "20M" for other numbers. */
void study_time_words(double ns, char *text, size_t capacity);
void study_number_words(double number, char *text, size_t capacity);

/* Operations of representations in the order of the course: NULL-terminated; whether one asks about
 * single elements. */
extern const char *const study_operations[];
bool study_is_query(const char *operation);

#endif
