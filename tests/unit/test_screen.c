/* The screen of object files: real ones from gcc, then damaged ones. */
#include "graders/engine/build/instruction.h"
#include "graders/engine/build/screen.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

enum { OBJECT_BYTES = 4 << 20 };

static const char *const functions[] = {"edge_table_any", NULL};
static const char *const given[] = {"row_of_edge", "execute_query", NULL};
static const char *const giving[] = {"row_of_edge", "execute_query", "use", "mesh_vertex", NULL};
static const struct screen_rules rules = {functions, given, 1 << 20, false};
static const struct screen_rules sanitized_rules = {functions, giving, 1 << 20, true};
static const struct screen_rules giving_rules = {functions, giving, 1 << 20, false};

/* A right one; tests append to it. */
#define RIGHT                                                                                      \
    "#include <stdlib.h>\n#include <string.h>\n#include <stdio.h>\n#include <math.h>\n"            \
    "struct edge { int a, b; };\n"                                                                 \
    "static int by_ends(const void *x, const void *y) { return memcmp(x, y, 8); }\n"               \
    "struct edge *edge_table_any(const int *t, int count, int *edges) {\n"                         \
    "  struct edge *e = malloc(24 * (size_t)count); if (!e) return 0;\n"                           \
    "  for (int i = 0; i < 3 * count; i++) e[i] = (struct edge){t[i], t[i] ^ 1};\n"                \
    "  qsort(e, 3 * (size_t)count, sizeof *e, by_ends); *edges = 3 * count;\n"                     \
    "  fflush(stderr); *edges += (int)sqrt(count); return e; }\n"

struct bytes {
    unsigned char *at;
    size_t count;
};

/* What gcc makes of `source`. */
static struct bytes compile(const char *source, const char *flags)
{
    char folder[] = "/tmp/test_screen.XXXXXX", command[512], path[64];
    assert_non_null(mkdtemp(folder));
    snprintf(command, sizeof command, "gcc -std=gnu17 -O2 -w %s -c -x c - -o %s/o.o", flags,
             folder);
    FILE *compiler = popen(command, "w");
    assert_non_null(compiler);
    assert_true(fputs(source, compiler) >= 0);
    assert_int_equal(pclose(compiler), 0);
    snprintf(path, sizeof path, "%s/o.o", folder);
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    struct bytes object = {malloc(OBJECT_BYTES), 0};
    assert_non_null(object.at);
    object.count = fread(object.at, 1, OBJECT_BYTES, file);
    fclose(file);
    unlink(path);
    rmdir(folder);
    return object;
}

static void expect_by(const struct screen_rules *by, const char *source, const char *flags,
                      const char *cause, const char *named)
{
    struct bytes object = compile(source, flags);
    struct screen screen;
    assert_int_equal(screen_object(object.at, object.count, by, &screen, NULL), 0);
    assert_string_equal(screen.refusal.cause, cause);
    assert_int_equal(screen.refusal.refused, cause[0] != '\0');
    if (named) {
        assert_non_null(strstr(screen.refusal.message.en, named));
        assert_non_null(strstr(screen.refusal.message.es, named));
    }
    screen_release(&screen);
    free(object.at);
}

static void expect(const char *source, const char *flags, const char *cause, const char *named)
{
    expect_by(&rules, source, flags, cause, named);
}

static void right_objects_pass(void **state)
{
    (void)state;
    static const char *const flags[] = {"",
                                        "-g",
                                        "-O0",
                                        "-O3",
                                        "-g3 -ffunction-sections -fdata-sections",
                                        "-march=x86-64-v3 -O3",
                                        "-fPIC",
                                        "-D_FORTIFY_SOURCE=2",
                                        "-fcf-protection=full",
                                        "-fno-asynchronous-unwind-tables"};
    for (size_t i = 0; i < sizeof flags / sizeof flags[0]; i++)
        expect(RIGHT, flags[i], "", NULL);
    expect(RIGHT "static _Thread_local int calls; int count_call(void) { return ++calls; }", "", "",
           NULL);
    expect(RIGHT "int fork(void); int f(void) { return fork(); } void g(void) { exit(1); }", "", "",
           NULL); /* the box's business */
}

static void static_data_and_undefined_symbols_are_listed(void **state)
{
    (void)state;
    struct bytes object =
        compile(RIGHT "int table[1000] = {1}; char room[500]; static const int c[100] = {7};\n"
                      "int get(int i) { return c[i] + table[i] + room[i]; }",
                "");
    struct screen screen;
    assert_int_equal(screen_object(object.at, object.count, &rules, &screen, NULL), 0);
    assert_false(screen.refusal.refused);
    assert_in_range(screen.static_bytes, 4500, 4600);
    static const char *const expected[] = {"fflush", "malloc", "memcmp", "qsort", "sqrt", "stderr"};
    assert_int_equal(screen.undefined_count, 6);
    for (int i = 0; i < 6; i++)
        assert_string_equal(screen.undefined[i], expected[i]);
    screen_release(&screen);
    free(object.at);
}

/* The exercise gives them, whatever they are called; nothing else may be left undefined that is
 * forbidden, and they must not be defined. */
static void given_functions_may_be_undefined(void **state)
{
    (void)state;
    expect(RIGHT "int row_of_edge(int e); int execute_query(int q);\n"
                 "int f(int e) { return row_of_edge(e) + execute_query(e); }",
           "", "", NULL);
    expect(RIGHT "int execute_other(int q); int f(int q) { return execute_other(q); }", "",
           "unknown-symbol", "execute_other");
    expect(RIGHT "int row_of_edge(int e) { return e; }", "", "given-function", "row_of_edge");
}

static void code_around_main_is_refused(void **state)
{
    (void)state;
    expect(RIGHT "__attribute__((constructor)) void f(void) { puts(\"x\"); }", "", "constructor",
           ".init_array");
    expect(RIGHT "__attribute__((destructor)) void f(void) { puts(\"x\"); }", "", "constructor",
           ".fini_array");
    expect(RIGHT "__attribute__((constructor(101))) void f(void) { puts(\"x\"); }", "",
           "constructor", ".init_array.00101");
    expect(RIGHT
           "void f(void); __attribute__((section(\".preinit_array\"), used)) void (*p)(void) = f;",
           "", "constructor", ".preinit_array");
    expect(RIGHT "__attribute__((section(\".init\"))) void f(void) {}", "", "constructor", ".init");
    expect(RIGHT "static int a(void) { return 1; } static void *pick(void) { return a; }\n"
                 "int f(void) __attribute__((ifunc(\"pick\")));",
           "", "indirect-function", "f");
}

static void odd_sections_and_stacks_are_refused(void **state)
{
    (void)state;
    expect(RIGHT "__attribute__((section(\".interp\"))) const char i[] = \"/x\";", "",
           "forbidden-section", ".interp");
    expect(RIGHT "__attribute__((section(\"mine\"))) int i = 1;", "", "forbidden-section", "mine");
    expect(RIGHT "__attribute__((section(\".data.x,\\\"awx\\\"#\"))) int i = 1;", "",
           "forbidden-section", ".data.x");
    expect(RIGHT
           "int g(int (*)(int)); int f(int n) { int add(int x) { return x + n; } return g(add); }",
           "", "executable-stack", "");
    expect(RIGHT "char room[1 << 21];", "", "static-data", "2097");
    expect(RIGHT "const char room[1 << 21] = {1};", "", "static-data", "2097");
    expect(RIGHT "char room[1 << 21];", "-fcommon", "static-data", "2097");
    expect(RIGHT "_Thread_local char room[1 << 21];", "", "static-data", "2097");
    expect(RIGHT "char room[1L << 40];", "-mcmodel=large", "static-data", "1099511");
}

static void names_that_disturb_are_refused(void **state)
{
    (void)state;
    static const char *const names[] = {"execve",
                                        "fexecve",
                                        "posix_spawn",
                                        "wordexp",
                                        "pvalloc",
                                        "__malloc",
                                        "__mremap",
                                        "__getcontext",
                                        "prctl",
                                        "__pthread_create",
                                        "__splitstack_makecontext",
                                        "mmap",
                                        "munmap",
                                        "sbrk",
                                        "syscall",
                                        "dlsym",
                                        "swapcontext",
                                        "pthread_create",
                                        "thrd_create",
                                        "__real_malloc",
                                        "__wrap_free",
                                        "__libc_malloc",
                                        "__malloc_hook",
                                        "environ"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        char source[2000];
        snprintf(source, sizeof source, RIGHT "extern long %s(void); long f(void) { return %s(); }",
                 names[i], names[i]);
        expect(source, "-fno-builtin", "forbidden-symbol", names[i]);
    }
    expect(RIGHT "int f(void) { return system(\"id\"); }", "", "forbidden-symbol", "system");
    expect(RIGHT "void *f(void) { return popen(\"id\", \"r\"); }", "", "forbidden-symbol", "popen");
    expect(RIGHT "extern void __asan_poison(void); void f(void) { __asan_poison(); }", "",
           "sanitizer-symbol", "__asan_poison");
    expect(RIGHT "const char *__asan_default_options(void) { return \"\"; }", "",
           "sanitizer-symbol", "__asan_default_options");
    expect(RIGHT "int __lsan_is_turned_off(void) { return 1; }", "", "sanitizer-symbol", "__lsan_");
    expect(RIGHT "void *__wrap_malloc(size_t n) { return 0; }", "", "forbidden-symbol",
           "__wrap_malloc");
}

/* On no list: perhaps a slip, perhaps a name of what stands beside the code. */
static void unknown_names_are_refused(void **state)
{
    (void)state;
    expect(RIGHT "extern char end[]; char *f(void) { return end; }", "", "unknown-symbol", "end");
    expect(RIGHT "void edge_sort(void); void f(void) { edge_sort(); }", "", "unknown-symbol",
           "edge_sort");
    expect(RIGHT "extern int _IO_list_all; int f(void) { return _IO_list_all; }", "",
           "unknown-symbol", "_IO_list_all");
}

/* Of what is not there weakly, the address says NULL, and so which tool is there. */
static void weak_names_are_refused(void **state)
{
    (void)state;
    expect(RIGHT "int fork(void) __attribute__((weak)); int f(void) { return fork != 0; }", "",
           "forbidden-symbol", "fork");
    expect(RIGHT "int fork(void);\n#pragma weak fork\nint f(void) { return fork != 0; }", "",
           "forbidden-symbol", "fork");
    expect(RIGHT "__attribute__((weak)) int own(void) { return 3; }", "", "", NULL);
    expect_by(&sanitized_rules,
              RIGHT "int fork(void) __attribute__((weak)); int f(void) { return fork != 0; }",
              "-O1 -fsanitize=address,undefined", "forbidden-symbol", "fork");
}

static void given_names_are_allowed(void **state)
{
    (void)state;
    static const char source[] = RIGHT "int mesh_vertex(int); int f(int i)\n"
                                       "{ return mesh_vertex(i); }";
    expect(source, "", "unknown-symbol", "mesh_vertex");
    expect_by(&giving_rules, source, "", "", NULL);
    expect_by(&giving_rules,
              RIGHT "int mesh_vertices(void); int f(void)\n"
                    "{ return mesh_vertices(); }",
              "", "unknown-symbol", "mesh_vertices");
}

/* Their object holds names that gcc makes, and may hold calls that the plain one does not. */
static void objects_for_sanitizers_are_screened(void **state)
{
    (void)state;
    static const char flags[] = "-O1 -fsanitize=address,undefined -fno-sanitize-recover=all";
    expect_by(&sanitized_rules, RIGHT, flags, "", NULL);
    expect_by(&sanitized_rules,
              RIGHT "void use(char *); void f(int n) { for (int i = 0; i < n; i++) {\n"
                    "char room[5000], rest[n + 1]; use(room); use(rest); } }",
              flags, "", NULL);
    expect_by(&sanitized_rules, RIGHT "int f(int n) { int t[] = {7, n}; return t[n]; }",
              "-O1 -fsanitize=address,undefined --param asan-instrumentation-with-call-threshold=0",
              "", NULL);
    expect_by(&sanitized_rules,
              RIGHT "void __asan_unpoison_memory_region(const void *, size_t);\n"
                    "void f(void *p) { __asan_unpoison_memory_region(p, 8); }",
              flags, "sanitizer-symbol", "__asan_unpoison_memory_region");
    expect_by(&sanitized_rules,
              RIGHT "void __ubsan_on_report(void); void f(void) { __ubsan_on_report(); }", flags,
              "sanitizer-symbol", "__ubsan_on_report");
    expect_by(&sanitized_rules,
              RIGHT "int execv(const char *, char **); int f(char **a)\n"
                    "{ return execv(*a, a); }",
              flags, "forbidden-symbol", "execv");
    expect_by(&sanitized_rules, RIGHT "void f(void) { __asm__(\"syscall\"); }", flags,
              "system-call-instruction", ".text");
}

static void missing_functions_are_named(void **state)
{
    (void)state;
    expect("int x;", "", "missing-function", "edge_table_any");
    expect("int edge_tabel(void) { return 1; }", "", "missing-function", "edge_tabel");
    expect("static int edge_table_any(void) { return 1; } int (*f)(void) = edge_table_any;", "",
           "not-a-function", "static");
    expect("int edge_table_any = 3;", "", "not-a-function", "edge_table_any");
    expect("int edge_table_any(void); int f(void) { return edge_table_any(); }", "",
           "missing-function", "edge_table_any");
}

static void requests_and_system_calls_are_refused(void **state)
{
    (void)state;
    expect(RIGHT "long f(void) { long r; __asm__ volatile(\"syscall\" : \"=a\"(r) : \"a\"(39) : "
                 "\"rcx\", \"r11\"); return r; }",
           "", "system-call-instruction", ".text");
    expect(RIGHT "void f(void) { __asm__ volatile(\"int $0x80\"); }", "", "system-call-instruction",
           ".text");
    expect(RIGHT "void f(void) { __asm__ volatile(\"sysenter\"); }", "-ffunction-sections",
           "system-call-instruction", ".text.f");
    expect(RIGHT
           "void f(void) { __asm__ volatile(\"rolq $3,%rdi; rolq $13,%rdi; rolq $61,%rdi; rolq "
           "$51,%rdi; xchgq %rbx,%rbx\"); }",
           "", "tool-request", "valgrind");
    /* the same bytes inside other instructions are honest */
    expect(RIGHT "int f(int x) { return x ^ 0x050f; } long g(void) { return 0x80cd0f340f05L; }", "",
           "", NULL);
}

/* Wherever the linker put it together. */
static void programs_with_requests_are_refused(void **state)
{
    (void)state;
    unsigned char program[4096] = {0};
    static const unsigned char request[] = {0x48, 0xc1, 0xc7, 0x03, 0x48, 0xc1, 0xc7, 0x0d,
                                            0x48, 0xc1, 0xc7, 0x3d, 0x48, 0xc1, 0xc7, 0x33};
    struct refusal refusal = {0};
    memcpy(program + 1001, request, sizeof request - 1);
    screen_program(program, sizeof program, &refusal);
    assert_false(refusal.refused);
    memcpy(program + 1001, request, sizeof request);
    screen_program(program, sizeof program, &refusal);
    assert_string_equal(refusal.cause, "tool-request");
}

static void instructions_have_their_lengths(void **state)
{
    (void)state;
    static const struct {
        const char *code;
        size_t count, bytes;
        bool enters_kernel;
    } rows[] = {{"\xc3", 1, 1, false},
                {"\x0f\x05", 2, 2, true},
                {"\x0f\x34", 2, 2, true},
                {"\xcd\x80", 2, 2, true},
                {"\x89\xcd", 2, 2, false},                                   /* mov %ecx,%ebp */
                {"\x80\x3a\x00", 3, 3, false},                               /* cmpb $0,(%rdx) */
                {"\x0f\x84\x0f\x05\x00\x00", 6, 6, false},                   /* je */
                {"\x48\xb8\x01\x02\x03\x04\x05\x06\x07\x08", 10, 10, false}, /* movabs */
                {"\x66\xb8\x01\x02", 4, 4, false},                           /* mov $,%ax */
                {"\xf6\xc1\x01", 3, 3, false},                               /* test $1,%cl */
                {"\xf7\xd8", 2, 2, false},                                   /* neg %eax */
                {"\x48\x8b\x84\x24\x80\x00\x00\x00", 8, 8, false}, /* mov 128(%rsp),%rax */
                {"\xc5\xf8\x77", 3, 3, false},                     /* vzeroupper */
                {"\xc4\xe3\x7d\x19\xc1\x01", 6, 6, false},         /* vextractf128 */
                {"\x62\xf1\x7c\x48\x58\xc1", 6, 6, false},         /* vaddps zmm */
                {"\x66\x0f\x3a\x0f\xc1\x08", 6, 6, false},         /* palignr */
                {"\x06", 1, 0, false},
                {"\x0f", 1, 0, false},
                {"\xe8\x00\x00", 3, 0, false},
                {"\x66\x66\x66\x66\x66\x66\x66\x66\x66\x66\x66\x66\x66\x66\x66\x90", 16, 0, false}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct instruction found = instruction_decode((const uint8_t *)rows[i].code, rows[i].count);
        assert_int_equal(found.bytes, rows[i].bytes);
        assert_int_equal(found.enters_kernel, rows[i].enters_kernel);
    }
}

/* Every prefix, and every byte changed in turn, is read within its bounds (run with ASan). */
static void damaged_objects_are_survived(void **state)
{
    (void)state;
    struct bytes object = compile(RIGHT "char room[500];", "-g0");
    struct screen screen;
    for (size_t i = 0; i < object.count; i++) {
        unsigned char *copy = malloc(i ? i : 1);
        assert_non_null(copy);
        memcpy(copy, object.at, i);
        assert_int_equal(screen_object(copy, i, &rules, &screen, NULL), 0);
        assert_string_equal(screen.refusal.cause, "object-malformed");
        screen_release(&screen);
        free(copy);
        const unsigned char kept = object.at[i], changes[] = {0xff, 0x80, 1};
        for (int k = 0; k < 3; k++) {
            object.at[i] = (unsigned char)(kept ^ changes[k]);
            assert_int_equal(screen_object(object.at, object.count, &rules, &screen, NULL), 0);
            screen_release(&screen);
        }
        object.at[i] = kept;
    }
    free(object.at);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(right_objects_pass),
        cmocka_unit_test(static_data_and_undefined_symbols_are_listed),
        cmocka_unit_test(given_functions_may_be_undefined),
        cmocka_unit_test(code_around_main_is_refused),
        cmocka_unit_test(odd_sections_and_stacks_are_refused),
        cmocka_unit_test(names_that_disturb_are_refused),
        cmocka_unit_test(unknown_names_are_refused),
        cmocka_unit_test(weak_names_are_refused),
        cmocka_unit_test(given_names_are_allowed),
        cmocka_unit_test(objects_for_sanitizers_are_screened),
        cmocka_unit_test(missing_functions_are_named),
        cmocka_unit_test(requests_and_system_calls_are_refused),
        cmocka_unit_test(programs_with_requests_are_refused),
        cmocka_unit_test(instructions_have_their_lengths),
        cmocka_unit_test(damaged_objects_are_survived),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
