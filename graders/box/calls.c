/* The system calls of each profile, by name. Names that a machine does not have are passed over. */
#include "graders/box/inside.h"

/* What a static program needs of the kernel to start, compute, allocate, print on open descriptors,
 * abort and end. Calls that are allowed with certain arguments only stand in filter.c. */
const char *const calls_run[] = {
    "read", "readv", "pread64", "write", "writev", "pwrite64", "lseek", "close", "dup", "fstat",
    /* memory */
    "brk", "mmap", "munmap", "mremap", "mprotect", "madvise", "mincore",
    /* signals to itself */
    "rt_sigaction", "rt_sigprocmask", "rt_sigreturn", "sigaltstack", "restart_syscall",
    /* start and end of a thread */
    "arch_prctl", "set_tid_address", "set_robust_list", "rseq", "futex", "exit", "exit_group",
    /* time */
    "clock_gettime", "clock_getres", "gettimeofday", "time", "times", "getrusage", "nanosleep",
    "clock_nanosleep", "sched_yield",
    /* what it and the machine are */
    "getpid", "gettid", "getppid", "getuid", "geteuid", "getgid", "getegid", "uname", "sysinfo",
    "getcpu", "sched_getaffinity", "getrlimit", "getrandom", NULL};

/* What compilers, valgrind and sanitizers need besides. The files are guarded by the private root
 * and by Landlock. */
const char *const calls_tools[] = {
    "read", "readv", "pread64", "preadv", "preadv2", "write", "writev", "pwrite64", "pwritev",
    "pwritev2", "lseek", "close", "close_range", "open", "openat", "openat2", "creat", "stat",
    "fstat", "lstat", "newfstatat", "statx", "statfs", "fstatfs", "access", "faccessat",
    "faccessat2", "readlink", "readlinkat", "getdents", "getdents64", "getcwd", "chdir", "fchdir",
    "rename", "renameat", "renameat2", "mkdir", "mkdirat", "rmdir", "unlink", "unlinkat", "link",
    "linkat", "symlink", "symlinkat", "umask", "utime", "utimes", "utimensat", "futimesat",
    "truncate", "ftruncate", "fsync", "fdatasync", "sync_file_range", "fadvise64",
    "copy_file_range", "sendfile", "flock", "dup", "dup2", "dup3", "pipe", "pipe2", "poll", "ppoll",
    "select", "pselect6",
    /* memory */
    "brk", "mmap", "munmap", "mremap", "mprotect", "madvise", "msync", "mincore", "mlock",
    "munlock", "memfd_create", "membarrier",
    /* signals */
    "rt_sigaction", "rt_sigprocmask", "rt_sigreturn", "rt_sigpending", "rt_sigsuspend",
    "rt_sigtimedwait", "sigaltstack", "restart_syscall", "pause",
    /* the process */
    "execve", "execveat", "arch_prctl", "set_tid_address", "set_robust_list", "get_robust_list",
    "rseq", "futex", "exit", "exit_group", "prctl", "personality", "capget", "wait4", "waitid",
    "setpgid", "getpgid", "getpgrp", "getsid",
    /* time */
    "clock_gettime", "clock_getres", "gettimeofday", "time", "times", "getrusage", "nanosleep",
    "clock_nanosleep", "sched_yield",
    /* what it and the machine are */
    "getpid", "gettid", "getppid", "getuid", "geteuid", "getgid", "getegid", "getresuid",
    "getresgid", "getgroups", "uname", "sysinfo", "getcpu", "sched_getaffinity", "sched_getparam",
    "sched_getscheduler", "getpriority", "getrlimit", "setrlimit", "getrandom", NULL};

/* Compilers and linkers start each other, make what they have written executable, and ask for the
 * room beforehand: room on a disk that no count of written bytes tells of. */
const char *const calls_processes[] = {"fork",      "vfork",    "chmod",     "fchmod",
                                       "fallocate", "fchmodat", "fchmodat2", NULL};

/* No tool makes these for honest work. Calls in no list are answered ENOSYS, as on an older kernel:
 * tools of later years may try new calls and then do without. */
const char *const calls_forbidden[] = {
    /* network */
    "socket", "socketpair", "connect", "bind", "listen", "accept", "accept4", "sendto", "sendmmsg",
    /* other processes */
    "ptrace", "process_vm_readv", "process_vm_writev", "process_madvise", "pidfd_open",
    "pidfd_getfd", "pidfd_send_signal", "kcmp", "rt_sigqueueinfo", "rt_tgsigqueueinfo",
    /* the kernel's large and young parts */
    "io_uring_setup", "io_uring_enter", "io_uring_register", "userfaultfd", "bpf",
    "perf_event_open", "keyctl", "add_key", "request_key", "seccomp", "memfd_secret", "io_setup",
    "io_submit", "fanotify_init", "lookup_dcookie", "uselib", "ustat", "vmsplice", "splice", "tee",
    /* mounts and namespaces */
    "mount", "umount2", "move_mount", "open_tree", "fsopen", "fsconfig", "fsmount", "fspick",
    "mount_setattr", "pivot_root", "chroot", "unshare", "setns", "open_by_handle_at",
    "name_to_handle_at",
    /* work that a timer begins, after the measured call */
    "setitimer", "alarm", "timerfd_create",
    /* shared memory and queues outside of files */
    "shmget", "shmat", "semget", "msgget", "mq_open",
    /* the machine */
    "kexec_load", "kexec_file_load", "init_module", "finit_module", "delete_module", "reboot",
    "swapon", "swapoff", "quotactl", "quotactl_fd", "acct", "settimeofday", "clock_settime",
    "clock_adjtime", "adjtimex", "iopl", "ioperm", "syslog", "vhangup", "sethostname",
    "setdomainname", "migrate_pages", "move_pages", "modify_ldt", NULL};

const char *const calls_quiet[] = {"mknod",
                                   "mknodat",
                                   "chown",
                                   "fchown",
                                   "lchown",
                                   "fchownat",
                                   "setpriority",
                                   "sched_setaffinity",
                                   "sched_setscheduler",
                                   "sched_setparam",
                                   "setsid",
                                   "setuid",
                                   "setgid",
                                   "setreuid",
                                   "setregid",
                                   "setresuid",
                                   "setresgid",
                                   "setgroups",
                                   "setfsuid",
                                   "setfsgid",
                                   "capset",
                                   "setxattr",
                                   "lsetxattr",
                                   "fsetxattr",
                                   "ioprio_set",
                                   "timer_create",
                                   NULL};
