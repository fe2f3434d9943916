/* For rows that attack. Right answers, for those whose attack is followed by one: were it not
 * stopped, the row would pass, and so be noticed. And how a program knows the tool that it is
 * under, though no variable tells: by where it lies. The driver puts this file beside every row. */
#ifndef HONEST_H
#define HONEST_H

#include <elf.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

static const volatile char place;

/* The static program begins at 4 MiB; valgrind puts those that can lie anywhere below, the kernel
 * puts them high. */
static inline bool under_sanitizer(void)
{
    return (uintptr_t)&place >> 32 != 0;
}

static inline bool under_memcheck(void)
{
    return (uintptr_t)&place < 0x400000;
}

static inline bool under_callgrind(void)
{
    volatile char local = 0; /* valgrind's stack */
    return (uintptr_t)&local >> 32 == 0x1f && !under_memcheck() && !under_sanitizer();
}

/* All data that the static program may write, the runner's too, as its header says: names of the
 * linker's for that the screen refuses. */
static inline char *all_data(size_t *bytes)
{
    volatile uintptr_t start = 0x400000;
    const Elf64_Ehdr *program = (const Elf64_Ehdr *)start;
    const Elf64_Phdr *part = (const Elf64_Phdr *)(start + program->e_phoff);
    while (part->p_type != PT_LOAD || !(part->p_flags & PF_W))
        part++;
    *bytes = part->p_memsz;
    return (char *)(uintptr_t)part->p_vaddr;
}

static inline int64_t honest_edges(const int32_t *triangles, int32_t triangle_count,
                                   int32_t **edges)
{
    int32_t *table = malloc(3 * (size_t)triangle_count * sizeof *table + 1);
    if (!table)
        return -1;
    int64_t count = 0;
    for (size_t s = 0; s < 3 * (size_t)triangle_count; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        if (i < j) {
            table[2 * count] = i;
            table[2 * count++ + 1] = j;
        }
    }
    *edges = table;
    return count;
}

/* Right, in quadratic time: looks for each of the first sides, one in `part` of all, whether it
 * came before. */
static inline int64_t quadratic_edges(const int32_t *triangles, int32_t triangle_count, int part,
                                      int32_t **edges)
{
    volatile int64_t seen = 0;
    int64_t sides = 3 * (int64_t)triangle_count / part;
    for (int64_t s = 0; s < sides; s++)
        for (int64_t t = 0; t < s; t++)
            seen += triangles[t] == triangles[s];
    return honest_edges(triangles, triangle_count, edges);
}

/* Half of the length of the cross product of two sides, from the corner opposite to the longest. */
static inline double honest_triangle(const float *vertices, const int32_t *corners)
{
    const float *p[3];
    double square[3], u[3], v[3];
    for (int k = 0; k < 3; k++)
        p[k] = vertices + 3 * (size_t)corners[k];
    for (int k = 0; k < 3; k++) {
        const float *a = p[(k + 1) % 3], *b = p[(k + 2) % 3];
        double x = (double)b[0] - a[0], y = (double)b[1] - a[1], z = (double)b[2] - a[2];
        square[k] = x * x + y * y + z * z;
    }
    int k = square[0] >= square[1] ? 0 : 1;
    k = square[k] >= square[2] ? k : 2;
    for (int axis = 0; axis < 3; axis++) {
        u[axis] = (double)p[(k + 1) % 3][axis] - p[k][axis];
        v[axis] = (double)p[(k + 2) % 3][axis] - p[k][axis];
    }
    double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2];
    double z = u[0] * v[1] - u[1] * v[0];
    return 0.5 * sqrt(x * x + y * y + z * z);
}

static inline double honest_area(const float *vertices, const int32_t *triangles,
                                 int32_t triangle_count)
{
    double area = 0;
    for (int32_t t = 0; t < triangle_count; t++)
        area += honest_triangle(vertices, triangles + 3 * (size_t)t);
    return area;
}

#endif
