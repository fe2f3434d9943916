/* What every judge must keep, whatever its exercise: the same case gives the same bytes, the
 * reference's answers are accepted, the starter's are not, and answers of any bytes are judged,
 * with a reason, and never accepted when they are garbage. */
#include "graders/engine/base/exercise.h"
#include "graders/engine/run/soundness.h"
#include "graders/judges/table.h"
#include "tests/unit/answers.h"
#include "tests/unit/submissions.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { FAILING_LIMIT = 24, ROUNDS = 4000, SIZES = 3, SIZE_SEED = 7 };

static struct exercise *exercises;
static int exercise_count;

static int read_exercises(void **state)
{
    struct error err = {""};
    (void)state;
    if (exercises_read(".", &exercises, &exercise_count, &err) == 0)
        return 0;
    print_error("%s\n", err.text);
    return -1;
}

static int free_exercises(void **state)
{
    (void)state;
    free(exercises);
    return 0;
}

static const struct exercise *exercise_of(const struct judge *judge)
{
    const struct exercise *exercise = exercise_find(exercises, exercise_count, judge->exercise);
    if (!exercise)
        fail_msg("judge %s has no exercise.json", judge->exercise);
    return exercise;
}

static void each_fits_its_exercise(void **state)
{
    (void)state;
    for (const struct judge *const *judge = judge_table; *judge; judge++) {
        struct error err = {""};
        if (soundness_check(exercise_of(*judge), *judge, &err) != 0)
            fail_msg("%s", err.text);
    }
    for (int i = 0; i < exercise_count; i++)
        if (!judge_find(exercises[i].name))
            fail_msg("%s has no judge", exercises[i].name);
}

/* A submission can call what the runner exports: main, the allocation shim, and exactly the functions
 * that exercise.json says are given. */
static void each_runner_gives_what_its_exercise_says(void **state)
{
    (void)state;
    for (int i = 0; i < exercise_count; i++) {
        const struct exercise *exercise = &exercises[i];
        char command[PATH_MAX], line[256];
        int found = 0;
        snprintf(command, sizeof command,
                 "nm -g --defined-only build/runner/%s/%s.plain.o | awk '{print $3}' | "
                 "grep -v '^main$\\|^__wrap_\\|^student_\\|^__ubsan_default_options$'",
                 exercise->group, exercise->name);
        FILE *names = popen(command, "r");
        assert_non_null(names);
        while (fgets(line, sizeof line, names)) {
            bool is_given = false;
            line[strcspn(line, "\n")] = '\0';
            for (int g = 0; g < exercise->given_count; g++)
                is_given |= strcmp(exercise->given[g], line) == 0;
            if (!is_given)
                fail_msg("%s: the runner exports %s, which exercise.json does not list as given",
                         exercise->name, line);
            found++;
        }
        pclose(names);
        if (found != exercise->given_count)
            fail_msg("%s: of %d given functions the runner defines %d", exercise->name,
                     exercise->given_count, found);
    }
}

/* ------------------------------------------------------------------- inputs */

static struct span span_of(const struct writer *writer)
{
    return (struct span){writer->bytes, writer->count};
}

static void make_case(const struct judge *judge, size_t index, struct writer *input)
{
    struct error err = {""};
    *input = writer_growing();
    if (judge_make(judge, &judge->cases[index], "exercises/models", input, &err) != 0)
        fail_msg("%s: case %s: %s", judge->exercise, judge->cases[index].name, err.text);
}

static void make_sized(const struct judge *judge, int family, int64_t size, struct writer *input)
{
    struct error err = {""};
    *input = writer_growing();
    if (judge_make_sized(judge, family, size, SIZE_SEED, input, &err) != 0)
        fail_msg("%s: size %d of %s: %s", judge->exercise, (int)size,
                 judge_family_name(judge, family), err.text);
}

/* Takes both over. */
static void compare_inputs(const struct judge *judge, const char *name, struct writer *first,
                           struct writer *second)
{
    if (first->count != second->count || memcmp(first->bytes, second->bytes, first->count) != 0)
        fail_msg("%s: %s is not the same twice", judge->exercise, name);
    if (judge_answer_bound(judge, span_of(first)) == 0)
        fail_msg("%s: %s has no room for an answer", judge->exercise, name);
    writer_release(first);
    writer_release(second);
}

static void inputs_repeat(void **state)
{
    (void)state;
    for (const struct judge *const *judge = judge_table; *judge; judge++) {
        struct writer first, second;
        for (size_t i = 0; i < (*judge)->case_count; i++) {
            make_case(*judge, i, &first);
            make_case(*judge, i, &second);
            compare_inputs(*judge, (*judge)->cases[i].name, &first, &second);
        }
        int64_t size = exercise_of(*judge)->growth_first_size;
        for (int family = 0; family < judge_family_count(*judge); family++) {
            make_sized(*judge, family, size, &first);
            make_sized(*judge, family, size, &second);
            compare_inputs(*judge, judge_family_name(*judge, family), &first, &second);
        }
    }
}

/* ------------------------------------------------------------- known answers */

static void build(const struct judge *judge, const char *format, struct submission *submission)
{
    char source[PATH_MAX];
    const char *group = exercise_of(judge)->group;
    snprintf(source, sizeof source, "%s/%s/%s%s",
             *format == '/' ? "exercises" : "reference/answers", group, judge->exercise, format);
    submission_build(submission, group, judge->exercise, source);
}

/* Judges what a program answers to a case, or to a size (c NULL). `why` says what is wrong with it, and is empty when it is right.
 */
static void judge_run(const struct judge *judge, const struct judge_case *c,
                      const struct submission *submission, struct span input, char *why,
                      size_t capacity)
{
    struct submission_answer answer;
    struct judgement judgement = {0};
    struct error err = {""};
    *why = '\0';
    submission_run(submission, input, judge_answer_bound(judge, input), 0, &answer);
    struct span bytes = {answer.bytes, answer.count};
    if (answer.end != SUBMISSION_ANSWERED)
        snprintf(why, capacity, "no answer");
    else if (judge_case_answer(judge, c, input, bytes, &answer.usage, &judgement, &err) != 0)
        fail_msg("%s: the judge failed: %s", judge->exercise, err.text);
    else if (!judgement.accepted)
        snprintf(why, capacity, "%s [%s]: %s", judgement.cause, judgement.element.en,
                 judgement.message.en);
    else if (answer.usage.heap_left_bytes != 0 || answer.bad_free_count != 0)
        snprintf(why, capacity, "leaks, or frees what it must not");
    scene_release(&judgement.scene);
    submission_answer_release(&answer);
}

/* Every allocation fails once: the program must say that memory ran out, or do without, and leave
 * nothing behind. */
static void fail_allocations(const struct judge *judge, const struct submission *submission,
                             struct span input, const char *name)
{
    for (int64_t failing = 1; failing <= FAILING_LIMIT; failing++) {
        struct submission_answer answer;
        submission_run(submission, input, judge_answer_bound(judge, input), failing, &answer);
        bool reached = answer.usage.allocation_count >= failing;
        if (answer.end == SUBMISSION_DIED || answer.usage.heap_left_bytes || answer.bad_free_count)
            fail_msg("%s, case %s: allocation %d fails: the reference %s", judge->exercise, name,
                     (int)failing, answer.end == SUBMISSION_DIED ? "dies" : "leaks");
        submission_answer_release(&answer);
        if (!reached)
            return;
    }
}

static void check_sizes(const struct judge *judge, const struct submission *reference)
{
    char why[1400];
    int64_t first = exercise_of(judge)->growth_first_size;
    for (int family = 0; family < judge_family_count(judge); family++)
        for (int i = 0; i < SIZES; i++) {
            struct writer input;
            make_sized(judge, family, first << i, &input);
            judge_run(judge, NULL, reference, span_of(&input), why, sizeof why);
            writer_release(&input);
            if (*why)
                fail_msg("%s: size %d of %s: the reference: %s", judge->exercise, (int)(first << i),
                         judge_family_name(judge, family), why);
        }
}

static void the_reference_is_accepted(void **state)
{
    (void)state;
    for (const struct judge *const *judge = judge_table; *judge; judge++) {
        struct submission reference;
        char why[1400];
        build(*judge, ".c", &reference);
        for (size_t i = 0; i < (*judge)->case_count; i++) {
            struct writer input;
            make_case(*judge, i, &input);
            judge_run(*judge, &(*judge)->cases[i], &reference, span_of(&input), why, sizeof why);
            if (*why)
                fail_msg("%s, case %s: the reference: %s", (*judge)->exercise,
                         (*judge)->cases[i].name, why);
            fail_allocations(*judge, &reference, span_of(&input), (*judge)->cases[i].name);
            writer_release(&input);
        }
        check_sizes(*judge, &reference);
        submission_release(&reference);
    }
}

static void the_starter_fails_the_basic_class(void **state)
{
    (void)state;
    for (const struct judge *const *judge = judge_table; *judge; judge++) {
        struct submission starter;
        bool failed = false;
        build(*judge, "/starter.c", &starter);
        for (size_t i = 0; i < (*judge)->case_count && !failed; i++) {
            struct writer input;
            char why[1400];
            if (strcmp((*judge)->cases[i].class_name, exercise_of(*judge)->classes[0].name) != 0)
                continue;
            make_case(*judge, i, &input);
            judge_run(*judge, &(*judge)->cases[i], &starter, span_of(&input), why, sizeof why);
            failed = *why;
            writer_release(&input);
        }
        submission_release(&starter);
        if (!failed)
            fail_msg("%s: the starter passes the first class", (*judge)->exercise);
    }
}

/* --------------------------------------------------------------- any answers */

static void any_bytes_are_judged(void **state)
{
    (void)state;
    for (const struct judge *const *judge = judge_table; *judge; judge++)
        answers_fuzz(*judge, exercise_of(*judge)->group, ROUNDS);
}

static void garbage_is_rejected(void **state)
{
    (void)state;
    for (const struct judge *const *judge = judge_table; *judge; judge++)
        answers_refuse_garbage(*judge, exercise_of(*judge)->group);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(each_fits_its_exercise),
                                       cmocka_unit_test(each_runner_gives_what_its_exercise_says),
                                       cmocka_unit_test(inputs_repeat),
                                       cmocka_unit_test(the_reference_is_accepted),
                                       cmocka_unit_test(the_starter_fails_the_basic_class),
                                       cmocka_unit_test(any_bytes_are_judged),
                                       cmocka_unit_test(garbage_is_rejected)};
    return cmocka_run_group_tests(tests, read_exercises, free_exercises);
}
