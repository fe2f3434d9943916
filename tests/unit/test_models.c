/* The real models are what exercises/models/README.md says. Runs from the root of the tree. */
#include "reference/formats/mesh_file.h"
#include "reference/mesh/check.h"
#include "tests/unit/mesh_measures.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* One row of the table. */
struct row {
    char name[40];
    int vertices, edges, triangles, boundary_edges, boundary_loops, components, euler, incoherent;
};

static bool parse_row(const char *line, struct row *row)
{
    return sscanf(line, "| `%39[a-z.]` | %d | %d | %d | %d | %d | %d | %d | %d |", row->name,
                  &row->vertices, &row->edges, &row->triangles, &row->boundary_edges,
                  &row->boundary_loops, &row->components, &row->euler, &row->incoherent) == 9;
}

static void assert_as_described(const struct row *row)
{
    char path[100];
    struct mesh mesh;
    struct topology found;
    struct error err = {0};
    snprintf(path, sizeof path, "exercises/models/%s", row->name);
    if (mesh_file_read(path, &mesh, &err))
        fail_msg("%s", err.text);
    assert_int_equal(mesh_topology(&mesh, &found, NULL), 0);
    assert_int_equal(found.vertex_count, row->vertices);
    assert_int_equal(found.edge_count, row->edges);
    assert_int_equal(found.triangle_count, row->triangles);
    assert_int_equal(found.boundary.count, row->boundary_edges);
    assert_int_equal(found.boundary_loop_count, row->boundary_loops);
    assert_int_equal(found.component_count, row->components);
    assert_int_equal(found.euler_characteristic, row->euler);
    assert_int_equal(found.incoherent.count, row->incoherent);
    assert_int_equal(found.degenerate.count + found.duplicate.count + found.isolated.count, 0);
    assert_int_equal(found.nonmanifold_edge.count + found.nonmanifold_vertex.count, 0);
    assert_true(signed_volume(&mesh) > 0.0);
    mesh_release(&mesh);
}

static void the_table_of_the_readme_is_right(void **state)
{
    (void)state;
    FILE *readme = fopen("exercises/models/README.md", "r");
    assert_non_null(readme);
    char line[1000];
    int rows = 0;
    while (fgets(line, sizeof line, readme)) {
        struct row row;
        if (parse_row(line, &row)) {
            assert_as_described(&row);
            rows++;
        }
    }
    assert_int_equal(fclose(readme), 0);
    assert_int_equal(rows, 4);
}

static void models_are_centred_and_one_unit_long(void **state)
{
    (void)state;
    static const char *const names[] = {"bunny", "horse", "mug", "spider"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char path[100];
        struct mesh mesh;
        snprintf(path, sizeof path, "exercises/models/%s.ply", names[i]);
        assert_int_equal(mesh_file_read(path, &mesh, NULL), 0);
        float longest = 0.0F;
        for (int axis = 0; axis < 3; axis++) {
            float low = INFINITY, high = -INFINITY;
            for (int64_t v = 0; v < mesh.vertex_count; v++) {
                low = fminf(low, mesh.positions[3 * v + axis]);
                high = fmaxf(high, mesh.positions[3 * v + axis]);
            }
            assert_true(fabsf(low + high) < 1e-6F);
            longest = fmaxf(longest, high - low);
        }
        assert_true(fabsf(longest - 1.0F) < 1e-6F);
        mesh_release(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_table_of_the_readme_is_right),
        cmocka_unit_test(models_are_centred_and_one_unit_long),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
