/* meshgrade: the command line. Each command is a file in graders/commands. */
#include "graders/commands/options.h"
#include "graders/engine/result/score.h"
#include "reference/kernels/cpu.h"

#include <errno.h>
#include <jansson.h>
#include <locale.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const struct command *const commands[] = {
    &command_list,   &command_start,     &command_check,    &command_grade,
    &command_report, &command_export,    &command_validate, &command_doctor,
    &command_bench,  &command_calibrate, &command_new,      &command_mesh};
enum { COMMAND_COUNT = sizeof commands / sizeof commands[0] };

static void print_usage(FILE *to)
{
    fprintf(to, "meshgrade grades C solutions to problems on triangle meshes.\n\n"
                "usage: meshgrade COMMAND [options] ...\n\n");
    for (int i = 0; i < COMMAND_COUNT; i++) {
        char left[64];
        snprintf(left, sizeof left, "%s %s", commands[i]->name, commands[i]->arguments);
        fprintf(to, "  %-34s %s\n", left, commands[i]->help);
    }
    fprintf(to, "\n  meshgrade COMMAND --help tells its options; meshgrade --version the version.\n"
                "  exit codes: 0 all passed, 1 something did not pass, 2 the grader failed, 64 "
                "wrong usage\n");
}

/* Safe in a signal handler and without memory. */
_Noreturn static void end_with(const char *words, size_t count)
{
    ssize_t written = write(STDERR_FILENO, words, count);
    (void)written;
    _exit(EXIT_FAULT);
}

/* A value that lacks a part for want of memory would be a wrong mark, and jansson cannot be asked
 * whether it does. So want of memory in it ends this process: a worker's end is a fault. */
static void *allocate_or_end(size_t bytes)
{
    static const char words[] = "meshgrade: out of memory\n";
    void *block = malloc(bytes);
    if (!block)
        end_with(words, sizeof words - 1);
    return block;
}

static pid_t own_pid;

/* A crash of the grader is a fault like any other. Its children (judges, boxes) keep the default,
 * so that their parent sees what they died of. */
static void tell_crash(int signal_number)
{
    static const char words[] = "meshgrade: the grader itself crashed, or memory ran out in a "
                                "library; nothing was marked\n";
    if (getpid() != own_pid) {
        signal(signal_number, SIG_DFL); /* returning repeats the crash */
        return;
    }
    end_with(words, sizeof words - 1);
}

static void watch_crashes(void)
{
    static const int crashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGABRT};
    static char stack[1 << 16];
    const stack_t own_stack = {.ss_sp = stack, .ss_size = sizeof stack};
    struct sigaction present, ours = {.sa_handler = tell_crash, .sa_flags = SA_ONSTACK};
    own_pid = getpid();
    sigaltstack(&own_stack, NULL);
    for (size_t i = 0; i < sizeof crashes / sizeof *crashes; i++)
        if (sigaction(crashes[i], NULL, &present) == 0 && present.sa_handler == SIG_DFL)
            sigaction(crashes[i], &ours, NULL); /* a sanitizer's stays */
}

/* What was printed may not have arrived: a full disk, a closed pipe. */
static int close_output(int code)
{
    if (fflush(stdout) == 0 && !ferror(stdout))
        return code;
    fprintf(stderr, "meshgrade: the output could not be written: %s\n", strerror(errno));
    return EXIT_FAULT;
}

int main(int argc, char **argv)
{
    watch_crashes();
    signal(SIGXFSZ, SIG_IGN); /* a file that may not grow is an error of write, and is told */
    json_set_alloc_funcs(allocate_or_end, free);
    setlocale(LC_CTYPE, "C.UTF-8"); /* for the width of characters; numbers stay as in C */
    const char *name = argc > 1 ? argv[1] : "";
    if (strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0 || strcmp(name, "help") == 0) {
        print_usage(stdout);
        return EXIT_PASSED;
    }
    if (strcmp(name, "--version") == 0) {
        printf("meshgrade %s\n", meshgrade_version());
        return EXIT_PASSED;
    }
    struct error err = {""};
    if (cpu_check_limit(&err) != 0) {
        fprintf(stderr, "meshgrade: %s\n", err.text);
        return EXIT_USAGE;
    }
    for (int i = 0; i < COMMAND_COUNT; i++)
        if (strcmp(commands[i]->name, name) == 0)
            return close_output(commands[i]->run(argc - 1, argv + 1));
    if (*name)
        fprintf(stderr, "meshgrade: there is no command \"%s\"\n\n", name);
    print_usage(stderr);
    return EXIT_USAGE;
}
