/* Hostile programs for the tests of the box, one an argument: what a submission may try. Each
 * returns or exits 99 when its attack had an effect that the box must prevent; the test names the
 * end that it must have instead. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <linux/futex.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { SUCCEEDED = 99, HARMLESS = 7 };

static volatile uint64_t sink;

static _Noreturn int loop(void)
{
    for (;;)
        sink++;
}

static _Noreturn int sleep_forever(void)
{
    for (;;)
        nanosleep(&(struct timespec){.tv_sec = 1000}, NULL);
}

static int ignore_cpu_limit(void)
{
    signal(SIGXCPU, SIG_IGN);
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_SETMASK, &all, NULL);
    return loop();
}

/* Through a volatile pointer, so that the compiler keeps it. */
static void touch(volatile char *block, size_t bytes)
{
    for (size_t i = 0; i < bytes; i += 4096)
        block[i] = 1;
}

static int malloc_bomb(void)
{
    for (;;) {
        char *block = malloc(1 << 20);
        if (!block)
            return HARMLESS;
        touch(block, 1 << 20);
    }
}

static int map_bomb(void)
{
    for (;;) {
        char *block =
            mmap(NULL, 1 << 24, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (block == MAP_FAILED)
            return HARMLESS;
        touch(block, 1 << 24);
    }
}

static int fork_bomb(void)
{
    int born = 0;
    for (int i = 0; i < 100; i++) {
        pid_t child = fork();
        if (child == 0)
            sleep_forever();
        born += child > 0;
    }
    return born ? SUCCEEDED : HARMLESS;
}

static int vfork_once(void)
{
    return syscall(SYS_vfork) >= 0 ? SUCCEEDED : HARMLESS;
}

static void *thread_body(void *argument)
{
    return argument;
}

static int start_thread(void)
{
    pthread_t thread;
    return pthread_create(&thread, NULL, thread_body, NULL) == 0 ? SUCCEEDED : HARMLESS;
}

static int flood(void)
{
    static char text[65536];
    memset(text, 'x', sizeof text);
    for (;;)
        if (write(1, text, sizeof text) < 0)
            return HARMLESS;
}

static int flood_ignoring(void)
{
    signal(SIGXFSZ, SIG_IGN);
    static char text[65536];
    ssize_t got;
    do
        got = write(1, text, sizeof text);
    while (got > 0);
    return got < 0 && errno == EFBIG ? HARMLESS : SUCCEEDED;
}

/* Counts the descriptors that it can write to, beside 0 to 5. */
static int write_everywhere(void)
{
    int written = 0;
    for (int fd = 0; fd < 1024; fd++)
        if (write(fd, "passed: 10 points\n", 18) >= 0 && fd > 5)
            written++;
    return written ? SUCCEEDED : HARMLESS;
}

static int read_passwd(void)
{
    return open("/etc/passwd", O_RDONLY) >= 0 ? SUCCEEDED : HARMLESS;
}

/* A path that ends at the very end of a page, before unmapped memory. */
static int read_at_page_end(void)
{
    char *pages = mmap(NULL, 8192, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    munmap(pages + 4096, 4096);
    char *path = pages + 4096 - sizeof "/etc/shadow\x01";
    memcpy(path, "/etc/shadow\x01", sizeof "/etc/shadow\x01");
    return syscall(SYS_openat, AT_FDCWD, path, O_RDONLY) >= 0 ? SUCCEEDED : HARMLESS;
}

static int read_wild_path(void)
{
    return syscall(SYS_openat, AT_FDCWD, (char *)16, O_RDONLY) >= 0 ? SUCCEEDED : HARMLESS;
}

static int locale_escape(void)
{
    return open("/usr/lib/locale/../../../etc/passwd", O_RDONLY) >= 0 ? SUCCEEDED : HARMLESS;
}

static int kill_parent(void)
{
    return kill(getppid(), SIGKILL) == 0 ? SUCCEEDED : HARMLESS;
}

static int kill_all(void)
{
    return kill(-1, SIGKILL) == 0 ? SUCCEEDED : HARMLESS;
}

static int kill_thread_of_parent(void)
{
    return syscall(SYS_tgkill, getppid(), getppid(), SIGABRT) == 0 ? SUCCEEDED : HARMLESS;
}

static int raise_kill(void)
{
    return raise(SIGKILL);
}

static int trace(void)
{
    return ptrace(PTRACE_ATTACH, getppid(), 0, 0) == 0 ? SUCCEEDED : HARMLESS;
}

static int open_socket(void)
{
    return socket(AF_INET, SOCK_STREAM, 0) >= 0 ? SUCCEEDED : HARMLESS;
}

static int overflow_stack(int depth)
{
    volatile char block[4096];
    block[0] = (char)depth;
    return depth < 0 ? 0 : overflow_stack(depth + 1) + block[0];
}

static int overflow(void)
{
    return overflow_stack(1);
}

/* fork by the 32-bit call number, which is open() in a 64-bit list. */
static int old_interrupt(void)
{
#ifdef __x86_64__
    long result = 2;
    __asm__ volatile("int $0x80" : "+a"(result) : : "memory", "r8", "r9", "r10", "r11");
    return result >= 0 ? SUCCEEDED : HARMLESS;
#else
    return syscall(SYS_socket, AF_INET, SOCK_STREAM, 0) >= 0 ? SUCCEEDED : HARMLESS;
#endif
}

/* Memory that would make a large core file. */
static void fill(void)
{
    size_t bytes = 30 << 20;
    char *large = malloc(bytes);
    if (large)
        touch(large, bytes);
}

static int abort_large(void)
{
    fill();
    abort();
}

static int crash_large(void)
{
    fill();
    *(volatile int *)8 = 1;
    return SUCCEEDED;
}

static int set_dumpable(void)
{
    return prctl(PR_SET_DUMPABLE, 1) == 0 ? SUCCEEDED : HARMLESS;
}

static int raise_limits(void)
{
    struct rlimit limit = {RLIM_INFINITY, RLIM_INFINITY};
    return setrlimit(RLIMIT_CPU, &limit) == 0 ? SUCCEEDED : HARMLESS;
}

static int unshare_user(void)
{
    return unshare(CLONE_NEWUSER) == 0 ? SUCCEEDED : HARMLESS;
}

static int unpin(void)
{
    cpu_set_t set;
    memset(&set, 0xff, sizeof set);
    return sched_setaffinity(0, sizeof set, &set) == 0 ? SUCCEEDED : HARMLESS;
}

static int run_shell(void)
{
    char *argv[] = {(char *)(uintptr_t) "/bin/sh", NULL};
    execv("/bin/sh", argv);
    return HARMLESS;
}

static int uring(void)
{
    return syscall(SYS_io_uring_setup, 8, NULL) >= 0 ? SUCCEEDED : HARMLESS;
}

static int read_parent_memory(void)
{
    char here[8];
    struct iovec to = {here, 8}, from = {here, 8};
    return process_vm_readv(getppid(), &to, 1, &from, 1, 0) >= 0 ? SUCCEEDED : HARMLESS;
}

/* Uses the descriptors that the box itself used before exec. */
static int use_slots(void)
{
    struct msghdr message = {0};
    char *argv[] = {NULL};
    if (sendmsg(201, &message, 0) >= 0)
        return SUCCEEDED;
    syscall(SYS_execveat, 200, "", argv, argv, AT_EMPTY_PATH);
    for (int fd = 6; fd < 1024; fd++)
        if (lseek(fd, 0, SEEK_CUR) >= 0 || errno != EBADF)
            return SUCCEEDED;
    return HARMLESS;
}

/* Leaves children behind that let go of everything that held them, and ends well. */
static int leave_children(void)
{
    for (int i = 0; i < 3; i++) {
        pid_t child = fork();
        if (child == 0) {
            setsid();
            for (int fd = 0; fd < 64; fd++)
                close(fd);
            if (fork() >= 0)
                sleep_forever();
            _exit(0);
        }
        if (child < 0)
            return SUCCEEDED;
    }
    return 0;
}

static int write_outside(void)
{
    static const char *const paths[] = {"/tmp/box-test-escaped", "/etc/box-test-escaped",
                                        "/usr/box-test-escaped", "/dev/shm/box-test-escaped",
                                        "/proc/self/../../box-test-escaped"};
    int written = 0;
    for (size_t i = 1; i < sizeof paths / sizeof paths[0]; i++)
        written += open(paths[i], O_CREAT | O_WRONLY, 0600) >= 0;
    open(paths[0], O_CREAT | O_WRONLY, 0600); /* its own /tmp is its own affair */
    return written ? SUCCEEDED : HARMLESS;
}

/* Writes 8 MB; where to go on after it. */
static int fill_file(const char *path)
{
    static const char zeros[1 << 20];
    int fd = open(path, O_CREAT | O_WRONLY, 0600);
    for (int i = 0; fd >= 0 && i < 8; i++)
        if (write(fd, zeros, sizeof zeros) <= 0)
            break;
    return fd;
}

/* 400 MB in 50 files, then folders in folders as deep as they go. */
static int fill_disk(void)
{
    char path[32];
    for (int i = 0; i < 100; i++) {
        snprintf(path, sizeof path, i % 2 ? "file%d" : "tmp/file%d", i);
        close(fill_file(path));
    }
    for (int i = 0; i < 10000 && mkdir(i ? "deep" : "tmp/deep", 0700) == 0; i++)
        if (chdir(i ? "deep" : "tmp/deep") != 0)
            break;
    return HARMLESS;
}

/* The same in files that have no name and are only mapped. */
static int fill_unseen(void)
{
    for (int i = 0; i < 50; i++) {
        int fd = fill_file("tmp/file");
        unlink("tmp/file");
        if (fd >= 0)
            mmap(NULL, 8 << 20, PROT_READ, MAP_SHARED, fd, 0);
        close(fd);
    }
    usleep(100000);
    return HARMLESS;
}

static int exit_zero(void)
{
    return 0;
}

static const struct {
    const char *name;
    int (*run)(void);
} attacks[] = {
    {"loop", loop},
    {"sleep", sleep_forever},
    {"ignore-cpu-limit", ignore_cpu_limit},
    {"malloc-bomb", malloc_bomb},
    {"map-bomb", map_bomb},
    {"fork-bomb", fork_bomb},
    {"vfork", vfork_once},
    {"thread", start_thread},
    {"flood", flood},
    {"flood-ignoring", flood_ignoring},
    {"write-everywhere", write_everywhere},
    {"read-passwd", read_passwd},
    {"read-at-page-end", read_at_page_end},
    {"read-wild-path", read_wild_path},
    {"locale-escape", locale_escape},
    {"kill-parent", kill_parent},
    {"kill-all", kill_all},
    {"kill-thread-of-parent", kill_thread_of_parent},
    {"raise-kill", raise_kill},
    {"trace", trace},
    {"socket", open_socket},
    {"stack-overflow", overflow},
    {"int-0x80", old_interrupt},
    {"abort", abort_large},
    {"crash", crash_large},
    {"set-dumpable", set_dumpable},
    {"raise-limits", raise_limits},
    {"unshare", unshare_user},
    {"unpin", unpin},
    {"shell", run_shell},
    {"io-uring", uring},
    {"read-parent-memory", read_parent_memory},
    {"use-slots", use_slots},
    {"leave-children", leave_children},
    {"write-outside", write_outside},
    {"fill-disk", fill_disk},
    {"fill-unseen", fill_unseen},
    {"exit-zero", exit_zero},
};

/* Ends before main when asked to by argv[0]: what a constructor in a submission does. */
__attribute__((constructor)) static void early(int argc, char **argv)
{
    (void)argc;
    if (strcmp(argv[0], "early-exit") == 0)
        _exit(0);
}

int main(int argc, char **argv)
{
    for (size_t i = 0; argc > 1 && i < sizeof attacks / sizeof attacks[0]; i++)
        if (strcmp(argv[1], attacks[i].name) == 0)
            return attacks[i].run();
    return 98;
}
