/* callgrind's dumps as one stream; see dumps.h. */
#include "graders/engine/run/dumps.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { TEXT_BYTES = 4 << 20 }; /* an honest dump has some 10 KiB */

struct dumps dumps_none(void)
{
    return (struct dumps){.fd = -1};
}

int dumps_make(struct dumps *dumps, const char *folder, int count, struct error *err)
{
    char first[PATH_MAX + 16], path[PATH_MAX + 32];
    *dumps = (struct dumps){.fd = -1, .number = 1};
    dumps->text = malloc(TEXT_BYTES);
    if (!dumps->text)
        return error_set(err, "out of memory for counts");
    snprintf(first, sizeof first, "%s/counts", folder);
    if (mkfifo(first, 0600) != 0)
        return error_set(err, "%s: %s", first, strerror(errno));
    /* For writing too: so the pipe never ends, and nobody who writes to it waits for a reader. */
    dumps->fd = open(first, O_RDWR | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
    if (dumps->fd < 0 || fchmod(dumps->fd, 0222) != 0)
        return error_set(err, "%s: %s", first, strerror(errno));
    for (int number = 1; number <= count; number++) {
        snprintf(path, sizeof path, "%s.%d", first, number);
        if (link(first, path) != 0)
            return error_set(err, "%s: %s", path, strerror(errno));
    }
    return 0;
}

void dumps_drain(void *argument)
{
    struct dumps *dumps = argument;
    while (dumps->fd >= 0 && !dumps->too_long) {
        size_t room = TEXT_BYTES - dumps->count;
        ssize_t got = read(dumps->fd, dumps->text + dumps->count, room);
        if (got <= 0)
            break;
        dumps->count += (size_t)got;
        dumps->too_long = dumps->count == TEXT_BYTES;
    }
}

int dumps_take(struct dumps *dumps, const char *trigger, const struct callgrind_calls *calls,
               struct callgrind_dump *dump, struct error *err)
{
    dumps_drain(dumps);
    size_t count = dumps->count;
    int64_t number = dumps->number++;
    dumps->count = 0;
    if (count == 0)
        return error_set(err, "callgrind dumped nothing");
    if (dumps->too_long)
        return error_set(err, "more than any dump of callgrind");
    if (callgrind_parse_calls(dumps->text, count, calls, dump, err) != 0)
        return -1;
    if (dump->part != number)
        return error_set(err, "callgrind's dump %lld came as number %lld", (long long)dump->part,
                         (long long)number);
    if (strcmp(dump->trigger, trigger) != 0)
        return error_set(err, "callgrind's dump %lld was made by \"%s\", not by \"%s\"",
                         (long long)number, dump->trigger, trigger);
    return 0;
}

void dumps_release(struct dumps *dumps)
{
    if (dumps->fd >= 0)
        close(dumps->fd);
    free(dumps->text);
    *dumps = dumps_none();
}
