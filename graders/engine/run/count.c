/* Measures memory and work on sized inputs; see count.h. */
#include "graders/engine/run/count.h"

#include "graders/engine/run/series.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const struct cause no_counts = {"no-counts", {"doubtful counts", "cuentas dudosas"}};

enum {
    SIZES_BEFORE_HOPELESS = 4,
    BESIDE_SLACK = 200000,          /* instructions */
    HOPELESS_RATIO = 50,            /* cost over the reference's ... */
    ALLOCATION_OVERHEAD_BYTES = 64, /* of a block, at most */
    OVERHEAD_TO_HEAP = 8,           /* blocks of 8 bytes on average, at the least */
    STACK_BYTES_MAX = 16 << 20,
    RESIDENT_SLACK_BYTES = 1 << 20
};
static const double HOPELESS_RISE = 2.83; /* ... while a doubling costs more than n^1.5 would */

static const struct call_limits native_limits = {10000000000LL, 2000000000LL};
static const struct call_limits counted_limits = {120000000000LL, 10000000000LL};

bool count_available(char *reason, size_t capacity)
{
    bool found = access("/usr/bin/valgrind", X_OK) == 0;
    snprintf(reason, capacity, "%s",
             found ? "" : "valgrind is not installed (apt-get install valgrind)");
    return found;
}

/* The sized inputs of one family that are to be measured. */
struct range {
    struct yardstick *yardstick;
    int family, first, last;
};

static int start(const struct range *range, const struct build *build, enum series_tool tool,
                 struct series *series, struct error *err)
{
    struct series_plan plan = {.yardstick = range->yardstick,
                               .build = build,
                               .tool = tool,
                               .mode = tool == SERIES_PLAIN ? MODE_PAINT_STACK : MODE_PLAIN,
                               .cpu = -1};
    for (int i = range->first; i <= range->last; i++) {
        const struct input *input;
        if (yardstick_sized(range->yardstick, range->family, i, &input, err) != 0)
            return -1;
        if (input->bytes > plan.input_bytes)
            plan.input_bytes = input->bytes;
        if (input->answer_bound > plan.answer_bytes)
            plan.answer_bytes = input->answer_bound;
    }
    return series_start(series, &plan, err);
}

/* A claim of memory, as far as it can be true. */
static int64_t possible(int64_t claimed, int64_t most)
{
    return claimed < 0 ? 0 : claimed < most ? claimed : most;
}

static int64_t possible_heap(const struct range *range, const struct control *claims)
{
    return possible(claims->heap_peak_bytes, range->yardstick->exercise->memory_limit_bytes);
}

/* What the allocator adds to blocks that all lived at once. The number of blocks is believed as far
 * as the heap, by which a mark is given, goes with it: claiming many costs bytes that count. */
static int64_t overhead_bytes(int64_t heap, int64_t allocation_count)
{
    int64_t most = OVERHEAD_TO_HEAP * heap;
    return ALLOCATION_OVERHEAD_BYTES * possible(allocation_count, most / ALLOCATION_OVERHEAD_BYTES);
}

/* What a process of these claims may grow by: its heap with the allocator's overhead, stack, static
 * data, the regions that it shares with us, and what libc keeps. */
static int64_t explained_bytes(const struct range *range, const struct control *claims,
                               const struct input *input, const struct build *build)
{
    int64_t heap = possible_heap(range, claims);
    return heap + heap / 8 + overhead_bytes(heap, claims->allocation_count) +
           possible(claims->stack_bytes, STACK_BYTES_MAX) + build->static_bytes +
           (int64_t)input->bytes + (int64_t)input->answer_bound + RESIDENT_SLACK_BYTES;
}

/* Calls on one size and judges. Returns 0, or -1: a fault. `run->failure` tells. */
static int measure_one(const struct range *range, struct series *series, int size_index,
                       const struct call_limits *limits, struct count_run *run, struct error *err)
{
    const struct input *input;
    if (yardstick_sized(range->yardstick, range->family, size_index, &input, err) != 0)
        return -1;
    if (series_call(series, input, 0, limits, &run->failure) != CALL_ANSWERED)
        return 0;
    return attempt_judge(range->yardstick, input, &series->session, &run->failure, err);
}

/* Calls on the largest size, and reads from outside how much the process grew. Memory that was not
 * asked for through malloc would show here. */
static int measure_hidden(const struct range *range, const struct build *build,
                          struct series *series, int size_index, struct count_run *run,
                          struct error *err)
{
    const struct box *box = &series->session.box;
    const struct input *input;
    int64_t before = box_reset_peak(box) == 0 ? box_peak_resident_bytes(box) : -1;
    if (measure_one(range, series, size_index, &native_limits, run, err) != 0 ||
        yardstick_sized(range->yardstick, range->family, size_index, &input, err) != 0)
        return -1;
    int64_t after = series->end == CALL_ANSWERED ? box_peak_resident_bytes(box) : -1;
    int64_t growth = before >= 0 && after >= 0 ? after - before : 0;
    if (growth > explained_bytes(range, &series->session.claims, input, build))
        run->hidden_bytes = growth - possible_heap(range, &series->session.claims);
    return 0;
}

static void read_memory(const struct range *range, const struct series *series, struct cost *cost)
{
    const struct control *claims = &series->session.claims;
    cost->heap_peak_bytes = possible_heap(range, claims);
    cost->allocation_count = possible(claims->allocation_count, INT64_MAX);
    cost->stack_bytes = possible(claims->stack_bytes, STACK_BYTES_MAX);
}

/* What the process does around the call is the runner's own, about as much as around the
 * reference's. More than that is the submission's too, whatever way it found to work there; and so
 * is all of it when callgrind lost sight of the call, or knows its function by another name. */
static void charge(const struct cost *reference, const struct callgrind_dump *dump,
                   struct cost *cost)
{
    int64_t called = dump->called.instructions;
    cost->beside_instructions = dump->counts.instructions - called;
    bool is_alone = called > 0 &&
                    (!reference->counted || cost->beside_instructions <=
                                                2 * reference->beside_instructions + BESIDE_SLACK);
    cost->counts = is_alone ? dump->called : dump->counts;
    cost->counted = true;
}

static int take_dump(const struct range *range, struct series *series, const char *trigger,
                     struct callgrind_dump *dump, struct error *err)
{
    const struct exercise *exercise = range->yardstick->exercise;
    const char *functions[EXERCISE_FUNCTIONS + 1] = {NULL};
    for (int i = 0; i < exercise->function_count; i++)
        functions[i] = exercise->functions[i];
    return dumps_take(&series->dumps, trigger, SERIES_CALLER, functions, dump, err);
}

static int read_counts(const struct range *range, struct series *series, int size_index,
                       struct cost *cost, struct error *err)
{
    struct callgrind_dump dump;
    if (take_dump(range, series, SERIES_DUMPED_CALL, &dump, err) != 0)
        return -1;
    charge(&range->yardstick->costs[range->family][size_index], &dump, cost);
    return 0;
}

/* The dump at the end of the program has the number that follows: so all before were callgrind's.
 * There is none of a program that did not end through valgrind, with its own exit code. */
static int check_end(const struct range *range, struct series *series,
                     const struct box_outcome *outcome, struct error *err)
{
    struct callgrind_dump dump;
    if (outcome->end != BOX_ENDED_EXIT || outcome->exit_code != 0)
        return error_set(err, "the program did not end when it was told to");
    return take_dump(range, series, SERIES_DUMPED_END, &dump, err);
}

/* A submission in valgrind's process can write where valgrind writes. What is not exactly what
 * callgrind would have written may be its doing as well as ours, and gives no mark either way.
 * Where callgrind could not read the program at all, it is this machine's: a fault, -1. */
static int blame_dump(const struct series *series, const struct error *why, struct attempt *failure,
                      struct error *err)
{
    if (series_check_way(series, err) != 0)
        return -1;
    attempt_say(failure, VERDICT_FLAGGED, &no_counts,
                "The work counts look tampered with (%.200s): a person must look at it.",
                "Las cuentas del trabajo parecen manipuladas (%.200s): debe mirarlo una persona.",
                why->text);
    return 0;
}

static bool is_hopeless(const struct cost *costs, const struct cost *reference, int i, int first)
{
    if (!reference || !costs[i].counted || i < first + SIZES_BEFORE_HOPELESS - 1)
        return false;
    double ratio = (double)callgrind_cost(&costs[i].counts) /
                   (double)(callgrind_cost(&reference[i].counts) + 1);
    double rise =
        (double)costs[i].counts.instructions / (double)(costs[i - 1].counts.instructions + 1);
    return ratio > HOPELESS_RATIO && rise > HOPELESS_RISE;
}

/* The common course of both measurements. */
static int measure(const struct range *range, const struct build *build, enum series_tool tool,
                   const struct cost *reference, struct cost *costs, struct count_run *run,
                   struct error *err)
{
    struct series series = series_none();
    const struct call_limits *limits = tool == SERIES_PLAIN ? &native_limits : &counted_limits;
    memset(run, 0, sizeof *run);
    run->failure.verdict = VERDICT_PASSED;
    int result = start(range, build, tool, &series, err);
    for (int i = range->first; i <= range->last && result == 0 && !run->hopeless; i++) {
        result = tool == SERIES_PLAIN && i == range->last
                     ? measure_hidden(range, build, &series, i, run, err)
                     : measure_one(range, &series, i, limits, run, err);
        if (result != 0 || series.end != CALL_ANSWERED || run->failure.verdict != VERDICT_PASSED)
            break;
        struct error unread = {""};
        if (tool == SERIES_PLAIN)
            read_memory(range, &series, &costs[i]);
        else if (read_counts(range, &series, i, &costs[i], &unread) != 0)
            result = blame_dump(&series, &unread, &run->failure, err);
        if (unread.text[0])
            break;
        run->done++;
        run->hopeless = is_hopeless(costs, reference, i, range->first);
    }
    bool counted = tool == SERIES_CALLGRIND && series.started && series.end == CALL_ANSWERED &&
                   run->failure.verdict == VERDICT_PASSED;
    struct error unproven = {""};
    if (series.started && series_end(&series, &run->failure, err) != 0)
        result = -1;
    else if (result == 0 && counted &&
             check_end(range, &series, &run->failure.outcome, &unproven) != 0)
        result = blame_dump(&series, &unproven, &run->failure, err);
    series_release(&series);
    return result;
}

int count_memory(struct yardstick *yardstick, const struct build *build, int family, int first,
                 int last, struct cost *costs, struct count_run *run, struct error *err)
{
    struct range range = {yardstick, family, first, last};
    return measure(&range, build, SERIES_PLAIN, NULL, costs, run, err);
}

int count_work(struct yardstick *yardstick, const struct build *build, int family, int first,
               int last, const struct cost *reference, struct cost *costs, struct count_run *run,
               struct error *err)
{
    struct range range = {yardstick, family, first, last};
    return measure(&range, build, SERIES_CALLGRIND, reference, costs, run, err);
}
