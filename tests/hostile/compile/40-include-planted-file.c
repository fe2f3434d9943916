/* Tries: to have the compiler print a file of the host that everybody may read
 * Stopped by: the build box, which does not hold it; no result, page or log may show its text
 * expect: compile-error, syntax */
#include "/tmp/meshgrade-canary/canary.h"
