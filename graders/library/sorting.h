/* Sorting that is O(n log n) at worst, whatever an answer holds; qsort promises neither that nor an
 * order of equal elements. */
#ifndef GRADERS_LIBRARY_SORTING_H
#define GRADERS_LIBRARY_SORTING_H

#include <stdint.h>

/* Sorts numbers upwards, by their bytes; linear.
 *
 * words, spare   count numbers each; spare is scratch. Both may be NULL when count is 0 */
void sort_words(uint64_t *words, uint64_t *spare, int64_t count);

/* Which of two things comes first: negative, zero (equal) or positive, as for qsort. */
typedef int sort_comparison(int64_t a, int64_t b, const void *context);

/* Sorts numbers of things by a comparison of the things; stable: equal ones stay in their order.
 *
 *     for (int64_t i = 0; i < count; i++)
 *         order[i] = i;
 *     sort_order(order, spare, count, compare_lengths, rows);
 *
 * order, spare   count numbers each; spare is scratch */
void sort_order(int64_t *order, int64_t *spare, int64_t count, sort_comparison *compare,
                const void *context);

#endif
