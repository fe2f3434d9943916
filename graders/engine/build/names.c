/* The names that a submission may use; see names.h. */
#include "graders/engine/build/names.h"

#include <string.h>

const struct name_group name_groups[] = {
    /* C17, with what POSIX and GNU add to the same headers */
    {"<assert.h>", false, "__assert_fail __assert_perror_fail __assert"},
    {"<complex.h>", true,
     "cabs cacos cacosh carg casin casinh catan catanh ccos ccosh cexp cimag clog clog10 conj cpow "
     "cproj creal csin csinh csqrt ctan ctanh"},
    {"<ctype.h>", false,
     "isalnum isalpha isascii isblank iscntrl isdigit isgraph islower isprint ispunct isspace "
     "isupper isxdigit toascii tolower toupper __ctype_b_loc __ctype_tolower_loc "
     "__ctype_toupper_loc __ctype_get_mb_cur_max"},
    {"<errno.h>", false, "__errno_location program_invocation_name program_invocation_short_name"},
    {"<fenv.h>", false,
     "feclearexcept fedisableexcept feenableexcept fegetenv fegetexcept fegetexceptflag fegetmode "
     "fegetround feholdexcept feraiseexcept fesetenv fesetexcept fesetexceptflag fesetmode "
     "fesetround fetestexcept fetestexceptflag feupdateenv"},
    {"<inttypes.h>", false,
     "imaxabs imaxdiv strtoimax strtoumax wcstoimax wcstoumax __strtol_internal "
     "__strtoul_internal __wcstol_internal __wcstoul_internal"},
    {"<locale.h>", false, "duplocale freelocale localeconv newlocale setlocale uselocale"},
    {"<math.h>", true,
     "acos acosh asin asinh atan atan2 atanh canonicalize cbrt ceil copysign cos cosh drem erf "
     "erfc exp exp10 exp2 expm1 fabs fdim floor fma fmax fmaximum fmaximum_num fmaxmag fmin "
     "fminimum fminimum_num fminmag fmod frexp fromfp gamma hypot ilogb j0 j1 jn ldexp lgamma "
     "llogb llrint llround log log10 log1p log2 logb lrint lround modf nan nearbyint nextafter "
     "nextdown nexttoward nextup pow pow10 remainder remquo rint round roundeven scalb scalbln "
     "scalbn significand sin sincos sinh sqrt tan tanh tgamma totalorder trunc ufromfp y0 y1 yn "
     "finite isinf isnan __finite __fpclassify __isinf __isnan __iseqsig __issignaling __signbit"},
    {"<math.h>", false,
     "lgamma_r lgammaf_r lgammal_r signgam fadd faddl fdiv fdivl fmul fmull fsub fsubl ffma fsqrt "
     "daddl ddivl dmull dsubl dfmal dsqrtl __iscanonicall"},
    {"<setjmp.h>", false, "setjmp _setjmp __sigsetjmp longjmp _longjmp siglongjmp"},
    {"<signal.h>", false,
     "alarm kill killpg pause psignal psiginfo raise sigaction sigaddset sigaltstack sigdelset "
     "sigemptyset sigfillset sigismember signal sigpending sigprocmask sigqueue sigsuspend "
     "sigtimedwait sigwait sigwaitinfo pthread_sigmask __libc_current_sigrtmin "
     "__libc_current_sigrtmax sigabbrev_np sigdescr_np"},
    {"<stdio.h>", false,
     "asprintf clearerr dprintf fclose fdopen feof ferror fflush fgetc fgetpos fgets fileno "
     "flockfile fmemopen fopen fprintf fputc fputs fread freopen fscanf fseek fseeko fsetpos ftell "
     "ftello ftrylockfile funlockfile fwrite getc getchar getdelim getline gets getw "
     "open_memstream perror printf putc putchar puts putw remove rename renameat rewind scanf "
     "setbuf setbuffer setlinebuf setvbuf snprintf sprintf sscanf tempnam tmpfile tmpnam tmpnam_r "
     "ungetc vasprintf vdprintf vfprintf vfscanf vprintf vscanf vsnprintf vsprintf vsscanf stdin "
     "stdout stderr clearerr_unlocked feof_unlocked ferror_unlocked fflush_unlocked fgetc_unlocked "
     "fgets_unlocked fileno_unlocked fputc_unlocked fputs_unlocked fread_unlocked fwrite_unlocked "
     "getc_unlocked getchar_unlocked putc_unlocked putchar_unlocked __getdelim __uflow __overflow "
     "__asprintf"},
    {"<stdlib.h>", false,
     "_Exit a64l abort abs aligned_alloc arc4random arc4random_buf arc4random_uniform "
     "at_quick_exit atexit atof atoi atol atoll bsearch calloc div drand48 drand48_r ecvt ecvt_r "
     "erand48 erand48_r exit fcvt fcvt_r free gcvt getenv getsubopt initstate initstate_r jrand48 "
     "jrand48_r l64a labs lcong48 lcong48_r ldiv llabs lldiv lrand48 lrand48_r malloc mblen "
     "mbstowcs mbtowc mkdtemp mkostemp mkstemp mktemp mrand48 mrand48_r nrand48 nrand48_r on_exit "
     "posix_memalign putenv qsort qsort_r quick_exit rand rand_r random random_r realloc "
     "reallocarray realpath secure_getenv seed48 seed48_r setenv setstate setstate_r srand srand48 "
     "srand48_r srandom srandom_r strfromd strfromf strfroml strtod strtof strtol strtold strtoll "
     "strtoul strtoull unsetenv valloc wcstombs wctomb"},
    {"<string.h>", false,
     "bcmp bcopy bzero explicit_bzero ffs ffsl ffsll index memccpy memchr memcmp memcpy memfrob "
     "memmem memmove mempcpy memrchr memset rawmemchr rindex stpcpy stpncpy strcasecmp strcasestr "
     "strcat strchr strchrnul strcmp strcoll strcpy strcspn strdup strerror strerror_r "
     "strerrordesc_np strerrorname_np strfry strlcat strlcpy strlen strncasecmp strncat strncmp "
     "strncpy strndup strnlen strpbrk strrchr strsep strsignal strspn strstr strtok strtok_r "
     "strverscmp strxfrm basename __memcmpeq __mempcpy __stpcpy __stpncpy __strdup __strndup "
     "__strtok_r __xpg_strerror_r __rawmemchr"},
    {"<threads.h>", false,
     "call_once cnd_broadcast cnd_destroy cnd_init cnd_signal cnd_timedwait cnd_wait mtx_destroy "
     "mtx_init mtx_lock mtx_timedlock mtx_trylock mtx_unlock thrd_current thrd_equal thrd_exit "
     "thrd_sleep thrd_yield tss_create tss_delete tss_get tss_set"},
    {"<time.h>", false,
     "asctime asctime_r clock clock_getres clock_gettime clock_nanosleep clock_settime ctime "
     "ctime_r daylight difftime getdate getdate_err gmtime gmtime_r localtime localtime_r mktime "
     "nanosleep strftime strptime time timegm timelocal timer_create timer_delete timer_gettime "
     "timer_settime timespec_get timespec_getres timezone tzname tzset __timezone __tzname"},
    {"<uchar.h>", false, "c16rtomb c32rtomb c8rtomb mbrtoc16 mbrtoc32 mbrtoc8"},
    {"<wchar.h>", false,
     "btowc fgetwc fgetws fputwc fputws fwide fwprintf fwscanf getwc getwchar mbrlen mbrtowc "
     "mbsinit mbsnrtowcs mbsrtowcs open_wmemstream putwc putwchar swprintf swscanf ungetwc "
     "vfwprintf vfwscanf vswprintf vswscanf vwprintf vwscanf wcpcpy wcpncpy wcrtomb wcscasecmp "
     "wcscat wcschr wcschrnul wcscmp wcscoll wcscpy wcscspn wcsdup wcsftime wcslen wcsncasecmp "
     "wcsncat wcsncmp wcsncpy wcsnlen wcsnrtombs wcspbrk wcsrchr wcsrtombs wcsspn wcsstr wcstod "
     "wcstof wcstok wcstol wcstold wcstoll wcstoul wcstoull wcswidth wcsxfrm wctob wcwidth wmemchr "
     "wmemcmp wmemcpy wmemmove wmempcpy wmemset wprintf wscanf __mbrlen"},
    {"<wctype.h>", false,
     "iswalnum iswalpha iswblank iswcntrl iswctype iswdigit iswgraph iswlower iswprint iswpunct "
     "iswspace iswupper iswxdigit towctrans towlower towupper wctrans wctype"},

    /* Headers of their own of POSIX and GNU */
    {"<search.h>", false,
     "hcreate hcreate_r hdestroy hdestroy_r hsearch hsearch_r insque lfind lsearch remque tdelete "
     "tdestroy tfind tsearch twalk twalk_r"},
    {"<malloc.h>", false, "memalign malloc_usable_size"},
    {"<obstack.h>", false,
     "_obstack_begin _obstack_begin_1 _obstack_newchunk _obstack_free _obstack_allocated_p "
     "_obstack_memory_used obstack_free obstack_alloc_failed_handler obstack_printf "
     "obstack_vprintf obstack_exit_failure"},
    {"<regex.h>", false, "regcomp regerror regexec regfree"},
    {"<fnmatch.h>", false, "fnmatch"},
    {"<libgen.h>", false, "dirname __xpg_basename"},
    {"<langinfo.h>", false, "nl_langinfo"},
    {"<getopt.h>", false, "getopt getopt_long optarg opterr optind optopt __posix_getopt"},
    {"<err.h>", false, "err errx verr verrx vwarn vwarnx warn warnx error"},
    {"<sys/random.h>", false, "getentropy getrandom"},
    {"<pthread.h>", false,
     "pthread_cond_broadcast pthread_cond_destroy pthread_cond_init pthread_cond_signal "
     "pthread_cond_timedwait pthread_cond_wait pthread_equal pthread_exit pthread_getspecific "
     "pthread_key_create pthread_key_delete pthread_mutex_destroy pthread_mutex_init "
     "pthread_mutex_lock pthread_mutex_timedlock pthread_mutex_trylock pthread_mutex_unlock "
     "pthread_mutexattr_destroy pthread_mutexattr_init pthread_mutexattr_settype pthread_once "
     "pthread_rwlock_destroy pthread_rwlock_init pthread_rwlock_rdlock pthread_rwlock_tryrdlock "
     "pthread_rwlock_trywrlock pthread_rwlock_unlock pthread_rwlock_wrlock pthread_self "
     "pthread_setspecific pthread_spin_destroy pthread_spin_init pthread_spin_lock "
     "pthread_spin_trylock pthread_spin_unlock sched_yield sched_getcpu"},

    /* What reaches out of the process: for the box to refuse by name */
    {"<unistd.h>", false,
     "_exit access chdir chown close confstr creat daemon dup dup2 faccessat fchdir fchown fcntl "
     "fdatasync fork fpathconf fsync ftruncate getcwd getegid geteuid getgid gethostname getlogin "
     "getpagesize getpgid getpgrp getpid getppid getsid getuid getwd ioctl isatty lchown link "
     "linkat lockf lseek nice open openat pathconf pipe poll pread pwrite read readlink readlinkat "
     "readv rmdir select pselect setegid seteuid setgid setpgid setregid setreuid setsid setuid "
     "sleep swab symlink symlinkat sync sysconf tcgetattr tcsetattr truncate ttyname umask unlink "
     "unlinkat usleep vfork wait waitpid waitid write writev __open_2 __open64_2 __openat_2"},
    {"<sys/stat.h>", false,
     "chmod fchmod fstat fstatat lstat mkdir mkdirat mkfifo mknod stat utime utimes"},
    {"<sys/socket.h>", false,
     "accept bind connect getpeername getsockname getsockopt listen recv recvfrom recvmsg send "
     "sendmsg sendto setsockopt shutdown socket socketpair"},
    {"<sys/resource.h>", false,
     "getpriority getrlimit getrusage setpriority setrlimit times getitimer setitimer gettimeofday "
     "settimeofday uname"},
    {"<sys/shm.h>", false, "shmget shmat shmdt shmctl semget semop msgget shm_open shm_unlink"},
    {"<dirent.h>", false, "closedir fdopendir opendir readdir rewinddir scandir alphasort"},
    {"<sched.h>", false, "sched_getscheduler sched_setscheduler sched_getparam sched_setparam"},
    {"<syslog.h>", false, "openlog syslog closelog"},

    /* Of no header */
    {"what the compiler calls", false,
     "_GLOBAL_OFFSET_TABLE_ __tls_get_addr __stack_chk_fail __fdelt_chk __addtf3 __subtf3 __multf3 "
     "__divtf3 __negtf2 __eqtf2 __netf2 __lttf2 __letf2 __gttf2 __getf2 __unordtf2 __extendsftf2 "
     "__extenddftf2 __extendxftf2 __trunctfsf2 __trunctfdf2 __trunctfxf2 __fixtfsi __fixtfdi "
     "__fixtfti __fixunstfsi __fixunstfdi __fixunstfti __floatsitf __floatditf __floattitf "
     "__floatunsitf __floatunditf __floatuntitf __extendhfsf2 __extendhfdf2 __extendhfxf2 "
     "__extendhftf2 __truncsfhf2 __truncdfhf2 __truncxfhf2 __trunctfhf2 __eqhf2 __nehf2 __fixsfti "
     "__fixdfti __fixxfti __fixunssfdi __fixunsdfdi __fixunsxfdi __fixunssfti __fixunsdfti "
     "__fixunsxfti __floattisf __floattidf __floattixf __floatuntisf __floatuntidf __floatuntixf "
     "__divti3 __modti3 __udivti3 __umodti3 __divmodti4 __udivmodti4 __multi3 __ashlti3 __ashrti3 "
     "__lshrti3 __cmpti2 __ucmpti2 __negti2 __clzdi2 __clzti2 __ctzdi2 __ctzti2 __ffsdi2 __ffsti2 "
     "__clrsbdi2 __clrsbti2 __popcountdi2 __popcountti2 __paritydi2 __parityti2 __bswapsi2 "
     "__bswapdi2 __mulvsi3 __mulvdi3 __mulvti3 __addvsi3 __addvdi3 __addvti3 __subvsi3 __subvdi3 "
     "__subvti3 __powisf2 __powidf2 __powixf2 __powitf2 __mulsc3 __muldc3 __mulxc3 __multc3 "
     "__divsc3 __divdc3 __divxc3 __divtc3"},
    {0}};

/* Known, and not for here. Only for the words of a refusal: a name in no list is refused, too. */
static const char forbidden[] =
    "mmap mmap64 munmap mremap mprotect pkey_mprotect madvise brk sbrk syscall dlopen dlmopen "
    "dlsym dlvsym dladdr dl_iterate_phdr environ __environ _environ getcontext setcontext "
    "__getcontext __setcontext __makecontext __swapcontext "
    "makecontext swapcontext __getcontext __setcontext __makecontext __swapcontext pthread_create "
    "pthread_cancel pthread_kill thrd_create thrd_join "
    "pthread_join pthread_detach clone clone3 fexecve execl execle execlp execv execve execveat "
    "execvp execvpe posix_spawn posix_spawnp system popen pclose wordexp pvalloc mallopt mallinfo "
    "mallinfo2 malloc_trim malloc_stats malloc_info ptrace prctl unshare setns mount umount "
    "umount2 "
    "pivot_root chroot personality process_vm_readv process_vm_writev memfd_create reboot acct "
    "swapon swapoff iopl ioperm tgkill sched_setaffinity sched_getaffinity perf_event_open "
    "process_madvise userfaultfd quotactl sethostname vhangup profil _start _init _fini main";

static const char *const forbidden_prefixes[] = {
    "__wrap_",     "__real_",    "__libc_",   "__malloc", "__free_hook",   "__realloc",
    "__calloc",    "__morecore", "__mmap",    "__munmap", "__mremap",      "__mprotect",
    "__sbrk",      "__brk",      "__syscall", "__clone",  "__pthread_",    "__splitstack_",
    "__morestack", "_dl_",       "__dl_",     "__exec",   "__posix_spawn", NULL};

static const char *const type_suffixes[] = {"",     "f",    "l",    "f32", "f64",
                                            "f32x", "f64x", "f128", NULL};

/* Is it one of the words of `names`, to the letter? */
static bool has_word(const char *names, const char *word, size_t length)
{
    for (const char *at = names; *at;) {
        size_t count = strcspn(at, " ");
        if (count == length && memcmp(at, word, length) == 0)
            return true;
        at += count + (at[count] == ' ');
    }
    return false;
}

static bool ends(const char *name, size_t length, const char *suffix)
{
    size_t count = strlen(suffix);
    return length > count && memcmp(name + length - count, suffix, count) == 0;
}

static bool is_of_group(const struct name_group *group, const char *name, size_t length)
{
    if (!group->by_type)
        return has_word(group->names, name, length);
    for (const char *const *suffix = type_suffixes; *suffix; suffix++)
        if (ends(name, length, *suffix) && has_word(group->names, name, length - strlen(*suffix)))
            return true;
    return false;
}

static bool is_listed(const char *name, size_t length)
{
    for (const struct name_group *group = name_groups; group->header; group++)
        if (is_of_group(group, name, length))
            return true;
    return false;
}

bool name_is_allowed(const char *name)
{
    size_t length = strlen(name);
    if (is_listed(name, length))
        return true;
    if (ends(name, length, "64") && is_listed(name, length - 2))
        return true;
    if (strncmp(name, "__isoc99_", 9) == 0 || strncmp(name, "__isoc23_", 9) == 0)
        return is_listed(name + 9, length - 9);
    return strncmp(name, "__", 2) == 0 && ends(name + 2, length - 2, "_chk") &&
           is_listed(name + 2, length - 6);
}

bool name_is_forbidden(const char *name)
{
    for (const char *const *prefix = forbidden_prefixes; *prefix; prefix++)
        if (strncmp(name, *prefix, strlen(*prefix)) == 0)
            return true;
    return has_word(forbidden, name, strlen(name));
}
