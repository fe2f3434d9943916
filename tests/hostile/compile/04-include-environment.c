/* Tries: to read the engine's environment
 * Stopped by: the build box, which has no /proc
 * expect: compile-error, syntax */
#include "/proc/self/environ"
