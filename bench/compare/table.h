/* bench.json as tables to read on 96 columns. */
#ifndef BENCH_COMPARE_TABLE_H
#define BENCH_COMPARE_TABLE_H

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

/* Writes the machine, a table for each comparison and mesh, the claims, and what the signs mean.
 *
 * document  of bench_document_make
 * bold      titles in bold, for terminals */
void table_write(const json_t *document, bool bold, FILE *to);

#endif
