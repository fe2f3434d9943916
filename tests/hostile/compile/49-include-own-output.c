/* Tries: to read pipes: what the compiler writes to, and is told by
 * Stopped by: the build box, which has no /proc and no descriptor but its own output; behind it the
 * policy on what is included
 * expect: compile-error, syntax
 * expect(mount-namespace): compile-error, forbidden-include */
#include "/proc/self/fd/1"
#include "/dev/fd/2"
