/* Options of a command: one table parses them and prints the help, so that the two cannot differ.
 */
#ifndef GRADERS_COMMANDS_OPTIONS_H
#define GRADERS_COMMANDS_OPTIONS_H

#include "reference/base/phrase.h"

#include <stdbool.h>
#include <stdint.h>

/* Exit codes of the program. */
enum { EXIT_PASSED = 0, EXIT_NOT_PASSED = 1, EXIT_FAULT = 2, EXIT_USAGE = 64 };

struct option_rule {
    const char *name;     /* long, without --; NULL ends the table */
    char letter;          /* short, 0: none */
    const char *argument; /* its name in the help; NULL: a flag */
    const char *help;
    const char **text; /* where the argument goes, or ... */
    bool *flag;        /* ... what is set */
};

struct command {
    const char *name;
    const char *arguments; /* "EXERCISE FILE..." */
    const char *help;      /* one line */
    int (*run)(int argc, char **argv);
};

/* Parses argv (argv[0] is the command's name); --help prints the help and ends the program.
 *
 * returns  the index of the first operand, or -1 after saying what is wrong */
int options_parse(const struct command *command, const struct option_rule *rules, int argc,
                  char **argv);

/* A whole number of at least `least`; complains and returns -1 otherwise. `text` NULL: `absent`. */
long options_number(const char *name, const char *text, long least, long absent);

/* The number after --seed: 1 to 4294967295; `text` NULL: `absent`. Returns 0, or -1 after saying
 * what is wrong. */
int options_seed(const char *text, uint32_t absent, uint32_t *seed);

/* The language after --lang: en or es; `text` NULL: `absent`. Returns 0, or -1 after saying what is
 * wrong. */
int options_language(const char *text, enum language absent, enum language *language);

extern const struct command command_list, command_start, command_check, command_grade,
    command_report, command_export, command_validate, command_doctor, command_bench,
    command_calibrate, command_new, command_mesh;

#endif
