/* Compiles, screens and links a submission; see build.h. */
#include "graders/engine/build/build.h"

#include "graders/engine/base/files.h"
#include "graders/engine/build/compiler.h"
#include "graders/engine/build/directives.h"
#include "graders/engine/build/policy.h"
#include "graders/engine/build/screen.h"
#include "graders/engine/build/wrapped.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <unistd.h>

static const struct cause compiler_memory = {"compiler-memory",
                                             {"memory of the compiler", "memoria del compilador"}};
static const struct cause compiler_time = {"compiler-time",
                                           {"time of the compiler", "tiempo del compilador"}};
static const struct cause compiler_output = {"compiler-output",
                                             {"output of the compiler", "salida del compilador"}};
static const struct cause link_failed = {"link", {"does not link", "no se enlaza"}};
static const struct cause syntax = {"syntax", {"syntax", "sintaxis"}};

enum {
    CPU_SECONDS = 15,      /* of one process, such as the compiler on one file */
    ALL_CPU_SECONDS = 40,  /* of all together; an answer in one file takes about 1.5 */
    IDLE_SECONDS = 300,    /* a compiler waits for nothing but the machine: beyond it, a fault, */
    WALL_MS = 3600 * 1000, /* and so beyond this */
    FILE_LIMIT_BYTES = 16 << 20,
    WORK_LIMIT_BYTES = 128 << 20,
    MEMORY_LIMIT_BYTES = 1 << 30,
    STATIC_LIMIT_BYTES = 16 << 20,
    SCRIPT_BYTES = 16384
};

/* Exit codes of the build script: the stage that failed, or that the tools fail on any program. */
enum { STAGE_PREPROCESS = 10, STAGE_COMPILE = 11, STAGE_LINK = 12, STAGE_TOOLS = 13 };

static const char *const program_names[PROGRAM_COUNT] = {"plain", "sanitized", "checked"};

/* The same for submission and reference. x86-64-v2: what valgrind can run everywhere. */
#define COMMON_FLAGS                                                                               \
    COMPILER_LANGUAGE                                                                              \
    " -march=x86-64-v2 -g -Wall -Wextra -fmax-errors=20 -fdiagnostics-color=never "                \
    "-fno-lto -ffp-contract=off -fmax-include-depth=32"
#define PLAIN_FLAGS "-O2"
#define SANITIZED_FLAGS                                                                            \
    "-O1 -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer"
/* Gold links it in a third of the time: most of the other linker's goes into libasan's symbols. */
#define CHOOSE_LINKER "fast=; [ -x /usr/bin/ld.gold ] && fast=-fuse-ld=gold\n"
#define LINK_SANITIZED "gcc -fsanitize=address,undefined $fast"
/* By these callgrind and its reader know the runner's functions (series.h): where a submission has
 * functions of the same name, they get another. */
static const char *const runner_names[] = {"counted_call_ends", "run_call"};

/* ------------------------------------------------------------------ folder */

static int write_sources(const struct exercise *exercise, const struct source *sources, int count,
                         const char *folder, struct error *err)
{
    char from[PATH_MAX + 128], to[PATH_MAX + 128], header[EXERCISE_NAME + 4];
    char *bytes;
    size_t byte_count;
    snprintf(header, sizeof header, "%s.h", exercise->name);
    for (int i = 0; i < count; i++) {
        snprintf(to, sizeof to, "%s/%s", folder, sources[i].name);
        if (file_write(to, sources[i].bytes, sources[i].count, err) != 0)
            return -1;
    }
    snprintf(from, sizeof from, "%s/%s", exercise->folder, header);
    snprintf(to, sizeof to, "%s/%s", folder, header); /* after the sources: ours wins */
    if (file_read(from, 1 << 20, &bytes, &byte_count, err) != 0)
        return -1;
    int result = file_write(to, bytes, byte_count, err);
    free(bytes);
    return result;
}

static int program_count(enum build_extent extent)
{
    return extent == BUILD_ALL ? PROGRAM_COUNT : PROGRAM_PLAIN + 1;
}

static int copy_runners(const struct exercise *exercise, enum build_extent extent,
                        const char *folder, struct error *err)
{
    const char *root = project_root(err);
    for (int kind = 0; root && kind < program_count(extent); kind++) {
        char from[PATH_MAX + 128], to[PATH_MAX + 128];
        char *bytes;
        size_t count;
        snprintf(from, sizeof from, "%s/build/runner/%s/%s.%s.o", root, exercise->group,
                 exercise->name, program_names[kind]);
        snprintf(to, sizeof to, "%s/runner-%s.o", folder, program_names[kind]);
        if (file_read(from, 16 << 20, &bytes, &count, err) != 0)
            return -1;
        int result = file_write(to, bytes, count, err);
        free(bytes);
        if (result != 0)
            return -1;
    }
    return root ? 0 : -1;
}

/* ------------------------------------------------------------------ script */

struct script {
    char text[SCRIPT_BYTES];
    size_t count;
};

__attribute__((format(printf, 2, 3))) static void add(struct script *script, const char *format,
                                                      ...)
{
    va_list arguments;
    va_start(arguments, format);
    int added = vsnprintf(script->text + script->count, sizeof script->text - script->count, format,
                          arguments);
    va_end(arguments);
    if (added > 0 && script->count + (size_t)added < sizeof script->text)
        script->count += (size_t)added;
}

/* A failed stage is the submission's fault only if the same tools can build another program in the
 * same folder: else the disk is full, or a part of the compiler is missing. */
static void add_probe(struct script *script)
{
    add(script,
        "fail() {\n"
        "echo 'int main(void) { return 0; }' >.probe.c && gcc -static .probe.c -lm -o .probe && "
        "objcopy .probe .probed && " LINK_SANITIZED " .probe.c -lm -o .probe && "
        "exit $1\n"
        "exit %d\n"
        "}\n",
        STAGE_TOOLS);
}

/* Compiles NUMBER.i for the sanitizers. For these an overflow in a constant is none: a label as
 * `case 1 << 31:` is an error for them alone. Such a file goes without what sees overflows. */
static void add_sanitize(struct script *script)
{
    add(script, "sanitize() {\n"
                "for off in '' shift shift,signed-integer-overflow undefined; do\n"
                "gcc " COMMON_FLAGS " " SANITIZED_FLAGS " ${off:+-fno-sanitize=$off} "
                "-w -fpreprocessed -c $1.i -o $1.s.o 2>.sanitize && return\n"
                "grep -q 'constant\\|variably' .sanitize || break\n"
                "done\n"
                "cat .sanitize >&2\n"
                "return 1\n"
                "}\n");
}

static bool is_c_file(const char *name)
{
    size_t length = strlen(name);
    return length > 2 && strcmp(name + length - 2, ".c") == 0;
}

/* Compiles one file, and adds the objects to the lists of what is to be linked. */
static void add_compilation(struct script *script, const char *name, int number, bool sanitized,
                            char objects[2][1024])
{
    add(script, "gcc " COMMON_FLAGS " " COMPILER_NAMES " -I. -E %s -o %d.i || fail %d\n", name,
        number, STAGE_PREPROCESS);
    add(script,
        "gcc " COMMON_FLAGS " " PLAIN_FLAGS " %s -fpreprocessed -c %d.i -o %d.o || fail %d\n",
        compiler_liberties(), number, number, STAGE_COMPILE);
    if (sanitized)
        add(script, "sanitize %d || fail %d\n", number, STAGE_COMPILE);
    for (int i = 0; i < 2; i++) {
        size_t used = strlen(objects[i]);
        snprintf(objects[i] + used, sizeof objects[i] - used, i == 0 ? " %d.o" : " %d.s.o", number);
    }
}

static void write_script(const struct exercise *exercise, const struct source *sources, int count,
                         enum build_extent extent, struct script *script)
{
    char objects[2][1024] = {"", ""};
    bool all = extent == BUILD_ALL;
    if (strcmp(compiler_name(), "gcc") != 0)
        add(script, "gcc() { /usr/bin/%s \"$@\"; }\n", compiler_name());
    add(script, CHOOSE_LINKER);
    add_probe(script);
    add_sanitize(script);
    for (int i = 0; i < count; i++)
        if (is_c_file(sources[i].name))
            add_compilation(script, sources[i].name, i, all, objects);
    add(script, "ld -r%s -o all.o || fail %d\n", objects[0], STAGE_LINK);
    if (all)
        add(script, "ld -r%s -o all.s.o || fail %d\n", objects[1], STAGE_LINK);
    add(script, "for o in all%s; do objcopy", all ? " all.s" : "");
    for (int i = 0; i < exercise->function_count; i++)
        add(script, " --keep-global-symbol=%s", exercise->functions[i]);
    for (size_t i = 0; i < sizeof runner_names / sizeof *runner_names; i++)
        add(script, " --redefine-sym %s=its_own_%s", runner_names[i], runner_names[i]);
    add(script, " $o.o $o.kept.o || fail %d; done\n", STAGE_LINK);
    add(script,
        "objcopy" WRAPPED_OBJECT " all.kept.o all.wrapped.o && "
        "gcc -static " WRAPPED_LINK " runner-plain.o all.wrapped.o -lm -o plain || fail %d\n",
        STAGE_LINK);
    if (all)
        add(script,
            LINK_SANITIZED " runner-sanitized.o all.s.kept.o -lm -o sanitized && "
                           "gcc runner-checked.o all.kept.o -lm -o checked || fail %d\n",
            STAGE_LINK);
}

/* ------------------------------------------------------------------- build */

static int run_script(struct build *build, const char *text, struct box_outcome *outcome,
                      struct error *err)
{
    char *script = strdup(text);
    char shell[] = "/bin/sh", option[] = "-c";
    char *argv[] = {shell, option, script, NULL};
    int output = memfd_create("diagnostics", MFD_CLOEXEC);
    struct box_plan plan = {
        .profile = BOX_BUILD,
        .argv = argv,
        .program_fd = -1,
        .writable = build->folder,
        .input_fd = -1,
        .output_fd = output,
        .error_fd = output,
        .memory_bytes = MEMORY_LIMIT_BYTES,
        .file_bytes = FILE_LIMIT_BYTES,
        .scratch_bytes = 64 << 20,
        .work_bytes = WORK_LIMIT_BYTES,
        .stack_bytes = 64 << 20,
        .cpu_seconds = CPU_SECONDS,
        .box_cpu_seconds = ALL_CPU_SECONDS,
        .wall_ms = WALL_MS,
        .idle_ms = IDLE_SECONDS * 1000,
        .process_count = 32,
        .cpu = -1,
    };
    int result = -1;
    if (!script || output < 0)
        error_set(err, "build: %s", strerror(errno));
    else
        result = box_run(&plan, outcome, err);
    if (result == 0) {
        ssize_t count = pread(output, build->diagnostics, sizeof build->diagnostics - 1, 0);
        build->diagnostics[count > 0 ? count : 0] = '\0';
        build->active_layers = outcome->active;
    }
    if (output >= 0)
        close(output);
    free(script);
    return result;
}

/* What is no doing of the submission. */
static int find_fault(const struct build *build, const struct box_outcome *outcome,
                      struct error *err)
{
    if (outcome->end == BOX_ENDED_LOST)
        return error_set(err, "build box: its own process vanished");
    if (outcome->end == BOX_ENDED_SIGNAL)
        return error_set(err, "build box: the shell was killed by signal %d; is memory short?",
                         outcome->signal);
    if (outcome->end == BOX_ENDED_KILLED)
        return error_set(err,
                         "build box: it got no CPU time for %d s, or too little in an hour; the "
                         "machine is overloaded",
                         IDLE_SECONDS);
    if (outcome->end == BOX_ENDED_EXIT && outcome->exit_code == STAGE_TOOLS)
        return error_set(err,
                         "build box: the compiler fails on any program: free some space in "
                         "TMPDIR, or run make deps: %.300s",
                         build->diagnostics);
    return 0;
}

/* What the outcome of the script means for the submission. Returns 0, or -1: a fault. */
static int judge_outcome(struct build *build, const struct box_outcome *outcome, struct error *err)
{
    struct refusal *refusal = &build->refusal;
    if (outcome->end == BOX_ENDED_EXIT && outcome->exit_code == 0)
        return 0;
    if (find_fault(build, outcome, err) != 0)
        return -1;
    if (outcome->end == BOX_ENDED_MEMORY)
        refuse(refusal, &compiler_memory, "The compiler needed more than %d GB of memory.",
               "El compilador necesitó más de %d GB de memoria.", MEMORY_LIMIT_BYTES >> 30);
    else if (outcome->end == BOX_ENDED_CPU && outcome->cpu_ns >= ALL_CPU_SECONDS * 1000000000LL)
        refuse(refusal, &compiler_time,
               "Your files take more than %d s to compile, all of them together.",
               "Tus archivos tardan más de %d s en compilarse, todos juntos.", ALL_CPU_SECONDS);
    else if (outcome->end == BOX_ENDED_CPU || strstr(build->diagnostics, "CPU time limit exceeded"))
        refuse(refusal, &compiler_time, "The compiler did not end within %d seconds.",
               "El compilador no terminó en %d segundos.", CPU_SECONDS);
    else if (outcome->end == BOX_ENDED_OUTPUT ||
             strstr(build->diagnostics, "File size limit exceeded"))
        refuse(refusal, &compiler_output, "The compiler would write more than %d MB.",
               "El compilador escribiría más de %d MB.", FILE_LIMIT_BYTES >> 20);
    else if (outcome->end == BOX_ENDED_DISK)
        refuse(refusal, &compiler_output,
               "The compiler would write more than %d MB, all of your files together.",
               "El compilador escribiría más de %d MB, todos tus archivos juntos.",
               WORK_LIMIT_BYTES >> 20);
    else if (outcome->end == BOX_ENDED_EXIT && outcome->exit_code == STAGE_LINK)
        refuse(refusal, &link_failed,
               "It compiles but cannot be linked: see the messages of the linker (%s).",
               "Compila pero no se puede enlazar: vea los mensajes del enlazador (%s).", "ld");
    else if (strstr(build->diagnostics, "[-Werror="))
        refuse(refusal, &syntax,
               "It does not compile: what newer compilers (gcc 14) refuse is refused here by all: "
               "see the messages of the compiler (%s).",
               "No compila: lo que los compiladores nuevos (gcc 14) rechazan aquí se rechaza con "
               "todos: vea los mensajes del compilador (%s).",
               "gcc");
    else
        refuse(refusal, &syntax, "It does not compile: see the messages of the compiler (%s).",
               "No compila: vea los mensajes del compilador (%s).", "gcc");
    return 0;
}

/* ------------------------------------------------------------------ checks */

/* Before anything is compiled. */
static void check_directives(struct build *build, const struct source *sources, int count)
{
    for (int i = 0; i < count && !build->refusal.refused; i++)
        directives_check(sources[i].name, sources[i].bytes, sources[i].count, &build->refusal);
}

static int check_policy(struct build *build, const struct source *sources, int count,
                        struct error *err)
{
    for (int i = 0; i < count && !build->refusal.refused; i++) {
        char name[16];
        char *text;
        size_t text_bytes;
        struct policy policy;
        if (!is_c_file(sources[i].name))
            continue;
        snprintf(name, sizeof name, "%d.i", i);
        if (file_read_below(build->folder, name, FILE_LIMIT_BYTES, &text, &text_bytes, err) != 0)
            return -1;
        policy_check(text, text_bytes, NULL, &policy);
        build->refusal = policy.refusal;
        free(text);
    }
    return 0;
}

/* What tells the time or draws from chance: with it the same answer may cost another count each
 * time. */
static void note_chance(struct build *build, const struct screen *screen)
{
    static const char *const functions[] = {
        "arc4random", "clock",        "clock_gettime", "getentropy", "getpid",      "getrandom",
        "getrusage",  "gettimeofday", "time",          "times",      "timespec_get"};
    for (int i = 0; i < screen->undefined_count; i++)
        for (size_t f = 0; f < sizeof functions / sizeof *functions; f++)
            if (!build->chance[0] && strcmp(screen->undefined[i], functions[f]) == 0)
                snprintf(build->chance, sizeof build->chance, "%s", functions[f]);
}

static int screen_one(const struct exercise *exercise, const char *name, bool sanitized,
                      struct build *build, struct error *err)
{
    const char *functions[EXERCISE_FUNCTIONS + 1] = {NULL}, *given[EXERCISE_GIVEN + 1] = {NULL};
    struct screen_rules rules = {functions, given, STATIC_LIMIT_BYTES, sanitized};
    char *object;
    size_t object_bytes;
    struct screen screen;
    for (int i = 0; i < exercise->function_count; i++)
        functions[i] = exercise->functions[i];
    for (int i = 0; i < exercise->given_count; i++)
        given[i] = exercise->given[i];
    if (file_read_below(build->folder, name, 2 * FILE_LIMIT_BYTES, &object, &object_bytes, err) !=
        0)
        return -1;
    int result = screen_object(object, object_bytes, &rules, &screen, err);
    if (result == 0) {
        build->refusal = screen.refusal;
        if (!sanitized) {
            build->static_bytes = screen.static_bytes;
            note_chance(build, &screen);
        }
        screen_release(&screen);
    }
    free(object);
    return result;
}

static int check_screen(const struct exercise *exercise, enum build_extent extent,
                        struct build *build, struct error *err)
{
    if (screen_one(exercise, "all.o", false, build, err) != 0)
        return -1;
    return build->refusal.refused || extent == BUILD_PLAIN
               ? 0
               : screen_one(exercise, "all.s.o", true, build, err);
}

/* The program that is counted, as it was linked. */
static int check_program(struct build *build, struct error *err)
{
    char *bytes;
    size_t count;
    if (file_read_below(build->folder, program_names[PROGRAM_PLAIN], 2 * FILE_LIMIT_BYTES, &bytes,
                        &count, err) != 0)
        return -1;
    screen_program(bytes, count, &build->refusal);
    free(bytes);
    return 0;
}

/* Policy and screen look at what the compiler made. A missing function of the exercise is told better
 * by the screen than by the linker, so both run after a failed link too; any other name that is
 * nowhere the linker tells better, with the line that uses it. */
static int check_build(const struct exercise *exercise, const struct source *sources, int count,
                       enum build_extent extent, struct build *build, struct error *err)
{
    struct refusal of_linker = build->refusal;
    if (of_linker.refused && strcmp(of_linker.cause, "link") != 0)
        return 0;
    build->refusal.refused = false;
    if (check_policy(build, sources, count, err) != 0 ||
        (!build->refusal.refused && check_screen(exercise, extent, build, err) != 0))
        return -1;
    const bool linker_knows_better =
        of_linker.refused && strcmp(build->refusal.cause, "unknown-symbol") == 0;
    if (build->refusal.refused && !linker_knows_better)
        return 0;
    build->refusal = of_linker;
    return of_linker.refused ? 0 : check_program(build, err);
}

static int open_programs(struct build *build, enum build_extent extent, struct error *err)
{
    for (int kind = 0; kind < program_count(extent); kind++) {
        build->program_fd[kind] = file_open_below(build->folder, program_names[kind], err);
        if (build->program_fd[kind] < 0)
            return -1;
    }
    return 0;
}

void build_clear(struct build *build)
{
    memset(build, 0, sizeof *build);
    for (int kind = 0; kind < PROGRAM_COUNT; kind++)
        build->program_fd[kind] = -1;
}

int build_submission(const struct exercise *exercise, const struct source *sources,
                     int source_count, enum build_extent extent, struct build *build,
                     struct error *err)
{
    struct script script = {.count = 0};
    struct box_outcome outcome;
    build_clear(build);
    if (folder_make_work(build->folder, err) != 0 ||
        write_sources(exercise, sources, source_count, build->folder, err) != 0 ||
        copy_runners(exercise, extent, build->folder, err) != 0 ||
        box_give_folder(build->folder, err) != 0)
        return -1;
    check_directives(build, sources, source_count);
    if (build->refusal.refused) /* the box starts all the same, and tells its layers */
        return run_script(build, "exit 0", &outcome, err);
    write_script(exercise, sources, source_count, extent, &script);
    if (run_script(build, script.text, &outcome, err) != 0 ||
        judge_outcome(build, &outcome, err) != 0 ||
        check_build(exercise, sources, source_count, extent, build, err) != 0)
        return -1;
    return build->refusal.refused ? 0 : open_programs(build, extent, err);
}

int build_copy_program(const struct build *build, enum program_kind kind, const char *folder,
                       struct error *err)
{
    char path[PATH_MAX + 16];
    struct stat status;
    snprintf(path, sizeof path, "%s/%s", folder, program_names[kind]);
    int to = open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0755);
    if (to < 0 || fstat(build->program_fd[kind], &status) != 0) {
        if (to >= 0)
            close(to);
        return error_set(err, "%s: %s", path, strerror(errno));
    }
    off_t at = 0;
    while (at < status.st_size)
        if (sendfile(to, build->program_fd[kind], &at, (size_t)(status.st_size - at)) <= 0)
            break;
    fchmod(to, 0755);
    close(to);
    return at == status.st_size ? 0 : error_set(err, "%s: %s", path, strerror(errno));
}

void build_release(struct build *build)
{
    for (int kind = 0; kind < PROGRAM_COUNT; kind++)
        if (build->program_fd[kind] >= 0)
            close(build->program_fd[kind]);
    folder_remove_work(build->folder);
    build_clear(build);
}
