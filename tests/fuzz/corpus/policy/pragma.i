struct s { int a __attribute__((aligned(8))); };
_Pragma("GCC push_options")
__asm__ volatile ("syscall");
const char *r = R"x(a)x";
