/* Reading callgrind's dumps: a real one, and everything that can be wrong with one. */
#include "bench/measure/callgrind.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* The shape of valgrind 3.19's output, cut short. */
static const char header[] =
    "# callgrind format\nversion: 1\ncreator: callgrind-3.19.0\npid: 10239\n"
    "cmd:  ./program 0\npart: 7\n\n\n"
    "desc: D1 cache: 32768 B, 64 B, 8-way associative\n"
    "desc: Timerange: Basic block 0 - 8462\n"
    "desc: Trigger: Client Request: call 7\n\npositions: line\n"
    "events: Ir Dr Dw I1mr D1mr D1mw ILmr DLmr DLmw\n";

static const char body[] = "summary: 23425 2106 3570 34 1 190 34 2 188\n\n\n"
                           "ob=(1) /box/program\nfl=(3) /box/runner.c\n"
                           "fn=(222) main\n25 2 0 0 1 0 0 1\n+3 1 1\n"
                           "cfi=(5) /box/student.c\ncfn=(230) edge_table_any\ncalls=1 -25 \n"
                           "* 23408 2103 3562 31 0 190 31 0 190\n\n"
                           "fl=(5)\nfn=(230)\n3 8 0 6 1 0 0 1\n+1 2000\n-1 21\n"
                           "cfi=(1) ???\ncfn=(232) calloc\ncalls=1 -12 \n* 1072 34 521\n"
                           "fi=(9) /usr/include/stdlib.h\n* 300\nfe=(5)\n\n"
                           "fn=(232)\n0 1072 34 521 15 0 125 15 0 125\n\n"
                           "totals: 23415 2105 3564 34 0 190 34 0 190\n";

static char *joined(const char *first, const char *second, const char *third)
{
    char *text = malloc(strlen(first) + strlen(second) + strlen(third) + 1);
    assert_non_null(text);
    strcpy(text, first);
    strcat(text, second);
    strcat(text, third);
    return text;
}

static void a_real_dump_is_read(void **state)
{
    (void)state;
    char *text = joined(header, body, "");
    struct callgrind_dump dump;
    struct error err = {0};
    assert_int_equal(callgrind_parse(text, strlen(text), &dump, &err), 0);
    free(text);
    assert_int_equal(dump.part, 7);
    assert_string_equal(dump.trigger, "Client Request: call 7");
    assert_string_equal(dump.label, "call 7");
    assert_true(dump.has_misses);
    assert_int_equal(dump.counts.instructions, 23425);
    assert_int_equal(dump.counts.data_reads, 2106);
    assert_int_equal(dump.counts.data_writes, 3570);
    assert_int_equal(dump.counts.l1_misses, 34 + 1 + 190);
    assert_int_equal(dump.counts.ll_misses, 34 + 2 + 188);
    assert_int_equal(callgrind_cost(&dump.counts), 23425 + 10 * 225 + 100 * 224);
    assert_int_equal(dump.hottest_count, 3);
    assert_string_equal(dump.hottest[0].name, "edge_table_any");
    assert_int_equal(dump.hottest[0].instructions, 8 + 2000 + 21 + 300);
    assert_string_equal(dump.hottest[1].name, "calloc");
    assert_int_equal(dump.hottest[1].instructions, 1072);
    assert_string_equal(dump.hottest[2].name, "main");
    assert_int_equal(dump.hottest[2].instructions, 3);
}

static void the_calls_that_are_asked_for_are_added_up(void **state)
{
    (void)state;
    static const char *const functions[] = {"edge_table_any", "not_there", NULL};
    static const char *const others[] = {"calloc", NULL};
    static const struct callgrind_calls of_main = {"main", functions, NULL, NULL};
    static const struct callgrind_calls of_answer = {"edge_table_any", others, "main", NULL};
    char *text = joined(header, body,
                        "fn=(222)\n30 1\ncfn=(230)\ncalls=2 3\n+1 100 1 1\n"
                        "cfn=(232)\ncalls=1 3\n+1 5000\n");
    struct callgrind_dump dump;
    assert_int_equal(callgrind_parse_calls(text, strlen(text), &of_main, &dump, NULL), 0);
    assert_int_equal(dump.called.instructions, 23408 + 100);
    assert_int_equal(dump.called.data_reads, 2103 + 1);
    assert_int_equal(dump.called.data_writes, 3562 + 1);
    assert_int_equal(dump.called.l1_misses, 31 + 0 + 190);
    assert_int_equal(dump.called.ll_misses, 31 + 0 + 190);
    assert_int_equal(dump.access_count, 0);
    assert_int_equal(callgrind_parse_calls(text, strlen(text), &of_answer, &dump, NULL), 0);
    assert_int_equal(dump.called.instructions, 1072);
    assert_int_equal(callgrind_parse(text, strlen(text), &dump, NULL), 0);
    assert_int_equal(dump.called.instructions, 0);
    free(text);
}

static void calls_of_accessors_are_counted_whoever_makes_them(void **state)
{
    (void)state;
    static const char *const accessors[] = {"calloc", "not_there", NULL};
    static const struct callgrind_calls calls = {NULL, NULL, NULL, accessors};
    char *text = joined(header, body, "fn=(222)\n30 1\ncfn=(232)\ncalls=41 3\n+1 5000\n");
    struct callgrind_dump dump;
    assert_int_equal(callgrind_parse_calls(text, strlen(text), &calls, &dump, NULL), 0);
    assert_int_equal(dump.access_count, 1 + 41);
    assert_int_equal(dump.called.instructions, 0);
    free(text);
    text = joined(header, body, "fn=(222)\n30 1\ncfn=(232)\ncalls=-4 3\n+1 5000\n");
    assert_int_equal(callgrind_parse_calls(text, strlen(text), &calls, &dump, NULL), -1);
    free(text);
}

static void only_the_hottest_are_kept(void **state)
{
    (void)state;
    char *text = joined(header, "summary: 100\n", "");
    for (int i = 1; i <= 20; i++) {
        char function[64];
        snprintf(function, sizeof function, "fn=(%d) f%d\n1 %d\n", i, i, (i * 7) % 20 + 1);
        char *longer = joined(text, function, "");
        free(text);
        text = longer;
    }
    struct callgrind_dump dump;
    assert_int_equal(callgrind_parse(text, strlen(text), &dump, NULL), 0);
    free(text);
    assert_int_equal(dump.hottest_count, CALLGRIND_HOTTEST);
    for (int i = 0; i < CALLGRIND_HOTTEST; i++)
        assert_int_equal(dump.hottest[i].instructions, 20 - i);
}

static void short_summaries_and_plain_counts_are_read(void **state)
{
    (void)state;
    struct callgrind_dump dump;
    char *text = joined(header, "summary: 0\n", "");
    assert_int_equal(callgrind_parse(text, strlen(text), &dump, NULL), 0);
    free(text);
    assert_int_equal(dump.counts.instructions, 0);
    assert_int_equal(dump.hottest_count, 0);
    const char plain[] = "part: 1\nevents: Ir\nsummary: 77";
    assert_int_equal(callgrind_parse(plain, strlen(plain), &dump, NULL), 0);
    assert_false(dump.has_misses);
    assert_int_equal(dump.counts.instructions, 77);
    assert_string_equal(dump.trigger, "");
}

static void names_are_made_printable_and_cut(void **state)
{
    (void)state;
    char name[300];
    memset(name, 'x', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    memcpy(name, "\x1b]8;\xff<b>", 8);
    char *text = joined("part: 1\nevents: Ir\nsummary: 77\nfn=(1) ", name, "\n1 77\n");
    struct callgrind_dump dump;
    assert_int_equal(callgrind_parse(text, strlen(text), &dump, NULL), 0);
    free(text);
    assert_int_equal(strlen(dump.hottest[0].name), CALLGRIND_NAME - 1);
    assert_memory_equal(dump.hottest[0].name, "?]8;?<b>x", 9);
}

static void wrong_dumps_are_errors_that_name_the_line(void **state)
{
    (void)state;
    static const char *const wrong[] = {
        "",
        "part: 1\n",
        "part: 1\nevents: Ir\n",
        "events: Ir\nsummary: 1\n",
        "part: 1\nevents: Dr Dw\nsummary: 1 1\n",
        "part: 1\nsummary: 1\nevents: Ir\n",
        "part: 1\nevents: Ir\nsummary: 1\nsummary: 1\n",
        "part: 1\nevents: Ir\nsummary: 1000000000000001\n",
        "part: 1\nevents: Ir\nsummary: 99999999999999999999999999\n",
        "part: 1\nevents: Ir\nsummary: -1\n",
        "part: 1\nevents: Ir\nsummary: 1x\n",
        "part: x\nevents: Ir\nsummary: 1\n",
        "part: 1\nevents: Ir\nsummary: 1\n5 5\n",
        "part: 1\nevents: Ir\nsummary: 1\nfn=f\n",
        "part: 1\nevents: Ir\nsummary: 1\nfn=(65536) f\n",
        "part: 1\nevents: Ir\nsummary: 1\nfn=(99999999999999999999) f\n",
        "part: 1\nevents: Ir\nsummary: 1\nfn=(1) f\n5 x\n",
        "part: 1\nevents: Ir\nsummary: 1\nfn=(1) f\ncalls=1 5\n5 5\n",
        "part: 1\nevents: Ir\nsummary: 1\ncfn=(1) f\ncalls=1 5\n5 5\n",
        "part: 1\npositions:\nevents: Ir\nsummary: 1\n",
        "part: 1\npositions: a b c\nevents: Ir\nsummary: 1\n",
        "part: 1\nevents: Ir a a a a a a a a a a a a a a a a a a a a a a a a a a a a a a a "
        "a\nsummary: 1\n",
    };
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        struct callgrind_dump dump;
        struct error err = {0};
        assert_int_equal(callgrind_parse(wrong[i], strlen(wrong[i]), &dump, &err), -1);
        assert_non_null(strstr(err.text, "line "));
    }
}

/* Every prefix and every single changed byte is read within its bounds (run with ASan). */
static void damaged_dumps_are_survived(void **state)
{
    (void)state;
    char *text = joined(header, body, "");
    size_t length = strlen(text);
    for (size_t i = 0; i < length; i++) {
        struct callgrind_dump dump;
        char *copy = malloc(i ? i : 1);
        assert_non_null(copy);
        memcpy(copy, text, i);
        int whole = callgrind_parse(copy, i, &dump, NULL);
        assert_true(whole == 0 || whole == -1);
        free(copy);
        char kept = text[i];
        text[i] = (char)(kept ^ 0x1f);
        (void)!callgrind_parse(text, length, &dump, NULL);
        assert_true(dump.hottest_count >= 0 && dump.hottest_count <= CALLGRIND_HOTTEST);
        text[i] = kept;
    }
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_real_dump_is_read),
        cmocka_unit_test(the_calls_that_are_asked_for_are_added_up),
        cmocka_unit_test(calls_of_accessors_are_counted_whoever_makes_them),
        cmocka_unit_test(only_the_hottest_are_kept),
        cmocka_unit_test(short_summaries_and_plain_counts_are_read),
        cmocka_unit_test(names_are_made_printable_and_cut),
        cmocka_unit_test(wrong_dumps_are_errors_that_name_the_line),
        cmocka_unit_test(damaged_dumps_are_survived),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
