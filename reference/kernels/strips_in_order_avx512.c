/* Strips by a window that is three vectors of 512 bits; see strips_in_order.h and strip_window.h.
 */
#include "reference/kernels/strip_window.h"
#include "reference/kernels/x86.h"

#if defined(__x86_64__)

#include <immintrin.h>

struct window {
    struct strip_places places;
    __m512i a, b, c; /* corners by place; of a place without triangle -1, which no side has */
};

TARGET_AVX512 STRIP_INLINE void refill(void *of, int place)
{
    struct window *window = of;
    int32_t triangle = strip_places_refill(&window->places, place);
    const int32_t *corner = window->places.corner + 3 * (int64_t)(triangle < 0 ? 0 : triangle);
    __mmask16 at = (__mmask16)(1U << place);
    window->a = _mm512_mask_set1_epi32(window->a, at, triangle < 0 ? -1 : corner[0]);
    window->b = _mm512_mask_set1_epi32(window->b, at, triangle < 0 ? -1 : corner[1]);
    window->c = _mm512_mask_set1_epi32(window->c, at, triangle < 0 ? -1 : corner[2]);
}

TARGET_AVX512 STRIP_INLINE int find(const void *in, int32_t from, int32_t to)
{
    const struct window *window = in;
    __m512i begin = _mm512_set1_epi32(from), end = _mm512_set1_epi32(to);
    __mmask16 ab =
        _mm512_mask_cmpeq_epi32_mask(_mm512_cmpeq_epi32_mask(window->a, begin), window->b, end);
    __mmask16 bc =
        _mm512_mask_cmpeq_epi32_mask(_mm512_cmpeq_epi32_mask(window->b, begin), window->c, end);
    __mmask16 ca =
        _mm512_mask_cmpeq_epi32_mask(_mm512_cmpeq_epi32_mask(window->c, begin), window->a, end);
    unsigned places = (unsigned)ab | bc | ca;
    return places ? __builtin_ctz(places) : -1;
}

TARGET_AVX512 int64_t strips_in_order_avx512(const struct mesh *mesh, void *scratch, void *output)
{
    (void)scratch;
    struct window window = {.places = {.corner = mesh->triangles, .count = mesh->triangle_count}};
    for (int place = 0; place < STRIP_WINDOW; place++)
        refill(&window, place);
    return strip_walk(&window, output, find, refill);
}

#endif
