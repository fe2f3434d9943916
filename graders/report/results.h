/* A class's results as a table: students by exercises, read from OUT/results and checked. */
#ifndef GRADERS_REPORT_RESULTS_H
#define GRADERS_REPORT_RESULTS_H

#include "graders/report/words.h"
#include "reference/base/error.h"

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

struct book_exercise {
    const char *name;    /* borrowed from the first result of the exercise, like the others */
    const char *problem; /* number in the course */
    struct phrase title;
    double max_score;
};

struct student {
    const json_t *name; /* the untrusted string */
    const char *folder;
    json_t **results; /* one an exercise; NULL: nothing submitted; owned by the book */
    double score;     /* sum of the scores */
    int unscored;     /* results that are fault or flagged: the sum is not the last word */
};

struct gradebook {
    size_t exercise_count, student_count;
    struct book_exercise *exercises; /* by number in the course, then name */
    struct student *students;        /* by name, then folder */
    double max_score;                /* sum over the exercises */
    json_t **cells;                  /* every student's results, borrowed from `all` */
    json_t *all;                     /* owns the results: an array in no order */
};

/* Reads OUT/results. Every file is checked (result_check, and that it stands where it says): the
 * first that fails is an error that names the file and the remedy. A class without results is an
 * error. */
int gradebook_load(const char *out, struct gradebook *book, struct error *err) MUST_CHECK;

/* The same from results in memory, for tests and `check`; takes a reference of its own. */
int gradebook_from(json_t *results, struct gradebook *book, struct error *err) MUST_CHECK;

/* A zeroed gradebook may be released too. */
void gradebook_release(struct gradebook *book);

/* The standing of a result for its colour: passed, partial (some points, not all), failed,
 * unscored; absent for NULL. */
enum standing result_standing(const json_t *result);

/* The cases of a class that were left out, because others before them did not end in time. */
struct not_run {
    size_t count;
    struct phrase reason; /* what the first of them says; both empty when there is none */
};

/* Those of a class of a result; of all its classes when class_name is NULL. */
struct not_run result_not_run(const json_t *result, const char *class_name);

/* The standing of a class, an entry of the result's classes: absent when no case of it was run. */
enum standing result_class_standing(const json_t *result, const json_t *class_entry);

/* How many of the class's cases passed: "3 of 4", "0 of 2, 2 not run", "not run". */
void result_class_tally(const json_t *result, const json_t *class_entry, struct message *tally);

/* A string of an object, borrowed; "" when it is not there. Not for untrusted text with NUL. */
const char *result_text(const json_t *object, const char *key);

/* A number of an object; 0 when it is not there. */
double result_number(const json_t *object, const char *key);

#endif
