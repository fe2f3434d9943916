/* A program that lets itself be measured; see worker.h. */
#include "bench/measure/worker.h"

#include "bench/measure/allocation_counts.h"
#include "bench/measure/clock.h"

#include <dlfcn.h>
#include <limits.h>
#include <malloc.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <valgrind/callgrind.h>

enum { LINE_CAPACITY = 256, CALLS_MAX = 20000 };
static const int64_t SAMPLE_NS = 300000, LONG_NS = 30000000;
static const size_t HUGE_PAGE = 2 << 20;

/* ---- memory ---- */

/* Fresh zero pages at `start` (NULL: anywhere): huge ones, or none of them huge. */
static void *map_pages(void *start, size_t bytes, bool huge)
{
    void *memory = mmap(start, bytes, PROT_READ | PROT_WRITE,
                        MAP_PRIVATE | MAP_ANONYMOUS | (start ? MAP_FIXED : 0), -1, 0);
    if (memory == MAP_FAILED)
        return NULL;
    madvise(memory, bytes, huge ? MADV_HUGEPAGE : MADV_NOHUGEPAGE); /* only a wish */
    return memory;
}

void *worker_memory_take(struct worker_memory *memory, size_t bytes, struct error *err)
{
    size_t whole = (bytes / HUGE_PAGE + 1) * HUGE_PAGE;
    void *start = memory->piece_count < WORKER_PIECES_MAX ? map_pages(NULL, whole, true) : NULL;
    if (!start) {
        error_set(err, "out of memory: %zu bytes for output and scratch", bytes);
        return NULL;
    }
    memory->pieces[memory->piece_count].start = start;
    memory->pieces[memory->piece_count++].bytes = whole;
    return start;
}

void worker_memory_release(struct worker_memory *memory)
{
    for (int i = 0; i < memory->piece_count; i++)
        munmap(memory->pieces[i].start, memory->pieces[i].bytes);
    *memory = (struct worker_memory){.piece_count = 0};
}

static int renew(struct worker_memory *memory, bool cold, struct error *err)
{
    for (int i = 0; memory && i < memory->piece_count; i++)
        if (!map_pages(memory->pieces[i].start, memory->pieces[i].bytes, !cold))
            return error_set(err, "out of memory: fresh pages");
    if (memory)
        memory->is_cold = cold;
    if (cold)
        malloc_trim(0);
    return 0;
}

void worker_keep_memory(void)
{
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, INT_MAX);
}

/* ---- samples ---- */

struct service {
    const struct worker_subject *subject;
    FILE *out;
    int *calls; /* of a warm sample, by operation; 0: not yet known */
};

static int64_t now_ns(const struct worker_subject *subject)
{
    return subject->thread_count > 1 ? clock_wall_ns() : clock_thread_cpu_ns();
}

/* Time of `calls` calls, each reset afterwards; -1 after an error. */
static int64_t time_calls(const struct worker_subject *subject,
                          const struct worker_operation *operation, int calls, struct error *err)
{
    int64_t elapsed_ns = 0, start = now_ns(subject);
    for (int i = 0; i < calls; i++) {
        if (operation->run(operation->context, err) != 0)
            return -1;
        if (operation->reset) {
            elapsed_ns += now_ns(subject) - start;
            operation->reset(operation->context);
            start = now_ns(subject);
        }
    }
    return operation->reset ? elapsed_ns : now_ns(subject) - start;
}

/* Makes memory warm and finds out how many calls fill a sample. */
static int warm_up(struct service *service, int index, struct error *err)
{
    const struct worker_subject *subject = service->subject;
    const struct worker_operation *operation = &subject->operations[index];
    bool was_cold = subject->memory && subject->memory->is_cold;
    if (was_cold && renew(subject->memory, false, err) != 0)
        return -1;
    if (service->calls[index] && !was_cold)
        return 0;
    int64_t once_ns = time_calls(subject, operation, 1, err);
    if (once_ns >= 0 && once_ns < LONG_NS && !service->calls[index])
        once_ns = time_calls(subject, operation, 1, err); /* now on touched memory */
    if (once_ns < 0)
        return -1;
    if (!service->calls[index]) {
        int64_t calls = SAMPLE_NS / (once_ns + 1) + 1;
        service->calls[index] = (int)(calls < CALLS_MAX ? calls : CALLS_MAX);
    }
    return 0;
}

static int take_sample(struct service *service, int index, bool cold, struct error *err)
{
    const struct worker_subject *subject = service->subject;
    if ((cold ? renew(subject->memory, true, err) : warm_up(service, index, err)) != 0)
        return -1;
    int calls = cold ? 1 : service->calls[index];
    double before = clock_core_speed(CORE_SPEED_ROUNDS);
    int64_t elapsed_ns = time_calls(subject, &subject->operations[index], calls, err);
    double after = clock_core_speed(CORE_SPEED_ROUNDS);
    if (elapsed_ns < 0)
        return -1;
    fprintf(service->out, "sample %.4f %d %.4f %.4f\n", (double)elapsed_ns / calls, calls, before,
            after);
    return 0;
}

static int tell_answer(struct service *service, int index, struct error *err)
{
    const struct worker_subject *subject = service->subject;
    const struct worker_operation *operation = &subject->operations[index];
    struct worker_answer found = {.hash = 0};
    if (subject->memory && subject->memory->is_cold && renew(subject->memory, false, err) != 0)
        return -1;
    if (operation->run(operation->context, err) != 0)
        return -1;
    int result = operation->answer ? operation->answer(operation->context, &found, err) : 0;
    if (operation->reset)
        operation->reset(operation->context);
    if (result == 0)
        fprintf(service->out, "answer %016llx %.17g %.17g %.17g%s\n",
                (unsigned long long)found.hash, found.value, found.scale, found.tolerance,
                found.facts);
    return result;
}

static int count_call(struct service *service, int index, struct error *err)
{
    const struct worker_subject *subject = service->subject;
    const struct worker_operation *operation = &subject->operations[index];
    struct allocation_counts *counts = dlsym(RTLD_DEFAULT, ALLOCATION_COUNTS_SYMBOL);
    if (time_calls(subject, operation, 1, err) < 0) /* warm */
        return -1;
    struct allocation_counts before = counts ? *counts : (struct allocation_counts){0};
    if (counts)
        counts->peak_bytes = counts->live_bytes;
    CALLGRIND_TOGGLE_COLLECT;
    int result = operation->run(operation->context, err);
    CALLGRIND_TOGGLE_COLLECT;
    struct allocation_counts now = counts ? *counts : before;
    CALLGRIND_DUMP_STATS_AT(operation->name);
    if (operation->reset)
        operation->reset(operation->context);
    if (result != 0)
        return -1;
    if (!counts)
        fprintf(service->out, "counted -1 -1 -1 -1\n");
    else
        fprintf(service->out, "counted %lld %lld %lld %lld\n",
                (long long)(now.allocations - before.allocations),
                (long long)(now.allocated_bytes - before.allocated_bytes),
                (long long)(now.peak_bytes - before.live_bytes),
                (long long)(now.live_bytes - before.live_bytes));
    return 0;
}

void worker_fact(struct worker_answer *answer, const char *name, double number)
{
    size_t used = strlen(answer->facts);
    snprintf(answer->facts + used, sizeof answer->facts - used, " %s=%.10g", name, number);
}

/* ---- talk ---- */

static int obey(struct service *service, const char *verb, const char *name, struct error *err)
{
    int index = 0;
    while (index < service->subject->operation_count &&
           strcmp(service->subject->operations[index].name, name) != 0)
        index++;
    if (index == service->subject->operation_count)
        return error_set(err, "there is no operation \"%s\"", name);
    if (strcmp(verb, "warm") == 0)
        return take_sample(service, index, false, err);
    if (strcmp(verb, "cold") == 0)
        return take_sample(service, index, true, err);
    if (strcmp(verb, "answer") == 0)
        return tell_answer(service, index, err);
    if (strcmp(verb, "count") == 0)
        return count_call(service, index, err);
    return error_set(err, "do what? \"%s\"", verb);
}

int worker_serve(const struct worker_subject *subject, FILE *in, FILE *out, struct error *err)
{
    char line[LINE_CAPACITY], verb[16], name[64];
    struct service service = {.subject = subject, .out = out};
    service.calls = calloc((size_t)subject->operation_count + 1, sizeof *service.calls);
    if (!service.calls)
        return error_set(err, "out of memory");
    fputs("ready", out);
    for (int i = 0; i < subject->operation_count; i++)
        fprintf(out, " %s", subject->operations[i].name);
    fputc('\n', out);
    fflush(out);
    while (fgets(line, sizeof line, in)) {
        struct error trouble = {""};
        if (sscanf(line, "%15s %63s", verb, name) != 2) {
            free(service.calls);
            return error_set(err, "worker: not understood: %.100s", line);
        }
        if (obey(&service, verb, name, &trouble) != 0)
            fprintf(out, "error %s\n", trouble.text);
        fflush(out);
    }
    free(service.calls);
    return 0;
}

void worker_refuse(FILE *out, const char *why)
{
    fprintf(out, "refused %s\n", why);
    fflush(out);
}
