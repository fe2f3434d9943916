/* Fuzz target: the OFF reader; see fuzz_ply.c. */
#include "reference/formats/off.h"
#include "tests/fuzz/check_reader.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t byte_count)
{
    check_reader(off_read, off_write, bytes, byte_count);
    return 0;
}
