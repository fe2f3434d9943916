/* Rows of a PLY file in the layouts that nearly every file has, read many times faster than value
 * by value:
 *
 *   vertices  only scalars; x, y, z float or double; in text at most PLAIN_LIMIT values a row
 *   faces     nothing but the list of indices; in binary its length one byte and its indices of
 * four, in text whole numbers
 *
 * What has another layout, or is wrong, is left where it is, to be read value by value, which names
 * what is wrong. */
#ifndef REFERENCE_FORMATS_PLY_PLAIN_H
#define REFERENCE_FORMATS_PLY_PLAIN_H

#include "reference/formats/growing_mesh.h"
#include "reference/formats/ply_header.h"

/* Reads rows from *row on, up to the first that is not plain, and moves the scan and *row behind
 * them. Returns 0, or -1 and the scan's error (out of memory). */
int ply_read_plain_rows(struct scan *scan, const struct ply_header *header,
                        const struct ply_element *element, int64_t *row,
                        struct growing_mesh *mesh) MUST_CHECK;

#endif
