/* See stack.h. */
#include "graders/runner/stack.h"

#include <stddef.h>
#include <sys/mman.h>

enum {
    PAGE = 4096,
    PAGES = 3072,   /* looked at: 12 MiB of the 16 that a stack can have */
    GAP_BYTES = 512 /* the frames of the functions here, and what they call */
};

static unsigned char *lowest;         /* page that is looked at */
static const volatile uint64_t *from; /* where the call may begin */

static unsigned char *page_of(const volatile void *at)
{
    return (unsigned char *)((uintptr_t)at / PAGE * PAGE);
}

/* Touches the lowest page, so that all lie in the stack as the kernel sees it. It must not give the
 * call large pages, of which one byte makes 2 MiB resident. */
void stack_prepare(void)
{
    lowest = page_of(__builtin_frame_address(0)) - (size_t)PAGES * PAGE;
    *(volatile unsigned char *)lowest = 0;
    madvise(lowest, (size_t)PAGES * PAGE, MADV_NOHUGEPAGE);
}

/* The rest of the page that frames above still use is cleared by hand. */
__attribute__((noinline)) void stack_give_back(void)
{
    volatile uint64_t *at =
        (volatile uint64_t *)((uintptr_t)__builtin_frame_address(0) - GAP_BYTES);
    unsigned char *page = page_of(at);
    from = at;
    while ((unsigned char *)(uintptr_t)at > page)
        *--at = 0;
    madvise(lowest, (size_t)(page - lowest), MADV_DONTNEED);
}

__attribute__((noinline)) int64_t stack_used_bytes(void)
{
    static unsigned char resident[PAGES + 1];
    const unsigned char *last = page_of(from);
    size_t count = (size_t)(last - lowest) / PAGE, i = 0;
    if (count > PAGES || mincore(lowest, count * PAGE, resident) != 0)
        count = 0;
    while (i < count && !(resident[i] & 1))
        i++;
    const volatile uint64_t *page = (const volatile uint64_t *)(last - (count - i) * PAGE);
    const volatile uint64_t *end = i < count ? page + PAGE / sizeof *page : from, *at = page;
    while (at < end && *at == 0)
        at++;
    if (i < count && at == end)
        at = page; /* used, and left empty */
    return (const unsigned char *)(uintptr_t)from - (const unsigned char *)(uintptr_t)at;
}
