/* What several commands share. */
#ifndef GRADERS_COMMANDS_COMMON_H
#define GRADERS_COMMANDS_COMMON_H

#include "graders/engine/base/exercise.h"
#include "graders/report/terminal.h"
#include "reference/base/error.h"

#include <jansson.h>
#include <stdio.h>

/* The exercises of this tree; the caller frees *exercises. Says what is wrong and returns -1. */
int load_exercises(struct exercise **exercises, int *count);

/* Their names, borrowed, and a NULL after the last; the caller frees the array. NULL: no memory. */
const char **exercise_names(const struct exercise *exercises, int count);

/* The exercise of that name, or NULL after saying that there is none, and which are like it. */
const struct exercise *need_exercise(const struct exercise *exercises, int count, const char *name);

/* Whether there is FOLDER/name, as far as can be told. */
bool folder_holds(const char *folder, const char *name);

/* What --without asks for: boxes without these layers; NULL: all layers. Says what is wrong and
 * returns -1. */
int use_layers(const char *without);

/* The language of the environment: of LC_ALL, else LC_MESSAGES, else LANG. */
enum language language_here(void);

/* Colour only on a terminal and without NO_COLOR. */
struct terminal_style style_for(FILE *stream, enum language language);

/* Prints "meshgrade: ..." and returns EXIT_FAULT, or EXIT_USAGE when the error is in what was asked
 * for. */
int report_fault(const struct error *err);

/* Prints a value and the end of the line on the standard output. Returns 0, or -1 after saying that
 * it could not be written. */
int print_value(const json_t *value) MUST_CHECK;

/* build/meshgrade-render beside this program. */
const char *renderer_path(void);

#endif
