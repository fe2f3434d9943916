/* A heap overflow that is survived when the sanitizer's end is a signal, for rows that make it one. */
#ifndef HOSTILE_SURVIVE_H
#define HOSTILE_SURVIVE_H

#include <setjmp.h>
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>

static sigjmp_buf place_before;

static void jump_out(int signal_number)
{
    (void)signal_number;
    siglongjmp(place_before, 1);
}

/* Overflows a block, and goes on when the sanitizer's end became a signal. */
static void overflow(int signal_number)
{
    volatile size_t bytes = 64; /* out of sight of UBSan */
    volatile int32_t *table = malloc(bytes);
    signal(signal_number, jump_out);
    if (sigsetjmp(place_before, 1) == 0)
        table[16] = 1;
}

#endif
