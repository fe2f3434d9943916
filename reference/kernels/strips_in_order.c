/* Strips by a window, portable; see strips_in_order.h and strip_window.h. */
#include "reference/kernels/strip_window.h"

/* Corners by place; of a place without triangle -1, which no side has. */
struct window {
    struct strip_places places;
    int32_t a[STRIP_WINDOW], b[STRIP_WINDOW], c[STRIP_WINDOW];
};

STRIP_INLINE void refill(void *of, int place)
{
    struct window *window = of;
    int32_t triangle = strip_places_refill(&window->places, place);
    const int32_t *corner = window->places.corner + 3 * (int64_t)(triangle < 0 ? 0 : triangle);
    window->a[place] = triangle < 0 ? -1 : corner[0];
    window->b[place] = triangle < 0 ? -1 : corner[1];
    window->c[place] = triangle < 0 ? -1 : corner[2];
}

/* The first place whose triangle has that side, or -1. */
STRIP_INLINE int find(const void *in, int32_t from, int32_t to)
{
    const struct window *window = in;
    for (int i = 0; i < STRIP_WINDOW; i++) {
        bool ab = (window->a[i] == from) & (window->b[i] == to);
        bool bc = (window->b[i] == from) & (window->c[i] == to);
        bool ca = (window->c[i] == from) & (window->a[i] == to);
        if (ab | bc | ca)
            return i;
    }
    return -1;
}

int64_t strips_in_order_plain(const struct mesh *mesh, void *scratch, void *output)
{
    (void)scratch;
    struct window window = {.places = {.corner = mesh->triangles, .count = mesh->triangle_count}};
    for (int place = 0; place < STRIP_WINDOW; place++)
        refill(&window, place);
    return strip_walk(&window, output, find, refill);
}
