/* Many calls in one session; see series.h. */
#include "graders/engine/run/series.h"

#include "graders/engine/base/files.h"
#include "graders/engine/run/debug_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { TOOL_MEMORY_BYTES = 1 << 30, CPU_SECONDS = 600, TOOL_ARGUMENTS = 14 };

/* A tool that finds an error ends the program itself, at once, with this code: abort() could be
 * caught by the program, which would then go on. Signals of faults go to the tool, not to handlers
 * of the program. UBSan has its options from the runner (seclude.c). */
#define FOUND EXIT_TOOL_FOUND
_Static_assert(SERIES_FOUND == 86, "the tools are told the code as text");
static const char ASAN_OPTIONS[] =
    "ASAN_OPTIONS=detect_leaks=0:abort_on_error=0:exitcode=" FOUND ":handle_segv=2:handle_sigbus=2:"
    "handle_sigfpe=2:color=never:allocator_may_return_null=1:detect_stack_use_after_return=0";
static const char MEMCHECK_EXIT_CODE[] = "--error-exitcode=" FOUND;
static const char DUMPED_CALL[] = SERIES_DUMPED_CALL;

#define COUNTING                                                                                   \
    "/usr/bin/valgrind", "-q", "--tool=callgrind", "--vgdb=no", "--dump-line=no", DUMPED_CALL,     \
        "--callgrind-out-file=/proc/self/cwd/counts"
#define COUNTED                                                                                    \
    {                                                                                              \
        "PATH=/usr/bin:/bin", "LC_ALL=C", "TMPDIR=tmp", SERIES_PINNED_FUNCTIONS, NULL              \
    }

/* How each tool is run. Programs are named relative to /work, so that their counts do not depend on
 * the host's paths; callgrind would make a relative name absolute, and its user may not pass all
 * folders above, but /proc/self/cwd leads there at once. GLIBC_TUNABLES pins libc's choice of
 * functions: counts then agree between machines. Caches of declared size, not this
 * machine's. Everything is collected, and dumped when the runner's function is entered that
 * follows a call: the program itself asks valgrind for nothing. */
static const struct {
    enum program_kind program;
    uint32_t mode;
    const char *argv[TOOL_ARGUMENTS];
    const char *envp[TOOL_ARGUMENTS];
} tools[] = {
    [SERIES_PLAIN] = {PROGRAM_PLAIN, MODE_PLAIN, {NULL}, {NULL}},
    [SERIES_CALLGRIND] = {PROGRAM_PLAIN,
                          MODE_COUNT,
                          {COUNTING, "--cache-sim=yes", "--I1=32768,8,64", "--D1=32768,8,64",
                           "--LL=8388608,16,64", "./plain", NULL},
                          COUNTED},
    [SERIES_INSTRUCTIONS] = {PROGRAM_PLAIN,
                             MODE_COUNT,
                             {COUNTING, "--cache-sim=no", "./plain", NULL},
                             COUNTED},
    [SERIES_SANITIZER] = {PROGRAM_SANITIZED,
                          MODE_PLAIN,
                          {"./sanitized", NULL},
                          {"PATH=/usr/bin:/bin", "LC_ALL=C", "TMPDIR=tmp", ASAN_OPTIONS, NULL}},
    [SERIES_MEMCHECK] = {PROGRAM_CHECKED,
                         MODE_MEMCHECK,
                         {"/usr/bin/valgrind", "-q", "--tool=memcheck", "--vgdb=no",
                          "--leak-check=no", "--num-callers=8", MEMCHECK_EXIT_CODE,
                          "--exit-on-first-error=yes", "--max-stackframe=16777216", "./checked",
                          NULL},
                         {"PATH=/usr/bin:/bin", "LC_ALL=C", "TMPDIR=tmp", NULL}},
};

/* Valgrind writes what its program sees of /proc into files of its own. A folder in /work serves
 * also where the box has no /tmp. */
static int make_scratch(const struct series *series, struct error *err)
{
    char path[PATH_MAX + 8];
    snprintf(path, sizeof path, "%s/tmp", series->folder);
    if (mkdir(path, 0700) != 0)
        return error_set(err, "%s: %s", path, strerror(errno));
    return box_give_folder(path, err);
}

static bool is_counted(enum series_tool tool)
{
    return tool == SERIES_CALLGRIND || tool == SERIES_INSTRUCTIONS;
}

static int make_folder(struct series *series, const struct series_plan *plan, struct error *err)
{
    if (plan->tool == SERIES_PLAIN)
        return 0;
    if (folder_make_work(series->folder, err) != 0 ||
        build_copy_program(plan->build, tools[plan->tool].program, series->folder, err) != 0)
        return -1;
    if (make_scratch(series, err) != 0 || box_open_way(series->folder, err) != 0)
        return -1;
    return is_counted(plan->tool)
               ? dumps_make(&series->dumps, series->folder, plan->call_count, err)
               : 0;
}

struct series series_none(void)
{
    struct series none = {.input = {.fd = -1}, .dumps = dumps_none(), .end = CALL_ANSWERED};
    none.session.control_region.fd = none.session.answer.fd = none.session.output.fd = -1;
    return none;
}

int series_start(struct series *series, const struct series_plan *plan, struct error *err)
{
    bool plain = plan->tool == SERIES_PLAIN;
    char linker[PATH_MAX];
    /* Half of memcheck's start is to read what it makes no use of. */
    bool hides_rest = plan->tool == SERIES_MEMCHECK && debug_file_of_linker(linker, sizeof linker);
    int64_t heap_limit = plan->inputs->exercise->memory_limit_bytes;
    *series = series_none();
    if (region_make(&series->input, plan->input_bytes, true, err) != 0 ||
        make_folder(series, plan, err) != 0)
        return -1;
    char *argv[TOOL_ARGUMENTS], *envp[TOOL_ARGUMENTS]; /* exec takes them without const */
    memcpy(argv, tools[plan->tool].argv, sizeof argv);
    memcpy(envp, tools[plan->tool].envp, sizeof envp);
    struct session_plan session = {
        .profile = plain ? BOX_RUN : BOX_TOOLS,
        .program_fd = plain ? plan->build->program_fd[PROGRAM_PLAIN] : -1,
        .argv = plain ? NULL : argv,
        .envp = plain ? NULL : envp,
        .work_folder = plain ? NULL : series->folder,
        .covered = hides_rest ? DEBUG_FILE_FOLDER : NULL,
        .uncovered = hides_rest ? linker : NULL,
        .input = &series->input,
        .answer_bytes = plan->answer_bytes,
        .mode = tools[plan->tool].mode | plan->mode,
        .heap_limit_bytes = heap_limit,
        .memory_limit_bytes =
            (uint64_t)heap_limit + plan->input_bytes + plan->answer_bytes + TOOL_MEMORY_BYTES,
        .cpu_seconds = CPU_SECONDS,
        .budget = plan->build->budget,
        .ends_by_itself = is_counted(plan->tool), /* callgrind's last dump proves the others */
        .cpu = plan->cpu,
        .meanwhile = is_counted(plan->tool) ? dumps_drain : NULL,
        .meanwhile_argument = &series->dumps,
    };
    if (session_start(&series->session, &session, err) != 0)
        return -1;
    series->started = true;
    return 0;
}

enum call_end series_call(struct series *series, const struct input *input,
                          int64_t failing_allocation, const struct call_limits *limits,
                          struct attempt *attempt)
{
    size_t start = (size_t)series->session.input_page * INPUT_PAGE_BYTES;
    memcpy(series->input.bytes + start, input->region.bytes, input->bytes);
    series->end = session_call(&series->session, input->bytes, failing_allocation, limits);
    attempt->claims = series->session.claims;
    attempt->cpu_ns = series->session.call_cpu_ns;
    return series->end;
}

int series_end(struct series *series, struct attempt *attempt, struct error *err)
{
    series->started = false;
    if (session_end(&series->session, &attempt->outcome, err) != 0)
        return -1;
    session_output(&series->session, attempt->output, sizeof attempt->output);
    if (series->end == CALL_ANSWERED)
        return 0;
    return attempt_explain_death(series->end, &attempt->claims, &attempt->outcome, attempt, err);
}

int series_check_way(const struct series *series, struct error *err)
{
    char closed[PATH_MAX];
    if (!box_way_is_closed(&series->session.box, series->folder, closed))
        return 0;
    return error_set(err,
                     "%s: programs in boxes cannot pass this folder, and valgrind cannot read what "
                     "it counts: chmod o+x it, or choose another output folder (or TMPDIR)",
                     closed);
}

void series_release(struct series *series)
{
    struct box_outcome outcome;
    if (series->started && session_end(&series->session, &outcome, NULL) != 0)
        series->started = false; /* lost already: nothing more to end */
    session_release(&series->session);
    region_release(&series->input);
    dumps_release(&series->dumps);
    folder_remove_work(series->folder);
}
