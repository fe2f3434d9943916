/* Tries: to keep the compiler reading for ever
 * Stopped by: the build box, whose only device is /dev/null
 * expect: compile-error, syntax */
#include "/dev/zero"
