/* The names in a folder.
 *
 * A path is never a pattern: a folder may be called "marks [2026]", and glob() would look into
 * other folders for it. So nothing in this project calls glob(); this is what takes its place. */
#ifndef REFERENCE_BASE_LISTING_H
#define REFERENCE_BASE_LISTING_H

#include "reference/base/error.h"

/* The names of the folders, or of all else whose names end in `ending`, that lie in `folder`. Links
 * count as what they lead to; a pipe, a device or a link to nothing is listed as a file, so that
 * who reads it can refuse it by name. Names that begin with a dot are left out.
 *
 *     char **names = listing_files("marks [2026]/results/ana", ".json", &err);
 *     for (size_t i = 0; names && names[i]; i++)
 *         ...
 *     free(names);
 *
 * ending   "" for any file; a name must be longer than it
 * returns  the names, sorted as by strcmp and ended by NULL, in one piece of memory that the caller
 *          frees; none when the folder is absent. NULL and *err when it cannot be read */
char **listing_folders(const char *folder, struct error *err) MUST_CHECK;
char **listing_files(const char *folder, const char *ending, struct error *err) MUST_CHECK;

#endif
