/* Reading and writing the files of a report folder.
 *
 * Reading never follows a symbolic link at the file itself and never takes more than a limit;
 * writing is atomic (a new file is renamed over the old one) and leaves a file alone that already
 * holds the same bytes, so that making a report again touches only what changed. Nothing is synced
 * to the disk: a report can always be made anew from the results. */
#ifndef GRADERS_REPORT_DOCUMENTS_H
#define GRADERS_REPORT_DOCUMENTS_H

#include "reference/base/error.h"

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

enum { DOCUMENT_PATH_BYTES = 4096, DOCUMENT_JSON_LIMIT_BYTES = 64 << 20 };

/* The bytes of a regular file and a NUL behind them, which the caller frees; NULL on error (absent,
 * a link, not a regular file, larger than limit_bytes, unreadable). length may be NULL. */
char *document_read(const char *path, size_t limit_bytes, size_t *length, struct error *err);

/* A JSON file of at most DOCUMENT_JSON_LIMIT_BYTES, a new reference; NULL on error. Duplicate keys
 * and bytes that are not UTF-8 are errors. Strings may hold NUL: use json_string_length. */
json_t *document_read_json(const char *path, struct error *err);

/* Writes atomically, unless the file holds these bytes already. */
int document_write(const char *path, const char *bytes, size_t length, struct error *err);

/* The same for a JSON value: compact, keys in the order of insertion, ASCII only. */
int document_write_json(const char *path, const json_t *value, struct error *err);

/* Makes a folder and those above it; one that is there is no error. */
int document_make_folders(const char *path, struct error *err);

/* Joins printf style into a path of DOCUMENT_PATH_BYTES; -1 when it does not fit. */
int document_path(char *path, struct error *err, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Whether a name can stand in a path, a URL and an id unescaped: 1 to 128 letters, digits, '.', '_'
 * and '-' (ASCII), not starting with '.' or '-'. */
bool document_is_safe_name(const char *name);

/* listing_files and listing_folders (reference/base/listing.h), without the names that are not
 * safe.
 */
char **document_list(const char *folder, const char *ending, struct error *err) MUST_CHECK;
char **document_folders(const char *folder, struct error *err) MUST_CHECK;

#endif
