/* Picture: the walk around a vertex of winged edges, step by step. */
#include "graders/report/bench/lesson.h"

#include "reference/representation/winged_edge.h"

enum { SECTORS = 7 };

/* The edge as it is stored: an arrow from vertex[0] to vertex[1]. */
static void add_edge(json_t *scene, const struct winged_edge_mesh *we, int32_t edge, enum look look)
{
    const double shortened = 0.07;
    struct place from = lesson_vertex(we->positions, we->edges[edge].vertex[0]);
    struct place to = lesson_vertex(we->positions, we->edges[edge].vertex[1]);
    lesson_arrow(scene, lesson_between(from, to, shortened), lesson_between(to, from, shortened),
                 look, "", false);
}

/* A place on an edge, a share of the way out from the vertex in the middle. */
static struct place on_edge(const struct winged_edge_mesh *we, struct winged_side side,
                            double share)
{
    return lesson_between(lesson_vertex(we->positions, winged_edge_start(we, side)),
                          lesson_vertex(we->positions, winged_edge_end(we, side)), share);
}

static void add_walk(json_t *scene, const struct winged_edge_mesh *we, int32_t vertex)
{
    const double share = 0.66, gap = 0.16;
    struct winged_side first = winged_edge_leaving(we, we->vertex_edge[vertex], vertex);
    struct winged_side side = first;
    int step = 0;
    do {
        char label[24];
        struct winged_side next = winged_edge_turn_left(we, side);
        struct place from = on_edge(we, side, share), to = on_edge(we, next, share);
        add_edge(scene, we, side.edge, side.way == 0 ? LOOK_BLUE : LOOK_ORANGE);
        snprintf(label, sizeof label, "%d", ++step);
        lesson_arrow(scene, lesson_between(from, to, gap), lesson_between(to, from, gap), LOOK_DARK,
                     label, false);
        lesson_face(scene, winged_edge_face(we, side), step % 2 ? LOOK_SKY : LOOK_AMBER);
        side = next;
    } while (side.edge != first.edge && step < we->edge_count);
    lesson_label(scene, lesson_vertex(we->positions, vertex), LOOK_DARK, "v");
    lesson_label(scene, on_edge(we, first, 1.42), LOOK_GREEN, "first: taver of v");
}

static json_t *scene(const struct study *study)
{
    struct mesh mesh = {0};
    struct winged_edge_mesh we = {0};
    struct error ignored = {""};
    json_t *json = NULL;
    (void)study;
    if (lesson_dome(&mesh, SECTORS) != 0)
        return NULL;
    struct polygons polygons = polygons_of_mesh(&mesh);
    if (winged_edge_build(&we, &polygons, mesh.positions, &ignored) == 0)
        json = lesson_diagram(&mesh, "Winged edges: the faces around a vertex v, edge by edge",
                              "each step reads one link of an edge; which of the two depends on "
                              "whether the edge leaves v");
    if (json) {
        add_walk(json, &we, lesson_middle(&mesh));
        json_object_set_new(
            json, "legend",
            json_pack("[o, o, o]",
                      figure_key("arrow", LOOK_BLUE, "stored from v: read previous[0]"),
                      figure_key("arrow", LOOK_ORANGE, "stored to v: read previous[1]"),
                      figure_key("arrow", LOOK_DARK, "steps of the walk")));
    }
    winged_edge_release(&we);
    mesh_release(&mesh);
    return json;
}

static void finding(const struct study *study, FILE *to)
{
    (void)study;
    fputs("Winged edges. The walk around v starts at the edge that v keeps (taver) and turns to "
          "the previous edge in the face to its left, until it is back: one step a face, whatever "
          "the size of the mesh. An edge is stored in one direction only, so each step first "
          "compares vertices to know which of its links to read.",
          to);
}

const struct figure lesson_winged_edge = {.name = "winged-edge",
                                          .label = "The walk around a vertex of winged edges",
                                          .width = 1200,
                                          .height = 900,
                                          .scene = scene,
                                          .finding = finding,
                                          .absent = "memory ran out"};
