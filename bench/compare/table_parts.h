/* What the tables on the terminal share; for the table*.c files. */
#ifndef BENCH_COMPARE_TABLE_PARTS_H
#define BENCH_COMPARE_TABLE_PARTS_H

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

struct table {
    FILE *to;
    bool bold;
    bool has_noisy, has_refused, has_equal, has_different; /* what the closing lines must explain */
};

/* A number, 0 when there is none; a text, "" when there is none. */
double table_number(const json_t *object, const char *key);
const char *table_text(const json_t *object, const char *key);

/* Numbers as text of at most TABLE_NUMBER bytes: three digits or so; a time with its unit where it
 * is not some ns; 1,234,567. */
enum { TABLE_NUMBER = 24 };
void table_digits(char *out, double value);
void table_time(char *out, double ns);
void table_grouped(char *out, long long value);

/* "1.34 [1.30, 1.38]", with "~" for the median when too noisy; "-" without one. */
enum { TABLE_INTERVAL = 3 * TABLE_NUMBER + 8 };
void table_interval(char *out, const json_t *interval, bool too_noisy);

/* The goals of a document (goals.h), in one table for all kernels and meshes. */
void table_goals(const struct table *table, const json_t *goals);

/* The accesses of a document (accesses.h): a line a representation, by size and by valence. */
void table_accesses(const struct table *table, const json_t *accesses);

#endif
