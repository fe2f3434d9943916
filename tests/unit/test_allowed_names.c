/* The names that a submission may use of libc: the list against libc itself. */
#include "graders/engine/build/names.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SYMBOLS_MOST = 60000, NAME_BYTES = 64 };

/* A name that an archive of libc defines, and where. */
struct symbol {
    int member;
    unsigned long long address;
    char kind, name[NAME_BYTES];
};

static struct symbol symbols[SYMBOLS_MOST];
static int symbol_count;

static int compare_names(const void *a, const void *b)
{
    return strcmp(((const struct symbol *)a)->name, ((const struct symbol *)b)->name);
}

static int compare_places(const void *a, const void *b)
{
    const struct symbol *x = a, *y = b;
    if (x->member != y->member)
        return x->member < y->member ? -1 : 1;
    return x->address < y->address ? -1 : x->address > y->address;
}

/* All that the static libraries define, which the linker would find. */
static int read_symbols(void **state)
{
    (void)state;
    static const char command[] =
        "for name in libc.a libm.a libgcc.a; do path=$(gcc -print-file-name=$name)\n"
        "for path in $(sed -n '/^GROUP/s/[^/]*\\(\\/[^ ]*\\)/ \\1/gp' $path | grep -o '/[^ )]*' ||"
        " echo $path); do nm --defined-only -g $path 2>/dev/null; done; done";
    char line[1024];
    FILE *nm = popen(command, "r");
    assert_non_null(nm);
    for (int member = 0; fgets(line, sizeof line, nm);) {
        struct symbol *s = &symbols[symbol_count];
        if (sscanf(line, "%llx %c %63s", &s->address, &s->kind, s->name) == 3) {
            s->member = member;
            symbol_count++;
        } else {
            member++;
        }
        assert_in_range(symbol_count, 0, SYMBOLS_MOST - 1);
    }
    pclose(nm);
    return symbol_count > 3000 ? 0 : -1;
}

/* By its own name: libc's inner names are refused whatever they are names of. */
static bool is_refused_function(const struct symbol *symbol)
{
    return strchr("TWi", symbol->kind) && symbol->name[0] != '_' && name_is_forbidden(symbol->name);
}

/* An alias of a refused function is refused, whatever it is called: here is each that libc has. */
static void no_refused_function_has_a_name_that_is_allowed(void **state)
{
    (void)state;
    int refused = 0, wrong = 0;
    qsort(symbols, (size_t)symbol_count, sizeof *symbols, compare_places);
    for (int i = 0, next; i < symbol_count; i = next) {
        const char *forbidden = NULL;
        for (next = i; next < symbol_count && compare_places(&symbols[i], &symbols[next]) == 0;)
            if (is_refused_function(&symbols[next++]))
                forbidden = symbols[next - 1].name;
        refused += forbidden != NULL;
        for (int k = i; forbidden && k < next; k++)
            if (strchr("TWi", symbols[k].kind) && name_is_allowed(symbols[k].name)) {
                print_error("%s is %s\n", symbols[k].name, forbidden);
                wrong++;
            }
    }
    assert_int_equal(wrong, 0);
    assert_true(refused > 50);
}

/* A name with a slip of the pen would refuse a right program. */
static void every_name_on_the_list_is_in_libc(void **state)
{
    (void)state;
    static const char newer[] = " strlcat strlcpy c8rtomb mbrtoc8 fmaximum fmaximum_num fminimum "
                                "fminimum_num __memcmpeq arc4random arc4random_buf "
                                "arc4random_uniform pow10 getw __tls_get_addr ";
    int wrong = 0;
    qsort(symbols, (size_t)symbol_count, sizeof *symbols, compare_names);
    for (const struct name_group *group = name_groups; group->header; group++) {
        char words[4096], *rest = words;
        snprintf(words, sizeof words, "%s", group->names);
        for (char *word; (word = strsep(&rest, " "));) {
            char spaced[NAME_BYTES + 2];
            struct symbol wanted = {.name = ""};
            snprintf(spaced, sizeof spaced, " %.61s ", word);
            snprintf(wanted.name, sizeof wanted.name, "%s", word);
            const bool is_found = bsearch(&wanted, symbols, (size_t)symbol_count, sizeof *symbols,
                                          compare_names) != NULL;
            if (is_found || strstr(newer, spaced) || strcmp(word, "_GLOBAL_OFFSET_TABLE_") == 0)
                continue;
            print_error("%s: %s is not in libc\n", group->header, word);
            wrong++;
        }
    }
    assert_int_equal(wrong, 0);
}

static void names_are_told_apart(void **state)
{
    (void)state;
    static const char *const allowed[] = {"sin",
                                          "sinf",
                                          "sinl",
                                          "sqrtf128",
                                          "lgamma_r",
                                          "memcpy",
                                          "__memcpy_chk",
                                          "__printf_chk",
                                          "__longjmp_chk",
                                          "__isoc99_sscanf",
                                          "fopen64",
                                          "__errno_location",
                                          "__divti3",
                                          "qsort_r",
                                          "tsearch",
                                          "__sigsetjmp",
                                          "__isoc23_strtol",
                                          "stdout",
                                          "open_memstream",
                                          "socket"};
    static const char *const not_allowed[] = {"",
                                              "s",
                                              "sinx",
                                              "sinfl",
                                              "mmap64",
                                              "__mmap_chk",
                                              "__isoc99_",
                                              "__chk",
                                              "___chk",
                                              "64",
                                              "sin cos",
                                              " ",
                                              "end",
                                              "__bss_start",
                                              "run_call",
                                              "qsort ",
                                              "printff",
                                              "__isoc99_mmap",
                                              "main",
                                              "_IO_2_1_stdout_",
                                              "__asan_init",
                                              "malloc_hook",
                                              "__errno_locatio"};
    static const char *const forbidden[] = {
        "__malloc",         "__libc_malloc", "__splitstack_makecontext",
        "__getcontext",     "__mremap",      "mremap",
        "__pthread_create", "__mmap",        "prctl",
        "execvpe",          "__wrap_free",   "__real_malloc",
        "environ",          "__environ",     "clone"};
    for (size_t i = 0; i < sizeof allowed / sizeof *allowed; i++)
        assert_true(name_is_allowed(allowed[i]));
    for (size_t i = 0; i < sizeof not_allowed / sizeof *not_allowed; i++)
        assert_false(name_is_allowed(not_allowed[i]));
    for (size_t i = 0; i < sizeof forbidden / sizeof *forbidden; i++) {
        assert_false(name_is_allowed(forbidden[i]));
        assert_true(name_is_forbidden(forbidden[i]));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_are_told_apart),
        cmocka_unit_test(no_refused_function_has_a_name_that_is_allowed),
        cmocka_unit_test(every_name_on_the_list_is_in_libc),
    };
    return cmocka_run_group_tests(tests, read_symbols, NULL);
}
