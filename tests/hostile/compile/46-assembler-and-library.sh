# Tries: code past the policy, in a .s file and a library
# Stopped by: the upload: only .c and .h are taken
# expect: passed

mkdir edge-table-closed
cd edge-table-closed
cp "$HOSTILE/right.c" edge-table-closed.c
cp "$HOSTILE/honest.h" .
printf '.globl malloc\nmalloc: mov $60, %%eax\nsyscall\n' >x.s
as x.s -o x.o
ar qc libm.a x.o
rm x.o
