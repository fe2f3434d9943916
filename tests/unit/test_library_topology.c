/* The topology of faces: against the checks of reference/mesh on known meshes, against slow
 * searches on random polygons, and on tables full of garbage. */
#include "graders/library/topology.h"
#include "reference/base/random.h"
#include "reference/mesh/generate.h"
#include "tests/unit/mesh_corpus.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct face_table table_of(const struct mesh *mesh)
{
    return (struct face_table){.corners = mesh->triangles,
                               .face_count = mesh->triangle_count,
                               .corner_count = 3 * (int64_t)mesh->triangle_count,
                               .vertex_count = mesh->vertex_count};
}

static struct face_topology build(const struct face_table *table)
{
    struct face_topology t;
    assert_int_equal(topology_build(table, &t, NULL), 0);
    return t;
}

/* -- against reference/mesh/check.h ----------------------------------------------------------- */

static void assert_as_checked(const struct mesh *mesh)
{
    struct topology found;
    assert_int_equal(mesh_topology(mesh, &found, NULL), 0);
    struct face_table table = table_of(mesh);
    struct face_topology t = build(&table);
    assert_int_equal(t.broken.count, 0);
    assert_int_equal(t.edge_count, found.edge_count);
    assert_int_equal(topology_euler(&t), found.euler_characteristic);
    assert_int_equal(t.component_count, found.component_count);
    assert_int_equal(t.unorientable.count == 0, found.is_orientable);
    assert_memory_equal(&t.boundary, &found.boundary, sizeof t.boundary);
    assert_memory_equal(&t.nonmanifold_edge, &found.nonmanifold_edge, sizeof t.boundary);
    assert_memory_equal(&t.incoherent, &found.incoherent, sizeof t.boundary);
    assert_memory_equal(&t.degenerate, &found.degenerate, sizeof t.boundary);
    assert_int_equal(t.used_count, mesh->vertex_count - found.isolated.count);
    assert_int_equal(t.nonmanifold_vertex.count, found.nonmanifold_vertex.count);
    if (t.nonmanifold_vertex.count)
        assert_int_equal(t.vertices[t.nonmanifold_vertex.first].vertex,
                         found.nonmanifold_vertex.first);
    else
        assert_int_equal(t.loop_count, found.boundary_loop_count);
    topology_release(&t);
}

static void known_meshes_are_as_the_checks_say(void **state)
{
    (void)state;
    for (int i = 0; i < CORPUS_GENERATED + 300; i++) {
        struct mesh mesh = corpus_mesh(i);
        assert_as_checked(&mesh);
        mesh_release(&mesh);
    }
}

static void genus_and_loops(void **state)
{
    (void)state;
    struct mesh mesh, disc;
    for (int genus = 0; genus < 4; genus++) {
        assert_int_equal(generate_torus(&mesh, genus, 300, NULL), 0);
        assert_int_equal(generate_disc(&disc, 2, 7, NULL), 0);
        assert_int_equal(change_append(&mesh, &disc, 9, 0, 0, NULL), 0);
        struct face_table table = table_of(&mesh);
        struct face_topology t = build(&table);
        assert_int_equal(topology_genus(&t), genus);
        assert_true(topology_is_manifold(&t));
        assert_int_equal(t.component_count, 2);
        assert_int_equal(t.patch_count, 2);
        assert_int_equal(t.loop_count, 1);
        assert_int_equal(t.loop_first[1], 7);
        assert_int_equal(t.patch[0], 0);
        assert_int_equal(t.patch[mesh.triangle_count - 1], 1);
        topology_release(&t);
        mesh_release(&mesh);
        mesh_release(&disc);
    }
    assert_int_equal(generate_moebius(&mesh, 9, NULL), 0);
    struct face_table table = table_of(&mesh);
    struct face_topology t = build(&table);
    assert_int_equal(t.unorientable.count, 1);
    assert_int_equal(topology_genus(&t), -1);
    assert_int_equal(t.loop_count, 1);
    topology_release(&t);
    topology_release(&t);
    mesh_release(&mesh);
}

static void fans_umbrellas_and_sheets_are_counted(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_two_cones(&mesh, 5, NULL), 0);
    struct face_table table = table_of(&mesh);
    struct face_topology t = build(&table);
    const struct face_vertex *apex = &t.vertices[t.nonmanifold_vertex.first];
    assert_int_equal(t.nonmanifold_vertex.count, 1);
    assert_int_equal(apex->fan_count, 2);
    assert_int_equal(apex->face_count, 10);
    assert_int_equal(t.component_count, 1);
    assert_int_equal(t.patch_count, 2);
    topology_release(&t);
    mesh_release(&mesh);
    assert_int_equal(generate_book(&mesh, 5, NULL), 0);
    table = table_of(&mesh);
    t = build(&table);
    const struct face_edge *spine = &t.edges[t.nonmanifold_edge.first];
    int64_t end = topology_find_vertex(&t, spine->low);
    assert_int_equal(topology_side_count(spine), 5);
    assert_int_equal(t.vertices[end].fan_count, 1);
    assert_int_equal(t.vertices[end].sheet_count, 5);
    assert_int_equal(t.vertices[end].boundary_count, 5);
    assert_false(t.vertices[end].is_manifold);
    assert_null(t.loop_first);
    assert_int_equal(t.loop_count, 1);
    topology_release(&t);
    mesh_release(&mesh);
}

static void two_fans_at_a_vertex_are_two_loops(void **state)
{
    (void)state;
    const int32_t bow_tie[] = {0, 1, 2, 2, 3, 4};
    struct face_table table = {NULL, bow_tie, 2, 6, 5};
    struct face_topology t = build(&table);
    const int32_t first[] = {0, 3, 6};
    assert_int_equal(t.loop_count, 2);
    assert_memory_equal(t.loop_first, first, sizeof first);
    assert_memory_equal(t.loop_vertices, bow_tie, sizeof bow_tie);
    assert_int_equal(t.vertices[2].fan_count, 2);
    assert_int_equal(t.vertices[2].boundary_count, 4);
    topology_release(&t);
}

/* -- against slow searches -------------------------------------------------------------------- */

enum { VERTICES = 7, MOST_FACES = 7, MOST_CORNERS = 5 * MOST_FACES };

struct faces {
    int32_t starts[MOST_FACES + 1], corners[MOST_CORNERS];
    int count;
};

static struct face_table table_of_faces(const struct faces *f)
{
    return (struct face_table){f->starts, f->corners, f->count, f->starts[f->count], VERTICES};
}

/* Polygons of 3 to 5 different vertices, sometimes with one twice. */
static struct faces random_faces(struct random *rng)
{
    struct faces f = {.count = (int)random_below(rng, MOST_FACES + 1)};
    for (int i = 0; i < f.count; i++) {
        int32_t order[VERTICES];
        int corners = 3 + (int)random_below(rng, 3);
        random_permutation(rng, order, VERTICES);
        if (random_below(rng, 10) == 0)
            order[corners - 1] = order[random_below(rng, (uint64_t)corners - 1)];
        memcpy(f.corners + f.starts[i], order, (size_t)corners * sizeof *order);
        f.starts[i + 1] = f.starts[i] + corners;
    }
    return f;
}

static bool is_proper(const struct faces *f, int face)
{
    for (int i = f->starts[face]; i < f->starts[face + 1]; i++)
        for (int j = f->starts[face]; j < i; j++)
            if (f->corners[i] == f->corners[j])
                return false;
    return true;
}

/* How often a face runs from a to b. */
static int runs(const struct faces *f, int face, int a, int b)
{
    int count = 0;
    for (int i = f->starts[face]; i < f->starts[face + 1]; i++) {
        int next = i + 1 == f->starts[face + 1] ? f->starts[face] : i + 1;
        count += f->corners[i] == a && f->corners[next] == b;
    }
    return is_proper(f, face) ? count : 0;
}

static int sides_of(const struct faces *f, int a, int b)
{
    int count = 0;
    for (int face = 0; face < f->count; face++)
        count += runs(f, face, a, b);
    return count;
}

static bool has_vertex(const struct faces *f, int face, int v)
{
    for (int i = f->starts[face]; i < f->starts[face + 1]; i++)
        if (f->corners[i] == v)
            return true;
    return false;
}

enum relation { BY_VERTEX, BY_EDGE, BY_EDGE_AT, BY_PAIRED_EDGE_AT };

/* Whether two faces touch: anywhere, or at an edge of vertex v. */
static bool touch(const struct faces *f, int s, int t, enum relation relation, int v)
{
    for (int a = 0; a < VERTICES; a++) {
        if (relation == BY_VERTEX && has_vertex(f, s, a) && has_vertex(f, t, a))
            return true;
        for (int b = 0; b < VERTICES && relation != BY_VERTEX; b++) {
            bool is_at = relation == BY_EDGE || a == v || b == v;
            bool has_both =
                (runs(f, s, a, b) || runs(f, s, b, a)) && (runs(f, t, a, b) || runs(f, t, b, a));
            bool is_paired = sides_of(f, a, b) + sides_of(f, b, a) == 2;
            if (is_at && has_both && (relation != BY_PAIRED_EDGE_AT || is_paired))
                return true;
        }
    }
    return false;
}

/* Groups of faces; label[f] is -1 for those that are left out. */
static int group_slowly(const struct faces *f, const bool *takes_part, enum relation relation,
                        int v, int *label)
{
    int count = 0;
    for (int i = 0; i < f->count; i++)
        label[i] = -1;
    for (int i = 0; i < f->count; i++) {
        if (!takes_part[i] || label[i] >= 0)
            continue;
        label[i] = count++;
        for (bool again = true; again;) {
            again = false;
            for (int s = 0; s < f->count; s++)
                for (int t = 0; t < f->count; t++)
                    if (takes_part[s] && takes_part[t] && label[s] >= 0 && label[t] < 0 &&
                        touch(f, s, t, relation, v)) {
                        label[t] = label[s];
                        again = true;
                    }
        }
    }
    return count;
}

static void assert_edges(const struct faces *f, const struct face_topology *t)
{
    int count = 0;
    for (int a = 0; a < VERTICES; a++)
        for (int b = a + 1; b < VERTICES; b++) {
            int64_t e = topology_find_edge(t, b, a);
            int up = sides_of(f, a, b), down = sides_of(f, b, a);
            assert_int_equal(e >= 0, up + down > 0);
            if (e < 0)
                continue;
            count++;
            assert_int_equal(t->edges[e].low, a);
            assert_int_equal(t->edges[e].high, b);
            assert_int_equal(t->edges[e].up_count, up);
            assert_int_equal(t->edges[e].down_count, down);
            for (int i = 0; i < up + down; i++) {
                int32_t side = t->uses[t->edges[e].first_use + i];
                int32_t from = f->corners[side], to = f->corners[topology_next(t, side)];
                assert_true((from == a && to == b) || (from == b && to == a));
                assert_int_equal(t->side_edge[side], e);
                assert_int_equal(topology_previous(t, topology_next(t, side)), side);
                int64_t twin = topology_twin(t, side);
                assert_int_equal(twin >= 0, up + down == 2);
                if (twin >= 0)
                    assert_int_equal(topology_twin(t, twin), side);
            }
        }
    assert_int_equal(t->edge_count, count);
}

static void assert_groups(const struct faces *f, const struct face_topology *t)
{
    bool all[MOST_FACES], proper[MOST_FACES];
    int label[MOST_FACES];
    for (int i = 0; i < f->count; i++) {
        all[i] = true;
        proper[i] = is_proper(f, i);
    }
    assert_int_equal(t->component_count, group_slowly(f, all, BY_VERTEX, 0, label));
    for (int i = 0; i < f->count; i++)
        assert_int_equal(t->component[i], label[i]);
    assert_int_equal(t->patch_count, group_slowly(f, proper, BY_EDGE, 0, label));
    for (int i = 0; i < f->count; i++)
        assert_int_equal(t->patch[i], label[i]);
    for (int v = 0; v < VERTICES; v++) {
        bool at[MOST_FACES];
        int faces = 0, boundary = 0, most = 0;
        for (int i = 0; i < f->count; i++)
            faces += at[i] = proper[i] && has_vertex(f, i, v);
        for (int b = 0; b < VERTICES; b++) {
            int sides = sides_of(f, v, b) + sides_of(f, b, v);
            boundary += sides == 1;
            most = sides > most ? sides : most;
        }
        int64_t index = topology_find_vertex(t, v);
        if (index < 0) {
            assert_int_equal(faces, 0);
            continue;
        }
        const struct face_vertex *vertex = &t->vertices[index];
        for (int i = 0; i < f->count; i++)
            if (has_vertex(f, i, v))
                assert_int_equal(vertex->component, t->component[i]);
        int fans = group_slowly(f, at, BY_EDGE_AT, v, label);
        assert_int_equal(vertex->face_count, faces);
        assert_int_equal(vertex->fan_count, fans);
        assert_int_equal(vertex->sheet_count, group_slowly(f, at, BY_PAIRED_EDGE_AT, v, label));
        assert_int_equal(vertex->boundary_count, boundary);
        assert_int_equal(vertex->is_manifold, fans <= 1 && most <= 2);
    }
}

/* Tries every choice of windings. */
static bool orientable_slowly(const struct faces *f)
{
    for (unsigned choice = 0; choice < 1u << f->count; choice++) {
        bool fits = true;
        for (int a = 0; a < VERTICES; a++)
            for (int b = a + 1; b < VERTICES; b++) {
                int up = 0;
                for (int i = 0; i < f->count; i++)
                    up += choice >> i & 1 ? runs(f, i, b, a) : runs(f, i, a, b);
                if (sides_of(f, a, b) + sides_of(f, b, a) == 2 && up != 1)
                    fits = false;
            }
        if (fits)
            return true;
    }
    return false;
}

/* Every boundary edge lies in just one loop, in its own direction when faces are coherent. */
static void assert_loops(const struct faces *f, const struct face_topology *t)
{
    if (!t->loop_first)
        return;
    int seen[VERTICES][VERTICES] = {{0}};
    for (int64_t loop = 0; loop < t->loop_count; loop++) {
        int32_t first = t->loop_first[loop], end = t->loop_first[loop + 1];
        assert_true(end - first >= 2);
        for (int32_t i = first; i < end; i++) {
            int32_t a = t->loop_vertices[i], b = t->loop_vertices[i + 1 == end ? first : i + 1];
            if (t->incoherent.count == 0)
                assert_int_equal(sides_of(f, a, b), 1);
            seen[a < b ? a : b][a < b ? b : a]++;
        }
    }
    for (int a = 0; a < VERTICES; a++)
        for (int b = a + 1; b < VERTICES; b++)
            assert_int_equal(seen[a][b], sides_of(f, a, b) + sides_of(f, b, a) == 1);
}

static void random_polygons_are_as_slow_searches_say(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 41);
    int walked = 0;
    for (int trial = 0; trial < 1500; trial++) {
        struct faces f = random_faces(&rng);
        struct face_table table = table_of_faces(&f);
        struct face_topology t = build(&table);
        assert_int_equal(t.broken.count, 0);
        assert_edges(&f, &t);
        assert_groups(&f, &t);
        assert_loops(&f, &t);
        assert_int_equal(t.unorientable.count == 0, orientable_slowly(&f));
        walked += t.loop_first && t.loop_count > 1;
        topology_release(&t);
    }
    assert_true(walked > 50);
}

/* -- garbage ---------------------------------------------------------------------------------- */

static void broken_faces_are_named_and_left_out(void **state)
{
    (void)state;
    const int32_t corners[] = {0, 1, 2, 0, 2, 3, 1, 7, INT32_MIN, 3, 2, 0};
    struct face_table table = {NULL, corners, 4, 12, 4};
    struct face_topology t = build(&table);
    assert_int_equal(t.broken.count, 1);
    assert_int_equal(t.broken.first, 2);
    assert_int_equal(t.flaw, FACE_INDEX_OUT_OF_RANGE);
    assert_int_equal(t.flaw_corner, 7);
    assert_int_equal(t.component[2], -1);
    assert_int_equal(t.patch[2], -1);
    assert_int_equal(t.proper_count, 3);
    assert_int_equal(topology_genus(&t), -1);
    assert_int_equal(topology_find_edge(&t, INT32_MIN, INT32_MAX), -1);
    topology_release(&t);
    table.face_count = 5; /* one more than there are corners for */
    t = build(&table);
    assert_int_equal(t.broken.count, 2);
    topology_release(&t);
    static const struct {
        int32_t starts[4];
        int64_t face;
        enum face_flaw flaw;
    } bad[] = {
        {{1, 4, 8, 12}, 0, FACE_BAD_OFFSETS},        {{0, 2, 8, 12}, 0, FACE_TOO_FEW_CORNERS},
        {{0, 3, 13, 12}, 1, FACE_BAD_OFFSETS},       {{0, 6, 3, 6}, 1, FACE_BAD_OFFSETS},
        {{0, 3, INT32_MAX, 6}, 1, FACE_BAD_OFFSETS}, {{0, 3, INT32_MIN, 6}, 1, FACE_BAD_OFFSETS},
        {{0, 3, 3, 6}, 1, FACE_TOO_FEW_CORNERS}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        table = (struct face_table){bad[i].starts, corners, 3, 12, 4};
        t = build(&table);
        assert_int_equal(t.broken.first, bad[i].face);
        assert_int_equal(t.flaw, bad[i].flaw);
        topology_release(&t);
    }
}

static void impossible_counts_are_our_error(void **state)
{
    (void)state;
    struct face_topology t;
    struct error err = {0};
    struct face_table table = {NULL, NULL, -1, 0, 0};
    assert_int_equal(topology_build(&table, &t, &err), -1);
    assert_true(err.text[0]);
    table = (struct face_table){NULL, NULL, 1, INT64_MAX, 0};
    assert_int_equal(topology_build(&table, &t, NULL), -1);
    table = (struct face_table){NULL, NULL, 0, 0, 0};
    assert_int_equal(topology_build(&table, &t, NULL), 0);
    assert_int_equal(topology_genus(&t), 0);
    assert_int_equal(t.loop_first[0], 0);
    topology_release(&t);
}

static int32_t random_garbage(struct random *rng, int32_t limit)
{
    static const int32_t wild[] = {INT32_MIN, INT32_MAX, -1, INT32_MAX - 1};
    switch (random_below(rng, 12)) {
    case 0:
        return wild[random_below(rng, 4)];
    case 1:
        return (int32_t)random_next(rng);
    default:
        return (int32_t)random_below(rng, (uint64_t)limit);
    }
}

/* Every query is asked; sanitizers watch. What is counted must add up. */
static void garbage_is_bounded(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 42);
    for (int trial = 0; trial < 20000; trial++) {
        int32_t faces = (int32_t)random_below(&rng, 9), room = (int32_t)random_below(&rng, 30);
        bool has_starts = random_below(&rng, 2);
        int32_t *starts = malloc(((size_t)faces + 1) * sizeof *starts);
        int32_t *corners = malloc((size_t)room * sizeof *corners + 1);
        assert_true(starts && corners);
        for (int32_t i = 0; i <= faces; i++)
            starts[i] = random_below(&rng, 4) ? 3 * i : random_garbage(&rng, room + 1);
        for (int32_t i = 0; i < room; i++)
            corners[i] = random_garbage(&rng, 6);
        struct face_table table = {has_starts ? starts : NULL, corners, faces, room, 5};
        struct face_topology t = build(&table);
        assert_int_equal(t.broken.count + t.degenerate.count + t.proper_count, faces);
        assert_int_equal(t.flaw != FACE_FINE, t.broken.count > 0);
        int64_t sides = 0;
        for (int64_t e = 0; e < t.edge_count; e++) {
            sides += topology_side_count(&t.edges[e]);
            assert_int_equal(topology_find_edge(&t, t.edges[e].high, t.edges[e].low), e);
            assert_true(topology_edge_face(&t, e, 0) >= 0);
        }
        for (int64_t c = 0; c < room; c++)
            sides -= t.corner_face[c] >= 0;
        assert_int_equal(sides, 0);
        for (int64_t v = 0; v < t.used_count; v++)
            assert_in_range(t.vertices[v].vertex, 0, 4);
        topology_release(&t);
        free(starts);
        free(corners);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_meshes_are_as_the_checks_say),
        cmocka_unit_test(genus_and_loops),
        cmocka_unit_test(fans_umbrellas_and_sheets_are_counted),
        cmocka_unit_test(two_fans_at_a_vertex_are_two_loops),
        cmocka_unit_test(random_polygons_are_as_slow_searches_say),
        cmocka_unit_test(broken_faces_are_named_and_left_out),
        cmocka_unit_test(impossible_counts_are_our_error),
        cmocka_unit_test(garbage_is_bounded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
