/* Reads exercise.json; see exercise.h. A reader of its own names the key at fault, which
 * json_unpack cannot. */
#include "graders/engine/base/exercise.h"

#include "graders/engine/base/files.h"
#include "reference/base/listing.h"

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { FILE_LIMIT_BYTES = 1 << 20, CLASS_COLUMNS = 37, TITLE_COLUMNS = 63 /* with its problem */ };

static const double POINTS = 10; /* of every exercise, so that none weighs more than another */

static const struct {
    const char *name;
    struct phrase title;
} checks[CHECK_COUNT] = {
    [CHECK_UNDEFINED_BEHAVIOUR] = {"undefined-behaviour",
                                   {"No undefined behaviour", "Sin comportamiento indefinido"}},
    [CHECK_LEAK] = {"leak", {"Frees what it allocates", "Libera lo que reserva"}},
    [CHECK_GROWTH] = {"growth", {"Growth of the work", "Crecimiento del trabajo"}},
    [CHECK_QUERY_GROWTH] = {"query-growth", {"Growth of queries", "Crecimiento de las consultas"}},
    [CHECK_QUERY_WORK] = {"query-work", {"Work of queries", "Trabajo de las consultas"}},
    [CHECK_QUERY_MEMORY] = {"query-memory", {"Memory of queries", "Memoria de las consultas"}},
    [CHECK_WORK] = {"work", {"Amount of work", "Cantidad de trabajo"}},
    [CHECK_ACCESSES] = {"accesses", {"Number of accesses", "Número de accesos"}},
    [CHECK_MEMORY] = {"memory", {"Peak of memory", "Máximo de memoria"}},
    [CHECK_ALLOCATION_FAILURE] = {"allocation-failure",
                                  {"Reports that memory ran out", "Avisa si falta memoria"}},
};

const char *check_name(enum check_kind check)
{
    return checks[check].name;
}

struct phrase check_title(enum check_kind check)
{
    return checks[check].title;
}

/* ------------------------------------------------------------ typed access */

/* Where we are in the file; the first error sticks. */
struct place {
    const char *file;
    struct error *err;
    bool failed;
};

static void complain(struct place *place, const char *key, const char *expected)
{
    if (!place->failed)
        error_set(place->err, "%s: %s: expected %s", place->file, key, expected);
    place->failed = true;
}

static void get_text(struct place *place, const json_t *object, const char *key, char *text,
                     size_t capacity)
{
    const char *value = json_string_value(json_object_get(object, key));
    if (!value || strlen(value) >= capacity)
        complain(place, key, "a short text");
    else
        strcpy(text, value);
}

static double get_number(struct place *place, const json_t *object, const char *key, double low,
                         double high)
{
    const json_t *value = json_object_get(object, key);
    double number = json_number_value(value);
    if (!json_is_number(value) || !(number >= low && number <= high)) {
        char expected[80];
        snprintf(expected, sizeof expected, "a number from %g to %g", low, high);
        complain(place, key, expected);
        return low; /* callers convert it before they look whether anything failed */
    }
    return number;
}

static void get_phrase(struct place *place, const json_t *object, const char *key,
                       struct message *phrase)
{
    const json_t *value = json_object_get(object, key);
    if (!json_is_object(value)) {
        complain(place, key, "an object with the texts \"en\" and \"es\"");
        return;
    }
    get_text(place, value, "en", phrase->en, sizeof phrase->en);
    get_text(place, value, "es", phrase->es, sizeof phrase->es);
    if (!phrase->en[0] || !phrase->es[0])
        complain(place, key, "texts in both languages that are not empty");
}

static int columns_of(const char *text)
{
    int columns = 0;
    for (; *text; text++)
        columns += (*text & 0xC0) != 0x80; /* not in the middle of a UTF-8 character */
    return columns;
}

/* What is longer a terminal of 80 columns would cut (report/terminal.c). */
static void get_title(struct place *place, const json_t *object, int most_columns,
                      struct message *title)
{
    char expected[80];
    get_phrase(place, object, "title", title);
    snprintf(expected, sizeof expected, "at most %d columns, which is what a terminal shows",
             most_columns);
    if (columns_of(title->en) > most_columns || columns_of(title->es) > most_columns)
        complain(place, "title", expected);
}

/* Lower case, digits and dashes: what stands in paths, options and `fails:` lines. */
static bool is_slug(const char *name)
{
    return *name && *name != '-' &&
           name[strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789-")] == '\0';
}

/* Every key must be among `known`, a list of words with a space around each. */
static void refuse_unknown_keys(struct place *place, json_t *object, const char *known)
{
    const char *key;
    json_t *value;
    json_object_foreach(object, key, value)
    {
        char word[80];
        snprintf(word, sizeof word, " %.70s ", key);
        if (!strstr(known, word))
            complain(place, key, "no such key; remove it or correct its name");
    }
}

/* ------------------------------------------------------------------- parts */

/* The names stand in the build's shell script: nothing but C's identifiers may. */
static bool is_identifier(const char *name)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
    return *name && strchr(letters, *name) &&
           name[strspn(name, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789")] ==
               '\0';
}

/* A list of at most `most` functions. Returns how many they are. */
static int read_names(struct place *place, const json_t *root, const char *key, int most,
                      char names[][EXERCISE_NAME])
{
    const json_t *list = json_object_get(root, key);
    size_t count = json_array_size(list);
    char expected[80];
    snprintf(expected, sizeof expected, "a list of 1 to %d function names", most);
    if (count < 1 || count > (size_t)most) {
        complain(place, key, expected);
        return 0;
    }
    for (size_t i = 0; i < count; i++) {
        const char *name = json_string_value(json_array_get(list, i));
        if (!name || strlen(name) >= EXERCISE_NAME || !is_identifier(name))
            complain(place, key, "names of functions");
        else
            strcpy(names[i], name);
    }
    return (int)count;
}

static void read_functions(struct place *place, const json_t *root, struct exercise *exercise)
{
    exercise->function_count =
        read_names(place, root, "functions", EXERCISE_FUNCTIONS, exercise->functions);
    if (!json_object_get(root, "given"))
        return;
    exercise->given_count = read_names(place, root, "given", EXERCISE_GIVEN, exercise->given);
    for (int g = 0; g < exercise->given_count; g++)
        for (int f = 0; f < exercise->function_count; f++)
            if (strcmp(exercise->given[g], exercise->functions[f]) == 0)
                complain(place, "given", "functions that are not the student's to write");
}

static void read_classes(struct place *place, const json_t *root, struct exercise *exercise)
{
    json_t *classes = json_object_get(root, "classes");
    size_t count = json_array_size(classes);
    if (count < 1 || count > EXERCISE_CLASSES) {
        complain(place, "classes", "a list of 1 to 24 classes");
        return;
    }
    for (size_t i = 0; i < count; i++) {
        json_t *entry = json_array_get(classes, i);
        struct exercise_class *class = &exercise->classes[exercise->class_count++];
        refuse_unknown_keys(place, entry, " name title points ");
        get_text(place, entry, "name", class->name, sizeof class->name);
        get_title(place, entry, CLASS_COLUMNS, &class->title);
        if (!is_slug(class->name))
            complain(place, "classes", "names of small letters, digits and dashes");
        for (size_t k = 0; k < i; k++)
            if (strcmp(exercise->classes[k].name, class->name) == 0)
                complain(place, "classes", "each name once");
        class->points = get_number(place, entry, "points", 0, 10);
        exercise->max_score += class->points;
    }
}

static json_t *read_check(struct place *place, const json_t *root, struct exercise *exercise,
                          enum check_kind check, const char *known)
{
    json_t *entry = json_object_get(root, check_name(check));
    if (!entry)
        return NULL;
    if (!json_is_object(entry)) {
        complain(place, check_name(check), "an object with \"points\"");
        return NULL;
    }
    refuse_unknown_keys(place, entry, known);
    exercise->checked[check] = true;
    exercise->check_points[check] = get_number(place, entry, "points", 0, 10);
    exercise->max_score += exercise->check_points[check];
    return entry;
}

/* What queries are held to, when they are measured apart. */
static void read_query_checks(struct place *place, const json_t *root, struct exercise *exercise)
{
    json_t *growth = read_check(place, root, exercise, CHECK_QUERY_GROWTH, " points allowed ");
    json_t *work = read_check(place, root, exercise, CHECK_QUERY_WORK, " points band ");
    json_t *memory = read_check(place, root, exercise, CHECK_QUERY_MEMORY, " points band ");
    if (growth)
        get_text(place, growth, "allowed", exercise->growth_allowed[PART_QUERY],
                 sizeof exercise->growth_allowed[PART_QUERY]);
    if (work)
        exercise->work_band[PART_QUERY] = get_number(place, work, "band", 1, 1e6);
    if (memory)
        exercise->memory_band[PART_QUERY] = get_number(place, memory, "band", 1, 1e6);
    if ((work || memory) && !growth)
        complain(place, "query-work", "\"query-growth\" too: all are measured at its sizes");
    if (growth && !exercise->checked[CHECK_GROWTH])
        complain(place, "query-growth", "\"growth\" too: of what is built before the queries");
}

static void read_checks(struct place *place, const json_t *root, struct exercise *exercise)
{
    json_t *growth = read_check(place, root, exercise, CHECK_GROWTH,
                                " points allowed elements first_size doublings ");
    if (growth) {
        get_text(place, growth, "allowed", exercise->growth_allowed[PART_BUILD],
                 sizeof exercise->growth_allowed[PART_BUILD]);
        get_phrase(place, growth, "elements", &exercise->growth_elements);
        exercise->growth_first_size = (int64_t)get_number(place, growth, "first_size", 1, 1e6);
        exercise->growth_doublings = (int)get_number(place, growth, "doublings", 4, 12);
    }
    json_t *work = read_check(place, root, exercise, CHECK_WORK, " points band ");
    if (work)
        exercise->work_band[PART_BUILD] = get_number(place, work, "band", 1, 1e6);
    json_t *memory = read_check(place, root, exercise, CHECK_MEMORY, " points band ");
    if (memory)
        exercise->memory_band[PART_BUILD] = get_number(place, memory, "band", 1, 1e6);
    json_t *accesses = read_check(place, root, exercise, CHECK_ACCESSES, " points band ");
    if (accesses)
        exercise->access_band = get_number(place, accesses, "band", 1, 1e6);
    if (accesses && exercise->given_count == 0)
        complain(place, "accesses", "\"given\" too: what is counted is calls of given functions");
    if ((work || memory || accesses) && !growth)
        complain(place, work || memory ? "work" : "accesses",
                 "\"growth\" too: all of these are measured at its sizes");
    read_query_checks(place, root, exercise);
    read_check(place, root, exercise, CHECK_LEAK, " points ");
    read_check(place, root, exercise, CHECK_UNDEFINED_BEHAVIOUR, " points ");
    read_check(place, root, exercise, CHECK_ALLOCATION_FAILURE, " points ");
}

static void read_root(struct place *place, json_t *root, struct exercise *exercise)
{
    refuse_unknown_keys(
        place, root,
        " name group order problem title functions given classes growth work query-growth "
        "query-work query-memory accesses memory leak undefined-behaviour allocation-failure "
        "limits ");
    get_text(place, root, "name", exercise->name, sizeof exercise->name);
    get_text(place, root, "group", exercise->group, sizeof exercise->group);
    get_text(place, root, "problem", exercise->problem, sizeof exercise->problem);
    get_title(place, root, TITLE_COLUMNS - columns_of(exercise->problem), &exercise->title);
    exercise->order = (int)get_number(place, root, "order", 0, 1e6);
    read_functions(place, root, exercise);
    read_classes(place, root, exercise);
    read_checks(place, root, exercise);
    json_t *limits = json_object_get(root, "limits");
    exercise->memory_limit_bytes = (int64_t)256 << 20;
    if (limits) {
        refuse_unknown_keys(place, limits, " memory_megabytes ");
        exercise->memory_limit_bytes =
            (int64_t)get_number(place, limits, "memory_megabytes", 1, 4096) << 20;
    }
}

static void check_points_sum(struct place *place, const struct exercise *exercise)
{
    char expected[80];
    snprintf(expected, sizeof expected, "%g in all classes and checks together, not %g", POINTS,
             exercise->max_score);
    if (fabs(exercise->max_score - POINTS) > 1e-9)
        complain(place, "points", expected);
}

static void check_folder(struct place *place, const struct exercise *exercise)
{
    char folder[PATH_MAX];
    snprintf(folder, sizeof folder, "%s", exercise->folder);
    char *name = strrchr(folder, '/');
    if (strcmp(name ? name + 1 : folder, exercise->name) != 0)
        complain(place, "name", "the name of the folder");
    if (!name)
        return;
    *name = '\0';
    char *group = strrchr(folder, '/');
    if (strcmp(group ? group + 1 : folder, exercise->group) != 0)
        complain(place, "group", "the name of the folder above");
}

int exercise_parse(const char *text, size_t count, const char *path, struct exercise *exercise,
                   struct error *err)
{
    json_error_t problem;
    memset(exercise, 0, sizeof *exercise);
    snprintf(exercise->folder, sizeof exercise->folder, "%s", path);
    char *slash = strrchr(exercise->folder, '/');
    if (!slash)
        return error_set(err, "%s: is in no folder", path);
    *slash = '\0';
    json_auto_t *root = json_loadb(text, count, JSON_REJECT_DUPLICATES, &problem);
    if (!root)
        return error_set(err, "%s:%d: %s", path, problem.line, problem.text);
    struct place place = {.file = path, .err = err};
    read_root(&place, root, exercise);
    check_points_sum(&place, exercise);
    check_folder(&place, exercise);
    return place.failed ? -1 : 0;
}

int exercise_read(const char *folder, struct exercise *exercise, struct error *err)
{
    char path[PATH_MAX], *text;
    size_t count;
    if (snprintf(path, sizeof path, "%s/exercise.json", folder) >= (int)sizeof path)
        return error_set(err, "%s: the path is too long", folder);
    if (file_read(path, FILE_LIMIT_BYTES, &text, &count, err) != 0)
        return -1;
    int result = exercise_parse(text, count, path, exercise, err);
    free(text);
    return result;
}

static int by_order(const void *a, const void *b)
{
    const struct exercise *x = a, *y = b;
    return x->order != y->order ? (x->order > y->order) - (x->order < y->order)
                                : strcmp(x->name, y->name);
}

/* A growing list of exercises. */
struct shelf {
    struct exercise *list;
    int count;
};

static int add_exercise(struct shelf *shelf, const char *folder, struct error *err)
{
    struct exercise *larger = realloc(shelf->list, (size_t)(shelf->count + 1) * sizeof *larger);
    if (!larger)
        return error_set(err, "out of memory");
    shelf->list = larger;
    if (exercise_read(folder, &shelf->list[shelf->count], err) != 0)
        return -1;
    shelf->count++;
    return 0;
}

/* Adds those folders of a group that hold an exercise.json. */
static int add_group(struct shelf *shelf, const char *group, struct error *err)
{
    char **names = listing_folders(group, err);
    int result = names ? 0 : -1;
    for (size_t i = 0; result == 0 && names[i]; i++) {
        char folder[PATH_MAX], manifest[PATH_MAX];
        if (file_path(folder, err, "%s/%s", group, names[i]) != 0 ||
            file_path(manifest, err, "%s/exercise.json", folder) != 0)
            result = -1;
        else if (access(manifest, F_OK) == 0)
            result = add_exercise(shelf, folder, err);
    }
    free(names);
    return result;
}

/* Names go through paths and pages alone, so each stands in one group; `order` sorts every list. */
static int check_shelf(const struct shelf *shelf, struct error *err)
{
    for (int i = 0; i < shelf->count; i++)
        for (int k = 0; k < i; k++) {
            const struct exercise *one = &shelf->list[k], *other = &shelf->list[i];
            if (strcmp(one->name, other->name) == 0)
                return error_set(err,
                                 "%s/exercise.json: name: group %s has an exercise of that "
                                 "name; rename one",
                                 other->folder, one->group);
            if (one->order == other->order)
                return error_set(err, "%s/exercise.json: order: %d is that of %s; choose another",
                                 other->folder, other->order, one->name);
        }
    return 0;
}

int exercises_read(const char *root, struct exercise **exercises, int *count, struct error *err)
{
    char folder[PATH_MAX], group[PATH_MAX];
    struct shelf shelf = {NULL, 0};
    if (file_path(folder, err, "%s/exercises", root) != 0)
        return -1;
    char **groups = listing_folders(folder, err);
    int result = groups ? 0 : -1;
    for (size_t i = 0; result == 0 && groups[i]; i++) {
        result = file_path(group, err, "%s/%s", folder, groups[i]);
        if (result == 0)
            result = add_group(&shelf, group, err);
    }
    free(groups);
    if (result == 0 && !shelf.list) {
        error_set(err, "%s: no exercise found (GROUP/NAME/exercise.json)", folder);
        result = -1;
    }
    if (result == 0)
        result = check_shelf(&shelf, err);
    if (result == 0) {
        qsort(shelf.list, (size_t)shelf.count, sizeof *shelf.list, by_order);
        *exercises = shelf.list;
        *count = shelf.count;
    } else {
        free(shelf.list);
    }
    return result;
}

const struct exercise *exercise_find(const struct exercise *exercises, int count, const char *name)
{
    for (int i = 0; i < count; i++)
        if (strcmp(exercises[i].name, name) == 0)
            return &exercises[i];
    return NULL;
}
