/* Huge pages; see huge_pages.h. */
#include "reference/formats/huge_pages.h"

#include <stdint.h>
#include <sys/mman.h>

void huge_pages_prefer(void *memory, size_t byte_count)
{
    const uintptr_t page = 4096, least = 4 << 20;
    uintptr_t start = ((uintptr_t)memory + page - 1) & ~(page - 1);
    uintptr_t end = ((uintptr_t)memory + byte_count) & ~(page - 1);
    /* Only a wish: what it returns does not matter. */
    if (end > start && end - start >= least)
        (void)madvise((void *)start, end - start, MADV_HUGEPAGE);
}
