/* Any bytes as callgrind's dump: no crash, and what is read keeps its promises. */
#include "bench/measure/callgrind.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count)
{
    struct callgrind_dump dump;
    struct error err = {0};
    if (callgrind_parse((const char *)bytes, count, &dump, &err)) {
        if (!err.text[0])
            abort();
        return 0;
    }
    const struct callgrind_counts *counts = &dump.counts;
    if (dump.part < 0 || callgrind_cost(counts) < counts->instructions)
        abort();
    if (dump.hottest_count < 0 || dump.hottest_count > CALLGRIND_HOTTEST)
        abort();
    for (int i = 0; i < dump.hottest_count; i++)
        if (dump.hottest[i].instructions <= 0 || strlen(dump.hottest[i].name) >= CALLGRIND_NAME ||
            (i && dump.hottest[i].instructions > dump.hottest[i - 1].instructions))
            abort();
    return 0;
}
