/* Compilers, valgrind and sanitized programs in the box: they work, and what they are made to do
 * stays inside; as root, as a plain user, and without namespaces. */
#include "graders/engine/base/files.h"
#include "tests/unit/box_bench.h"

#include <fcntl.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

enum { OUTPUT_BYTES = 1 << 16 };

/* What a box printed, and the folder that it works in: made anew by whoever plays. */
static char output[OUTPUT_BYTES];
static char work[64], scratch[80], parent[32];
static uint32_t disabled;

static int open_work(void)
{
    snprintf(parent, sizeof parent, "/tmp/box-work-XXXXXX");
    struct error err = {""};
    if (!mkdtemp(parent))
        return -1;
    /* Without a mount namespace the program passes through it to its folder. */
    if (chmod(parent, 0711))
        return -1;
    snprintf(work, sizeof work, "%s/work", parent);
    snprintf(scratch, sizeof scratch, "%s/tmp", work);
    return mkdir(work, 0700) || mkdir(scratch, 0700) || box_give_folder(scratch, &err) ||
                   box_give_folder(work, &err)
               ? -1
               : 0;
}

static void close_work(void)
{
    char command[100];
    snprintf(command, sizeof command, "rm -rf %s", parent);
    if (system(command))
        fprintf(stderr, "cannot remove %s\n", parent);
}

static int put_source(const char *name, const char *text)
{
    char path[128];
    snprintf(path, sizeof path, "%s/%s", work, name);
    int fd = open(path, O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
    bool written = fd >= 0 && write(fd, text, strlen(text)) == (ssize_t)strlen(text);
    if (fd >= 0)
        close(fd);
    return written ? chmod(path, 0644) : -1;
}

static int put_program(const char *program)
{
    char command[300];
    snprintf(command, sizeof command, "install -m 0755 %s/%s %s/%s", box_bench_folder(), program,
             work, program);
    return system(command) ? -1 : 0;
}

/* Runs a command line, words separated by single spaces. Output and outcome stay in statics. */
static struct box_outcome outcome;
static struct error err;

static int run(enum box_profile profile, const char *line, struct box_plan changes)
{
    char words[512], *argv[32], *rest = words;
    int count = 0;
    snprintf(words, sizeof words, "%s", line);
    for (char *word; count < 31 && (word = strsep(&rest, " "));)
        argv[count++] = word;
    argv[count] = NULL;
    int out = memfd_create("output", MFD_CLOEXEC);
    struct box_plan plan = {.profile = profile,
                            .argv = argv,
                            .program_fd = -1,
                            .covered = changes.covered,
                            .readable = {changes.readable[0]},
                            .writable = work,
                            .input_fd = -1,
                            .output_fd = out,
                            .error_fd = out,
                            .memory_bytes = changes.memory_bytes ? changes.memory_bytes : 600 << 20,
                            .file_bytes = changes.file_bytes ? changes.file_bytes : 16 << 20,
                            .scratch_bytes = 16 << 20,
                            .stack_bytes = 16 << 20,
                            .cpu_seconds = changes.cpu_seconds ? changes.cpu_seconds : 20,
                            .box_cpu_seconds = changes.box_cpu_seconds,
                            .idle_ms = changes.idle_ms,
                            .work_bytes = 16 << 20,
                            .wall_ms = 60000,
                            .process_count = 16,
                            .cpu = -1,
                            .disabled_layers = disabled};
    err.text[0] = '\0';
    memset(&outcome, 0, sizeof outcome);
    int failed = box_run(&plan, &outcome, &err);
    ssize_t length = pread(out, output, sizeof output - 1, 0);
    output[length > 0 ? length : 0] = '\0';
    close(out);
    return failed;
}

static const struct box_plan usual;

static int complain(const char *line)
{
    static const char *const ends[] = {"forbidden", "memory", "output", "disk", "cpu",
                                       "killed",    "signal", "exit",   "lost"};
    fprintf(stderr, "box (disabled %#x): %s: %s, code %d, signal %d, refused '%s' %s\n%.2000s\n",
            disabled, line, ends[outcome.end], outcome.exit_code, outcome.signal,
            outcome.refused_detail, err.text, output);
    return 1;
}

/* 0 when the command exits with `code`, prints `text` (NULL: anything) and leaves nothing behind.
 */
static int expect_exit(enum box_profile profile, const char *line, int code, const char *text)
{
    if (run(profile, line, usual) || outcome.end != BOX_ENDED_EXIT || outcome.exit_code != code ||
        (text && !strstr(output, text)) || !outcome.cleaned || box_bench_leftovers())
        return complain(line);
    return 0;
}

static int expect_end(enum box_profile profile, const char *line, enum box_end end,
                      const char *call, struct box_plan changes)
{
    bool named = !call || !(outcome.active >> BOX_SECCOMP_NAMES & 1);
    if (run(profile, line, changes) || outcome.end != end ||
        (!named && strcmp(call, outcome.refused_call) != 0) || !outcome.cleaned ||
        box_bench_leftovers())
        return complain(line);
    return 0;
}

/* ------------------------------------------------------------------ building */

/* LeakSanitizer would start a thread to look at the program. */
static const char hello[] = "#include <stdio.h>\n#include <stdlib.h>\n"
                            "const char *__asan_default_options(void);\n"
                            "const char *__asan_default_options(void)\n{\n"
                            "    return \"detect_leaks=0\";\n}\n"
                            "int main(int argc, char **argv)\n{\n"
                            "    char *block = malloc(10);\n    (void)argv;\n"
                            "    printf(\"hello\\n\");\n"
                            "    block[argc > 1 ? 10 : 0] = 1;\n"
                            "    free(block);\n    return 0;\n}\n";

static int build_works(void)
{
    if (open_work() || put_source("a.c", hello))
        return 99;
    int wrong =
        expect_exit(BOX_BUILD, "/usr/bin/gcc -O2 -g -c a.c -o a.o", 0, NULL) +
        expect_exit(BOX_BUILD, "/usr/bin/gcc -static a.o -o a.static", 0, NULL) +
        expect_exit(BOX_BUILD, "/usr/bin/gcc -g -fsanitize=address,undefined a.c -o a.sanitized", 0,
                    NULL) +
        expect_exit(BOX_BUILD, "/usr/bin/objcopy --keep-global-symbol=main a.o b.o", 0, NULL) +
        expect_exit(BOX_BUILD, "/usr/bin/ld -r b.o -o c.o", 0, NULL) +
        expect_exit(BOX_BUILD, "/bin/sh -c true", 0, NULL) +
        expect_exit(BOX_BUILD, "/usr/bin/gcc -c missing.c", 1, "missing.c") +
        expect_exit(BOX_TOOLS, "./a.static", 0, "hello") +
        expect_exit(BOX_TOOLS, "./a.sanitized", 0, "hello") +
        expect_exit(BOX_TOOLS, "./a.sanitized 1", 1, "heap-buffer-overflow");
    close_work();
    return wrong;
}

/* Reading what is not shown: by the preprocessor, the assembler, the linker. */
static int build_reads_nothing(void)
{
    if (open_work() || put_source("a.c", "#include \"/etc/passwd\"\n") ||
        put_source("b.c", "__asm__(\".incbin \\\"/etc/passwd\\\"\");\n") ||
        put_source("c.c", "#include \"/proc/self/environ\"\n") ||
        put_source("d.ld", "INCLUDE /etc/passwd\n"))
        return 99;
    int wrong = expect_exit(BOX_BUILD, "/usr/bin/gcc -c a.c", 1, "/etc/passwd") +
                expect_exit(BOX_BUILD, "/usr/bin/gcc -c b.c", 1, "/etc/passwd") +
                expect_exit(BOX_BUILD, "/usr/bin/gcc -c c.c", 1, NULL) +
                expect_exit(BOX_BUILD, "/usr/bin/ld -T d.ld", 1, NULL);
    wrong += strstr(output, "root:") ? complain("a file of the host was shown") : 0;
    close_work();
    return wrong;
}

static int build_is_bounded(void)
{
    struct box_plan little_memory = {.memory_bytes = 100 << 20};
    if (open_work() || put_source("a.c", "char x[1L << 28] = {1};\n") ||
        put_source("b.c", "#define A(x) x x x x x x x x x x\n#define B(x) A(A(A(A(x))))\n"
                          "int a[] = {B(B(1,))};\n"))
        return 99;
    int wrong = 0;
    if (run(BOX_BUILD, "/usr/bin/gcc -c a.c", usual) || outcome.end == BOX_ENDED_LOST ||
        (outcome.end == BOX_ENDED_EXIT && outcome.exit_code == 0) || !outcome.cleaned)
        wrong += complain("a large object");
    if (run(BOX_BUILD, "/usr/bin/gcc -c b.c", little_memory) || outcome.end == BOX_ENDED_LOST ||
        (outcome.end == BOX_ENDED_EXIT && outcome.exit_code == 0) || !outcome.cleaned)
        wrong += complain("a macro bomb");
    close_work();
    return wrong + box_bench_leftovers();
}

/* A compiler that was taken over: what it writes it cannot execute, nor make namespaces. */
static int build_contains(void)
{
    if (open_work() || put_source("a.sh", "cp /bin/true mine\n./mine\n"))
        return 99;
    int wrong = expect_exit(BOX_BUILD, "/bin/sh a.sh", 126, NULL) +
                expect_end(BOX_BUILD, "/usr/bin/unshare -m /bin/true", BOX_ENDED_FORBIDDEN,
                           "unshare", usual);
    close_work();
    return wrong;
}

/* Many processes, none of which takes long: with and without control groups they end together. One
 * that fails late is no compiler that took too long, and one that waits for ever is ended. */
static int build_time_is_bounded(void)
{
    struct box_plan little = {.box_cpu_seconds = 2}, idle = {.idle_ms = 300};
    struct box_plan short_each = {.cpu_seconds = 1, .box_cpu_seconds = 20};
    if (open_work() ||
        put_source("work.sh", "i=0\nwhile [ $i -lt 50000 ]; do i=$((i + 1)); done\n") ||
        put_source("series.sh", "while :; do sh work.sh; done\n") ||
        put_source("orphans.sh", "while :; do (sh work.sh &) ; sh work.sh; done\n") ||
        put_source("fails.sh", "for k in $(seq 40); do sh work.sh; done\nexit 3\n") ||
        put_source("long.sh", "sh -c 'while :; do :; done'\nexit 3\n"))
        return 99;
    int wrong = expect_end(BOX_BUILD, "/bin/sh series.sh", BOX_ENDED_CPU, NULL, little) +
                (outcome.cpu_ns < 2000000000 ? complain("its CPU time is not known") : 0) +
                expect_end(BOX_BUILD, "/bin/sh orphans.sh", BOX_ENDED_CPU, NULL, little) +
                expect_end(BOX_BUILD, "/bin/sh fails.sh", BOX_ENDED_EXIT, NULL, short_each) +
                (outcome.cpu_ns < 1000000000 ? complain("it works too little for this test") : 0) +
                expect_end(BOX_BUILD, "/bin/sh long.sh", BOX_ENDED_EXIT, NULL, short_each) +
                (!strstr(output, "CPU time limit exceeded") ? complain("not told") : 0) +
                expect_end(BOX_BUILD, "/bin/sleep 50", BOX_ENDED_KILLED, NULL, idle);
    close_work();
    return wrong;
}

/* ---------------------------------------------------------------------- tools */

static int tools_contain(void)
{
    struct box_plan little_memory = {.memory_bytes = 64 << 20};
    struct box_plan little_time = {.cpu_seconds = 1};
    if (open_work() || put_program("attacks"))
        return 99;
    int wrong =
        expect_end(BOX_TOOLS, "./attacks fork-bomb", BOX_ENDED_FORBIDDEN, "clone", usual) +
        expect_end(BOX_TOOLS, "./attacks vfork", BOX_ENDED_FORBIDDEN, "vfork", usual) +
        expect_end(BOX_TOOLS, "./attacks socket", BOX_ENDED_FORBIDDEN, "socket", usual) +
        expect_end(BOX_TOOLS, "./attacks kill-all", BOX_ENDED_FORBIDDEN, "kill", usual) +
        expect_end(BOX_TOOLS, "./attacks kill-parent", BOX_ENDED_FORBIDDEN, "kill", usual) +
        expect_end(BOX_TOOLS, "./attacks trace", BOX_ENDED_FORBIDDEN, "ptrace", usual) +
        expect_end(BOX_TOOLS, "./attacks io-uring", BOX_ENDED_FORBIDDEN, "io_uring_setup", usual) +
        expect_end(BOX_TOOLS, "./attacks int-0x80", BOX_ENDED_FORBIDDEN, NULL, usual) +
        expect_end(BOX_TOOLS, "./attacks malloc-bomb", BOX_ENDED_MEMORY, NULL, little_memory) +
        expect_end(BOX_TOOLS, "./attacks flood", BOX_ENDED_OUTPUT, NULL, usual) +
        expect_end(BOX_TOOLS, "./attacks loop", BOX_ENDED_CPU, NULL, little_time) +
        expect_exit(BOX_TOOLS, "./attacks read-passwd", HARMLESS, NULL) +
        expect_exit(BOX_TOOLS, "./attacks write-outside", HARMLESS, NULL) +
        expect_exit(BOX_TOOLS, "./attacks raise-limits", HARMLESS, NULL) +
        expect_exit(BOX_TOOLS, "./attacks unpin", HARMLESS, NULL);
    close_work();
    return wrong;
}

/* How much a box could put on the host's disk: nothing where it has a file system of its own, else as
 * much as it writes until it is looked at. */
static int disk_is_bounded(void)
{
    if (open_work() || put_program("attacks"))
        return 99;
    int wrong = expect_exit(BOX_TOOLS, "./attacks exit-zero", 0, NULL);
    bool rooted = outcome.active >> BOX_PRIVATE_ROOT & 1;
    static const char *const lines[] = {"./attacks fill-disk", "./attacks fill-unseen"};
    for (int i = 0; i < 2; i++)
        wrong += rooted ? expect_exit(BOX_TOOLS, lines[i], HARMLESS, NULL)
                        : expect_end(BOX_TOOLS, lines[i], BOX_ENDED_DISK, NULL, usual);
    if (rooted && rmdir(scratch)) /* nothing came through */
        wrong += complain("something is on the host's disk");
    close_work();
    return wrong;
}

/* A compiler that was taken over, or many files, each within the limit of a file. */
static int build_disk_is_bounded(void)
{
    if (open_work() ||
        put_source("a.sh", "i=0; while :; do cp /usr/bin/gcc file$i; i=$((i + 1)); done\n") ||
        put_source("b.sh", "while :; do mkdir deep; cd deep; done\n"))
        return 99;
    int wrong = expect_end(BOX_BUILD, "/bin/sh a.sh", BOX_ENDED_DISK, NULL, usual) +
                expect_end(BOX_BUILD, "/bin/sh b.sh", BOX_ENDED_DISK, NULL, usual);
    folder_remove(work);
    close_work();
    return wrong;
}

/* A covered folder holds just what the plan names in it, and cannot be written to; without a
 * private root it is there as it is. */
static int cover_hides(void)
{
    struct box_plan covered = {.covered = "/usr/include", .readable = {"/usr/include/stdio.h"}};
    if (open_work())
        return 99;
    int wrong = 0;
    if (run(BOX_TOOLS, "/bin/ls -A /usr/include", covered) || outcome.end != BOX_ENDED_EXIT ||
        outcome.exit_code != 0 || !strstr(output, "stdio.h"))
        wrong += complain("what is named in a covered folder");
    bool rooted = outcome.active >> BOX_PRIVATE_ROOT & 1;
    if (rooted != (strcmp(output, "stdio.h\n") == 0))
        wrong += complain("a covered folder");
    if (run(BOX_TOOLS, "/usr/bin/head -n 1 /usr/include/stdio.h", covered) ||
        outcome.exit_code != 0 || !output[0])
        wrong += complain("a file in a covered folder");
    if (run(BOX_TOOLS, "/usr/bin/touch /usr/include/mine", covered) || outcome.exit_code == 0)
        wrong += complain("writing to a covered folder");
    close_work();
    return wrong;
}

static int valgrind_works(void)
{
    const char *memcheck = "/usr/bin/valgrind --vgdb=no --error-exitcode=9 ./controls nothing";
    if (open_work() || put_program("attacks") || put_program("controls"))
        return 99;
    int wrong =
        expect_exit(BOX_TOOLS,
                    "/usr/bin/valgrind --tool=callgrind --vgdb=no --callgrind-out-file=tmp/counts "
                    "./controls allocate",
                    0, "Collected") +
        (run(BOX_TOOLS, memcheck, usual) || outcome.end != BOX_ENDED_EXIT ? complain(memcheck)
                                                                          : 0) +
        expect_end(BOX_TOOLS, "/usr/bin/valgrind --tool=none --vgdb=no ./attacks fork-bomb",
                   BOX_ENDED_FORBIDDEN, "clone", usual) +
        expect_exit(BOX_TOOLS, "/usr/bin/valgrind --tool=none --vgdb=no ./attacks read-passwd",
                    HARMLESS, NULL);
    close_work();
    return wrong;
}

/* ---------------------------------------------------------------------- tests */

static int everything(void)
{
    int wrong = build_works() + build_reads_nothing() + build_contains() + tools_contain();
    wrong += cover_hides() + build_time_is_bounded();
    wrong += disk_is_bounded() + build_disk_is_bounded();
    if (access("/usr/bin/valgrind", X_OK) == 0)
        wrong += valgrind_works();
    return wrong;
}

static void test_here(void **state)
{
    (void)state;
    assert_int_equal(everything(), 0);
    assert_int_equal(build_is_bounded(), 0);
}

static void test_plain_user(void **state)
{
    (void)state;
    box_bench_play(box_bench_become_nobody, everything);
}

static void test_plain_user_without_namespaces(void **state)
{
    (void)state;
    box_bench_play(box_bench_lose_namespaces, everything);
}

static void test_without_groups_or_namespaces(void **state)
{
    (void)state;
    disabled = OFF_NAMESPACES | OFF_GROUPS;
    int wrong = everything();
    disabled = 0;
    assert_int_equal(wrong, 0);
}

static void test_without_landlock(void **state)
{
    (void)state;
    disabled = OFF(LANDLOCK);
    int wrong = everything();
    disabled = 0;
    assert_int_equal(wrong, 0);
}

/* Children that let go of everything: ended by the pid namespace, or by init. */
static void test_children_left_behind(void **state)
{
    const uint32_t settings[] = {0, OFF_NAMESPACES, OFF_NAMESPACES | OFF_GROUPS};
    (void)state;
    for (int i = 0; i < 3; i++) {
        struct box_plan plan = box_bench_plan("attacks", "leave-children");
        struct error error = {""};
        plan.profile = BOX_BUILD;
        plan.disabled_layers = settings[i];
        assert_int_equal(box_run(&plan, &outcome, &error), 0);
        assert_int_equal(outcome.end, BOX_ENDED_EXIT);
        assert_int_equal(outcome.exit_code, 0);
        assert_true(outcome.cleaned);
        assert_int_equal(box_bench_leftovers(), 0);
    }
}

/* A build may make processes, but only so many, and they end with it. */
static void test_process_limit(void **state)
{
    (void)state;
    struct box_plan plan = box_bench_plan("attacks", "fork-bomb");
    struct error error = {""};
    plan.profile = BOX_BUILD;
    assert_int_equal(box_run(&plan, &outcome, &error), 0);
    assert_int_equal(outcome.end, BOX_ENDED_EXIT);
    assert_int_equal(outcome.exit_code, 99);
    assert_true(outcome.cleaned);
    assert_int_equal(box_bench_leftovers(), 0);
}

static int refuses_without_walls(void)
{
    if (open_work() || put_program("attacks"))
        return 99;
    int wrong = run(BOX_TOOLS, "./attacks exit-zero", usual) == 0 || !strstr(err.text, "Landlock");
    wrong += run(BOX_BUILD, "/bin/true", usual) == 0 || !strstr(err.text, "Landlock");
    close_work();
    return wrong + box_bench_leftovers();
}

static void test_tools_need_a_wall_before_files(void **state)
{
    (void)state;
    box_bench_play(box_bench_enter_container, refuses_without_walls);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_here),
        cmocka_unit_test(test_plain_user),
        cmocka_unit_test(test_plain_user_without_namespaces),
        cmocka_unit_test(test_without_groups_or_namespaces),
        cmocka_unit_test(test_without_landlock),
        cmocka_unit_test(test_children_left_behind),
        cmocka_unit_test(test_process_limit),
        cmocka_unit_test(test_tools_need_a_wall_before_files),
    };
    return cmocka_run_group_tests(tests, box_bench_set_up, box_bench_tear_down);
}
