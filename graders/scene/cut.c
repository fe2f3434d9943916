/* Breadth-first growth from the marked vertices; see scene_cut.h. */
#include "graders/scene/cut.h"

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
};

bool scene_needs_cut(const struct scene *scene)
{
    return scene->mesh.triangle_count > SCENE_TRIANGLE_LIMIT ||
           scene->mesh.vertex_count > SCENE_VERTEX_LIMIT;
}

bool scene_mark_fits(const struct scene *scene, const struct mark *mark)
{
    for (int i = 0; i <= (int)mark->element; i++)
        if (mark->vertex[i] < 0 || mark->vertex[i] >= scene->mesh.vertex_count)
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
}

static int growth_init(struct growth *growth, const struct mesh *mesh, struct error *err)
{
    size_t vertices = (size_t)mesh->vertex_count;
    size_t triangles = (size_t)mesh->triangle_count;
    *growth = (struct growth){.mesh = mesh,
                              .first = calloc(vertices + 2, sizeof(int32_t)),
                              .incident = malloc((3 * triangles + 1) * sizeof(int32_t)),
                              .number = malloc((vertices + 1) * sizeof(int32_t)),
                              .reached = malloc((vertices + 1) * sizeof(int32_t)),
                              .taken = calloc(triangles + 1, sizeof(bool)),
                              .triangles = malloc(SCENE_CUT_TRIANGLES * sizeof(int32_t))};
    if (growth->first && growth->incident && growth->number && growth->reached && growth->taken &&
        growth->triangles)
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
    if (growth->taken[triangle] || growth->triangle_count == SCENE_CUT_TRIANGLES)
        return;
    growth->taken[triangle] = true;
    growth->triangles[growth->triangle_count++] = triangle;
    for (int i = 0; i < 3; i++)
        reach(growth, growth->mesh->triangles[3 * (size_t)triangle + i]);
}

static void grow(struct growth *growth, const struct scene *scene)
{
    for (int m = 0; m < scene->kept_mark_count; m++)
        if (scene_mark_fits(scene, &scene->marks[m]))
            for (int i = 0; i <= (int)scene->marks[m].element; i++)
                reach(growth, scene->marks[m].vertex[i]);
    if (growth->reached_count == 0 && growth->mesh->triangle_count > 0)
        reach(growth, growth->mesh->triangles[0]);
    for (int32_t q = 0; q < growth->reached_count; q++) {
        int32_t vertex = growth->reached[q];
        for (int32_t i = growth->first[vertex]; i < growth->first[vertex + 1]; i++)
            take(growth, growth->incident[i]);
    }
}

static int copy_cut(const struct growth *growth, const struct scene *from, struct scene *to,
                    struct error *err)
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
    if (from->kept_mark_count == 0)
        return 0;
    to->marks = malloc((size_t)from->kept_mark_count * sizeof *to->marks);
    if (!to->marks)
        return error_set(err, "out of memory for the marks of a scene");
    for (int m = 0; m < from->kept_mark_count; m++) {
        struct mark mark = from->marks[m];
        if (!scene_mark_fits(from, &mark))
            continue;
        for (int i = 0; i < 3 && i <= (int)mark.element; i++)
            mark.vertex[i] = growth->number[mark.vertex[i]];
        to->marks[to->kept_mark_count++] = mark;
    }
    return 0;
}

int scene_cut(const struct scene *from, struct scene *to, struct error *err)
{
    struct growth growth;
    if (growth_init(&growth, &from->mesh, err))
        return -1;
    list_incident_triangles(&growth);
    grow(&growth, from);
    int failed = copy_cut(&growth, from, to, err);
    growth_release(&growth);
    if (failed)
        scene_release(to);
    return failed;
}
