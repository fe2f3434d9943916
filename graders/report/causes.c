/* Counting causes; see causes.h. */
#include "graders/report/causes.h"

#include <stdlib.h>
#include <string.h>

/* ---------------------------------------------------------------- hints */

/* Where the hint of a message begins: behind its first sentence, which tells what was found in the
 * one case. */
static const char *hint_of(const char *message)
{
    const char *end = strstr(message, ". ");
    return end ? end + 2 : "";
}

static bool is_number_part(char c)
{
    return (c >= '0' && c <= '9') || c == '-';
}

/* Whether two hints say the same, whatever numbers they name. */
static bool is_same_hint(const char *one, const char *other)
{
    while (*one && *other) {
        if (is_number_part(*one) && is_number_part(*other)) {
            while (is_number_part(*one))
                one++;
            while (is_number_part(*other))
                other++;
        } else if (*one++ != *other++) {
            return false;
        }
    }
    return *one == *other;
}

/* ---------------------------------------------------------------- the list */

/* What a case or check says of lost points. */
struct note {
    const char *slug;
    const char *check; /* name of the check, "" of a case: one verdict can be of two checks */
    struct phrase message;
    const json_t *one; /* the case; NULL when it is none */
};

static struct class_cause *find(const struct causes *causes, const struct note *note)
{
    for (size_t i = 0; i < causes->count; i++) {
        struct class_cause *cause = &causes->list[i];
        if (strcmp(cause->slug, note->slug) == 0 && strcmp(cause->check, note->check) == 0 &&
            is_same_hint(hint_of(cause->example.en), hint_of(note->message.en)))
            return cause;
    }
    return NULL;
}

/* The cause of this slug that a student has already. */
static struct class_cause *find_of_student(const struct causes *causes, const struct note *note,
                                           size_t student)
{
    for (size_t i = 0; i < causes->count; i++)
        if (strcmp(causes->list[i].slug, note->slug) == 0 &&
            strcmp(causes->list[i].check, note->check) == 0 &&
            causes->touched[causes->list[i].row * causes->student_count + student])
            return &causes->list[i];
    return NULL;
}

static struct class_cause *add(struct causes *causes, const struct note *note, const json_t *result)
{
    struct class_cause *list = realloc(causes->list, (causes->count + 1) * sizeof *list);
    if (!list)
        return NULL;
    causes->list = list;
    size_t columns = causes->student_count;
    bool *touched = realloc(causes->touched, (causes->count + 1) * columns * sizeof *touched);
    if (!touched)
        return NULL;
    causes->touched = touched;
    memset(touched + causes->count * columns, 0, columns * sizeof *touched);
    struct class_cause *added = &list[causes->count];
    *added = (struct class_cause){.slug = note->slug,
                                  .part = note->one,
                                  .check = note->check,
                                  .example = note->message,
                                  .result = result,
                                  .row = causes->count};
    causes->count++;
    return added;
}

/* Notes that `student` lost points. Of the cases of one slug the first tells the student's cause:
 * the others are the same mistake on other inputs. */
static int take_note(struct causes *causes, size_t student, const json_t *result,
                     const struct note *note)
{
    struct class_cause *cause = find_of_student(causes, note, student);
    if (!cause)
        cause = find(causes, note);
    if (!cause)
        cause = add(causes, note, result);
    if (!cause)
        return -1;
    bool *touched = &causes->touched[cause->row * causes->student_count + student];
    cause->student_count += !*touched;
    *touched = true;
    if (!cause->case_name && json_is_true(json_object_get(note->one, "scene"))) {
        cause->case_name = result_text(note->one, "name");
        cause->scene_result = result;
    }
    return 0;
}

static int note_result(struct causes *causes, size_t student, const json_t *result)
{
    size_t i;
    json_t *part;
    json_array_foreach(json_object_get(result, "cases"), i, part)
    {
        struct note note = {result_text(part, "cause"), "", words_in(part, "message"), part};
        if (words_standing(result_text(part, "verdict")) == STANDING_FAILED &&
            take_note(causes, student, result, &note) != 0)
            return -1;
    }
    json_array_foreach(json_object_get(result, "checks"), i, part)
    {
        struct note note = {result_text(part, "verdict"), result_text(part, "name"),
                            words_in(part, "message"), NULL};
        if (words_standing(note.slug) == STANDING_FAILED &&
            take_note(causes, student, result, &note) != 0)
            return -1;
    }
    struct note refusal = {"compile-error", "", words_in(result, "summary"), NULL};
    if (strcmp(result_text(result, "verdict"), refusal.slug) == 0)
        return take_note(causes, student, result, &refusal);
    return 0;
}

static int by_frequency(const void *a, const void *b)
{
    const struct class_cause *one = a;
    const struct class_cause *other = b;
    if (one->student_count != other->student_count)
        return one->student_count > other->student_count ? -1 : 1;
    int order = strcmp(one->slug, other->slug);
    return order ? order : one->row < other->row ? -1 : one->row > other->row;
}

int causes_of(const struct gradebook *book, size_t exercise, struct causes *causes,
              struct error *err)
{
    *causes = (struct causes){.student_count = book->student_count};
    for (size_t s = 0; s < book->student_count; s++) {
        const json_t *result = book->students[s].results[exercise];
        if (!result)
            continue;
        causes->answer_count++;
        if (note_result(causes, s, result) != 0) {
            causes_release(causes);
            return error_set(err, "out of memory for the causes");
        }
    }
    if (causes->count > 0)
        qsort(causes->list, causes->count, sizeof *causes->list, by_frequency);
    return 0;
}

bool causes_touch(const struct causes *causes, const struct class_cause *cause, size_t student)
{
    return causes->touched[cause->row * causes->student_count + student];
}

void causes_release(struct causes *causes)
{
    free(causes->touched);
    free(causes->list);
    *causes = (struct causes){0};
}

struct phrase causes_name(const struct class_cause *cause, char *room, size_t capacity)
{
    return cause->part ? words_cause(cause->part, room, capacity) : words_verdict(cause->slug);
}
