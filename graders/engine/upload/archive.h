/* Reads archives (.zip, .tar, .tar.gz, .tar.xz, .tar.bz2) into a bundle, and archives inside them.
 * Hostile archives are refused, never followed: links, devices, absolute and .. paths, encryption,
 * too many entries, too large, too strongly compressed, too deeply nested. Nothing is written. */
#ifndef GRADERS_ENGINE_UPLOAD_ARCHIVE_H
#define GRADERS_ENGINE_UPLOAD_ARCHIVE_H

#include "graders/engine/upload/bundle.h"

enum {
    ARCHIVE_NESTING = 2,                 /* an archive in an archive, no deeper */
    ARCHIVE_NESTED_BYTES = 32 << 20,     /* largest archive inside another */
    ARCHIVE_RATIO = 200,                 /* unpacked to packed, beyond ... */
    ARCHIVE_RATIO_FREE_BYTES = 16 << 20, /* ... so much unpacked */
    ARCHIVE_UNPACKED_BYTES = 1 << 30,    /* sum of all entries' sizes */
    ARCHIVE_NESTED_ENTRIES = 2000,       /* entries of an archive inside another */
    ARCHIVE_CLASS_ENTRIES = 1000000      /* entries of an archive of a whole class */
};

/* What may have to be unpacked of an archive of a whole class, in bytes. */
static const int64_t ARCHIVE_CLASS_BYTES = 4LL << 30;

/* Reads an archive. Entries go to `bundle` below `prefix` ("" or a path). An entry that cannot be
 * taken is added with its refusal; when the archive as a whole cannot, a file `prefix` is added
 * with the refusal.
 *
 * With the prefix "" it may be the archive of a whole class, and what one student packed must not
 * cost the others their marks: a path, size or compression that is refused then refuses the folder
 * or file that it is of, and reading goes on. Where it cannot, as the archive is damaged or its
 * limits are reached, all that was read before stays, and a file "" with the cause archive-unread
 * tells that there is more.
 *
 * fd       descriptor of the archive, read from its beginning; stays open
 * returns  0, also when refused; -1 and *err: out of memory, or the bundle is full */
int archive_read_fd(int fd, const char *prefix, struct bundle *bundle,
                    struct error *err) MUST_CHECK;

/* The same from memory, as found inside `nesting` other archives. */
int archive_read_bytes(const void *bytes, size_t count, int nesting, const char *prefix,
                       struct bundle *bundle, struct error *err) MUST_CHECK;

#endif
