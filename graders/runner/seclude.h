/* What the runner gives up before it calls the student's code for the first time, so that this
 * code, which may do whatever the process may, finds less to do it with. */
#ifndef GRADERS_RUNNER_SECLUDE_H
#define GRADERS_RUNNER_SECLUDE_H

/* What else runs in the process. */
enum secluded_in { IN_NO_TOOL, IN_VALGRIND, IN_SANITIZER };

/* Closes the descriptors of the shared regions, which are mapped by now; clears the environment,
 * which tells of tools and their settings, and leaves the same three variables everywhere.
 *
 * In a tool it then gives calls up, for good: exec kills the process, so that no program can be
 * started anew without the tool or with other settings of it; so do chdir and fchdir, after which
 * valgrind would write somewhere else; and prctl, seccomp and changes of limits, by which a
 * tool's end could be turned into a signal, and survived. In a sanitizer handlers can be set of no
 * signals but those of the program's own faults.
 *
 * returns   0, or -1: the kernel refused */
int seclude(enum secluded_in where);

#endif
