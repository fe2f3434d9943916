/* Reads submissions whose verdict is known; see submissions.h. */
#include "graders/known/submissions.h"

#include "graders/engine/base/files.h"
#include "graders/known/change.h"
#include "reference/base/listing.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SOURCE_BYTES = 1 << 20, SUBMISSIONS_MAX = 1000 };

static const char *const kinds[] = {"crash", "greedy", "hostile", "leak",
                                    "poor",  "right",  "slow",    "wrong"};

/* Where an exercise's files stand. */
struct place {
    const char *root, *group, *exercise;
    char folder[PATH_MAX];
};

static bool ends_in(const char *name, const char *ending)
{
    size_t length = strlen(name), tail = strlen(ending);
    return length > tail && strcmp(name + length - tail, ending) == 0;
}

/* ------------------------------------------------------------------- texts */

static int join(char *path, const char *folder, const char *name, struct error *err)
{
    if (snprintf(path, PATH_MAX, "%s/%s", folder, name) >= PATH_MAX)
        return error_set(err, "%s/%s: the path is too long", folder, name);
    return 0;
}

static int find_reference(const struct place *place, char *path, struct error *err)
{
    if (snprintf(path, PATH_MAX, "%s/reference/answers/%s/%s.c", place->root, place->group,
                 place->exercise) >= PATH_MAX)
        return error_set(err, "%s: the path is too long", place->root);
    return 0;
}

/* Reads a change and its base, and makes the whole text of them. */
static int expand(const struct place *place, struct known_submission *submission, struct error *err)
{
    char base_name[CHANGE_BASE_BYTES], path[PATH_MAX], *bytes, *whole = NULL;
    size_t count, whole_count;
    struct change_text change = {submission->stored, submission->text, submission->count};
    if (change_find_base(&change, base_name, err) != 0)
        return -1;
    int result = strcmp(base_name, "reference") == 0 ? find_reference(place, path, err)
                                                     : join(path, place->folder, base_name, err);
    if (result == 0 && access(path, R_OK) != 0)
        result = error_set(err, "%s: of: %s: there is no such whole file of %s", submission->stored,
                           base_name, place->exercise);
    if (result != 0 || file_read(path, SOURCE_BYTES, &bytes, &count, err) != 0)
        return -1;
    struct change_text base = {base_name, bytes, count};
    result = change_apply(&change, &base, &whole, &whole_count, err);
    free(bytes);
    if (result != 0)
        return -1;
    free(submission->text);
    submission->text = whole;
    submission->count = whole_count;
    return 0;
}

static int read_submission(const struct place *place, const char *kind, const char *name,
                           struct known_submission *submission, struct error *err)
{
    bool is_change = ends_in(name, ".change");
    size_t stem = strlen(name) - strlen(is_change ? ".change" : ".c");
    if (asprintf(&submission->file, "%s/%.*s.c", kind, (int)stem, name) < 0)
        submission->file = NULL;
    if (asprintf(&submission->stored, "%s/%s/%s", place->folder, kind, name) < 0)
        submission->stored = NULL;
    if (!submission->file || !submission->stored)
        return error_set(err, "%s: out of memory", name);
    if (is_change && strcmp(kind, "right") == 0)
        return error_set(err, "%s: right answers are whole files, for others to be changes of",
                         submission->stored);
    if (file_read(submission->stored, SOURCE_BYTES, &submission->text, &submission->count, err) !=
            0 ||
        (is_change && expand(place, submission, err) != 0))
        return -1;
    return expectation_read(kind, submission->stored, submission->text, &submission->expected, err);
}

/* ----------------------------------------------------------------- folders */

static int read_kind(const struct place *place, const char *kind, struct known_list *list,
                     struct error *err)
{
    char path[PATH_MAX];
    if (join(path, place->folder, kind, err) != 0)
        return -1;
    char **names = listing_files(path, "", err);
    int result = names ? 0 : -1;
    for (size_t i = 0; result == 0 && names[i]; i++) {
        if (!ends_in(names[i], ".c") && !ends_in(names[i], ".change"))
            result = error_set(err, "%s/%s: neither a .c nor a .change file; take it out", path,
                               names[i]);
        else if (list->count == SUBMISSIONS_MAX)
            result = error_set(err, "%s: more than %d submissions", path, SUBMISSIONS_MAX);
        else
            result = read_submission(place, kind, names[i], &list->submissions[list->count++], err);
    }
    free(names);
    return result;
}

static bool is_kind(const char *name)
{
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++)
        if (strcmp(kinds[i], name) == 0)
            return true;
    return false;
}

/* Folders that are no kind are slips of the pen: what stands in them would never be graded. */
static int check_folders(const struct place *place, struct error *err)
{
    char **names = listing_folders(place->folder, err);
    int result = names ? 0 : -1;
    for (size_t i = 0; result == 0 && names[i]; i++)
        if (!is_kind(names[i]))
            result = error_set(err,
                               "%s/%s: no kind of submission; use right, wrong, poor, slow, "
                               "greedy, crash, leak or hostile",
                               place->folder, names[i]);
    free(names);
    return result;
}

static int by_file(const void *a, const void *b)
{
    const struct known_submission *p = a, *q = b;
    return strcmp(p->file, q->file);
}

/* The same name as .c and as .change would be graded twice under one name. */
static int refuse_twins(const struct known_list *list, struct error *err)
{
    for (int i = 1; i < list->count; i++)
        if (strcmp(list->submissions[i - 1].file, list->submissions[i].file) == 0)
            return error_set(err, "%s: stands there whole and as a change; remove one of them",
                             list->submissions[i].stored);
    return 0;
}

int known_read(const char *root, const char *group, const char *exercise, struct known_list *list,
               struct error *err)
{
    struct place place = {root, group, exercise, ""};
    *list = (struct known_list){calloc(SUBMISSIONS_MAX, sizeof *list->submissions), 0};
    if (!list->submissions)
        return error_set(err, "%s: out of memory", exercise);
    if (snprintf(place.folder, sizeof place.folder, "%s/tests/submissions/%s/%s", root, group,
                 exercise) >= (int)sizeof place.folder)
        return error_set(err, "%s: the path is too long", root);
    int result = check_folders(&place, err);
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0] && result == 0; i++)
        result = read_kind(&place, kinds[i], list, err);
    qsort(list->submissions, (size_t)list->count, sizeof *list->submissions, by_file);
    return result == 0 ? refuse_twins(list, err) : -1;
}

const struct known_submission *known_find(const struct known_list *list, const char *file)
{
    for (int i = 0; i < list->count; i++)
        if (strcmp(list->submissions[i].file, file) == 0)
            return &list->submissions[i];
    return NULL;
}

bool known_is(const struct known_submission *submission, const char *kind)
{
    size_t length = strlen(kind);
    return strncmp(submission->file, kind, length) == 0 && submission->file[length] == '/';
}

int known_write(const struct known_list *list, const char *folder, struct error *err)
{
    char path[PATH_MAX];
    for (int i = 0; i < list->count; i++) {
        const struct known_submission *submission = &list->submissions[i];
        if (join(path, folder, submission->file, err) != 0)
            return -1;
        *strrchr(path, '/') = '\0';
        if (folder_make(path, err) != 0 || join(path, folder, submission->file, err) != 0 ||
            file_write(path, submission->text, submission->count, err) != 0)
            return -1;
    }
    return 0;
}

static void release_submission(struct known_submission *submission)
{
    free(submission->file);
    free(submission->stored);
    free(submission->text);
}

void known_keep(struct known_list *list, const bool *kept)
{
    int count = 0;
    for (int i = 0; i < list->count; i++)
        if (kept[i])
            list->submissions[count++] = list->submissions[i];
        else
            release_submission(&list->submissions[i]);
    list->count = count;
}

void known_release(struct known_list *list)
{
    for (int i = 0; i < list->count; i++)
        release_submission(&list->submissions[i]);
    free(list->submissions);
    *list = (struct known_list){0};
}
