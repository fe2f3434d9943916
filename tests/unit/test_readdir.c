/* A folder whose reading fails half way is an error wherever it is read: what comes after would be
 * lost without a word, students among it. */
#include "graders/engine/base/files.h"
#include "graders/engine/upload/upload.h"
#include "reference/base/listing.h"

#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <limits.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { STUDENTS = 4 };

static char root[PATH_MAX];
static long failing = -1; /* which call of readdir fails; negative: none */
static long calls;

/* Stands in the place of libc's. */
struct dirent *readdir(DIR *folder)
{
    struct dirent *(*real)(DIR *) =
        (__extension__(struct dirent * (*)(DIR *)) dlsym(RTLD_NEXT, "readdir"));
    if (calls++ != failing)
        return real(folder);
    errno = EIO;
    return NULL;
}

static int make_root(void **state)
{
    struct error err = {""};
    (void)state;
    if (folder_make_work(root, &err) != 0)
        return -1;
    for (int i = 0; i < STUDENTS; i++) {
        char path[PATH_MAX + 64];
        snprintf(path, sizeof path, "%s/student-%d", root, i);
        if (folder_make(path, &err) != 0)
            return -1;
        strcat(path, "/mesh-area.c");
        if (file_write(path, "int x;\n", 7, &err) != 0)
            return -1;
    }
    return 0;
}

static int remove_root(void **state)
{
    (void)state;
    folder_remove_work(root);
    return 0;
}

/* Fails each call in turn, until none is left to fail. `read` says how many students it found. */
static void fail_each(int (*read)(struct error *err))
{
    struct error err;
    int found;
    for (failing = 0;; failing++) {
        calls = 0;
        err.text[0] = '\0';
        found = read(&err);
        if (calls <= failing)
            break;
        assert_int_equal(found, -1);
        assert_non_null(strstr(err.text, strerror(EIO)));
    }
    assert_true(failing >= STUDENTS);
    assert_int_equal(found, STUDENTS);
    failing = -1;
}

static int list_students(struct error *err)
{
    char **names = listing_folders(root, err);
    int count = 0;
    while (names && names[count])
        count++;
    free(names);
    return names ? count : -1;
}

static int read_uploads(struct error *err)
{
    const char *const exercises[] = {"mesh-area", NULL};
    const char *paths[] = {root};
    struct upload_list list;
    int result = upload_read(paths, 1, exercises, NULL, &list, err);
    int count = list.count;
    upload_list_release(&list);
    return result == 0 ? count : -1;
}

static void test_listing(void **state)
{
    (void)state;
    fail_each(list_students);
}

static void test_upload(void **state)
{
    (void)state;
    fail_each(read_uploads);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_listing),
        cmocka_unit_test(test_upload),
    };
    return cmocka_run_group_tests(tests, make_root, remove_root);
}
