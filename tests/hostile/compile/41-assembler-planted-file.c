/* Tries: to have the assembler print such a file
 * Stopped by: the build box: the assembler finds nothing
 * expect: compile-error, syntax */
__asm__(".include \"/tmp/meshgrade-canary/canary.h\"");
