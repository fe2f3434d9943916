/* The policy on preprocessed text: what gcc -E makes of honest and of tricky sources. */
#include "graders/engine/build/directives.h"
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

static struct policy judge(const char *source, const char *flags)
{
    struct policy policy;
    size_t bytes = preprocessed_make(source, flags);
    policy_check(preprocessed_text, bytes, NULL, &policy);
    return policy;
}

static void expect(const char *source, const char *cause, int line)
{
    static const char *const standards[] = {"-std=c17", "-std=gnu17 -g"};
    for (int i = 0; i < 2; i++) {
        struct policy policy = judge(source, standards[i]);
        assert_string_equal(policy.refusal.cause, cause);
        assert_int_equal(policy.refusal.refused, cause[0] != '\0');
        if (cause[0]) {
            char where[32];
            snprintf(where, sizeof where, "main.c:%d: ", line);
            assert_int_equal(policy.line, line);
            assert_string_equal(policy.file, "main.c");
            assert_memory_equal(policy.refusal.message.en, where, strlen(where));
            assert_memory_equal(policy.refusal.message.es, where, strlen(where));
        }
    }
}

static void every_header_passes(void **state)
{
    (void)state;
    static const char headers[] =
        "#define _GNU_SOURCE\n#include <assert.h>\n#include <complex.h>\n#include <ctype.h>\n"
        "#include <errno.h>\n#include <fenv.h>\n#include <float.h>\n#include <inttypes.h>\n"
        "#include <iso646.h>\n#include <limits.h>\n#include <locale.h>\n#include <math.h>\n"
        "#include <setjmp.h>\n#include <signal.h>\n#include <stdalign.h>\n#include <stdarg.h>\n"
        "#include <stdatomic.h>\n#include <stdbool.h>\n#include <stddef.h>\n#include <stdint.h>\n"
        "#include <stdio.h>\n#include <stdlib.h>\n#include <stdnoreturn.h>\n#include <string.h>\n"
        "#include <tgmath.h>\n#include <threads.h>\n#include <time.h>\n#include <uchar.h>\n"
        "#include <wchar.h>\n#include <wctype.h>\n#include <unistd.h>\n#include <pthread.h>\n"
        "#include <search.h>\n#include <immintrin.h>\n#include <x86intrin.h>\n#include <malloc.h>\n"
        "__m128 twice(__m128 x) { return _mm_add_ps(x, x); }\n";
    expect(headers, "", 0);
    struct policy policy = judge(headers, "-std=gnu17 -D_FORTIFY_SOURCE=2");
    assert_string_equal(policy.refusal.message.en, "");
    policy = judge(headers, "-std=c17 -O0 -fsanitize=address");
    assert_string_equal(policy.refusal.message.en, "");
}

static void honest_words_pass(void **state)
{
    (void)state;
    expect(
        "int constructor, naked, section, weak, target; /* asm */ // __asm__\n"
        "const char *s = \"asm(\\\"nop\\\") \\\\\", *t = \"#pragma GCC optimize\"; char c = '\"';\n"
        "int plasma, asmodeus; int a[3]; int f(int n) { return a[a[n]] + n; }\n",
        "", 0);
    expect("__attribute__((noinline, aligned(sizeof(int)), cleanup(section))) int f(void);\n"
           "__attribute__((unused)) static int naked(int constructor) { return constructor; }\n"
           "#pragma GCC diagnostic ignored \"-Wall\"\n#pragma STDC FP_CONTRACT OFF\n"
           "#pragma GCC unroll 4\n#pragma pack(push, 1)\n#pragma omp simd\n#pragma once\n",
           "", 0);
    expect("int x = __builtin_popcount(3); void g(void) { __builtin_ia32_pause(); }\n", "", 0);
}

static void assembly_is_refused(void **state)
{
    (void)state;
    static const char *const sources[] = {
        "\n\n__asm__(\"nop\");\n",
        "\nvoid f(void) {\n  __asm__ volatile(\"nop\"); }\n",
        "\n\nregister long sp __asm__(\"rsp\");\n",
        "\n\nint f(void) __asm(\"__real_malloc\");\n",
        "#define PASTE(a, b) a##b\n#define A PASTE(__as, m__)\nvoid f(void) { A(\"nop\"); }\n",
        "\n\nint f(void) { return 'x' + '\"'; } __asm__(\"nop\"); char c = '\"';\n",
        "\nconst char *s = \"\\\\\"\n; __asm__(\"\"); const char *t = \"\";\n",
        "\n\n__a\\\nsm__(\"nop\");\n",
        "?\?=define A __asm__\n\nA(\"nop\");\n",
    };
    for (size_t i = 0; i + 1 < sizeof sources / sizeof sources[0]; i++)
        expect(sources[i], "inline-assembly", 3);
    struct policy policy = judge(sources[sizeof sources / sizeof sources[0] - 1], "-std=c17");
    assert_string_equal(policy.refusal.cause, "inline-assembly"); /* gnu17 knows no trigraphs */
}

static void attributes_are_refused(void **state)
{
    (void)state;
    static const char *const names[] = {"constructor",
                                        "__constructor__",
                                        "constructor(101)",
                                        "destructor",
                                        "naked",
                                        "no_sanitize(\\\"address\\\")",
                                        "no_sanitize_address",
                                        "__no_sanitize_undefined__",
                                        "no_sanitize_thread",
                                        "ifunc(\\\"g\\\")",
                                        "section(\\\".init\\\")",
                                        "alias(\\\"g\\\")",
                                        "optimize(\\\"O3\\\")",
                                        "copy(g)",
                                        "indirect_branch(\\\"thunk-extern\\\")",
                                        "common",
                                        "patchable_function_entry(9)",
                                        "retain",
                                        "simd",
                                        "of_tomorrow",
                                        "target(\\\"avx2\\\")",
                                        "target_clones(\\\"avx2\\\", \\\"default\\\")",
                                        "unused, aligned(8), __naked__"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        char name[100], source[400];
        size_t length = 0;
        for (const char *c = names[i]; *c; c++)
            if (*c != '\\')
                name[length++] = *c;
        name[length] = '\0';
        snprintf(source, sizeof source, "int g(void);\n__attribute__((%s)) int f(void);\n", name);
        expect(source, "forbidden-attribute", 2);
        snprintf(source, sizeof source,
                 "int g(void);\nint f(void) __attribute  (  ( const, %s ) ) ;\n", name);
        expect(source, "forbidden-attribute", 2);
        if (!strchr(name, ','))
            snprintf(source, sizeof source, "int g(void);\n[[gnu::%s]] int f(void);\n", name);
        expect(source, "forbidden-attribute", 2);
        if (!strchr(name, ','))
            snprintf(source, sizeof source, "int g(void);\n<: [gnu::%s]:> int f(void);\n", name);
        expect(source, "forbidden-attribute", 2);
    }
    expect("#define NO(x) __attribute__((no_##x##_address))\n\nNO(sanitize) int f(void);\n",
           "forbidden-attribute", 3);
}

static void pragmas_are_refused(void **state)
{
    (void)state;
    static const char *const pragmas[] = {"#pragma GCC optimize(\"O3\")",
                                          "#pragma GCC target(\"avx512f\")",
                                          "#pragma weak f",
                                          "#pragma redefine_extname f g",
                                          "#  pragma   GCC   optimize \"O3\"",
                                          "#pragma GCC push_options",
                                          "#pragma weakly",
                                          "#pragma GCC pch_preprocess \"x\"",
                                          "#pragma GCC visibility push(default)",
                                          "#pragma GCC of_tomorrow",
                                          "#pragma ident \"nop\"",
                                          "_Pragma(\"GCC optimize(3)\")"};
    for (size_t i = 0; i < sizeof pragmas / sizeof pragmas[0]; i++) {
        char source[200];
        snprintf(source, sizeof source, "int x;\n%s\nint y;\n", pragmas[i]);
        expect(source, "forbidden-pragma", 2);
    }
}

/* gcc hands the text of #ident to the assembler. */
static void other_directives_are_refused(void **state)
{
    (void)state;
    expect("int x;\n#ident \"\\\"\\n nop \\n .string \\\"\"\n", "forbidden-directive", 2);
    expect("int x;\n%: sccs \"x\"\n", "forbidden-directive", 2);
    struct policy policy;
    policy_check("#assert x(y)\n", 13, NULL, &policy);
    assert_string_equal(policy.refusal.cause, "forbidden-directive");
    policy_check("#pragmatic\n", 11, NULL, &policy);
    assert_string_equal(policy.refusal.cause, "forbidden-directive");
}

static void expect_source(const char *source, const char *cause, int line)
{
    struct refusal refusal = {0};
    char where[32];
    int found = directives_check("main.c", source, strlen(source), &refusal);
    if (strcmp(refusal.cause, cause) != 0 || found != line)
        print_error("%s\n", source);
    assert_string_equal(refusal.cause, cause);
    assert_int_equal(found, line);
    assert_int_equal(refusal.refused, cause[0] != '\0');
    snprintf(where, sizeof where, "main.c:%d: ", line);
    if (line) {
        assert_memory_equal(refusal.message.en, where, strlen(where));
        assert_memory_equal(refusal.message.es, where, strlen(where));
    }
}

/* Whatever the preprocessor takes for one, and nothing else. */
static void markers_in_the_source_are_refused(void **state)
{
    (void)state;
    static const struct {
        const char *source, *cause;
        int line;
    } rows[] = {
        {"int x;\n# 1 \"/usr/include/stdio.h\" 1 3\n", "forbidden-line", 2},
        {"#1 \"a\"", "forbidden-line", 1},
        {"\xef\xbb\xbf# 1 \"a\"", "forbidden-line", 1},
        {"#define F \"a\"\n# 1 F 1 3\n", "forbidden-line", 2},
        {" \t\f\v\r# \t1 \"a\"", "forbidden-line", 1},
        {"%: 1 \"a\"", "forbidden-line", 1},
        {"%\\\n:\\ \n 1 \"a\"", "forbidden-line", 2},
        {"?\?= 1 \"a\"", "forbidden-line", 1},
        {"#\\\n 1 \"a\"", "forbidden-line", 1},
        {"#?\?/\n 1 \"a\"", "forbidden-line", 1},
        {"/* x\n */ # 1 \"a\"", "forbidden-line", 2},
        {"#/* x\n */ 1 \"a\"", "forbidden-line", 1},
        {"# /\\\n* x *\\\n/ 1 \"a\"", "forbidden-line", 1},
        {"// x \\\n\n# 1 \"a\"", "forbidden-line", 3},
        {"#if 0\ndon't /*\n#endif\n# 1 \"a\"\n/* */", "forbidden-line", 4},
        {"const char *s = \"\\\\\" \"/*\";\n# 1 \"a\"", "forbidden-line", 2},
        {"char c = '\"'; /* \" */\n# 1 \"a\"", "forbidden-line", 2},
        {"char c = '/*\n# 1 \"a\"", "forbidden-line", 2},
        {"#ident \"x\"", "forbidden-directive", 1},
        {"#/**/sc\\\ncs \"x\"", "forbidden-directive", 1},
        {"#if __has_include(</*>)\n#endif\n# 1 \"a\" /* */", "forbidden-include", 1},
        {"#include <a\"/*>\n# 1 \"a\" /* \" */", "forbidden-include", 1},
        {"#pragma GCC dependency </*>\n", "forbidden-include", 1},
        {"s = R\"( \" /* )\";\n# 1 \"a\"\n", "raw-string", 1},
        {"s = u8\\\nR\"()\";", "raw-string", 2},
        {"/*\n# 1 \"a\"\n# ident is a word\n*/ int x;", "", 0},
        {"// \\\n# 1 \"a\"\n", "", 0},
        {"const char *s = \"\\\n# 1 \";\n", "", 0},
        {"#if A < B /* less */ && C > D\n#include <stdio.h> /* puts */\n#endif", "", 0},
        {"#include \"own.h\" // one's own\n#define HASH #\nHASH 1\nx = a # 1;", "", 0},
        {"#line 7\n#define identity(x) x\n#error don't\n#", "", 0},
        {"", "", 0},
        {"\\", "", 0},
        {"/*", "", 0},
        {"#/", "", 0},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
        expect_source(rows[i].source, rows[i].cause, rows[i].line);
    struct refusal refusal = {0};
    assert_int_equal(directives_check("main.c", "\0#\0 1", 5, &refusal), 1);
    assert_string_equal(refusal.cause, "forbidden-line");
}

/* Markers in the student's text may not make it look like a system header. */
static void forged_lines_are_refused(void **state)
{
    (void)state;
    struct policy policy = judge("int x;\n#line 1 \"tests/hidden.c\"\nint y;\n", "");
    assert_string_equal(policy.refusal.cause, "forbidden-line");
    policy = judge("int x;\n# 1 \"/usr/include/stdio.h\" 3\n__asm__(\"nop\");\n", "");
    assert_string_equal(policy.refusal.cause, "forbidden-line");
    static const char *const hidden[] = {
        "__asm__(\"nop\");", "void f(void) { __asm__ volatile (\"syscall\"); }",
        "void f(void) { if (1) __asm__ (\"syscall\"); }", "int f(void) __asm__ (\"nop; nop\");",
        "void f(void) { __asm__ volatile (\"encls\\n\\t\" \"syscall\"); }"};
    for (size_t i = 0; i < sizeof hidden / sizeof hidden[0]; i++) {
        char source[300];
        snprintf(source, sizeof source,
                 "int x;\n# 1 \"/usr/include/stdio.h\" 1 3\n%s\n# 2 \"main.c\" 2\n", hidden[i]);
        policy = judge(source, "");
        assert_string_equal(policy.refusal.cause, "inline-assembly");
    }
    policy = judge("# 1 \"/usr/include/stdio.h\" 1 3\n__attribute__((constructor)) void f(void);\n"
                   "# 2 \"main.c\" 2\n",
                   "");
    assert_string_equal(policy.refusal.cause, "forbidden-attribute");
    preprocessed_write("own.h", "#pragma GCC system_header\nint z; __asm__(\"nop\");\n");
    policy = judge("#include \"own.h\"\nint x;\n", "");
    assert_string_equal(policy.refusal.cause, "inline-assembly");
    assert_string_equal(policy.file, "own.h");
}

static void includes_stay_inside(void **state)
{
    (void)state;
    preprocessed_write("own.h", "int own;\n");
    expect("#include \"own.h\"\n#include \"./own.h\"\n", "", 0);
    char source[200], outside[64], name[64];
    snprintf(outside, sizeof outside, "%s/own.h", preprocessed_folder);
    snprintf(source, sizeof source, "#include \"%s\"\n", outside);
    struct policy policy = judge(source, "");
    assert_string_equal(policy.refusal.cause, "forbidden-include");
    policy_check(preprocessed_text, preprocessed_make(source, ""), preprocessed_folder, &policy);
    assert_string_equal(policy.refusal.cause, "");
    snprintf(name, sizeof name, "../%s/own.h", strrchr(preprocessed_folder, '/') + 1);
    snprintf(source, sizeof source, "#include \"%s\"\n", name);
    policy = judge(source, "");
    assert_string_equal(policy.refusal.cause, "forbidden-include");
    policy = judge("#include \"/usr/include/limits.h\"\n", "");
    assert_string_equal(policy.refusal.cause, "forbidden-include");
    /* gcc marks what <> finds as a system header, wherever the path leads from there. */
    static const char *const ways[] = {"linux/../../..", "../..", "linux/../../../../.."};
    static const char *const contents[] = {"int own;\n", "#pragma GCC target(\"avx512f\")\n",
                                           "int f(void) __asm__(\"hidden\");\n"};
    for (size_t i = 0; i < sizeof ways / sizeof ways[0]; i++)
        for (size_t j = 0; j < sizeof contents / sizeof contents[0]; j++) {
            preprocessed_write("own.h", contents[j]);
            snprintf(source, sizeof source, "#include <%s%s>\n", ways[i], outside);
            policy = judge(source, "");
            assert_string_equal(policy.refusal.cause, "forbidden-include");
        }
    expect("#include <sys/types.h>\n#include <linux/limits.h>\n", "", 0);
}

/* gnu17 knows raw strings, c17 does not: what one takes for a string the other compiles. */
static void raw_strings_are_refused(void **state)
{
    (void)state;
    static const char hidden[] =
        "const char *s = R\"( \" )\"; __asm__(\"nop\"); char t[] = \") \";\n";
    struct policy policy;
    policy_check(hidden, strlen(hidden), NULL, &policy);
    assert_string_equal(policy.refusal.cause, "raw-string");
}

static void anything_is_survived(void **state)
{
    (void)state;
    static const char *const texts[] = {"",
                                        "#",
                                        "# 1",
                                        "# 1 \"",
                                        "# 1 \"x\\",
                                        "\"",
                                        "'\\",
                                        "asm",
                                        "__attribute__",
                                        "__attribute__((",
                                        "[[",
                                        "#pragma",
                                        "\\",
                                        "# 99999999999999 \"x\" 3\nasm(",
                                        ")asm(\"\"",
                                        "<:<:naked"};
    struct policy policy;
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        size_t length = strlen(texts[i]);
        char *copy = malloc(length ? length : 1);
        assert_non_null(copy);
        memcpy(copy, texts[i], length);
        policy_check(copy, length, NULL, &policy);
        assert_int_equal(policy.refusal.refused, policy.refusal.cause[0] != '\0');
        free(copy);
    }
    policy_check("\0asm(\"x\")", 9, NULL, &policy);
    assert_string_equal(policy.refusal.cause, "inline-assembly");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_header_passes),
        cmocka_unit_test(honest_words_pass),
        cmocka_unit_test(assembly_is_refused),
        cmocka_unit_test(attributes_are_refused),
        cmocka_unit_test(pragmas_are_refused),
        cmocka_unit_test(forged_lines_are_refused),
        cmocka_unit_test(includes_stay_inside),
        cmocka_unit_test(raw_strings_are_refused),

        cmocka_unit_test(anything_is_survived),
        cmocka_unit_test(other_directives_are_refused),
        cmocka_unit_test(markers_in_the_source_are_refused),
    };
    return cmocka_run_group_tests(tests, preprocessed_set_up, preprocessed_tear_down);
}
