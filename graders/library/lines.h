/* Point sets, polylines and polygons of the plane or of space as inputs.
 *
 *     {.line = {LINE_STAR, .count = 12}}
 *
 * Packet: int point_count, int is_closed, int dimension (2 or 3), float points[point_count *
 * dimension]. Coordinates of plane shapes are integers of 0 ... 1024, so that predicates on them
 * are exact; of space shapes they are about one unit wide. */
#ifndef GRADERS_LIBRARY_LINES_H
#define GRADERS_LIBRARY_LINES_H

#include "graders/wire/packet.h"
#include "reference/base/error.h"

#include <stdbool.h>

enum line_shape {
    /* simple polygons, counter-clockwise */
    LINE_CONVEX,    /* points of a circle, rounded */
    LINE_STAR,      /* turn about far and near from the middle */
    LINE_COMB,      /* teeth: half of all corners are reflex */
    LINE_SPIRAL,    /* winds round twice: not star-shaped */
    LINE_COLLINEAR, /* a square with points along its sides */
    /* open, in the plane */
    LINE_ZIGZAG,
    LINE_PROFILE, /* x rises: what is turned round an axis or drawn out */
    /* open, in space */
    LINE_HELIX,
    /* points without an order */
    POINTS_RANDOM,   /* in the plane, no two equal */
    POINTS_GRID,     /* many on one line, many on one circle */
    POINTS_CLUSTERS, /* in space: groups much narrower than their distance */
    POINTS_ON_LINE   /* in space, evenly along a line */
};

struct line_recipe {
    enum line_shape shape;
    int32_t count;
    bool reversed;  /* clockwise; from the end */
    bool scrambled; /* the start of a closed one, or the order of points, at random */
};

/* Makes points and writes them. Returns 0, or -1 and *err (out of memory, too few points). */
int line_write(const struct line_recipe *recipe, uint64_t seed, struct writer *input,
               struct error *err) MUST_CHECK;

/* Points in a packet, in place. */
struct line_view {
    int32_t point_count, dimension;
    bool is_closed;
    const float *points;
};
struct line_view line_read(struct reader *input);

#endif
