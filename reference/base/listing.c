/* Names in a folder; see listing.h. */
#include "reference/base/listing.h"

#include <dirent.h>
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

struct wanted {
    bool folders; /* or else all that is none: a pipe in a file's place is refused by its reader */
    const char *ending;
};

static bool ends_in(const char *name, const char *ending)
{
    size_t length = strlen(name);
    size_t tail = strlen(ending);
    return length > tail && strcmp(name + length - tail, ending) == 0;
}

static bool is_wanted(int folder, const char *name, const struct wanted *wanted)
{
    struct stat status;
    if (name[0] == '.' || !ends_in(name, wanted->ending))
        return false;
    bool is_folder = fstatat(folder, name, &status, 0) == 0 && S_ISDIR(status.st_mode);
    return is_folder == wanted->folders;
}

/* Writes the wanted names to `text`, each with its zero byte. Returns how many, or -1 and errno. */
static ssize_t write_names(DIR *entries, const struct wanted *wanted, FILE *text)
{
    ssize_t count = 0;
    for (;;) {
        errno = 0; /* only so can the end be told from an error */
        const struct dirent *entry = readdir(entries);
        if (!entry)
            return errno ? -1 : count;
        if (!is_wanted(dirfd(entries), entry->d_name, wanted))
            continue;
        fwrite(entry->d_name, 1, strlen(entry->d_name) + 1, text);
        count++;
    }
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

/* Puts `count` names that stand one behind the other in `text` into one array with its own copy. */
static char **as_array(const char *text, size_t bytes, size_t count)
{
    char **names = malloc((count + 1) * sizeof *names + bytes + 1);
    if (!names)
        return NULL;
    char *copy = (char *)(names + count + 1);
    memcpy(copy, text, bytes);
    for (size_t i = 0; i < count; i++) {
        names[i] = copy;
        copy += strlen(copy) + 1;
    }
    names[count] = NULL;
    qsort(names, count, sizeof *names, by_name);
    return names;
}

static char **list(const char *folder, const struct wanted *wanted, struct error *err)
{
    DIR *entries = opendir(folder);
    if (!entries && errno != ENOENT) {
        error_set(err, "%s cannot be listed: %s", folder, strerror(errno));
        return NULL;
    }
    char *text = NULL, **names = NULL;
    size_t bytes = 0;
    FILE *found = open_memstream(&text, &bytes);
    ssize_t count = found && entries ? write_names(entries, wanted, found) : 0;
    if (count < 0)
        error_set(err, "%s cannot be listed to its end: %s", folder, strerror(errno));
    bool complete = found && !ferror(found);
    complete = found && fclose(found) == 0 && complete;
    if (complete && count >= 0)
        names = as_array(text, bytes, (size_t)count);
    if (!names)
        error_set(err, "%s: out of memory for its list", folder);
    if (entries)
        closedir(entries);
    free(text);
    return names;
}

char **listing_folders(const char *folder, struct error *err)
{
    return list(folder, &(struct wanted){true, ""}, err);
}

char **listing_files(const char *folder, const char *ending, struct error *err)
{
    return list(folder, &(struct wanted){false, ending}, err);
}
