/* Makes one system or library call of a program fail, for the tests of what a failure leads to.
 *
 *   INJECT=malloc:17 LD_PRELOAD=inject.so program     the 17th malloc of a process returns NULL
 *   INJECT=clock:5                                    from the 5th reading on, clocks are a day
 * later INJECT=kill:3                                     the 3rd child that is forked is killed at
 * once INJECT_COUNTS=FILE                                at its end, each process adds a line with
 * its counts
 *
 * A child inherits its parent's counts and goes on from there. Programs that a box starts are not
 * touched: their environment is the box's own. */
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum call {
    CALL_MALLOC,
    CALL_OPEN,
    CALL_READ,
    CALL_WRITE,
    CALL_FORK,
    CALL_MMAP,
    CALL_MEMFD,
    CALL_SYSCALL,
    CALL_SOCKETPAIR,
    CALL_MKDIR,
    CALL_RENAME,
    CALL_FTRUNCATE,
    CALL_FSYNC,
    CALL_CLOCK,
    CALL_KILL,
    CALL_READDIR,
    CALL_COUNT
};

static const char *const names[CALL_COUNT] = {
    "malloc",     "open",  "read",   "write",     "fork",  "mmap",  "memfd", "syscall",
    "socketpair", "mkdir", "rename", "ftruncate", "fsync", "clock", "kill",  "readdir"};

static atomic_long counts[CALL_COUNT];
static int chosen = -1;
static long chosen_index;

void *__libc_malloc(size_t bytes);
void *__libc_calloc(size_t count, size_t bytes);
void *__libc_realloc(void *block, size_t bytes);

__attribute__((constructor)) static void read_plan(void)
{
    const char *plan = getenv("INJECT");
    for (int call = 0; plan && call < CALL_COUNT; call++) {
        size_t length = strlen(names[call]);
        if (strncmp(plan, names[call], length) == 0 && plan[length] == ':') {
            chosen_index = atol(plan + length + 1);
            chosen = call;
        }
    }
    for (int call = 0; call < CALL_COUNT; call++)
        atomic_store(&counts[call], 0);
}

/* Counts a call; says whether it is the one to fail. */
static bool strikes(enum call call)
{
    return atomic_fetch_add(&counts[call], 1) + 1 == chosen_index && chosen == (int)call;
}

__attribute__((destructor)) static void write_counts(void)
{
    const char *path = getenv("INJECT_COUNTS");
    char line[512];
    int used = 0;
    if (!path)
        return;
    chosen = -1;
    int file = open(path, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0644);
    for (int call = 0; call < CALL_COUNT; call++)
        used += snprintf(line + used, sizeof line - (size_t)used, "%s %ld ", names[call],
                         atomic_load(&counts[call]));
    line[used - 1] = '\n';
    if (file >= 0 && write(file, line, (size_t)used) != used)
        abort();
    close(file);
}

/* The libc's own function of that name. Not for C's pedants: a function's address from a data
 * pointer. */
#define REAL(name) (__extension__(__typeof__(&name)) dlsym(RTLD_NEXT, #name))

/* ------------------------------------------------------------------ memory */

void *malloc(size_t bytes)
{
    if (!strikes(CALL_MALLOC))
        return __libc_malloc(bytes);
    errno = ENOMEM;
    return NULL;
}

void *calloc(size_t count, size_t bytes)
{
    if (!strikes(CALL_MALLOC))
        return __libc_calloc(count, bytes);
    errno = ENOMEM;
    return NULL;
}

void *realloc(void *block, size_t bytes)
{
    if (!strikes(CALL_MALLOC))
        return __libc_realloc(block, bytes);
    errno = ENOMEM;
    return NULL;
}

void *mmap(void *at, size_t bytes, int protection, int flags, int file, off_t offset)
{
    if (!strikes(CALL_MMAP))
        return REAL(mmap)(at, bytes, protection, flags, file, offset);
    errno = ENOMEM;
    return MAP_FAILED;
}

int memfd_create(const char *name, unsigned flags)
{
    if (!strikes(CALL_MEMFD))
        return REAL(memfd_create)(name, flags);
    errno = ENFILE;
    return -1;
}

/* ------------------------------------------------------------------- files */

int open(const char *path, int flags, ...)
{
    va_list more;
    va_start(more, flags);
    mode_t mode = flags & O_CREAT ? va_arg(more, mode_t) : 0;
    va_end(more);
    if (!strikes(CALL_OPEN))
        return REAL(open)(path, flags, mode);
    errno = EMFILE;
    return -1;
}

FILE *fopen(const char *path, const char *mode)
{
    if (!strikes(CALL_OPEN))
        return REAL(fopen)(path, mode);
    errno = EMFILE;
    return NULL;
}

ssize_t read(int file, void *bytes, size_t count)
{
    if (!strikes(CALL_READ))
        return REAL(read)(file, bytes, count);
    errno = EIO;
    return -1;
}

ssize_t pread(int file, void *bytes, size_t count, off_t offset)
{
    if (!strikes(CALL_READ))
        return REAL(pread)(file, bytes, count, offset);
    errno = EIO;
    return -1;
}

ssize_t write(int file, const void *bytes, size_t count)
{
    if (!strikes(CALL_WRITE))
        return REAL(write)(file, bytes, count);
    errno = ENOSPC;
    return -1;
}

ssize_t pwrite(int file, const void *bytes, size_t count, off_t offset)
{
    if (!strikes(CALL_WRITE))
        return REAL(pwrite)(file, bytes, count, offset);
    errno = ENOSPC;
    return -1;
}

size_t fwrite(const void *bytes, size_t size, size_t count, FILE *file)
{
    if (!strikes(CALL_WRITE))
        return REAL(fwrite)(bytes, size, count, file);
    errno = ENOSPC;
    file->_flags |= _IO_ERR_SEEN; /* what ferror tells */
    return 0;
}

int fsync(int file)
{
    if (!strikes(CALL_FSYNC))
        return REAL(fsync)(file);
    errno = EIO;
    return -1;
}

/* The names under which libraries of the distribution import the same calls. */
int open64(const char *path, int flags, ...) __attribute__((alias("open")));
FILE *fopen64(const char *path, const char *mode) __attribute__((alias("fopen")));
ssize_t pread64(int file, void *bytes, size_t count, off_t offset) __attribute__((alias("pread")));
ssize_t pwrite64(int file, const void *bytes, size_t count, off_t offset)
    __attribute__((alias("pwrite")));
int ftruncate64(int file, off_t bytes) __attribute__((alias("ftruncate")));
void *mmap64(void *at, size_t bytes, int protection, int flags, int file, off_t offset)
    __attribute__((alias("mmap")));
struct dirent64 *readdir64(DIR *folder) __attribute__((alias("readdir")));

int ftruncate(int file, off_t bytes)
{
    if (!strikes(CALL_FTRUNCATE))
        return REAL(ftruncate)(file, bytes);
    errno = ENOSPC;
    return -1;
}

int mkdir(const char *path, mode_t mode)
{
    if (!strikes(CALL_MKDIR))
        return REAL(mkdir)(path, mode);
    errno = ENOSPC;
    return -1;
}

struct dirent *readdir(DIR *folder)
{
    if (!strikes(CALL_READDIR))
        return REAL(readdir)(folder);
    errno = EIO;
    return NULL;
}

int rename(const char *from, const char *to)
{
    if (!strikes(CALL_RENAME))
        return REAL(rename)(from, to);
    errno = EIO;
    return -1;
}

/* --------------------------------------------------------------- processes */

pid_t fork(void)
{
    if (strikes(CALL_FORK)) {
        errno = EAGAIN;
        return -1;
    }
    pid_t child = REAL(fork)();
    if (child > 0 && strikes(CALL_KILL))
        kill(child, SIGKILL);
    return child;
}

int socketpair(int domain, int type, int protocol, int ends[2])
{
    if (!strikes(CALL_SOCKETPAIR))
        return REAL(socketpair)(domain, type, protocol, ends);
    errno = EMFILE;
    return -1;
}

/* Whatever has no function of its own in libc: pidfd_open, openat2, clone3, futex, seccomp ... */
long syscall(long number, ...)
{
    long a[6];
    va_list more;
    va_start(more, number);
    for (int i = 0; i < 6; i++)
        a[i] = va_arg(more, long);
    va_end(more);
    if (strikes(CALL_SYSCALL)) {
        errno = EAGAIN;
        return -1;
    }
    long result = REAL(syscall)(number, a[0], a[1], a[2], a[3], a[4], a[5]);
    if (number == SYS_clone3 && result > 0 && strikes(CALL_KILL))
        kill((pid_t)result, SIGKILL);
    return result;
}

_Noreturn void _exit(int code)
{
    write_counts();
    REAL(syscall)(SYS_exit_group, code);
    abort();
}

/* ------------------------------------------------------------------- clock */

int clock_gettime(clockid_t clock, struct timespec *time)
{
    int result = REAL(clock_gettime)(clock, time);
    bool from_now = chosen == CALL_CLOCK && atomic_load(&counts[CALL_CLOCK]) + 1 >= chosen_index;
    (void)strikes(CALL_CLOCK);
    bool of_world = clock == CLOCK_REALTIME || clock == CLOCK_MONOTONIC;
    if (result == 0 && from_now && of_world)
        time->tv_sec += 86400;
    return result;
}
