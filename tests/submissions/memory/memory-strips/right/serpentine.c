/* Every second strip runs back from right to left; i / 2 and i % 2 place vertex i. */
#include "memory-strips.h"

#include <stdlib.h>

struct vertex {
    float x, y, z;
};

int64_t strips_bytes(int32_t m, int32_t n)
{
    return (int64_t)sizeof(int) +
           (int64_t)m * (int64_t)(sizeof(void *) + 2 * ((size_t)n + 1) * sizeof(struct vertex));
}

double strips_kilobytes(void)
{
    return (double)strips_bytes(128, 128) / 1024.0;
}

int64_t strips_processed_vertices(int32_t m, int32_t n)
{
    return (int64_t)m * (2LL * n + 2);
}

int64_t indexed_processed_vertices(int32_t m, int32_t n)
{
    return (m + 1LL) * (n + 1LL);
}

double strips_memory_ratio(void)
{
    return 3.0 / 2.0;
}

double strips_time_ratio(void)
{
    return 2.0;
}

static struct vertex place(int32_t m, int32_t n, int32_t row, int32_t i)
{
    int32_t column = row % 2 == 0 ? i / 2 : n - i / 2;
    int32_t upper = (row + i) % 2 == 0;
    return (struct vertex){(float)column / (float)n, (float)(row + upper) / (float)m, 0};
}

int strips_build(int32_t m, int32_t n, struct strip_grid *grid)
{
    int32_t count = 2 * (n + 1);
    float **strips = malloc(sizeof(float *) * (size_t)m);
    int32_t made = 0;
    while (strips && made < m) {
        struct vertex *strip = malloc(sizeof *strip * (size_t)count);
        if (!strip)
            break;
        for (int32_t i = 0; i < count; i++)
            strip[i] = place(m, n, made, i);
        strips[made++] = &strip->x;
    }
    if (made < m) {
        while (made > 0)
            free(strips[--made]);
        free(strips);
        return OUT_OF_MEMORY;
    }
    grid->strips = strips;
    grid->strip_count = m;
    grid->vertices_per_strip = count;
    return 0;
}
