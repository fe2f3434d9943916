/* Points on the unit circle at rational angles, by IEEE additions and multiplications only: the C
 * library's sin and cos differ in the last bit between machines, and generated meshes must not. */
#ifndef REFERENCE_MESH_CIRCLE_H
#define REFERENCE_MESH_CIRCLE_H

#include <stdint.h>

struct circle_point {
    double cosine;
    double sine;
};

/* The point at `step` / `steps` of a full turn; right to 1e-15, exact at multiples of 1/4 turn.
 *
 * step     any value from -2^58 to 2^58
 * steps    1 ... 2^58 */
struct circle_point circle_point(int64_t step, int64_t steps);

#endif
