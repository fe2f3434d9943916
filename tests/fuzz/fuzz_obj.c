/* Fuzz target: the OBJ reader; see fuzz_ply.c. */
#include "reference/formats/obj.h"
#include "tests/fuzz/check_reader.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t byte_count)
{
    check_reader(obj_read, obj_write, bytes, byte_count);
    return 0;
}
