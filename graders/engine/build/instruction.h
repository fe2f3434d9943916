/* How long an x86-64 instruction is, and whether it enters the kernel: just enough of a decoder to
 * know where instructions begin, since the bytes of a system call also occur by chance inside
 * others (measured on 100 MB of Debian's static libraries: 4 times in a megabyte of honest code).
 */
#ifndef GRADERS_ENGINE_BUILD_INSTRUCTION_H
#define GRADERS_ENGINE_BUILD_INSTRUCTION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct instruction {
    size_t bytes;       /* 1..15; 0: no instruction that this decoder knows */
    bool enters_kernel; /* syscall, sysenter, int */
};

/* Decodes the instruction at the front of `count` bytes, in 64-bit mode. One that does not end
 * within them has 0 bytes. Knows the one-byte, 0F, 0F38 and 0F3A maps and VEX and EVEX encodings.
 *
 * Source: Intel 64 and IA-32 Architectures Software Developer's Manual, volume 2, appendix A. */
struct instruction instruction_decode(const uint8_t *code, size_t count);

#endif
