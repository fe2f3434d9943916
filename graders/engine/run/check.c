/* What came of a check; see check.h. */
#include "graders/engine/run/check.h"

#include <stdarg.h>
#include <stdio.h>

const struct cause check_not_reached = {"not-reached", {"not reached", "sin examinar"}};

const struct cause check_leaked_blocks = {"leak", {"memory leak", "fuga de memoria"}};

void check_say(struct check_result *check, enum verdict verdict, const struct cause *cause,
               const char *en, const char *es, ...)
{
    va_list arguments;
    check->verdict = verdict;
    snprintf(check->cause, sizeof check->cause, "%s", cause ? cause->slug : "");
    message_set_phrase(&check->cause_name, cause ? cause->name : (struct phrase){NULL, NULL});
    va_start(arguments, es);
    message_say_list(&check->message, en, es, arguments);
    va_end(arguments);
}
