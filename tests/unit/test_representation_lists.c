/* Lists of triangles, strips, fans, edges and faces: worked examples, and damage that their checks
 * find. What holds for every representation is in test_representation.c. */
#include "reference/mesh/generate.h"
#include "reference/representation/edge_list.h"
#include "reference/representation/edge_numbers.h"
#include "reference/representation/extended_edge_list.h"
#include "reference/representation/face_edge_vertex.h"
#include "reference/representation/indexed_csr.h"
#include "reference/representation/indexed_mesh.h"
#include "reference/representation/indexed_strips.h"
#include "reference/representation/isolated_triangles.h"
#include "reference/representation/triangle_fans.h"
#include "reference/representation/triangle_strips.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* -- worked examples -------------------------------------------------------------------------- */

/* The square of two triangles that the headers draw. */
static struct mesh square(void)
{
    static const float positions[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    static const int32_t triangles[6] = {0, 1, 2, 0, 2, 3};
    struct mesh mesh;
    assert_int_equal(mesh_init(&mesh, 4, 2, NULL), 0);
    memcpy(mesh.positions, positions, sizeof positions);
    memcpy(mesh.triangles, triangles, sizeof triangles);
    return mesh;
}

static void the_square_of_the_headers(void **state)
{
    (void)state;
    struct mesh mesh = square();
    struct triangle_edge_list list;
    assert_int_equal(representation_edge_list.build(&list, &mesh, NULL), 0);
    const int32_t ends[10] = {0, 1, 1, 2, 2, 0, 2, 3, 3, 0}, edges[6] = {0, 1, 2, 2, 3, 4};
    assert_int_equal(list.edge_count, 5);
    assert_memory_equal(list.ends, ends, sizeof ends);
    assert_memory_equal(list.edges, edges, sizeof edges);
    representation_edge_list.release(&list);

    struct extended_edge_list extended;
    assert_int_equal(representation_extended_edge_list.build(&extended, &mesh, NULL), 0);
    const struct two_sided_edge rows[5] = {
        {0, 1, 0, -1}, {1, 2, 0, -1}, {2, 0, 0, 1}, {2, 3, 1, -1}, {3, 0, 1, -1}};
    assert_int_equal(extended.edges.count, 5);
    assert_memory_equal(extended.edges.table, rows, sizeof rows);
    assert_memory_equal(extended.face_edges, edges, sizeof edges);
    representation_extended_edge_list.release(&extended);

    struct indexed_csr csr;
    assert_int_equal(representation_indexed_csr.build(&csr, &mesh, NULL), 0);
    const int32_t starts[5] = {0, 2, 3, 5, 6}, faces[6] = {0, 1, 0, 0, 1, 1};
    assert_memory_equal(csr.starts, starts, sizeof starts);
    assert_memory_equal(csr.vertex_faces, faces, sizeof faces);
    representation_indexed_csr.release(&csr);
    mesh_release(&mesh);
}

/* Document 001: faces 0 1 2 3 and 1 5 4 2, counted from 0 here; its table of edges. */
static const float document_positions[18] = {0, 0, 0, 0, 2, -1, 0, 3, 2,
                                             0, 1, 2, 2, 4, 1,  2, 3, -1};

static void the_example_of_the_course(void **state)
{
    (void)state;
    const int32_t starts[3] = {0, 4, 8}, corners[8] = {0, 1, 2, 3, 1, 5, 4, 2};
    struct listed_polygons polygons = {document_positions, starts, corners, 6, 2};
    struct face_edge_vertex lists;
    assert_int_equal(face_edge_vertex_from_polygons(&lists, &polygons, NULL), 0);
    assert_int_equal(representation_face_edge_vertex.check(&lists, NULL), 0);
    const int32_t face_edges[8] = {0, 1, 2, 3, 4, 5, 6, 1};
    const struct two_sided_edge edges[7] = {{0, 1, 0, -1}, {1, 2, 0, 1},  {2, 3, 0, -1},
                                            {3, 0, 0, -1}, {1, 5, 1, -1}, {5, 4, 1, -1},
                                            {4, 2, 1, -1}};
    assert_int_equal(lists.edges.count, 7);
    assert_memory_equal(lists.face_edges, face_edges, sizeof face_edges);
    assert_memory_equal(lists.edges.table, edges, sizeof edges);
    int32_t back[4];
    assert_int_equal(face_edge_vertex_sides(&lists, 1), 4);
    face_edge_vertex_corners(&lists, 1, back);
    assert_memory_equal(back, corners + 4, sizeof back);
    struct mesh mesh;
    struct error err = {0};
    assert_int_equal(representation_face_edge_vertex.to_mesh(&lists, &mesh, &err), -1);
    assert_string_equal(err.text, "face 0 has 4 sides: it is no triangle");
    int32_t around[6];
    assert_int_equal(representation_face_edge_vertex.faces_around_vertex(&lists, 1, around, 6), 2);
    assert_int_equal(representation_face_edge_vertex.faces_around_vertex(&lists, 0, around, 6), 1);
    assert_true(representation_face_edge_vertex.is_edge(&lists, 2, 4));
    assert_false(representation_face_edge_vertex.is_edge(&lists, 0, 2));
    int32_t loop[6], loop_starts[7];
    assert_int_equal(
        representation_face_edge_vertex.boundary_loops(&lists, loop, loop_starts, NULL), 1);
    assert_int_equal(loop_starts[1], 6);
    representation_face_edge_vertex.release(&lists);
}

static void impossible_polygons_are_refused(void **state)
{
    (void)state;
    static const struct {
        int32_t starts[4], corners[12];
        const char *message;
    } cases[] = {
        {{0, 2, 5, 8}, {0, 1, 0, 1, 2, 1, 3, 2}, "face 0 has 2 corners: at least 3 are needed"},
        {{0, 4, 7, 10}, {0, 1, 2, 1, 0, 1, 2, 1, 3, 2}, "face 0 has vertex 1 twice"},
        {{0, 3, 6, 9}, {0, 1, 2, 0, 6, 2, 1, 3, 2}, "face 1 names vertex 6 of 6"},
        {{0, 3, 6, 9},
         {0, 1, 2, 0, 1, 3, 1, 3, 2},
         "edge {0,1} runs the same way in faces 0 and 1"},
        {{0, 3, 6, 9},
         {0, 1, 2, 1, 0, 3, 0, 1, 4},
         "edge {0,1} is in faces 0, 1 and 2: it can have two"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct listed_polygons polygons = {document_positions, cases[i].starts, cases[i].corners, 6,
                                           3};
        struct face_edge_vertex lists;
        struct error err = {0};
        assert_int_equal(face_edge_vertex_from_polygons(&lists, &polygons, &err), -1);
        assert_string_equal(err.text, cases[i].message);
        assert_null(lists.positions);
    }
}

static void refusals_name_the_element(void **state)
{
    (void)state;
    struct mesh mesh = square();
    struct soup soup;
    struct error err = {0};
    assert_int_equal(change_add_isolated_vertices(&mesh, 1, 3, NULL), 0);
    assert_int_equal(representation_isolated_triangles.build(&soup, &mesh, &err), -1);
    assert_non_null(strstr(err.text, "is in no triangle: a table of isolated triangles"));
    mesh_release(&mesh);
    mesh = square();
    mesh.triangles[5] = 2;
    struct triangle_edge_list list;
    err.text[0] = '\0';
    assert_int_equal(representation_edge_list.build(&list, &mesh, &err), -1);
    assert_string_equal(err.text, "triangle 1 has corners 0 2 2: two are the same vertex");
    mesh_release(&mesh);
}

/* -- what the course claims of strips --------------------------------------------------------- */

/* Problem 4.3: strips of the grid store and process each vertex about twice, and the indexed mesh
 * takes half as much memory again; fans do not come near. */
static void strips_and_fans_of_a_grid(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_grid(&mesh, 128, 128, NULL), 0);
    struct strips strips;
    assert_int_equal(representation_triangle_strips.build(&strips, &mesh, NULL), 0);
    assert_int_equal(strips.strip_count, 128);
    assert_int_equal(strips.vertex_count, 2 * 129 * 128);
    int64_t bytes = representation_triangle_strips.bytes(&strips);
    assert_int_equal(bytes + 4 * 128, 397316); /* the course's 8 bytes a strip */
    struct triangle_fans fans;
    assert_int_equal(representation_triangle_fans.build(&fans, &mesh, NULL), 0);
    assert_int_equal(representation_triangle_fans.face_count(&fans), mesh.triangle_count);
    assert_true(fans.entries.vertex_count > strips.vertex_count);
    assert_true(fans.entries.vertex_count < 8 * mesh.triangle_count / 5);
    representation_triangle_fans.release(&fans);
    representation_triangle_strips.release(&strips);
    mesh_release(&mesh);
}

static void a_whole_ring_is_one_fan(void **state)
{
    (void)state;
    struct mesh mesh;
    struct triangle_fans fans;
    assert_int_equal(generate_disc(&mesh, 1, 9, NULL), 0);
    assert_int_equal(change_scramble(&mesh, 4, NULL), 0);
    assert_int_equal(representation_triangle_fans.build(&fans, &mesh, NULL), 0);
    assert_int_equal(fans.entries.strip_count, 1);
    assert_int_equal(fans.entries.vertex_count, 11); /* the centre, nine, and the first again */
    representation_triangle_fans.release(&fans);
    mesh_release(&mesh);
}

/* -- damage ----------------------------------------------------------------------------------- */

/* A table of a representation. Redundant: no single entry can change without a contradiction. */
struct table {
    int32_t *values;
    int64_t count;
    bool is_redundant;
};

struct tables {
    float *positions;
    int64_t position_count;
    struct table tables[3]; /* unused ones have no values */
};

static struct tables soup_tables(void *self)
{
    struct soup *soup = self;
    return (struct tables){soup->corners, 9 * (int64_t)soup->triangle_count, {{0}}};
}

static struct tables strips_tables(void *self)
{
    struct strips *strips = self;
    return (struct tables){strips->positions,
                           3 * (int64_t)strips->vertex_count,
                           {{strips->first_vertex, strips->strip_count + 1, false}}};
}

static struct tables fans_tables(void *self)
{
    struct triangle_fans *fans = self;
    return strips_tables(&fans->entries);
}

static struct tables mesh_tables(void *self)
{
    struct mesh *mesh = self;
    return (struct tables){mesh->positions,
                           3 * (int64_t)mesh->vertex_count,
                           {{mesh->triangles, 3 * (int64_t)mesh->triangle_count, false}}};
}

static struct tables csr_tables(void *self)
{
    struct indexed_csr *csr = self;
    struct tables t = mesh_tables(&csr->mesh);
    t.tables[0].is_redundant = true;
    t.tables[1] = (struct table){csr->starts, csr->mesh.vertex_count + 1, true};
    t.tables[2] = (struct table){csr->vertex_faces, 3 * (int64_t)csr->mesh.triangle_count, true};
    return t;
}

static struct tables indexed_strips_tables(void *self)
{
    struct indexed_strips *strips = self;
    return (struct tables){strips->positions,
                           3 * (int64_t)strips->vertex_count,
                           {{strips->starts, strips->strip_count + 1, false},
                            {strips->indices, strips->index_count, false}}};
}

static struct tables edge_list_tables(void *self)
{
    struct triangle_edge_list *list = self;
    return (struct tables){list->positions,
                           3 * (int64_t)list->vertex_count,
                           {{list->ends, 2 * (int64_t)list->edge_count, true},
                            {list->edges, 3 * (int64_t)list->face_count, true}}};
}

static struct tables extended_tables(void *self)
{
    struct extended_edge_list *list = self;
    return (struct tables){list->positions,
                           3 * (int64_t)list->edges.vertex_count,
                           {{&list->edges.table[0].from, 4 * (int64_t)list->edges.count, true},
                            {list->face_edges, 3 * (int64_t)list->edges.face_count, true}}};
}

static struct tables face_edge_vertex_tables(void *self)
{
    struct face_edge_vertex *list = self;
    return (struct tables){list->positions,
                           3 * (int64_t)list->edges.vertex_count,
                           {{&list->edges.table[0].from, 4 * (int64_t)list->edges.count, true},
                            {list->starts, list->edges.face_count + 1, true},
                            {list->face_edges, list->side_count, true}}};
}

static bool names_an_element(const char *text)
{
    static const char *const words[] = {"vertex ", "edge ",  "edges ",    "triangle ",
                                        "face ",   "strip ", "vertices ", "strips end"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strstr(text, words[i]))
            return true;
    return false;
}

static void damage_entry(const struct representation *kind, void *self, const struct table *table,
                         int64_t i)
{
    int32_t right = table->values[i];
    const int32_t wrong[] = {-7, INT32_MIN, INT32_MAX, 1000,     -1,
                             0,  right + 1, right - 1, right + 2};
    for (size_t w = 0; w < sizeof wrong / sizeof *wrong; w++) {
        struct error err = {0};
        if (wrong[w] == right)
            continue;
        table->values[i] = wrong[w];
        int code = kind->check(self, &err);
        bool is_wild = wrong[w] < -1 || wrong[w] >= 1000;
        if ((is_wild || table->is_redundant) && code != -1)
            fail_msg("%s: entry %lld changed from %d to %d is not found", kind->name, (long long)i,
                     right, wrong[w]);
        if (code == -1 && !names_an_element(err.text))
            fail_msg("%s: \"%s\" names no element", kind->name, err.text);
    }
    table->values[i] = right;
}

static void damage_all(const struct representation *kind, struct tables (*tables_of)(void *),
                       const struct mesh *mesh)
{
    void *self;
    assert_int_equal(representation_new(kind, &self, mesh, NULL), 0);
    struct tables t = tables_of(self);
    for (int64_t i = 0; i < t.position_count; i++) {
        struct error err = {0};
        float right = t.positions[i];
        t.positions[i] = i % 2 ? NAN : -INFINITY;
        assert_int_equal(kind->check(self, &err), -1);
        assert_true(names_an_element(err.text));
        t.positions[i] = right;
    }
    for (int which = 0; which < 3; which++)
        for (int64_t i = 0; i < t.tables[which].count; i++)
            damage_entry(kind, self, &t.tables[which], i);
    assert_int_equal(kind->check(self, NULL), 0);
    representation_delete(kind, self);
}

static void damage_is_found(void **state)
{
    (void)state;
    static const struct {
        const struct representation *kind;
        struct tables (*tables_of)(void *);
    } cases[] = {{&representation_isolated_triangles, soup_tables},
                 {&representation_triangle_strips, strips_tables},
                 {&representation_triangle_fans, fans_tables},
                 {&representation_indexed_mesh, mesh_tables},
                 {&representation_indexed_csr, csr_tables},
                 {&representation_indexed_strips, indexed_strips_tables},
                 {&representation_edge_list, edge_list_tables},
                 {&representation_extended_edge_list, extended_tables},
                 {&representation_face_edge_vertex, face_edge_vertex_tables}};
    for (int seed = 0; seed < 3; seed++) {
        struct mesh mesh;
        assert_int_equal(seed == 0 ? generate_tetrahedron(&mesh, NULL)
                                   : generate_grid(&mesh, 3, 2 + seed, NULL),
                         0);
        assert_int_equal(change_scramble(&mesh, (uint64_t)seed, NULL), 0);
        for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
            damage_all(cases[i].kind, cases[i].tables_of, &mesh);
        mesh_release(&mesh);
    }
}

/* A face that goes through vertex 0 twice: every edge starts where the one before ends, all the
 * same. */
static void pinched_faces_are_found(void **state)
{
    (void)state;
    float positions[15] = {0};
    struct two_sided_edge edges[6] = {{0, 1, 0, -1}, {1, 2, 0, -1}, {2, 0, 0, -1},
                                      {0, 3, 0, -1}, {3, 4, 0, -1}, {4, 0, 0, -1}};
    int32_t starts[2] = {0, 6}, face_edges[6] = {0, 1, 2, 3, 4, 5};
    struct face_edge_vertex lists = {positions, {edges, 6, 5, 1}, starts, face_edges, 6};
    struct error err = {0};
    assert_int_equal(representation_face_edge_vertex.check(&lists, &err), -1);
    assert_string_equal(err.text, "face 0 has vertex 0 twice");
}

static void double_edges_are_found(void **state)
{
    (void)state;
    const int32_t pairs[8] = {0, 1, 1, 2, 2, 0, 2, 1};
    struct error err = {0};
    assert_int_equal(edge_numbers_check(pairs, 2, 3, 3, NULL), 0);
    assert_int_equal(edge_numbers_check(pairs, 2, 4, 3, &err), -1);
    assert_string_equal(err.text, "edges 1 and 3 both join vertices 2 and 1");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_square_of_the_headers),
        cmocka_unit_test(the_example_of_the_course),
        cmocka_unit_test(impossible_polygons_are_refused),
        cmocka_unit_test(refusals_name_the_element),
        cmocka_unit_test(strips_and_fans_of_a_grid),
        cmocka_unit_test(a_whole_ring_is_one_fan),
        cmocka_unit_test(damage_is_found),
        cmocka_unit_test(pinched_faces_are_found),
        cmocka_unit_test(double_edges_are_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
