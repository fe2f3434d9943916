/* Edits of half edges and winged edges: random sequences of splits, flips and collapses on both at
 * once, against the same changes made to a list of triangles. What can be done is exactly what
 * keeps the surface a manifold of the same shape. */
#include "reference/base/random.h"
#include "reference/mesh/check.h"
#include "reference/mesh/generate.h"
#include "reference/representation/half_edge_edit.h"
#include "reference/representation/winged_edge_edit.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MOST_VERTICES = 4000, MOST_TRIANGLES = 2000, MESHES = 8, STEPS = 160 };

/* The truth: triangles as a list, in which vertices keep their numbers. */
struct list {
    int32_t corners[3 * MOST_TRIANGLES];
    int32_t count;
    int32_t vertex_count; /* removed ones included */
};

struct subject {
    struct half_edge_mesh he;
    struct winged_edge_mesh we;
    struct list *list, *trial;
    struct topology topology;
};

/* -- the list ------------------------------------------------------------------------------- */

static void add(struct list *list, int32_t a, int32_t b, int32_t c)
{
    assert_true(list->count < MOST_TRIANGLES);
    int32_t *corners = list->corners + 3 * (int64_t)list->count++;
    corners[0] = a;
    corners[1] = b;
    corners[2] = c;
}

/* Takes the triangle that runs from u to v out; its third corner, or -1 when there is none. */
static int32_t take(struct list *list, int32_t u, int32_t v)
{
    for (int32_t t = 0; t < list->count; t++)
        for (int i = 0; i < 3; i++) {
            int32_t *corners = list->corners + 3 * (int64_t)t;
            if (corners[i] != u || corners[(i + 1) % 3] != v)
                continue;
            int32_t third = corners[(i + 2) % 3];
            memmove(corners, list->corners + 3 * (int64_t)--list->count, 3 * sizeof *corners);
            return third;
        }
    return -1;
}

static void list_split_edge(struct list *list, int32_t u, int32_t v, int32_t middle)
{
    const int32_t ends[2] = {u, v};
    for (int i = 0; i < 2; i++) {
        int32_t from = ends[i], to = ends[1 - i], third = take(list, from, to);
        if (third < 0)
            continue;
        add(list, from, middle, third);
        add(list, middle, to, third);
    }
}

static void list_flip(struct list *list, int32_t u, int32_t v)
{
    int32_t w = take(list, u, v), x = take(list, v, u);
    if (w >= 0 && x >= 0) {
        add(list, x, w, u);
        add(list, w, x, v);
    } else { /* a boundary edge: leave a degenerate triangle, which is found */
        add(list, u, u, v);
    }
}

static void list_collapse(struct list *list, int32_t u, int32_t v)
{
    while (take(list, u, v) >= 0 || take(list, v, u) >= 0)
        continue;
    for (int32_t i = 0; i < 3 * list->count; i++)
        if (list->corners[i] == u)
            list->corners[i] = v;
}

static struct topology list_topology(struct list *list)
{
    static float positions[3 * MOST_VERTICES];
    struct mesh mesh = {positions, list->corners, list->vertex_count, list->count};
    struct topology topology;
    assert_true(list->vertex_count <= MOST_VERTICES);
    assert_int_equal(mesh_topology(&mesh, &topology, NULL), 0);
    return topology;
}

/* Whether `after` is a manifold of the shape of `before`, with `fewer` vertices less in use. */
static bool keeps_shape(const struct topology *before, const struct topology *after, int64_t fewer)
{
    return after->triangle_count > 0 && after->degenerate.count == 0 &&
           after->duplicate.count == 0 && after->nonmanifold_edge.count == 0 &&
           after->nonmanifold_vertex.count == 0 && after->incoherent.count == 0 &&
           after->isolated.count == before->isolated.count + fewer &&
           after->euler_characteristic == before->euler_characteristic &&
           after->boundary_loop_count == before->boundary_loop_count &&
           after->component_count == before->component_count;
}

/* -- comparing ------------------------------------------------------------------------------ */

static int compare_triangles(const void *a, const void *b)
{
    const int32_t *x = a, *y = b;
    for (int i = 0; i < 3; i++)
        if (x[i] != y[i])
            return x[i] < y[i] ? -1 : 1;
    return 0;
}

/* Each triangle from its lowest corner, sorted. */
static void normalise(struct list *list)
{
    for (int32_t t = 0; t < list->count; t++) {
        int32_t *c = list->corners + 3 * (int64_t)t;
        while (c[0] > c[1] || c[0] > c[2]) {
            int32_t first = c[0];
            c[0] = c[1];
            c[1] = c[2];
            c[2] = first;
        }
    }
    qsort(list->corners, (size_t)list->count, 3 * sizeof *list->corners, compare_triangles);
}

static void list_half_edges(const struct half_edge_mesh *he, struct list *list)
{
    list->count = 0;
    for (int32_t f = 0; f < he->face_count; f++) {
        int32_t h = he->face_half_edge[f];
        if (h == HALF_EDGE_REMOVED)
            continue;
        int32_t second = he->half_edges[h].next;
        add(list, he->half_edges[h].origin, he->half_edges[second].origin,
            half_edge_end(he, second));
    }
}

static void list_winged_edges(const struct winged_edge_mesh *we, struct list *list)
{
    list->count = 0;
    for (int32_t f = 0; f < we->face_count; f++) {
        if (we->face_edge[f] == WINGED_EDGE_REMOVED)
            continue;
        struct winged_side side = winged_edge_of_face(we, f);
        add(list, winged_edge_start(we, side), winged_edge_end(we, side),
            winged_edge_end(we, winged_edge_next(we, side)));
    }
}

static void require_agreement(struct subject *s)
{
    struct error err = {0};
    if (half_edge_check(&s->he, &err) || winged_edge_check(&s->we, &err))
        fail_msg("%s", err.text);
    normalise(s->list);
    list_half_edges(&s->he, s->trial);
    normalise(s->trial);
    assert_int_equal(s->trial->count, s->list->count);
    assert_memory_equal(s->trial->corners, s->list->corners, 12 * (size_t)s->list->count);
    list_winged_edges(&s->we, s->trial);
    normalise(s->trial);
    assert_int_equal(s->trial->count, s->list->count);
    assert_memory_equal(s->trial->corners, s->list->corners, 12 * (size_t)s->list->count);
    s->topology = list_topology(s->list);
}

/* -- steps ---------------------------------------------------------------------------------- */

static const float somewhere[3] = {1.0F, 2.0F, 3.0F};

static void split_face(struct subject *s, struct random *rng)
{
    int32_t f;
    do {
        f = (int32_t)random_below(rng, (uint64_t)s->he.face_count);
    } while (s->he.face_half_edge[f] < 0);
    int32_t h = s->he.face_half_edge[f], second = s->he.half_edges[h].next;
    int32_t a = s->he.half_edges[h].origin, b = s->he.half_edges[second].origin;
    int32_t c = half_edge_end(&s->he, second), middle = s->list->vertex_count++;
    assert_int_equal(half_edge_split_face(&s->he, f, somewhere, NULL), middle);
    struct winged_side side = winged_edge_leaving(&s->we, winged_edge_find(&s->we, a, b), a);
    assert_int_equal(
        winged_edge_split_face(&s->we, winged_edge_face(&s->we, side), somewhere, NULL), middle);
    assert_int_equal(take(s->list, a, b), c);
    add(s->list, a, b, middle);
    add(s->list, b, c, middle);
    add(s->list, c, a, middle);
}

/* A random half edge and the side of the winged edge that runs like it. */
static int32_t pick(const struct subject *s, struct random *rng, struct winged_side *side,
                    int32_t *u, int32_t *v)
{
    int32_t h;
    do {
        h = (int32_t)random_below(rng, (uint64_t)s->he.half_edge_count);
    } while (s->he.half_edges[h].origin < 0);
    *u = s->he.half_edges[h].origin;
    *v = half_edge_end(&s->he, h);
    int32_t edge = winged_edge_find(&s->we, *u, *v);
    assert_true(edge >= 0);
    *side = winged_edge_leaving(&s->we, edge, *u);
    return h;
}

static void split_edge(struct subject *s, struct random *rng)
{
    struct winged_side side;
    int32_t u, v, h = pick(s, rng, &side, &u, &v), middle = s->list->vertex_count++;
    assert_int_equal(half_edge_split_edge(&s->he, h, somewhere, NULL), middle);
    assert_int_equal(winged_edge_split_edge(&s->we, side, somewhere, NULL), middle);
    list_split_edge(s->list, u, v, middle);
}

static void flip(struct subject *s, struct random *rng)
{
    struct winged_side side;
    int32_t u, v, h = pick(s, rng, &side, &u, &v);
    *s->trial = *s->list;
    list_flip(s->trial, u, v);
    struct topology after = list_topology(s->trial);
    bool can = keeps_shape(&s->topology, &after, 0);
    assert_int_equal(half_edge_can_flip(&s->he, h), can);
    assert_int_equal(winged_edge_can_flip(&s->we, side), can);
    if (!can)
        return;
    half_edge_flip(&s->he, h);
    winged_edge_flip(&s->we, side);
    *s->list = *s->trial;
}

static void collapse(struct subject *s, struct random *rng)
{
    struct winged_side side;
    int32_t u, v, h = pick(s, rng, &side, &u, &v);
    *s->trial = *s->list;
    list_collapse(s->trial, u, v);
    struct topology after = list_topology(s->trial);
    bool can = keeps_shape(&s->topology, &after, 1);
    assert_int_equal(half_edge_can_collapse(&s->he, h), can);
    assert_int_equal(winged_edge_can_collapse(&s->we, side), can);
    if (!can)
        return;
    half_edge_collapse(&s->he, h);
    winged_edge_collapse(&s->we, side);
    *s->list = *s->trial;
}

/* -- the sequences -------------------------------------------------------------------------- */

static struct mesh start_mesh(int which)
{
    struct mesh mesh;
    int code = which == 0   ? generate_tetrahedron(&mesh, NULL)
               : which == 1 ? generate_one_triangle(&mesh, NULL)
               : which == 2 ? generate_grid(&mesh, 2, 3, NULL)
               : which == 3 ? generate_disc(&mesh, 1, 5, NULL)
               : which == 4 ? generate_cube(&mesh, NULL)
               : which == 5 ? generate_torus(&mesh, 1, 60, NULL)
               : which == 6 ? generate_icosphere(&mesh, 1, NULL)
                            : generate_bipyramid(&mesh, 3, NULL);
    assert_int_equal(code, 0);
    if (which == 6)
        assert_int_equal(change_remove_triangles(&mesh, 1, 5, NULL), 0);
    return mesh;
}

static void start(struct subject *s, int which)
{
    struct mesh mesh = start_mesh(which);
    struct polygons polygons = polygons_of_mesh(&mesh);
    assert_int_equal(half_edge_build(&s->he, &polygons, mesh.positions, NULL), 0);
    assert_int_equal(winged_edge_build(&s->we, &polygons, mesh.positions, NULL), 0);
    s->list = calloc(1, sizeof *s->list);
    s->trial = calloc(1, sizeof *s->trial);
    assert_true(s->list && s->trial);
    s->list->count = mesh.triangle_count;
    s->list->vertex_count = s->trial->vertex_count = mesh.vertex_count;
    memcpy(s->list->corners, mesh.triangles, 12 * (size_t)mesh.triangle_count);
    mesh_release(&mesh);
    require_agreement(s);
}

/* Both compacted are the same mesh as the list, vertices in order. */
static void finish(struct subject *s)
{
    int64_t isolated = s->topology.isolated.count;
    assert_int_equal(half_edge_compact(&s->he, NULL), 0);
    assert_int_equal(winged_edge_compact(&s->we, NULL), 0);
    assert_int_equal(half_edge_check(&s->he, NULL), 0);
    assert_int_equal(winged_edge_check(&s->we, NULL), 0);
    struct mesh a, b;
    assert_int_equal(half_edge_to_mesh(&s->he, &a, NULL), 0);
    assert_int_equal(winged_edge_to_mesh(&s->we, &b, NULL), 0);
    assert_int_equal(a.vertex_count, s->list->vertex_count - isolated);
    assert_int_equal(b.vertex_count, a.vertex_count);
    assert_int_equal(a.triangle_count, s->list->count);
    assert_int_equal(b.triangle_count, s->list->count);
    assert_memory_equal(a.positions, b.positions, 12 * (size_t)a.vertex_count);
    struct topology topology;
    assert_int_equal(mesh_topology(&a, &topology, NULL), 0);
    assert_int_equal(topology.euler_characteristic, s->topology.euler_characteristic);
    mesh_release(&a);
    mesh_release(&b);
    half_edge_release(&s->he);
    winged_edge_release(&s->we);
    free(s->list);
    free(s->trial);
}

/* The share of splits falls, so that meshes grow first and are then collapsed to the bone. */
static void random_edits_keep_the_invariants(void **state)
{
    (void)state;
    for (int which = 0; which < MESHES; which++) {
        struct subject s;
        struct random rng;
        random_init(&rng, (uint64_t)(100 + which));
        start(&s, which);
        for (int step = 0; step < STEPS; step++) {
            uint64_t split_percent = step < STEPS / 3 ? 50 : 2, dice = random_below(&rng, 100);
            if (dice < split_percent / 2)
                split_face(&s, &rng);
            else if (dice < split_percent)
                split_edge(&s, &rng);
            else if (dice < 65)
                flip(&s, &rng);
            else
                collapse(&s, &rng);
            require_agreement(&s);
        }
        finish(&s);
    }
}

/* What the sphere comes down to: no edge of a tetrahedron can go. */
static void a_tetrahedron_cannot_collapse(void **state)
{
    (void)state;
    struct subject s;
    start(&s, 0);
    for (int32_t h = 0; h < s.he.half_edge_count; h++) {
        assert_false(half_edge_can_collapse(&s.he, h));
        assert_false(half_edge_can_flip(&s.he, h));
    }
    for (int32_t e = 0; e < s.we.edge_count; e++)
        assert_false(winged_edge_can_collapse(&s.we, (struct winged_side){e, 0}));
    finish(&s);
}

/* Two triangles back to back, which a strict eye takes for one: nothing can be done to them. */
static void a_pillow_stays_as_it_is(void **state)
{
    (void)state;
    const float positions[9] = {0};
    const int32_t corners[6] = {0, 1, 2, 0, 2, 1};
    const struct polygons polygons = {corners, NULL, 3, 2};
    struct half_edge_mesh he;
    struct winged_edge_mesh we;
    assert_int_equal(half_edge_build(&he, &polygons, positions, NULL), 0);
    assert_int_equal(winged_edge_build(&we, &polygons, positions, NULL), 0);
    for (int32_t h = 0; h < 6; h++) {
        struct winged_side side = {h % 3, h / 3};
        assert_false(half_edge_can_collapse(&he, h) || half_edge_can_flip(&he, h));
        assert_false(winged_edge_can_collapse(&we, side) || winged_edge_can_flip(&we, side));
    }
    half_edge_release(&he);
    winged_edge_release(&we);
}

/* Splitting every face and collapsing the new vertices again gives back the mesh. */
static void split_faces_collapse_back(void **state)
{
    (void)state;
    struct subject s;
    start(&s, 5);
    int32_t faces = s.he.face_count, vertices = s.he.vertex_count;
    for (int32_t f = 0; f < faces; f++) {
        assert_int_equal(half_edge_split_face(&s.he, f, somewhere, NULL), vertices + f);
        assert_int_equal(winged_edge_split_face(&s.we, f, somewhere, NULL), vertices + f);
    }
    for (int32_t v = vertices; v < vertices + faces; v++) {
        int32_t h = s.he.vertex_half_edge[v];
        assert_true(half_edge_can_collapse(&s.he, h));
        half_edge_collapse(&s.he, h);
        struct winged_side side = winged_edge_of_vertex(&s.we, v);
        assert_true(winged_edge_can_collapse(&s.we, side));
        winged_edge_collapse(&s.we, side);
    }
    require_agreement(&s);
    finish(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_edits_keep_the_invariants),
        cmocka_unit_test(a_tetrahedron_cannot_collapse),
        cmocka_unit_test(a_pillow_stays_as_it_is),
        cmocka_unit_test(split_faces_collapse_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
