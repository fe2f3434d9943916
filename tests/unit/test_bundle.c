/* What a bundle does when it is full. */
#include "graders/engine/upload/bundle.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void full_bundles_let_go_of_the_heaviest(void **state)
{
    (void)state;
    struct bundle bundle = {0};
    struct error err = {0};
    char path[64];
    assert_int_equal(bundle_add(&bundle, "ana/mesh-area.c", NULL, 0, NULL, &err), 0);
    for (int i = 0; i < 3 * BUNDLE_ENTRIES; i++) {
        snprintf(path, sizeof path, "m%d/%d/f%d.c", i / BUNDLE_ENTRIES, i % 100, i);
        assert_int_equal(bundle_add(&bundle, path, NULL, 0, NULL, &err), 0);
    }
    assert_int_equal(bundle_add(&bundle, "zoe/mesh-area.c", NULL, 0, NULL, &err), 0);
    bundle_sort(&bundle);
    assert_string_equal(bundle.files[0].path, "ana/mesh-area.c");
    assert_string_equal(bundle.files[bundle.count - 1].path, "zoe/mesh-area.c");
    int let_go = 0;
    for (int i = 0; i < bundle.count; i++)
        let_go += bundle.files[i].refusal.refused;
    assert_int_equal(let_go, 3); /* m0, m1, m2 */
    bundle_release(&bundle);
}

static void many_bytes_are_too_much_as_well(void **state)
{
    (void)state;
    enum { FILE_BYTES = 1 << 20 };
    struct bundle bundle = {0};
    char path[64];
    assert_int_equal(bundle_add(&bundle, "ana/mesh-area.c", NULL, 0, NULL, NULL), 0);
    for (int i = 0; i < 300; i++) {
        snprintf(path, sizeof path, "mallory/mesh-area/%d/f%d.c", i % 20, i);
        unsigned char *bytes = calloc(1, FILE_BYTES); /* never touched: costs nothing */
        assert_int_equal(bundle_add(&bundle, path, bytes, FILE_BYTES, NULL, NULL), 0);
    }
    bundle_sort(&bundle);
    assert_string_equal(bundle.files[0].path, "ana/mesh-area.c");
    assert_false(bundle.files[0].refusal.refused);
    assert_true(bundle.bytes <= BUNDLE_BYTES);
    int let_go = 0;
    for (int i = 1; i < bundle.count; i++)
        let_go += strcmp(bundle.files[i].refusal.cause, "folder-too-large") == 0;
    assert_true(let_go > 0);
    bundle_release(&bundle);
}

static void a_large_class_is_told_of(void **state)
{
    (void)state;
    struct bundle bundle = {0};
    struct error err = {0};
    char path[64];
    int result = 0;
    for (int i = 0; i <= BUNDLE_ENTRIES && result == 0; i++) {
        snprintf(path, sizeof path, "s%d/mesh-area.c", i);
        result = bundle_add(&bundle, path, NULL, 0, NULL, &err);
    }
    assert_int_equal(result, -1);
    assert_non_null(strstr(err.text, "too much to read"));
    bundle_release(&bundle);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(full_bundles_let_go_of_the_heaviest),
        cmocka_unit_test(many_bytes_are_too_much_as_well),
        cmocka_unit_test(a_large_class_is_told_of),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
