/* Tries: to put a file of the host into the program by the assembler
 * Stopped by: the build box, which does not hold it
 * expect: compile-error, syntax */
__asm__(".incbin \"reference/answers/edges/edge-table-closed.c\"");
