/* The page of a benchmark run, part by part. It reads like a short paper; every number and every
 * sentence about a number is computed from the run. */
#ifndef GRADERS_REPORT_BENCH_PAGE_H
#define GRADERS_REPORT_BENCH_PAGE_H

#include "graders/report/bench/figures.h"
#include "graders/report/html.h"

struct bench_page {
    const struct study *study;
    const char *folder;          /* where pictures/ is, to see which are there */
    const char *pictures_reason; /* why some are missing, or "" */
    int figures;                 /* numbered so far */
    int tables;
};

/* The whole page, from <html> to </html>. */
void bench_page_write(struct html *page, struct bench_page *context);

/* A figure with its number and finding; without a picture, a sentence that says what is missing. */
void page_figure(struct html *page, struct bench_page *context, const struct figure *figure);

/* Method, machine, limits, and how to cite and repeat: what the run says of itself. */
void page_method(struct html *page, const struct bench_page *context);
void page_machine(struct html *page, struct bench_page *context);
void page_limits(struct html *page, const struct bench_page *context);
void page_repeat(struct html *page, const struct bench_page *context);

/* The tables: representations by operation (times, and ratios with intervals), kernels and peers,
 * other comparisons of the run (readers, the paper's operations), goals, the meshes, claims,
 * counted accesses. Each writes nothing when the run has no such rows. */
void page_representations(struct html *page, struct bench_page *context);
void page_comparison(struct html *page, struct bench_page *context, const char *what,
                     const char *title);
void page_goals(struct html *page, struct bench_page *context);
void page_meshes(struct html *page, struct bench_page *context);
void page_claims(struct html *page, struct bench_page *context);
void page_accesses(struct html *page, struct bench_page *context);

/* Parts of tables: starts one in a scrollable box with a numbered caption; a cell of a row. */
void table_open(struct html *page, struct bench_page *context, const char *caption);
void table_close(struct html *page);
void table_head(struct html *page, const char *const *names, size_t count);
void table_cell(struct html *page, const char *class_name, const char *text);

/* "× 1.34 (1.30 – 1.38)" from a row's ratio; only its ends when too noisy, only its median when the
 * blocks are too few for an interval; "" without one. */
void ratio_words(const json_t *ratio, char *text, size_t capacity);

#endif
