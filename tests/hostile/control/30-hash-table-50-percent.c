/* Tries: a hash table of open addressing that doubles when it is 50 % full
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-any.h"

#define LOAD_PERCENT 50
#include "hash_table.h"
