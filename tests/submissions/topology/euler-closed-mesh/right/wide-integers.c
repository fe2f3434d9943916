/* Computes with 128 bits, then tests whether Euler's formula and 3F = 2E hold and all fits. */
#include "euler-closed-mesh.h"

__extension__ typedef __int128 wide;

int euler_counts_from(enum euler_given given, int64_t count, struct euler_counts *counts)
{
    static const int denominator[3] = {1, 3, 2};
    wide base = given == GIVEN_VERTICES ? (wide)count - 2 : (wide)count;
    wide v = base / denominator[given] + 2;
    wide e = 3 * base / denominator[given];
    wide f = 2 * base / denominator[given];
    wide given_again = given == GIVEN_VERTICES ? v : given == GIVEN_EDGES ? e : f;
    if (v - e + f != 2 || 3 * f != 2 * e || given_again != count)
        return IMPOSSIBLE;
    if (v < 4 || e > INT64_MAX || f > INT64_MAX)
        return IMPOSSIBLE;
    counts->vertices = (int64_t)v;
    counts->edges = (int64_t)e;
    counts->faces = (int64_t)f;
    return 0;
}
