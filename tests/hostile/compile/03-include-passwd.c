/* Tries: to print a file of the host in the compiler's message
 * Stopped by: the build box: private root, Landlock
 * expect: compile-error, syntax */
#include "/etc/passwd"
