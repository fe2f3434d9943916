/* Counted nouns: the plural's ending where it is -s, as in English and Spanish "4 bytes", "4
 * cases", "4 casos". The singular is for 1 alone. */
#ifndef REFERENCE_BASE_PLURAL_H
#define REFERENCE_BASE_PLURAL_H

/* "s", or "" for one. */
static inline const char *plural_ending(long long count)
{
    return count == 1 ? "" : "s";
}

#endif
