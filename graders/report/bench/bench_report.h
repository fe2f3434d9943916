/* The page of a benchmark run: DIR/index.html and what it shows, made from DIR/bench.json. */
#ifndef GRADERS_REPORT_BENCH_BENCH_REPORT_H
#define GRADERS_REPORT_BENCH_BENCH_REPORT_H

#include "reference/base/error.h"

#include <stddef.h>

/* Writes DIR/pictures/NAME.json and, by meshgrade-render, NAME.png, DIR/assets/bench.css and
 * DIR/index.html. The folder is complete in itself and opens from file://. Measures nothing; doing
 * it again draws only the pictures that are older than their scenes or the renderer.
 *
 * renderer  the program meshgrade-render; NULL or absent: the page comes without pictures
 * root      the tree that holds graders/report/bench/bench.css and exercises/models
 * reason    gets why pictures are missing, in English; "" when all are there. NULL allowed
 * returns   0, or -1 and *err: no or unsound bench.json, DIR cannot be written
 * cost      about 8 s of CPU when all pictures are drawn */
int bench_report(const char *folder, const char *renderer, const char *root, char *reason,
                 size_t capacity, struct error *err) MUST_CHECK;

#endif
