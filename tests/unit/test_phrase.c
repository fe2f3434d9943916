/* Texts in both languages: composing, appending, cutting between characters. */
#include "reference/base/phrase.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static void says_both_languages(void **state)
{
    (void)state;
    struct message m = {"old", "viejo"};
    message_say(&m, "%d edges of %s", "%d aristas de %s", 3, "x");
    assert_string_equal(m.en, "3 edges of x");
    assert_string_equal(m.es, "3 aristas de x");
    message_add(&m, ".", ";");
    message_en(&m, " %s", "en");
    message_es(&m, " %s", "es");
    message_add_phrase(&m, (struct phrase){" yes", " sí"});
    assert_string_equal(message_text(&m, LANGUAGE_EN), "3 edges of x. en yes");
    assert_string_equal(message_text(&m, LANGUAGE_ES), "3 aristas de x; es sí");
}

static void no_phrase_is_empty(void **state)
{
    (void)state;
    struct phrase none = {NULL, NULL};
    assert_string_equal(phrase_text(none, LANGUAGE_EN), "");
    assert_string_equal(phrase_text(none, LANGUAGE_ES), "");
}

/* Fills up to `before` bytes, then adds a text that does not fit: what remains must be whole. */
static void cuts_between_characters(void **state)
{
    (void)state;
    for (int room = 1; room <= 9; room++) {
        struct message m = {"", ""};
        char filler[MESSAGE_BYTES];
        memset(filler, 'a', sizeof filler);
        filler[MESSAGE_BYTES - room] = '\0';
        message_say(&m, "%s", "%s", filler);
        size_t used = strlen(m.es);
        message_es(&m, "%s", "áá€€");
        size_t added = strlen(m.es) - used;
        static const size_t whole[] = {0, 0, 2, 2, 4, 4, 4, 7, 7};
        assert_int_equal(added, whole[room - 1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(says_both_languages),
        cmocka_unit_test(no_phrase_is_empty),
        cmocka_unit_test(cuts_between_characters),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
