/* Bundles; see bundle.h. */
#include "graders/engine/upload/bundle.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

const struct cause upload_archive_broken = {"archive-broken",
                                            {"broken archive", "archivo comprimido dañado"}};
const struct cause upload_archive_kind = {"archive-kind",
                                          {"kind of archive", "tipo de archivo comprimido"}};
const struct cause upload_file_too_large = {"file-too-large",
                                            {"file too large", "archivo demasiado grande"}};
const struct cause upload_file_twice = {"file-twice", {"handed in twice", "entregado dos veces"}};
const struct cause upload_no_source = {"no-source", {"no source file", "sin archivo fuente"}};
static const struct cause folder_too_large = {"folder-too-large",
                                              {"folder too large", "carpeta demasiado grande"}};

/* A folder that weighs less is never let go: no class consists of such. */
enum { SHED_BYTES = 8 << 20 };

static const char *const archive_endings[] = {".zip", ".tar",     ".tar.gz", ".tgz", ".tar.xz",
                                              ".txz", ".tar.bz2", ".tbz2",   ".tbz", NULL};
static const char *const other_archive_endings[] = {".rar", ".7z",  ".gz", ".xz",
                                                    ".bz2", ".zst", NULL};
static const char *const junk_names[] = {"__MACOSX", ".DS_Store", "Thumbs.db", "desktop.ini",
                                         ".git",     ".vscode",   ".idea",     NULL};

/* The listed ending that `path` has; the longest comes to more than its last dot. */
static const char *ending_of(const char *path, const char *const *endings)
{
    const size_t length = strlen(path);
    const char *found = NULL;
    for (; *endings; endings++) {
        size_t bytes = strlen(*endings);
        if (length > bytes && strcasecmp(path + length - bytes, *endings) == 0 &&
            (!found || bytes > strlen(found)))
            found = *endings;
    }
    return found;
}

static bool has_junk_step(const char *path)
{
    while (*path) {
        size_t length = strcspn(path, "/");
        if (length > 2 && strncmp(path, "._", 2) == 0)
            return true;
        for (const char *const *junk = junk_names; *junk; junk++)
            if (strlen(*junk) == length && strncasecmp(path, *junk, length) == 0)
                return true;
        path += length + (path[length] == '/');
    }
    return false;
}

enum bundle_kind bundle_kind(const char *path)
{
    static const char *const sources[] = {".c", ".h", NULL};
    const char *name = strrchr(path, '/') ? strrchr(path, '/') + 1 : path;
    if (has_junk_step(path))
        return BUNDLE_JUNK;
    if (ending_of(name, sources) || strcasecmp(name, ".c") == 0 || strcasecmp(name, ".h") == 0)
        return BUNDLE_SOURCE;
    if (ending_of(name, archive_endings))
        return BUNDLE_ARCHIVE;
    if (ending_of(name, other_archive_endings))
        return BUNDLE_OTHER_ARCHIVE;
    return strcmp(name, "submission_metadata.yml") == 0 ? BUNDLE_METADATA : BUNDLE_OTHER;
}

size_t bundle_archive_stem(const char *path)
{
    const char *ending = ending_of(path, archive_endings);
    return strlen(path) - (ending ? strlen(ending) : 0);
}

/* Where Moodle's prefix ends in a step, or 0: "Ana Pérez_12345_assignsubmission_file_". */
static size_t moodle_prefix(const char *step, size_t length)
{
    static const char *const marks[] = {"_assignsubmission_file_", "_assignsubmission_onlinetext_"};
    for (size_t m = 0; m < sizeof marks / sizeof marks[0]; m++) {
        const char *mark = memmem(step, length, marks[m], strlen(marks[m]));
        if (mark && mark > step && mark[-1] >= '0' && mark[-1] <= '9')
            return (size_t)(mark - step) + strlen(marks[m]);
    }
    return 0;
}

static int append_step(char out[BUNDLE_PATH_BYTES], const char *step, size_t length)
{
    size_t used = strlen(out);
    if (length > BUNDLE_NAME_BYTES || used + length + 2 > BUNDLE_PATH_BYTES)
        return -1;
    if (used)
        out[used++] = '/';
    memcpy(out + used, step, length);
    out[used + length] = '\0';
    return 0;
}

int bundle_join(char out[BUNDLE_PATH_BYTES], const char *prefix, const char *name)
{
    size_t used = strlen(prefix);
    bool is_drive = *name && name[1] == ':' && (name[2] == '\\' || name[2] == '/');
    if (used >= BUNDLE_PATH_BYTES || !*name || *name == '/' || *name == '\\' || is_drive)
        return -1;
    memcpy(out, prefix, used + 1);
    while (*name) {
        size_t length = strcspn(name, "/\\"), flat = moodle_prefix(name, length);
        if (length == 2 && memcmp(name, "..", 2) == 0)
            return -1;
        if (length == 0 || (length == 1 && *name == '.')) {
            name += length + (name[length] != '\0');
            continue;
        }
        if (flat && flat < length) {
            if (append_step(out, name, flat))
                return -1;
            name += flat;
            continue;
        }
        if (append_step(out, name, length))
            return -1;
        name += length + (name[length] != '\0');
    }
    int depth = 1;
    for (const char *at = out; (at = strchr(at, '/')); at++)
        depth++;
    return out[0] && strlen(out) > used && depth <= BUNDLE_DEPTH ? 0 : -1;
}

static int append_file(struct bundle *bundle, const char *path, unsigned char *bytes, size_t count,
                       const struct refusal *refusal, struct error *err)
{
    if (bundle->count == bundle->capacity) {
        int capacity = bundle->capacity ? 2 * bundle->capacity : 64;
        struct bundle_file *larger =
            realloc(bundle->files, (size_t)capacity * sizeof *bundle->files);
        if (!larger) {
            free(bytes);
            return error_set(err, "out of memory");
        }
        bundle->files = larger;
        bundle->capacity = capacity;
    }
    struct bundle_file *file = &bundle->files[bundle->count];
    *file = (struct bundle_file){.bytes = bytes, .count = count};
    file->path = strdup(path);
    if (!file->path) {
        free(bytes);
        return error_set(err, "out of memory");
    }
    if (refusal)
        file->refusal = *refusal;
    bundle->bytes += (int64_t)count;
    bundle->count++;
    return 0;
}

/* ---------------------------------------------------------------- letting go */

static bool is_below(const char *path, const char *folder, size_t length)
{
    return strncmp(path, folder, length) == 0 && (length == 0 || path[length] == '/');
}

/* What a file takes of both limits, in bytes. */
static int64_t weight_of(const struct bundle_file *file)
{
    return (int64_t)file->count + BUNDLE_BYTES / BUNDLE_ENTRIES;
}

/* Goes on from `folder` into the heaviest of the folders in it, if it weighs as much as to be let
 * go. The bundle is sorted. */
static bool enter_heaviest(const struct bundle *bundle, char folder[BUNDLE_PATH_BYTES])
{
    const size_t length = strlen(folder), from = length + (length > 0);
    const char *heaviest = NULL, *step = NULL;
    size_t heaviest_length = 0, step_length = 0;
    int64_t most = SHED_BYTES - 1, weight = 0;
    for (int i = 0; i < bundle->count; i++) {
        const char *path = bundle->files[i].path;
        if (!is_below(path, folder, length) || !strchr(path + from, '/'))
            continue;
        size_t next = strcspn(path + from, "/");
        if (!step || next != step_length || memcmp(step, path + from, next) != 0) {
            step = path + from;
            step_length = next;
            weight = 0;
        }
        weight += weight_of(&bundle->files[i]);
        if (weight > most) {
            most = weight;
            heaviest = step;
            heaviest_length = step_length;
        }
    }
    if (!heaviest)
        return false;
    memcpy(folder, heaviest - from, from + heaviest_length);
    folder[from + heaviest_length] = '\0';
    return true;
}

static void remove_below(struct bundle *bundle, const char *folder)
{
    int kept = 0;
    for (int i = 0; i < bundle->count; i++) {
        struct bundle_file *file = &bundle->files[i];
        if (!is_below(file->path, folder, strlen(folder))) {
            bundle->files[kept++] = *file;
            continue;
        }
        bundle->bytes -= (int64_t)file->count;
        free(file->path);
        free(file->bytes);
    }
    bundle->count = kept;
}

static int let_go_of_heaviest(struct bundle *bundle, struct error *err)
{
    char folder[BUNDLE_PATH_BYTES] = "", shown[REFUSAL_NAME];
    struct refusal refusal = {0};
    bundle_sort(bundle);
    while (enter_heaviest(bundle, folder))
        continue;
    if (!folder[0])
        return error_set(err, "too much to read: more than %d files or %d MB", BUNDLE_ENTRIES,
                         BUNDLE_BYTES >> 20);
    char *shed = strdup(folder);
    if (!shed)
        return error_set(err, "out of memory");
    free(bundle->shed);
    bundle->shed = shed;
    remove_below(bundle, folder);
    refuse(&refusal, &folder_too_large,
           "%s holds more files or bytes than there is room for: hand in the sources only.",
           "%s contiene más archivos o bytes de los que caben: entregue solo las fuentes.",
           refusal_name(shown, folder, strlen(folder)));
    return append_file(bundle, folder, NULL, 0, &refusal, err);
}

int bundle_add(struct bundle *bundle, const char *path, unsigned char *bytes, size_t count,
               const struct refusal *refusal, struct error *err)
{
    int result = 0;
    bool is_full = bundle->count >= BUNDLE_ENTRIES || bundle->bytes + (int64_t)count > BUNDLE_BYTES;
    bool is_dropped = bundle->shed && is_below(path, bundle->shed, strlen(bundle->shed));
    if (is_full && !is_dropped) {
        result = let_go_of_heaviest(bundle, err);
        is_dropped = result == 0 && is_below(path, bundle->shed, strlen(bundle->shed));
    }
    if (result == 0 && !is_dropped)
        return append_file(bundle, path, bytes, count, refusal, err);
    free(bytes);
    return result;
}

bool bundle_refuses_all(const struct bundle_file *file)
{
    return (strncmp(file->refusal.cause, "archive-", 8) == 0 && !bundle_is_rest(file)) ||
           strncmp(file->refusal.cause, "folder-", 7) == 0;
}

bool bundle_is_rest(const struct bundle_file *file)
{
    return strcmp(file->refusal.cause, "archive-unread") == 0;
}

/* Orders paths so that a folder's files stand together: / comes before every other byte. */
static int compare_steps(const char *a, const char *b)
{
    while (*a && *a == *b) {
        a++;
        b++;
    }
    int x = *a == '/' ? 1 : *a ? 1 + (unsigned char)*a : 0;
    int y = *b == '/' ? 1 : *b ? 1 + (unsigned char)*b : 0;
    return x - y;
}

static int compare_files(const void *a, const void *b)
{
    const struct bundle_file *x = a, *y = b;
    int order = compare_steps(x->path, y->path);
    if (order == 0)
        order = (int)x->refusal.refused - (int)y->refusal.refused;
    if (order == 0)
        order = x->count < y->count ? -1 : x->count > y->count;
    return order || !x->count ? order : memcmp(x->bytes, y->bytes, x->count);
}

void bundle_sort(struct bundle *bundle)
{
    if (bundle->count)
        qsort(bundle->files, (size_t)bundle->count, sizeof *bundle->files, compare_files);
}

void bundle_release(struct bundle *bundle)
{
    for (int i = 0; i < bundle->count; i++) {
        free(bundle->files[i].path);
        free(bundle->files[i].bytes);
    }
    free(bundle->files);
    free(bundle->shed);
    *bundle = (struct bundle){0};
}
