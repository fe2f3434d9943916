/* Problem 4.4. Replace what stands in the function; euler-closed-mesh.h says what it must do. */
#include "euler-closed-mesh.h"

int euler_counts_from(enum euler_given given, int64_t count, struct euler_counts *counts)
{
    (void)given;
    counts->vertices = count;
    counts->edges = count;
    counts->faces = count;
    return 0;
}
