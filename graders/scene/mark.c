/* Keeping marks and labels; see mark.h. */
#include "graders/scene/scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const int32_t *mark_vertices(const struct mark *mark)
{
    return mark->list ? mark->list : mark->vertex;
}

/* ------------------------------------------------------------------------------------- thinning */

/* Scatters ordinals, so that a sample of them follows no row of a regular mesh; 0 stays 0. */
static uint32_t scattered(int64_t ordinal)
{
    uint64_t h = (uint64_t)ordinal;
    h = (h ^ h >> 32) * 0x9e3779b97f4a7c15U;
    h = (h ^ h >> 29) * 0xbf58476d1ce4e5b9U;
    return (uint32_t)(h >> 32);
}

static bool is_sampled(const struct scene *scene, const struct mark *mark)
{
    uint32_t one_in = 1U << scene->sampling[mark->kind];
    return (scattered(mark->ordinal) & (one_in - 1)) == 0;
}

static void drop(struct scene *scene, struct mark *mark)
{
    if (mark->list)
        scene->listed_vertex_count -= mark->count;
    free(mark->list);
}

/* Makes room: drops about half of the marks of the kind that has most. */
static void thin_out_marks(struct scene *scene)
{
    int kept[MARK_KINDS] = {0}, most = 0, count = 0;
    for (int m = 0; m < scene->kept_mark_count; m++)
        kept[scene->marks[m].kind]++;
    for (int kind = 1; kind < MARK_KINDS; kind++)
        most = kept[kind] > kept[most] ? kind : most;
    scene->sampling[most]++;
    for (int m = 0; m < scene->kept_mark_count; m++)
        if (is_sampled(scene, &scene->marks[m]))
            scene->marks[count++] = scene->marks[m];
        else
            drop(scene, &scene->marks[m]);
    scene->kept_mark_count = count;
}

/* -------------------------------------------------------------------------------------- keeping */

/* Copies `count` vertices into a mark that starts zeroed, beginning with number `first` and going
 * round; false when that cannot be kept. */
static bool copy_vertices(struct scene *scene, struct mark *mark, const int32_t *vertices,
                          int64_t count, int64_t first)
{
    int32_t *to = mark->vertex;
    if (count > 3) {
        if (scene->listed_vertex_count + count > SCENE_PATH_LIMIT_ALL)
            return false;
        to = mark->list = malloc((size_t)count * sizeof *to);
        if (!to)
            return false;
        scene->listed_vertex_count += count;
    }
    for (int64_t i = 0; i < count; i++)
        to[i] = vertices[(first + i) % count];
    mark->count = (int32_t)count;
    return true;
}

static bool all_named(const int32_t *vertices, int64_t count)
{
    for (int64_t i = 0; i < count; i++)
        if (vertices[i] < 0)
            return false;
    return true;
}

/* Counts a mark, and keeps it when it can be drawn and there is room. */
static void add_mark(struct scene *scene, enum mark_kind kind, enum element_kind element,
                     const int32_t *vertices, int64_t count, int64_t first)
{
    struct mark mark = {.kind = kind, .element = element, .ordinal = scene->mark_count[kind]++};
    if (!vertices || count < 1 || count > SCENE_PATH_LIMIT || !all_named(vertices, count))
        return;
    if (!scene->marks)
        scene->marks = calloc(SCENE_MARK_LIMIT, sizeof *scene->marks);
    if (!scene->marks)
        return;
    while (scene->kept_mark_count == SCENE_MARK_LIMIT && is_sampled(scene, &mark))
        thin_out_marks(scene);
    if (is_sampled(scene, &mark) && copy_vertices(scene, &mark, vertices, count, first))
        scene->marks[scene->kept_mark_count++] = mark;
}

void scene_mark_vertex(struct scene *scene, enum mark_kind kind, int32_t vertex)
{
    add_mark(scene, kind, ELEMENT_VERTEX, &vertex, 1, 0);
}

void scene_mark_edge(struct scene *scene, enum mark_kind kind, int32_t a, int32_t b)
{
    add_mark(scene, kind, ELEMENT_EDGE, (const int32_t[]){a, b}, 2, 0);
}

void scene_mark_triangle(struct scene *scene, enum mark_kind kind, int32_t a, int32_t b, int32_t c)
{
    add_mark(scene, kind, ELEMENT_TRIANGLE, (const int32_t[]){a, b, c}, 3, 0);
}

void scene_mark_arrow(struct scene *scene, enum mark_kind kind, int32_t a, int32_t b)
{
    add_mark(scene, kind, ELEMENT_ARROW, (const int32_t[]){a, b}, 2, 0);
}

void scene_mark_half_edge(struct scene *scene, enum mark_kind kind, const int32_t *corners,
                          int64_t count, int64_t side)
{
    bool sound = count >= 3 && side >= 0 && side < count;
    add_mark(scene, kind, ELEMENT_HALF_EDGE, corners, sound ? count : 0, side);
}

void scene_mark_path(struct scene *scene, enum mark_kind kind, const int32_t *vertices,
                     int64_t count, bool closed)
{
    bool too_long = count > SCENE_PATH_LIMIT;
    add_mark(scene, kind, closed && !too_long ? ELEMENT_LOOP : ELEMENT_PATH, vertices,
             too_long ? SCENE_PATH_LIMIT : count, 0);
}

void scene_mark_face(struct scene *scene, enum mark_kind kind, const int32_t *corners,
                     int64_t count)
{
    if (corners && count == 3)
        scene_mark_triangle(scene, kind, corners[0], corners[1], corners[2]);
    else
        add_mark(scene, kind, ELEMENT_FACE, corners, count < 3 ? 0 : count, 0);
}

/* --------------------------------------------------------------------------- labels and names */

static void add_label(struct scene *scene, enum element_kind element, const int32_t *vertices,
                      int64_t count, int64_t number)
{
    struct label label = {.at = {.element = element}, .number = number};
    if (scene->label_count == SCENE_LABEL_LIMIT || !vertices || count < 1 ||
        count > SCENE_PATH_LIMIT || !all_named(vertices, count))
        return;
    if (!scene->labels)
        scene->labels = calloc(SCENE_LABEL_LIMIT, sizeof *scene->labels);
    if (scene->labels && copy_vertices(scene, &label.at, vertices, count, 0))
        scene->labels[scene->label_count++] = label;
}

void scene_label_vertex(struct scene *scene, int32_t vertex, int64_t number)
{
    add_label(scene, ELEMENT_VERTEX, &vertex, 1, number);
}

void scene_label_edge(struct scene *scene, int32_t a, int32_t b, int64_t number)
{
    add_label(scene, ELEMENT_EDGE, (const int32_t[]){a, b}, 2, number);
}

void scene_label_face(struct scene *scene, const int32_t *corners, int64_t count, int64_t number)
{
    add_label(scene, ELEMENT_FACE, corners, count < 3 ? 0 : count, number);
}

void scene_set_text(struct scene_text *text, struct phrase phrase)
{
    snprintf(text->en, sizeof text->en, "%s", phrase.en ? phrase.en : "");
    snprintf(text->es, sizeof text->es, "%s", phrase.es ? phrase.es : "");
}

void scene_name_marks(struct scene *scene, enum mark_kind kind, struct phrase name)
{
    scene_set_text(&scene->mark_names[kind], name);
}

void scene_name_turns(struct scene *scene, struct phrase name, int64_t count)
{
    scene_set_text(&scene->turn_name, name);
    scene->turn_count = count;
}
