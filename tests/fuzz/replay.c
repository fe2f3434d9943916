/* Runs a fuzz target once over each file given, without libFuzzer: the saved corpus as a test.
 * Linked with one target and check_reader.c:  replay-ply tests/fuzz/corpus/ply/ascii.ply ...
 *
 * Exit code 0: every file was run; a target that finds a fault aborts. 2: a file cannot be read. */
#include "tests/fuzz/check_reader.h"

#include <stdlib.h>

enum { FILE_LIMIT = 1 << 24 };

/* A buffer of exactly the file's size, so that sanitizers see reads behind its end. */
static int replay(const char *path)
{
    FILE *file = fopen(path, "rb");
    uint8_t *buffer = malloc(FILE_LIMIT);
    size_t count = file && buffer ? fread(buffer, 1, FILE_LIMIT, file) : 0;
    int failed = !file || !buffer || ferror(file) || count == FILE_LIMIT;
    if (file)
        fclose(file);
    if (!failed) {
        uint8_t *exact = realloc(buffer, count > 0 ? count : 1);
        buffer = exact ? exact : buffer;
        LLVMFuzzerTestOneInput(buffer, count);
    }
    free(buffer);
    return failed;
}

int main(int argument_count, char **arguments)
{
    for (int i = 1; i < argument_count; i++)
        if (replay(arguments[i])) {
            fprintf(stderr, "replay: cannot read %s\n", arguments[i]);
            return 2;
        }
    printf("replay: %d inputs, no fault\n", argument_count - 1);
    return 0;
}
