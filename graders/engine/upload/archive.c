/* Reading archives with libarchive; see archive.h. */
#include "graders/engine/upload/archive.h"

#include "graders/engine/upload/upload.h"

#include <archive.h>
#include <archive_entry.h>
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static const struct cause archive_too_large = {
    "archive-too-large", {"archive too large", "archivo comprimido demasiado grande"}};
static const struct cause archive_ratio = {"archive-ratio",
                                           {"excessive compression", "compresión excesiva"}};
static const struct cause archive_link = {"archive-link",
                                          {"archive with links", "archivo comprimido con enlaces"}};
static const struct cause archive_device = {
    "archive-device", {"archive with devices", "archivo comprimido con dispositivos"}};
static const struct cause archive_encrypted = {"archive-encrypted",
                                               {"encrypted archive", "archivo comprimido cifrado"}};
static const struct cause archive_nested = {"archive-nested",
                                            {"nested archives", "archivos comprimidos anidados"}};
static const struct cause archive_too_many = {
    "archive-too-many",
    {"archive with too many files", "archivo comprimido con demasiados archivos"}};
static const struct cause archive_path = {"archive-path",
                                          {"path not allowed", "ruta no permitida"}};
static const struct cause archive_unread = {
    "archive-unread",
    {"archive not read to its end", "archivo comprimido sin leer hasta el final"}};

struct unpacking {
    struct archive *archive;
    int64_t packed_bytes; /* size of the archive itself */
    int64_t unpacked_bytes;
    int entries, nesting;
    bool is_class; /* it may hold the uploads of many students */
    const char *prefix;
    struct bundle *bundle;
    struct error *err;
};

/* ---------------------------------------------------------------- refusals */

/* Adds a file that stands for the refusal: of the entry `path`, or of the whole archive. */
static int add_refused(struct unpacking *u, const char *path, const struct refusal *refusal)
{
    return bundle_add(u->bundle, path, NULL, 0, refusal, u->err);
}

static void refuse_entry(struct refusal *refusal, const struct cause *cause, const char *entry,
                         const char *en, const char *es)
{
    char shown[REFUSAL_NAME];
    struct message message;
    message_say(&message, "archive: %s: ", "archivo comprimido: %s: ",
                refusal_name(shown, entry, strlen(entry)));
    message_add_phrase(&message, (struct phrase){en, es});
    refuse_saying(refusal, cause, &message);
}

static void refuse_archive(struct refusal *refusal, const struct cause *cause, const char *en,
                           const char *es)
{
    struct message message;
    message_say(&message, "archive: ", "archivo comprimido: ");
    message_add_phrase(&message, (struct phrase){en, es});
    refuse_saying(refusal, cause, &message);
}

/* ---------------------------------------------------------------- one entry */

/* Of an archive of a class each entry is looked at by itself: the sum is everybody's. */
static void check_amount(const struct unpacking *u, int64_t size, const char *name,
                         struct refusal *refusal)
{
    int64_t unpacked_bytes = u->is_class ? size : u->unpacked_bytes;
    bool is_too_large = unpacked_bytes > ARCHIVE_UNPACKED_BYTES;
    bool is_bomb = unpacked_bytes > ARCHIVE_RATIO_FREE_BYTES &&
                   unpacked_bytes / ARCHIVE_RATIO > u->packed_bytes;
    if (u->is_class && is_too_large)
        refuse_entry(refusal, &archive_too_large, name, "more than 1 GB.", "más de 1 GB.");
    else if (u->is_class && is_bomb)
        refuse_entry(refusal, &archive_ratio, name,
                     "it unpacks to more than 200 times the whole archive (a bomb?).",
                     "descomprimido ocupa más de 200 veces el archivo entero (¿una bomba?).");
    else if (is_too_large)
        refuse_archive(refusal, &archive_too_large, "it unpacks to more than 1 GB.",
                       "descomprimido ocupa más de 1 GB.");
    else if (is_bomb)
        refuse_archive(refusal, &archive_ratio,
                       "it unpacks to more than 200 times its size (an archive bomb?).",
                       "descomprimido ocupa más de 200 veces su tamaño (¿una bomba?).");
}

/* Looks at an entry's header. Refuses what no honest upload holds. */
static void check_entry(struct unpacking *u, struct archive_entry *entry, const char *name,
                        struct refusal *refusal)
{
    const mode_t type = archive_entry_filetype(entry);
    if (archive_entry_hardlink(entry) || type == AE_IFLNK)
        refuse_entry(refusal, &archive_link, name, "links are not allowed.",
                     "no se permiten enlaces.");
    else if (type != AE_IFREG && type != AE_IFDIR)
        refuse_entry(refusal, &archive_device, name, "only plain files are allowed.",
                     "solo se permiten archivos normales.");
    else if (archive_entry_is_encrypted(entry))
        refuse_entry(refusal, &archive_encrypted, name, "encrypted; pack it without a password.",
                     "cifrado; comprímalo sin contraseña.");
    else
        check_amount(u, archive_entry_size(entry), name, refusal);
}

/* Reads the entry's content, at most `limit` bytes. Returns 0; 1 when refused; -1 and *err. */
static int read_content(struct unpacking *u, const char *name, size_t limit, unsigned char **bytes,
                        size_t *count, struct refusal *refusal)
{
    size_t capacity = 0;
    *bytes = NULL;
    *count = 0;
    for (;;) {
        if (*count == capacity) {
            size_t larger = capacity ? 2 * capacity : 16384;
            unsigned char *moved = realloc(*bytes, larger);
            if (!moved) {
                free(*bytes);
                return error_set(u->err, "out of memory");
            }
            *bytes = moved;
            capacity = larger;
        }
        la_ssize_t got = archive_read_data(u->archive, *bytes + *count, capacity - *count);
        if (got == 0)
            return 0;
        if (got < 0) {
            refuse_entry(refusal, &upload_archive_broken, name, "cannot be unpacked: damaged.",
                         "no se puede descomprimir: está dañado.");
            refusal->is_fault = u->is_class; /* packed by no student */
        } else if (*count + (size_t)got > limit)
            refuse_entry(refusal, &upload_file_too_large, name, "too large.", "demasiado grande.");
        if (refusal->refused) {
            free(*bytes);
            *bytes = NULL;
            *count = 0;
            return 1;
        }
        *count += (size_t)got;
    }
}

static int open_nested(struct unpacking *u, const char *path, const unsigned char *bytes,
                       size_t count)
{
    char prefix[BUNDLE_PATH_BYTES];
    size_t stem = bundle_archive_stem(path);
    memcpy(prefix, path, stem);
    prefix[stem] = '\0';
    return archive_read_bytes(bytes, count, u->nesting + 1, prefix, u->bundle, u->err);
}

/* Takes one regular file, already named `path` in the bundle. */
static int take_file(struct unpacking *u, const char *path)
{
    enum bundle_kind kind = bundle_kind(path);
    struct refusal refusal = {0};
    if (kind == BUNDLE_JUNK)
        return 0;
    if (kind == BUNDLE_OTHER_ARCHIVE)
        refuse_entry(&refusal, &upload_archive_kind, path, "pack it as .zip or .tar.gz.",
                     "comprímalo como .zip o .tar.gz.");
    if (kind == BUNDLE_ARCHIVE && u->nesting + 1 >= ARCHIVE_NESTING)
        refuse_entry(&refusal, &archive_nested, path, "an archive in an archive in an archive.",
                     "un archivo comprimido dentro de otro y de otro.");
    if (kind == BUNDLE_OTHER || refusal.refused)
        return add_refused(u, path, &refusal);
    unsigned char *bytes;
    size_t count;
    size_t limit = kind == BUNDLE_SOURCE ? (size_t)UPLOAD_FILE_BYTES : (size_t)ARCHIVE_NESTED_BYTES;
    int result = read_content(u, path, limit, &bytes, &count, &refusal);
    if (result < 0)
        return -1;
    if (result > 0)
        return add_refused(u, path, &refusal);
    if (kind != BUNDLE_ARCHIVE)
        return bundle_add(u->bundle, path, bytes, count, NULL, u->err);
    result = open_nested(u, path, bytes, count);
    free(bytes);
    return result;
}

/* A path that is refused, of an archive of a class: the folder that it is said to lie in, as far as
 * there can be such a folder, bears the refusal. Returns 0; 1: there is none; -1 and *err. */
static int refuse_owner(struct unpacking *u, const char *name, const struct refusal *refusal)
{
    char owner[BUNDLE_PATH_BYTES], path[BUNDLE_PATH_BYTES];
    size_t length = strlen(name);
    if (!u->is_class || length >= sizeof owner)
        return 1;
    memcpy(owner, name, length + 1);
    while (length > 0) {
        while (length > 0 && owner[length - 1] != '/' && owner[length - 1] != '\\')
            length--;
        if (length == 0)
            return 1;
        owner[--length] = '\0';
        if (bundle_join(path, u->prefix, owner) == 0)
            return add_refused(u, path, refusal);
    }
    return 1;
}

/* Counts an entry. Returns 1 when there are too many of them or of their bytes (`refusal`). */
static int count_entry(struct unpacking *u, int64_t size, struct refusal *refusal)
{
    int most = u->is_class  ? ARCHIVE_CLASS_ENTRIES
               : u->nesting ? (int)ARCHIVE_NESTED_ENTRIES
                            : (int)BUNDLE_ENTRIES;
    u->unpacked_bytes += size > 0 && size < INT64_MAX / 4 ? size : size > 0 ? INT64_MAX / 4 : 0;
    if (++u->entries > most)
        refuse_archive(refusal, &archive_too_many, "it holds too many files.",
                       "contiene demasiados archivos.");
    /* Entries that are passed over cost nothing in a zip, and their unpacking in a tar. */
    else if (u->is_class && u->unpacked_bytes > ARCHIVE_CLASS_BYTES &&
             archive_format(u->archive) != ARCHIVE_FORMAT_ZIP)
        refuse_archive(refusal, &archive_too_large,
                       "it unpacks to more than 4 GB: pack it as .zip.",
                       "descomprimido ocupa más de 4 GB: comprímalo como .zip.");
    return refusal->refused;
}

/* Returns 0; 1 when the whole archive is refused (`refusal`); -1 and *err. */
static int take_entry(struct unpacking *u, struct archive_entry *entry, struct refusal *refusal)
{
    char path[BUNDLE_PATH_BYTES];
    const char *name = archive_entry_pathname(entry);
    const bool is_folder = archive_entry_filetype(entry) == AE_IFDIR;
    if (count_entry(u, archive_entry_size(entry), refusal))
        return 1;
    if (name && is_folder && strspn(name, "./") == strlen(name) && !strstr(name, ".."))
        return 0; /* the archive's own top: "./" */
    struct refusal of_entry = {0};
    if (!name || bundle_join(path, u->prefix, name)) {
        refuse_entry(&of_entry, &archive_path, name ? name : "?",
                     "absolute, upward, empty and very long paths are not allowed.",
                     "no se permiten rutas absolutas, hacia arriba, vacías o muy largas.");
        int result = name ? refuse_owner(u, name, &of_entry) : 1;
        if (result == 1)
            *refusal = of_entry;
        return result;
    }
    check_entry(u, entry, name, &of_entry);
    if (!u->is_class && (strcmp(of_entry.cause, archive_ratio.slug) == 0 ||
                         strcmp(of_entry.cause, archive_too_large.slug) == 0)) {
        *refusal = of_entry;
        return 1;
    }
    if (of_entry.refused)
        return bundle_kind(path) == BUNDLE_JUNK ? 0 : add_refused(u, path, &of_entry);
    return is_folder ? 0 : take_file(u, path);
}

/* ---------------------------------------------------------------- one archive */

static struct archive *new_reader(struct error *err)
{
    struct archive *archive = archive_read_new();
    if (!archive) {
        error_set(err, "out of memory");
        return NULL;
    }
    archive_read_support_format_zip(archive);
    archive_read_support_format_tar(archive);
    archive_read_support_filter_gzip(archive);
    archive_read_support_filter_bzip2(archive);
    archive_read_support_filter_xz(archive);
    return archive;
}

/* The archive of a class that could be read in part: what was read stays. */
static void keep_what_was_read(const struct unpacking *u, struct refusal *refusal)
{
    struct message message = refusal->message;
    if (!u->is_class || !refusal->refused || u->bundle->count == 0 ||
        strcmp(refusal->cause, archive_path.slug) == 0)
        return;
    message_add(&message,
                " What comes after it was not read: pack it anew without what is at fault, and "
                "grade again.",
                " Lo que sigue no se leyó: comprímalo de nuevo, sin lo que falla, y corríjalo otra "
                "vez.");
    *refusal = (struct refusal){0};
    refuse_saying(refusal, &archive_unread, &message);
    refusal->is_fault = true;
}

static int take_entries(struct unpacking *u, bool is_open)
{
    struct refusal refusal = {0};
    struct archive_entry *entry;
    int status = is_open ? ARCHIVE_OK : ARCHIVE_FATAL, result = 0;
    while (result == 0 && status >= ARCHIVE_WARN) {
        status = archive_read_next_header(u->archive, &entry);
        if (status >= ARCHIVE_WARN && status != ARCHIVE_EOF)
            result = take_entry(u, entry, &refusal);
        if (status == ARCHIVE_EOF)
            break;
    }
    if (result < 0)
        return -1;
    if (status != ARCHIVE_EOF && result == 0)
        refuse_archive(&refusal, &upload_archive_broken, "it is damaged or of an unknown kind.",
                       "está dañado o es de un tipo desconocido.");
    else if (result == 0 && u->entries == 0)
        refuse_archive(&refusal, &upload_archive_broken, "it is empty.", "está vacío.");
    keep_what_was_read(u, &refusal);
    return refusal.refused ? add_refused(u, u->prefix, &refusal) : 0;
}

/* Names in archives are UTF-8 or bytes; libarchive asks the locale what that means. */
static int unpack(struct unpacking *u, int fd, const void *bytes, size_t count)
{
    u->archive = new_reader(u->err);
    if (!u->archive)
        return -1;
    locale_t utf8 = newlocale(LC_CTYPE_MASK, "C.UTF-8", (locale_t)0);
    locale_t before = utf8 ? uselocale(utf8) : (locale_t)0;
    int status = fd >= 0 ? archive_read_open_fd(u->archive, fd, 65536)
                         : archive_read_open_memory(u->archive, bytes, count);
    int result = take_entries(u, status == ARCHIVE_OK);
    archive_read_free(u->archive);
    if (utf8) {
        uselocale(before);
        freelocale(utf8);
    }
    return result;
}

int archive_read_fd(int fd, const char *prefix, struct bundle *bundle, struct error *err)
{
    struct stat status;
    struct unpacking u = {.prefix = prefix, .is_class = !*prefix, .bundle = bundle, .err = err};
    if (fstat(fd, &status))
        return error_set(err, "cannot look at the archive");
    u.packed_bytes = status.st_size;
    return unpack(&u, fd, NULL, 0);
}

int archive_read_bytes(const void *bytes, size_t count, int nesting, const char *prefix,
                       struct bundle *bundle, struct error *err)
{
    struct unpacking u = {.packed_bytes = (int64_t)count,
                          .nesting = nesting,
                          .prefix = prefix,
                          .bundle = bundle,
                          .err = err};
    return unpack(&u, -1, bytes, count);
}
