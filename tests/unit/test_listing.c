/* The names in a folder, whatever characters are in its path. */
#include "graders/engine/base/files.h"
#include "reference/base/listing.h"

#include <errno.h>
#include <limits.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

enum { PATH_BYTES = PATH_MAX + 64 };

static char root[PATH_MAX];

static char *path_of(const char *name, char *path)
{
    snprintf(path, PATH_BYTES, "%s/%s", root, name);
    return path;
}

static void put_file(const char *name)
{
    char path[PATH_BYTES];
    struct error err = {""};
    assert_int_equal(file_write(path_of(name, path), "x", 1, &err), 0);
}

static void put_folder(const char *name)
{
    char path[PATH_BYTES];
    assert_int_equal(mkdir(path_of(name, path), 0755), 0);
}

static int make_root(void **state)
{
    struct error err = {""};
    (void)state;
    return folder_make_work(root, &err);
}

static int remove_root(void **state)
{
    (void)state;
    folder_remove_work(root);
    return 0;
}

static void assert_names(char **names, const char *const *expected)
{
    size_t i = 0;
    assert_non_null(names);
    for (; expected[i]; i++) {
        assert_non_null(names[i]);
        assert_string_equal(names[i], expected[i]);
    }
    assert_null(names[i]);
    free(names);
}

static void test_sorted_by_kind_and_ending(void **state)
{
    char path[PATH_BYTES], link[PATH_BYTES];
    struct error err = {""};
    (void)state;
    put_folder("plain");
    put_folder("plain/b");
    put_folder("plain/a.json");
    put_file("plain/z.json");
    put_file("plain/B.json");
    put_file("plain/.json");
    put_file("plain/.hidden.json");
    put_file("plain/note.txt");
    assert_int_equal(symlink("z.json", path_of("plain/link.json", link)), 0);
    assert_int_equal(symlink("nowhere", path_of("plain/lost.json", link)), 0);
    path_of("plain", path);
    assert_names(listing_files(path, ".json", &err),
                 (const char *const[]){"B.json", "link.json", "lost.json", "z.json", NULL});
    assert_names(
        listing_files(path, "", &err),
        (const char *const[]){"B.json", "link.json", "lost.json", "note.txt", "z.json", NULL});
    assert_names(listing_folders(path, &err), (const char *const[]){"a.json", "b", NULL});
    assert_string_equal(err.text, "");
}

/* What glob() would take for a pattern. The siblings are what it would find instead. */
static void test_a_path_is_no_pattern(void **state)
{
    static const char *const folders[] = {"marks[12]", "marks *", "marks?", "ma\\rks",
                                          "{a,b}",     "~",       "[!a]",   "[2026"};
    char path[PATH_BYTES], inner[PATH_BYTES];
    struct error err = {""};
    (void)state;
    put_folder("marks1");
    put_file("marks1/of-the-sibling.json");
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        put_folder(folders[i]);
        snprintf(inner, sizeof inner, "%s/own[1]*.json", folders[i]);
        put_file(inner);
        assert_names(listing_files(path_of(folders[i], path), ".json", &err),
                     (const char *const[]){"own[1]*.json", NULL});
    }
}

static void test_absent_has_none(void **state)
{
    char path[PATH_BYTES];
    struct error err = {""};
    (void)state;
    assert_names(listing_files(path_of("absent", path), "", &err), (const char *const[]){NULL});
    assert_names(listing_folders(path, &err), (const char *const[]){NULL});
    assert_string_equal(err.text, "");
}

static void test_unreadable_is_an_error(void **state)
{
    char path[PATH_BYTES];
    struct error err = {""};
    (void)state;
    put_file("no-folder");
    assert_null(listing_files(path_of("no-folder", path), "", &err));
    assert_non_null(strstr(err.text, path));
    assert_non_null(strstr(err.text, strerror(ENOTDIR)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sorted_by_kind_and_ending),
        cmocka_unit_test(test_a_path_is_no_pattern),
        cmocka_unit_test(test_absent_has_none),
        cmocka_unit_test(test_unreadable_is_an_error),
    };
    return cmocka_run_group_tests(tests, make_root, remove_root);
}
