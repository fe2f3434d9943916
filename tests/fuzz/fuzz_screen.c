/* Any bytes as an object file, and as preprocessed text: no crash, and a refusal always says why.
 */
#include "graders/engine/build/policy.h"
#include "graders/engine/build/screen.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

static void check_refusal(const struct refusal *refusal)
{
    bool has_text = refusal->cause[0] && refusal->message.en[0] && refusal->message.es[0];
    if (refusal->refused != has_text)
        abort();
}

static void try_screen(const uint8_t *bytes, size_t count, bool sanitized)
{
    static const char *const functions[] = {"edge_table_any", NULL}, *const given[] = {NULL};
    const struct screen_rules rules = {functions, given, 1 << 20, sanitized};
    struct screen screen;
    if (screen_object(bytes, count, &rules, &screen, NULL))
        abort();
    check_refusal(&screen.refusal);
    for (int i = 1; i < screen.undefined_count; i++)
        if (strcmp(screen.undefined[i - 1], screen.undefined[i]) >= 0)
            abort();
    if (screen.static_bytes < 0 ||
        (!screen.refusal.refused && screen.static_bytes > rules.static_limit_bytes))
        abort();
    screen_release(&screen);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count)
{
    struct policy policy;
    try_screen(bytes, count, false);
    try_screen(bytes, count, true);
    policy_check((const char *)bytes, count, "/public", &policy);
    check_refusal(&policy.refusal);
    return 0;
}
