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
    SIZES_BEFORE_LEAP = 4,
    BESIDE_SLACK = 200000,          /* instructions */
    HOPELESS_RATIO = 50,            /* cost over the reference's ... */
    ALLOCATION_OVERHEAD_BYTES = 64, /* of a block, at most */
    OVERHEAD_TO_HEAP = 8,           /* blocks of 8 bytes on average, at the least */
    STACK_BYTES_MAX = 16 << 20,
    RESIDENT_SLACK_BYTES = 1 << 20
};
static const double HOPELESS_RISE = 2.83; /* ... while a doubling costs more than n^1.5 would */
static const double LEAP_RISE = 2.5;      /* sorting has 2.2; more may be n^2, dear at a large n */

static const struct call_limits native_limits = {10000000000LL, 2000000000LL};
static const struct call_limits counted_limits = {120000000000LL, 10000000000LL};

bool count_available(struct phrase *why_not)
{
    static const struct phrase absent = {"valgrind is not installed (apt-get install valgrind)",
                                         "valgrind no está instalado (apt-get install valgrind)"};
    bool found = access("/usr/bin/valgrind", X_OK) == 0;
    *why_not = found ? (struct phrase){NULL, NULL} : absent;
    return found;
}

/* What is being measured, and of whom. */
struct measuring {
    struct series series;
    struct inputs *inputs;
    const struct build *build;
    const struct count_plan *plan;
    struct cost *const *costs;
    struct count_run *run;
    enum series_tool tool;
    uint32_t family_pages; /* of the input region, for each family */
};

static int start(struct measuring *m, struct error *err)
{
    const struct count_plan *sizes = m->plan;
    struct series_plan plan = {.inputs = m->inputs,
                               .build = m->build,
                               .tool = m->tool,
                               .mode = m->tool == SERIES_PLAIN ? MODE_STACK : MODE_PLAIN,
                               .cpu = -1};
    for (int family = sizes->first_family; family <= sizes->last_family; family++)
        for (int i = sizes->first; i <= sizes->last; i++) {
            const struct input *input;
            if (inputs_sized(m->inputs, family, i, &input, err) != 0)
                return -1;
            if (input->bytes > plan.input_bytes)
                plan.input_bytes = input->bytes;
            if (input->answer_bound > plan.answer_bytes)
                plan.answer_bytes = input->answer_bound;
            plan.call_count++;
        }
    m->family_pages = (uint32_t)((plan.input_bytes + INPUT_PAGE_BYTES - 1) / INPUT_PAGE_BYTES);
    int families = sizes->last_family - sizes->first_family + 1;
    plan.input_bytes = (size_t)families * m->family_pages * INPUT_PAGE_BYTES;
    return series_start(&m->series, &plan, err);
}

/* A claim of memory, as far as it can be true. */
static int64_t possible(int64_t claimed, int64_t most)
{
    return claimed < 0 ? 0 : claimed < most ? claimed : most;
}

static int64_t possible_heap(const struct measuring *m, const struct control *claims)
{
    return possible(claims->heap_peak_bytes, m->inputs->exercise->memory_limit_bytes);
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
static int64_t explained_bytes(const struct measuring *m, const struct control *claims,
                               const struct input *input)
{
    int64_t heap = possible_heap(m, claims);
    int64_t prepared = possible(claims->prepared_bytes, m->inputs->exercise->memory_limit_bytes);
    return heap + heap / 8 + overhead_bytes(heap, claims->allocation_count) + prepared +
           prepared / 8 + overhead_bytes(prepared, claims->prepared_count) +
           possible(claims->stack_bytes, STACK_BYTES_MAX) + m->build->static_bytes +
           (int64_t)input->bytes + (int64_t)input->answer_bound + RESIDENT_SLACK_BYTES;
}

/* Calls on one size and judges. Returns 0, or -1: a fault. `run->failure` tells. */
static int measure_one(struct measuring *m, int family, int size_index, struct error *err)
{
    const struct call_limits *limits = m->tool == SERIES_PLAIN ? &native_limits : &counted_limits;
    const struct input *input;
    m->run->family = family;
    m->run->size_index = size_index;
    if (inputs_sized(m->inputs, family, size_index, &input, err) != 0)
        return -1;
    if (series_call(&m->series, input, 0, limits, &m->run->failure) != CALL_ANSWERED)
        return 0;
    return attempt_judge(m->inputs, input, &m->series.session, &m->run->failure, err);
}

/* The same, and reads from outside how much the process grew. Memory that was not asked for through
 * malloc shows here, in the call that first uses it, whichever that is. */
static int measure_hidden(struct measuring *m, int family, int size_index, struct error *err)
{
    const struct box *box = &m->series.session.box;
    const struct input *input;
    (void)session_await_ready(&m->series.session); /* when it fails, the call tells */
    int64_t before = box_reset_peak(box) == 0 ? box_peak_resident_bytes(box) : -1;
    if (measure_one(m, family, size_index, err) != 0 ||
        inputs_sized(m->inputs, family, size_index, &input, err) != 0)
        return -1;
    int64_t after = m->series.end == CALL_ANSWERED ? box_peak_resident_bytes(box) : -1;
    int64_t growth = before >= 0 && after >= 0 ? after - before : 0;
    int64_t hidden = growth - possible_heap(m, &m->series.session.claims);
    if (growth > explained_bytes(m, &m->series.session.claims, input) &&
        hidden > m->run->hidden_bytes)
        m->run->hidden_bytes = hidden;
    return 0;
}

static void read_memory(const struct measuring *m, int size_index, struct cost *cost)
{
    const struct control *claims = &m->series.session.claims;
    struct count_run *run = m->run;
    if (claims->leaked_blocks > 0 && run->leaked_blocks == 0) {
        run->leaked_blocks = claims->leaked_blocks;
        run->leaked_bytes = possible(claims->heap_left_bytes, INT64_MAX);
        run->leaking_size = size_index;
    }
    cost->heap_peak_bytes = possible_heap(m, claims);
    cost->allocation_count = possible(claims->allocation_count, INT64_MAX);
    cost->stack_bytes = possible(claims->stack_bytes, STACK_BYTES_MAX);
}

/* What the process does around the call is the runner's own, about as much as around the
 * reference's. More than that is the submission's too, whatever way it found to work there; and so
 * is all of it when callgrind lost sight of the call, or knows its function by another name. What is
 * built before queries, or asked after building, is counted by itself on other inputs; the witness
 * of time sees it here too. */
static void charge(const struct cost *reference, const struct callgrind_dump *dump,
                   struct cost *cost)
{
    int64_t called = dump->called.instructions;
    cost->beside_instructions = dump->counts.instructions - called - dump->prepared.instructions;
    bool is_alone = called > 0 && (!reference || !reference->counted ||
                                   cost->beside_instructions <=
                                       2 * reference->beside_instructions + BESIDE_SLACK);
    cost->counts = is_alone ? dump->called : dump->counts;
    cost->access_count = dump->access_count;
    cost->counted = true;
}

static int take_dump(struct measuring *m, const char *trigger, struct callgrind_dump *dump,
                     struct error *err)
{
    const struct exercise *exercise = m->inputs->exercise;
    const char *functions[EXERCISE_FUNCTIONS + 1] = {NULL}, *given[EXERCISE_GIVEN + 1] = {NULL};
    const struct callgrind_calls calls = {SERIES_CALLER, functions, SERIES_PREPARER, given};
    for (int i = 0; i < exercise->function_count; i++)
        functions[i] = exercise->functions[i];
    for (int i = 0; i < exercise->given_count; i++)
        given[i] = exercise->given[i];
    return dumps_take(&m->series.dumps, trigger, &calls, dump, err);
}

/* The runner counts accesses in the process of the submission, which can write there what it likes.
 * callgrind saw each of these calls as well: so the claim must be true, and where nothing counts
 * beside, a submission would have to know when it may lie. */
static int compare_accesses(const struct measuring *m, const struct callgrind_dump *dump,
                            struct error *err)
{
    int64_t claimed = m->series.session.claims.access_count;
    if (claimed == dump->access_count)
        return 0;
    return error_set(err, "%lld accesses were reported, and callgrind saw %lld", (long long)claimed,
                     (long long)dump->access_count);
}

/* What the reference's call on the same input cost; NULL: it is not known. */
static const struct cost *reference_cost(const struct measuring *m, int family, int size_index)
{
    const struct cost *of_family = m->plan->reference[family];
    return of_family ? &of_family[size_index] : NULL;
}

static int read_counts(struct measuring *m, int family, int size_index, struct error *err)
{
    struct callgrind_dump dump;
    if (take_dump(m, SERIES_DUMPED_CALL, &dump, err) != 0 || compare_accesses(m, &dump, err) != 0)
        return -1;
    charge(reference_cost(m, family, size_index), &dump, &m->costs[family][size_index]);
    return 0;
}

/* The dump at the end of the program has the number that follows: so all before were callgrind's.
 * There is none of a program that did not end through valgrind, with its own exit code. */
static int check_end(struct measuring *m, const struct box_outcome *outcome, struct error *err)
{
    struct callgrind_dump dump;
    if (outcome->end != BOX_ENDED_EXIT || outcome->exit_code != 0)
        return error_set(err, "the program did not end when it was told to");
    return take_dump(m, SERIES_DUMPED_END, &dump, err);
}

/* A submission in valgrind's process can write where valgrind writes. What is not exactly what
 * callgrind would have written may be its doing as well as ours, and gives no mark either way.
 * Where callgrind could not read the program at all, it is this machine's: a fault, -1. */
static int blame_dump(const struct series *series, const struct error *why, struct attempt *failure,
                      struct error *err)
{
    if (series_check_way(series, err) != 0)
        return -1;
    attempt_say(failure, VERDICT_FLAGGED, &no_counts, "The work counts look tampered with",
                "Las cuentas del trabajo parecen manipuladas");
    message_en(&failure->message, " (%.200s)", why->text); /* an error has no Spanish */
    message_add(&failure->message, ": a person must look at it.", ": debe mirarlo una persona.");
    return 0;
}

/* What the last doubling made of the work. */
static double rise_of(const struct cost *costs, int i)
{
    return (double)costs[i].counts.instructions / (double)(costs[i - 1].counts.instructions + 1);
}

static bool is_hopeless(const struct cost *costs, const struct cost *reference, int i)
{
    if (!reference || i < SIZES_BEFORE_HOPELESS - 1 || !costs[i - 1].counted)
        return false;
    double ratio =
        (double)costs[i].counts.instructions / (double)(reference->counts.instructions + 1);
    return ratio > HOPELESS_RATIO && rise_of(costs, i) > HOPELESS_RISE;
}

static int next_size(const struct measuring *m, const struct cost *costs, int i)
{
    bool leaps = m->plan->leaps && i == SIZES_BEFORE_LEAP - 1 && i < m->plan->last &&
                 rise_of(costs, i) < LEAP_RISE;
    return leaps ? m->plan->last : i + 1;
}

/* Whether everything has been well so far, so that the next call makes sense. */
static bool goes_well(const struct measuring *m)
{
    return m->series.end == CALL_ANSWERED && m->run->failure.verdict == VERDICT_PASSED;
}

/* The sizes of one family, in the process that runs. Its inputs have a place of their own: where
 * those of the family before stood, the simulated caches would hold them already, and whoever reads
 * little but the input seem cheap. Returns 0, or -1: a fault. */
static int measure_family(struct measuring *m, int family, struct error *err)
{
    struct cost *costs = m->costs[family];
    m->series.session.input_page = (uint32_t)(family - m->plan->first_family) * m->family_pages;
    for (int i = m->plan->first; i <= m->plan->last && !m->run->hopeless[family];
         i = next_size(m, costs, i)) {
        int result = m->tool == SERIES_PLAIN ? measure_hidden(m, family, i, err)
                                             : measure_one(m, family, i, err);
        if (result != 0 || !goes_well(m))
            return result;
        struct error unread = {""};
        if (m->tool == SERIES_PLAIN)
            read_memory(m, i, &costs[i]);
        else if (read_counts(m, family, i, &unread) != 0)
            return blame_dump(&m->series, &unread, &m->run->failure, err);
        m->run->end[family] = i + 1;
        m->run->hopeless[family] =
            m->plan->stops_early && is_hopeless(costs, reference_cost(m, family, i), i);
    }
    return 0;
}

/* The common course of both measurements. */
static int measure(struct measuring *m, struct error *err)
{
    struct count_run *run = m->run;
    memset(run, 0, sizeof *run);
    run->failure.verdict = VERDICT_PASSED;
    m->series = series_none();
    int result = start(m, err);
    for (int f = m->plan->first_family; f <= m->plan->last_family && result == 0 && goes_well(m);
         f++)
        result = measure_family(m, f, err);
    bool counted = m->tool != SERIES_PLAIN && m->series.started && goes_well(m);
    struct error unproven = {""};
    if (m->series.started && series_end(&m->series, &run->failure, err) != 0)
        result = -1;
    else if (result == 0 && counted && check_end(m, &run->failure.outcome, &unproven) != 0)
        result = blame_dump(&m->series, &unproven, &run->failure, err);
    series_release(&m->series);
    return result;
}

int count_memory(struct inputs *inputs, const struct build *build, const struct count_plan *plan,
                 struct cost *const costs[FAMILIES_MAX], struct count_run *run, struct error *err)
{
    struct measuring measuring = {.inputs = inputs,
                                  .build = build,
                                  .plan = plan,
                                  .tool = SERIES_PLAIN,
                                  .costs = costs,
                                  .run = run};
    return measure(&measuring, err);
}

int count_work(struct inputs *inputs, const struct build *build, const struct count_plan *plan,
               struct cost *const costs[FAMILIES_MAX], struct count_run *run, struct error *err)
{
    struct measuring measuring = {.inputs = inputs,
                                  .build = build,
                                  .plan = plan,
                                  .tool =
                                      plan->without_misses ? SERIES_INSTRUCTIONS : SERIES_CALLGRIND,
                                  .costs = costs,
                                  .run = run};
    return measure(&measuring, err);
}
