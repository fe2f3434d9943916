/* The lock of a class: one run at a time writes below OUT.
 *
 * Two runs would remove each other's scratch folders, which makes faults of right answers. The lock
 * is the kernel's, on OUT/meshgrade.lock: it ends with the process that took it, however that ends.
 * Children do not have it, so what a killed run leaves behind for a moment holds up nobody. */
#ifndef GRADERS_ENGINE_RESULT_LOCK_H
#define GRADERS_ENGINE_RESULT_LOCK_H

#include "reference/base/error.h"

struct lock {
    int file; /* negative: not taken */
};

/* Takes the lock of OUT, a folder that is there, and writes down who holds it.
 *
 * returns  0; -1 and *err when it is taken (the error says by whom and since when) or cannot be.
 *          lock_release follows in both cases */
int lock_take(struct lock *lock, const char *out, struct error *err) MUST_CHECK;
void lock_release(struct lock *lock);

#endif
