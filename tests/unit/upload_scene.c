/* Scenes for the tests of uploads; see upload_scene.h. */
#include "tests/unit/upload_scene.h"

#include "graders/engine/upload/archive.h"
#include "graders/engine/upload/upload.h"

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <ftw.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

const char *const upload_scene_exercises[] = {"edge-table-any", "mesh-area", "memory-strips", NULL};

static char top[64];

/* ---------------------------------------------------------------- making uploads */

const char *upload_scene_path(const char *name)
{
    static char paths[4][256];
    static int next;
    char *path = paths[next++ % 4];
    snprintf(path, sizeof paths[0], "%s/%s", top, name);
    return path;
}

void upload_scene_write(const char *path, const void *bytes, size_t count)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, count, file), count);
    assert_int_equal(fclose(file), 0);
}

/* Writes a file below the top folder, making folders on the way. */
void upload_scene_put(const char *name, const char *content)
{
    char path[256];
    snprintf(path, sizeof path, "%s", upload_scene_path(name));
    for (char *slash = path + strlen(top) + 1; (slash = strchr(slash, '/')); slash++) {
        *slash = '\0';
        mkdir(path, 0700);
        *slash = '/';
    }
    upload_scene_write(path, content, strlen(content));
}

/* Packs items; the format by the ending of `name`. Returns the size. */
size_t upload_scene_pack(const char *name, const struct upload_item *items, void *into,
                         size_t capacity)
{
    struct archive *a = archive_write_new();
    size_t used = 0;
    bool is_zip = strstr(name, ".zip");
    assert_int_equal(is_zip ? archive_write_set_format_zip(a) : archive_write_set_format_pax(a), 0);
    if (strstr(name, "gz"))
        assert_int_equal(archive_write_add_filter_gzip(a), 0);
    if (strstr(name, "xz"))
        assert_int_equal(archive_write_add_filter_xz(a), 0);
    if (strstr(name, "bz2"))
        assert_int_equal(archive_write_add_filter_bzip2(a), 0);
    archive_write_set_bytes_in_last_block(a, 1);
    assert_int_equal(archive_write_open_memory(a, into, capacity, &used), 0);
    for (; items->path; items++) {
        struct archive_entry *entry = archive_entry_new();
        size_t bytes = items->bytes ? items->bytes : items->content ? strlen(items->content) : 0;
        archive_entry_set_pathname(entry, items->path);
        archive_entry_set_filetype(entry, items->type ? items->type : AE_IFREG);
        archive_entry_set_perm(entry, 0644);
        if (items->is_hardlink)
            archive_entry_set_hardlink(entry, items->content);
        else if (items->type == AE_IFLNK)
            archive_entry_set_symlink(entry, items->content);
        else
            archive_entry_set_size(entry, (la_int64_t)bytes);
        assert_true(archive_write_header(a, entry) >= ARCHIVE_WARN);
        if (!items->type && !items->is_hardlink && bytes)
            assert_int_equal(archive_write_data(a, items->content, bytes), bytes);
        archive_entry_free(entry);
    }
    assert_int_equal(archive_write_close(a), 0);
    archive_write_free(a);
    return used;
}

static char packed[8 << 20];

void upload_scene_put_archive(const char *name, const struct upload_item *items)
{
    size_t count = upload_scene_pack(name, items, packed, sizeof packed);
    upload_scene_put(name, "");
    upload_scene_write(upload_scene_path(name), packed, count);
}

/* ---------------------------------------------------------------- expecting */

/* Reads paths below the top folder and renders the list: "student/exercise: file file; ...", with
 * the cause in brackets for what is refused. */
const char *upload_scene_summary(const char *exercise, const char *names)
{
    static char text[8192];
    char list_of_names[1024], kept[16][256];
    const char *paths[16];
    int count = 0;
    snprintf(list_of_names, sizeof list_of_names, "%s", names);
    for (char *name = strtok(list_of_names, " "); name; name = strtok(NULL, " ")) {
        snprintf(kept[count], sizeof kept[0], "%s/%s", top, name);
        paths[count] = kept[count];
        count++;
    }
    struct upload_list list;
    struct error err = {0};
    size_t used = 0;
    text[0] = '\0';
    if (upload_read(paths, count, upload_scene_exercises, exercise, &list, &err))
        snprintf(text, sizeof text, "error");
    for (int i = 0; i < list.count && used < sizeof text; i++) {
        const struct upload *u = &list.uploads[i];
        used += (size_t)snprintf(text + used, sizeof text - used, "%s%s/%s:", i ? "; " : "",
                                 u->student_folder, u->exercise ? u->exercise : "?");
        if (u->refusal.refused)
            used += (size_t)snprintf(text + used, sizeof text - used, " [%s]", u->refusal.cause);
        for (int f = 0; f < u->file_count; f++)
            used += (size_t)snprintf(text + used, sizeof text - used, " %s", u->files[f].name);
    }
    upload_list_release(&list);
    return text;
}

void upload_scene_expect(const char *exercise, const char *names, const char *summary)
{
    assert_string_equal(upload_scene_summary(exercise, names), summary);
}

static int remove_one(const char *path, const struct stat *status, int type, struct FTW *at)
{
    (void)status;
    (void)type;
    (void)at;
    return remove(path);
}

int upload_scene_make(void **state)
{
    (void)state;
    snprintf(top, sizeof top, "/tmp/test_upload.XXXXXX");
    return mkdtemp(top) ? 0 : -1;
}

int upload_scene_remove(void **state)
{
    (void)state;
    return nftw(top, remove_one, 16, FTW_DEPTH | FTW_PHYS);
}
