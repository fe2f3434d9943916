/* The allocation shim; see shim.h. */
#include "graders/runner/shim.h"

struct shim_counts shim_counts;

#ifndef RUNNER_WITHOUT_SHIM

#include <errno.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *block, size_t size);
void __real_free(void *block);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *block, size_t size);
void __wrap_free(void *block);
void *__wrap_aligned_alloc(size_t alignment, size_t size);
void *__wrap_memalign(size_t alignment, size_t size);
void *__wrap_valloc(size_t size);
int __wrap_posix_memalign(void **block, size_t alignment, size_t size);

/* Stands right before every block. `check` ties it to its address, so that a pointer into the
 * middle of a block, or to no block at all, is told apart; its last bit says whether the block is
 * counted. */
struct header {
    size_t size;
    uint32_t offset; /* from the real block to the student's */
    uint32_t check;
};
_Static_assert(sizeof(struct header) == 16, "blocks stay aligned to 16 bytes");

static struct {
    bool counting;
    struct header *graveyard; /* freed after the call, not yet given back; linked by `size` */
    int64_t limit_bytes, failing_allocation;
} state;

static uint32_t check_of(const void *block, bool counted)
{
    uint64_t mixed = ((uint64_t)(uintptr_t)block ^ 0x9E3779B97F4A7C15u) * 0xBF58476D1CE4E5B9u;
    return (uint32_t)(mixed >> 32 & ~1u) | counted;
}

static struct header *header_of(void *block)
{
    return (struct header *)block - 1;
}

/* Blocks that are freed after the call stay readable until the next one: a pointer into a block
 * that went before is then told as no block, and does not crash the runner. */
static void bury(struct header *header)
{
    header->size = (size_t)state.graveyard;
    state.graveyard = header;
}

static void empty_graveyard(void)
{
    while (state.graveyard) {
        struct header *header = state.graveyard;
        state.graveyard = (struct header *)header->size;
        __real_free((unsigned char *)(header + 1) - header->offset);
    }
}

void shim_begin(int64_t limit_bytes, int64_t failing_allocation)
{
    empty_graveyard();
    int64_t live_bytes = shim_counts.live_bytes, live_blocks = shim_counts.live_blocks;
    shim_counts = (struct shim_counts){
        .live_bytes = live_bytes, .live_blocks = live_blocks, .peak_bytes = live_bytes};
    state.limit_bytes = limit_bytes;
    state.failing_allocation = failing_allocation;
    state.counting = true;
}

void shim_end(void)
{
    state.counting = false;
}

/* Whether an allocation of `size` bytes that replaces `replaced` bytes may be made; counts it. */
static bool admit(size_t size, int64_t replaced)
{
    if (!state.counting)
        return true;
    shim_counts.allocation_count++;
    if (shim_counts.allocation_count == state.failing_allocation)
        return false;
    if (size > (size_t)INT64_MAX / 2 ||
        shim_counts.live_bytes - replaced + (int64_t)size > state.limit_bytes) {
        shim_counts.refused_count++;
        return false;
    }
    return true;
}

static void *adopt(unsigned char *real, size_t offset, size_t size)
{
    if (!real)
        return NULL;
    unsigned char *block = real + offset;
    *header_of(block) = (struct header){size, (uint32_t)offset, check_of(block, state.counting)};
    if (state.counting) {
        shim_counts.live_bytes += (int64_t)size;
        shim_counts.live_blocks++;
        if (shim_counts.live_bytes > shim_counts.peak_bytes)
            shim_counts.peak_bytes = shim_counts.live_bytes;
    }
    return block;
}

/* Takes a block out of the counts. NULL when the pointer is no live block. */
static unsigned char *disown(void *block, size_t *size)
{
    struct header *header = header_of(block);
    bool counted = header->check & 1;
    if ((uintptr_t)block % 16 != 0 || header->check != check_of(block, counted)) {
        shim_counts.bad_free_count++;
        return NULL;
    }
    *size = header->size;
    header->check = 0;
    if (counted) {
        shim_counts.live_bytes -= (int64_t)*size;
        shim_counts.live_blocks--;
    }
    return (unsigned char *)block - header->offset;
}

static void *refuse(void)
{
    errno = ENOMEM;
    return NULL;
}

void *__wrap_malloc(size_t size)
{
    if (!admit(size, 0) || size > SIZE_MAX - sizeof(struct header))
        return refuse();
    return adopt(__real_malloc(size + sizeof(struct header)), sizeof(struct header), size);
}

void *__wrap_calloc(size_t count, size_t size)
{
    size_t bytes;
    if (__builtin_mul_overflow(count, size, &bytes))
        bytes = SIZE_MAX;
    if (!admit(bytes, 0) || bytes > SIZE_MAX - sizeof(struct header))
        return refuse();
    return adopt(__real_calloc(1, bytes + sizeof(struct header)), sizeof(struct header), bytes);
}

void __wrap_free(void *block)
{
    size_t size;
    if (!block)
        return;
    unsigned char *real = disown(block, &size);
    if (real && state.counting)
        __real_free(real);
    else if (real)
        bury(header_of(block));
}

/* Moves by hand: the real realloc would not know blocks with an offset of more than a header. */
void *__wrap_realloc(void *block, size_t size)
{
    if (!block)
        return __wrap_malloc(size);
    if (size == 0) {
        __wrap_free(block);
        return NULL;
    }
    struct header old = *header_of(block);
    bool counted = old.check & 1;
    if (!admit(size, counted ? (int64_t)old.size : 0) || size > SIZE_MAX - sizeof(struct header))
        return refuse();
    size_t old_size;
    unsigned char *real = disown(block, &old_size);
    if (!real)
        return refuse();
    if (old.offset == sizeof(struct header)) {
        unsigned char *moved = __real_realloc(real, size + sizeof(struct header));
        return moved ? adopt(moved, sizeof(struct header), size)
                     : (adopt(real, sizeof(struct header), old_size), refuse());
    }
    unsigned char *fresh = __real_malloc(size + sizeof(struct header));
    if (!fresh)
        return adopt(real, old.offset, old_size), refuse();
    memcpy(fresh + sizeof(struct header), block, size < old_size ? size : old_size);
    __real_free(real);
    return adopt(fresh, sizeof(struct header), size);
}

void *__wrap_memalign(size_t alignment, size_t size)
{
    if (alignment < 16)
        alignment = 16;
    if ((alignment & (alignment - 1)) != 0 || alignment > 1u << 24 || !admit(size, 0) ||
        size > SIZE_MAX - 2 * alignment - sizeof(struct header))
        return refuse();
    unsigned char *real = __real_malloc(size + alignment + sizeof(struct header));
    if (!real)
        return refuse();
    uintptr_t first = (uintptr_t)real + sizeof(struct header);
    uintptr_t aligned = (first + alignment - 1) / alignment * alignment;
    return adopt(real, aligned - (uintptr_t)real, size);
}

void *__wrap_aligned_alloc(size_t alignment, size_t size)
{
    return __wrap_memalign(alignment, size);
}

void *__wrap_valloc(size_t size)
{
    return __wrap_memalign(4096, size);
}

int __wrap_posix_memalign(void **block, size_t alignment, size_t size)
{
    if (alignment % sizeof(void *) != 0 || (alignment & (alignment - 1)) != 0 || alignment == 0)
        return EINVAL;
    void *made = __wrap_memalign(alignment, size);
    if (!made)
        return ENOMEM;
    *block = made;
    return 0;
}

#else

void shim_begin(int64_t limit_bytes, int64_t failing_allocation)
{
    (void)limit_bytes;
    (void)failing_allocation;
}

void shim_end(void)
{
}

#endif
