/* Reads a folder on disk into a bundle. Never follows a link, never leaves the folder (openat2 with
 * RESOLVE_BENEATH and RESOLVE_NO_SYMLINKS), never waits on a pipe. */
#ifndef GRADERS_ENGINE_UPLOAD_FOLDER_H
#define GRADERS_ENGINE_UPLOAD_FOLDER_H

#include "graders/engine/upload/bundle.h"

/* Reads everything below `fd`, a folder; archives in it are opened in place, under their names
 * without ending. What cannot be taken is added with its refusal, which stops nobody else: a link,
 * a device, too large; a name with a backslash or too deep a path (folder-path); what the machine
 * does not let us read (unreadable, archive-unreadable, folder-unreadable), which is a fault.
 *
 * returns  0, or -1 and *err: `fd` itself cannot be read, out of memory or descriptors, or the
 *          bundle is full */
int folder_read(int fd, struct bundle *bundle, struct error *err) MUST_CHECK;

/* Reads one regular file of at most `limit` bytes. `name` is for messages.
 *
 * bytes    malloc'ed, the caller's; NULL when refused
 * returns  0, also when refused (unreadable: a fault); -1 and *err when memory runs out */
int folder_read_file(int fd, const char *name, size_t limit, unsigned char **bytes, size_t *count,
                     struct refusal *refusal, struct error *err) MUST_CHECK;

#endif
