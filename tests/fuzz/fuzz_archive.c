/* Any bytes as an uploaded archive: no crash, no path that leaves the bundle, and no file that
 * breaks the promises about names and sizes. The whole way from the archive to submissions is
 * taken. */
#include "graders/engine/upload/archive.h"
#include "graders/engine/upload/names.h"
#include "graders/engine/upload/students.h"
#include "graders/engine/upload/upload.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

static const char *const exercises[] = {"edge-table-any", "mesh-area", NULL};

static void check_path(const char *path)
{
    if (path[0] == '/' || strlen(path) >= BUNDLE_PATH_BYTES)
        abort();
    for (const char *step = path; *step; step += strcspn(step, "/") + (strchr(step, '/') != NULL)) {
        size_t length = strcspn(step, "/");
        if (length == 0 || length > BUNDLE_NAME_BYTES ||
            (length == 2 && memcmp(step, "..", 2) == 0))
            abort();
    }
}

static void check_upload(const struct upload *upload)
{
    const struct refusal *refusal = &upload->refusal;
    char slug[NAMES_SLUG];
    names_slug(slug, upload->student);
    if (refusal->refused != (upload->file_count == 0) ||
        refusal->refused != (refusal->cause[0] != 0))
        abort();
    for (int i = 0; i < upload->file_count; i++) {
        const char *name = upload->files[i].name;
        if (strspn(name, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-") !=
                strlen(name) ||
            name[0] == '.' || name[0] == '-' || upload->files[i].count > UPLOAD_FILE_BYTES)
            abort();
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count)
{
    struct bundle bundle = {0};
    struct upload_list list = {0};
    struct roster roster = {.list = &list};
    const struct origin origin = {
        .exercises = exercises, .only = count % 7 == 0 ? 1 : -1, .base = "class", .parent = "top"};
    struct error err = {0};
    if (archive_read_bytes(bytes, count, 0, "", &bundle, &err) == 0) {
        for (int i = 0; i < bundle.count; i++)
            check_path(bundle.files[i].path);
        if (students_find(&bundle, &origin, &roster, &err))
            abort();
        for (int i = 0; i < list.count; i++)
            check_upload(&list.uploads[i]);
    } else if (!err.text[0]) {
        abort();
    }
    upload_list_release(&list);
    free(roster.students);
    bundle_release(&bundle);
    return 0;
}
