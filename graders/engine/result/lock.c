/* One run at a time; see lock.h. */
#include "graders/engine/result/lock.h"

#include "graders/engine/base/files.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { HOLDER_BYTES = 160 };

/* Who holds it, as the holder wrote it: a line, or "" when it did not come to it. */
static void read_holder(int file, char holder[HOLDER_BYTES])
{
    ssize_t count = pread(file, holder, HOLDER_BYTES - 1, 0);
    holder[count > 0 ? count : 0] = '\0';
    for (char *at = holder; *at; at++) {
        if (*at == '\n')
            *at = '\0';
        else if (*at < ' ' || *at > '~')
            *at = '?';
        if (!*at)
            break;
    }
}

static int write_holder(int file, const char *path, struct error *err)
{
    char holder[HOLDER_BYTES], host[65] = "", since[32] = "";
    time_t now = time(NULL);
    struct tm utc;
    gethostname(host, sizeof host - 1);
    if (gmtime_r(&now, &utc))
        strftime(since, sizeof since, "%Y-%m-%d %H:%M:%S UTC", &utc);
    int length =
        snprintf(holder, sizeof holder, "process %d on %s, since %s\n", (int)getpid(), host, since);
    if (ftruncate(file, 0) != 0 || pwrite(file, holder, (size_t)length, 0) != length)
        return error_set(err, "%s: cannot be written: %s", path, strerror(errno));
    return 0;
}

static int complain(int file, const char *out, const char *path, struct error *err)
{
    char holder[HOLDER_BYTES];
    if (errno != EACCES && errno != EAGAIN)
        return error_set(err, "%s: cannot be locked: %s (take a folder on a local disk)", path,
                         strerror(errno));
    read_holder(file, holder);
    return error_set(err,
                     "%s: another meshgrade is at work there (%s); wait for it, or stop it and "
                     "run this again",
                     out, holder[0] ? holder : "a process that has just begun");
}

int lock_take(struct lock *lock, const char *out, struct error *err)
{
    char path[PATH_MAX];
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    lock->file = -1;
    if (file_path(path, err, "%s/meshgrade.lock", out) != 0)
        return -1;
    lock->file = open(path, O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644);
    if (lock->file < 0)
        return errno == ENOENT || errno == ENOTDIR
                   ? error_set_request(err, "%s: %s", out, strerror(errno))
                   : error_set(err, "%s: %s", path, strerror(errno));
    if (fcntl(lock->file, F_SETLK, &whole) != 0)
        return complain(lock->file, out, path, err);
    return write_holder(lock->file, path, err);
}

void lock_release(struct lock *lock)
{
    if (lock->file >= 0)
        close(lock->file);
    lock->file = -1;
}
