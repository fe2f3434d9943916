/* Any bytes as a change of any bytes: what stands before the first zero byte is the change, what
 * stands behind it the base. Refused with a place in one of the two files, or the result is the
 * change's comment and as many lines as the marks say. */
#include "graders/known/change.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

static void require(bool holds)
{
    if (!holds)
        abort();
}

static bool begins_with(const char *text, const char *beginning)
{
    return strncmp(text, beginning, strlen(beginning)) == 0;
}

static long count_lines(const char *text, size_t count)
{
    long lines = 0;
    for (size_t i = 0; i < count; i++)
        lines += text[i] == '\n';
    return lines + (count > 0 && text[count - 1] != '\n');
}

/* Lines behind the first comment, and how many more + than - there are. */
static long count_behind_comment(const char *text, size_t count, long *growth)
{
    const char *end = memmem(text + 2, count - 2, "*/", 2);
    require(end != NULL);
    size_t left = count - (size_t)(end - text) - 2;
    const char *at = end + 2 + (left > 0);
    left -= left > 0;
    *growth = 0;
    for (size_t i = 0; i < left; i++)
        if (i == 0 || at[i - 1] == '\n')
            *growth += (at[i] == '+') - (at[i] == '-');
    return count_lines(at, left);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count)
{
    const char *zero = count > 0 ? memchr(bytes, 0, count) : NULL;
    size_t change_count = zero ? (size_t)(zero - (const char *)bytes) : count, text_count;
    size_t base_count = zero ? count - change_count - 1 : 0;
    char *change_bytes = calloc(1, change_count + 1), *text = NULL, name[CHANGE_BASE_BYTES];
    require(change_bytes != NULL);
    if (change_count > 0)
        memcpy(change_bytes, bytes, change_count);
    struct change_text change = {"x.change", change_bytes, change_count};
    struct change_text base = {"right/x.c", zero ? zero + 1 : "", base_count};
    struct error err = {""};
    if (change_find_base(&change, name, &err) == 0)
        require(strcmp(name, "reference") == 0 || (name[0] != '.' && !strstr(name, "/.")));
    else
        require(begins_with(err.text, "x.change:"));
    err.text[0] = '\0';
    if (change_apply(&change, &base, &text, &text_count, &err) != 0) {
        require(begins_with(err.text, "x.change:") || begins_with(err.text, "right/x.c:"));
    } else {
        long growth, ignored;
        count_behind_comment(change.bytes, change.count, &growth);
        long before = count_behind_comment(base.bytes, base.count, &ignored);
        require(count_behind_comment(text, text_count, &ignored) == before + growth);
        free(text);
    }
    free(change_bytes);
    return 0;
}
