/* A library to preload (LD_PRELOAD) that counts what a program takes from malloc. Works for any
 * program that leaves allocation to glibc, C++ ones too. Sizes are what the allocator makes of a
 * request (malloc_usable_size). Not for measuring time. */
#include "bench/measure/allocation_counts.h"

#include <errno.h>
#include <malloc.h>
#include <stdlib.h>

/* glibc's own, under their other names. */
void *__libc_malloc(size_t bytes);
void *__libc_calloc(size_t count, size_t bytes);
void *__libc_realloc(void *old, size_t bytes);
void *__libc_memalign(size_t alignment, size_t bytes);
void __libc_free(void *memory);

extern struct allocation_counts meshgrade_allocation_counts;
struct allocation_counts meshgrade_allocation_counts;

static void add_live(int64_t bytes)
{
    int64_t live =
        __atomic_add_fetch(&meshgrade_allocation_counts.live_bytes, bytes, __ATOMIC_RELAXED);
    int64_t peak = __atomic_load_n(&meshgrade_allocation_counts.peak_bytes, __ATOMIC_RELAXED);
    while (live > peak &&
           !__atomic_compare_exchange_n(&meshgrade_allocation_counts.peak_bytes, &peak, live, 1,
                                        __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
    }
}

static void *counted(void *memory)
{
    if (!memory)
        return NULL;
    int64_t bytes = (int64_t)malloc_usable_size(memory);
    __atomic_add_fetch(&meshgrade_allocation_counts.allocations, 1, __ATOMIC_RELAXED);
    __atomic_add_fetch(&meshgrade_allocation_counts.allocated_bytes, bytes, __ATOMIC_RELAXED);
    add_live(bytes);
    return memory;
}

void *malloc(size_t bytes)
{
    return counted(__libc_malloc(bytes));
}

void *calloc(size_t count, size_t bytes)
{
    return counted(__libc_calloc(count, bytes));
}

void *realloc(void *old, size_t bytes)
{
    int64_t before = old ? (int64_t)malloc_usable_size(old) : 0;
    void *memory = __libc_realloc(old, bytes);
    if (memory || bytes == 0)
        add_live(-before);
    return counted(memory);
}

void *memalign(size_t alignment, size_t bytes)
{
    return counted(__libc_memalign(alignment, bytes));
}

void *aligned_alloc(size_t alignment, size_t bytes)
{
    return counted(__libc_memalign(alignment, bytes));
}

int posix_memalign(void **memory, size_t alignment, size_t bytes)
{
    void *taken = counted(__libc_memalign(alignment, bytes));
    if (!taken)
        return ENOMEM;
    *memory = taken;
    return 0;
}

void free(void *memory)
{
    if (memory)
        add_live(-(int64_t)malloc_usable_size(memory));
    __libc_free(memory);
}
