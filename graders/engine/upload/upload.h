/* From the paths that an instructor gives to submissions in memory. Nothing is ever extracted to
 * disk, no link is followed, every size is bounded.
 *
 * Layouts, in folders or in .zip, .tar, .tar.gz, .tar.xz, .tar.bz2 archives, and one archive a
 * student inside any of them:
 *     <student>/<exercise>.c                       and any .h files beside it
 *     <student>/<exercise>/...                     .c and .h files
 *     <student>.zip                                holding the one or the other
 *     <name>_<id>_assignsubmission_file_/...       Moodle, also flat ("download in folders" off)
 *     submission_<id>/... submission_metadata.yml  Gradescope's export
 *     <student>.c                                  single files, when the exercise is given
 * Folders around the class and inside a student's upload are looked through. Exercise names match
 * without regard to case and with `_` for `-`. When one path holds one student and several paths
 * are given, the student bears the path's name.
 *
 * What is wrong with a student's upload refuses that student's submissions and no other's, in one
 * archive of the whole class too. What of such an archive cannot be read is reported as a fault
 * under the archive's own name (archive-unread). */
#ifndef GRADERS_ENGINE_UPLOAD_UPLOAD_H
#define GRADERS_ENGINE_UPLOAD_UPLOAD_H

#include "graders/engine/base/refusal.h"
#include "reference/base/error.h"

enum {
    UPLOAD_FILE_BYTES = 1 << 20, /* of one source file */
    UPLOAD_FILES = 20,           /* of one submission */
    UPLOAD_NAME_BYTES = 63       /* of a file's name */
};

struct upload_file {
    char *name; /* [A-Za-z0-9._-]+, ends in .c or .h, does not begin with . or - */
    unsigned char *bytes;
    size_t count;
};

/* One submission: a student's files for one exercise. */
struct upload {
    char *student;             /* as found, made valid UTF-8; untrusted text */
    char *student_folder;      /* the same as a safe file name, unique in the list */
    const char *exercise;      /* the caller's string; NULL: refused before one could be told */
    struct upload_file *files; /* sorted by name; none when refused */
    int file_count;
    struct refusal refusal;
};

struct upload_list {
    struct upload
        *uploads; /* sorted by student, then exercise: the same paths give the same list */
    int count;
    char **notes; /* what was not taken, one line each: "ana/notes.txt: not a .c or .h file" */
    int note_count;
};

/* Reads every path.
 *
 * paths      `path_count` files, folders or archives
 * exercises  NULL-terminated names of the exercises that exist; outlive the list
 * exercise   one of them when everything is for that exercise; NULL: told by names
 * list       release with upload_list_release, also after an error
 * returns    0, or -1 and *err: a path cannot be read (names it), or memory runs out
 * Causes of refusals: archive-* (link, device, path, too-large, too-many, ratio, nested, broken,
 * encrypted, kind), folder-* (path, too-large), file-name, file-too-large, too-many-files,
 * file-twice, link, device, no-source; and, as faults, unreadable, archive-unread,
 * archive-unreadable, folder-unreadable. */
int upload_read(const char *const *paths, int path_count, const char *const *exercises,
                const char *exercise, struct upload_list *list, struct error *err) MUST_CHECK;

/* Takes the files of one submission as they are given: `meshgrade check EXERCISE FILE...`.
 * `upload` is filled with student "" and no folder; release it with upload_release. */
int upload_read_files(const char *const *paths, int path_count, const char *exercise,
                      struct upload *upload, struct error *err) MUST_CHECK;

void upload_release(struct upload *upload);
void upload_list_release(struct upload_list *list);

#endif
