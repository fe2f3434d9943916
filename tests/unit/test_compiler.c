/* The compiler that submissions meet: its headers and its language, on this machine as on others. */
#include "graders/engine/build/compiler.h"
#include "graders/engine/build/policy.h"
#include "tests/unit/preprocessed.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

/* Each header of libc and of the kernel's interface that this machine has, alone: the folders in
 * which they stand differ between distributions, and links lead from one to the other. Only
 * <sys/io.h> and <sys/rseq.h> are left out, which hold inline assembly. */
static void every_header_of_libc_passes(void **state)
{
    (void)state;
    static const char headers[] =
        "aio aliases alloca ar argp argz arpa/ftp arpa/inet arpa/nameser arpa/telnet "
        "arpa/tftp assert byteswap complex cpio crypt ctype dirent dlfcn elf endian "
        "envz err errno error execinfo fcntl features fenv fmtmsg fnmatch fstab fts ftw "
        "gconv getopt glob gnu-versions grp gshadow iconv ifaddrs inttypes langinfo "
        "lastlog libgen libintl limits link locale malloc math mcheck memory mntent "
        "monetary mqueue net/ethernet net/if net/if_arp net/route netdb netinet/ether "
        "netinet/icmp6 netinet/in netinet/ip netinet/tcp netinet/udp nl_types nss "
        "obstack paths poll printf proc_service pthread pty pwd re_comp regex resolv "
        "rpc/netdb sched search semaphore setjmp sgtty shadow signal spawn stdalign "
        "stdarg stdatomic stdbool stddef stdint stdio stdio_ext stdlib stdnoreturn "
        "string strings sys/acct sys/auxv sys/cdefs sys/dir sys/epoll sys/errno "
        "sys/eventfd sys/fanotify sys/fcntl sys/file sys/fsuid sys/gmon sys/inotify "
        "sys/ioctl sys/ipc sys/kd sys/klog sys/mman sys/mount sys/msg sys/mtio "
        "sys/param sys/personality sys/pidfd sys/poll sys/prctl sys/procfs sys/profil "
        "sys/ptrace sys/queue sys/quota sys/random sys/reboot sys/reg sys/resource "
        "sys/select sys/sem sys/sendfile sys/shm sys/signal sys/signalfd "
        "sys/single_threaded sys/socket sys/soundcard sys/stat sys/statfs sys/statvfs "
        "sys/swap sys/syscall sys/sysinfo sys/syslog sys/sysmacros sys/termios sys/time "
        "sys/timeb sys/timerfd sys/times sys/timex sys/ttydefaults sys/types "
        "sys/ucontext sys/uio sys/un sys/unistd sys/user sys/utsname sys/vfs sys/vlimit "
        "sys/vt sys/wait sys/xattr syscall sysexits syslog tar termio termios tgmath "
        "thread_db threads time ttyent uchar ucontext ulimit unistd utime utmp utmpx "
        "values wait wchar wctype wordexp linux/errno linux/limits linux/futex "
        "asm/errno asm/unistd immintrin x86intrin float iso646";
    char list[sizeof headers], source[200], *rest = NULL;
    int there = 0;
    memcpy(list, headers, sizeof headers);
    for (char *name = strtok_r(list, " ", &rest); name; name = strtok_r(NULL, " ", &rest)) {
        snprintf(source, sizeof source,
                 "#define _GNU_SOURCE\n#if __has_include(<%s.h>)\n#include <%s.h>\n#else\n"
                 "int missing_here;\n#endif\n",
                 name, name);
        struct policy policy;
        policy_check(preprocessed_text,
                     preprocessed_make(source, COMPILER_LANGUAGE " " COMPILER_NAMES), NULL,
                     &policy);
        if (policy.refusal.refused)
            print_error("<%s.h>: %s\n", name, policy.refusal.message.en);
        assert_false(policy.refusal.refused);
        there += strstr(preprocessed_text, "missing_here") == NULL;
    }
    assert_true(there > 150);
}

/* Debian 13 keeps <asm/errno.h> behind such a link. */
static void headers_behind_links_keep_their_place(void **state)
{
    (void)state;
    char flags[500], path[100], header[100], marker[200];
    snprintf(path, sizeof path, "%s/in", preprocessed_folder);
    snprintf(header, sizeof header, "%s/linked.h", preprocessed_folder);
    snprintf(marker, sizeof marker, "\"%s/linked.h\"", path);
    preprocessed_write("linked.h", "int linked;\n");
    assert_int_equal(symlink(".", path), 0);
    snprintf(flags, sizeof flags, COMPILER_LANGUAGE " " COMPILER_NAMES " -isystem %s", path);
    preprocessed_make("#include <linked.h>\nint x;\n", flags);
    assert_int_equal(unlink(path), 0);
    assert_int_equal(unlink(header), 0);
    assert_non_null(strstr(preprocessed_text, marker));
}

static void folders_are_the_compilers(void **state)
{
    (void)state;
    bool has_libc = false, has_own = false;
    for (const char *const *f = compiler_system_folders(); *f; f++) {
        assert_true((*f)[0] == '/');
        has_libc |= strcmp(*f, "/usr/include") == 0;
        has_own |= strncmp(*f, "/usr/lib/gcc/", 13) == 0;
    }
    assert_true(has_libc && has_own);
}

/* The four that gcc 14 refuses by itself, whatever the compiler; and what it must not refuse. */
static void the_language_is_the_same_everywhere(void **state)
{
    (void)state;
    static const char *const refused[] = {
        "int f(void) { return g(); }", "f(void) { return 1; }", "int *f(int x) { return x; }",
        "struct pair { int a, b; }; int *f(struct pair *p) { return p; }",
        "int by(int *a, int *b); void qs(int (*)(const void *, const void *)); void f(void) "
        "{ qs(by); }"};
    static const char *const taken[] = {"void f(void) { return 1; }",
                                        "int f(void) { return; }",
                                        "int f(x); int g(x) int x; "
                                        "{ return x; }",
                                        "char *f(const char *s) { return s; }",
                                        "unsigned *f(int *x) { return x; }",
                                        "int f(int x) { if (x) return 1; }"};
    static const char *const compilers[] = {"gcc",    "gcc-11", "gcc-12",
                                            "gcc-13", "gcc-14", "gcc-15"};
    char command[400];
    for (size_t c = 0; c < sizeof compilers / sizeof compilers[0]; c++) {
        const char *liberties = c == 0  ? compiler_liberties()
                                : c < 4 ? ""
                                        : "-Wno-return-mismatch "
                                          "-Wno-declaration-missing-parameter-type";
        snprintf(command, sizeof command, "command -v %s >/dev/null", compilers[c]);
        if (system(command) != 0)
            continue;
        for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
            preprocessed_write("main.c", refused[i]);
            snprintf(command, sizeof command,
                     "cd %s && %s " COMPILER_LANGUAGE " %s -c main.c -o /dev/null 2>/dev/null",
                     preprocessed_folder, compilers[c], liberties);
            assert_int_not_equal(system(command), 0);
        }
        for (size_t i = 0; i < sizeof taken / sizeof taken[0]; i++) {
            preprocessed_write("main.c", taken[i]);
            if (system(command) != 0)
                print_error("%s refuses %s\n", compilers[c], taken[i]);
            assert_int_equal(system(command), 0);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_header_of_libc_passes),
        cmocka_unit_test(headers_behind_links_keep_their_place),
        cmocka_unit_test(folders_are_the_compilers),
        cmocka_unit_test(the_language_is_the_same_everywhere),
    };
    return cmocka_run_group_tests(tests, preprocessed_set_up, preprocessed_tear_down);
}
