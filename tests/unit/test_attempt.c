/* How a program's death is told: by what it did, or as a fault when it was not its doing. */
#include "graders/engine/run/attempt.h"

#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const struct {
    enum call_end call;
    enum box_end end;
    int signal, exit_code;
    uint32_t phase, fault;
    enum verdict verdict; /* FAULT: no verdict, an error */
    const char *cause;
} deaths[] = {
    {CALL_DIED, BOX_ENDED_SIGNAL, SIGSEGV, 0, PHASE_CALL, FAULT_NULL, VERDICT_CRASH,
     "null-pointer"},
    {CALL_DIED, BOX_ENDED_SIGNAL, SIGSEGV, 0, PHASE_CALL, FAULT_STACK, VERDICT_CRASH,
     "stack-overflow"},
    {CALL_DIED, BOX_ENDED_SIGNAL, SIGSEGV, 0, PHASE_CALL, FAULT_INPUT, VERDICT_CRASH, "input"},
    {CALL_DIED, BOX_ENDED_SIGNAL, SIGBUS, 0, PHASE_CALL, FAULT_OTHER, VERDICT_CRASH,
     "segmentation-fault"},
    {CALL_DIED, BOX_ENDED_SIGNAL, SIGSEGV, 0, PHASE_ANSWER, 0, VERDICT_CRASH, "wild-pointer"},
    {CALL_DIED, BOX_ENDED_SIGNAL, SIGABRT, 0, PHASE_CALL, 0, VERDICT_CRASH, "abort"},
    {CALL_DIED, BOX_ENDED_SIGNAL, SIGFPE, 0, PHASE_CALL, 0, VERDICT_CRASH, "division"},
    {CALL_DIED, BOX_ENDED_SIGNAL, SIGILL, 0, PHASE_CALL, 0, VERDICT_CRASH, "illegal-instruction"},
    {CALL_DIED, BOX_ENDED_SIGNAL, SIGPIPE, 0, PHASE_CALL, 0, VERDICT_CRASH, "broken-pipe"},
    {CALL_DIED, BOX_ENDED_EXIT, 0, 3, PHASE_CALL, 0, VERDICT_CRASH, "exit"},
    {CALL_DIED, BOX_ENDED_EXIT, 0, EXIT_NO_REGIONS, PHASE_CALL, 0, VERDICT_CRASH, "exit"},
    /* once it was ready, the page and the exit code say what the submission wants them to */
    {CALL_DIED, BOX_ENDED_EXIT, 0, EXIT_NO_REGIONS, PHASE_START, 0, VERDICT_CRASH, "exit"},
    {CALL_DIED, BOX_ENDED_EXIT, 0, EXIT_NOT_SECLUDED, PHASE_START, 0, VERDICT_CRASH, "exit"},
    {CALL_NOT_READY, BOX_ENDED_SIGNAL, SIGSEGV, 0, PHASE_START, 0, VERDICT_CRASH,
     "segmentation-fault"},
    {CALL_DIED, BOX_ENDED_KILLED, SIGKILL, 0, PHASE_CALL, 0, VERDICT_CRASH, "broken-protocol"},
    {CALL_DIED, BOX_ENDED_MEMORY, SIGKILL, 0, PHASE_CALL, 0, VERDICT_OUT_OF_MEMORY, "memory-limit"},
    {CALL_DIED, BOX_ENDED_OUTPUT, SIGXFSZ, 0, PHASE_CALL, 0, VERDICT_TOO_MUCH_OUTPUT,
     "output-limit"},
    {CALL_DIED, BOX_ENDED_CPU, SIGXCPU, 0, PHASE_CALL, 0, VERDICT_CPU_TIME, "cpu-limit"},
    {CALL_CPU, BOX_ENDED_KILLED, SIGKILL, 0, PHASE_CALL, 0, VERDICT_CPU_TIME, "cpu-limit"},
    {CALL_CPU, BOX_ENDED_SIGNAL, SIGKILL, 0, PHASE_CALL, 0, VERDICT_CPU_TIME, "cpu-limit"},
    {CALL_SPENT, BOX_ENDED_KILLED, SIGKILL, 0, PHASE_CALL, 0, VERDICT_CPU_TIME, "time-budget"},
    {CALL_SPENT, BOX_ENDED_SIGNAL, SIGKILL, 0, PHASE_CALL, 0, VERDICT_CPU_TIME, "time-budget"},
    {CALL_IDLE, BOX_ENDED_KILLED, SIGKILL, 0, PHASE_CALL, 0, VERDICT_IDLE_TIME, "idle-limit"},
    /* nothing of its own doing */
    {CALL_DIED, BOX_ENDED_SIGNAL, SIGKILL, 0, PHASE_CALL, 0, VERDICT_FAULT, ""},
    {CALL_DIED, BOX_ENDED_SIGNAL, SIGTERM, 0, PHASE_CALL, 0, VERDICT_FAULT, ""},
    {CALL_DIED, BOX_ENDED_SIGNAL, SIGKILL, 0, PHASE_START, 0, VERDICT_FAULT, ""},
    {CALL_DIED, BOX_ENDED_SIGNAL, SIGHUP, 0, PHASE_ANSWER, 0, VERDICT_FAULT, ""},
    {CALL_NOT_READY, BOX_ENDED_EXIT, 0, EXIT_NO_REGIONS, PHASE_START, 0, VERDICT_FAULT, ""},
    {CALL_NOT_READY, BOX_ENDED_EXIT, 0, EXIT_NOT_SECLUDED, PHASE_START, 0, VERDICT_FAULT, ""},
    {CALL_NOT_READY, BOX_ENDED_KILLED, SIGKILL, 0, PHASE_START, 0, VERDICT_FAULT, ""},
};

static void test_deaths(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof deaths / sizeof *deaths; i++) {
        struct attempt attempt = {.verdict = VERDICT_COUNT};
        struct error err = {""};
        const struct control claims = {.phase = deaths[i].phase, .fault = deaths[i].fault};
        const struct box_outcome outcome = {
            .end = deaths[i].end, .signal = deaths[i].signal, .exit_code = deaths[i].exit_code};
        int result = attempt_explain_death(deaths[i].call, &claims, &outcome, &attempt, &err);
        assert_int_equal(result, deaths[i].verdict == VERDICT_FAULT ? -1 : 0);
        if (result != 0) {
            assert_string_not_equal(err.text, "");
            assert_int_equal(attempt.verdict, VERDICT_COUNT);
            continue;
        }
        assert_int_equal(attempt.verdict, deaths[i].verdict);
        assert_string_equal(attempt.cause, deaths[i].cause);
        assert_string_not_equal(attempt.message.en, "");
        assert_string_not_equal(attempt.message.es, "");
    }
}

/* Memory that was refused explains every later end. */
static void test_refused_memory(void **state)
{
    struct attempt attempt = {0};
    struct error err = {""};
    const struct control claims = {.phase = PHASE_CALL, .refused_count = 1};
    const struct box_outcome outcome = {.end = BOX_ENDED_SIGNAL, .signal = SIGSEGV};
    (void)state;
    assert_int_equal(attempt_explain_death(CALL_DIED, &claims, &outcome, &attempt, &err), 0);
    assert_int_equal(attempt.verdict, VERDICT_OUT_OF_MEMORY);
}

static void test_forbidden(void **state)
{
    struct attempt attempt = {0};
    struct error err = {""};
    struct box_outcome outcome = {.end = BOX_ENDED_FORBIDDEN, .refused_call = "openat"};
    const struct control claims = {.phase = PHASE_CALL};
    (void)state;
    assert_int_equal(attempt_explain_death(CALL_DIED, &claims, &outcome, &attempt, &err), 0);
    assert_int_equal(attempt.verdict, VERDICT_FORBIDDEN_OPERATION);
    assert_string_equal(attempt.cause, "openat");
    outcome.refused_is_process = true;
    assert_int_equal(attempt_explain_death(CALL_DIED, &claims, &outcome, &attempt, &err), 0);
    assert_int_equal(attempt.verdict, VERDICT_TOO_MANY_PROCESSES);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_deaths),
                                       cmocka_unit_test(test_refused_memory),
                                       cmocka_unit_test(test_forbidden)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
