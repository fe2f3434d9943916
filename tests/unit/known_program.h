/* Small programs with known behaviour, for the tests of the engine: a solution of edge-table-any in
 * a few lines, compiled with the project's own runner as a submission is. */
#ifndef TESTS_UNIT_KNOWN_PROGRAM_H
#define TESTS_UNIT_KNOWN_PROGRAM_H

#include <limits.h>

#include "graders/engine/run/region.h"
#include "graders/engine/run/session.h"

struct known_program {
    char folder[PATH_MAX]; /* of its own, below the folder for work */
    int fd;                /* the program, open for reading */
    struct region input;   /* of its calls: no triangles, no vertices */
};

/* The bytes of that input that a call is given. */
enum { KNOWN_INPUT_BYTES = 64 };

/* Compiles `source` by gcc with these further options ("": none). Whatever fails ends the test. To
 * be given back to known_program_release. */
void known_program_build(struct known_program *program, const char *source, const char *options);
void known_program_release(struct known_program *program);

/* A plan to run it with room for every test; borrows the program. */
struct session_plan known_program_plan(const struct known_program *program);

#endif
