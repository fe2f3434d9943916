/* Uploads; see upload.h. Each path is read into a bundle, students are found in it, and at last all
 * uploads are put in order and every student gets a folder name. */
#include "graders/engine/upload/upload.h"

#include "graders/engine/upload/archive.h"
#include "graders/engine/upload/folder.h"
#include "graders/engine/upload/names.h"
#include "graders/engine/upload/sources.h"
#include "graders/engine/upload/students.h"
#include "graders/engine/upload/tree.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---------------------------------------------------------------- one path */

/* A path that cannot be opened; errno says why. When nothing is there, the caller asked for the
 * wrong thing; else the machine does not let us. */
static int complain_of_path(const char *path, struct error *err)
{
    bool is_absent = errno == ENOENT || errno == ENOTDIR || errno == ENAMETOOLONG || errno == ELOOP;
    return is_absent ? error_set_request(err, "%s: %s", path, strerror(errno))
                     : error_set(err, "%s: %s", path, strerror(errno));
}

static int open_path(const char *path, struct error *err)
{
    int fd = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    return fd < 0 ? complain_of_path(path, err) : fd;
}

/* Reads the path behind `fd`; `base` is its name and loses an archive's ending. */
static int fill_bundle(int fd, char *base, struct origin *origin, struct bundle *bundle,
                       struct error *err)
{
    struct stat status;
    if (fstat(fd, &status))
        return error_set(err, "%s: %s", base, strerror(errno));
    if (S_ISDIR(status.st_mode)) {
        origin->is_folder = true;
        return folder_read(fd, bundle, err);
    }
    if (bundle_kind(base) == BUNDLE_ARCHIVE) {
        base[bundle_archive_stem(base)] = '\0';
        return archive_read_fd(fd, "", bundle, err);
    }
    if (bundle_kind(base) != BUNDLE_SOURCE)
        return error_set_request(
            err, "%s: neither a folder, an archive (.zip, .tar.gz, ...) nor a .c file", base);
    unsigned char *bytes;
    size_t count;
    struct refusal refusal = {0};
    origin->is_single = true;
    if (folder_read_file(fd, base, UPLOAD_FILE_BYTES, &bytes, &count, &refusal, err))
        return -1;
    return bundle_add(bundle, base, bytes, count, &refusal, err);
}

/* The last step of an absolute path; cuts it off. */
static char *cut_last_step(char *path)
{
    char *slash = strrchr(path, '/');
    if (!slash || !slash[1])
        return path;
    *slash = '\0';
    return slash + 1;
}

static int read_path(const char *path, struct origin origin, struct roster *roster,
                     struct error *err)
{
    char *real = realpath(path, NULL);
    if (!real)
        return complain_of_path(path, err);
    int fd = open_path(real, err), result = -1;
    struct bundle bundle = {0};
    char *base = cut_last_step(real);
    if (fd >= 0)
        result = fill_bundle(fd, base, &origin, &bundle, err);
    origin.base = base;
    origin.parent = base == real ? base : cut_last_step(real);
    if (result == 0)
        result = students_find(&bundle, &origin, roster, err);
    bundle_release(&bundle);
    if (fd >= 0)
        close(fd);
    free(real);
    return result;
}

/* ---------------------------------------------------------------- the list */

/* An upload and whose it is, for sorting. */
struct entry {
    struct upload upload;
    int student;
};

static int compare_entries(const void *a, const void *b)
{
    const struct entry *x = a, *y = b;
    int order = strcmp(x->upload.student, y->upload.student);
    if (order == 0)
        order = x->student < y->student ? -1 : x->student > y->student;
    if (order == 0)
        order = strcmp(x->upload.exercise ? x->upload.exercise : "",
                       y->upload.exercise ? y->upload.exercise : "");
    return order;
}

static int sort_roster(struct roster *roster, struct error *err)
{
    struct upload_list *list = roster->list;
    struct entry *entries = calloc((size_t)list->count + 1, sizeof *entries);
    if (!entries)
        return error_set(err, "reading submissions: out of memory");
    for (int i = 0; i < list->count; i++)
        entries[i] = (struct entry){list->uploads[i], roster->students[i]};
    qsort(entries, (size_t)list->count, sizeof *entries, compare_entries);
    for (int i = 0; i < list->count; i++) {
        list->uploads[i] = entries[i].upload;
        roster->students[i] = entries[i].student;
    }
    free(entries);
    return 0;
}

static bool is_same_student(const struct roster *roster, int a, int b)
{
    const struct upload *uploads = roster->list->uploads;
    return roster->students[a] == roster->students[b] &&
           strcmp(uploads[a].student, uploads[b].student) == 0;
}

/* Refuses what one student handed in twice for one exercise, and keeps it once. */
static void join_twins(struct roster *roster)
{
    struct upload_list *list = roster->list;
    int kept = 0;
    for (int i = 0; i < list->count; i++) {
        struct upload *last = kept ? &list->uploads[kept - 1] : NULL;
        if (last && is_same_student(roster, kept - 1, i) &&
            last->exercise == list->uploads[i].exercise) {
            refuse(&last->refusal, &upload_file_twice, "%s was handed in twice.",
                   "%s se entregó dos veces.", last->exercise ? last->exercise : "It");
            upload_settle(last);
            upload_release(&list->uploads[i]);
        } else {
            list->uploads[kept] = list->uploads[i];
            roster->students[kept++] = roster->students[i];
        }
    }
    list->count = kept;
}

static bool is_taken(const struct upload *uploads, int count, const char *folder)
{
    for (int i = 0; i < count; i++)
        if (strcasecmp(uploads[i].student_folder, folder) == 0)
            return true;
    return false;
}

/* Gives each student a folder name that no other has, whatever the letter case. */
static int name_folders(struct roster *roster, struct error *err)
{
    struct upload *uploads = roster->list->uploads;
    for (int i = 0; i < roster->list->count; i++) {
        char slug[NAMES_SLUG], folder[NAMES_SLUG + 16];
        if (i > 0 && is_same_student(roster, i, i - 1)) {
            snprintf(folder, sizeof folder, "%s", uploads[i - 1].student_folder);
        } else {
            names_slug(slug, uploads[i].student);
            snprintf(folder, sizeof folder, "%s", slug);
            for (int n = 2; is_taken(uploads, i, folder); n++)
                snprintf(folder, sizeof folder, "%s-%d", slug, n);
        }
        uploads[i].student_folder = strdup(folder);
        if (!uploads[i].student_folder)
            return error_set(err, "reading submissions: out of memory");
    }
    return 0;
}

static int finish_list(struct roster *roster, struct error *err)
{
    if (!roster->students)
        return 0; /* nobody handed in anything */
    if (sort_roster(roster, err))
        return -1;
    join_twins(roster);
    return name_folders(roster, err);
}

static int compare_strings(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

static int find_exercise(const char *const *exercises, const char *exercise, int *only,
                         struct error *err)
{
    int count = 0;
    *only = -1;
    for (; exercises[count]; count++)
        if (exercise && strcmp(exercises[count], exercise) == 0)
            *only = count;
    if (count > TREE_EXERCISES)
        return error_set(err, "more than %d exercises", TREE_EXERCISES);
    return exercise && *only < 0 ? error_set_request(err, "there is no exercise %s", exercise) : 0;
}

int upload_read(const char *const *paths, int path_count, const char *const *exercises,
                const char *exercise, struct upload_list *list, struct error *err)
{
    *list = (struct upload_list){0};
    struct roster roster = {.list = list};
    struct origin origin = {.exercises = exercises, .is_one_of_many = path_count > 1};
    const char **sorted = calloc((size_t)path_count + 1, sizeof *sorted);
    if (!sorted)
        return error_set(err, "reading submissions: out of memory");
    if (path_count)
        memcpy(sorted, paths, (size_t)path_count * sizeof *sorted);
    qsort(sorted, (size_t)path_count, sizeof *sorted, compare_strings);
    int result = find_exercise(exercises, exercise, &origin.only, err);
    for (int i = 0; i < path_count && result == 0; i++)
        if (i == 0 || strcmp(sorted[i], sorted[i - 1]) != 0)
            result = read_path(sorted[i], origin, &roster, err);
    if (result == 0)
        result = finish_list(&roster, err);
    free(sorted);
    free(roster.students);
    return result;
}

int upload_read_files(const char *const *paths, int path_count, const char *exercise,
                      struct upload *upload, struct error *err)
{
    *upload = (struct upload){.student = strdup(""), .exercise = exercise};
    int result = upload->student ? 0 : error_set(err, "reading files: out of memory");
    for (int i = 0; i < path_count && result == 0; i++) {
        unsigned char *bytes = NULL;
        size_t count = 0;
        const char *name = strrchr(paths[i], '/') ? strrchr(paths[i], '/') + 1 : paths[i];
        int fd = open_path(paths[i], err);
        if (fd < 0)
            return -1;
        result = bundle_kind(name) == BUNDLE_SOURCE
                     ? folder_read_file(fd, name, UPLOAD_FILE_BYTES, &bytes, &count,
                                        &upload->refusal, err)
                     : error_set_request(err, "%s: not a .c or .h file", paths[i]);
        close(fd);
        if (result == 0 && bytes)
            result = upload_take_source(upload, name, strlen(name), bytes, count, err);
        free(bytes);
    }
    if (result == 0 && upload->refusal.is_fault)
        result = error_set(err, "%s", upload->refusal.message.en);
    if (result == 0)
        upload_settle(upload);
    return result;
}

void upload_list_release(struct upload_list *list)
{
    for (int i = 0; i < list->count; i++)
        upload_release(&list->uploads[i]);
    for (int i = 0; i < list->note_count; i++)
        free(list->notes[i]);
    free(list->uploads);
    free(list->notes);
    *list = (struct upload_list){0};
}
