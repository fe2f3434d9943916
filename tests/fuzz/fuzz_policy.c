/* Any bytes as preprocessed text: no crash, a refusal always says why, and what is refused stays
 * refused when harmless text follows it. */
#include "graders/engine/build/policy.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count)
{
    static const char harmless[] = "\nint x;\n";
    struct policy policy, longer;
    policy_check((const char *)bytes, count, "/public", &policy);
    const struct refusal *refusal = &policy.refusal;
    bool has_text = refusal->cause[0] && refusal->message.en[0] && refusal->message.es[0];
    if (refusal->refused != has_text)
        abort();
    char *text = malloc(count + sizeof harmless);
    if (!text)
        return 0;
    memcpy(text, bytes, count);
    memcpy(text + count, harmless, sizeof harmless);
    policy_check(text, count + sizeof harmless - 1, "/public", &longer);
    if (refusal->refused && !longer.refusal.refused)
        abort();
    free(text);
    return 0;
}
