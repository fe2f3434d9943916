/* A bundle: the files found below one path that an instructor gave, in memory, whether they lay in
 * a folder, in an archive, or in archives inside either. Knows nothing of students and exercises.
 */
#ifndef GRADERS_ENGINE_UPLOAD_BUNDLE_H
#define GRADERS_ENGINE_UPLOAD_BUNDLE_H

#include "graders/engine/base/refusal.h"
#include "reference/base/error.h"

#include <stdint.h>

enum {
    BUNDLE_PATH_BYTES = 1024, /* longest path inside a bundle, with its zero */
    BUNDLE_NAME_BYTES = 255,  /* longest step of a path */
    BUNDLE_DEPTH = 16,        /* most steps */
    BUNDLE_ENTRIES = 100000,  /* most files */
    BUNDLE_BYTES = 256 << 20  /* most bytes kept in memory */
};

enum bundle_kind {
    BUNDLE_SOURCE,        /* .c, .h: kept */
    BUNDLE_METADATA,      /* submission_metadata.yml: kept */
    BUNDLE_ARCHIVE,       /* .zip, .tar, ...: opened */
    BUNDLE_OTHER_ARCHIVE, /* .rar, .7z: refused with advice */
    BUNDLE_JUNK,          /* what systems leave behind: __MACOSX, .DS_Store, .git; not even noted */
    BUNDLE_OTHER          /* its name is kept */
};

/* Causes that several readers of uploads find. */
extern const struct cause upload_archive_broken, upload_archive_kind, upload_file_too_large,
    upload_file_twice, upload_no_source;

struct bundle_file {
    char *path; /* steps with / between; no . or .. step; bytes as found, maybe not UTF-8 */
    unsigned char *bytes; /* NULL when refused or of no use */
    size_t count;
    struct refusal refusal; /* of this file or, when an archive could not be read, of all below */
};

struct bundle {
    struct bundle_file *files;
    int count, capacity;
    int64_t bytes;
    char *shed; /* the folder that was let go last, or NULL: nothing below it is taken */
};

/* What kind a file is, by the names in its path. Letter case does not matter. */
enum bundle_kind bundle_kind(const char *path);

/* Length of `path` without the ending that makes it an archive. */
size_t bundle_archive_stem(const char *path);

/* Joins `prefix` ("" or a path inside the bundle) and a name from outside, which may hold several
 * steps and backslashes. Moodle's flat names "Ana_12_assignsubmission_file_x.c" get a / after the
 * underscore, as its folders have.
 *
 * returns  0; -1 when the path is absolute, has a .. step, is empty, or is too long or deep */
int bundle_join(char out[BUNDLE_PATH_BYTES], const char *prefix, const char *name) MUST_CHECK;

/* Adds one file. Takes `bytes` over, also when it fails. When the bundle is full, the heaviest
 * folder in it is let go, so that one student's flood costs nobody else anything: its files are
 * removed, a refusal (folder-too-large) stands in their place, and what else comes from it is
 * dropped.
 *
 * returns  0, or -1 and *err: out of memory, or full without any folder that stands out */
int bundle_add(struct bundle *bundle, const char *path, unsigned char *bytes, size_t count,
               const struct refusal *refusal, struct error *err) MUST_CHECK;

/* Does the file's refusal stand for all that its student handed in (archive-..., folder-...)? */
bool bundle_refuses_all(const struct bundle_file *file);

/* Does it stand for the part of a class's archive that could not be read (archive-unread)? */
bool bundle_is_rest(const struct bundle_file *file);

/* Sorts by path, step by step: the order of folders and archives does not matter, and what lies in
 * one folder stands together, after the folder's own refusal if it has one. */
void bundle_sort(struct bundle *bundle);

void bundle_release(struct bundle *bundle);

#endif
