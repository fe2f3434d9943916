/* Tries: to have the assembler print a file of the host
 * Stopped by: the build box: the assembler finds nothing
 * expect: compile-error, syntax */
__asm__(".include \"/etc/passwd\"");
