/* Picture: half edges as arrows inside their faces. */
#include "graders/report/bench/lesson.h"

#include "reference/representation/half_edge.h"

enum { SECTORS = 6 };

/* Middle of the face beside a half edge, or beside its twin where it has none. */
static struct place middle_of(const struct half_edge_mesh *he, int32_t h)
{
    int32_t a = he->half_edges[h].face < 0 ? he->half_edges[h].twin : h;
    int32_t b = he->half_edges[a].next, c = he->half_edges[b].next;
    struct place p = lesson_vertex(he->positions, he->half_edges[a].origin);
    struct place q = lesson_vertex(he->positions, he->half_edges[b].origin);
    struct place r = lesson_vertex(he->positions, he->half_edges[c].origin);
    return (struct place){(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3, (p.z + q.z + r.z) / 3};
}

/* The arrow of a half edge: beside its edge, on the side of its face, or outside of the mesh. */
static void add_arrow(json_t *scene, const struct half_edge_mesh *he, int32_t h, enum look look,
                      const char *label)
{
    const double inwards = 0.24, outwards = -0.16, shortened = 0.1;
    const double label_at = 0.62; /* behind the middle, so that the labels of twins stand apart */
    bool outside = he->half_edges[h].face < 0;
    double by = outside ? outwards : inwards;
    struct place middle = middle_of(he, h);
    struct place from =
        lesson_between(lesson_vertex(he->positions, he->half_edges[h].origin), middle, by);
    struct place to =
        lesson_between(lesson_vertex(he->positions, half_edge_end(he, h)), middle, by);
    lesson_arrow(scene, lesson_between(from, to, shortened), lesson_between(to, from, shortened),
                 look, "", outside);
    if (*label)
        lesson_label(scene, lesson_between(from, to, label_at), look, label);
}

/* h leaves the vertex in the middle. */
static void add_all(json_t *scene, const struct half_edge_mesh *he, int32_t middle)
{
    int32_t h = he->vertex_half_edge[middle];
    int32_t twin = he->half_edges[h].twin, next = he->half_edges[h].next;
    int32_t after = he->half_edges[next].next;
    for (int32_t i = 0; i < he->half_edge_count; i++) {
        if (i == h)
            add_arrow(scene, he, i, LOOK_ORANGE, "h");
        else if (i == twin)
            add_arrow(scene, he, i, LOOK_BLUE, "twin");
        else if (i == next)
            add_arrow(scene, he, i, LOOK_GREEN, "next");
        else if (i == after)
            add_arrow(scene, he, i, LOOK_GREEN, "previous");
        else
            add_arrow(scene, he, i, he->half_edges[i].face < 0 ? LOOK_PURPLE : LOOK_GREY, "");
    }
    lesson_face(scene, he->half_edges[h].face, LOOK_AMBER);
    lesson_label(scene, lesson_vertex(he->positions, he->half_edges[h].origin), LOOK_DARK, "u");
    lesson_label(scene, lesson_vertex(he->positions, half_edge_end(he, h)), LOOK_DARK, "v");
}

static json_t *scene(const struct study *study)
{
    struct mesh mesh = {0};
    struct half_edge_mesh he = {0};
    struct error ignored = {""};
    json_t *json = NULL;
    (void)study;
    if (lesson_dome(&mesh, SECTORS) != 0)
        return NULL;
    struct polygons polygons = polygons_of_mesh(&mesh);
    if (half_edge_build(&he, &polygons, mesh.positions, &ignored) == 0)
        json = lesson_diagram(&mesh, "Half edges: each edge twice, once for each face beside it",
                              "an arrow runs inside its face, counter-clockwise");
    if (json) {
        add_all(json, &he, lesson_middle(&mesh));
        json_object_set_new(
            json, "legend",
            json_pack("[o, o, o, o, o]", figure_key("arrow", LOOK_ORANGE, "h, from u to v"),
                      figure_key("arrow", LOOK_BLUE, "twin(h)"),
                      figure_key("arrow", LOOK_GREEN, "next, previous"),
                      figure_key("face", LOOK_AMBER, "face of h"),
                      figure_key("arrow", LOOK_PURPLE, "no face: around the hole")));
    }
    half_edge_release(&he);
    mesh_release(&mesh);
    return json;
}

static void finding(const struct study *study, FILE *to)
{
    (void)study;
    fputs("Half edges. Every edge is two arrows that run against each other; each lies in the face "
          "to its left. From h, next leads around its face and twin across its edge; the two "
          "together turn around a vertex. Along the boundary the outer halves have no face and are "
          "linked around the hole.",
          to);
}

const struct figure lesson_half_edge = {.name = "half-edges",
                                        .label = "Half edges drawn as arrows inside their faces",
                                        .width = 1200,
                                        .height = 900,
                                        .scene = scene,
                                        .finding = finding,
                                        .absent = "memory ran out"};
