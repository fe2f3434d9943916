/* The walk of strips_in_order.h, the same for all variants, which differ in how a window of
 * triangles is kept and searched. Everything is inline and called with the variant's own functions.
 *
 * A strip's last triangle has the indices w x y, of which y is not written yet: the strip may still
 * write w once more before it. An even triangle is (w,x,y), an odd one (x,w,y). */
#ifndef REFERENCE_KERNELS_STRIP_WINDOW_H
#define REFERENCE_KERNELS_STRIP_WINDOW_H

#include "reference/kernels/stripify.h"
#include "reference/kernels/strips_in_order.h"

#define STRIP_INLINE static inline __attribute__((always_inline))

/* What all variants know of the window: the triangle in each place, -1: none. */
struct strip_places {
    const int32_t *corner; /* the mesh's triangles */
    int32_t triangle[STRIP_WINDOW];
    int32_t next, count; /* the next triangle to come in, and how many the mesh has */
};

/* The next triangle to come into the place, -1 when all have. */
STRIP_INLINE int32_t strip_places_refill(struct strip_places *places, int place)
{
    int32_t triangle = places->next < places->count ? places->next++ : -1;
    places->triangle[place] = triangle;
    return triangle;
}

/* Where the oldest triangle is, -1: the window is empty. */
STRIP_INLINE int strip_places_oldest(const struct strip_places *places)
{
    int oldest = -1;
    uint32_t least = UINT32_MAX; /* no triangle, as unsigned */
    for (int i = 0; i < STRIP_WINDOW; i++)
        if ((uint32_t)places->triangle[i] < least) {
            least = (uint32_t)places->triangle[i];
            oldest = i;
        }
    return oldest;
}

/* The corner of a triangle that is neither end of its side. */
STRIP_INLINE int32_t strip_third(const struct strip_places *places, int place, int32_t from,
                                 int32_t to)
{
    const int32_t *corner = places->corner + 3 * (int64_t)places->triangle[place];
    return (int32_t)((uint32_t)corner[0] + (uint32_t)corner[1] + (uint32_t)corner[2] -
                     (uint32_t)from - (uint32_t)to);
}

/* The walk. `window` begins with its strip_places, which are filled; find returns the first place
 * whose triangle has that side, or -1; refill puts the next triangle into a place. */
STRIP_INLINE int64_t strip_walk(void *window, int32_t *indices,
                                int (*find)(const void *window, int32_t from, int32_t to),
                                void (*refill)(void *window, int place))
{
    struct strip_places *places = window;
    int32_t *out = indices;
    for (int place; (place = strip_places_oldest(places)) >= 0;) {
        const int32_t *corner = places->corner + 3 * (int64_t)places->triangle[place];
        refill(window, place);
        int first = 0; /* corner to begin with: the strip goes on behind the side of the others */
        while (first < 2 && find(window, corner[(first + 2) % 3], corner[(first + 1) % 3]) < 0)
            first++;
        int32_t w = corner[first], x = corner[(first + 1) % 3], y = corner[(first + 2) % 3];
        bool is_odd = false;
        if (out != indices)
            *out++ = STRIP_RESTART;
        *out++ = w;
        *out++ = x;
        for (;;) {
            int32_t from = is_odd ? x : y, to = is_odd ? y : x;
            int next = find(window, from, to);
            if (next >= 0) {
                w = x;
                is_odd = !is_odd;
            } else {
                from = is_odd ? y : w;
                to = is_odd ? w : y;
                next = find(window, from, to);
                if (next < 0)
                    break;
                *out++ = w;
            }
            *out++ = y;
            x = y;
            y = strip_third(places, next, from, to);
            refill(window, next);
        }
        *out++ = y;
    }
    return out - indices;
}

#endif
