/* Faces of strips and fans: which entries their corners are. Entries of all runs (strips or fans)
 * stand one after another; run r has entries starts[r] ... starts[r + 1] - 1, at least three, and
 * two faces less than entries. Faces are numbered run after run. */
#ifndef REFERENCE_REPRESENTATION_STRIP_FACES_H
#define REFERENCE_REPRESENTATION_STRIP_FACES_H

#include <stdint.h>

/* Entries of `count` (>= 1) faces from `first` on. Face i of a strip is (i, i+1, i+2), turned to
 * (i+1, i, i+2) when i is odd; face i of a fan is (0, i+1, i+2).
 *
 * corners  3 * count entries
 * cost     lg(run_count) to find the first face, then constant a face */
void strip_faces(const int32_t *starts, int32_t run_count, int32_t first, int32_t count,
                 int32_t *corners);
void strip_faces_of_fans(const int32_t *starts, int32_t run_count, int32_t first, int32_t count,
                         int32_t *corners);

#endif
