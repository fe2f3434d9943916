/* Tries: one of every kind of function that a right answer may want of libc and of the compiler
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <assert.h>
#include <complex.h>
#include <ctype.h>
#include <errno.h>
#include <fenv.h>
#include <inttypes.h>
#include <locale.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <threads.h>
#include <wchar.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    volatile double x = vertex_count;
    volatile long double y = x;
    volatile __int128 wide = triangle_count;
    volatile _Float128 quad = x;
    char text[100], word[10];
    jmp_buf back;
    thread_local static int calls;
    assert(vertex_count >= 0);
    if (setjmp(back) == 0)
        longjmp(back, ++calls ? 1 : 2);
    snprintf(text, sizeof text, "%d %s %" PRId64, vertex_count, "word", (int64_t)wide);
    const bool is_right = sscanf(text, "%*d %9s", word) == 1 && isalpha(word[0]);
    wide = wide * wide / 3 % 7;
    quad = quad * quad / 3;
    x = creal(cexp(x * I)) + cabs(x + I) + lgamma(x) + fma(x, x, x) + (double)sinl(y) + fmod(x, 3) +
        (double)quad + (double)wide;
    fesetround(FE_TONEAREST);
    setlocale(LC_ALL, "C");
    printf("%s %g %jd %s %zu\n", text, x, strtoimax("12", NULL, 0), strerror(errno),
           wcslen(L"abc"));
    return is_right ? honest_edges(triangles, triangle_count, edges) : -7;
}
