/* The store of a class: results come back as they were put, and a damaged store never gives a
 * different one. */
#include "graders/engine/base/files.h"
#include "graders/engine/result/store.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

enum { DAMAGES = 600, CUTS = 60, STUDENTS = 3, PATH_BYTES = PATH_MAX + 64 };

static char folder[PATH_MAX];
static const char *const students[STUDENTS] = {"ana", "bruno-conti", "s3"};

static void path_of(const char *name, char *path)
{
    snprintf(path, PATH_BYTES, "%s/%s", folder, name);
}

static json_t *result_of(int student)
{
    json_t *result = json_pack("{s:s, s:f, s:s}", "verdict", student ? "wrong-answer" : "passed",
                               "score", 10.0 - 2.5 * student, "student", students[student]);
    assert_non_null(result);
    return result;
}

static void fill_store(void)
{
    struct store store;
    struct error err = {""};
    assert_int_equal(store_open(&store, folder, &err), 0);
    for (int i = 0; i < STUDENTS; i++) {
        char scenes[] = "{\"cube\":{\"kind\":\"mesh\"}}";
        struct outcome outcome = {result_of(i), scenes};
        assert_int_equal(
            store_put(&store, students[i], "euler-closed-mesh", "digest", &outcome, &err), 0);
        json_decref(outcome.result);
    }
    store_close(&store);
}

static int make_folder(void **state)
{
    struct error err = {""};
    (void)state;
    if (folder_make_work(folder, &err) != 0)
        return -1;
    fill_store();
    return 0;
}

static int remove_folder(void **state)
{
    (void)state;
    folder_remove_work(folder);
    return 0;
}

static void test_round_trip(void **state)
{
    struct store store;
    struct error err = {""};
    json_t *found;
    (void)state;
    assert_int_equal(store_open(&store, folder, &err), 0);
    for (int i = 0; i < STUDENTS; i++) {
        json_auto_t *expected = result_of(i);
        assert_int_equal(
            store_find(&store, students[i], "euler-closed-mesh", "digest", &found, &err), 0);
        assert_true(json_equal(found, expected));
        json_decref(found);
    }
    assert_int_equal(store_find(&store, "ana", "euler-closed-mesh", "other", &found, &err), 0);
    assert_null(found);
    store_close(&store);
}

/* Reads everything from the store as it stands. Each result is right or refused with a remedy. */
static void check_store(size_t at)
{
    struct store store;
    struct error err = {""};
    int opened = store_open(&store, folder, &err);
    if (opened != 0 && !err.text[0])
        fail_msg("damage at %zu: refused without a word", at);
    for (int i = 0; i < STUDENTS && opened == 0; i++) {
        json_t *found = NULL;
        json_auto_t *expected = result_of(i);
        err.text[0] = '\0';
        if (store_find(&store, students[i], "euler-closed-mesh", NULL, &found, &err) != 0) {
            if (!strstr(err.text, "move the file away"))
                fail_msg("damage at %zu: no remedy: %s", at, err.text);
        } else if (found && !json_equal(found, expected)) {
            fail_msg("damage at %zu: %s has another result", at, students[i]);
        }
        json_decref(found);
    }
    err.text[0] = '\0';
    if (opened == 0 && store_write_files(&store, folder, &err) != 0 && !err.text[0])
        fail_msg("damage at %zu: refused without a word", at);
    store_close(&store);
}

static void put_file(const char *path, const char *bytes, size_t count)
{
    static const char *const leftovers[] = {"meshgrade.sqlite-wal", "meshgrade.sqlite-shm"};
    struct error err = {""};
    for (int i = 0; i < 2; i++) {
        char other[PATH_BYTES];
        path_of(leftovers[i], other);
        unlink(other);
    }
    assert_int_equal(file_write(path, bytes, count, &err), 0);
}

static void test_damage(void **state)
{
    char path[PATH_BYTES], *whole;
    size_t count;
    struct error err = {""};
    (void)state;
    path_of("meshgrade.sqlite", path);
    assert_int_equal(file_read(path, 1 << 20, &whole, &count, &err), 0);
    char *damaged = malloc(count);
    assert_non_null(damaged);
    for (size_t i = 0; i < DAMAGES; i++) {
        size_t at = count * i / DAMAGES;
        memcpy(damaged, whole, count);
        for (; at + 1 < count && whole[at] == 0; at++) /* most of a page is empty */
            continue;
        damaged[at] ^= (char)(1 << i % 8);
        put_file(path, damaged, count);
        check_store(at);
    }
    for (size_t i = 0; i < CUTS; i++) {
        put_file(path, whole, count * i / CUTS);
        check_store(count * i / CUTS);
    }
    put_file(path, whole, count);
    free(damaged);
    free(whole);
}

/* A changed digit in a text is nothing that SQLite would notice. */
static void test_changed_mark(void **state)
{
    struct store store;
    struct error err = {""};
    json_t *found = NULL;
    (void)state;
    assert_int_equal(store_open(&store, folder, &err), 0);
    assert_int_equal(sqlite3_exec(store.database,
                                  "UPDATE result SET result = replace(result, '7.5', '9.5')", NULL,
                                  NULL, NULL),
                     SQLITE_OK);
    assert_int_equal(store_find(&store, "bruno-conti", "euler-closed-mesh", NULL, &found, &err),
                     -1);
    assert_null(found);
    assert_non_null(strstr(err.text, "bruno-conti"));
    assert_non_null(strstr(err.text, "move the file away"));
    assert_int_equal(store_write_files(&store, folder, &err), -1);
    store_close(&store);
}

static void test_other_version(void **state)
{
    struct store store;
    struct error err = {""};
    (void)state;
    for (int version = 2; version <= 4; version += 2) {
        char statement[64];
        assert_int_equal(store_open(&store, folder, &err), 0);
        snprintf(statement, sizeof statement, "PRAGMA user_version = %d", version);
        assert_int_equal(sqlite3_exec(store.database, statement, NULL, NULL, NULL), SQLITE_OK);
        store_close(&store);
        assert_int_equal(store_open(&store, folder, &err), -1);
        assert_non_null(strstr(err.text, "move the file away"));
        assert_int_equal(sqlite3_exec(store.database, "PRAGMA user_version = 3", NULL, NULL, NULL),
                         SQLITE_OK);
        store_close(&store);
    }
}

/* Drawn once, kept, and never mixed with another. */
static void test_seed(void **state)
{
    struct store store;
    struct error err = {""};
    uint32_t first = 0, again = 0, others[2];
    (void)state;
    assert_int_equal(store_open(&store, folder, &err), 0);
    assert_int_equal(store_seed(&store, SEED_PUBLISHED, &first, &err), 0);
    store_close(&store);
    assert_int_not_equal(first, SEED_PUBLISHED);
    assert_int_equal(store_open(&store, folder, &err), 0);
    assert_int_equal(store_seed(&store, SEED_PUBLISHED, &again, &err), 0);
    assert_int_equal(again, first);
    assert_int_equal(store_seed(&store, first, &again, &err), 0);
    assert_int_equal(store_seed(&store, first ^ 1 ? first ^ 1 : 2, &again, &err), -1);
    assert_non_null(strstr(err.text, "another folder"));
    for (int i = 0; i < 2; i++) { /* a folder without results draws anew: 1 of 2^32 is equal */
        assert_int_equal(sqlite3_exec(store.database, "DELETE FROM class", NULL, NULL, NULL),
                         SQLITE_OK);
        assert_int_equal(store_seed(&store, SEED_PUBLISHED, &others[i], &err), 0);
    }
    assert_int_not_equal(others[0], others[1]);
    assert_int_equal(sqlite3_exec(store.database, "UPDATE class SET seed = '12'", NULL, NULL, NULL),
                     SQLITE_OK);
    err.text[0] = '\0';
    assert_int_equal(store_seed(&store, SEED_PUBLISHED, &again, &err), -1);
    assert_non_null(strstr(err.text, "move the file away"));
    store_close(&store);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_round_trip, make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(test_damage, make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(test_changed_mark, make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(test_other_version, make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(test_seed, make_folder, remove_folder),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
