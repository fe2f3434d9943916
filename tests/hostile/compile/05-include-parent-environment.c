/* Tries: to read the environment of the process that compiles
 * Stopped by: the build box, which has no /proc
 * expect: compile-error, syntax */
#include "/proc/1/environ"
