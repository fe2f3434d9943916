/* One block of a comparison; see block.h. */
#include "bench/measure/block.h"

#include "bench/measure/clock.h"
#include "bench/measure/process.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RETRIES = 3 };
static const double SLOWED = 0.90;
static const double ENOUGH_NS = 1.5e8; /* after so much measured time nothing is tried again */

static int by_speed(const void *left, const void *right)
{
    double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

static void note_speed(struct core_watch *watch, double speed)
{
    watch->recent[watch->next] = speed;
    watch->next = (watch->next + 1) % CORE_WATCH_RECENT;
    if (watch->recent_count < CORE_WATCH_RECENT)
        watch->recent_count++;
    if (watch->next % 16 == 0 || watch->recent_count < 16) {
        double sorted[CORE_WATCH_RECENT];
        memcpy(sorted, watch->recent, (size_t)watch->recent_count * sizeof *sorted);
        qsort(sorted, (size_t)watch->recent_count, sizeof *sorted, by_speed);
        watch->full_speed = sorted[3 * (watch->recent_count - 1) / 4];
    }
}

void core_watch_begin(struct core_watch *watch)
{
    for (int i = 0; i < CORE_WATCH_RECENT; i++)
        note_speed(watch, clock_core_speed(CORE_SPEED_ROUNDS));
}

bool core_watch_accepts(struct core_watch *watch, double before, double after)
{
    double slower = before < after ? before : after;
    note_speed(watch, before);
    note_speed(watch, after);
    watch->samples++;
    bool accepted = slower >= SLOWED * watch->full_speed;
    watch->dropped += !accepted;
    return accepted;
}

struct block {
    const struct block_plan *plan;
    struct core_watch *watch;
    struct process processes[BLOCK_PROGRAMS_MAX];
    struct block_result *results;
};

/* The i-th program to be started: rotated by the number of the block, every second time backwards.
 */
static int started_as(const struct block_plan *plan, int i)
{
    int count = plan->program_count, at = (i + plan->number / 2) % count;
    return plan->number % 2 ? count - 1 - at : at;
}

static bool is_wanted(const struct block_plan *plan, const char *operation)
{
    char wanted[64];
    snprintf(wanted, sizeof wanted, " %s ", operation);
    return !plan->only || strstr(plan->only, wanted);
}

/* Reads "ready OPERATION..." or "refused WHY". */
static void read_greeting(struct block *block, int program)
{
    struct block_result *result = &block->results[program];
    struct process *process = &block->processes[program];
    struct error err = {""};
    char *rest = NULL;
    if (process_read(process, block->plan->seconds, &err) != 0) {
        snprintf(result->refused, sizeof result->refused, "%.*s", BLOCK_TEXT - 1, err.text);
    } else if (strncmp(process->line, "ready", 5) != 0) {
        const char *why =
            strncmp(process->line, "refused ", 8) == 0 ? process->line + 8 : "no greeting";
        snprintf(result->refused, sizeof result->refused, "%s", why);
    }
    if (result->refused[0])
        return;
    for (char *word = strtok_r(process->line + 5, " ", &rest); word;
         word = strtok_r(NULL, " ", &rest)) {
        if (!is_wanted(block->plan, word) || result->measure_count == BLOCK_OPERATIONS_MAX)
            continue;
        struct block_measure *measure = &result->measures[result->measure_count++];
        snprintf(measure->operation, sizeof measure->operation, "%s", word);
    }
}

static int start_all(struct block *block, struct error *err)
{
    for (int i = 0; i < block->plan->program_count; i++) {
        int program = started_as(block->plan, i);
        if (process_start(&block->processes[program], block->plan->programs[program], NULL, err) !=
            0)
            return -1;
        read_greeting(block, program);
    }
    return 0;
}

static struct block_measure *measure_of(struct block_result *result, const char *operation)
{
    for (int i = 0; i < result->measure_count; i++)
        if (strcmp(result->measures[i].operation, operation) == 0)
            return &result->measures[i];
    return NULL;
}

static void ask(struct block *block, int program, struct block_measure *measure, const char *verb,
                char *error)
{
    struct process *process = &block->processes[program];
    struct error err = {""};
    if (process_ask(process, verb, measure->operation, block->plan->seconds, &err) != 0) {
        snprintf(error, BLOCK_TEXT, "%.*s", BLOCK_TEXT - 1, err.text);
        process_stop(process, 0);
    } else if (strncmp(process->line, "error ", 6) == 0) {
        snprintf(error, BLOCK_TEXT, "%.*s", BLOCK_TEXT - 1, process->line + 6);
    }
}

/* One sample, tried again while a neighbour slows the core, and while that is cheap: what matters
 * is to have many blocks, not many samples in each. */
static void take_sample(struct block *block, int program, struct block_measure *measure, bool cold)
{
    struct block_time *least = cold ? &measure->cold : &measure->warm;
    double slow_least = 0;
    double *spent_ns = cold ? &measure->cold_spent_ns : &measure->warm_spent_ns;
    for (int i = 0; i <= RETRIES && (i == 0 || *spent_ns < ENOUGH_NS); i++) {
        double ns, before, after;
        int calls;
        ask(block, program, measure, cold ? "cold" : "warm", measure->error);
        if (measure->error[0])
            return;
        if (sscanf(block->processes[program].line, "sample %lf %d %lf %lf", &ns, &calls, &before,
                   &after) != 4) {
            snprintf(measure->error, sizeof measure->error, "not a sample");
            return;
        }
        measure->samples++;
        *spent_ns += ns * calls;
        if (ns <= 0)
            ns = 0.01; /* below the clock's resolution */
        if (core_watch_accepts(block->watch, before, after)) {
            if (least->ns == 0 || least->noisy || ns < least->ns)
                *least = (struct block_time){.ns = ns};
            return;
        }
        measure->dropped++;
        if (slow_least == 0 || ns < slow_least)
            slow_least = ns;
    }
    if (least->ns == 0 || (least->noisy && slow_least < least->ns))
        *least = (struct block_time){.ns = slow_least, .noisy = true};
}

static void measure_operation(struct block *block, const char *operation)
{
    const struct block_plan *plan = block->plan;
    for (int round = 0; round < plan->rounds + plan->cold_rounds; round++)
        for (int i = 0; i < plan->program_count; i++) {
            int program = (round + plan->number) % 2 ? plan->program_count - 1 - i : i;
            struct block_measure *measure = measure_of(&block->results[program], operation);
            bool cold = round >= plan->rounds;
            if (!measure || measure->error[0])
                continue;
            if ((cold ? measure->cold_spent_ns : measure->warm_spent_ns) < ENOUGH_NS)
                take_sample(block, program, measure, cold);
        }
}

/* Reads "answer HASH VALUE SCALE TOLERANCE[ NAME=NUMBER...]". */
static void read_answer(struct block *block, int program, struct block_measure *measure)
{
    unsigned long long hash;
    int at = 0;
    ask(block, program, measure, "answer", measure->error);
    if (measure->error[0])
        return;
    struct worker_answer *answer = &measure->answer;
    const char *line = block->processes[program].line;
    if (sscanf(line, "answer %llx %lf %lf %lf%n", &hash, &answer->value, &answer->scale,
               &answer->tolerance, &at) != 4) {
        snprintf(measure->error, sizeof measure->error, "not an answer");
        return;
    }
    answer->hash = hash;
    snprintf(answer->facts, sizeof answer->facts, "%s", line + at);
}

/* All operations that any program has, in the order of the first program that has them. */
static void measure_all(struct block *block)
{
    for (int program = 0; program < block->plan->program_count; program++)
        for (int i = 0; i < block->results[program].measure_count; i++) {
            struct block_measure *measure = &block->results[program].measures[i];
            bool is_done = measure->samples > 0 || measure->error[0];
            if (!is_done)
                measure_operation(block, measure->operation);
        }
    for (int program = 0; program < block->plan->program_count && block->plan->number == 0;
         program++)
        for (int i = 0; i < block->results[program].measure_count; i++) {
            struct block_measure *measure = &block->results[program].measures[i];
            if (!measure->error[0])
                read_answer(block, program, measure);
        }
}

int block_run(const struct block_plan *plan, struct core_watch *watch, struct block_result *results,
              struct error *err)
{
    struct block block = {.plan = plan, .watch = watch, .results = results};
    if (plan->program_count < 1 || plan->program_count > BLOCK_PROGRAMS_MAX)
        return error_set(err, "a block of %d programs", plan->program_count);
    memset(results, 0, (size_t)plan->program_count * sizeof *results);
    for (int i = 0; i < plan->program_count; i++)
        block.processes[i] = process_none();
    int result = start_all(&block, err);
    if (result == 0)
        measure_all(&block);
    for (int i = 0; i < plan->program_count; i++)
        process_stop(&block.processes[i], 10);
    return result;
}
