/* The instruction length decoder; see instruction.h. */
#include "graders/engine/build/instruction.h"

enum { INSTRUCTION_BYTES_MAX = 15 };

/* What follows an opcode. */
enum {
    M = 1,  /* a ModRM byte, with its SIB byte and displacement */
    B = 2,  /* an immediate byte */
    W = 4,  /* an immediate of 2 bytes */
    Z = 8,  /* an immediate of 4 bytes, 2 with the operand-size prefix */
    J = 16, /* a jump distance of 4 bytes */
    V = 32, /* an immediate of 2, 4 or 8 bytes: mov to a register */
    A = 64, /* an address of 8 bytes, 4 with the address-size prefix */
    X = 128 /* no instruction in 64-bit mode, or a prefix that is dealt with before */
};

/* clang-format off */
static const uint8_t one_byte_map[256] = {
    M, M, M, M, B, Z, X, X, M, M, M, M, B, Z, X, X,               /* 00: add, or */
    M, M, M, M, B, Z, X, X, M, M, M, M, B, Z, X, X,               /* 10: adc, sbb */
    M, M, M, M, B, Z, X, X, M, M, M, M, B, Z, X, X,               /* 20: and, sub */
    M, M, M, M, B, Z, X, X, M, M, M, M, B, Z, X, X,               /* 30: xor, cmp */
    X, X, X, X, X, X, X, X, X, X, X, X, X, X, X, X,               /* 40: REX */
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,               /* 50: push, pop */
    X, X, X, M, X, X, X, X, Z, M|Z, B, M|B, 0, 0, 0, 0,           /* 60: movsxd, push, imul */
    B, B, B, B, B, B, B, B, B, B, B, B, B, B, B, B,               /* 70: jcc */
    M|B, M|Z, X, M|B, M, M, M, M, M, M, M, M, M, M, M, M,         /* 80: immediate group, mov, lea */
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, X, 0, 0, 0, 0, 0,               /* 90: xchg, cdq */
    A, A, A, A, 0, 0, 0, 0, B, Z, 0, 0, 0, 0, 0, 0,               /* A0: mov, string instructions */
    B, B, B, B, B, B, B, B, V, V, V, V, V, V, V, V,               /* B0: mov immediate */
    M|B, M|B, W, 0, X, X, M|B, M|Z, W|B, 0, W, 0, 0, B, X, 0,     /* C0: shifts, ret, int */
    M, M, M, M, X, X, X, 0, M, M, M, M, M, M, M, M,               /* D0: shifts, x87 */
    B, B, B, B, B, B, B, B, J, J, X, B, 0, 0, 0, 0,               /* E0: loop, call, jmp */
    X, 0, X, X, 0, 0, M, M, 0, 0, 0, 0, 0, 0, M, M,               /* F0: groups 3, 4, 5 */
};

static const uint8_t two_byte_map[256] = {
    M, M, M, M, X, 0, 0, 0, 0, 0, X, 0, X, M, 0, M|B,             /* 00: syscall, ud2, prefetch */
    M, M, M, M, M, M, M, M, M, M, M, M, M, M, M, M,               /* 10: SSE moves, long nop */
    M, M, M, M, X, X, X, X, M, M, M, M, M, M, M, M,               /* 20: control registers, conversions */
    0, 0, 0, 0, 0, 0, X, 0, X, X, X, X, X, X, X, X,               /* 30: rdtsc, sysenter */
    M, M, M, M, M, M, M, M, M, M, M, M, M, M, M, M,               /* 40: cmovcc */
    M, M, M, M, M, M, M, M, M, M, M, M, M, M, M, M,               /* 50 */
    M, M, M, M, M, M, M, M, M, M, M, M, M, M, M, M,               /* 60 */
    M|B, M|B, M|B, M|B, M, M, M, 0, M, M, X, X, M, M, M, M,       /* 70: shuffles, emms */
    J, J, J, J, J, J, J, J, J, J, J, J, J, J, J, J,               /* 80: jcc */
    M, M, M, M, M, M, M, M, M, M, M, M, M, M, M, M,               /* 90: setcc */
    0, 0, 0, M, M|B, M, X, X, 0, 0, 0, M, M|B, M, M, M,           /* A0: cpuid, bt, shld, imul */
    M, M, M, M, M, M, M, M, M, M, M|B, M, M, M, M, M,             /* B0: cmpxchg, movzx, popcnt */
    M, M, M|B, M, M|B, M|B, M|B, M, 0, 0, 0, 0, 0, 0, 0, 0,       /* C0: xadd, cmpps, bswap */
    M, M, M, M, M, M, M, M, M, M, M, M, M, M, M, M,               /* D0 */
    M, M, M, M, M, M, M, M, M, M, M, M, M, M, M, M,               /* E0 */
    M, M, M, M, M, M, M, M, M, M, M, M, M, M, M, M,               /* F0 */
};
/* clang-format on */

struct decoder {
    const uint8_t *code;
    size_t count, at;
    bool short_operand, short_address, wide; /* prefixes 66, 67, REX.W */
};

static bool has(const struct decoder *d, size_t bytes)
{
    return d->count - d->at >= bytes;
}

/* Passes over the legacy prefixes and REX. */
static void pass_prefixes(struct decoder *d)
{
    for (; has(d, 1); d->at++) {
        switch (d->code[d->at]) {
        case 0x66:
            d->short_operand = true;
            continue;
        case 0x67:
            d->short_address = true;
            continue;
        case 0x26:
        case 0x2e:
        case 0x36:
        case 0x3e:
        case 0x64:
        case 0x65:
        case 0xf0:
        case 0xf2:
        case 0xf3:
            continue;
        default:
            break;
        }
        break;
    }
    if (has(d, 1) && (d->code[d->at] & 0xf0) == 0x40)
        d->wide = d->code[d->at++] & 8;
}

/* Bytes of ModRM, SIB and displacement; 0 when they are cut off. */
static size_t operand_bytes(const struct decoder *d)
{
    if (!has(d, 1))
        return 0;
    unsigned mode = d->code[d->at] >> 6, base = d->code[d->at] & 7;
    size_t bytes = 1;
    if (mode == 3)
        return bytes;
    if (base == 4) {
        if (!has(d, 2))
            return 0;
        base = d->code[d->at + 1] & 7;
        bytes = 2;
    }
    if (mode == 1)
        return bytes + 1;
    return mode == 2 || base == 5 ? bytes + 4 : bytes;
}

static size_t immediate_bytes(const struct decoder *d, unsigned shape)
{
    size_t bytes = 0;
    if (shape & B)
        bytes += 1;
    if (shape & W)
        bytes += 2;
    if (shape & J)
        bytes += 4;
    if (shape & Z)
        bytes += d->short_operand && !d->wide ? 2 : 4;
    if (shape & V)
        bytes += d->wide ? 8 : d->short_operand ? 2 : 4;
    if (shape & A)
        bytes += d->short_address ? 4 : 8;
    return bytes;
}

static struct instruction finish(struct decoder *d, unsigned shape, bool enters_kernel)
{
    const struct instruction unknown = {0};
    if (shape & X)
        return unknown;
    if (shape & M) {
        size_t bytes = operand_bytes(d);
        if (!bytes || !has(d, bytes))
            return unknown;
        d->at += bytes;
    }
    size_t bytes = immediate_bytes(d, shape);
    if (!has(d, bytes) || d->at + bytes > INSTRUCTION_BYTES_MAX)
        return unknown;
    return (struct instruction){.bytes = d->at + bytes, .enters_kernel = enters_kernel};
}

/* VEX (C4, C5) and EVEX (62): a prefix that also names the opcode map. */
static struct instruction decode_vector(struct decoder *d)
{
    const struct instruction unknown = {0};
    size_t prefix = d->code[d->at] == 0xc5 ? 2 : d->code[d->at] == 0xc4 ? 3 : 4;
    if (!has(d, prefix + 1))
        return unknown;
    unsigned map = prefix == 2 ? 1 : d->code[d->at + 1] & (prefix == 3 ? 31 : 7);
    uint8_t opcode = d->code[d->at + prefix];
    d->at += prefix + 1;
    switch (map) {
    case 1:
        return finish(d, two_byte_map[opcode] & (M | B), false);
    case 2:
    case 5:
    case 6:
        return finish(d, M, false);
    case 3:
        return finish(d, M | B, false);
    default:
        return unknown;
    }
}

static struct instruction decode_two_byte(struct decoder *d)
{
    const struct instruction unknown = {0};
    if (!has(d, 1))
        return unknown;
    uint8_t opcode = d->code[d->at++];
    if (opcode == 0x38 || opcode == 0x3a) {
        if (!has(d, 1))
            return unknown;
        d->at++;
        return finish(d, opcode == 0x38 ? M : M | B, false);
    }
    return finish(d, two_byte_map[opcode], opcode == 0x05 || opcode == 0x34);
}

struct instruction instruction_decode(const uint8_t *code, size_t count)
{
    struct decoder d = {.code = code,
                        .count =
                            count < INSTRUCTION_BYTES_MAX ? count : (size_t)INSTRUCTION_BYTES_MAX};
    pass_prefixes(&d);
    if (!has(&d, 1))
        return (struct instruction){0};
    uint8_t opcode = code[d.at];
    if (opcode == 0x62 || opcode == 0xc4 || opcode == 0xc5)
        return decode_vector(&d);
    d.at++;
    if (opcode == 0x0f)
        return decode_two_byte(&d);
    unsigned shape = one_byte_map[opcode];
    if ((opcode == 0xf6 || opcode == 0xf7) && has(&d, 1) && (code[d.at] >> 3 & 7) < 2)
        shape |= opcode == 0xf6 ? B : Z; /* test, the one of its group with an immediate */
    return finish(&d, shape, opcode == 0xcd);
}
