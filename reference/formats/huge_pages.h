/* Large tables on huge pages: the first touch of each page costs a microsecond or two, so that
 * fresh memory in pages of 4 KiB takes longer than reading a mesh into it. */
#ifndef REFERENCE_FORMATS_HUGE_PAGES_H
#define REFERENCE_FORMATS_HUGE_PAGES_H

#include <stddef.h>

/* Tells the kernel that the memory, fresh from malloc or realloc, is worth huge pages; of small
 * tables and where there are none nothing happens. It is freed as ever. */
void huge_pages_prefer(void *memory, size_t byte_count);

#endif
