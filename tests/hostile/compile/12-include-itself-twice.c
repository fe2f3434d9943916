/* Tries: 2^26 inclusions of a file by itself
 * Stopped by: the build box: file size
 * expect: compile-error, compiler-output */
#define LINE x x x x x x x x x x x x x x x x x x x x x x x x x x x x x x x x x x x x x x x x
LINE LINE LINE LINE LINE LINE LINE LINE LINE LINE LINE LINE LINE LINE LINE LINE
#if __INCLUDE_LEVEL__ < 26
#include __FILE__
#include __FILE__
#endif
