/* Every cause that the engine and the judges name in their sources has a Spanish text. */
#include "graders/engine/base/files.h"
#include "graders/report/words.h"

#include <glob.h>
#include <regex.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* A slug in quotes, behind a verdict, a refusal's or a rejection's first argument, or an equals
 * sign. */
static const char *const patterns[] = {
    "VERDICT_[A-Z_]+,[[:space:]]*\"([a-z][a-z0-9-]*[a-z0-9])\"",
    "refuse[a-z_]*\\([^\";]*,[[:space:]]*\"([a-z][a-z0-9-]*[a-z0-9])\"",
    "judge_reject\\([^\";]*,[[:space:]]*\"([a-z][a-z0-9-]*[a-z0-9])\"",
    "cause = \"([a-z][a-z0-9-]*[a-z0-9])\"",
};
static const char *const sources[] = {"graders/engine/*.c", "graders/engine/*/*.c",
                                      "graders/library/*.c", "graders/judges/*.c",
                                      "graders/judges/*/*.c"};

/* Looks the causes up that one pattern finds in one file. Returns how many. */
static int look_up(const char *text, const char *pattern, int *missing)
{
    regex_t expression;
    regmatch_t match[2];
    int found = 0;
    assert_int_equal(regcomp(&expression, pattern, REG_EXTENDED), 0);
    for (; regexec(&expression, text, 2, match, 0) == 0; text += match[0].rm_eo, found++) {
        char slug[80], shown[80];
        snprintf(slug, sizeof slug, "%.*s", (int)(match[1].rm_eo - match[1].rm_so),
                 text + match[1].rm_so);
        struct words words = words_cause(slug, shown, sizeof shown);
        if (strcmp(words.es, words.en) != 0 || strcmp(slug, "constructor") == 0)
            continue;
        print_error("%s has no Spanish text\n", slug);
        ++*missing;
    }
    regfree(&expression);
    return found;
}

static void every_cause_has_a_spanish_text(void **state)
{
    (void)state;
    const char *root = project_root(NULL);
    int found = 0, missing = 0;
    assert_non_null(root);
    for (size_t s = 0; s < sizeof sources / sizeof *sources; s++) {
        char pattern[4096];
        glob_t files;
        snprintf(pattern, sizeof pattern, "%s/%s", root, sources[s]);
        assert_int_equal(glob(pattern, 0, NULL, &files), 0);
        for (size_t i = 0; i < files.gl_pathc; i++) {
            char *text;
            size_t bytes;
            assert_int_equal(file_read(files.gl_pathv[i], 1 << 20, &text, &bytes, NULL), 0);
            for (size_t p = 0; p < sizeof patterns / sizeof *patterns; p++)
                found += look_up(text, patterns[p], &missing);
            free(text);
        }
        globfree(&files);
    }
    assert_int_equal(missing, 0);
    assert_true(found > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_cause_has_a_spanish_text)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
