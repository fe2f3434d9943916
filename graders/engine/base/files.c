/* Files and folders; see files.h. */
#include "graders/engine/base/files.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <linux/openat2.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

int file_path(char *path, struct error *err, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(path, PATH_MAX, format, arguments);
    va_end(arguments);
    return length >= 0 && length < PATH_MAX
               ? 0
               : error_set(err, "%.200s...: the path is too long", path);
}

static int read_bytes(int descriptor, const char *name, char *buffer, size_t size, size_t *count,
                      struct error *err)
{
    *count = 0;
    while (*count < size) {
        ssize_t got = read(descriptor, buffer + *count, size - *count);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return error_set(err, "%s: %s", name, strerror(errno));
        if (got == 0)
            break; /* it shrank while we read */
        *count += (size_t)got;
    }
    buffer[*count] = '\0';
    return 0;
}

/* Takes the descriptor over. */
static int read_descriptor(int descriptor, const char *name, size_t limit, char **bytes,
                           size_t *count, struct error *err)
{
    struct stat status;
    char *buffer = NULL;
    int result = -1;
    if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode))
        error_set(err, "%s: not a regular file", name);
    else if ((uint64_t)status.st_size > limit)
        error_set(err, "%s: %lld bytes, more than the %zu allowed", name, (long long)status.st_size,
                  limit);
    else if (!(buffer = malloc((size_t)status.st_size + 1)))
        error_set(err, "%s: out of memory", name);
    else
        result = read_bytes(descriptor, name, buffer, (size_t)status.st_size, count, err);
    close(descriptor);
    if (result == 0)
        *bytes = buffer;
    else
        free(buffer);
    return result;
}

int file_read(const char *path, size_t limit, char **bytes, size_t *count, struct error *err)
{
    int descriptor = open(path, O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0)
        return error_set(err, "%s: %s", path, strerror(errno));
    return read_descriptor(descriptor, path, limit, bytes, count, err);
}

int file_open_below(const char *folder, const char *name, struct error *err)
{
    struct stat status;
    int below = open(folder, O_PATH | O_DIRECTORY | O_CLOEXEC);
    if (below < 0)
        return error_set(err, "%s: %s", folder, strerror(errno));
    struct open_how how = {.flags = O_RDONLY | O_CLOEXEC | O_NONBLOCK,
                           .resolve =
                               RESOLVE_BENEATH | RESOLVE_NO_SYMLINKS | RESOLVE_NO_MAGICLINKS};
    int descriptor = (int)syscall(SYS_openat2, below, name, &how, sizeof how);
    int failure = errno;
    close(below);
    if (descriptor < 0)
        return error_set(err, "%s/%s: %s", folder, name, strerror(failure));
    if (fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode))
        return descriptor;
    close(descriptor);
    return error_set(err, "%s/%s: not a regular file", folder, name);
}

int file_read_below(const char *folder, const char *name, size_t limit, char **bytes, size_t *count,
                    struct error *err)
{
    int descriptor = file_open_below(folder, name, err);
    return descriptor < 0 ? -1 : read_descriptor(descriptor, name, limit, bytes, count, err);
}

int file_write(const char *path, const void *bytes, size_t count, struct error *err)
{
    char beside[PATH_MAX];
    if (snprintf(beside, sizeof beside, "%s.%d.new", path, (int)getpid()) >= (int)sizeof beside)
        return error_set(err, "%s: the path is too long", path);
    FILE *file = fopen(beside, "we");
    if (!file)
        return error_set(err, "%s: %s", beside, strerror(errno));
    bool whole = fwrite(bytes, 1, count, file) == count;
    whole = fflush(file) == 0 && whole;
    whole = fclose(file) == 0 && whole;
    if (whole && rename(beside, path) == 0)
        return 0;
    error_set(err, "%s: %s (is the disk full?)", path, strerror(errno));
    unlink(beside);
    return -1;
}

int folder_make(const char *path, struct error *err)
{
    char part[PATH_MAX];
    if (snprintf(part, sizeof part, "%s", path) >= (int)sizeof part)
        return error_set(err, "%s: the path is too long", path);
    for (char *slash = part + 1;; slash++) {
        if (*slash != '/' && *slash != '\0')
            continue;
        char kept = *slash;
        *slash = '\0';
        if (mkdir(part, 0755) != 0 && errno != EEXIST)
            return error_set(err, "%s: %s", part, strerror(errno));
        *slash = kept;
        if (kept == '\0')
            return 0;
    }
}

int folder_make_work(char *path, struct error *err)
{
    const char *base = getenv("TMPDIR");
    if (!base || base[0] != '/')
        base = "/tmp";
    if (snprintf(path, PATH_MAX - 8, "%s/meshgrade-XXXXXX", base) >= PATH_MAX - 8)
        return error_set(err, "TMPDIR: the path is too long");
    if (!mkdtemp(path)) {
        path[0] = '\0';
        return error_set(err, "%s: %s (set TMPDIR to a folder that can be written)", base,
                         strerror(errno));
    }
    strcat(path, "/work");
    if (mkdir(path, 0755) != 0)
        return error_set(err, "%s: %s", path, strerror(errno));
    return 0;
}

void folder_remove_work(char *path)
{
    char *slash = strrchr(path, '/');
    if (!slash)
        return;
    *slash = '\0';
    folder_remove(path);
    path[0] = '\0';
}

static bool is_root(const char *folder)
{
    char inside[PATH_MAX];
    return snprintf(inside, sizeof inside, "%s/graders/runner/call.h", folder) <
               (int)sizeof inside &&
           access(inside, R_OK) == 0;
}

const char *project_root(struct error *err)
{
    static char root[PATH_MAX];
    if (root[0])
        return root;
    const char *named = getenv("MESHGRADE_ROOT");
    char found[PATH_MAX];
    if (named && realpath(named, found) && is_root(found))
        return strcpy(root, found);
    ssize_t count = readlink("/proc/self/exe", found, sizeof found - 1);
    found[count > 0 ? count : 0] = '\0';
    for (char *slash = strrchr(found, '/'); slash; slash = strrchr(found, '/')) {
        *slash = '\0';
        if (is_root(found))
            return strcpy(root, found);
    }
    error_set(err, "exercises/ and graders/ are not above the program; set "
                   "MESHGRADE_ROOT to the project's folder");
    return NULL;
}
