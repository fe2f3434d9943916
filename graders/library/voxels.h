/* The sphere of problem 4.1 as voxels: one bit for each of k * k * k cells, set when the centre of
 * the cell is in the sphere. Cell (x, y, z) is bit number x + k * (y + k * z), low bit first. */
#ifndef GRADERS_LIBRARY_VOXELS_H
#define GRADERS_LIBRARY_VOXELS_H

#include "graders/library/judgement.h"

/* Judges the bits, (k^3 + 7) / 8 bytes, by an exact test of every cell; unused bits must be 0.
 * Accepts, or rejects, names the first wrong bit and the mistake that explains all of them, and
 * shows the voxels beside the sphere. Returns 0, or -1 and *err (out of memory). */
int voxels_judge(int32_t k, const uint8_t *bits, struct judgement *out,
                 struct error *err) MUST_CHECK;

#endif
