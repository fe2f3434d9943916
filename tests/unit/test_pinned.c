/* Libc's functions where work is counted: those that callgrind names are the pinned ones. */
#include "graders/engine/run/series.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

/* Of memory, strings and mathematics, so long that none is worth a shortcut. */
static const char program[] =
    "#define _GNU_SOURCE\n#include <math.h>\n#include <stdlib.h>\n#include <string.h>\n"
    "#include <strings.h>\n#include <wchar.h>\n"
    "static char a[9000], b[9000]; volatile int n = 8000; volatile size_t sink;\n"
    "volatile double x = 0.7;\n"
    "int main(void) { memset(a, 'x', n); memcpy(b, a, n); memmove(a + 1, a, n); mempcpy(b, a, n);\n"
    "sink += strlen(a) + memcmp(a, b, n) + (size_t)memchr(a, 'q', n) + strcmp(a, b);\n"
    "strcpy(b, a); stpcpy(b, a); strncpy(b, a, 100); strcat(b, \"z\"); sink += strnlen(a, n);\n"
    "sink += strncmp(a, b, 100) + (size_t)strchr(a, 'q') + (size_t)strrchr(a, 'q');\n"
    "sink += strspn(a, \"xy\") + strcspn(a, \"q\") + (size_t)strstr(a, \"xq\") + strcasecmp(a, "
    "b);\n"
    "sink += (size_t)memrchr(a, 'q', n) + (size_t)rawmemchr(a, 0);\n"
    "wchar_t w[50]; wmemset(w, L'x', 49); w[49] = 0; sink += wcslen(w);\n"
    "x += sin(x) + cos(x) + tan(x) + atan2(x, 2) + exp(x) + log(x) + pow(x, x) + fma(x, x, x);\n"
    "x += floor(x) + rint(x) + sinf(x) + expf(x) + exp2f(x); return 0; }\n";

static const char *const unpinned[] = {"_avx", "_evex", "_ssse3", "_fma", "_erms", NULL};

static char folder[] = "/tmp/test_pinned.XXXXXX";

static void run_counted(void)
{
    char command[1024], path[64];
    snprintf(path, sizeof path, "%s/p.c", folder);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_true(fputs(program, file) >= 0);
    assert_int_equal(fclose(file), 0);
    snprintf(command, sizeof command,
             "cd %s && gcc -w -fno-builtin -static p.c -lm -o p && %s valgrind -q "
             "--tool=callgrind --callgrind-out-file=counts ./p",
             folder, SERIES_PINNED_FUNCTIONS);
    assert_int_equal(system(command), 0);
}

static void the_functions_counted_are_the_pinned_ones(void **state)
{
    (void)state;
    char line[512], path[64];
    int pinned = 0, wrong = 0;
    bool has_copy = false, has_move = false;
    if (access("/usr/bin/valgrind", X_OK) != 0)
        skip();
    run_counted();
    snprintf(path, sizeof path, "%s/counts", folder);
    FILE *counts = fopen(path, "r");
    assert_non_null(counts);
    while (fgets(line, sizeof line, counts)) {
        const char *name = strncmp(line, "fn=(", 4) == 0 || strncmp(line, "cfn=(", 5) == 0
                               ? strstr(line, ") ")
                               : NULL;
        if (!name || strstr(name, "init") || strstr(name, "select") || strstr(name, "cpu"))
            continue;
        const bool is_pinned = strstr(name, "_sse") != NULL;
        pinned += is_pinned;
        has_copy |= strstr(name, "memcpy_sse2") != NULL; /* memmove's has that name, too */
        has_move |= strstr(name, "mem") != NULL && strstr(name, "_sse2_unaligned") != NULL;
        for (const char *const *kind = unpinned; *kind; kind++)
            if (!is_pinned && strstr(name, *kind)) {
                print_error("counted: %s", name + 2);
                wrong++;
            }
    }
    fclose(counts);
    assert_int_equal(wrong, 0);
    assert_true(has_copy);
    assert_true(has_move);
    assert_true(pinned > 15);
}

static int set_up(void **state)
{
    (void)state;
    return mkdtemp(folder) ? 0 : -1;
}

static int tear_down(void **state)
{
    (void)state;
    char command[64];
    snprintf(command, sizeof command, "rm -r %s", folder);
    return system(command);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_functions_counted_are_the_pinned_ones)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
