/* Comparing meshes as oriented surfaces: up to the numbers of vertices, the order of triangles and
 * the rotation of their corners. Which vertex is which is told by a table that came with the
 * answer, or found by position.
 *
 *     struct surface_fault fault;
 *     if (surface_compare_places(&answer, &right, 1e-5, 1e-3, &fault, err))
 *         return -1;
 *     const struct cause *cause = surface_fault_cause(&fault);
 *     if (cause == &surface_flipped)
 *         ... triangle fault.triangles.reversed of the answer ...
 *     surface_fault_release(&fault);
 */
#ifndef GRADERS_LIBRARY_SURFACE_H
#define GRADERS_LIBRARY_SURFACE_H

#include "graders/library/set_fault.h"

/* A mesh, borrowed. What comes from an answer may hold anything; the tables are really there. */
struct surface_mesh {
    const float *positions; /* 3 a vertex; not looked at where vertices are told by a table */
    const int32_t *triangles;
    int32_t vertex_count;
    int64_t triangle_count;
};

/* First element of each kind (-1: none), and how many there are. */
struct surface_fault {
    int64_t bad_corner,
        bad_corner_count;        /* corners of the answer's triangles that name no vertex */
    int64_t stray, stray_count;  /* vertices of the answer that stand for no right one, or
                                    lie farther from it than the tolerance */
    double stray_distance;       /* how far the first is off; infinity: it stands for none */
    int64_t doubled_of, doubled; /* two vertices of the answer that stand for one */
    int64_t doubled_count;       /* of vertices that repeat an earlier one */
    int64_t lost, lost_count;    /* right vertices that nothing stands for */
    struct set_fault triangles;  /* entries: the answer's triangles; reversed: flipped */
    int32_t *right_of;           /* of each vertex of the answer: the right one; or -1 */
};

extern const struct cause surface_bad_index, surface_stray, surface_doubled, surface_lost,
    surface_repeated, surface_extra, surface_flipped, surface_missing;

/* Vertices by a table: origin[v] is the right vertex for which the answer's vertex v stands. It may
 * hold anything; what is out of range stands for none. Several may stand for one where the exercise
 * lets vertices be copied: then doubled_count is no fault, see surface_fault_cause_of_triangles.
 *
 * fault     on success the caller owns it (surface_fault_release)
 * returns   0, or -1 and *err (out of memory, negative count)
 * cost      O(n log n) */
int surface_compare_mapped(const struct surface_mesh *answer, const int32_t *origin,
                           const struct surface_mesh *right, struct surface_fault *fault,
                           struct error *err) MUST_CHECK;

/* Vertices by position: each stands for the nearest right vertex within `reach`, and is stray when
 * that is farther than `tolerance` (0: equal as numbers). Right vertices must differ by more than
 * twice the reach to be told apart for certain; keep the reach small (near_points.h). */
int surface_compare_places(const struct surface_mesh *answer, const struct surface_mesh *right,
                           double tolerance, double reach, struct surface_fault *fault,
                           struct error *err) MUST_CHECK;

void surface_fault_release(struct surface_fault *fault);

/* The cause to tell first: bad index, stray, doubled, lost, then what is wrong with triangles:
 * repeated, extra, flipped, missing. NULL: nothing is wrong. */
const struct cause *surface_fault_cause(const struct surface_fault *fault);

/* The same without doubled and lost vertices. */
const struct cause *surface_fault_cause_of_triangles(const struct surface_fault *fault);

#endif
