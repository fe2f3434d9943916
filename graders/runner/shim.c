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
void *student_malloc(size_t size);
void *student_calloc(size_t count, size_t size);
void *student_realloc(void *block, size_t size);
void *student_reallocarray(void *block, size_t count, size_t size);
void *student_aligned_alloc(size_t alignment, size_t size);
void *student_memalign(size_t alignment, size_t size);
void *student_valloc(size_t size);
int student_posix_memalign(void **block, size_t alignment, size_t size);
size_t student_malloc_usable_size(void *block);

/* Whose a block is; each counts as all before it do, and more. */
enum owner {
    OWNER_NOBODY, /* asked for outside of a call */
    OWNER_LIBC,   /* counts while it lives */
    OWNER_STUDENT /* must be given back, and can be refused */
};
enum { OWNER_BITS = 3 };

/* Stands right before every block. `check` ties it to its address, so that a pointer into the
 * middle of a block, or to no block at all, is told apart; its last bits say whose the block is. */
struct header {
    size_t size;
    uint32_t offset; /* from the real block to the student's */
    uint32_t check;
};
_Static_assert(sizeof(struct header) == 16, "blocks stay aligned to 16 bytes");

static struct {
    bool counting;
    enum shim_behalf behalf;
    struct header *graveyard; /* freed after the call, not yet given back; linked by `size` */
    int64_t limit_bytes, failing_allocation;
} state;

static uint32_t check_of(const void *block, enum owner owner)
{
    uint64_t mixed = ((uint64_t)(uintptr_t)block ^ 0x9E3779B97F4A7C15u) * 0xBF58476D1CE4E5B9u;
    return ((uint32_t)(mixed >> 32) & ~(uint32_t)OWNER_BITS) | (uint32_t)owner;
}

static struct header *header_of(void *block)
{
    return (struct header *)block - 1;
}

static bool is_live(void *block)
{
    const struct header *header = header_of(block);
    return (uintptr_t)block % 16 == 0 &&
           header->check == check_of(block, header->check & OWNER_BITS);
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
    struct shim_counts before = shim_counts;
    shim_counts = (struct shim_counts){.live_bytes = before.live_bytes,
                                       .own_bytes = before.own_bytes,
                                       .own_blocks = before.own_blocks,
                                       .peak_bytes = before.live_bytes};
    state.limit_bytes = limit_bytes;
    state.failing_allocation = failing_allocation;
    state.behalf = BEHALF_NONE;
    state.counting = true;
}

void shim_end(void)
{
    state.counting = false;
}

enum shim_behalf shim_on_behalf(enum shim_behalf behalf)
{
    enum shim_behalf before = state.behalf;
    state.behalf = behalf;
    return before;
}

/* Whose a block is that libc asks for now. */
static enum owner asked_by_libc(void)
{
    return state.behalf == BEHALF_NONE ? OWNER_LIBC : OWNER_STUDENT;
}

/* Whether an allocation of `size` bytes that replaces `replaced` bytes may be made; counts it. */
static bool admit(size_t size, int64_t replaced, enum owner owner)
{
    if (!state.counting)
        return true;
    if (owner == OWNER_STUDENT && state.behalf != BEHALF_TAKES) {
        shim_counts.allocation_count++;
        if (shim_counts.allocation_count == state.failing_allocation)
            return false;
    }
    if (size > (size_t)INT64_MAX / 2 ||
        shim_counts.live_bytes - replaced + (int64_t)size > state.limit_bytes) {
        shim_counts.refused_count++;
        return false;
    }
    return true;
}

static void *adopt(unsigned char *real, size_t offset, size_t size, enum owner owner)
{
    if (!real)
        return NULL;
    unsigned char *block = real + offset;
    *header_of(block) = (struct header){size, (uint32_t)offset, check_of(block, owner)};
    if (owner == OWNER_STUDENT) {
        shim_counts.own_bytes += (int64_t)size;
        shim_counts.own_blocks++;
    }
    if (owner != OWNER_NOBODY)
        shim_counts.live_bytes += (int64_t)size;
    if (shim_counts.live_bytes > shim_counts.peak_bytes)
        shim_counts.peak_bytes = shim_counts.live_bytes;
    return block;
}

/* Takes a block out of the counts. NULL when the pointer is no live block. */
static unsigned char *disown(void *block)
{
    struct header *header = header_of(block);
    if (!is_live(block)) {
        shim_counts.bad_free_count++;
        return NULL;
    }
    enum owner owner = header->check & OWNER_BITS;
    header->check = 0;
    if (owner == OWNER_STUDENT) {
        shim_counts.own_bytes -= (int64_t)header->size;
        shim_counts.own_blocks--;
    }
    if (owner != OWNER_NOBODY)
        shim_counts.live_bytes -= (int64_t)header->size;
    return (unsigned char *)block - header->offset;
}

static void *refuse(void)
{
    errno = ENOMEM;
    return NULL;
}

static enum owner counted(enum owner asker)
{
    return state.counting ? asker : OWNER_NOBODY;
}

/* ------------------------------------------------------------------ requests */

static void *request(size_t size, enum owner owner)
{
    if (!admit(size, 0, owner) || size > SIZE_MAX - sizeof(struct header))
        return refuse();
    return adopt(__real_malloc(size + sizeof(struct header)), sizeof(struct header), size,
                 counted(owner));
}

static void *request_zeros(size_t count, size_t size, enum owner owner)
{
    size_t bytes;
    if (__builtin_mul_overflow(count, size, &bytes))
        bytes = SIZE_MAX;
    if (!admit(bytes, 0, owner) || bytes > SIZE_MAX - sizeof(struct header))
        return refuse();
    return adopt(__real_calloc(1, bytes + sizeof(struct header)), sizeof(struct header), bytes,
                 counted(owner));
}

/* Moves by hand: the real realloc would not know blocks with an offset of more than a header. */
static void *move(void *block, size_t size, enum owner owner, enum owner old_owner)
{
    const struct header old = *header_of(block);
    unsigned char *real = disown(block);
    if (old.offset == sizeof(struct header)) {
        unsigned char *moved = __real_realloc(real, size + sizeof(struct header));
        return moved ? adopt(moved, sizeof(struct header), size, owner)
                     : (adopt(real, sizeof(struct header), old.size, old_owner), refuse());
    }
    unsigned char *fresh = __real_malloc(size + sizeof(struct header));
    if (!fresh)
        return adopt(real, old.offset, old.size, old_owner), refuse();
    memcpy(fresh + sizeof(struct header), block, size < old.size ? size : old.size);
    __real_free(real);
    return adopt(fresh, sizeof(struct header), size, owner);
}

/* A block of the student's that libc makes larger stays the student's, and one of libc's that the
 * student makes larger becomes so. */
static void *resize(void *block, size_t size, enum owner owner)
{
    if (!block)
        return request(size, owner);
    if (size == 0) {
        __wrap_free(block);
        return NULL;
    }
    const struct header old = *header_of(block);
    if (!is_live(block)) {
        shim_counts.bad_free_count++;
        return refuse();
    }
    enum owner old_owner = old.check & OWNER_BITS;
    if (owner < old_owner)
        owner = old_owner;
    if (!admit(size, old_owner != OWNER_NOBODY ? (int64_t)old.size : 0, owner) ||
        size > SIZE_MAX - sizeof(struct header))
        return refuse();
    return move(block, size, counted(owner), old_owner);
}

static void *request_aligned(size_t alignment, size_t size, enum owner owner)
{
    if (alignment < 16)
        alignment = 16;
    if ((alignment & (alignment - 1)) != 0 || alignment > 1u << 24 || !admit(size, 0, owner) ||
        size > SIZE_MAX - 2 * alignment - sizeof(struct header))
        return refuse();
    unsigned char *real = __real_malloc(size + alignment + sizeof(struct header));
    if (!real)
        return refuse();
    uintptr_t first = (uintptr_t)real + sizeof(struct header);
    uintptr_t aligned = (first + alignment - 1) / alignment * alignment;
    return adopt(real, aligned - (uintptr_t)real, size, counted(owner));
}

static int request_posix(void **block, size_t alignment, size_t size, enum owner owner)
{
    if (alignment % sizeof(void *) != 0 || (alignment & (alignment - 1)) != 0 || alignment == 0)
        return EINVAL;
    void *made = request_aligned(alignment, size, owner);
    if (!made)
        return ENOMEM;
    *block = made;
    return 0;
}

void __wrap_free(void *block)
{
    if (!block)
        return;
    unsigned char *real = disown(block);
    if (real && state.counting)
        __real_free(real);
    else if (real)
        bury(header_of(block));
}

/* ------------------------------------------------------------------ what libc calls */

void *__wrap_malloc(size_t size)
{
    return request(size, asked_by_libc());
}

void *__wrap_calloc(size_t count, size_t size)
{
    return request_zeros(count, size, asked_by_libc());
}

void *__wrap_realloc(void *block, size_t size)
{
    return resize(block, size, asked_by_libc());
}

void *__wrap_memalign(size_t alignment, size_t size)
{
    return request_aligned(alignment, size, asked_by_libc());
}

void *__wrap_aligned_alloc(size_t alignment, size_t size)
{
    return request_aligned(alignment, size, asked_by_libc());
}

void *__wrap_valloc(size_t size)
{
    return request_aligned(4096, size, asked_by_libc());
}

int __wrap_posix_memalign(void **block, size_t alignment, size_t size)
{
    return request_posix(block, alignment, size, asked_by_libc());
}

/* ------------------------------------------------------------------ what the student calls */

void *student_malloc(size_t size)
{
    return request(size, OWNER_STUDENT);
}

void *student_calloc(size_t count, size_t size)
{
    return request_zeros(count, size, OWNER_STUDENT);
}

void *student_realloc(void *block, size_t size)
{
    return resize(block, size, OWNER_STUDENT);
}

void *student_reallocarray(void *block, size_t count, size_t size)
{
    size_t bytes;
    return __builtin_mul_overflow(count, size, &bytes) ? refuse()
                                                       : resize(block, bytes, OWNER_STUDENT);
}

void *student_memalign(size_t alignment, size_t size)
{
    return request_aligned(alignment, size, OWNER_STUDENT);
}

void *student_aligned_alloc(size_t alignment, size_t size)
{
    return request_aligned(alignment, size, OWNER_STUDENT);
}

void *student_valloc(size_t size)
{
    return request_aligned(4096, size, OWNER_STUDENT);
}

int student_posix_memalign(void **block, size_t alignment, size_t size)
{
    return request_posix(block, alignment, size, OWNER_STUDENT);
}

/* What was asked for, and not a byte more: behind it another block's header may stand. */
size_t student_malloc_usable_size(void *block)
{
    return block && is_live(block) ? header_of(block)->size : 0;
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
