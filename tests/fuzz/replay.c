/* Runs a fuzz target once over each file given, without libFuzzer: the saved corpus as a test.
 * Linked with one target and check_reader.c:  replay-ply tests/fuzz/corpus/ply/ascii.ply ...
 *
 * Exit code 0: every file was run; a target that finds a fault aborts. 2: a file cannot be read. */
#include "tests/fuzz/check_reader.h"

#include <stdlib.h>
#include <string.h>

enum { FILE_LIMIT = 1 << 24 };

/* The file's bytes in a buffer of exactly their size, so that sanitizers see reads behind its end.
 */
static uint8_t *load(const char *path, size_t *count)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return NULL;
    uint8_t *buffer = malloc(FILE_LIMIT), *exact = NULL;
    *count = buffer ? fread(buffer, 1, FILE_LIMIT, file) : 0;
    if (buffer && !ferror(file) && *count < FILE_LIMIT)
        exact = malloc(*count > 0 ? *count : 1);
    if (exact)
        memcpy(exact, buffer, *count);
    free(buffer);
    fclose(file);
    return exact;
}

int main(int argument_count, char **arguments)
{
    for (int i = 1; i < argument_count; i++) {
        size_t count;
        uint8_t *bytes = load(arguments[i], &count);
        if (!bytes) {
            fprintf(stderr, "replay: cannot read %s\n", arguments[i]);
            return 2;
        }
        LLVMFuzzerTestOneInput(bytes, count);
        free(bytes);
    }
    printf("replay: %d inputs, no fault\n", argument_count - 1);
    return 0;
}
