/* Hints as tables: against every subset of small sets, and the ready-made ones on meshes. */
#include "graders/library/topology_hints.h"
#include "reference/mesh/generate.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { COUNT = 6 };

static bool is_even(const void *context, int64_t element)
{
    (void)context;
    return element % 2 == 0;
}

static bool is_low(const void *context, int64_t element)
{
    (void)context;
    return element < 4;
}

static bool is_in(const void *context, int64_t element)
{
    const unsigned *set = context;
    return *set >> element & 1;
}

static const struct hint_rule rules[] = {{is_even, HINT_ALL_OF_THESE, {"even", "pares"}},
                                         {is_low, HINT_ONLY_THESE, {"low", "bajos"}}};

/* The set {0, 2, 4} is the even ones; sets within {0, 1, 2, 3} are low; others are nothing. */
static void every_subset_gets_its_hint(void **state)
{
    (void)state;
    for (unsigned set = 0; set < 1u << COUNT; set++) {
        const char *right = set == 21 ? "even" : set && set < 16 ? "low" : NULL;
        uint8_t marks[COUNT];
        for (int i = 0; i < COUNT; i++)
            marks[i] = (uint8_t)(set >> i & 1 ? 3 : i % 3);
        struct phrase hint = hint_find(rules, 2, &set, COUNT, is_in);
        struct phrase marked = hint_find_marked(rules, 2, NULL, COUNT, marks, 3);
        assert_ptr_equal(hint.en, marked.en);
        assert_int_equal(hint.en != NULL, right != NULL);
        if (right)
            assert_string_equal(hint.en, right);
    }
    unsigned none = 0;
    assert_null(hint_find(rules, 2, &none, 0, is_in).en);
    assert_null(hint_find(NULL, 0, &none, COUNT, is_in).en);
}

/* -- ready-made ones -------------------------------------------------------------------------- */

struct trial {
    struct mesh mesh;
    struct face_topology t;
};

/* A grid beside a bipyramid of valence 12 beside a book of 3, two isolated vertices at the end, and
 * a degenerate triangle. */
static void begin(struct trial *trial)
{
    struct mesh other;
    assert_int_equal(generate_grid(&trial->mesh, 3, 3, NULL), 0);
    assert_int_equal(generate_bipyramid(&other, 12, NULL), 0);
    assert_int_equal(change_append(&trial->mesh, &other, 5, 0, 0, NULL), 0);
    mesh_release(&other);
    assert_int_equal(generate_book(&other, 3, NULL), 0);
    assert_int_equal(change_append(&trial->mesh, &other, 9, 0, 0, NULL), 0);
    mesh_release(&other);
    assert_int_equal(change_add_degenerate_triangles(&trial->mesh, 1, 1, NULL), 0);
    struct face_table table = {.corners = trial->mesh.triangles,
                               .face_count = trial->mesh.triangle_count,
                               .corner_count = 3 * (int64_t)trial->mesh.triangle_count,
                               .vertex_count = trial->mesh.vertex_count + 2};
    assert_int_equal(topology_build(&table, &trial->t, NULL), 0);
}

static void end(struct trial *trial)
{
    topology_release(&trial->t);
    mesh_release(&trial->mesh);
}

/* Every rule is told when just its elements are lost, unless a rule before it holds for these, and
 * so at least some element has it. */
static void assert_rules_tell(const struct hint_rule *table, int count, const void *context,
                              int64_t element_count)
{
    uint8_t *marks = calloc((size_t)element_count + 1, 1);
    assert_non_null(marks);
    for (int rule = 0; rule < count; rule++) {
        int64_t lost = 0;
        for (int64_t i = 0; i < element_count; i++)
            lost += marks[i] = table[rule].holds(context, i);
        struct phrase hint = hint_find_marked(table, count, context, element_count, marks, 1);
        assert_int_equal(hint.en != NULL, lost > 0);
        int told = 0;
        while (lost > 0 && hint.en != table[told].hint.en)
            told++;
        assert_true(told <= rule);
        assert_true(strlen(table[rule].hint.es) > 10);
    }
    memset(marks, 0, (size_t)element_count);
    assert_null(hint_find_marked(table, count, context, element_count, marks, 1).en);
    free(marks);
}

static void ready_made_rules_tell(void **state)
{
    (void)state;
    struct trial trial;
    begin(&trial);
    const struct face_topology *t = &trial.t;
    assert_rules_tell(topology_edges_lost, TOPOLOGY_EDGES_LOST, t, t->edge_count);
    assert_rules_tell(topology_vertices_lost, TOPOLOGY_VERTICES_LOST, t, t->table.vertex_count);
    assert_rules_tell(topology_faces_lost, TOPOLOGY_FACES_LOST, t, t->table.face_count);
    end(&trial);
}

static void predicates_hold_where_they_should(void **state)
{
    (void)state;
    struct trial trial;
    begin(&trial);
    const struct face_topology *t = &trial.t;
    int64_t counts[6] = {0};
    for (int64_t e = 0; e < t->edge_count; e++) {
        int sides = topology_edge_on_boundary(t, e) + topology_edge_inside(t, e) +
                    topology_edge_nonmanifold(t, e);
        assert_int_equal(sides, 1);
        counts[0] += topology_edge_on_boundary(t, e);
        counts[1] += topology_edge_nonmanifold(t, e);
        counts[2] += topology_edge_at_large(t, e);
        counts[3] += topology_edge_elsewhere(t, e);
    }
    assert_int_equal(counts[0], t->boundary.count);
    assert_int_equal(counts[1], 1);
    assert_int_equal(counts[2], 24); /* all that lead to an apex */
    assert_int_equal(counts[3], 36 + 7);
    for (int64_t v = 0; v < t->table.vertex_count; v++) {
        counts[4] += topology_vertex_isolated(t, v);
        counts[5] += topology_vertex_large(t, v);
        assert_false(topology_vertex_isolated(t, v) && topology_vertex_elsewhere(t, v));
    }
    assert_int_equal(counts[4], 2);
    assert_int_equal(counts[5], 2);
    assert_true(topology_vertex_last(t, t->table.vertex_count - 1));
    end(&trial);
}

static void loops_too(void **state)
{
    (void)state;
    struct mesh mesh, other;
    assert_int_equal(generate_grid(&mesh, 3, 3, NULL), 0);
    assert_int_equal(generate_one_triangle(&other, NULL), 0);
    assert_int_equal(change_append(&mesh, &other, 5, 0, 0, NULL), 0);
    struct face_table table = {.corners = mesh.triangles,
                               .face_count = mesh.triangle_count,
                               .corner_count = 3 * (int64_t)mesh.triangle_count,
                               .vertex_count = mesh.vertex_count};
    struct face_topology t;
    assert_int_equal(topology_build(&table, &t, NULL), 0);
    assert_int_equal(t.loop_count, 2);
    assert_rules_tell(topology_loops_lost, TOPOLOGY_LOOPS_LOST, &t, t.loop_count);
    const uint8_t second[] = {0, 1};
    assert_string_equal(
        hint_find_marked(topology_loops_lost, TOPOLOGY_LOOPS_LOST, &t, 2, second, 1).en,
        "Only loops of three edges are lost.");
    topology_release(&t);
    mesh_release(&mesh);
    mesh_release(&other);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_subset_gets_its_hint),
        cmocka_unit_test(ready_made_rules_tell),
        cmocka_unit_test(predicates_hold_where_they_should),
        cmocka_unit_test(loops_too),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
