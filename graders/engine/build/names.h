/* The names that a submission may leave for libc: what C17 declares, the useful part of POSIX and
 * of GNU beside it, and what the compiler itself calls. All other names are refused, so that one
 * that is only another name of a refused thing (__mmap, __libc_malloc, __splitstack_makecontext)
 * needs no place on any list.
 *
 * The functions of POSIX that reach out of the process (fork, open, socket, kill ...) are among
 * them: the box refuses them when they are called, and the verdict names the call. */
#ifndef GRADERS_ENGINE_BUILD_NAMES_H
#define GRADERS_ENGINE_BUILD_NAMES_H

#include <stdbool.h>

/* One header and its names, apart by spaces. Those of `by_type` stand also for the same name with
 * the suffix of a type: sin for sinf and sinl. The last group has no header. */
struct name_group {
    const char *header; /* "<math.h>"; in words where none declares them */
    bool by_type;
    const char *names;
};
extern const struct name_group name_groups[];

/* Whether a name may be left undefined. Besides those of the groups, what headers make of them:
 * __NAME_chk (_FORTIFY_SOURCE), __isoc99_NAME and __isoc23_NAME (standards), NAME64 (file offsets).
 * Cost: linear in the groups. */
bool name_is_allowed(const char *name);

/* Whether a name is known, but for something that no submission may do here (system calls and
 * memory past malloc, threads, other stacks, other programs): the refusal then says so, instead of
 * asking where it is defined. */
bool name_is_forbidden(const char *name);

#endif
