/* Hints as tables; see hints.h. */
#include "graders/library/hints.h"

#include <stddef.h>

/* What tells wrong elements: a predicate, or marks. */
struct wrongness {
    hint_predicate *is_wrong;
    const void *context;
    const uint8_t *marks;
    uint8_t mark;
};

static bool is_wrong(const struct wrongness *wrong, int64_t element)
{
    if (wrong->is_wrong)
        return wrong->is_wrong(wrong->context, element);
    return wrong->marks && wrong->marks[element] == wrong->mark;
}

static bool fits(const struct hint_rule *rule, const void *context, int64_t element_count,
                 const struct wrongness *wrong)
{
    bool is_any = false;
    for (int64_t i = 0; i < element_count; i++) {
        bool is_bad = is_wrong(wrong, i);
        is_any = is_any || is_bad;
        if ((is_bad || rule->scope == HINT_ALL_OF_THESE) && rule->holds(context, i) != is_bad)
            return false;
    }
    return is_any;
}

static struct phrase find(const struct hint_rule *rules, int rule_count, const void *context,
                          int64_t element_count, const struct wrongness *wrong)
{
    for (int i = 0; i < rule_count; i++)
        if (fits(&rules[i], context, element_count, wrong))
            return rules[i].hint;
    return (struct phrase){NULL, NULL};
}

struct phrase hint_find(const struct hint_rule *rules, int rule_count, const void *context,
                        int64_t element_count, hint_predicate *is_wrong_element)
{
    struct wrongness wrong = {.is_wrong = is_wrong_element, .context = context};
    return find(rules, rule_count, context, element_count, &wrong);
}

struct phrase hint_find_marked(const struct hint_rule *rules, int rule_count, const void *context,
                               int64_t element_count, const uint8_t *marks, uint8_t wrong)
{
    struct wrongness wrongness = {.marks = marks, .mark = wrong};
    return find(rules, rule_count, context, element_count, &wrongness);
}
