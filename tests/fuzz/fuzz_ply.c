/* Fuzz target: the PLY reader. Any bytes are refused with an error, or read as a valid mesh that
 * comes back from the writer bit for bit.
 *
 *   clang -fsanitize=fuzzer,address,undefined ...   searches; see tests/fuzz/replay.c for gcc */
#include "reference/formats/ply.h"
#include "tests/fuzz/check_reader.h"

static int write_binary(FILE *out, const struct mesh *mesh, struct error *err)
{
    return ply_write(out, mesh, PLY_BIG_ENDIAN, err);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t byte_count)
{
    check_reader(ply_read, write_binary, bytes, byte_count);
    return 0;
}
