/* Finds the students in one bundle, and what each handed in. */
#ifndef GRADERS_ENGINE_UPLOAD_STUDENTS_H
#define GRADERS_ENGINE_UPLOAD_STUDENTS_H

#include "graders/engine/upload/bundle.h"
#include "graders/engine/upload/upload.h"

/* The uploads found so far, in all bundles. */
struct roster {
    struct upload_list *list; /* student_folder is still NULL */
    int *students; /* by upload: who is who when names are equal; -1: known by name alone */
    int student_count;
};

/* Where a bundle comes from. */
struct origin {
    const char *const *exercises; /* NULL-terminated */
    int only;                     /* index of the exercise that everything is for, or -1 */
    const char *base;             /* the path's own name, without an archive's ending */
    const char *parent;           /* the name of the folder that it lies in */
    bool is_folder;               /* the path is a folder on disk */
    bool is_single;               /* the path is one source file, the bundle's only file */
    bool is_one_of_many;          /* several paths were given */
};

/* Sorts the bundle, and appends its students' uploads and notes to the roster.
 * Returns 0, or -1 and *err when memory runs out. */
int students_find(struct bundle *bundle, const struct origin *origin, struct roster *roster,
                  struct error *err) MUST_CHECK;

#endif
