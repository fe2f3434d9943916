/* Accesses of queries are counted exactly, and grow as the headers claim. */
#include "bench/compare/accesses.h"
#include "bench/compare/counted_reads.h"
#include "reference/mesh/generate.h"

#include <malloc.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct access_counts counts;

static int count(void **state)
{
    struct error err;
    (void)state;
    if (accesses_count(&counts, &err) == 0)
        return 0;
    print_error("%s\n", err.text);
    return -1;
}

static int release(void **state)
{
    (void)state;
    accesses_release(&counts);
    accesses_release(&counts);
    return 0;
}

static const struct access_count *find(const char *name, enum query query)
{
    for (int i = 0; i < counts.count; i++)
        if (strcmp(counts.rows[i].kind->name, name) == 0 && counts.rows[i].query == query)
            return counts.rows + i;
    fail_msg("%s is not counted", name);
    return NULL;
}

static void assert_count(double found, double expected)
{
    if (found != expected)
        fail_msg("%g accesses, %g expected", found, expected);
}

/* What can be said in advance, from the headers' pictures. */
static void known_costs_are_counted(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        /* every triangle is looked at, once */
        double triangles = (double)counts.triangles[i];
        assert_count(find("indexed-mesh", QUERY_FACES_AROUND_VERTEX)->by_size[i], triangles);
        assert_count(find("indexed-mesh", QUERY_IS_EDGE)->by_size[i], triangles);
        /* every edge, of which there are 3/2 a triangle */
        assert_count(find("extended-edge-list", QUERY_FACES_AROUND_VERTEX)->by_size[i],
                     1.5 * triangles);
        assert_count(find("face-edge-vertex", QUERY_IS_EDGE)->by_size[i], 1.5 * triangles);
        /* its row */
        assert_count(find("indexed-mesh", QUERY_FACE_VERTICES)->by_size[i], 1);
        assert_count(find("corner-table", QUERY_FACE_VERTICES)->by_size[i], 1);
        /* the three edges of the face, each with its neighbour */
        assert_count(find("directed-edges", QUERY_FACE_NEIGHBOURS)->by_size[i], 3);
        assert_count(find("directed-edges", QUERY_FACE_NEIGHBOURS)->by_valence[i], 3);
        /* the same whatever the size of the mesh */
        assert_count(find("half-edge", QUERY_FACES_AROUND_VERTEX)->by_size[i],
                     find("half-edge", QUERY_FACES_AROUND_VERTEX)->by_size[0]);
    }
}

static void claims_hold(void **state)
{
    (void)state;
    int kinds = 0;
    while (representation_table[kinds])
        kinds++;
    assert_int_equal(counts.count, kinds * QUERY_COUNT);
    for (int i = 0; i < counts.count; i++) {
        const struct access_count *row = counts.rows + i;
        assert_true(row->by_size[0] > 0 || row->query == QUERY_FACE_VERTICES);
        if (!row->holds)
            print_error("%s, %s: claimed %s, %g and %g by size, %g and %g by valence\n",
                        row->kind->name, query_name(row->query), row->kind->cost[row->query],
                        row->by_size[0], row->by_size[1], row->by_valence[0], row->by_valence[1]);
    }
    for (int i = 0; i < counts.count; i++)
        assert_true(counts.rows[i].holds);
}

/* A claim that is too low or too high would be found: the growths differ among structures. */
static void growths_are_told_apart(void **state)
{
    (void)state;
    assert_string_equal(find("half-edge", QUERY_IS_EDGE)->growth, "k");
    assert_string_equal(find("edge-list", QUERY_IS_EDGE)->growth, "n");
    assert_string_equal(find("directed-edges", QUERY_FACE_NEIGHBOURS)->growth, "1");
    assert_string_equal(find("indexed-csr", QUERY_FACE_NEIGHBOURS)->growth, "k");
}

/* The tables of each representation are all of its bytes: none is read uncounted. */
static void tables_are_complete(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_torus(&mesh, 1, 1000, NULL), 0);
    for (int i = 0; representation_table[i]; i++) {
        const struct representation *kind = representation_table[i];
        const int64_t slack = 64; /* that an allocator gives beyond what was asked for */
        void *self;
        int64_t bytes = 0, tables = 0;
        assert_int_equal(representation_new(kind, &self, &mesh, NULL), 0);
        for (; tables < REPRESENTATION_TABLES_MAX && kind->tables[tables].row_bytes; tables++) {
            void *rows;
            memcpy(&rows, (char *)self + kind->tables[tables].offset, sizeof rows);
            bytes += (int64_t)malloc_usable_size(rows);
        }
        assert_in_range(bytes, kind->bytes(self), kind->bytes(self) + tables * slack);
        representation_delete(kind, self);
    }
    mesh_release(&mesh);
}

static void rows_are_written(void **state)
{
    (void)state;
    json_t *json = accesses_to_json(&counts);
    assert_int_equal(json_array_size(json), counts.count);
    const json_t *first = json_array_get(json, 0);
    assert_string_equal(json_string_value(json_object_get(first, "subject")),
                        counts.rows[0].kind->name);
    assert_string_equal(json_string_value(json_object_get(first, "query")), "face-vertices");
    assert_int_equal(json_array_size(json_object_get(first, "by_size")), 2);
    assert_int_equal(json_array_size(json_object_get(first, "by_valence")), 2);
    json_decref(json);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_costs_are_counted), cmocka_unit_test(claims_hold),
        cmocka_unit_test(growths_are_told_apart),  cmocka_unit_test(tables_are_complete),
        cmocka_unit_test(rows_are_written),
    };
    return cmocka_run_group_tests(tests, count, release);
}
