/* Students and submissions in a bundle; see upload_students.h. */
#include "graders/engine/upload/students.h"

#include "graders/engine/upload/names.h"
#include "graders/engine/upload/sources.h"
#include "graders/engine/upload/tree.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NOTES_MAX = 500 };

struct reading {
    const struct origin *origin;
    struct bundle *bundle;
    struct folder_tree tree;
    bool *used;  /* by file of the bundle: taken into a submission, or named in its refusal */
    int student; /* the current one's number */
    int first_upload;
    bool found_marked;
    struct roster *roster;
    struct error *err;
};

static int out_of_memory(struct reading *r)
{
    return error_set(r->err, "reading submissions: out of memory");
}

/* ---------------------------------------------------------------- the list */

static int add_note(struct reading *r, const char *path, const char *what)
{
    struct upload_list *list = r->roster->list;
    if (list->note_count >= NOTES_MAX)
        return 0;
    char **larger = realloc(list->notes, (size_t)(list->note_count + 1) * sizeof *list->notes);
    if (!larger)
        return out_of_memory(r);
    list->notes = larger;
    char *line, *clean = names_utf8(path, strlen(path));
    if (!clean || asprintf(&line, "%s/%s: %s", r->origin->base, clean, what) < 0)
        line = NULL;
    free(clean);
    if (!line)
        return out_of_memory(r);
    for (char *c = line; *c; c++)
        if ((unsigned char)*c < ' ' || *c == 0x7f)
            *c = '?';
    list->notes[list->note_count++] = line;
    return 0;
}

/* Appends an upload of the current student. NULL when memory runs out. */
static struct upload *add_upload(struct reading *r, const char *display, int exercise)
{
    struct upload_list *list = r->roster->list;
    struct upload *larger = realloc(list->uploads, (size_t)(list->count + 1) * sizeof *larger);
    if (larger)
        list->uploads = larger;
    int *students = realloc(r->roster->students, (size_t)(list->count + 1) * sizeof *students);
    if (students)
        r->roster->students = students;
    if (!larger || !students) {
        out_of_memory(r);
        return NULL;
    }
    struct upload *upload = &list->uploads[list->count];
    *upload = (struct upload){.exercise = exercise < 0 ? NULL : r->origin->exercises[exercise]};
    upload->student = strdup(display);
    if (!upload->student) {
        out_of_memory(r);
        return NULL;
    }
    r->roster->students[list->count++] = r->student;
    return upload;
}

/* ---------------------------------------------------------------- files of a submission */

/* Takes one file of the bundle, if it is a source and not the exercise's own header. */
static int take_node(struct reading *r, struct upload *upload, const struct tree_node *node)
{
    const struct bundle_file *file = &r->bundle->files[node->file];
    if (file->refusal.refused) {
        r->used[node->file] = true;
        if (!upload->refusal.refused)
            upload->refusal = file->refusal;
        return 0;
    }
    bool is_header = node->length && (node->name[node->length - 1] | 32) == 'h';
    if (!file->bytes || bundle_kind(file->path) != BUNDLE_SOURCE ||
        (is_header && node->exercise >= 0))
        return 0;
    r->used[node->file] = true;
    return upload_take_source(upload, node->name, node->length, file->bytes, file->count, r->err);
}

/* Everything below a folder. */
static int take_folder(struct reading *r, struct upload *upload, int folder)
{
    int result = 0, child = r->tree.nodes[folder].first_child;
    for (; child >= 0 && result == 0; child = r->tree.nodes[child].next) {
        const struct tree_node *node = &r->tree.nodes[child];
        if (node->file >= 0)
            result = take_node(r, upload, node);
        if (result == 0 && node->is_folder)
            result = take_folder(r, upload, child);
    }
    return result;
}

/* A file <exercise>.c and the headers beside it. */
static int take_file_and_headers(struct reading *r, struct upload *upload, int file)
{
    int result = take_node(r, upload, &r->tree.nodes[file]);
    int child = r->tree.nodes[r->tree.nodes[file].parent].first_child;
    for (; child >= 0 && result == 0; child = r->tree.nodes[child].next) {
        const struct tree_node *node = &r->tree.nodes[child];
        bool is_header = !node->is_folder && node->length > 1 &&
                         node->name[node->length - 2] == '.' &&
                         (node->name[node->length - 1] | 32) == 'h';
        if (is_header && node->file >= 0)
            result = take_node(r, upload, node);
    }
    return result;
}

/* ---------------------------------------------------------------- submissions of a student */

/* The places in a student's folder that are named after an exercise. */
struct places {
    int best, depth, other; /* nodes; other: as near as best */
};

static void find_places(const struct reading *r, int folder, int exercise, int depth,
                        struct places *places)
{
    for (int c = r->tree.nodes[folder].first_child; c >= 0; c = r->tree.nodes[c].next) {
        const struct tree_node *node = &r->tree.nodes[c];
        if (node->exercise == exercise && node->has_source) {
            if (places->best < 0 || depth < places->depth)
                *places = (struct places){.best = c, .depth = depth, .other = -1};
            else if (depth == places->depth)
                places->other = c;
        } else if (node->is_folder && node->exercise < 0) {
            find_places(r, c, exercise, depth + 1, places);
        }
    }
}

static int add_submission(struct reading *r, const char *display, int student, int exercise,
                          const struct refusal *refusal)
{
    struct places places = {.best = -1, .other = -1};
    struct upload *upload = add_upload(r, display, exercise);
    if (!upload)
        return -1;
    if (refusal) {
        upload->refusal = *refusal;
        return 0;
    }
    find_places(r, student, exercise, 0, &places);
    int result = 0;
    if (places.other >= 0) {
        char first[REFUSAL_NAME], second[REFUSAL_NAME];
        const struct tree_node *a = &r->tree.nodes[places.best], *b = &r->tree.nodes[places.other];
        refuse(&upload->refusal, &upload_file_twice, "Handed in twice: as %s and as %s.",
               "Entregado dos veces: como %s y como %s.", refusal_name(first, a->name, a->length),
               refusal_name(second, b->name, b->length));
    } else if (places.best < 0) {
        result = take_folder(r, upload, student);
    } else if (r->tree.nodes[places.best].is_folder) {
        result = take_folder(r, upload, places.best);
    } else {
        result = take_file_and_headers(r, upload, places.best);
    }
    if (result == 0)
        upload_settle(upload);
    return result;
}

/* The first refusal of an archive or a folder in or around a student's folder, or NULL. */
static const struct refusal *find_refusal(struct reading *r, int student)
{
    for (int node = student; node >= 0; node = r->tree.nodes[node].parent) {
        int file = r->tree.nodes[node].file;
        if (file >= 0 && bundle_refuses_all(&r->bundle->files[file]))
            return &r->bundle->files[file].refusal;
    }
    if (!r->tree.nodes[student].has_refusal)
        return NULL;
    for (int c = r->tree.nodes[student].first_child; c >= 0; c = r->tree.nodes[c].next)
        if (r->tree.nodes[c].has_refusal) {
            int file = r->tree.nodes[c].file;
            return file >= 0 && bundle_refuses_all(&r->bundle->files[file])
                       ? &r->bundle->files[file].refusal
                       : find_refusal(r, c);
        }
    return NULL;
}

static void mark_used(struct reading *r, int node)
{
    if (r->tree.nodes[node].file >= 0)
        r->used[r->tree.nodes[node].file] = true;
    for (int c = r->tree.nodes[node].first_child; c >= 0; c = r->tree.nodes[c].next)
        mark_used(r, c);
}

static int add_student(struct reading *r, int student, const char *display)
{
    const struct tree_node *node = &r->tree.nodes[student];
    const struct refusal *refusal = find_refusal(r, student);
    int result = 0;
    r->student = ++r->roster->student_count;
    if (refusal)
        mark_used(r, student);
    for (int e = 0; r->origin->exercises[e] && result == 0; e++)
        if (tree_claims_has(&node->below, e))
            result = add_submission(r, display, student, e, refusal);
    if (!tree_claims_is_empty(&node->below) || (!refusal && !node->has_source))
        return result;
    struct upload *upload = add_upload(r, display, r->origin->only);
    if (!upload)
        return -1;
    if (refusal)
        upload->refusal = *refusal;
    refuse(&upload->refusal, &upload_no_source,
           "No file or folder is named after an exercise (%s.c, for example).",
           "Ningún archivo ni carpeta lleva el nombre de un ejercicio (por ejemplo, %s.c).",
           r->origin->exercises[0] ? r->origin->exercises[0] : "mesh-area");
    return 0;
}

/* ---------------------------------------------------------------- students of a path */

/* The name that a student's folder stands for. NULL when memory runs out. */
static char *display_of(struct reading *r, int student)
{
    const struct tree_node *node = &r->tree.nodes[student];
    if (student == 0)
        return strdup(r->origin->base);
    if (!node->is_marked)
        return names_utf8(node->name, node->length);
    r->found_marked = true;
    size_t moodle = names_moodle(node->name, node->length);
    if (moodle)
        return names_utf8(node->name, moodle);
    for (int c = r->tree.nodes[node->parent].first_child; c >= 0; c = r->tree.nodes[c].next) {
        const struct tree_node *meta = &r->tree.nodes[c];
        if (meta->file >= 0 && bundle_kind(r->bundle->files[meta->file].path) == BUNDLE_METADATA)
            return names_gradescope((const char *)r->bundle->files[meta->file].bytes,
                                    r->bundle->files[meta->file].count, node->name, node->length);
    }
    return names_utf8(node->name, node->length);
}

static int add_named_student(struct reading *r, int student)
{
    char *display = display_of(r, student);
    int result = display ? add_student(r, student, display) : out_of_memory(r);
    free(display);
    return result;
}

/* Single files when the exercise is given: each <student>.c in the folder itself. */
static int add_loose_files(struct reading *r)
{
    int result = 0;
    for (int c = r->tree.nodes[0].first_child; c >= 0 && result == 0; c = r->tree.nodes[c].next) {
        const struct tree_node *node = &r->tree.nodes[c];
        if (node->is_folder || !node->has_source)
            continue;
        char *display = names_utf8(node->name, tree_stem(node));
        r->student = ++r->roster->student_count;
        struct upload *upload = display ? add_upload(r, display, r->origin->only) : NULL;
        free(display);
        result = upload ? take_node(r, upload, node) : -1;
        if (result == 0)
            upload_settle(upload);
    }
    return result;
}

static int find_students(struct reading *r, int node);

/* Below a folder that holds platforms' folders of students. */
static int find_marked(struct reading *r, int node)
{
    int result = 0;
    for (int c = r->tree.nodes[node].first_child; c >= 0 && result == 0; c = r->tree.nodes[c].next)
        if (!r->tree.nodes[c].is_marked && r->tree.nodes[c].has_marked)
            result = find_marked(r, c);
        else if (r->tree.nodes[c].is_marked || tree_is_candidate(&r->tree, c))
            result = add_named_student(r, c);
    return result;
}

static int find_students(struct reading *r, int node)
{
    const struct tree_node *n = &r->tree.nodes[node];
    int candidates = 0, only_child = -1, result = 0;
    if (n->has_marked)
        return find_marked(r, node);
    for (int c = n->first_child; c >= 0; c = r->tree.nodes[c].next)
        if (tree_is_candidate(&r->tree, c)) {
            candidates++;
            only_child = c;
        }
    const bool is_class = node == 0 && candidates > 1;
    if (node == 0 && n->file >= 0 && bundle_refuses_all(&r->bundle->files[n->file]))
        return add_named_student(r, node); /* an archive that could not be read */
    if (node == 0 && r->origin->only >= 0 && r->origin->is_folder &&
        !tree_claims_is_empty(&n->own)) {
        struct places named = {.best = -1, .other = -1};
        find_places(r, node, r->origin->only, 0, &named);
        if (named.best >= 0 && named.depth == 0 && !is_class)
            return add_named_student(r, node);
        result = add_loose_files(r);
    } else if (!tree_claims_is_empty(&n->own) && !is_class) {
        return add_named_student(r, node);
    }
    if (candidates == 1) {
        const struct tree_node *child = &r->tree.nodes[only_child];
        bool is_wrapping =
            tree_claims_is_empty(&child->own) && !tree_claims_is_empty(&child->below);
        if (result == 0)
            result = is_wrapping ? find_students(r, only_child) : add_named_student(r, only_child);
        return result;
    }
    for (int c = n->first_child; c >= 0 && result == 0; c = r->tree.nodes[c].next)
        if (tree_is_candidate(&r->tree, c))
            result = tree_claims_is_empty(&r->tree.nodes[c].own) && tree_is_group(&r->tree, c)
                         ? find_students(r, c)
                         : add_named_student(r, c);
    return result;
}

/* Notes every file that no submission took. */
static int note_unused(struct reading *r)
{
    int result = 0;
    for (int i = 0; i < r->bundle->count && result == 0; i++) {
        const struct bundle_file *file = &r->bundle->files[i];
        const enum bundle_kind kind = bundle_kind(file->path);
        if (r->used[i] || (kind == BUNDLE_METADATA && !file->refusal.refused))
            continue;
        result = add_note(r, file->path,
                          file->refusal.refused   ? file->refusal.message.en
                          : kind == BUNDLE_SOURCE ? "not taken (not part of a submission, or the "
                                                    "exercise's own header)"
                                                  : "not taken (no .c or .h file)");
    }
    return result;
}

/* A path that is a single source: the exercise's name or the student's, whichever it bears. */
static int add_single_file(struct reading *r)
{
    const struct tree_node *node = &r->tree.nodes[r->tree.nodes[0].first_child];
    bool is_named =
        node->exercise >= 0 && (r->origin->only < 0 || node->exercise == r->origin->only);
    char *display = is_named ? names_utf8(r->origin->parent, strlen(r->origin->parent))
                             : names_utf8(node->name, tree_stem(node));
    r->student = -1; /* known by name: several files may be one student's */
    struct upload *upload =
        display ? add_upload(r, display, r->origin->only >= 0 ? r->origin->only : node->exercise)
                : NULL;
    free(display);
    if (!upload)
        return out_of_memory(r);
    if (!upload->exercise)
        refuse(&upload->refusal, &upload_no_source, "The file is not named after an exercise.",
               "El archivo no lleva el nombre de un ejercicio.");
    int result = take_node(r, upload, node);
    if (result == 0)
        upload_settle(upload);
    return result;
}

/* When one path of several holds one student, the student bears the path's name. */
static int name_after_path(struct reading *r)
{
    for (int i = r->first_upload; i < r->roster->list->count; i++)
        if (r->roster->students[i] != r->roster->students[r->first_upload] ||
            r->roster->students[i] < 0)
            return 0;
    if (!r->origin->is_one_of_many || r->found_marked)
        return 0;
    for (int i = r->first_upload; i < r->roster->list->count; i++) {
        char *name = names_utf8(r->origin->base, strlen(r->origin->base));
        if (!name)
            return out_of_memory(r);
        free(r->roster->list->uploads[i].student);
        r->roster->list->uploads[i].student = name;
    }
    return 0;
}

/* The part of an archive that was not read is reported as nobody's, for whoever grades. When what
 * was read is of one student or none, the archive is that student's, and as damaged as any. */
static int add_rest(struct reading *r, int students_before)
{
    const int file = r->tree.nodes[0].file;
    struct upload_list *list = r->roster->list;
    if (file < 0 || !bundle_is_rest(&r->bundle->files[file]))
        return 0;
    r->used[file] = true;
    bool is_class = r->roster->student_count - students_before > 1;
    while (!is_class && list->count > r->first_upload)
        upload_release(&list->uploads[--list->count]);
    r->student = ++r->roster->student_count;
    char *display = names_utf8(r->origin->base, strlen(r->origin->base));
    struct upload *upload = display ? add_upload(r, display, r->origin->only) : NULL;
    free(display);
    if (!upload)
        return out_of_memory(r);
    upload->refusal = r->bundle->files[file].refusal;
    if (!is_class) {
        upload->refusal.is_fault = false;
        refusal_rename(&upload->refusal, &upload_archive_broken);
    }
    return 0;
}

int students_find(struct bundle *bundle, const struct origin *origin, struct roster *roster,
                  struct error *err)
{
    struct reading r = {.origin = origin, .bundle = bundle, .roster = roster, .err = err};
    bundle_sort(bundle);
    if (tree_build(bundle, origin->exercises, origin->only, &r.tree, err))
        return -1;
    r.first_upload = roster->list->count;
    r.used = calloc((size_t)bundle->count + 1, sizeof *r.used);
    const int students_before = roster->student_count;
    int result = !r.used             ? out_of_memory(&r)
                 : origin->is_single ? add_single_file(&r)
                                     : find_students(&r, 0);
    if (result == 0)
        result = name_after_path(&r);
    if (result == 0)
        result = add_rest(&r, students_before);
    if (result == 0)
        result = note_unused(&r);
    free(r.used);
    tree_release(&r.tree);
    return result;
}
