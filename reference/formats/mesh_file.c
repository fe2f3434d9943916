/* Meshes in files; see mesh_file.h. */
#include "reference/formats/mesh_file.h"

#include "reference/formats/huge_pages.h"
#include "reference/formats/obj.h"
#include "reference/formats/off.h"
#include "reference/formats/ply.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

static int write_binary_ply(FILE *out, const struct mesh *mesh, struct error *err)
{
    return ply_write(out, mesh, PLY_LITTLE_ENDIAN, err);
}

struct format {
    const char *extension;
    int (*read)(const void *bytes, size_t byte_count, const char *name, struct mesh *mesh,
                struct reading *reading, struct error *err);
    int (*write)(FILE *out, const struct mesh *mesh, struct error *err);
};

enum { FORMAT_PLY, FORMAT_OBJ, FORMAT_OFF, FORMAT_COUNT };

static const struct format formats[FORMAT_COUNT] = {
    [FORMAT_PLY] = {".ply", ply_read, write_binary_ply},
    [FORMAT_OBJ] = {".obj", obj_read, obj_write},
    [FORMAT_OFF] = {".off", off_read, off_write},
};

static const off_t most_bytes = INT64_C(8) << 30;

/* The format of a path's extension; NULL and *err when there is none. */
static const struct format *find_format(const char *path, struct error *err)
{
    const char *extension = strrchr(path, '.');
    for (size_t i = 0; extension && i < FORMAT_COUNT; i++)
        if (strcasecmp(extension, formats[i].extension) == 0)
            return &formats[i];
    error_set(err, "%s: the name of a mesh ends with .ply, .obj or .off", path);
    return NULL;
}

static int check_regular(int file, const char *path, size_t *byte_count, struct error *err)
{
    struct stat status;
    if (fstat(file, &status))
        return error_set(err, "%s: %s", path, strerror(errno));
    if (!S_ISREG(status.st_mode))
        return error_set(err, "%s is not a regular file", path);
    if (status.st_size > most_bytes)
        return error_set(err, "%s has %lld bytes: at most 8 GiB are read", path,
                         (long long)status.st_size);
    *byte_count = (size_t)status.st_size;
    return 0;
}

/* The whole file in memory, which the caller frees; NULL and *err on failure. */
static char *load(const char *path, size_t *byte_count, struct error *err)
{
    /* Without waiting, so that a pipe with no writer does not hold us up before it is refused. */
    int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0) {
        error_set(err, "%s: %s", path, strerror(errno));
        return NULL;
    }
    char *bytes = NULL;
    size_t size = 0, count = 0;
    if (check_regular(file, path, &size, err) == 0) {
        bytes = malloc(size + 1);
        if (!bytes)
            error_set(err, "%s: out of memory for its %zu bytes", path, size);
        else
            huge_pages_prefer(bytes, size);
    }
    ssize_t got = 1;
    while (bytes && count < size && got > 0) {
        got = read(file, bytes + count, size - count);
        if (got > 0)
            count += (size_t)got;
    }
    if (bytes && got < 0) {
        error_set(err, "%s: %s", path, strerror(errno));
        free(bytes);
        bytes = NULL;
    }
    close(file);
    *byte_count = count;
    return bytes;
}

int mesh_file_read_told(const char *path, struct mesh *mesh, struct reading *reading,
                        struct error *err)
{
    *mesh = (struct mesh){0};
    const struct format *format = find_format(path, err);
    size_t byte_count;
    char *bytes = format ? load(path, &byte_count, err) : NULL;
    if (!bytes)
        return -1;
    int result = format->read(bytes, byte_count, path, mesh, reading, err);
    free(bytes);
    return result;
}

int mesh_file_read(const char *path, struct mesh *mesh, struct error *err)
{
    return mesh_file_read_told(path, mesh, NULL, err);
}

/* -- streams ---------------------------------------------------------------------------------- */

/* All that comes, which the caller frees; NULL and *err on failure. */
static char *load_stream(FILE *in, const char *name, size_t *byte_count, struct error *err)
{
    size_t capacity = 1 << 16, count = 0, got = 1;
    char *bytes = malloc(capacity);
    while (bytes && got > 0 && count <= (size_t)most_bytes) {
        if (count == capacity) {
            void *grown = realloc(bytes, capacity *= 2);
            if (!grown)
                free(bytes);
            bytes = grown;
        }
        got = bytes ? fread(bytes + count, 1, capacity - count, in) : 0;
        count += got;
    }
    *byte_count = count;
    if (bytes && !ferror(in) && count <= (size_t)most_bytes)
        return bytes;
    error_set(err, "%s: %s", name,
              !bytes       ? "out of memory"
              : ferror(in) ? strerror(errno)
                           : "at most 8 GiB are read");
    free(bytes);
    return NULL;
}

/* The format that the first word speaks of: ply; digits or a word in OFF; else OBJ. */
static const struct format *guess_format(const char *bytes, size_t count)
{
    static const char blanks[] = " \t\r\n";
    size_t at = count >= 3 && memcmp(bytes, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    /* Comments stand before the first word in OFF and OBJ. */
    while (at < count && (bytes[at] == '#' || memchr(blanks, bytes[at], sizeof blanks - 1))) {
        const char *end = bytes[at] == '#' ? memchr(bytes + at, '\n', count - at) : bytes + at;
        at = end ? (size_t)(end - bytes) + 1 : count;
    }
    char word[16] = "";
    for (size_t i = 0; i + 1 < sizeof word && at + i < count && bytes[at + i] > ' '; i++)
        word[i] = bytes[at + i];
    if (strcmp(word, "ply") == 0)
        return &formats[FORMAT_PLY];
    bool is_off = strcasestr(word, "OFF") != NULL || (word[0] >= '0' && word[0] <= '9');
    return &formats[is_off ? FORMAT_OFF : FORMAT_OBJ];
}

int mesh_file_read_stream(FILE *in, const char *name, struct mesh *mesh, struct reading *reading,
                          struct error *err)
{
    *mesh = (struct mesh){0};
    size_t byte_count;
    char *bytes = load_stream(in, name, &byte_count, err);
    if (!bytes)
        return -1;
    int result = guess_format(bytes, byte_count)->read(bytes, byte_count, name, mesh, reading, err);
    free(bytes);
    return result;
}

int mesh_file_write(const char *path, const struct mesh *mesh, struct error *err)
{
    const struct format *format = find_format(path, err);
    if (!format)
        return -1;
    FILE *out = fopen(path, "we");
    if (!out)
        return error_set(err, "%s: %s", path, strerror(errno));
    struct error cause = {0};
    int result = format->write(out, mesh, &cause);
    if (fclose(out) && result == 0)
        result = error_set(&cause, "%s", strerror(errno));
    return result ? error_set(err, "%s: %s", path, cause.text) : 0;
}
