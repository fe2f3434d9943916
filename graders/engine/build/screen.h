/* Screens the object file that the build box made of a student's code, before it is linked.
 *
 * A bounded reader of ELF64 relocatable objects over bytes that may be anything: code that ran in
 * the compiler's box could have written them. It refuses
 *   - code that runs before or after main: constructor sections, indirect functions; sections that
 *     are not on a short list; an executable stack
 *   - names that are left undefined and stand on no list (names.h), so whatever would let the code
 * leave the measurement: memory past malloc, threads, other stacks, libc's and the allocation
 * shim's inner names, names of the sanitizers; and any that is left undefined weakly, which would
 * tell what stands beside the code
 *   - system calls made directly, requests to valgrind in the code
 *   - more static data than the limit; a missing or unsuitable function of the exercise; a
 *     definition of one that the exercise gives
 * Calls such as fork, open, socket or exit are not refused here: the box refuses them when they are
 * made, and names them.
 *
 * Screen the plain object, and then the one for the sanitizers, which optimises otherwise and may
 * call what the plain one does not. Of that one only code and undefined names are looked at: a
 * sanitizer adds sections, constructors and data of its own, and names, which are on a list.
 *
 * After this the engine makes every global symbol but the exercise's functions local, so it does
 * not matter what else the object defines (its own memcpy, malloc, main, ...). */
#ifndef GRADERS_ENGINE_BUILD_SCREEN_H
#define GRADERS_ENGINE_BUILD_SCREEN_H

#include "graders/engine/base/refusal.h"
#include "reference/base/error.h"

#include <stdbool.h>
#include <stdint.h>

struct screen_rules {
    const char *const *functions; /* NULL-terminated: each must be a defined global function */
    const char *const *given;     /* NULL-terminated: functions that the runner defines for it, and
                                     which it may leave undefined, whatever they are called */
    int64_t static_limit_bytes;   /* of .data + .bss + .tdata + .tbss + .rodata together */
    bool sanitized;               /* the object that was compiled with ASan and UBSan: see below */
};

struct screen {
    struct refusal refusal;
    int64_t static_bytes; /* .data + .bss + .tdata + .tbss and their kin: writable */
    char **undefined;     /* names of the undefined symbols, sorted, each once; untrusted text */
    int undefined_count;
};

/* Screens one object, as compiled or as `ld -r` made it of several.
 *
 * bytes, count  the file
 * screen        zeroed and filled; release it with screen_release
 * returns       0, also when refused (a malformed object is a refusal, "object-malformed");
 *               -1 and *err only when memory runs out
 * Cost: linear in the file. Causes: object-malformed, forbidden-section, constructor,
 * executable-stack, indirect-function, static-data, forbidden-symbol, unknown-symbol
 * (a name on no list, which may just be missing), sanitizer-symbol,
 * tool-request, system-call-instruction, missing-function, not-a-function, given-function. */
int screen_object(const void *bytes, size_t count, const struct screen_rules *rules,
                  struct screen *screen, struct error *err) MUST_CHECK;

/* Screens a linked program, after its object: what the linker put together must not speak to
 * valgrind either, so that nothing in it can tell the tool that counts its work to stop.
 *
 * refusal  filled when refused: tool-request */
void screen_program(const void *bytes, size_t count, struct refusal *refusal);

void screen_release(struct screen *screen);

#endif
