# 0 "main.c"
# 0 "<built-in>"
# 0 "<command-line>"
# 1 "/usr/include/stdc-predef.h" 1 3 4
# 0 "<command-line>" 2
# 1 "main.c"
# 1 "/usr/include/stdio.h" 1 3 4
extern int fscanf (void *f, ...) __asm__ ("" "__isoc99_fscanf") __attribute__ ((__nothrow__ , __leaf__));
#pragma GCC push_options
#pragma GCC target("sse2")
static inline void f(void) { __asm__ volatile ("tilerelease" ::); }
# 2 "main.c" 2
[[gnu::unused]] int a<:3:>; __attribute__((aligned(8), section(".x"))) int b;
_Pragma
