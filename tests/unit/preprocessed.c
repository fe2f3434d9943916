/* Has gcc preprocess sources; see preprocessed.h. */
#include "tests/unit/preprocessed.h"

#include "graders/engine/base/files.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

enum { TEXT_BYTES = 8 << 20 };

char *preprocessed_text;
char preprocessed_folder[] = "/tmp/test_preprocessed.XXXXXX";

int preprocessed_set_up(void **state)
{
    (void)state;
    preprocessed_text = malloc(TEXT_BYTES + 1);
    return preprocessed_text && mkdtemp(preprocessed_folder) ? 0 : -1;
}

int preprocessed_tear_down(void **state)
{
    (void)state;
    free(preprocessed_text);
    folder_remove(preprocessed_folder);
    return 0;
}

void preprocessed_write(const char *name, const char *content)
{
    char path[128];
    snprintf(path, sizeof path, "%s/%s", preprocessed_folder, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_true(fputs(content, file) >= 0);
    assert_int_equal(fclose(file), 0);
}

size_t preprocessed_make(const char *source, const char *flags)
{
    char command[900];
    preprocessed_write("main.c", source);
    snprintf(command, sizeof command, "cd %s && gcc -O2 -w %s -E main.c", preprocessed_folder,
             flags);
    FILE *compiler = popen(command, "r");
    assert_non_null(compiler);
    size_t bytes = fread(preprocessed_text, 1, TEXT_BYTES, compiler);
    assert_int_equal(pclose(compiler), 0);
    preprocessed_text[bytes] = '\0';
    return bytes;
}
