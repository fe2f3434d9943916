/* Tries: an object file of 1 GiB
 * Stopped by: the build box: file size
 * expect: compile-error, compiler-output */
int large[1 << 28] = {1};
