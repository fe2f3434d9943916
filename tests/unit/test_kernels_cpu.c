/* MESHGRADE_CPU takes vectors away, gives none, and changes no answer. */
#include "reference/kernels/cpu.h"
#include "reference/kernels/kernel.h"
#include "reference/mesh/generate.h"
#include "tests/unit/kernel_checks.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const char *const kernels[] = {"edges-closed", "edges-any",      "twins",   "area",
                                      "face-normals", "vertex-normals", "stripify"};
enum { KERNELS = sizeof kernels / sizeof *kernels };

static void limit(const char *value)
{
    assert_int_equal(value ? setenv("MESHGRADE_CPU", value, 1) : unsetenv("MESHGRADE_CPU"), 0);
}

static int lift_limit(void **state)
{
    (void)state;
    return unsetenv("MESHGRADE_CPU");
}

static void what_is_not_limited_is_the_processor(void **state)
{
    (void)state;
    static const char *const values[] = {NULL, "", "avx512"};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
        limit(values[i]);
        assert_int_equal(cpu_check_limit(NULL), 0);
        assert_int_equal(cpu_vectors(), cpu_processor_vectors());
    }
}

/* Of every kernel, no variant above the limit is chosen, found by name or called available. */
static void wider_variants_are_not_there(void **state)
{
    (void)state;
    for (int most = CPU_PLAIN; most < CPU_VECTORS_COUNT; most++) {
        limit(cpu_vectors_name(most));
        assert_int_equal(cpu_check_limit(NULL), 0);
        assert_true((int)cpu_vectors() <= most);
        assert_true(cpu_vectors() <= cpu_processor_vectors());
        for (const struct kernel *k = kernel_table; k->name; k++)
            for (int wider = most + 1; wider < CPU_VECTORS_COUNT; wider++)
                if (strcmp(k->variant, cpu_vectors_name(wider)) == 0) {
                    assert_false(k->available());
                    assert_null(kernel_find(k->name, k->variant));
                    assert_string_not_equal(kernel_find(k->name, NULL)->variant, k->variant);
                }
    }
    limit("plain");
    for (int i = 0; i < KERNELS; i++)
        assert_string_equal(kernel_find(kernels[i], NULL)->variant, "plain");
}

static void another_value_is_refused_and_gives_nothing(void **state)
{
    (void)state;
    static const char *const values[] = {"AVX2", "sse", "avx512 ", "none"};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
        struct error err = {""};
        limit(values[i]);
        assert_int_equal(cpu_check_limit(&err), -1);
        assert_non_null(strstr(err.text, values[i]));
        assert_non_null(strstr(err.text, "plain, avx2 or avx512"));
        assert_int_equal(cpu_vectors(), CPU_PLAIN);
    }
}

/* The entries that choose at run time: the fastest on one thread, and what threads run. */
static void answers_stay_the_same(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_torus(&mesh, 1, 3000, NULL), 0);
    assert_int_equal(change_scramble(&mesh, 5, NULL), 0);
    for (int i = 0; i < KERNELS; i++) {
        int64_t count;
        limit("plain");
        void *meant = run_guarded(kernel_find(kernels[i], "plain"), &mesh, &count);
        bool is_area = strcmp(kernels[i], "area") == 0;
        size_t bytes = is_area ? sizeof(double) : 4 * (size_t)count; /* the first words at least */
        for (int most = CPU_PLAIN; most < CPU_VECTORS_COUNT; most++) {
            limit(cpu_vectors_name(most));
            const struct kernel *chosen[] = {kernel_find(kernels[i], NULL),
                                             kernel_find(kernels[i], "threads")};
            for (int way = 0; way < 2; way++) {
                int64_t found;
                if (!chosen[way])
                    continue;
                void *records = way ? run_guarded_on_threads(chosen[way], &mesh, 3, &found)
                                    : run_guarded(chosen[way], &mesh, &found);
                assert_int_equal(found, count);
                if (is_area)
                    assert_float_equal(*(double *)records, *(double *)meant, 1e-9);
                else
                    assert_memory_equal(records, meant, bytes);
                free_guarded(records);
            }
        }
        free_guarded(meant);
    }
    mesh_release(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(what_is_not_limited_is_the_processor, lift_limit),
        cmocka_unit_test_teardown(wider_variants_are_not_there, lift_limit),
        cmocka_unit_test_teardown(another_value_is_refused_and_gives_nothing, lift_limit),
        cmocka_unit_test_teardown(answers_stay_the_same, lift_limit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
