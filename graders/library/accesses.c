/* Counted accesses; see accesses.h. */
#include "graders/library/accesses.h"

#include <inttypes.h>

static const struct cause impossible = {"impossible-accesses",
                                        {"too few accesses", "demasiado pocos accesos"}};

bool accesses_reject(const struct usage *usage, int64_t least, struct judgement *out)
{
    if (usage->access_count >= least)
        return false;
    judge_reject(out, &impossible,
                 "The answers are right, but %" PRId64 " accesses were counted, and no program can "
                 "find them with fewer than %" PRId64 ": what an earlier call has read must not be "
                 "kept for a later one.",
                 "Las respuestas son correctas, pero se contaron %" PRId64 " accesos y ningún "
                 "programa puede hallarlas con menos de %" PRId64 ": lo que ha leído una llamada "
                 "no debe guardarse para otra posterior.",
                 usage->access_count, least);
    return true;
}
