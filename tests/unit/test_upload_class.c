/* A whole class in one archive: nobody pays for what another packed. */
#include "graders/engine/upload/upload.h"
#include "tests/unit/upload_scene.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* One archive for the whole class: what one student packed refuses that student. */
static void a_class_in_an_archive_survives_its_students(void **state)
{
    (void)state;
    enum { ZEROS = 64 << 20 };
    char *zeros = calloc(1, ZEROS);
    assert_non_null(zeros);
    struct upload_item items[] = {
        {.path = "class/ana/mesh-area.c", .content = "int a;"},
        {.path = "class/bea/mesh-area.c", .content = "int b;"},
        {.path = "class/bea/x/../../ana/mesh-area.c", .content = "int bad;"},
        {.path = "class/carla/zeros.bin", .content = zeros, .bytes = ZEROS},
        {.path = "class/carla/mesh-area.c", .content = "int c;"},
        {.path = "class/dora/edge-table-any.c", .content = "int d;"},
        {0}};
    static const char *const endings[] = {"zip", "tar.gz", "tar.xz"};
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++) {
        char name[64];
        snprintf(name, sizeof name, "whole/%s/class.%s", endings[i], endings[i]);
        upload_scene_put_archive(name, items);
        upload_scene_expect(
            NULL, name,
            "ana/mesh-area: mesh-area.c; bea/mesh-area: [archive-path]; carla/mesh-area: "
            "[archive-ratio]; dora/edge-table-any: edge-table-any.c");
    }
    free(zeros);
}

/* What was read before the damage is kept, and the rest is named. */
static void a_damaged_class_is_read_as_far_as_it_goes(void **state)
{
    (void)state;
    struct upload_item items[] = {{.path = "class/ana/mesh-area.c", .content = "int a;"},
                                  {.path = "class/bea/mesh-area.c", .content = "int b;"},
                                  {.path = "class/carla/mesh-area.c", .content = "int c;"},
                                  {0}};
    char *tar = malloc(1 << 20);
    assert_non_null(tar);
    size_t count = upload_scene_pack(".tar", items, tar, 1 << 20);
    const char *carla = memmem(tar, count, "class/carla", 11);
    assert_non_null(carla);
    upload_scene_put("whole/cut/class.tar", "");
    upload_scene_write(upload_scene_path("whole/cut/class.tar"), tar, (size_t)(carla - tar) + 100);
    upload_scene_expect(
        NULL, "whole/cut/class.tar",
        "ana/mesh-area: mesh-area.c; bea/mesh-area: mesh-area.c; class/?: [archive-unread]");
    upload_scene_write(upload_scene_path("whole/cut/class.tar"), tar, (size_t)(carla - tar) + 515);
    const char *path = upload_scene_path("whole/cut/class.tar");
    struct upload_list list;
    assert_int_equal(upload_read(&path, 1, upload_scene_exercises, NULL, &list, NULL), 0);
    assert_int_equal(list.count, 4); /* whom the damage hits gets no mark by it */
    assert_string_equal(list.uploads[2].refusal.cause, "archive-broken");
    assert_true(list.uploads[2].refusal.is_fault && list.uploads[3].refusal.is_fault);
    upload_list_release(&list);
    const char *bea = memmem(tar, count, "class/bea", 9);
    assert_non_null(bea);
    upload_scene_write(upload_scene_path("whole/cut/class.tar"), tar, (size_t)(bea - tar) + 100);
    upload_scene_expect(NULL, "whole/cut/class.tar",
                        "class/?: [archive-broken]"); /* it may be one student's */
    free(tar);
}

int main(void)
{
#define TEST(function)                                                                             \
    cmocka_unit_test_setup_teardown(function, upload_scene_make, upload_scene_remove)
    const struct CMUnitTest tests[] = {
        TEST(a_class_in_an_archive_survives_its_students),
        TEST(a_damaged_class_is_read_as_far_as_it_goes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
