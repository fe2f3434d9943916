/* What honest programs do and the box must let them: one an argument. Each returns 0 when all went
 * well, and a number that names the failed step else. */
#include <assert.h>
#include <ctype.h>
#include <errno.h>
#include <locale.h>
#include <math.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#include <wchar.h>

static int allocate(void)
{
    /* below and above the size from which malloc maps memory, growing and shrinking by realloc */
    for (size_t bytes = 1; bytes < (size_t)20 << 20; bytes = bytes * 3 + 1) {
        unsigned char *block = malloc(bytes);
        if (!block)
            return 1;
        memset(block, 7, bytes);
        unsigned char *larger = realloc(block, bytes * 2);
        if (!larger || larger[bytes - 1] != 7)
            return 2;
        unsigned char *smaller = realloc(larger, bytes / 2 + 1);
        if (!smaller || smaller[bytes / 2] != 7)
            return 3;
        free(smaller);
    }
    void *aligned = NULL;
    if (posix_memalign(&aligned, 4096, 100000))
        return 4;
    free(aligned);
    int *zeros = calloc(1000000, sizeof *zeros);
    if (!zeros || zeros[999999])
        return 5;
    free(zeros);
    /* many small blocks, so that the heap grows and shrinks */
    enum { COUNT = 100000 };
    char **blocks = calloc(COUNT, sizeof *blocks);
    for (size_t i = 0; blocks && i < COUNT; i++)
        if (!(blocks[i] = malloc(100)))
            return 6;
    for (size_t i = 0; blocks && i < COUNT; i++)
        free(blocks[i]);
    free(blocks);
    return blocks ? 0 : 7;
}

static int compare(const void *a, const void *b)
{
    uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

static int sort(void)
{
    size_t count = 1000000;
    uint32_t *numbers = malloc(count * sizeof *numbers);
    if (!numbers)
        return 1;
    for (size_t i = 0; i < count; i++)
        numbers[i] = (uint32_t)i * 2654435761u;
    qsort(numbers, count, sizeof *numbers, compare);
    for (size_t i = 1; i < count; i++)
        if (numbers[i - 1] > numbers[i])
            return 2;
    free(numbers);
    return 0;
}

static int print(void)
{
    for (int i = 0; i < 2000; i++)
        if (printf("%d %.3f %s\n", i, sqrt(i), "text") < 0)
            return 1;
    errno = ENOMEM;
    perror("first words on stderr"); /* duplicates the descriptor */
    if (fprintf(stderr, "to stderr\n") < 0 || fflush(stdout))
        return 2;
    static char buffer[1 << 16];
    if (setvbuf(stderr, buffer, _IOFBF, sizeof buffer) || fputs("buffered\n", stderr) < 0)
        return 3;
    return getchar() == EOF ? 0 : 4;
}

static int locales(void)
{
    /* None is there; asking must not be held against anyone. */
    setlocale(LC_ALL, "");
    setlocale(LC_ALL, "en_US.UTF-8");
    setlocale(LC_ALL, "es_ES.ISO-8859-1");
    setlocale(LC_NUMERIC, "de_DE");
    wchar_t wide[10];
    mbstowcs(wide, "abc", 10);
    if (!setlocale(LC_ALL, "C") || toupper('a') != 'A')
        return 1;
    time_t now = time(NULL);
    struct tm *local = localtime(&now); /* looks for the time zone */
    char text[100];
    return local && strftime(text, sizeof text, "%Y-%m-%d", local) ? 0 : 2;
}

static int times(void)
{
    clock_t start = clock();
    time_t now = time(NULL);
    struct timespec precise;
    if (start == (clock_t)-1 || now == (time_t)-1 || clock_gettime(CLOCK_MONOTONIC, &precise))
        return 1;
    if (nanosleep(&(struct timespec){.tv_nsec = 1000}, NULL))
        return 2;
    srand((unsigned)now);
    return rand() >= 0 ? 0 : 3;
}

static volatile sig_atomic_t caught;

static void on_signal(int number)
{
    caught = number;
}

static int signals(void)
{
    if (signal(SIGFPE, on_signal) == SIG_ERR || signal(SIGABRT, on_signal) == SIG_ERR)
        return 1;
    raise(SIGABRT);
    return caught == SIGABRT ? 0 : 2;
}

static int fail_assertion(void)
{
    assert(errno == 12345);
    return 1;
}

static int corrupt_heap(void)
{
    char *block = malloc(100);
    free(block + 16); /* glibc says so on stderr and aborts */
    return 1;
}

static volatile unsigned large = 200;

static int smash_stack(void)
{
    volatile char block[16];
    for (unsigned i = 0; i < large; i++)
        block[i] = 1; /* the canary: "stack smashing detected", abort */
    return block[1];
}

static int stdio_files(void)
{
    if (fileno(stdout) != 1 || ftell(stdout) < 0)
        return 1;
    return isatty(1) ? 2 : 0;
}

/* Answers on descriptor 5 what it reads on 4, and may neither write nor grow 4. */
static int descriptors(void)
{
    char text[16] = "";
    if (read(4, text, 5) != 5 || strcmp(text, "input") != 0)
        return 1;
    if (pwrite(4, "x", 1, 0) >= 0)
        return 2;
    return write(5, "answer", 6) == 6 && write(3, "control", 7) == 7 ? 0 : 3;
}

/* Holds 16 MiB, says so on descriptor 3, and waits. */
static int hold(void)
{
    size_t bytes = 16 << 20;
    volatile char *block = malloc(bytes);
    for (size_t i = 0; block && i < bytes; i += 4096)
        block[i] = 1;
    if (!block || write(3, "held", 4) != 4)
        return 1;
    nanosleep(&(struct timespec){.tv_sec = 1000}, NULL);
    return 2;
}

static int nothing(void)
{
    return 0;
}

static const struct {
    const char *name;
    int (*run)(void);
} controls[] = {
    {"nothing", nothing},
    {"allocate", allocate},
    {"sort", sort},
    {"print", print},
    {"locales", locales},
    {"times", times},
    {"signals", signals},
    {"stdio-files", stdio_files},
    {"assert", fail_assertion},
    {"corrupt-heap", corrupt_heap},
    {"smash-stack", smash_stack},
    {"descriptors", descriptors},
    {"hold", hold},
};

int main(int argc, char **argv)
{
    for (size_t i = 0; argc > 1 && i < sizeof controls / sizeof controls[0]; i++)
        if (strcmp(argv[1], controls[i].name) == 0)
            return controls[i].run();
    return 98;
}
