/* Reading folders; see folder.h. */
#include "graders/engine/folder.h"

#include "graders/engine/archive.h"
#include "graders/engine/upload.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/openat2.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

/* Opens a name in a folder for reading, without following links. On kernels before 5.6, which lack
 * openat2, O_NOFOLLOW is as good, since `name` is a single step. */
static int open_step(int folder, const char *name)
{
    const int flags = O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
    struct open_how how = {.flags = (unsigned)flags,
                           .resolve =
                               RESOLVE_BENEATH | RESOLVE_NO_SYMLINKS | RESOLVE_NO_MAGICLINKS};
    int fd = (int)syscall(SYS_openat2, folder, name, &how, sizeof how);
    return fd < 0 && (errno == ENOSYS || errno == EPERM) ? openat(folder, name, flags) : fd;
}

int folder_read_file(int fd, const char *name, size_t limit, unsigned char **bytes, size_t *count,
                     struct refusal *refusal, struct error *err)
{
    struct stat status;
    char shown[REFUSAL_NAME];
    refusal_name(shown, name, strlen(name));
    *bytes = NULL;
    *count = 0;
    if (fstat(fd, &status))
        return error_set(err, "%s: %s", shown, strerror(errno));
    if (!S_ISREG(status.st_mode)) {
        refuse(refusal, "device", "%s is not a plain file.", "%s no es un archivo normal.", shown);
        return 0;
    }
    unsigned char *buffer = malloc(limit + 1);
    if (!buffer)
        return error_set(err, "%s: out of memory", shown);
    while (*count <= limit) {
        ssize_t got = read(fd, buffer + *count, limit + 1 - *count);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0) {
            free(buffer);
            return error_set(err, "%s: %s", shown, strerror(errno));
        }
        if (got == 0)
            break;
        *count += (size_t)got;
    }
    if (*count > limit) {
        free(buffer);
        *count = 0;
        refuse(refusal, "file-too-large", "%s is larger than %zu bytes.",
               "%s ocupa más de %zu bytes.", shown, limit);
        return 0;
    }
    unsigned char *fitting = realloc(buffer, *count ? *count : 1);
    *bytes = fitting ? fitting : buffer;
    return 0;
}

static int take_archive(int fd, const char *path, struct bundle *bundle, struct error *err)
{
    char prefix[BUNDLE_PATH_BYTES];
    size_t stem = bundle_archive_stem(path);
    memcpy(prefix, path, stem);
    prefix[stem] = '\0';
    return archive_read_fd(fd, prefix, bundle, err);
}

static int take_file(int fd, const char *path, struct bundle *bundle, struct error *err)
{
    struct refusal refusal = {0};
    unsigned char *bytes = NULL;
    size_t count = 0;
    switch (bundle_kind(path)) {
    case BUNDLE_JUNK:
        return 0;
    case BUNDLE_ARCHIVE:
        return take_archive(fd, path, bundle, err);
    case BUNDLE_OTHER_ARCHIVE:
        refuse(&refusal, "archive-kind", "archive: %s: pack it as .zip or .tar.gz.",
               "archivo comprimido: %s: comprímalo como .zip o .tar.gz.",
               strrchr(path, '/') ? strrchr(path, '/') + 1 : path);
        break;
    case BUNDLE_SOURCE:
    case BUNDLE_METADATA:
        if (folder_read_file(fd, path, UPLOAD_FILE_BYTES, &bytes, &count, &refusal, err))
            return -1;
        break;
    case BUNDLE_OTHER:
        break;
    }
    return bundle_add(bundle, path, bytes, count, &refusal, err);
}

static int read_level(int fd, const char *prefix, int depth, struct bundle *bundle,
                      struct error *err);

/* One name of a folder. */
static int take_name(int folder, const char *prefix, const char *name, int depth,
                     struct bundle *bundle, struct error *err)
{
    char path[BUNDLE_PATH_BYTES], shown[REFUSAL_NAME];
    struct refusal refusal = {0};
    struct stat status;
    refusal_name(shown, name, strlen(name));
    if (strchr(name, '\\') || depth > BUNDLE_DEPTH || bundle_join(path, prefix, name))
        return error_set(err, "%s: its path is too long or deep, or has a backslash", shown);
    if (bundle_kind(path) == BUNDLE_JUNK)
        return 0;
    int fd = open_step(folder, name);
    if (fd < 0 && errno == ENOENT)
        return 0; /* removed meanwhile */
    if (fd < 0 && errno != ELOOP && errno != ENXIO && errno != EXDEV)
        return error_set(err, "%s: %s", shown, strerror(errno));
    if (fd < 0) {
        refuse(&refusal, errno == ENXIO ? "device" : "link", "%s is a link or a device.",
               "%s es un enlace o un dispositivo.", shown);
        return bundle_add(bundle, path, NULL, 0, &refusal, err);
    }
    int result = fstat(fd, &status)        ? error_set(err, "%s: %s", shown, strerror(errno))
                 : S_ISDIR(status.st_mode) ? read_level(fd, path, depth + 1, bundle, err)
                                           : take_file(fd, path, bundle, err);
    close(fd);
    return result;
}

/* Reads the folder `fd`, which is `prefix` in the bundle. */
static int read_level(int fd, const char *prefix, int depth, struct bundle *bundle,
                      struct error *err)
{
    int copy = openat(fd, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *folder = copy < 0 ? NULL : fdopendir(copy);
    if (!folder) {
        if (copy >= 0)
            close(copy);
        return error_set(err, "%s: %s", prefix[0] ? prefix : "the folder", strerror(errno));
    }
    int result = 0;
    errno = 0;
    for (struct dirent *entry; result == 0 && (entry = readdir(folder));)
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0)
            result = take_name(fd, prefix, entry->d_name, depth, bundle, err);
    closedir(folder);
    return result;
}

int folder_read(int fd, struct bundle *bundle, struct error *err)
{
    return read_level(fd, "", 1, bundle, err);
}
