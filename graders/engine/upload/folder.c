/* Reading folders; see folder.h. */
#include "graders/engine/upload/folder.h"

#include "graders/engine/upload/archive.h"
#include "graders/engine/upload/upload.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/openat2.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

static const struct cause unreadable = {"unreadable", {"unreadable file", "archivo ilegible"}};
static const struct cause device_file = {"device", {"device", "dispositivo"}};
static const struct cause link_file = {"link", {"link", "enlace"}};
static const struct cause folder_unreadable = {"folder-unreadable",
                                               {"unreadable folder", "carpeta ilegible"}};
static const struct cause archive_unreadable = {
    "archive-unreadable", {"unreadable archive", "archivo comprimido ilegible"}};
static const struct cause folder_path = {"folder-path",
                                         {"path of the folder", "ruta de la carpeta"}};

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

/* What the machine does not let us read is no doing of the student. */
static void refuse_unreadable(struct refusal *refusal, const struct cause *cause, const char *shown)
{
    const char *why = strerror(errno);
    if (refuse(refusal, cause, "%s cannot be read (%s): make it readable and grade it again.",
               "No se puede leer %s (%s): hágalo legible y corríjalo de nuevo.", shown, why))
        refusal->is_fault = true;
}

int folder_read_file(int fd, const char *name, size_t limit, unsigned char **bytes, size_t *count,
                     struct refusal *refusal, struct error *err)
{
    struct stat status;
    char shown[REFUSAL_NAME];
    refusal_name(shown, name, strlen(name));
    *bytes = NULL;
    *count = 0;
    if (fstat(fd, &status)) {
        refuse_unreadable(refusal, &unreadable, shown);
        return 0;
    }
    if (!S_ISREG(status.st_mode)) {
        refuse(refusal, &device_file, "%s is not a plain file.", "%s no es un archivo normal.",
               shown);
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
            refuse_unreadable(refusal, &unreadable, shown);
            free(buffer);
            *count = 0;
            return 0;
        }
        if (got == 0)
            break;
        *count += (size_t)got;
    }
    if (*count > limit) {
        free(buffer);
        *count = 0;
        refuse(refusal, &upload_file_too_large, "%s is larger than %zu bytes.",
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
        refuse(&refusal, &upload_archive_kind, "archive: %s: pack it as .zip or .tar.gz.",
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

/* Is it the machine that fails, whatever the file? */
static bool is_short_of_everything(int error)
{
    return error == EMFILE || error == ENFILE || error == ENOMEM || error == EAGAIN;
}

/* A name that could not be opened; errno says why. */
static int take_unopened(int folder, const char *name, char path[BUNDLE_PATH_BYTES],
                         struct bundle *bundle, struct error *err)
{
    const int why = errno;
    const enum bundle_kind kind = bundle_kind(path);
    char shown[REFUSAL_NAME];
    struct refusal refusal = {0};
    struct stat status = {0};
    refusal_name(shown, name, strlen(name));
    if (why == ENOENT)
        return 0; /* removed meanwhile */
    if (is_short_of_everything(why))
        return error_set(err, "%s: %s", shown, strerror(why));
    bool is_folder =
        fstatat(folder, name, &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISDIR(status.st_mode);
    errno = why;
    if (why == ELOOP || why == ENXIO || why == EXDEV)
        refuse(&refusal, why == ENXIO ? &device_file : &link_file, "%s is a link or a device.",
               "%s es un enlace o un dispositivo.", shown);
    else if (is_folder)
        refuse_unreadable(&refusal, &folder_unreadable, shown);
    else if (kind == BUNDLE_ARCHIVE)
        refuse_unreadable(&refusal, &archive_unreadable, shown);
    else if (kind != BUNDLE_OTHER)
        refuse_unreadable(&refusal, &unreadable, shown);
    if (kind == BUNDLE_ARCHIVE && !is_folder)
        path[bundle_archive_stem(path)] = '\0';
    return bundle_add(bundle, path, NULL, 0, &refusal, err);
}

/* A name that makes no path: refused under a name that does, or with the folder that it lies in. */
static int refuse_name(const char *prefix, const char *name, struct bundle *bundle,
                       struct error *err)
{
    char path[BUNDLE_PATH_BYTES], plain[BUNDLE_NAME_BYTES + 1], shown[REFUSAL_NAME];
    struct refusal refusal = {0};
    snprintf(plain, sizeof plain, "%s", name);
    for (char *c = plain; *c; c++)
        if (*c == '\\')
            *c = '_';
    if (bundle_join(path, prefix, plain))
        snprintf(path, sizeof path, "%s", prefix);
    refuse(&refusal, &folder_path, "%s: its path is too long or deep, or has a backslash.",
           "%s: su ruta es demasiado larga o profunda, o tiene una barra invertida.",
           refusal_name(shown, name, strlen(name)));
    return bundle_add(bundle, path, NULL, 0, &refusal, err);
}

static int take_folder(int fd, const char *path, int depth, struct bundle *bundle,
                       struct error *err)
{
    char shown[REFUSAL_NAME];
    struct refusal refusal = {0};
    int copy = openat(fd, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (copy >= 0 || is_short_of_everything(errno))
        return read_level(copy, path, depth, bundle, err);
    refuse_unreadable(&refusal, &folder_unreadable, refusal_name(shown, path, strlen(path)));
    return bundle_add(bundle, path, NULL, 0, &refusal, err);
}

/* One name of a folder. */
static int take_name(int folder, const char *prefix, const char *name, int depth,
                     struct bundle *bundle, struct error *err)
{
    char path[BUNDLE_PATH_BYTES], shown[REFUSAL_NAME];
    struct stat status;
    if (bundle_kind(name) == BUNDLE_JUNK)
        return 0;
    if (strchr(name, '\\') || depth > BUNDLE_DEPTH || bundle_join(path, prefix, name))
        return refuse_name(prefix, name, bundle, err);
    int fd = open_step(folder, name);
    if (fd < 0)
        return take_unopened(folder, name, path, bundle, err);
    refusal_name(shown, name, strlen(name));
    int result = fstat(fd, &status)        ? error_set(err, "%s: %s", shown, strerror(errno))
                 : S_ISDIR(status.st_mode) ? take_folder(fd, path, depth + 1, bundle, err)
                                           : take_file(fd, path, bundle, err);
    close(fd);
    return result;
}

/* Reads the opened folder `fd`, which is `prefix` in the bundle, and closes it. -1: could not be
 * opened, errno says why. */
static int read_level(int fd, const char *prefix, int depth, struct bundle *bundle,
                      struct error *err)
{
    DIR *folder = fd < 0 ? NULL : fdopendir(fd);
    if (!folder) {
        error_set(err, "%s: %s", prefix[0] ? prefix : "the folder", strerror(errno));
        if (fd >= 0)
            close(fd);
        return -1;
    }
    int result = 0;
    for (;;) {
        errno = 0; /* only so can the end be told from an error, which would lose students */
        const struct dirent *entry = result == 0 ? readdir(folder) : NULL;
        if (!entry)
            break;
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0)
            result = take_name(dirfd(folder), prefix, entry->d_name, depth, bundle, err);
    }
    if (result == 0 && errno != 0)
        result = error_set(err, "%s cannot be read to its end: %s",
                           prefix[0] ? prefix : "the folder", strerror(errno));
    closedir(folder);
    return result;
}

int folder_read(int fd, struct bundle *bundle, struct error *err)
{
    return read_level(openat(fd, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC), "", 1, bundle, err);
}
