/* Numbers as people write them: "1.31", "0.0042", "12346". */
#ifndef REFERENCE_BASE_DECIMAL_H
#define REFERENCE_BASE_DECIMAL_H

#include <stddef.h>

enum { DECIMAL_BYTES = 32 };

/* Writes a finite number with four digits, or as many more as its whole part has, or as it takes to
 * look different from `beside`, which it stands beside: no "1.25, where 1.25 is allowed". */
void decimal_write(double value, double beside, char text[DECIMAL_BYTES]);

#endif
