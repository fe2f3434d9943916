/* Tries: to read a hidden judge by a path that leads out of the folder
 * Stopped by: the build box, which holds nothing else
 * expect: compile-error, syntax */
#include "../../../graders/judges/edges/edge-table-closed.c"
