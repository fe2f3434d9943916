/* Reading and writing the files of a report folder; see documents.h. */
#include "graders/report/documents.h"

#include "reference/base/listing.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char *read_open_file(int fd, const char *path, size_t limit_bytes, size_t *length,
                            struct error *err)
{
    struct stat status;
    if (fstat(fd, &status) != 0 || !S_ISREG(status.st_mode)) {
        error_set(err, "%s is not a regular file", path);
        return NULL;
    }
    if (status.st_size < 0 || (size_t)status.st_size > limit_bytes) {
        error_set(err, "%s has %lld bytes, more than the %zu that are read", path,
                  (long long)status.st_size, limit_bytes);
        return NULL;
    }
    size_t size = (size_t)status.st_size;
    char *bytes = malloc(size + 1);
    if (!bytes) {
        error_set(err, "%s: out of memory for %zu bytes", path, size);
        return NULL;
    }
    size_t used = 0;
    while (used < size) {
        ssize_t got = read(fd, bytes + used, size - used);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            break;
        used += (size_t)got;
    }
    if (used < size) {
        error_set(err, "%s: cannot be read to its end: %s", path, strerror(errno));
        free(bytes);
        return NULL;
    }
    bytes[used] = '\0';
    if (length)
        *length = used;
    return bytes;
}

char *document_read(const char *path, size_t limit_bytes, size_t *length, struct error *err)
{
    int fd = open(path, O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY);
    if (fd < 0) {
        error_set(err, "%s: %s", path, errno == ELOOP ? "is a symbolic link" : strerror(errno));
        return NULL;
    }
    char *bytes = read_open_file(fd, path, limit_bytes, length, err);
    close(fd);
    return bytes;
}

json_t *document_read_json(const char *path, struct error *err)
{
    size_t length = 0;
    char *bytes = document_read(path, DOCUMENT_JSON_LIMIT_BYTES, &length, err);
    if (!bytes)
        return NULL;
    json_error_t at;
    json_t *value = json_loadb(bytes, length, JSON_REJECT_DUPLICATES | JSON_ALLOW_NUL, &at);
    if (!value)
        error_set(err, "%s:%d:%d: %s", path, at.line, at.column, at.text);
    free(bytes);
    return value;
}

static bool holds_already(const char *path, const char *bytes, size_t length)
{
    struct error ignored = {""};
    size_t old_length = 0;
    char *old = document_read(path, length, &old_length, &ignored);
    bool same = old && old_length == length && memcmp(old, bytes, length) == 0;
    free(old);
    return same;
}

static int write_all(int fd, const char *bytes, size_t length)
{
    while (length > 0) {
        ssize_t wrote = write(fd, bytes, length);
        if (wrote < 0 && errno == EINTR)
            continue;
        if (wrote < 0)
            return -1;
        bytes += wrote;
        length -= (size_t)wrote;
    }
    return 0;
}

int document_write(const char *path, const char *bytes, size_t length, struct error *err)
{
    if (holds_already(path, bytes, length))
        return 0;
    char fresh[DOCUMENT_PATH_BYTES];
    if (document_path(fresh, err, "%s.XXXXXX", path) != 0)
        return -1;
    int fd = mkostemp(fresh, O_CLOEXEC);
    if (fd < 0)
        return error_set(err, "%s cannot be written: %s", path, strerror(errno));
    bool wrote = write_all(fd, bytes, length) == 0 && fchmod(fd, 0644) == 0;
    wrote = close(fd) == 0 && wrote;
    if (!wrote || rename(fresh, path) != 0) {
        int why = errno;
        unlink(fresh);
        return error_set(err, "%s cannot be written: %s", path, strerror(why));
    }
    return 0;
}

int document_write_json(const char *path, const json_t *value, struct error *err)
{
    char *text = json_dumps(value, JSON_COMPACT | JSON_ENSURE_ASCII | JSON_REAL_PRECISION(15));
    if (!text)
        return error_set(err, "%s: out of memory for its JSON", path);
    int status = document_write(path, text, strlen(text), err);
    free(text);
    return status;
}

int document_make_folders(const char *path, struct error *err)
{
    char part[DOCUMENT_PATH_BYTES];
    if (document_path(part, err, "%s", path) != 0)
        return -1;
    for (char *slash = part + 1;; slash++) {
        if (*slash != '/' && *slash != '\0')
            continue;
        char old = *slash;
        *slash = '\0';
        if (mkdir(part, 0777) != 0 && errno != EEXIST)
            return error_set(err, "folder %s cannot be made: %s", part, strerror(errno));
        *slash = old;
        if (old == '\0')
            return 0;
    }
}

int document_path(char *path, struct error *err, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(path, DOCUMENT_PATH_BYTES, format, arguments);
    va_end(arguments);
    if (length < 0 || length >= DOCUMENT_PATH_BYTES)
        return error_set(err, "a path is longer than %d bytes: %.200s...", DOCUMENT_PATH_BYTES,
                         path);
    return 0;
}

bool document_is_safe_name(const char *name)
{
    static const char allowed[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-";
    size_t length = strlen(name);
    return length >= 1 && length <= 128 && name[0] != '.' && name[0] != '-' &&
           strspn(name, allowed) == length;
}

/* Drops the names that are not safe. */
static char **keep_safe(char **names)
{
    size_t kept = 0;
    for (size_t i = 0; names && names[i]; i++)
        if (document_is_safe_name(names[i]))
            names[kept++] = names[i];
    if (names)
        names[kept] = NULL;
    return names;
}

char **document_list(const char *folder, const char *ending, struct error *err)
{
    return keep_safe(listing_files(folder, ending, err));
}

char **document_folders(const char *folder, struct error *err)
{
    return keep_safe(listing_folders(folder, err));
}
