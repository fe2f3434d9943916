/* Names of students, as uploads and platforms write them. */
#ifndef GRADERS_ENGINE_UPLOAD_NAMES_H
#define GRADERS_ENGINE_UPLOAD_NAMES_H

#include <stdbool.h>
#include <stddef.h>

enum { NAMES_SLUG = 64 };

/* A copy in valid UTF-8: bytes that are not become U+FFFD. NULL when memory runs out. */
char *names_utf8(const char *bytes, size_t count);

/* The name as a safe file name: [A-Za-z0-9._-], not beginning with . or -, accents dropped, at most
 * NAMES_SLUG - 1 long, "student" when nothing is left. `name` is valid UTF-8. */
void names_slug(char out[NAMES_SLUG], const char *name);

/* Is this folder one of Moodle's, "Ana Pérez_12345_assignsubmission_file_"?
 * Returns the length of the name in front, or 0. */
size_t names_moodle(const char *folder, size_t count);

/* The submitters of a folder "submission_123" in Gradescope's submission_metadata.yml, joined by
 * commas; the folder's name when they are not found.
 *
 * metadata  `bytes` of it; may be anything
 * returns   malloc'ed, valid UTF-8; NULL when memory runs out */
char *names_gradescope(const char *metadata, size_t bytes, const char *folder, size_t count);

/* Is `stem` the exercise's name, without regard to case and with _ for -? */
bool names_match(const char *exercise, const char *stem, size_t count);

#endif
