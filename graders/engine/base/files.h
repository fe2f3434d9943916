/* Files and folders of the engine's own: bounded reads, whole writes. */
#ifndef GRADERS_ENGINE_BASE_FILES_H
#define GRADERS_ENGINE_BASE_FILES_H

#include "reference/base/error.h"

#include <stddef.h>

/* Joins printf style into a path of PATH_MAX bytes. Returns 0, or -1 and *err when it does not fit:
 * a path that was cut would be another file's. */
int file_path(char *path, struct error *err, const char *format, ...)
    __attribute__((format(printf, 3, 4))) MUST_CHECK;

/* Reads a regular file whole, without following a link in its last part.
 *
 * bytes    on success the caller frees it; a zero byte stands after the last one
 * limit    more bytes than this are an error
 * returns  0, or -1 and *err */
int file_read(const char *path, size_t limit, char **bytes, size_t *count,
              struct error *err) MUST_CHECK;

/* Opens for reading what hostile code may have made: `name` is found below `folder` without leaving
 * it and without following any link, and must be a regular file. Never waits.
 *
 * returns  a descriptor, the caller's; -1 and *err */
int file_open_below(const char *folder, const char *name, struct error *err) MUST_CHECK;

/* As file_read, for a file that hostile code may have made; opened as by file_open_below. */
int file_read_below(const char *folder, const char *name, size_t limit, char **bytes, size_t *count,
                    struct error *err) MUST_CHECK;

/* Writes a file whole: into a new file beside it, which then takes its name. */
int file_write(const char *path, const void *bytes, size_t count, struct error *err) MUST_CHECK;

/* Makes a folder and those above it; fine when they are there. */
int folder_make(const char *path, struct error *err) MUST_CHECK;

/* Removes a folder and all below it, however deep; links are removed, not followed. */
void folder_remove(const char *path);

/* Makes a fresh folder "work" inside a private one (mode 0700) below $TMPDIR or /tmp: a box may be
 * given the inner one, and no other user reaches it.
 *
 * path     PATH_MAX bytes; the inner folder's absolute name */
int folder_make_work(char *path, struct error *err) MUST_CHECK;

/* Removes both, and empties `path`. The empty path is left alone. */
void folder_remove_work(char *path);

/* The project's folder, where exercises/ and graders/ stand: found above the running program, or
 * named by MESHGRADE_ROOT. Returns NULL and *err when there is none. The text lives for ever. */
const char *project_root(struct error *err) MUST_CHECK;

#endif
