/* The judges of the memory exercises: known submissions, known values, and answers of any bytes. */
#include "graders/judges/judge.h"
#include "tests/unit/submissions.h"

#include <setjmp.h>
#include <stdarg.h>

#include <cmocka.h>

extern const struct judge judge_memory_indexed_grid, judge_memory_strips,
    judge_memory_voxels_vs_mesh;

static void test_indexed_grid_submissions(void **state)
{
    (void)state;
    submissions_check(&judge_memory_indexed_grid, "memory");
}

static void test_strips_submissions(void **state)
{
    (void)state;
    submissions_check(&judge_memory_strips, "memory");
}

static void test_voxels_vs_mesh_submissions(void **state)
{
    (void)state;
    submissions_check(&judge_memory_voxels_vs_mesh, "memory");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_indexed_grid_submissions),
                                       cmocka_unit_test(test_strips_submissions),
                                       cmocka_unit_test(test_voxels_vs_mesh_submissions)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
