/* What a mesh takes in each of the representations (representation.h). */
#ifndef REFERENCE_SURVEY_SIZES_H
#define REFERENCE_SURVEY_SIZES_H

#include "reference/base/phrase.h"
#include "reference/representation/representation.h"

enum { SURVEY_SIZES = 16 };

struct representation_size {
    const struct representation *kind;
    int64_t bytes;     /* of its tables; -1: it cannot hold the mesh */
    unsigned obstacle; /* the first feature that it cannot hold (enum mesh_feature), or 0 */
};

/* Fills `sizes`, in the order of representation_table, and returns how many; or -1 and *err (out of
 * memory). Sizes follow from counts, as the formulas say them; strips and fans are made to be
 * counted. O(n log n). */
int survey_sizes(const struct mesh *mesh, const struct topology *topology,
                 struct representation_size sizes[SURVEY_SIZES], struct error *err) MUST_CHECK;

/* What a feature is called where it is an obstacle: "a boundary". */
struct phrase survey_obstacle(unsigned feature);

#endif
