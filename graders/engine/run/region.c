/* Shared memory of sealed size; see region.h. */
#include "graders/engine/run/region.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

enum { PAGE = 4096 };

int region_make(struct region *region, size_t bytes, bool input, struct error *err)
{
    size_t capacity = bytes / PAGE * PAGE + (bytes % PAGE || bytes == 0 ? PAGE : 0);
    *region = (struct region){.fd = memfd_create("region", MFD_CLOEXEC | MFD_ALLOW_SEALING),
                              .capacity = capacity};
    if (region->fd < 0 || ftruncate(region->fd, (off_t)capacity) != 0)
        goto failed;
    region->bytes = mmap(NULL, capacity, PROT_READ | PROT_WRITE, MAP_SHARED, region->fd, 0);
    if (region->bytes == MAP_FAILED) {
        region->bytes = NULL;
        goto failed;
    }
    int seals = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL | (input ? F_SEAL_FUTURE_WRITE : 0);
    if (fcntl(region->fd, F_ADD_SEALS, seals) != 0)
        goto failed;
    return 0;
failed:
    error_set(err, "shared memory of %zu bytes: %s", capacity, strerror(errno));
    if (region->bytes)
        munmap(region->bytes, capacity);
    if (region->fd >= 0)
        close(region->fd);
    *region = (struct region){.fd = -1};
    return -1;
}

void region_release(struct region *region)
{
    if (region->bytes) { /* all zero is nothing made, not descriptor 0 */
        munmap(region->bytes, region->capacity);
        close(region->fd);
    }
    *region = (struct region){.fd = -1};
}
