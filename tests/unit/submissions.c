/* Compiling and running known submissions; see submissions.h. */
#include "tests/unit/submissions.h"

#include "graders/engine/build/wrapped.h"
#include "graders/wire/control.h"

#include <fcntl.h>
#include <linux/futex.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>

enum { COMMAND_BYTES = 4096, STEP_NS = 5000000, STOP_SECONDS = 20 };
static const rlim_t MEMORY_BYTES = (rlim_t)1 << 30;

/* ------------------------------------------------------------------ compile */

void submission_build(struct submission *submission, const char *group, const char *name,
                      const char *source)
{
    char command[COMMAND_BYTES];
    snprintf(submission->program, sizeof submission->program, "/tmp/meshgrade-XXXXXX");
    int descriptor = mkstemp(submission->program);
    assert_true(descriptor >= 0);
    close(descriptor);
    snprintf(command, sizeof command,
             "gcc -std=c17 -O1 -Wall -Wextra -Iexercises/%s/%s -c %s -o %s && "
             "objcopy" WRAPPED_OBJECT " %s %s.o && "
             "gcc -static %s.o build/runner/%s/%s.plain.o -o %s " WRAPPED_LINK " -lm && rm %s.o",
             group, name, source, submission->program, submission->program, submission->program,
             submission->program, group, name, submission->program, submission->program);
    if (system(command) != 0)
        fail_msg("%s does not compile", source);
}

void submission_release(struct submission *submission)
{
    unlink(submission->program);
}

/* ---------------------------------------------------------------------- run */

struct regions {
    int descriptor[3]; /* control, input, answer: what the program finds as 3, 4, 5 */
    struct control *control;
};

static int region_make(size_t bytes)
{
    int descriptor = memfd_create("region", MFD_CLOEXEC);
    assert_true(descriptor >= 0);
    assert_int_equal(ftruncate(descriptor, (off_t)bytes), 0);
    return descriptor;
}

static void regions_make(struct regions *regions, struct span input, size_t answer_bound)
{
    regions->descriptor[0] = region_make(CONTROL_BYTES);
    regions->descriptor[1] = region_make(input.count);
    regions->descriptor[2] = region_make(answer_bound);
    for (size_t at = 0; at < input.count;) {
        ssize_t written = write(regions->descriptor[1], input.bytes + at, input.count - at);
        assert_true(written > 0);
        at += (size_t)written;
    }
    regions->control =
        mmap(NULL, CONTROL_BYTES, PROT_READ | PROT_WRITE, MAP_SHARED, regions->descriptor[0], 0);
    assert_true(regions->control != MAP_FAILED);
    regions->control->input_bytes = input.count;
    regions->control->input_capacity = input.count;
    regions->control->answer_capacity = answer_bound;
    regions->control->heap_limit_bytes = MEMORY_BYTES;
    regions->control->nonce = 1;
}

static void regions_release(struct regions *regions)
{
    munmap(regions->control, CONTROL_BYTES);
    for (int i = 0; i < 3; i++)
        close(regions->descriptor[i]);
}

/* In the child. The descriptors are moved out of the way first: they may be 3, 4 or 5 themselves.
 */
static void become(const char *program, const struct regions *regions)
{
    int high[3];
    for (int i = 0; i < 3; i++)
        high[i] = fcntl(regions->descriptor[i], F_DUPFD, 16);
    for (int i = 0; i < 3; i++)
        dup2(high[i], CONTROL_FD + i);
    setrlimit(RLIMIT_AS, &(struct rlimit){MEMORY_BYTES, MEMORY_BYTES});
    setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
    alarm(STOP_SECONDS);
    execl(program, program, (char *)NULL);
    _exit(127);
}

/* Waits until call 1 is done or the program is gone; returns whether it is done. */
static bool wait_for_call(struct control *control, pid_t program)
{
    const struct timespec step = {.tv_nsec = STEP_NS};
    while (atomic_load(&control->done_index) == 0) {
        if (waitpid(program, NULL, WNOHANG) == program)
            return false;
        syscall(SYS_futex, &control->done_index, FUTEX_WAIT, 0, &step, NULL, 0);
    }
    kill(program, SIGKILL);
    waitpid(program, NULL, 0);
    return true;
}

static void take_answer(const struct regions *regions, struct submission_answer *answer)
{
    const struct control *control = regions->control;
    answer->end = control->out_of_memory ? SUBMISSION_OUT_OF_MEMORY : SUBMISSION_ANSWERED;
    answer->usage = (struct usage){.heap_peak_bytes = control->heap_peak_bytes,
                                   .heap_held_bytes = control->heap_held_bytes,
                                   .heap_left_bytes = control->heap_left_bytes,
                                   .allocation_count = control->allocation_count,
                                   .known = true,
                                   .access_count = control->access_count};
    answer->bad_free_count = control->bad_free_count;
    answer->count = control->answer_bytes < control->answer_capacity ? control->answer_bytes
                                                                     : control->answer_capacity;
    answer->bytes = malloc(answer->count + 1);
    assert_non_null(answer->bytes);
    assert_true(pread(regions->descriptor[2], answer->bytes, answer->count, 0) ==
                (ssize_t)answer->count);
}

void submission_run(const struct submission *submission, struct span input, size_t answer_bound,
                    int64_t failing_allocation, struct submission_answer *answer)
{
    struct regions regions;
    *answer = (struct submission_answer){.end = SUBMISSION_DIED};
    regions_make(&regions, input, answer_bound);
    regions.control->failing_allocation = failing_allocation;
    atomic_store(&regions.control->call_index, 1);
    pid_t program = fork();
    assert_true(program >= 0);
    if (program == 0)
        become(submission->program, &regions);
    if (wait_for_call(regions.control, program))
        take_answer(&regions, answer);
    regions_release(&regions);
}

void submission_answer_release(struct submission_answer *answer)
{
    free(answer->bytes);
    *answer = (struct submission_answer){0};
}
