/* Tries: a variable of the function's name, holding machine code
 * Stopped by: the screen of the object
 * expect: compile-error, not-a-function */
#include <stdint.h>

const uint8_t edge_table_closed[] = {0x31, 0xc0, 0xc3};
