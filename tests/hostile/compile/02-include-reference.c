/* Tries: to have the reference compiled as its own answer
 * Stopped by: the build box, which does not hold it
 * expect: compile-error, syntax */
#include "reference/answers/edges/edge-table-closed.c"
