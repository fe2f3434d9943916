/* The seams of composed messages: what is told of them, and what is left alone. */
#include "graders/known/wording.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

/* A result whose one case has this message in English, or in Spanish. */
static bool is_sound(const char *language, const char *text, char *why, size_t capacity)
{
    json_t *result = json_pack("{s:{s:s}, s:[{s:s, s:{s:s}}]}", "summary", "en", "Fine.", "cases",
                               "name", "no.Sentence", "message", language, text);
    assert_non_null(result);
    bool sound = wording_is_sound(result, why, capacity);
    json_decref(result);
    return sound;
}

static void seams_are_found(void **state)
{
    static const struct {
        const char *text, *what;
    } bad[] = {{"around the face.After 7 comes 20.", "no blank between sentences"},
               {"one  two.", "two blanks"},
               {"one .", "a blank before a stop"},
               {" one.", "a blank at an end"},
               {"one. ", "a blank at an end"},
               {"one", "no stop at the end"}};
    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        for (int spanish = 0; spanish < 2; spanish++) {
            char why[400] = "";
            assert_false(is_sound(spanish ? "es" : "en", bad[i].text, why, sizeof why));
            assert_int_equal(strncmp(why, bad[i].what, strlen(bad[i].what)), 0);
            assert_non_null(strstr(why, bad[i].text));
        }
}

static void whole_sentences_are_left_alone(void **state)
{
    static const char *const good[] = {"", "A 1.5 in V.C is fine. So is 0 ... 7, and file.c.",
                                       "Is it?", "(In brackets.)", "¿Sí? No: 3."};
    (void)state;
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        char why[400] = "";
        assert_true(is_sound("en", good[i], why, sizeof why));
        assert_string_equal(why, "");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(seams_are_found),
                                       cmocka_unit_test(whole_sentences_are_left_alone)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
