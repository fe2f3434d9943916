/* Breadth-first growth from the marked vertices; see scene_cut.h. */
#include "graders/scene/cut.h"
#include "graders/scene/polygon.h"

#include <stdlib.h>
#include <string.h>

/* A mesh with its triangles by vertex, and what of it has been reached. */
struct growth {
    const struct mesh *mesh;
    int32_t *first;    /* triangles of vertex v: incident[first[v] ... first[v + 1] - 1] */
    int32_t *incident; /* 3 * triangle_count */
    int32_t *number;   /* of a vertex in the cut, -1: not reached */
    int32_t *reached;  /* vertices in the order of their numbers; the queue */
    int32_t reached_count;
    bool *taken;
    int32_t *triangles; /* kept ones, in the old numbering's indices into the table */
    int32_t triangle_count;
    const struct scene_faces *polygons;
    int32_t *faces; /* kept polygons, likewise */
    int32_t face_count;
};

bool scene_needs_cut(const struct scene *scene)
{
    return scene->mesh.triangle_count > SCENE_TRIANGLE_LIMIT ||
           scene->mesh.vertex_count > SCENE_VERTEX_LIMIT;
}

bool scene_mark_fits(const struct scene *scene, const struct mark *mark)
{
    const int32_t *vertices = mark_vertices(mark);
    for (int32_t i = 0; i < mark->count; i++)
        if (vertices[i] < 0 || vertices[i] >= scene->mesh.vertex_count)
            return false;
    return true;
}

static void growth_release(struct growth *growth)
{
    free(growth->first);
    free(growth->incident);
    free(growth->number);
    free(growth->reached);
    free(growth->taken);
    free(growth->triangles);
    free(growth->faces);
}

static int growth_init(struct growth *growth, const struct scene *scene, struct error *err)
{
    const struct mesh *mesh = &scene->mesh;
    size_t vertices = (size_t)mesh->vertex_count;
    size_t triangles = (size_t)mesh->triangle_count;
    *growth = (struct growth){.mesh = mesh,
                              .first = calloc(vertices + 2, sizeof(int32_t)),
                              .incident = malloc((3 * triangles + 1) * sizeof(int32_t)),
                              .number = malloc((vertices + 1) * sizeof(int32_t)),
                              .reached = malloc((vertices + 1) * sizeof(int32_t)),
                              .taken = calloc(triangles + 1, sizeof(bool)),
                              .triangles = malloc(SCENE_CUT_TRIANGLES * sizeof(int32_t)),
                              .polygons = &scene->faces,
                              .faces = malloc(SCENE_CUT_TRIANGLES * sizeof(int32_t))};
    if (growth->first && growth->incident && growth->number && growth->reached && growth->taken &&
        growth->triangles && growth->faces)
        return 0;
    growth_release(growth);
    error_set(err, "out of memory for cutting a mesh of %zu triangles", triangles);
    return -1;
}

/* Counting sort of the corners by vertex. first[] is used shifted by one while it fills. */
static void list_incident_triangles(struct growth *growth)
{
    const struct mesh *mesh = growth->mesh;
    int32_t corners = 3 * mesh->triangle_count;
    int32_t *next = growth->first + 1;
    for (int32_t i = 0; i < corners; i++)
        next[mesh->triangles[i] + 1]++;
    for (int32_t v = 0; v < mesh->vertex_count; v++)
        next[v + 1] += next[v];
    for (int32_t i = 0; i < corners; i++)
        growth->incident[next[mesh->triangles[i]]++] = i / 3;
    for (int32_t v = 0; v < mesh->vertex_count; v++)
        growth->number[v] = -1;
}

static void reach(struct growth *growth, int32_t vertex)
{
    if (growth->number[vertex] >= 0)
        return;
    growth->number[vertex] = growth->reached_count;
    growth->reached[growth->reached_count++] = vertex;
}

static void take(struct growth *growth, int32_t triangle)
{
    growth->taken[triangle] = true;
    growth->triangles[growth->triangle_count++] = triangle;
    for (int i = 0; i < 3; i++)
        reach(growth, growth->mesh->triangles[3 * (size_t)triangle + i]);
}

/* The polygon that a triangle belongs to. */
static int32_t face_of(const struct scene_faces *faces, int32_t triangle)
{
    int32_t low = 0, high = faces->count;
    while (high - low > 1) {
        int32_t middle = low + (high - low) / 2;
        if (scene_triangles_before(faces, middle) <= triangle)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Takes a triangle, or all of the polygon that it belongs to, if there is room. */
static void take_whole(struct growth *growth, int32_t triangle)
{
    int32_t first = triangle, end = triangle + 1, face = 0;
    if (growth->polygons->count > 0) {
        face = face_of(growth->polygons, triangle);
        first = scene_triangles_before(growth->polygons, face);
        end = scene_triangles_before(growth->polygons, face + 1);
    }
    if (growth->taken[triangle] || end - first > SCENE_CUT_TRIANGLES - growth->triangle_count)
        return;
    for (int32_t t = first; t < end; t++)
        take(growth, t);
    if (growth->polygons->count > 0)
        growth->faces[growth->face_count++] = face;
}

static void reach_marks(struct growth *growth, const struct scene *scene)
{
    for (int m = 0; m < scene->kept_mark_count; m++) {
        const struct mark *mark = &scene->marks[m];
        const int32_t *vertices = mark_vertices(mark);
        for (int32_t i = 0; scene_mark_fits(scene, mark) && i < mark->count; i++)
            reach(growth, vertices[i]);
    }
}

static void grow(struct growth *growth, const struct scene *scene)
{
    reach_marks(growth, scene);
    if (growth->reached_count == 0 && growth->mesh->triangle_count > 0)
        reach(growth, growth->mesh->triangles[0]);
    for (int32_t q = 0; q < growth->reached_count; q++) {
        int32_t vertex = growth->reached[q];
        for (int32_t i = growth->first[vertex]; i < growth->first[vertex + 1]; i++)
            take_whole(growth, growth->incident[i]);
    }
}

static int copy_mesh(const struct growth *growth, struct scene *to, struct error *err)
{
    if (mesh_init(&to->mesh, growth->reached_count, growth->triangle_count, err))
        return -1;
    const struct mesh *mesh = growth->mesh;
    for (int32_t v = 0; v < growth->reached_count; v++)
        memcpy(to->mesh.positions + 3 * (size_t)v, mesh->positions + 3 * (size_t)growth->reached[v],
               3 * sizeof(float));
    for (int32_t t = 0; t < growth->triangle_count; t++)
        for (size_t i = 0; i < 3; i++)
            to->mesh.triangles[3 * (size_t)t + i] =
                growth->number[mesh->triangles[3 * (size_t)growth->triangles[t] + i]];
    return 0;
}

static int copy_polygons(const struct growth *growth, struct scene_faces *to, struct error *err)
{
    const struct scene_faces *from = growth->polygons;
    /* A polygon has two corners more than triangles. */
    size_t corners = (size_t)growth->triangle_count + 2 * (size_t)growth->face_count;
    to->first_corner = calloc((size_t)growth->face_count + 1, sizeof(int32_t));
    to->corners = malloc((corners + 1) * sizeof(int32_t));
    if (!to->first_corner || !to->corners)
        return error_set(err, "out of memory for the polygons of a scene");
    int32_t count = 0;
    for (int32_t f = 0; f < growth->face_count; f++) {
        int32_t face = growth->faces[f];
        for (int32_t c = from->first_corner[face]; c < from->first_corner[face + 1]; c++)
            to->corners[count++] = growth->number[from->corners[c]];
        to->first_corner[f + 1] = count;
    }
    to->count = growth->face_count;
    return 0;
}

/* Copies a mark with the numbers of the cut; false: a vertex is not in it, or no memory. */
static bool copy_mark(const struct growth *growth, const struct scene *from,
                      const struct mark *mark, struct mark *to)
{
    const int32_t *vertices = mark_vertices(mark);
    for (int32_t i = 0; i < mark->count; i++)
        if (!scene_mark_fits(from, mark) || growth->number[vertices[i]] < 0)
            return false;
    *to = *mark;
    if (mark->list)
        to->list = malloc((size_t)mark->count * sizeof *to->list);
    int32_t *numbers = mark->list ? to->list : to->vertex;
    for (int32_t i = 0; numbers && i < mark->count; i++)
        numbers[i] = growth->number[vertices[i]];
    return numbers;
}

static int copy_marks(const struct growth *growth, const struct scene *from, struct scene *to,
                      struct error *err)
{
    to->marks = calloc((size_t)from->kept_mark_count + 1, sizeof *to->marks);
    to->labels = calloc((size_t)from->label_count + 1, sizeof *to->labels);
    if (!to->marks || !to->labels)
        return error_set(err, "out of memory for the marks of a scene");
    for (int m = 0; m < from->kept_mark_count; m++)
        if (copy_mark(growth, from, &from->marks[m], &to->marks[to->kept_mark_count]))
            to->kept_mark_count++;
    for (int l = 0; l < from->label_count; l++)
        if (copy_mark(growth, from, &from->labels[l].at, &to->labels[to->label_count].at))
            to->labels[to->label_count++].number = from->labels[l].number;
    return 0;
}

/* Values and parts of the kept vertices or triangles. */
static int copy_values(const struct growth *growth, const struct scene *from, struct scene *to,
                       struct error *err)
{
    bool per_vertex = from->values.part == SCENE_PER_VERTEX;
    int32_t count = per_vertex ? growth->reached_count : growth->triangle_count;
    const int32_t *kept = per_vertex ? growth->reached : growth->triangles;
    to->values = from->values;
    to->values.count = count;
    to->values.numbers = from->values.numbers ? malloc(((size_t)count + 1) * sizeof(float)) : NULL;
    to->groups = from->groups ? malloc((size_t)growth->triangle_count + 1) : NULL;
    if ((from->values.numbers && !to->values.numbers) || (from->groups && !to->groups))
        return error_set(err, "out of memory for the values of a scene");
    for (int32_t i = 0; to->values.numbers && i < count; i++)
        to->values.numbers[i] = from->values.numbers[kept[i]];
    for (int32_t t = 0; to->groups && t < growth->triangle_count; t++)
        to->groups[t] = from->groups[growth->triangles[t]];
    return 0;
}

static int copy_vectors(const struct growth *growth, const struct scene *from, struct scene *to,
                        struct error *err)
{
    for (int i = 0; i < from->vector_set_count; i++) {
        float *xyz = malloc((3 * (size_t)growth->reached_count + 1) * sizeof *xyz);
        if (!xyz)
            return error_set(err, "out of memory for the vectors of a scene");
        for (int32_t v = 0; v < growth->reached_count; v++)
            memcpy(xyz + 3 * (size_t)v, from->vectors[i].xyz + 3 * (size_t)growth->reached[v],
                   3 * sizeof *xyz);
        to->vectors[to->vector_set_count++] = (struct scene_vectors){from->vectors[i].kind, xyz};
    }
    return 0;
}

int scene_cut(const struct scene *from, struct scene *to, struct error *err)
{
    struct growth growth;
    if (growth_init(&growth, from, err))
        return -1;
    list_incident_triangles(&growth);
    grow(&growth, from);
    int failed = copy_mesh(&growth, to, err);
    if (!failed && growth.face_count > 0)
        failed = copy_polygons(&growth, &to->faces, err);
    if (!failed)
        failed = copy_marks(&growth, from, to, err);
    if (!failed)
        failed =
            copy_values(&growth, from, to, err) || copy_vectors(&growth, from, to, err) ? -1 : 0;
    growth_release(&growth);
    if (failed)
        scene_release(to);
    return failed;
}
