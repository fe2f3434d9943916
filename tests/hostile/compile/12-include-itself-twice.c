/* Tries: 2^26 inclusions
 * Stopped by: the build box: CPU time or file size
 * expect: compile-error, compiler-output */
#if __INCLUDE_LEVEL__ < 26
#include __FILE__
#include __FILE__
#endif
