/* What a bench run measures: quick, full and thorough plans. */
#include "bench/compare/plan.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static struct plan made(struct plan_wish wish)
{
    struct plan plan;
    struct error err = {""};
    wish.program = "/bin/meshgrade";
    wish.peers_folder = "/nowhere";
    if (plan_make(&plan, &wish, &err) != 0)
        fail_msg("%s", err.text);
    return plan;
}

static const struct job *find(const struct plan *plan, const char *name)
{
    for (int i = 0; i < plan->job_count; i++)
        if (strcmp(plan->jobs[i].name, name) == 0)
            return &plan->jobs[i];
    return NULL;
}

/* The journal finds a block by the name of its job. */
static void assert_names_differ(const struct plan *plan)
{
    for (int i = 0; i < plan->job_count; i++)
        assert_ptr_equal(find(plan, plan->jobs[i].name), &plan->jobs[i]);
}

static void names_of_jobs_differ(void **state)
{
    (void)state;
    struct plan_wish wishes[] = {{.what = BENCH_ALL, .quick = true},
                                 {.what = BENCH_ALL},
                                 {.what = BENCH_ALL, .thorough = true}};
    for (size_t i = 0; i < sizeof wishes / sizeof *wishes; i++) {
        struct plan plan = made(wishes[i]);
        assert_true(plan.job_count > 3);
        assert_names_differ(&plan);
        plan_release(&plan);
    }
}

/* Resuming a full run as a thorough one must find every block that is there. */
static void thorough_has_all_of_full(void **state)
{
    (void)state;
    struct plan full = made((struct plan_wish){.what = BENCH_ALL});
    struct plan thorough = made((struct plan_wish){.what = BENCH_ALL, .thorough = true});
    assert_true(thorough.job_count > full.job_count);
    for (int i = 0; i < full.job_count; i++) {
        const struct job *same = find(&thorough, full.jobs[i].name);
        assert_non_null(same);
        assert_true(same->blocks > full.jobs[i].blocks);
    }
    plan_release(&full);
    plan_release(&thorough);
}

/* From six blocks on an interval is sure to 95 %: a full run finishes them before it goes on. */
static void full_finishes_what_it_begins(void **state)
{
    (void)state;
    struct plan full = made((struct plan_wish){.what = BENCH_ALL});
    struct plan quick = made((struct plan_wish){.what = BENCH_ALL, .quick = true});
    assert_int_equal(full.blocks_at_once, 6);
    assert_int_equal(full.jobs[0].blocks, 6);
    assert_int_equal(quick.blocks_at_once, 1);
    plan_release(&full);
    plan_release(&quick);
}

static void one_mesh_and_blocks_as_wished(void **state)
{
    (void)state;
    struct plan plan =
        made((struct plan_wish){.what = BENCH_KERNELS, .mesh = "torus-10k-scrambled", .blocks = 9});
    assert_int_equal(plan.job_count, 1);
    assert_string_equal(plan.jobs[0].name, "kernels torus-10k-scrambled");
    assert_int_equal(plan.jobs[0].blocks, 9);
    plan_release(&plan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(names_of_jobs_differ),
                                       cmocka_unit_test(thorough_has_all_of_full),
                                       cmocka_unit_test(full_finishes_what_it_begins),
                                       cmocka_unit_test(one_mesh_and_blocks_as_wished)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
