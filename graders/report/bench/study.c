/* Reading a benchmark run; see study.h. */
#include "graders/report/bench/study.h"

#include "graders/report/clean.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS_MAX = 50000, DEPTH_MAX = 12 };

/* ---------------------------------------------------------------- reading */

static json_t *cleaned(json_t *value, int depth);

static json_t *cleaned_text(const json_t *text)
{
    char *clean =
        clean_text(json_string_value(text), json_string_length(text), CLEAN_LINE, STUDY_TEXT_BYTES);
    json_t *json = clean ? json_string(clean) : NULL;
    free(clean);
    return json;
}

static json_t *cleaned_object(json_t *value, int depth)
{
    json_t *object = json_object();
    const char *key;
    json_t *member;
    json_object_foreach(value, key, member)
    {
        json_object_set_new(object, key, cleaned(member, depth));
    }
    return object;
}

static json_t *cleaned_array(json_t *value, int depth)
{
    json_t *array = json_array();
    size_t i;
    json_t *element;
    json_array_foreach(value, i, element)
    {
        if (i < ROWS_MAX)
            json_array_append_new(array, cleaned(element, depth));
    }
    return array;
}

/* A copy in which every text is short and inert. */
static json_t *cleaned(json_t *value, int depth)
{
    if (depth == DEPTH_MAX)
        return json_null();
    if (json_is_string(value))
        return cleaned_text(value);
    if (json_is_object(value))
        return cleaned_object(value, depth + 1);
    return json_is_array(value) ? cleaned_array(value, depth + 1) : json_deep_copy(value);
}

int study_take(struct study *study, json_t *document, struct error *err)
{
    *study = (struct study){.document = document ? cleaned(document, 0) : NULL};
    json_decref(document);
    if (strcmp(study_text(study->document, "schema"), "meshgrade-bench-1") != 0)
        return error_set(err, "no results of a bench run: \"schema\" is not meshgrade-bench-1");
    study->rows = json_object_get(study->document, "rows");
    return 0;
}

void study_release(struct study *study)
{
    json_decref(study->document);
    *study = (struct study){0};
}

/* ---------------------------------------------------------------- values */

const char *study_text(const json_t *object, const char *key)
{
    const char *text = json_string_value(json_object_get(object, key));
    return text ? text : "";
}

double study_number(const json_t *object, const char *key)
{
    const json_t *value = json_object_get(object, key);
    double number = json_number_value(value);
    return json_is_number(value) && isfinite(number) ? number : (double)NAN;
}

double study_time(const json_t *row)
{
    double query = study_number(json_object_get(row, "ns_per_query"), "median");
    return isnan(query) ? study_number(json_object_get(row, "ns_per_triangle"), "median") : query;
}

bool study_is_decided(const json_t *ratio)
{
    return study_number(ratio, "confidence") >= STUDY_CONFIDENCE &&
           !json_is_true(json_object_get(ratio, "too_noisy"));
}

/* ---------------------------------------------------------------- rows */

static bool is(const json_t *row, const char *key, const char *value)
{
    return !value || strcmp(study_text(row, key), value) == 0;
}

bool study_matches(const json_t *row, const struct wanted *wanted)
{
    return is(row, "what", wanted->what) && is(row, "kind", wanted->kind) &&
           is(row, "subject", wanted->subject) && is(row, "variant", wanted->variant) &&
           is(row, "operation", wanted->operation) && is(row, "mesh", wanted->mesh) &&
           is(row, "mesh_kind", wanted->mesh_kind) && is(row, "order", wanted->order);
}

const json_t *study_find(const struct study *study, const struct wanted *wanted)
{
    size_t i;
    const json_t *row;
    json_array_foreach(study->rows, i, row)
    {
        if (study_matches(row, wanted))
            return row;
    }
    return NULL;
}

size_t study_count(const struct study *study, const struct wanted *wanted)
{
    size_t i, count = 0;
    const json_t *row;
    json_array_foreach(study->rows, i, row)
    {
        count += study_matches(row, wanted);
    }
    return count;
}

static bool is_real_model(const char *kind)
{
    static const char *const models[] = {"bunny", "horse", "mug"};
    for (size_t i = 0; i < sizeof models / sizeof *models; i++)
        if (strcmp(kind, models[i]) == 0)
            return true;
    return false;
}

/* How willingly the mesh of a row is shown, beside how much was measured on it. */
static double preference(const json_t *row)
{
    const double millions = study_number(row, "triangles") / 1e6;
    return (is_real_model(study_text(row, "mesh_kind")) ? 1000 : 0) +
           (isnan(millions) ? 0 : fmin(millions, 100)) +
           (strcmp(study_text(row, "order"), "generated") == 0 ? 0.001 : 0);
}

const char *study_mesh(const struct study *study, const struct wanted *wanted)
{
    const char *best = NULL;
    double best_preference = 0;
    size_t i, best_count = 0;
    const json_t *row;
    json_array_foreach(study->rows, i, row)
    {
        struct wanted here = *wanted;
        here.mesh = study_text(row, "mesh");
        if (!study_matches(row, &here) || !*here.mesh || (best && strcmp(here.mesh, best) == 0))
            continue;
        size_t count = study_count(study, &here);
        if (!best || count > best_count ||
            (count == best_count && preference(row) > best_preference)) {
            best = here.mesh;
            best_count = count;
            best_preference = preference(row);
        }
    }
    return best;
}

size_t study_names(const struct study *study, const struct wanted *wanted, const char *key,
                   const char *names[STUDY_NAMES_MAX])
{
    size_t i, count = 0;
    const json_t *row;
    json_array_foreach(study->rows, i, row)
    {
        const char *name = study_text(row, key);
        bool is_new = *name && study_matches(row, wanted);
        for (size_t k = 0; k < count && is_new; k++)
            is_new = strcmp(names[k], name) != 0;
        if (is_new && count < STUDY_NAMES_MAX)
            names[count++] = name;
    }
    return count;
}

/* ---------------------------------------------------------------- words */

const char *const study_operations[] = {
    "build",           "transform",      "area",   "face-normals",        "vertex-normals",
    "edges",           "boundary-loops", "smooth", "faces-around-vertex", "vertices-around-vertex",
    "face-neighbours", "is-edge",        NULL};

bool study_is_query(const char *operation)
{
    static const char *const queries[] = {"faces-around-vertex", "vertices-around-vertex",
                                          "face-neighbours", "is-edge"};
    for (size_t i = 0; i < sizeof queries / sizeof *queries; i++)
        if (strcmp(operation, queries[i]) == 0)
            return true;
    return false;
}

struct operation_words {
    const char *name, *words, *short_words;
};

static const struct operation_words *words_of(const char *operation)
{
    static const struct operation_words words[] = {
        {"bytes", "size", "size"},
        {"build", "build from an indexed mesh", "build"},
        {"transform", "transform all vertices", "move all"},
        {"area", "area", "area"},
        {"face-normals", "face normals", "face normals"},
        {"vertex-normals", "vertex normals", "vertex normals"},
        {"edges", "all edges once", "all edges"},
        {"boundary-loops", "boundary loops", "holes' loops"},
        {"smooth", "one smoothing step", "smooth"},
        {"faces-around-vertex", "faces around a vertex", "faces of a vertex"},
        {"vertices-around-vertex", "vertices around a vertex", "vertices of a vertex"},
        {"face-neighbours", "neighbours of a face", "faces of a face"},
        {"is-edge", "is (u,v) an edge", "is (u,v) an edge"},
        {"edges-closed", "edge table, coherent closed mesh", "edges, closed"},
        {"edges-any", "edge table, any orientation", "edges, any"},
        {"twins", "twins of half edges", "twins"},
        {"stripify", "strips of any mesh", "strips"},
        {"strips-in-order", "strips of the triangles in their order", "strips, in order"},
        {"vertex-cache", "order for the vertex cache", "cache order"},
        {"vertex-fetch", "order of first use of vertices", "fetch order"},
        {"read-ply-binary", "reading binary PLY", "binary PLY"},
        {"read-ply-ascii", "reading ASCII PLY", "ASCII PLY"},
        {"read-obj", "reading OBJ", "OBJ"},
        {"read-off", "reading OFF", "OFF"}};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(words[i].name, operation) == 0)
            return &words[i];
    return NULL;
}

const char *study_operation(const char *operation)
{
    const struct operation_words *found = words_of(operation);
    return found ? found->words : operation;
}

const char *study_operation_short(const char *operation)
{
    const struct operation_words *found = words_of(operation);
    return found ? found->short_words : operation;
}

const char *study_title(const struct study *study, const char *what, const char *subject)
{
    const json_t *row = study_find(study, &(struct wanted){.what = what, .subject = subject});
    const char *title = study_text(row, "title");
    return *title ? title : subject;
}

void study_mesh_words(const char *mesh, char *text, size_t capacity)
{
    const char *order = strrchr(mesh, '-');
    const char *size = order;
    while (size && size > mesh && size[-1] != '-')
        size--;
    if (!order || size <= mesh + 1) {
        snprintf(text, capacity, "%s", mesh);
        return;
    }
    snprintf(text, capacity, "%.*s (%.*s triangles, %s)", (int)(size - 1 - mesh), mesh,
             (int)(order - size), size,
             strcmp(order + 1, "cache") == 0       ? "in cache order"
             : strcmp(order + 1, "generated") == 0 ? "in its own order"
                                                   : order + 1);
}

static void three_digits(double number, const char *unit, char *text, size_t capacity)
{
    int decimals = number >= 99.95 ? 0 : number >= 9.995 ? 1 : 2;
    snprintf(text, capacity, "%.*f%s", decimals, number, unit);
}

void study_time_words(double ns, char *text, size_t capacity)
{
    static const char *const units[] = {" ns", " µs", " ms", " s"};
    int unit = 0;
    if (isnan(ns)) {
        snprintf(text, capacity, "–");
        return;
    }
    for (; ns >= 999.5 && unit < 3; unit++)
        ns /= 1000;
    three_digits(ns, units[unit], text, capacity);
}

void study_number_words(double number, char *text, size_t capacity)
{
    static const char *const units[] = {"", "k", "M", "G"};
    int unit = 0;
    if (isnan(number)) {
        snprintf(text, capacity, "–");
        return;
    }
    for (; number >= 999.5 && unit < 3; unit++)
        number /= 1000;
    three_digits(number, units[unit], text, capacity);
}
