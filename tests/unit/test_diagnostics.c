/* The line of a compiler's talk that a student is shown first. The texts are gcc 12's and ld's. */
#include "graders/report/diagnostics.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

static void assert_line(const char *diagnostics, const char *expected)
{
    char line[200];
    diagnostics_telling_line(diagnostics, line, sizeof line);
    assert_string_equal(line, expected);
}

static void test_an_error_at_its_place(void **state)
{
    (void)state;
    assert_line("mesh-area.c: In function 'mesh_area':\n"
                "mesh-area.c:5:9: warning: unused variable 'error' [-Wunused-variable]\n"
                "    5 |     int error;\n"
                "mesh-area.c:7:5: error: 'x' undeclared (first use in this function)\n"
                "mesh-area.c:9:1: error: expected ';'\n",
                "mesh-area.c:7:5: error: 'x' undeclared (first use in this function)");
    assert_line("mesh-area.c:1:10: fatal error: conio.h: No such file or directory\n"
                "compilation terminated.\n",
                "mesh-area.c:1:10: fatal error: conio.h: No such file or directory");
    assert_line("mesh-area.c: Assembler messages:\n"
                "mesh-area.c:3: Error: no such instruction: `frobnicate'\n",
                "mesh-area.c:3: Error: no such instruction: `frobnicate'");
}

static void test_a_name_that_holds_the_word(void **state)
{
    (void)state;
    assert_line("latin1-error.c: In function 'mesh_area':\n"
                "latin1-error.c:4:9: warning: unused variable 'a'\n"
                "latin1-error.c:5:1: error: stray '\\351' in program\n",
                "latin1-error.c:5:1: error: stray '\\351' in program");
    assert_line("error.c:2:2: warning: #warning \"error: none\" [-Wcpp]\n"
                "error.c:3:2: error: #error sorry\n",
                "error.c:3:2: error: #error sorry");
}

static void test_the_linker_speaks_last(void **state)
{
    (void)state;
    assert_line("mesh-area.c:6:20: warning: unused function 'error_of'\n"
                "/usr/bin/ld: mesh-area.o: in function `mesh_area':\n"
                "/work/mesh-area.c:23: undefined reference to `product'\n"
                "collect2: error: ld returned 1 exit status\n",
                "/work/mesh-area.c:23: undefined reference to `product'");
    assert_line("/usr/bin/ld: b.o: in function `area':\n"
                "b.c:2: multiple definition of `area'; a.o:a.c:2: first defined here\n"
                "collect2: error: ld returned 1 exit status\n",
                "b.c:2: multiple definition of `area'; a.o:a.c:2: first defined here");
}

static void test_nothing_that_tells(void **state)
{
    (void)state;
    assert_line("\ngcc was here\n", "gcc was here");
    assert_line("collect2: error: ld returned 1 exit status\n/usr/bin/ld: cannot find -lm\n",
                "/usr/bin/ld: cannot find -lm");
    assert_line("collect2: error: ld returned 1 exit status\n",
                "collect2: error: ld returned 1 exit status");
    assert_line("a.c:1:1: error: cut he", "a.c:1:1: error: cut he");
    assert_line("", "");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_an_error_at_its_place),
        cmocka_unit_test(test_a_name_that_holds_the_word),
        cmocka_unit_test(test_the_linker_speaks_last),
        cmocka_unit_test(test_nothing_that_tells),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
