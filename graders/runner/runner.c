/* The program inside the box, beside the student's object.
 *
 * It maps the three regions that it was given (control page, input, answer), gives up what the
 * student's code must not have, says that it is ready, and then, for every call that the engine
 * asks for: hands the input to run_call, lets it call the student, and reports what was measured.
 * It shares a process with the student's code, so nothing that it says is believed; it holds no
 * expected answer, no seed, no name of a case.
 *
 * It waits and wakes by futex on the control page. The student's function runs on the ordinary
 * stack; faults are described by a handler on a stack of its own and then take their course. */
#include "graders/runner/call.h"
#include "graders/runner/seclude.h"
#include "graders/runner/shim.h"
#include "graders/runner/stack.h"
#include "graders/wire/control.h"

#include <errno.h>
#include <linux/futex.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>
#ifdef RUNNER_WITHOUT_SHIM
#include <valgrind/memcheck.h>
#endif

enum {
    EXIT_MEASURED_TWICE = 98,
    PAGE = 4096,
    STACK_MOST_BYTES = 15 << 20 /* of 16: above lie the arguments and the first frames */
};

static struct control *control;

/* What stays the same for the whole session, copied before any of the student's code has run: later
 * the page may hold anything. */
static struct {
    uint32_t mode;
    size_t input_capacity, answer_capacity;
    int64_t heap_limit_bytes;
} fixed;

static const unsigned char *input_region;
static unsigned char *answer_region;
static uintptr_t stack_top;
static bool said_out_of_memory;
static int64_t access_count;
static struct shim_counts prepared; /* what is live of it is not the call's */
static char output_buffer[1 << 16];
static unsigned char handler_stack[1 << 16];

/* ------------------------------------------------------------------ faults */

/* Whether the function at fault has its frame where the stack has no room, wherever in the frame it
 * wanted to write: a local array may be larger than all that lies below. */
static bool is_past_stack(const ucontext_t *context)
{
    uintptr_t frame = (uintptr_t)context->uc_mcontext.gregs[REG_RSP];
    return frame < stack_top && stack_top - frame > STACK_MOST_BYTES;
}

static void describe_fault(int signal_number, siginfo_t *info, void *context)
{
    uintptr_t at = (uintptr_t)info->si_addr;
    uintptr_t input = (uintptr_t)input_region;
    bool is_near = at < stack_top && stack_top - at < (uintptr_t)64 << 20;
    if (at < 65536)
        control->fault = FAULT_NULL;
    else if (is_near || is_past_stack(context))
        control->fault = FAULT_STACK;
    else if (at >= input - PAGE && at < input + fixed.input_capacity + PAGE)
        control->fault = FAULT_INPUT;
    else
        control->fault = FAULT_OTHER;
    control->refused_count = shim_counts.refused_count; /* a malloc that gave NULL may explain it */
    signal(signal_number, SIG_DFL); /* returning repeats the fault, which now ends the program */
}

static void watch_faults(void)
{
#ifndef RUNNER_WITHOUT_SHIM /* sanitizers and valgrind describe faults themselves */
    stack_t own = {.ss_sp = handler_stack, .ss_size = sizeof handler_stack};
    struct sigaction action = {.sa_sigaction = describe_fault, .sa_flags = SA_SIGINFO | SA_ONSTACK};
    sigaltstack(&own, NULL);
    sigaction(SIGSEGV, &action, NULL);
    sigaction(SIGBUS, &action, NULL);
#else
    (void)describe_fault;
    (void)handler_stack;
#endif
}

/* ----------------------------------------------------------------- measure */

/* A submission can find the calls around its own, and end the measurement early or begin it anew.
 * One pair a call, in this order, or the program ends here. */
static enum { NOT_MEASURED, MEASURING, MEASURED } measurement;

static void pass_measurement(int from, int to)
{
    if ((int)measurement != from)
        _exit(EXIT_MEASURED_TWICE);
    measurement = to;
}

static struct shim_counts of_call; /* while something is prepared or asked after the call */

void prepare_begin(void)
{
    control->phase = PHASE_CALL;
    of_call = shim_counts;
    shim_begin(fixed.heap_limit_bytes, 0);
}

void prepare_end(void)
{
    struct shim_counts now = shim_counts;
    shim_end();
    if (now.peak_bytes > control->prepared_bytes)
        control->prepared_bytes = now.peak_bytes;
    control->prepared_count += now.allocation_count;
    if (measurement == MEASURED) {
        shim_counts = of_call;
        shim_counts.live_bytes = now.live_bytes;
        shim_counts.own_bytes = now.own_bytes;
        shim_counts.own_blocks = now.own_blocks;
        shim_counts.bad_free_count += now.bad_free_count;
        control->phase = PHASE_ANSWER;
    } else {
        prepared = now;
    }
}

void measure_begin(void)
{
    pass_measurement(NOT_MEASURED, MEASURING);
    control->phase = PHASE_CALL;
    access_count = 0;
    shim_begin(fixed.heap_limit_bytes, control->failing_allocation);
    if (fixed.mode & MODE_STACK)
        stack_give_back();
}

void measure_end(void)
{
    pass_measurement(MEASURING, MEASURED);
    shim_end();
    if (fixed.mode & MODE_STACK)
        control->stack_bytes = stack_used_bytes();
    control->heap_held_bytes = shim_counts.own_bytes - prepared.own_bytes;
    control->access_count = access_count;
    control->phase = PHASE_ANSWER;
}

void count_access(void)
{
    access_count++;
}

/* callgrind dumps when this is entered, by its name (series.c). Not by a request: the code of one
 * could be jumped to, with another request, and so the program that is counted holds none. */
__attribute__((noipa)) static void counted_call_ends(void)
{
}

void call_out_of_memory(void)
{
    said_out_of_memory = true;
}

/* ------------------------------------------------------------------- fence */

#ifdef RUNNER_WITHOUT_SHIM
/* AddressSanitizer's, absent from the flavour for valgrind. */
void __asan_poison_memory_region(const volatile void *at, size_t bytes) __attribute__((weak));
void __asan_unpoison_memory_region(const volatile void *at, size_t bytes) __attribute__((weak));
#endif

/* Lets the tools see a read behind the end of the input: what lies between there and the guard page
 * is ours, but was never written, or holds a longer input of an earlier call. */
static void fence_input(size_t start, size_t input_bytes)
{
#ifdef RUNNER_WITHOUT_SHIM
    const unsigned char *begin = input_region + start, *end = begin + input_bytes;
    size_t rest = fixed.input_capacity - start - input_bytes;
    if (__asan_poison_memory_region) {
        __asan_unpoison_memory_region(begin, input_bytes);
        __asan_poison_memory_region(end, rest);
    }
    (void)VALGRIND_MAKE_MEM_DEFINED(begin, input_bytes);
    (void)VALGRIND_MAKE_MEM_NOACCESS(end, rest);
#else
    (void)start;
    (void)input_bytes;
#endif
}

/* ------------------------------------------------------------------- unset */

static uint32_t table_count; /* of the answer, as far as they were looked at */

/* The first of these bytes that was never written; `bytes` when all were, or cannot be read. */
static size_t first_unset(const unsigned char *at, size_t bytes)
{
#ifdef RUNNER_WITHOUT_SHIM
    enum { CHUNK = 4096, GIVES_BITS = 1 };
    static unsigned char unset[CHUNK]; /* a bit for each bit, 1: never written */
    for (size_t done = 0; done < bytes; done += CHUNK) {
        size_t count = bytes - done < CHUNK ? bytes - done : CHUNK;
        if (VALGRIND_GET_VBITS(at + done, unset, count) != GIVES_BITS)
            return bytes;
        for (size_t i = 0; i < count; i++)
            if (unset[i])
                return done + i;
    }
#else
    (void)at;
#endif
    return bytes;
}

/* memcheck ends the program at its first error, which a check makes. */
static void look_for_unset(uint32_t table, const unsigned char *at, size_t bytes)
{
    size_t place = fixed.mode & MODE_MEMCHECK ? first_unset(at, bytes) : bytes;
    if (place == bytes)
        return;
    control->unset_table = table;
    control->unset_place = (int64_t)place + 1;
#ifdef RUNNER_WITHOUT_SHIM
    (void)VALGRIND_CHECK_MEM_IS_DEFINED(at + place, 1);
#endif
}

void look_at_result(const void *result, size_t bytes)
{
    look_for_unset(0, result, bytes);
}

/* No answer is larger than the room for it. */
void look_at_table(const void *table, size_t bytes)
{
    table_count++;
    if (table && bytes <= fixed.answer_capacity)
        look_for_unset(table_count, table, bytes);
}

/* ------------------------------------------------------------------- calls */

static void forget_last_call(void)
{
    control->echo = 0;
    control->answer_bytes = 0;
    control->phase = PHASE_START;
    said_out_of_memory = false;
    control->out_of_memory = 0;
    control->stack_bytes = 0;
    control->access_count = 0;
    control->prepared_bytes = control->prepared_count = 0;
    prepared = (struct shim_counts){0};
    control->refused_count = 0;
    control->tool_errors = 0;
    control->fault = FAULT_NONE;
    control->unset_place = table_count = 0;
}

static void ask_memcheck(const struct writer *answer)
{
#ifdef RUNNER_WITHOUT_SHIM
    if (fixed.mode & MODE_MEMCHECK) {
        size_t written = answer->count < answer->capacity ? answer->count : answer->capacity;
        (void)VALGRIND_CHECK_MEM_IS_DEFINED(answer_region, written);
    }
    control->tool_errors = (int64_t)VALGRIND_COUNT_ERRORS; /* 0 without valgrind */
#else
    (void)answer;
#endif
}

/* From the same place in a page whatever the addresses are: how many pages of the stack a call needs
 * then repeats. */
__attribute__((noinline)) static void call_aligned(struct reader *input, struct writer *answer)
{
    volatile char *room = __builtin_alloca((uintptr_t)__builtin_frame_address(0) % PAGE + 16);
    room[0] = 0;
    run_call(input, answer);
}

static void do_call(void)
{
    uint64_t nonce = control->nonce;
    size_t start = (size_t)control->input_page * INPUT_PAGE_BYTES;
    if (start > fixed.input_capacity)
        start = fixed.input_capacity;
    size_t input_bytes = control->input_bytes;
    if (input_bytes > fixed.input_capacity - start)
        input_bytes = fixed.input_capacity - start;
    struct reader input = reader_of(input_region + start, input_bytes);
    struct writer answer = writer_into(answer_region, fixed.answer_capacity);
    forget_last_call();
    fence_input(start, input_bytes);
    call_aligned(&input, &answer);
    pass_measurement(MEASURED, NOT_MEASURED);
    fflush(stdout);
    if (fixed.mode & MODE_STACK)
        stack_give_back(); /* what the next call uses is then seen from outside as well */
    ask_memcheck(&answer);
    counted_call_ends();
    control->heap_peak_bytes = shim_counts.peak_bytes - prepared.live_bytes;
    control->heap_left_bytes = shim_counts.own_bytes;
    control->leaked_blocks = shim_counts.own_blocks;
    control->allocation_count = shim_counts.allocation_count;
    control->refused_count = shim_counts.refused_count;
    control->bad_free_count = shim_counts.bad_free_count;
    control->out_of_memory = said_out_of_memory;
    control->answer_bytes = answer.count;
    control->phase = PHASE_DONE;
    control->echo = nonce;
}

static void futex(_Atomic uint32_t *word, int operation, uint32_t value)
{
    syscall(SYS_futex, word, operation, value, NULL, NULL, 0);
}

static void finish_call(uint32_t index)
{
    atomic_store(&control->done_index, index);
    futex(&control->done_index, FUTEX_WAKE, 1);
}

/* A call index that is neither the last nor the next was not written by the engine: the student's
 * code overwrote the page. Ending here keeps what the engine reads of the last call as it is. */
static void serve_calls(void)
{
    for (uint32_t index = 1;; index++) {
        while (atomic_load(&control->call_index) == index - 1)
            futex(&control->call_index, FUTEX_WAIT, index - 1);
        if (atomic_load(&control->call_index) != index)
            return;
        do_call();
        finish_call(index);
    }
}

/* ----------------------------------------------------------------- regions */

/* Maps a region with an unreachable page on each side. */
static void *map_guarded(int descriptor, size_t bytes, int protection)
{
    size_t room = (bytes + PAGE - 1) / PAGE * PAGE;
    unsigned char *guards =
        mmap(NULL, room + 2 * PAGE, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (guards == MAP_FAILED)
        return NULL;
    if (room == 0)
        return guards + PAGE;
    void *mapped = mmap(guards + PAGE, room, protection, MAP_SHARED | MAP_FIXED, descriptor, 0);
    return mapped == MAP_FAILED ? NULL : mapped;
}

/* Sanitizers and memcheck leave the shim out, callgrind counts. */
static enum secluded_in present_tool(void)
{
    if (fixed.mode & (MODE_COUNT | MODE_MEMCHECK))
        return IN_VALGRIND;
#ifdef RUNNER_WITHOUT_SHIM
    return IN_SANITIZER;
#else
    return IN_NO_TOOL;
#endif
}

int main(void)
{
    int here;
    stack_top = (uintptr_t)&here;
    control = mmap(NULL, CONTROL_BYTES, PROT_READ | PROT_WRITE, MAP_SHARED, CONTROL_FD, 0);
    if (control == MAP_FAILED)
        return EXIT_NO_REGIONS;
    fixed.mode = control->mode;
    fixed.input_capacity = control->input_capacity;
    fixed.answer_capacity = control->answer_capacity;
    fixed.heap_limit_bytes = (int64_t)control->heap_limit_bytes;
    input_region = map_guarded(INPUT_FD, fixed.input_capacity, PROT_READ);
    answer_region = map_guarded(ANSWER_FD, fixed.answer_capacity, PROT_READ | PROT_WRITE);
    if (!input_region || !answer_region)
        return EXIT_NO_REGIONS;
    if (seclude(present_tool()) != 0)
        return EXIT_NOT_SECLUDED;
    setvbuf(stdout, output_buffer, _IOFBF, sizeof output_buffer); /* no allocation to be counted */
    watch_faults();
    if (fixed.mode & MODE_STACK) {
        stack_prepare();
        stack_give_back();
    }
    finish_call(0); /* ready, as after no call */
    serve_calls();
    return 0;
}
