/* Whose is what libc asks for? Small programs that have libc allocate, with the runner's own shim. */
#include "graders/engine/run/session.h"
#include "tests/unit/known_program.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* `DO` is done in the call that is looked at. */
static const char PROGRAM[] =
    "#define _GNU_SOURCE\n#include \"edge-table-any.h\"\n"
    "#include <malloc.h>\n#include <search.h>\n#include <stdio.h>\n#include <stdlib.h>\n"
    "#include <string.h>\n#include <time.h>\n"
    "static int compare(const void *a, const void *b) { return a < b ? -1 : a > b; }\n"
    "int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,"
    " int32_t **edges)\n{\n(void)triangles; (void)triangle_count; (void)vertex_count;\n"
    "*edges = NULL;\nchar *text = NULL; size_t room = 0; FILE *stream; void *root = NULL;\n"
    "(void)text; (void)room; (void)stream; (void)root; (void)compare;\n"
    "DO\nreturn 0;\n}\n";

/* One call that does this. */
static struct control call(const char *what, int64_t failing_allocation)
{
    static const struct call_limits limits = {20000000000LL, 10000000000LL};
    char source[4096];
    struct known_program program;
    struct error err = {""};
    struct session session;
    struct box_outcome outcome;
    const char *at = strstr(PROGRAM, "DO\n");
    snprintf(source, sizeof source, "%.*s%s%s", (int)(at - PROGRAM), PROGRAM, what, at + 2);
    known_program_build(&program, source, "-fno-builtin"); /* or gcc leaves them out */
    struct session_plan plan = known_program_plan(&program);
    assert_int_equal(session_start(&session, &plan, &err), 0);
    enum call_end end = session_call(&session, KNOWN_INPUT_BYTES, failing_allocation, &limits);
    struct control claims = session.claims;
    assert_int_equal(session_end(&session, &outcome, &err), 0);
    if (end != CALL_ANSWERED)
        fail_msg("%s: ended by itself", what);
    session_release(&session);
    known_program_release(&program);
    return claims;
}

static void expect(const char *what, int64_t requests, int64_t left_bytes, int64_t left_blocks)
{
    struct control claims = call(what, 0);
    if (claims.allocation_count != requests || claims.heap_left_bytes != left_bytes ||
        claims.leaked_blocks != left_blocks || claims.bad_free_count != 0)
        fail_msg("%s: %lld requests, %lld bytes in %lld blocks left, %lld bad frees", what,
                 (long long)claims.allocation_count, (long long)claims.heap_left_bytes,
                 (long long)claims.leaked_blocks, (long long)claims.bad_free_count);
}

static void what_libc_keeps_is_its_own(void **state)
{
    (void)state;
    expect("getchar();", 0, 0, 0);
    expect("char line[80]; fgets(line, sizeof line, stdin);", 0, 0, 0);
    expect("time_t now = 0; localtime(&now);", 0, 0, 0);
    expect("char date[80]; time_t now = 0; strftime(date, sizeof date, \"%c %Z\", "
           "localtime(&now)); puts(date);",
           0, 0, 0);
    expect("fprintf(stderr, \"%f\\n\", 1e300);", 0, 0, 0);
}

static void what_libc_makes_for_him_is_the_students(void **state)
{
    (void)state;
    expect("text = strdup(\"edges\"); free(text);", 1, 0, 0);
    expect("text = strdup(\"edges\");", 1, 6, 1);
    expect("text = strndup(\"edges\", 2);", 1, 3, 1);
    expect("getline(&text, &room, stdin);", 1, 120, 1);
    expect("getline(&text, &room, stdin); free(text);", 1, 0, 0);
    expect("tsearch(&room, &root, compare);", 1, 24, 1);
    expect("tsearch(&room, &root, compare); tdelete(&room, &root, compare);", 1, 0, 0);
    expect("text = reallocarray(NULL, 3, 5);", 1, 15, 1);
    struct control claims = call("if (asprintf(&text, \"%d\", 12345) < 0) return -1;", 0);
    assert_int_equal(claims.leaked_blocks, 1);
    claims = call("if (asprintf(&text, \"%d\", 12345) < 0) return -1; free(text);", 0);
    assert_int_equal(claims.leaked_blocks, 0);
}

/* Written to until libc makes it larger, which is told when it is closed. */
static void a_stream_of_memory_gives_its_block_to_the_student(void **state)
{
    (void)state;
    static const char kept[] = "stream = open_memstream(&text, &room); if (!stream) return -1;\n"
                               "for (int i = 0; i < 20000; i++) fputs(\"edge \", stream);\n"
                               "fclose(stream);";
    char given_back[sizeof kept + 16];
    struct control claims = call(kept, 0);
    assert_int_equal(claims.leaked_blocks, 1);
    assert_int_equal(claims.heap_left_bytes, 100001);
    snprintf(given_back, sizeof given_back, "%s free(text);", kept);
    claims = call(given_back, 0);
    assert_int_equal(claims.leaked_blocks, 0);
    assert_int_equal(claims.heap_left_bytes, 0);
    assert_true(claims.heap_peak_bytes > 100000);
}

/* qsort takes a block and gives it back: nothing that the student must do, but memory. */
static void what_libc_takes_for_a_while_counts_for_the_peak(void **state)
{
    (void)state;
    struct control claims = call("int *table = calloc(100000, 4); if (!table) return -1;\n"
                                 "qsort(table, 100000, 4, compare); free(table);",
                                 0);
    assert_int_equal(claims.allocation_count, 1);
    assert_int_equal(claims.leaked_blocks, 0);
    assert_true(claims.heap_peak_bytes >= 400000);
}

/* An answer of -1 says that memory ran out. */
static void only_what_the_student_asks_for_is_refused(void **state)
{
    (void)state;
    struct control claims =
        call("getchar(); text = malloc(5); if (!text) return -1; free(text);", 1);
    assert_int_equal(claims.out_of_memory, 1);
    claims = call("text = strdup(\"edges\"); if (!text) return -1; free(text);", 1);
    assert_int_equal(claims.out_of_memory, 1);
    claims = call("if (getline(&text, &room, stdin) < 0 && !text) return -1; free(text);", 1);
    assert_int_equal(claims.out_of_memory, 1);
    claims = call("getchar(); time_t now = 0; if (!localtime(&now)) return -1;", 1);
    assert_int_equal(claims.out_of_memory, 0);
}

static void the_size_of_a_block_is_what_was_asked_for(void **state)
{
    (void)state;
    expect("text = malloc(13); if (malloc_usable_size(text) != 13) abort(); free(text);\n"
           "if (malloc_usable_size(NULL) != 0) abort();",
           1, 0, 0);
    expect("text = aligned_alloc(64, 128); if (malloc_usable_size(text) != 128) abort();\n"
           "text = realloc(text, 256); if (malloc_usable_size(text) != 256) abort(); free(text);",
           2, 0, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_libc_keeps_is_its_own),
        cmocka_unit_test(what_libc_makes_for_him_is_the_students),
        cmocka_unit_test(a_stream_of_memory_gives_its_block_to_the_student),
        cmocka_unit_test(what_libc_takes_for_a_while_counts_for_the_peak),
        cmocka_unit_test(only_what_the_student_asks_for_is_refused),
        cmocka_unit_test(the_size_of_a_block_is_what_was_asked_for),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
