/* Any bytes as a class's store: refused with the remedy, or the results in it are whole ones that
 * meshgrade sealed. */
#include "graders/engine/base/files.h"
#include "graders/engine/result/store.h"

#include <limits.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

static char folder[PATH_MAX];

static void remove_folder(void)
{
    folder_remove_work(folder);
}

static void check_error(const struct error *err)
{
    if (!err->text[0])
        abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count)
{
    static const char *const leftovers[] = {"-wal", "-shm", "-journal"};
    char path[PATH_MAX + 32], other[PATH_MAX + 48];
    struct store store;
    struct error err = {""};
    json_t *result = NULL;
    if (!folder[0] && (folder_make_work(folder, &err) != 0 || atexit(remove_folder) != 0))
        abort();
    snprintf(path, sizeof path, "%s/meshgrade.sqlite", folder);
    for (size_t i = 0; i < sizeof leftovers / sizeof *leftovers; i++) {
        snprintf(other, sizeof other, "%s%s", path, leftovers[i]);
        unlink(other);
    }
    if (file_write(path, bytes, count, &err) != 0)
        abort();
    if (store_open(&store, folder, &err) != 0) {
        check_error(&err);
    } else {
        if (store_find(&store, "ana", "euler-closed-mesh", NULL, &result, &err) != 0)
            check_error(&err);
        else if (result && !json_is_object(result))
            abort();
        json_decref(result);
        uint32_t seed;
        err.text[0] = '\0';
        if (store_seed(&store, 1, &seed, &err) != 0)
            check_error(&err);
        err.text[0] = '\0';
        if (store_write_files(&store, folder, &err) != 0)
            check_error(&err);
    }
    store_close(&store);
    return 0;
}
