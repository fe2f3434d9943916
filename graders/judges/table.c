/* Finds a judge by name; see table.h. */
#include "graders/judges/table.h"

#include <string.h>

const struct judge *judge_find(const char *exercise)
{
    for (const struct judge *const *judge = judge_table; *judge; judge++)
        if (strcmp((*judge)->exercise, exercise) == 0)
            return *judge;
    return NULL;
}
