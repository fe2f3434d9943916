/* A new exercise as a copy of one that is there; see skeleton.h. */
#include "graders/commands/skeleton.h"

#include "graders/engine/base/files.h"
#include "reference/base/listing.h"

#include <ctype.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { FILE_LIMIT = 1 << 20, NAME_FORMS = 3 };

/* ---------------------------------------------------------------------------------------- names */

static bool is_plain(const char *name)
{
    bool plain = islower((unsigned char)*name) && strlen(name) < EXERCISE_NAME;
    for (const char *at = name; *at; at++)
        plain &= islower((unsigned char)*at) || isdigit((unsigned char)*at) || *at == '-';
    return plain && name[strlen(name) - 1] != '-';
}

int skeleton_name(const char *text, struct skeleton *skeleton, struct error *err)
{
    const char *slash = strchr(text, '/');
    size_t length = slash ? (size_t)(slash - text) : 0;
    if (slash && length < sizeof skeleton->group && strlen(slash + 1) < sizeof skeleton->name) {
        memcpy(skeleton->group, text, length);
        skeleton->group[length] = '\0';
        strcpy(skeleton->name, slash + 1);
        if (*skeleton->group && is_plain(skeleton->group) && *skeleton->name &&
            is_plain(skeleton->name))
            return 0;
    }
    return error_set(err,
                     "\"%s\" is no name of an exercise: write GROUP/NAME, each of lower case "
                     "letters, digits and dashes, at most %d long: topology/boundary-loops",
                     text, EXERCISE_NAME - 1);
}

/* "edge-table", "edge_table", "EDGE_TABLE". */
static void spell(const char *name, int form, char spelled[EXERCISE_NAME])
{
    size_t i = 0;
    for (; name[i] && i + 1 < EXERCISE_NAME; i++) {
        spelled[i] = form > 0 && name[i] == '-' ? '_' : name[i];
        if (form == 2)
            spelled[i] = (char)toupper((unsigned char)spelled[i]);
    }
    spelled[i] = '\0';
}

static bool in_name(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

/* Whether what stands at `at` is the name by itself, or the name of its judge or include guard. */
static bool stands_alone(const char *text, const char *at, size_t length)
{
    static const char judge[] = "judge_", guard[] = "_H";
    const char *begin = at, *end = at + length;
    if ((size_t)(at - text) >= strlen(judge) &&
        strncmp(at - strlen(judge), judge, strlen(judge)) == 0)
        begin = at - strlen(judge);
    if (strncmp(end, guard, strlen(guard)) == 0)
        end += strlen(guard);
    return (begin == text || !in_name(begin[-1])) && !in_name(*end);
}

/* Whether the line of `at` includes a file of the library. */
static bool is_library_line(const char *text, const char *at)
{
    static const char *const starts[] = {"#include \"graders/", "#include \"reference/"};
    while (at > text && at[-1] != '\n')
        at--;
    return strncmp(at, starts[0], strlen(starts[0])) == 0 ||
           strncmp(at, starts[1], strlen(starts[1])) == 0;
}

static char *replaced(const char *text, const char *from, const char *to)
{
    size_t count = 0, length = strlen(from), more = strlen(to);
    char *made = calloc(strlen(text) * (more / length + 2) + 1, 1);
    if (!made)
        return NULL;
    for (const char *at = text; *at;) {
        if (strncmp(at, from, length) == 0 && stands_alone(text, at, length) &&
            !is_library_line(text, at)) {
            stpcpy(made + count, to);
            count += more;
            at += length;
        } else {
            made[count++] = *at++;
        }
    }
    return made;
}

char *skeleton_renamed(const char *text, const char *from, const char *to)
{
    char *made = strdup(text);
    for (int form = 0; made && form < NAME_FORMS; form++) {
        char old[EXERCISE_NAME], new[EXERCISE_NAME];
        spell(from, form, old);
        spell(to, form, new);
        char *next = replaced(made, old, new);
        free(made);
        made = next;
    }
    return made;
}

/* ---------------------------------------------------------------------------------------- files */

static int write_new(const struct skeleton *skeleton, const char *path, const char *text,
                     struct error *err)
{
    if (access(path, F_OK) == 0)
        return error_set(err, "%s is there already: take another name, or remove it first", path);
    if (file_write(path, text, strlen(text), err) != 0)
        return -1;
    skeleton->tell(path);
    return 0;
}

static int copy_file(const struct skeleton *skeleton, const char *from, const char *to,
                     struct error *err)
{
    char *bytes;
    size_t count;
    if (file_read(from, FILE_LIMIT, &bytes, &count, err) != 0)
        return -1;
    char *text = skeleton_renamed(bytes, skeleton->like->name, skeleton->name);
    free(bytes);
    int result = text ? write_new(skeleton, to, text, err) : error_set(err, "out of memory");
    free(text);
    return result;
}

/* One of the files that bear the exercise's name: ROOT/PLACE/GROUP/NAME.c */
static int copy_named(const struct skeleton *skeleton, const char *root, const char *place,
                      struct error *err)
{
    char folder[PATH_MAX], from[PATH_MAX], to[PATH_MAX];
    if (file_path(folder, err, "%s/%s/%s", root, place, skeleton->group) != 0 ||
        file_path(from, err, "%s/%s/%s/%s.c", root, place, skeleton->like->group,
                  skeleton->like->name) != 0 ||
        file_path(to, err, "%s/%s.c", folder, skeleton->name) != 0 || folder_make(folder, err) != 0)
        return -1;
    return copy_file(skeleton, from, to, err);
}

/* Copies a folder's files, renamed where they bear the old name; exercise.json is made anew. */
static int copy_folder(const struct skeleton *skeleton, const char *from, const char *to,
                       struct error *err)
{
    char **names = listing_files(from, "", err);
    int result = names ? folder_make(to, err) : -1;
    for (size_t i = 0; result == 0 && names[i]; i++) {
        char source[PATH_MAX], target[PATH_MAX];
        if (strcmp(names[i], "exercise.json") == 0)
            continue;
        char *name = skeleton_renamed(names[i], skeleton->like->name, skeleton->name);
        result = name ? file_path(source, err, "%s/%s", from, names[i])
                      : error_set(err, "out of memory");
        if (result == 0)
            result = file_path(target, err, "%s/%s", to, name);
        if (result == 0)
            result = copy_file(skeleton, source, target, err);
        free(name);
    }
    free(names);
    return result;
}

static int copy_submissions(const struct skeleton *skeleton, const char *root, struct error *err)
{
    char from[PATH_MAX], to[PATH_MAX], kind_from[PATH_MAX], kind_to[PATH_MAX];
    if (file_path(from, err, "%s/tests/submissions/%s/%s", root, skeleton->like->group,
                  skeleton->like->name) != 0 ||
        file_path(to, err, "%s/tests/submissions/%s/%s", root, skeleton->group, skeleton->name) !=
            0)
        return -1;
    char **kinds = listing_folders(from, err);
    int result = kinds ? 0 : -1;
    for (size_t i = 0; result == 0 && kinds[i]; i++) {
        result = file_path(kind_from, err, "%s/%s", from, kinds[i]);
        if (result == 0)
            result = file_path(kind_to, err, "%s/%s", to, kinds[i]);
        if (result == 0)
            result = copy_folder(skeleton, kind_from, kind_to, err);
    }
    free(kinds);
    return result;
}

/* The same points and classes; name, group, order, problem and title are the new one's. */
static int write_manifest(const struct skeleton *skeleton, const char *folder, struct error *err)
{
    char from[PATH_MAX], to[PATH_MAX], title[EXERCISE_NAME];
    char *bytes;
    size_t count;
    if (file_path(from, err, "%s/exercise.json", skeleton->like->folder) != 0 ||
        file_path(to, err, "%s/exercise.json", folder) != 0 ||
        file_read(from, FILE_LIMIT, &bytes, &count, err) != 0)
        return -1;
    char *text = skeleton_renamed(bytes, skeleton->like->name, skeleton->name);
    free(bytes);
    json_auto_t *json = text ? json_loads(text, 0, NULL) : NULL;
    free(text);
    spell(skeleton->name, 0, title);
    for (char *at = title; *at; at++)
        *at = *at == '-' ? ' ' : *at;
    title[0] = (char)toupper((unsigned char)title[0]);
    if (!json)
        return error_set(err, "%s cannot be read", from);
    json_object_set_new(json, "group", json_string(skeleton->group));
    json_object_set_new(json, "order", json_integer(skeleton->order));
    json_object_set_new(json, "problem", json_string(""));
    json_object_set_new(json, "title", json_pack("{s:s, s:s}", "en", title, "es", title));
    char *written = json_dumps(json, JSON_INDENT(2));
    int result = written ? write_new(skeleton, to, written, err) : error_set(err, "out of memory");
    free(written);
    return result;
}

int skeleton_write(const struct skeleton *skeleton, struct error *err)
{
    static const char *const places[] = {"reference/answers", "graders/runner", "graders/judges"};
    char folder[PATH_MAX];
    const char *root = project_root(err);
    if (!root ||
        file_path(folder, err, "%s/exercises/%s/%s", root, skeleton->group, skeleton->name) != 0)
        return -1;
    if (access(folder, F_OK) == 0)
        return error_set(err, "%s is there already: take another name, or remove it first", folder);
    if (copy_folder(skeleton, skeleton->like->folder, folder, err) != 0 ||
        write_manifest(skeleton, folder, err) != 0)
        return -1;
    for (size_t i = 0; i < sizeof places / sizeof *places; i++)
        if (copy_named(skeleton, root, places[i], err) != 0)
            return -1;
    return copy_submissions(skeleton, root, err);
}
