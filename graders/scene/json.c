/* Scenes as JSON; the format stands in graders/render/README.md. */
#include "graders/scene/cut.h"
#include "graders/scene/polygon.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "scenes hold little-endian numbers");

enum { STRIP_VERTEX_LIMIT = 300000, VOXELS_PER_SIDE_SHOWN = 128 };

static const char *const mark_names[MARK_KINDS] = {
    "missing", "duplicate", "extra",  "degenerate", "boundary", "flipped", "wrong",
    "right",   "turn-0",    "turn-1", "turn-2",     "turn-3",   "turn-4",  "turn-5"};
static const char *const element_names[ELEMENT_KINDS] = {"vertex",    "edge", "triangle", "arrow",
                                                         "half-edge", "path", "loop",     "face"};

/* Bytes as a JSON string in base64; NULL when out of memory. */
static json_t *json_base64(const void *data, size_t count)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const uint8_t *bytes = data;
    size_t length = (count + 2) / 3 * 4;
    char *text = malloc(length + 1);
    if (!text)
        return NULL;
    for (size_t i = 0, out = 0; i < count; i += 3, out += 4) {
        size_t left = count - i;
        uint32_t group = (uint32_t)bytes[i] << 16 | (left > 1 ? (uint32_t)bytes[i + 1] << 8 : 0) |
                         (left > 2 ? (uint32_t)bytes[i + 2] : 0);
        text[out] = digits[group >> 18];
        text[out + 1] = digits[group >> 12 & 63];
        text[out + 2] = '=';
        text[out + 3] = '=';
        if (left > 1)
            text[out + 2] = digits[group >> 6 & 63];
        if (left > 2)
            text[out + 3] = digits[group & 63];
    }
    json_t *json = json_stringn_nocheck(text, length);
    free(text);
    return json;
}

static json_t *mesh_to_json(const struct mesh *mesh)
{
    size_t positions = 3 * sizeof(float) * (size_t)mesh->vertex_count;
    size_t triangles = 3 * sizeof(int32_t) * (size_t)mesh->triangle_count;
    return json_pack("{s:i, s:i, s:o, s:o}", "vertex_count", (int)mesh->vertex_count,
                     "triangle_count", (int)mesh->triangle_count, "positions",
                     json_base64(mesh->positions, positions), "triangles",
                     json_base64(mesh->triangles, triangles));
}

static json_t *vertices_to_json(const struct mark *mark)
{
    json_t *vertices = json_array();
    for (int32_t i = 0; vertices && i < mark->count; i++)
        json_array_append_new(vertices, json_integer(mark_vertices(mark)[i]));
    return vertices;
}

/* The triangles that fill a face of more than three corners; NULL for what needs none. */
static json_t *fill_to_json(const struct scene *scene, const struct mark *mark)
{
    size_t corners = (size_t)mark->count;
    if (mark->element != ELEMENT_FACE || mark->count <= 3)
        return NULL;
    int32_t *triangles = malloc((4 * corners) * sizeof *triangles);
    json_t *fill = triangles ? json_array() : NULL;
    if (triangles)
        polygon_triangles(scene->mesh.positions, mark_vertices(mark), mark->count,
                          triangles + 3 * corners, triangles);
    for (size_t i = 0; fill && i < 3 * (corners - 2); i++)
        json_array_append_new(fill, json_integer(triangles[i]));
    free(triangles);
    return fill;
}

static json_t *mark_to_json(const struct scene *scene, const struct mark *mark)
{
    return json_pack("{s:s, s:s, s:o, s:o*}", "kind", mark_names[mark->kind], "element",
                     element_names[mark->element], "vertex", vertices_to_json(mark), "fill",
                     fill_to_json(scene, mark));
}

/* The marks that fit into the mesh. */
static json_t *marks_to_json(const struct scene *scene)
{
    json_t *marks = json_array();
    for (int m = 0; marks && m < scene->kept_mark_count; m++)
        if (scene_mark_fits(scene, &scene->marks[m]))
            json_array_append_new(marks, mark_to_json(scene, &scene->marks[m]));
    return marks;
}

static json_t *labels_to_json(const struct scene *scene)
{
    json_t *labels = json_array();
    for (int l = 0; labels && l < scene->label_count; l++) {
        const struct label *label = &scene->labels[l];
        if (scene_mark_fits(scene, &label->at))
            json_array_append_new(labels, json_pack("{s:s, s:o, s:o*, s:I}", "element",
                                                    element_names[label->at.element], "vertex",
                                                    vertices_to_json(&label->at), "fill",
                                                    fill_to_json(scene, &label->at), "number",
                                                    (json_int_t)label->number));
    }
    return labels;
}

/* Polygons as the numbers of their corners, and all corners. */
static json_t *faces_to_json(const struct scene_faces *faces)
{
    size_t count = (size_t)faces->count, corners = (size_t)faces->first_corner[faces->count];
    int32_t *sizes = malloc((count + 1) * sizeof *sizes);
    if (!sizes)
        return NULL;
    for (size_t f = 0; f < count; f++)
        sizes[f] = faces->first_corner[f + 1] - faces->first_corner[f];
    json_t *json =
        json_pack("{s:i, s:i, s:o, s:o}", "face_count", (int)count, "corner_count", (int)corners,
                  "sizes", json_base64(sizes, count * sizeof *sizes), "corners",
                  json_base64(faces->corners, corners * sizeof *faces->corners));
    free(sizes);
    return json;
}

/* A text that may not be UTF-8 as JSON: then as "?". */
static json_t *text_to_json(const char *text)
{
    json_t *json = json_string(text);
    return json ? json : json_string("?");
}

static json_t *both_to_json(const struct scene_text *text)
{
    return json_pack("{s:o, s:o}", "en", text_to_json(text->en), "es", text_to_json(text->es));
}

/* Adds "values" and "groups". */
static int add_values(json_t *json, const struct scene *shown)
{
    const struct scene_values *values = &shown->values;
    int failed = 0;
    if (values->numbers) {
        json_t *one = json_pack(
            "{s:s, s:o, s:f, s:f, s:o}", "of",
            values->part == SCENE_PER_VERTEX ? "vertex" : "triangle", "numbers",
            json_base64(values->numbers, (size_t)values->count * sizeof *values->numbers), "low",
            values->low, "high", values->high, "unit", both_to_json(&values->unit));
        if (one && isfinite(values->worst))
            failed |= json_object_set_new(one, "worst", json_real(values->worst));
        failed |= json_object_set_new(json, "values", one);
    }
    if (shown->groups)
        failed |= json_object_set_new(
            json, "groups", json_base64(shown->groups, (size_t)shown->mesh.triangle_count));
    return failed;
}

static int add_vectors(json_t *json, const struct scene *shown)
{
    json_t *sets = json_array();
    size_t bytes = 3 * sizeof(float) * (size_t)shown->mesh.vertex_count;
    int failed = sets ? 0 : -1;
    for (int i = 0; i < shown->vector_set_count; i++)
        failed |= json_array_append_new(sets, json_pack("{s:s, s:o}", "kind",
                                                        mark_names[shown->vectors[i].kind], "xyz",
                                                        json_base64(shown->vectors[i].xyz, bytes)));
    return failed | json_object_set_new(json, "vectors", sets);
}

/* Adds "mesh" and what lies on it, and "cut"; what there is none of is left out. */
static int add_mesh(json_t *json, const struct scene *scene)
{
    struct scene cut = {0};
    bool is_cut = scene_needs_cut(scene);
    if (is_cut && scene_cut(scene, &cut, NULL))
        return -1;
    const struct scene *shown = is_cut ? &cut : scene;
    int failed = 0;
    if (shown->mesh.vertex_count > 0 || scene->kind == SCENE_MESH)
        failed |= json_object_set_new(json, "mesh", mesh_to_json(&shown->mesh));
    if (shown->faces.count > 0)
        failed |= json_object_set_new(json, "polygons", faces_to_json(&shown->faces));
    if (shown->kept_mark_count > 0)
        failed |= json_object_set_new(json, "marks", marks_to_json(shown));
    if (shown->label_count > 0)
        failed |= json_object_set_new(json, "labels", labels_to_json(shown));
    failed |= add_values(json, shown);
    if (shown->vector_set_count > 0)
        failed |= add_vectors(json, shown);
    if (is_cut)
        failed |= json_object_set_new(json, "cut", json_true());
    scene_release(&cut);
    return failed;
}

static int add_counts(json_t *json, const struct scene *scene)
{
    json_t *counts = json_object();
    if (!counts)
        return -1;
    int failed = 0;
    for (int kind = 0; kind < MARK_KINDS; kind++)
        if (scene->mark_count[kind] > 0)
            failed |= json_object_set_new(counts, mark_names[kind],
                                          json_integer(scene->mark_count[kind]));
    failed |= json_object_set_new(json, "mark_counts", counts);
    if (scene->ok_count > 0)
        failed |= json_object_set_new(json, "ok_count", json_integer(scene->ok_count));
    return failed;
}

/* What the legend calls the marks, where the scene says it. */
static int add_names(json_t *json, const struct scene *scene)
{
    json_t *names = json_object();
    int failed = names ? 0 : -1;
    for (int kind = 0; kind < MARK_KINDS; kind++)
        if (scene->mark_names[kind].en[0])
            failed |= json_object_set_new(names, mark_names[kind],
                                          both_to_json(&scene->mark_names[kind]));
    if (scene->turn_name.en[0]) {
        failed |= json_object_set_new(names, "turns", both_to_json(&scene->turn_name));
        failed |= json_object_set_new(json, "turn_count", json_integer(scene->turn_count));
    }
    if (!failed && json_object_size(names) > 0)
        return json_object_set_new(json, "mark_names", names);
    json_decref(names);
    return failed;
}

static int add_strips(json_t *json, const struct scene *scene)
{
    json_t *strips = json_array();
    if (!strips)
        return -1;
    int failed = 0;
    int64_t vertex_count = 0;
    int i = 0;
    for (; i < scene->strip_count; i++) {
        const struct strip *strip = &scene->strips[i];
        vertex_count += strip->vertex_count;
        if (vertex_count > STRIP_VERTEX_LIMIT)
            break;
        json_t *positions =
            json_base64(strip->positions, 3 * sizeof(float) * (size_t)strip->vertex_count);
        failed |= json_array_append_new(strips, json_pack("{s:i, s:o}", "vertex_count",
                                                          (int)strip->vertex_count, "positions",
                                                          positions));
    }
    if (i < scene->strip_count)
        failed |= json_object_set_new(json, "cut", json_true());
    return failed | json_object_set_new(json, "strips", strips);
}

static bool voxel(const struct scene *scene, size_t x, size_t y, size_t z)
{
    size_t side = (size_t)scene->voxels_per_side;
    size_t bit = x + side * (y + side * z);
    return scene->voxel_bits[bit / 8] >> bit % 8 & 1;
}

/* Voxels above the shown size are sampled at the centres of the shown cells. */
static int add_voxels(json_t *json, const struct scene *scene)
{
    size_t side = (size_t)scene->voxels_per_side;
    size_t shown = side > VOXELS_PER_SIDE_SHOWN ? VOXELS_PER_SIDE_SHOWN : side;
    size_t bytes = (shown * shown * shown + 7) / 8;
    uint8_t *bits = calloc(bytes, 1);
    if (!bits)
        return -1;
    for (size_t bit = 0; bit < shown * shown * shown; bit++) {
        size_t x = (2 * (bit % shown) + 1) * side / (2 * shown);
        size_t y = (2 * (bit / shown % shown) + 1) * side / (2 * shown);
        size_t z = (2 * (bit / shown / shown) + 1) * side / (2 * shown);
        if (voxel(scene, x, y, z))
            bits[bit / 8] = (uint8_t)(bits[bit / 8] | 1U << bit % 8);
    }
    json_t *voxels =
        json_pack("{s:i, s:o}", "per_side", (int)shown, "bits", json_base64(bits, bytes));
    free(bits);
    if (voxels && scene->wrong_voxel_bits && shown == side) {
        json_object_set_new(voxels, "wrong", json_base64(scene->wrong_voxel_bits, bytes));
        json_object_set_new(voxels, "named", json_integer(scene->named_voxel - 1));
    }
    return json_object_set_new(json, "voxels", voxels);
}

static int add_facts(json_t *json, const struct scene *scene)
{
    json_t *facts = json_array();
    for (int i = 0; facts && i < scene->fact_count; i++)
        json_array_append_new(facts, json_pack("{s:s, s:s}", "name", scene->facts[i].name, "value",
                                               scene->facts[i].value));
    return json_object_set_new(json, "facts", facts);
}

static json_t *numbers_to_json(const double *numbers, int count)
{
    json_t *array = json_array();
    for (int i = 0; array && i < count; i++)
        json_array_append_new(array, json_real(numbers[i]));
    return array;
}

static int add_chart(json_t *json, const struct scene *scene)
{
    json_t *curves = json_array();
    if (!curves)
        return -1;
    int failed = 0;
    for (int i = 0; i < scene->curve_count; i++) {
        const struct curve *curve = &scene->curves[i];
        json_t *one = json_pack("{s:o, s:o, s:o}", "name", text_to_json(curve->name), "x",
                                numbers_to_json(curve->x, curve->point_count), "y",
                                numbers_to_json(curve->y, curve->point_count));
        if (one && curve->exponent != 0)
            failed |= json_object_set_new(one, "exponent", json_real(curve->exponent));
        failed |= json_array_append_new(curves, one);
    }
    failed |= json_object_set_new(json, "curves", curves);
    failed |= json_object_set_new(json, "x_label", text_to_json(scene->x_label));
    return failed | json_object_set_new(json, "y_label", text_to_json(scene->y_label));
}

/* The answer's mesh: what a scene of a mesh has. */
static int add_answer(json_t *json, const struct scene *answer)
{
    json_t *one = json_object();
    if (!one)
        return -1;
    int failed = add_mesh(one, answer) | add_counts(one, answer) | add_names(one, answer);
    return failed | json_object_set_new(json, "answer", one);
}

json_t *scene_to_json(const struct scene *scene)
{
    static const char *const kind_names[] = {"none", "mesh", "strips", "voxels", "chart"};
    json_t *json = json_pack("{s:s}", "kind", kind_names[scene->kind]);
    if (!json)
        return NULL;
    int failed = 0;
    if (scene->kind >= SCENE_MESH && scene->kind <= SCENE_VOXELS)
        failed |= add_mesh(json, scene) | add_counts(json, scene) | add_names(json, scene);
    if (scene->kind == SCENE_MESH && scene->answer)
        failed |= add_answer(json, scene->answer);
    if (scene->fact_count > 0)
        failed |= add_facts(json, scene);
    if (scene->kind == SCENE_STRIPS)
        failed |= add_strips(json, scene);
    if (scene->kind == SCENE_VOXELS)
        failed |= add_voxels(json, scene);
    if (scene->kind == SCENE_CHART)
        failed |= add_chart(json, scene);
    if (failed) {
        json_decref(json);
        return NULL;
    }
    return json;
}
