/* What the runner gives up before it calls the student's code for the first time, so that this
 * code, which may do whatever the process may, finds less to do it with. */
#ifndef GRADERS_RUNNER_SECLUDE_H
#define GRADERS_RUNNER_SECLUDE_H

#include <stdbool.h>

/* Closes the descriptors of the shared regions, which are mapped by now; clears the environment,
 * which tells of tools and their settings, and leaves the same three variables everywhere.
 *
 * in_tools  the process is in a tools box: from now on the system call exec kills it, so that no
 *           program can be started anew without the tool or with other settings of it, and so do
 *           chdir and fchdir, after which valgrind would write somewhere else
 * returns   0, or -1: the kernel refused */
int seclude(bool in_tools);

#endif
