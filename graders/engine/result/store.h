/* The store of a class: OUT/meshgrade.sqlite, one row a graded submission, one transaction a row.
 *
 * Killed at any moment, it holds whole results only. The result files below OUT are written from
 * it. Each row carries a hash of itself: a store that is damaged, in whatever byte, or of another
 * version is refused with a remedy. */
#ifndef GRADERS_ENGINE_RESULT_STORE_H
#define GRADERS_ENGINE_RESULT_STORE_H

#include "graders/engine/build/toolset.h"
#include "graders/engine/result/score.h"

#include <sqlite3.h>

struct store {
    sqlite3 *database;
};

/* Opens OUT/meshgrade.sqlite, making it when absent. Returns 0, or -1 and *err; store_close follows
 * in both cases. */
int store_open(struct store *store, const char *out, struct error *err) MUST_CHECK;
void store_close(struct store *store);

/* The seed of the class (inputs.h), which its first grading draws and all others keep, so that
 * the same files get the same marks.
 *
 * wanted   the seed to grade with, or SEED_PUBLISHED: the store's own, or one drawn anew
 * returns  0, or -1 and *err: results of another seed are in the store, or it is damaged */
int store_seed(struct store *store, uint32_t wanted, uint32_t *seed, struct error *err) MUST_CHECK;

/* The stored result of a submission.
 *
 * digest   of the files that were graded (store_digest); NULL: any
 * result   a new reference, or NULL when there is none with that digest
 * returns  0, or -1 and *err */
int store_find(struct store *store, const char *student_folder, const char *exercise,
               const char *digest, json_t **result, struct error *err) MUST_CHECK;

/* Looks for results that were made with other tools than these (toolset.h); faults, which are graded
 * again, and results that do not tell are left out.
 *
 * difference  what the first of them has and `here` has not, as "libc A there, B here"; empty: none
 * returns     how many, or -1 and *err */
enum { STORE_DIFFERENCE = 1000 };
int store_compare_tools(struct store *store, const struct toolset *here,
                        char difference[STORE_DIFFERENCE], struct error *err) MUST_CHECK;

/* Stores a result in one transaction, in the place of an earlier one. */
int store_put(struct store *store, const char *student_folder, const char *exercise,
              const char *digest, const struct outcome *outcome, struct error *err) MUST_CHECK;

/* Removes the results that are not named by `keep`. For submissions that are gone.
 *
 * keep     object: "student_folder/exercise" -> true */
int store_prune(struct store *store, const json_t *keep, struct error *err) MUST_CHECK;

/* Writes OUT/results/<student_folder>/<exercise>.json and the scenes
 * OUT/pictures/<student_folder>/<exercise>/<case>.json of every row; files of rows that are gone,
 * or of cases that are right now, are removed. */
int store_write_files(struct store *store, const char *out, struct error *err) MUST_CHECK;

enum { STORE_DIGEST = 65 };

/* SHA-256, in hexadecimal, of what decides a result: names and bytes of the files, or the refusal.
 */
void store_digest(const struct source *sources, int source_count, const char *refusal,
                  char digest[STORE_DIGEST]);

#endif
