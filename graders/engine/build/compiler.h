/* The compiler that submissions and references meet: what it is told everywhere, so that the same
 * text is the same language on every machine, and what it says of itself. */
#ifndef GRADERS_ENGINE_BUILD_COMPILER_H
#define GRADERS_ENGINE_BUILD_COMPILER_H

#include "reference/base/error.h"

/* Four liberties of old C that gcc 14 refuses by itself are refused by every gcc: functions and
 * types that were never declared, numbers for pointers, pointers of one type for another. */
#define COMPILER_LANGUAGE                                                                          \
    "-std=gnu17 -Werror=implicit-function-declaration -Werror=implicit-int "                       \
    "-Werror=int-conversion -Werror=incompatible-pointer-types"

/* Names of system headers stay as the compiler found them: where one is a link, another place would
 * be told, which differs between distributions. */
#define COMPILER_NAMES "-fno-working-directory -fno-canonical-system-headers"

/* Another gcc than the one called so, for all that is built after this: "gcc-11", in /usr/bin. To be
 * called first of all, before threads are. Returns 0, or -1 and *err: no such program there, or a
 * name that is no gcc's. */
int compiler_choose(const char *name, struct error *err) MUST_CHECK;

/* "gcc", or what was chosen. */
const char *compiler_name(void);

/* The folders that gcc searches for system headers, as it tells them itself; NULL-terminated, asked
 * for once. Without an answer (no compiler) the usual two. Lives as long as the program. */
const char *const *compiler_system_folders(void);

/* What a compiler later than 13 must be told so that it takes what earlier ones take with a warning:
 * a value returned from void, parameters without a type. "" for the others. Asked for once. */
const char *compiler_liberties(void);

#endif
