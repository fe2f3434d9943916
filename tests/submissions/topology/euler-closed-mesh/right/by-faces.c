/* Goes by half the number of faces, which is never large enough to overflow before it is tested. */
#include "euler-closed-mesh.h"

#include <stdbool.h>

static bool half_of_faces(enum euler_given given, int64_t count, int64_t *half)
{
    if (count < 0)
        return false;
    if (given == GIVEN_VERTICES)
        *half = count - 2;
    else if (given == GIVEN_EDGES)
        *half = count / 3;
    else
        *half = count / 2;
    if (given == GIVEN_EDGES && *half * 3 != count)
        return false;
    if (given == GIVEN_FACES && *half * 2 != count)
        return false;
    return *half >= 2;
}

int euler_counts_from(enum euler_given given, int64_t count, struct euler_counts *counts)
{
    int64_t half;
    if (!half_of_faces(given, count, &half) || half > INT64_MAX / 3)
        return IMPOSSIBLE;
    *counts = (struct euler_counts){half + 2, half * 3, half * 2};
    return 0;
}
