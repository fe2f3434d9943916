/* What need not be validated again: a stamp for each known-verdict submission that got its verdict
 * in full, below build/validated/<exercise>/, with a hash of all that the verdict depends on:
 *
 *   - the submission's whole source, its name and kind;
 *   - this program, and the runner's objects of the exercise;
 *   - the exercise's folder (but the statements), the real meshes, the reference answer;
 *   - the seed of the class;
 *   - the machine: its kernel, its Debian packages, the tools that the grader calls, the user's
 *     number, which layers of the box work.
 *
 * Whatever of these changes, the stamp holds no longer. What was not as expected gets no stamp. */
#ifndef GRADERS_KNOWN_STAMPS_H
#define GRADERS_KNOWN_STAMPS_H

#include "graders/engine/base/exercise.h"
#include "graders/known/submissions.h"
#include "reference/base/error.h"

#include <stdbool.h>
#include <stdint.h>

enum { STAMP_KEY = 65, STAMP_TEXT = 1024 };

struct stamps {
    char folder[PATH_MAX];         /* build/validated/<exercise> */
    char circumstances[STAMP_KEY]; /* hash of all but the submission */
};

/* Hashes the circumstances of an exercise.
 *
 * machine  from stamps_machine
 * returns  0, or -1 and *err: something that a verdict depends on cannot be read */
int stamps_open(const char *root, const struct exercise *exercise, uint32_t seed,
                const char machine[STAMP_KEY], struct stamps *stamps, struct error *err) MUST_CHECK;

/* Hashes this program and this machine; takes some 200 ms. */
int stamps_machine(char machine[STAMP_KEY], struct error *err) MUST_CHECK;

/* Whether a stamp of this submission holds; `text` gets what stamps_put was given. */
bool stamps_hold(const struct stamps *stamps, const struct known_submission *submission,
                 char text[STAMP_TEXT]);

/* Remembers a submission that got its verdict. `text` is one line. */
int stamps_put(const struct stamps *stamps, const struct known_submission *submission,
               const char *text, struct error *err) MUST_CHECK;

/* Forgets it. */
void stamps_remove(const struct stamps *stamps, const struct known_submission *submission);

#endif
