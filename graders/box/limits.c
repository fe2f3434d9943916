/* Resource limits of the program. */
#include "graders/box/inside.h"

#include <errno.h>
#include <sched.h>
#include <sys/resource.h>

/* Room in the address space for the program's own code, stacks and shared regions. */
enum { ADDRESS_SLACK_BYTES = 64 << 20 };

static void limit(struct report *report, int resource, uint64_t soft, uint64_t hard)
{
    struct rlimit value = {soft, hard};
    if (setrlimit((__rlimit_resource_t)resource, &value))
        layer_fails(report, BOX_RLIMITS, "setrlimit", errno);
}

void limits_apply(struct inside *inside)
{
    const struct box_plan *plan = inside->plan;
    struct report *report = &inside->report;
    if (!layer_wanted(plan, BOX_RLIMITS))
        return;
    layer_works(report, BOX_RLIMITS);
    /* 1, not 0: too small for any core file, and the value that also stops core patterns which pipe
     * into a program. */
    limit(report, RLIMIT_CORE, 1, 1);
    limit(report, RLIMIT_CPU, plan->cpu_seconds, plan->cpu_seconds + 1ull);
    limit(report, RLIMIT_FSIZE, plan->file_bytes, plan->file_bytes);
    limit(report, RLIMIT_NOFILE, plan->profile == BOX_RUN ? 64 : 256,
          plan->profile == BOX_RUN ? 64 : 256);
    limit(report, RLIMIT_MEMLOCK, 0, 0);
    limit(report, RLIMIT_MSGQUEUE, 0, 0);
    limit(report, RLIMIT_SIGPENDING, 64, 64);
    limit(report, RLIMIT_NICE, 0, 0);
    limit(report, RLIMIT_RTPRIO, 0, 0);
    /* Inside a user namespace the kernel counts the processes of this box alone (init is one).
     * Outside it would count all that the user runs, so that only "none at all" can be said. */
    uint64_t processes = plan->profile == BOX_BUILD ? plan->process_count + 1ull : 1;
    if (inside->namespaces & CLONE_NEWUSER || plan->profile != BOX_BUILD)
        limit(report, RLIMIT_NPROC, processes, processes);
}

/* Apart and late: the engine's own image, of which this process is still a copy, may be larger. */
void limits_apply_address_space(struct inside *inside)
{
    const struct box_plan *plan = inside->plan;
    if (!layer_wanted(plan, BOX_RLIMITS))
        return;
    uint64_t bytes = plan->memory_bytes + plan->stack_bytes + ADDRESS_SLACK_BYTES;
    limit(&inside->report, RLIMIT_STACK, plan->stack_bytes, plan->stack_bytes);
    if (plan->profile != BOX_TOOLS) /* valgrind and AddressSanitizer reserve terabytes of it */
        limit(&inside->report, RLIMIT_AS, bytes, bytes);
}
