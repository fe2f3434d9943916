/* Why points were lost: the causes of an exercise's rejected cases and failed checks over a class.
 * What shares slug and hint (what a message says behind its first sentence) is one cause: a hint is
 * the diagnosis of one submission, and is told of nobody to whom it was not given. */
#ifndef GRADERS_REPORT_CAUSES_H
#define GRADERS_REPORT_CAUSES_H

#include "graders/report/results.h"

struct class_cause {
    const char *slug;      /* borrowed: a case's cause, "duplicate-edge", or a check's verdict */
    const json_t *part;    /* borrowed: the first case with it; NULL of a check or a refusal */
    const char *check;     /* borrowed: the check's name; "" of a case */
    struct phrase example; /* borrowed: the first message with this cause; may be empty */
    const json_t *result;  /* the result that the example is from */
    const char *case_name; /* the first case with this cause and a scene; NULL when there is none */
    const json_t *scene_result; /* and its result */
    size_t student_count;
    size_t row; /* for causes_touch */
};

struct causes {
    struct class_cause *list; /* most frequent first, then by slug, then by first student */
    size_t count;
    size_t answer_count; /* students who submitted the exercise */
    bool *touched;       /* a row of students for each cause */
    size_t student_count;
};

/* Counts each cause once a student, and a student with several hints of one slug at the first.
 * Release the causes before the gradebook. */
int causes_of(const struct gradebook *book, size_t exercise, struct causes *causes,
              struct error *err) MUST_CHECK;

/* Whether a student of the gradebook lost points by a cause. */
bool causes_touch(const struct causes *causes, const struct class_cause *cause, size_t student);

/* The name of a cause for people; one of an earlier version's results is written to `room`. */
struct phrase causes_name(const struct class_cause *cause, char *room, size_t capacity);

void causes_release(struct causes *causes);

#endif
