/* Sources in a folder of the test, and what gcc -E makes of them; for tests of what reads that. */
#ifndef TESTS_UNIT_PREPROCESSED_H
#define TESTS_UNIT_PREPROCESSED_H

#include <stddef.h>

/* What gcc made of the last source, with a 0 behind it. */
extern char *preprocessed_text;
extern char preprocessed_folder[];

/* Fixtures of a group of tests. */
int preprocessed_set_up(void **state);
int preprocessed_tear_down(void **state);

/* Writes a file of the folder. */
void preprocessed_write(const char *name, const char *content);

/* Preprocesses `source` as main.c of the folder. Returns how many bytes stand in the text. */
size_t preprocessed_make(const char *source, const char *flags);

#endif
