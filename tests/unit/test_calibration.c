/* Is memory measured right? Known allocations of every kind, against each method that can see them:
 * the shim (heap, to the byte), the stack's pages, the object's sections, and the resident peak
 * that the engine reads from outside, which sees all kinds, also memory mapped past malloc. */
#include "graders/engine/base/files.h"
#include "graders/engine/run/attempt.h"
#include "tests/unit/known_program.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MIB = 1 << 20, SLACK_BYTES = 128 << 10 };
static const double TOLERANCE = 0.02;

/* Each takes `bytes` in one way, touches every page, and answers "no edges". The first call only
 * answers: then the program has started, and the resident memory before the second is its own. */
static const char PROGRAM[] =
    "#include \"edge-table-any.h\"\n"
    "#include <stdlib.h>\n#include <string.h>\n#include <sys/mman.h>\n"
    "#if KIND == 2\nstatic volatile char table[BYTES];\n#endif\n"
    "int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,"
    " int32_t **edges)\n{\nstatic int calls;\n*edges = NULL;\nif (calls++ == 0) return 0;\n"
    "(void)triangles; (void)triangle_count; (void)vertex_count; *edges = NULL;\n"
    "#if KIND == 0\nvolatile char *table = malloc(BYTES);\n"
    "#elif KIND == 1\nvolatile char table[BYTES];\n"
    "#elif KIND == 3\nvolatile char *table = mmap(NULL, BYTES, PROT_READ | PROT_WRITE,"
    " MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);\n#endif\n"
    "for (long i = 0; i < BYTES; i += 64) table[i] = 1;\n"
    "#if KIND == 0\nfree((void *)table);\n#endif\nreturn 0;\n}\n";

enum kind { HEAP, STACK, STATIC, MAPPED };

/* Measures one call; *resident gets the growth of the resident peak, -1 when it cannot be read. */
static struct control measure(enum kind kind, int bytes, uint32_t mode, int64_t *resident)
{
    static const struct call_limits limits = {20000000000LL, 10000000000LL};
    char options[64];
    struct known_program program;
    struct error err = {""};
    struct session session;
    struct box_outcome outcome;
    snprintf(options, sizeof options, "-DKIND=%d -DBYTES=%d", kind, bytes);
    known_program_build(&program, PROGRAM, options);
    struct session_plan plan = known_program_plan(&program);
    plan.mode = mode;
    assert_int_equal(session_start(&session, &plan, &err), 0);
    assert_int_equal(session_call(&session, KNOWN_INPUT_BYTES, 0, &limits), CALL_ANSWERED);
    int64_t before = box_reset_peak(&session.box) == 0 ? box_peak_resident_bytes(&session.box) : -1;
    enum call_end end = session_call(&session, KNOWN_INPUT_BYTES, 0, &limits);
    *resident = before >= 0 ? box_peak_resident_bytes(&session.box) - before : -1;
    struct control claims = session.claims;
    assert_int_equal(session_end(&session, &outcome, &err), 0);
    assert_int_equal(end, CALL_ANSWERED);
    session_release(&session);
    known_program_release(&program);
    return claims;
}

static void assert_near_bytes(int64_t measured, int64_t known)
{
    double difference = (double)(measured - known) / (double)known;
    if (difference > TOLERANCE || difference < -TOLERANCE)
        fail_msg("measured %lld bytes, known are %lld", (long long)measured, (long long)known);
}

static void heap_is_exact(void **state)
{
    (void)state;
    int64_t resident;
    struct control claims = measure(HEAP, 30 * MIB, MODE_PLAIN, &resident);
    assert_int_equal(claims.heap_peak_bytes, 30 * MIB);
    assert_int_equal(claims.heap_left_bytes, 0);
    assert_int_equal(claims.allocation_count, 1);
}

static void stack_is_within_two_percent(void **state)
{
    (void)state;
    int64_t resident;
    struct control claims = measure(STACK, 8 * MIB, MODE_STACK, &resident);
    assert_near_bytes(claims.stack_bytes, 8 * MIB);
}

static void static_data_is_within_two_percent(void **state)
{
    (void)state;
    struct error err = {""};
    struct exercise *exercises;
    struct build build;
    int count;
    char text[sizeof PROGRAM + 64];
    assert_int_equal(exercises_read(project_root(&err), &exercises, &count, &err), 0);
    snprintf(text, sizeof text, "#define KIND 2\n#define BYTES %d\n%s", 12 * MIB, PROGRAM);
    struct source source = {"known.c", text, strlen(text)};
    assert_int_equal(build_submission(exercise_find(exercises, count, "edge-table-any"), &source, 1,
                                      BUILD_PLAIN, &build, &err),
                     0);
    assert_false(build.refusal.refused);
    assert_near_bytes(build.static_bytes, 12 * MIB);
    build_release(&build);
    free(exercises);
}

static void resident_peak_sees_every_kind(void **state)
{
    (void)state;
    static const int bytes[] = {
        [HEAP] = 30 * MIB, [STACK] = 8 * MIB, [STATIC] = 30 * MIB, [MAPPED] = 30 * MIB};
    for (enum kind kind = HEAP; kind <= MAPPED; kind++) {
        int64_t resident;
        measure(kind, bytes[kind], MODE_PLAIN, &resident);
        if (resident < 0)
            skip(); /* /proc/<pid>/clear_refs cannot be written here: no method sees mapped memory
                     */
        if (resident > bytes[kind] + SLACK_BYTES || resident < bytes[kind] - SLACK_BYTES)
            assert_near_bytes(resident, bytes[kind]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(heap_is_exact),
        cmocka_unit_test(stack_is_within_two_percent),
        cmocka_unit_test(static_data_is_within_two_percent),
        cmocka_unit_test(resident_peak_sees_every_kind),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
