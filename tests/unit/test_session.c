/* How a session ends when the machine is slow to tell: the box's own process is stopped for a while
 * and so tells late that the program ended. */
#include "graders/engine/files.h"
#include "graders/engine/session.h"

#include <fcntl.h>
#include <limits.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

enum { STOPPED_SECONDS = 6 /* more than a program that sits idle gets for its end */ };

static const char PROGRAM[] =
    "#include \"edge-table-any.h\"\n"
    "int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,"
    " int32_t **edges)\n{\n(void)triangles; (void)vertex_count;\n*edges = 0;\n"
    "return triangle_count;\n}\n";

static const char COMMAND[] =
    "cd '%s' && gcc -O1 -w -static -I'%s/exercises/edges/edge-table-any' known.c "
    "'%s/build/runner/edge-table-any.plain.o' -o known -Wl,--wrap=malloc,--wrap=calloc,"
    "--wrap=realloc,--wrap=free,--wrap=aligned_alloc,--wrap=posix_memalign,--wrap=memalign,"
    "--wrap=valloc";

static int build_program(char *folder)
{
    char path[PATH_MAX + 16], command[3 * PATH_MAX];
    struct error err = {""};
    const char *root = project_root(&err);
    assert_non_null(root);
    assert_int_equal(folder_make_work(folder, &err), 0);
    snprintf(path, sizeof path, "%s/known.c", folder);
    assert_int_equal(file_write(path, PROGRAM, strlen(PROGRAM), &err), 0);
    snprintf(command, sizeof command, COMMAND, folder, root, root);
    assert_int_equal(system(command), 0);
    snprintf(path, sizeof path, "%s/known", folder);
    int program = open(path, O_RDONLY | O_CLOEXEC);
    assert_true(program >= 0);
    return program;
}

/* Stops a process now, and lets it go on later. */
static pid_t stop_for_a_while(pid_t pid)
{
    assert_int_equal(kill(pid, SIGSTOP), 0);
    pid_t child = fork();
    if (child == 0) {
        sleep(STOPPED_SECONDS);
        kill(pid, SIGCONT);
        _exit(0);
    }
    return child;
}

static void test_late_news_of_an_end(void **state)
{
    static const struct call_limits limits = {20000000000LL, 20000000000LL};
    char folder[PATH_MAX];
    struct error err = {""};
    struct session session;
    struct box_outcome outcome;
    struct region input;
    int program = build_program(folder);
    (void)state;
    assert_int_equal(region_make(&input, 64, true, &err), 0); /* no triangles, no vertices */
    struct session_plan plan = {.profile = BOX_RUN,
                                .program_fd = program,
                                .input = &input,
                                .answer_bytes = 4096,
                                .memory_limit_bytes = 256 << 20,
                                .cpu_seconds = 30,
                                .cpu = -1};
    assert_int_equal(session_start(&session, &plan, &err), 0);
    assert_int_equal(session_call(&session, 64, 0, &limits), CALL_ANSWERED);
    pid_t waker = stop_for_a_while(session.box.init);
    assert_int_equal(session_end(&session, &outcome, &err), 0);
    assert_int_equal(outcome.end, BOX_ENDED_EXIT);
    assert_int_equal(outcome.exit_code, 0);
    assert_int_equal(waitpid(waker, NULL, 0), waker);
    session_release(&session);
    region_release(&input);
    close(program);
    folder_remove_work(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_late_news_of_an_end)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
