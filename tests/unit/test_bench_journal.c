/* The journal: what was added is found again, a cut line is dropped, other results are put aside.
 */
#include "bench/compare/journal.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

static char folder[64], path[96], old[128];

static int make_folder(void **state)
{
    (void)state;
    strcpy(folder, "/tmp/meshgrade-journal.XXXXXX");
    if (!mkdtemp(folder))
        return -1;
    snprintf(path, sizeof path, "%s/journal.jsonl", folder);
    snprintf(old, sizeof old, "%s.old", path);
    return 0;
}

static int remove_folder(void **state)
{
    (void)state;
    unlink(path);
    unlink(old);
    return rmdir(folder);
}

static void add(struct journal *journal, const char *job, int block)
{
    json_t *entry = json_pack("{s:s, s:i}", "job", job, "block", block);
    assert_int_equal(journal_add(journal, entry, NULL), 0);
}

static void open_as(struct journal *journal, const char *fingerprint, size_t entries)
{
    struct error err = {""};
    if (journal_open(journal, folder, fingerprint, &err) != 0)
        fail_msg("%s", err.text);
    assert_int_equal(json_array_size(journal->entries), entries);
}

static void goes_on_where_it_was(void **state)
{
    struct journal journal;
    (void)state;
    open_as(&journal, "me", 0);
    assert_false(journal.is_resumed);
    add(&journal, "kernels a", 0);
    add(&journal, "kernels a", 1);
    journal_close(&journal);
    open_as(&journal, "me", 2);
    assert_true(journal.is_resumed);
    assert_non_null(journal_find(&journal, "kernels a", 1));
    assert_null(journal_find(&journal, "kernels a", 2));
    assert_null(journal_find(&journal, "kernels", 1));
    add(&journal, "kernels a", 2);
    journal_close(&journal);
    open_as(&journal, "me", 3);
    journal_close(&journal);
}

/* A line that was being written when the power went: at every length. */
static void drops_a_line_that_was_cut(void **state)
{
    const char *line = "{\"job\":\"b\",\"block\":7}";
    struct journal journal;
    (void)state;
    for (size_t length = 1; length <= strlen(line); length++) {
        FILE *file = fopen(path, "ae");
        assert_non_null(file);
        fwrite(line, 1, length, file);
        fclose(file);
        open_as(&journal, "me", 3);
        journal_close(&journal);
    }
    open_as(&journal, "me", 3);
    add(&journal, "b", 7);
    journal_close(&journal);
    open_as(&journal, "me", 4);
    journal_close(&journal);
}

static void puts_other_results_aside(void **state)
{
    struct journal journal;
    (void)state;
    open_as(&journal, "another machine", 0);
    assert_true(journal.was_other);
    assert_int_equal(access(old, R_OK), 0);
    journal_close(&journal);
    open_as(&journal, "me", 0);
    assert_true(journal.was_other);
    journal_close(&journal);
}

static void is_not_fooled_by_rubbish(void **state)
{
    static const char *const rubbish[] = {"", "x", "[1]\n", "{\"schema\":1}\n", "{}\n{}\n"};
    struct journal journal;
    (void)state;
    for (size_t i = 0; i < sizeof rubbish / sizeof *rubbish; i++) {
        FILE *file = fopen(path, "we");
        assert_non_null(file);
        fputs(rubbish[i], file);
        fclose(file);
        open_as(&journal, "me", 0);
        add(&journal, "a", 0);
        journal_close(&journal);
        open_as(&journal, "me", 1);
        journal_close(&journal);
    }
    assert_int_equal(journal_open(&journal, "/dev/null", "me", NULL), -1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(goes_on_where_it_was),
        cmocka_unit_test(drops_a_line_that_was_cut),
        cmocka_unit_test(puts_other_results_aside),
        cmocka_unit_test(is_not_fooled_by_rubbish),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
