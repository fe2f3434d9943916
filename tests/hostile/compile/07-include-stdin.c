/* Tries: to read what the compiler was given to read
 * Stopped by: the build box, whose stdin is /dev/null
 * expect: compile-error, syntax */
#include "/dev/stdin"
