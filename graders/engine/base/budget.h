/* What all runs of one submission may take together, so that none holds up a class: its CPU time,
 * and the time in which it could have worked and did not. Time in which the machine did not let it
 * work (no CPU, a disk that is busy) counts for nobody. */
#ifndef GRADERS_ENGINE_BASE_BUDGET_H
#define GRADERS_ENGINE_BASE_BUDGET_H

#include <stdbool.h>
#include <stdint.h>

/* Of five slow answers, the dearest takes 16. */
enum { BUDGET_SECONDS = 300 };

struct budget {
    int64_t limit_ns, cpu_ns, idle_ns;
};

/* Whether what was taken and `more_ns` are beyond the limit; never where there is no budget (NULL),
 * as for a reference. */
static inline bool budget_is_spent(const struct budget *budget, int64_t more_ns)
{
    return budget && budget->cpu_ns + budget->idle_ns + more_ns > budget->limit_ns;
}

static inline void budget_take(struct budget *budget, int64_t cpu_ns, int64_t idle_ns)
{
    if (!budget)
        return;
    budget->cpu_ns += cpu_ns > 0 ? cpu_ns : 0;
    budget->idle_ns += idle_ns > 0 ? idle_ns : 0;
}

#endif
