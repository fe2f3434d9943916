/* Tries: to sort the sides of triangles by their ends, 11 bits a pass: how many passes depends on
 * the size
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-any.h"

#define BITS 11
#include "radix_sort.h"
