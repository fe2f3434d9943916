/* Any bytes as machine code: instructions of 1 to 15 bytes within the text, and none that is
 * shorter or longer when more bytes follow it. */
#include "graders/engine/build/instruction.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

enum { LONGEST = 15 };

/* The same when the text ends behind it, in a buffer of exactly its size. */
static void check_cut(const uint8_t *code, struct instruction whole)
{
    uint8_t *exact = malloc(whole.bytes);
    if (!exact)
        return;
    memcpy(exact, code, whole.bytes);
    struct instruction cut = instruction_decode(exact, whole.bytes);
    if (cut.bytes != whole.bytes || cut.enters_kernel != whole.enters_kernel ||
        instruction_decode(exact, whole.bytes - 1).bytes != 0)
        abort();
    free(exact);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count)
{
    for (size_t at = 0; at < count;) {
        struct instruction found = instruction_decode(bytes + at, count - at);
        if (found.bytes > LONGEST || found.bytes > count - at ||
            (!found.bytes && found.enters_kernel))
            abort();
        if (found.bytes)
            check_cut(bytes + at, found);
        at += found.bytes ? found.bytes : 1;
    }
    return 0;
}
