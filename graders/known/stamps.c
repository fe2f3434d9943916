/* Remembers what got its verdict; see stamps.h. */
#include "graders/known/stamps.h"

#include "graders/box/box.h"
#include "graders/engine/base/files.h"
#include "graders/engine/build/compiler.h"
#include "reference/base/listing.h"

#include <fcntl.h>
#include <limits.h>
#include <nettle/sha2.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/utsname.h>
#include <unistd.h>

enum { PART_BYTES = 1 << 28, STAMP_FILE = 4096 };

/* The form of a stamp, and what counts as a pass: raise it when either changes. */
static const char form[] = "meshgrade stamp 1";

/* --------------------------------------------------------------------- hash */

/* A part, with its length in front, so that no two lists of parts give the same bytes. */
static void add(struct sha256_ctx *hash, const void *bytes, size_t count)
{
    uint64_t length = count;
    sha256_update(hash, sizeof length, (const uint8_t *)&length);
    sha256_update(hash, count, bytes);
}

static void add_text(struct sha256_ctx *hash, const char *text)
{
    add(hash, text, strlen(text));
}

static void finish(struct sha256_ctx *hash, char key[STAMP_KEY])
{
    uint8_t digest[SHA256_DIGEST_SIZE];
    sha256_digest(hash, sizeof digest, digest);
    for (int i = 0; i < SHA256_DIGEST_SIZE; i++)
        snprintf(key + 2 * (ptrdiff_t)i, 3, "%02x", digest[i]);
}

static int add_file(struct sha256_ctx *hash, const char *path, struct error *err)
{
    char *bytes;
    size_t count;
    if (file_read(path, PART_BYTES, &bytes, &count, err) != 0)
        return -1;
    add(hash, bytes, count);
    free(bytes);
    return 0;
}

/* The bytes of the program that runs, also when its file was replaced meanwhile. */
static int add_program(struct sha256_ctx *hash, struct error *err)
{
    uint8_t bytes[1 << 16];
    ssize_t got = 0;
    int descriptor = open("/proc/self/exe", O_RDONLY | O_CLOEXEC);
    while (descriptor >= 0 && (got = read(descriptor, bytes, sizeof bytes)) > 0)
        sha256_update(hash, (size_t)got, bytes);
    if (descriptor >= 0)
        close(descriptor);
    return descriptor >= 0 && got == 0 ? 0 : error_set(err, "/proc/self/exe: cannot be read");
}

static bool is_statement(const char *name)
{
    size_t length = strlen(name);
    return length > 3 && strcmp(name + length - 3, ".md") == 0;
}

/* The names and bytes of a folder's files; statements, which are for people, are left out. */
static int add_files(struct sha256_ctx *hash, const char *folder, struct error *err)
{
    char **names = listing_files(folder, "", err);
    int result = names ? 0 : -1;
    for (size_t i = 0; result == 0 && names[i]; i++) {
        char path[PATH_MAX];
        if (is_statement(names[i]))
            continue;
        snprintf(path, sizeof path, "%s/%s", folder, names[i]);
        add_text(hash, names[i]);
        result = add_file(hash, path, err);
    }
    free(names);
    return result;
}

/* ------------------------------------------------------------ circumstances */

/* Where a tool is found, and which file it is: hashing gcc itself would take longer. */
static void add_tool(struct sha256_ctx *hash, const char *name)
{
    const char *path = getenv("PATH");
    char *paths = strdup(path ? path : ""), *rest = paths;
    for (char *folder; paths && (folder = strsep(&rest, ":")) != NULL;) {
        char file[PATH_MAX], whole[PATH_MAX];
        struct stat status;
        snprintf(file, sizeof file, "%s/%s", folder, name);
        if (access(file, X_OK) != 0 || !realpath(file, whole) || stat(whole, &status) != 0)
            continue;
        add_text(hash, whole);
        add(hash, &status.st_size, sizeof status.st_size);
        add(hash, &status.st_mtim, sizeof status.st_mtim);
        break;
    }
    free(paths);
}

int stamps_machine(char machine[STAMP_KEY], struct error *err)
{
    const char *const tools[] = {compiler_name(), "as", "ld", "objcopy", "valgrind"};
    struct sha256_ctx hash;
    struct utsname name = {0};
    struct box_probe layers[BOX_LAYER_COUNT];
    unsigned user = geteuid();
    sha256_init(&hash);
    add_text(&hash, form);
    if (add_program(&hash, err) != 0 || add_file(&hash, "/var/lib/dpkg/status", err) != 0)
        return -1;
    uname(&name);
    add_text(&hash, name.release);
    add_text(&hash, name.version);
    add_text(&hash, name.machine);
    add(&hash, &user, sizeof user);
    for (size_t i = 0; i < sizeof tools / sizeof *tools; i++)
        add_tool(&hash, tools[i]);
    box_probe_layers(layers);
    for (int i = 0; i < BOX_LAYER_COUNT; i++)
        add(&hash, &layers[i].works, sizeof layers[i].works);
    finish(&hash, machine);
    return 0;
}

static int add_runner(struct sha256_ctx *hash, const char *root, const struct exercise *exercise,
                      struct error *err)
{
    static const char *const flavours[] = {"plain", "sanitized", "checked"};
    for (int i = 0; i < 3; i++) {
        char path[PATH_MAX];
        if (snprintf(path, sizeof path, "%s/build/runner/%s/%s.%s.o", root, exercise->group,
                     exercise->name, flavours[i]) >= (int)sizeof path)
            return error_set(err, "%s: the path is too long", root);
        if (add_file(hash, path, err) != 0)
            return -1;
    }
    return 0;
}

int stamps_open(const char *root, const struct exercise *exercise, uint32_t seed,
                const char machine[STAMP_KEY], struct stamps *stamps, struct error *err)
{
    struct sha256_ctx hash;
    char reference[PATH_MAX], models[PATH_MAX];
    snprintf(reference, sizeof reference, "%s/reference/answers/%s/%s.c", root, exercise->group,
             exercise->name);
    snprintf(models, sizeof models, "%s/exercises/models", root);
    if (snprintf(stamps->folder, sizeof stamps->folder, "%s/build/validated/%s", root,
                 exercise->name) >= (int)sizeof stamps->folder)
        return error_set(err, "%s: the path is too long", root);
    sha256_init(&hash);
    add_text(&hash, machine);
    add_text(&hash, exercise->name);
    add(&hash, &seed, sizeof seed);
    if (add_file(&hash, reference, err) != 0 || add_files(&hash, models, err) != 0 ||
        add_files(&hash, exercise->folder, err) != 0 || add_runner(&hash, root, exercise, err) != 0)
        return -1;
    finish(&hash, stamps->circumstances);
    return 0;
}

/* ------------------------------------------------------------------- stamps */

static int stamp_path(const struct stamps *stamps, const struct known_submission *submission,
                      char path[PATH_MAX])
{
    return snprintf(path, PATH_MAX, "%s/%s", stamps->folder, submission->file) < PATH_MAX ? 0 : -1;
}

static void stamp_key(const struct stamps *stamps, const struct known_submission *submission,
                      char key[STAMP_KEY])
{
    struct sha256_ctx hash;
    sha256_init(&hash);
    add_text(&hash, stamps->circumstances);
    add_text(&hash, submission->file);
    add(&hash, submission->text, submission->count);
    finish(&hash, key);
}

bool stamps_hold(const struct stamps *stamps, const struct known_submission *submission,
                 char text[STAMP_TEXT])
{
    char path[PATH_MAX], key[STAMP_KEY], *bytes;
    size_t count;
    stamp_key(stamps, submission, key);
    if (stamp_path(stamps, submission, path) != 0 ||
        file_read(path, STAMP_FILE, &bytes, &count, NULL) != 0)
        return false;
    bool holds = count > STAMP_KEY && strncmp(bytes, key, STAMP_KEY - 1) == 0 &&
                 bytes[STAMP_KEY - 1] == '\n' && bytes[count - 1] == '\n' &&
                 count - STAMP_KEY <= STAMP_TEXT;
    if (holds)
        snprintf(text, STAMP_TEXT, "%.*s", (int)(count - STAMP_KEY - 1), bytes + STAMP_KEY);
    free(bytes);
    return holds;
}

int stamps_put(const struct stamps *stamps, const struct known_submission *submission,
               const char *text, struct error *err)
{
    char path[PATH_MAX], key[STAMP_KEY], stamp[STAMP_FILE];
    stamp_key(stamps, submission, key);
    if (stamp_path(stamps, submission, path) != 0)
        return error_set(err, "%s: the path is too long", stamps->folder);
    *strrchr(path, '/') = '\0';
    if (folder_make(path, err) != 0 || stamp_path(stamps, submission, path) != 0)
        return -1;
    int length = snprintf(stamp, sizeof stamp, "%s\n%s\n", key, text);
    return file_write(path, stamp, (size_t)length, err);
}

void stamps_remove(const struct stamps *stamps, const struct known_submission *submission)
{
    char path[PATH_MAX];
    if (stamp_path(stamps, submission, path) == 0)
        unlink(path);
}
