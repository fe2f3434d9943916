/* Before the first call; see seclude.h. */
#include "graders/runner/seclude.h"

#include "graders/wire/control.h"

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <stddef.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

static void close_regions(void)
{
    close(CONTROL_FD);
    close(INPUT_FD);
    close(ANSWER_FD);
}

#ifdef RUNNER_WITHOUT_SHIM
/* UBSan asks for its options when it finds its first error; a variable would be gone by then. */
const char *__ubsan_default_options(void);
const char *__ubsan_default_options(void)
{
    return "abort_on_error=0:exitcode=" EXIT_TOOL_FOUND ":color=never:print_stacktrace=0";
}
#endif

/* The texts stand on the stack, where they could be found without a name. */
static void clear_environment(void)
{
    static char path[] = "PATH=/usr/bin:/bin", language[] = "LC_ALL=C", folder[] = "TMPDIR=.";
    static char *left[] = {path, language, folder, NULL};
    for (char **variable = environ; variable && *variable; variable++)
        explicit_bzero(*variable, strlen(*variable));
    environ = left;
}

/* A second filter over the box's own, which must let the tool itself be started, and the box enter
 * its folder. Calls of other architectures die by the first. */
static int give_up_calls(void)
{
    struct sock_filter code[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_execve, 3, 0),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_execveat, 2, 0),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_chdir, 1, 0),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_fchdir, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    struct sock_fprog filter = {sizeof code / sizeof *code, code};
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter, 0, 0);
}

int seclude(bool in_tools)
{
    close_regions();
    clear_environment();
    return in_tools ? give_up_calls() : 0;
}
