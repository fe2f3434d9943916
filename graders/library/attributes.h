/* Attributes of a mesh as inputs: numbers for each vertex, corner or face (normals, texture
 * coordinates, materials), given with the mesh.
 *
 *     .attributes = {{PER_CORNER, 2, ATTRIBUTE_RANDOM}, {PER_FACE, 1, ATTRIBUTE_WHOLE}},
 *
 * in a struct judge of any input that has vertices and faces. The judge finds them in
 * task->attribute[0], [1]; the runner passes them as ATTRIBUTE(0), ATTRIBUTE(1) (runner/shapes.h).
 * Attributes as answers are parts of an answer: ANSWER_PER_VERTEX and its kin, answer.h.
 *
 * Packet: int attribute_count, then for each int row_count, int columns, float values[...]. */
#ifndef GRADERS_LIBRARY_ATTRIBUTES_H
#define GRADERS_LIBRARY_ATTRIBUTES_H

#include "graders/library/answer.h"
#include "reference/base/error.h"

enum { ATTRIBUTES_MOST = 2, ATTRIBUTE_COLUMNS_MOST = 8 };

enum attribute_of {
    PER_NOTHING, /* ends the list */
    PER_VERTEX,
    PER_CORNER, /* in the order of the faces' corners */
    PER_FACE
};

enum attribute_values {
    ATTRIBUTE_RANDOM, /* from -1 to 1 */
    ATTRIBUTE_UNIT,   /* rows of length 1: normals */
    ATTRIBUTE_WHOLE   /* whole numbers from 0 to 7: materials, groups */
};

struct attribute_rule {
    enum attribute_of of;
    int columns;
    enum attribute_values values;
};

/* One in a packet, in place. */
struct attribute_view {
    const float *values; /* NULL: there is none */
    int64_t row_count;
    int columns;
};

/* Rows that an attribute has. */
int64_t attribute_rows(enum attribute_of of, struct input_sizes sizes);

/* Writes the attributes of a mesh of these sizes. Same seed, same values. Returns 0, or -1 and *err
 * (out of memory, more columns than there may be). */
int attributes_write(const struct attribute_rule rules[ATTRIBUTES_MOST], struct input_sizes sizes,
                     uint64_t seed, struct writer *input, struct error *err) MUST_CHECK;

/* Reads what was written; views that are not there become zero. */
void attributes_read(struct reader *input, struct attribute_view views[ATTRIBUTES_MOST]);

#endif
