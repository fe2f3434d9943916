/* The table of reference/representation/README.md says what the code says. When this fails, the
 * rows to put there are what it prints. */
#include "reference/mesh/generate.h"
#include "reference/representation/representation.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const char readme_path[] = "reference/representation/README.md";

/* The file of a representation: its name with underscores. */
static void file_name(const struct representation *kind, char *text, size_t capacity)
{
    snprintf(text, capacity, "%s.h", kind->name);
    for (char *c = text; *c; c++)
        if (*c == '-')
            *c = '_';
}

static void feature_letters(unsigned holds, char text[12])
{
    static const char letters[] = "BIDOEV";
    for (int i = 0; i < 6; i++) {
        text[2 * i] = holds >> i & 1 ? letters[i] : '.';
        text[2 * i + 1] = i < 5 ? ' ' : '\0';
    }
}

/* One row, with the bytes a triangle measured on `mesh`. */
static void write_row(const struct representation *kind, const struct mesh *mesh, char *row,
                      size_t capacity)
{
    char file[64], formula[100], features[12];
    void *self;
    file_name(kind, file, sizeof file);
    representation_formula(kind, formula, sizeof formula);
    feature_letters(kind->holds, features);
    assert_int_equal(representation_new(kind, &self, mesh, NULL), 0);
    double bytes = (double)kind->bytes(self) / mesh->triangle_count;
    snprintf(row, capacity, "| [%s](%s) | %s | %s | %.1f | `%s` | %s | %s | %s | %s | %s |\n",
             kind->title, file, kind->documents, formula, bytes, features,
             kind->cost[QUERY_FACE_VERTICES], kind->cost[QUERY_FACE_NEIGHBOURS],
             kind->cost[QUERY_FACES_AROUND_VERTEX], kind->cost[QUERY_VERTICES_AROUND_VERTEX],
             kind->cost[QUERY_IS_EDGE]);
    representation_delete(kind, self);
}

static char *read_readme(void)
{
    FILE *file = fopen(readme_path, "rb");
    assert_non_null(file);
    char *text = calloc(1 << 16, 1);
    assert_non_null(text);
    size_t count = fread(text, 1, (1 << 16) - 1, file);
    assert_true(count > 0 && count < (1 << 16) - 1);
    fclose(file);
    return text;
}

static int count_rows(const char *text)
{
    int rows = 0;
    for (const char *at = strstr(text, "\n| ["); at; at = strstr(at + 1, "\n| ["))
        rows++;
    return rows;
}

static void the_table_is_the_codes(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_icosphere(&mesh, 5, NULL), 0);
    char *readme = read_readme();
    int rows = 0, missing = 0;
    for (; representation_table[rows]; rows++) {
        char row[400];
        write_row(representation_table[rows], &mesh, row, sizeof row);
        if (!strstr(readme, row)) {
            print_error("%s lacks this row:\n%s", readme_path, row);
            missing++;
        }
    }
    assert_int_equal(missing, 0);
    assert_int_equal(count_rows(readme), rows); /* and no other */
    free(readme);
    mesh_release(&mesh);
}

static void formulas_are_written_out(void **state)
{
    (void)state;
    char text[100];
    representation_formula(representation_find("indexed-mesh"), text, sizeof text);
    assert_string_equal(text, "12 V + 12 F");
    representation_formula(representation_find("triangle-strips"), text, sizeof text);
    assert_string_equal(text, "4 S + 12 N + 4");
    representation_formula(representation_find("indexed-mesh"), text, 6);
    assert_string_equal(text, "12 V ");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_table_is_the_codes),
        cmocka_unit_test(formulas_are_written_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
