/* The source files of one submission; see upload_sources.h. */
#include "graders/engine/upload/sources.h"

#include "graders/engine/upload/bundle.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const struct cause file_name = {"file-name", {"file name", "nombre de archivo"}};
static const struct cause too_many_files = {"too-many-files",
                                            {"too many files", "demasiados archivos"}};

static void drop_files(struct upload *upload)
{
    for (int i = 0; i < upload->file_count; i++) {
        free(upload->files[i].name);
        free(upload->files[i].bytes);
    }
    free(upload->files);
    upload->files = NULL;
    upload->file_count = 0;
}

static void check_name(const char *name, size_t length, const char *shown, struct refusal *refusal)
{
    static const char letters[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-";
    bool is_plain = *name != '.' && *name != '-';
    for (size_t i = 0; i < length; i++)
        is_plain &= name[i] && strchr(letters, name[i]);
    if (length > UPLOAD_NAME_BYTES)
        refuse(refusal, &file_name,
               "The file name \"%s\" is too long: it has %zu characters, at most %d are allowed.",
               "El nombre de archivo \"%s\" es demasiado largo: tiene %zu caracteres y se admiten "
               "como mucho %d.",
               shown, length, UPLOAD_NAME_BYTES);
    if (!is_plain)
        refuse(refusal, &file_name,
               "The file name \"%s\" is not allowed: use letters, digits, . _ and - only.",
               "El nombre de archivo \"%s\" no está permitido: use solo letras, cifras, . _ y -.",
               shown);
}

int upload_take_source(struct upload *upload, const char *name, size_t length, const void *bytes,
                       size_t count, struct error *err)
{
    char shown[REFUSAL_NAME];
    struct refusal *refusal = &upload->refusal;
    refusal_name(shown, name, length);
    check_name(name, length, shown, refusal);
    for (int i = 0; i < upload->file_count; i++)
        if (strlen(upload->files[i].name) == length &&
            strncasecmp(upload->files[i].name, name, length) == 0)
            refuse(refusal, &upload_file_twice, "Two files are called %s.",
                   "Dos archivos se llaman %s.", shown);
    if (upload->file_count == UPLOAD_FILES)
        refuse(refusal, &too_many_files, "More than %d source files.", "Más de %d archivos fuente.",
               UPLOAD_FILES);
    if (refusal->refused)
        return 0;
    struct upload_file *larger =
        realloc(upload->files, (size_t)(upload->file_count + 1) * sizeof *larger);
    if (!larger)
        return error_set(err, "reading submissions: out of memory");
    upload->files = larger;
    struct upload_file *file = &upload->files[upload->file_count];
    file->name = strndup(name, length);
    file->bytes = malloc(count ? count : 1);
    if (!file->name || !file->bytes) {
        free(file->name);
        free(file->bytes);
        return error_set(err, "reading submissions: out of memory");
    }
    file->name[length - 1] |= 32; /* gcc takes .C for C++ */
    file->count = count;
    if (count)
        memcpy(file->bytes, bytes, count);
    upload->file_count++;
    return 0;
}

static int compare_files(const void *a, const void *b)
{
    return strcmp(((const struct upload_file *)a)->name, ((const struct upload_file *)b)->name);
}

void upload_settle(struct upload *upload)
{
    bool has_code = false;
    for (int i = 0; i < upload->file_count; i++) {
        const char *name = upload->files[i].name;
        has_code |= name[strlen(name) - 1] == 'c';
    }
    if (!has_code)
        refuse(&upload->refusal, &upload_no_source, "There is no .c file.",
               "No hay ningún archivo .c.");
    if (upload->refusal.refused)
        drop_files(upload);
    if (upload->file_count)
        qsort(upload->files, (size_t)upload->file_count, sizeof *upload->files, compare_files);
}

void upload_release(struct upload *upload)
{
    drop_files(upload);
    free(upload->student);
    free(upload->student_folder);
    *upload = (struct upload){0};
}
