# Tries: 100,000 braces in each other: the compiler's own stack
# Stopped by: the build box: a compiler that dies is a compile error
# expect: compile-error, syntax

{
    printf 'int a[] = '
    printf '{%.0s' $(seq 100000)
    echo 1
    printf '}%.0s' $(seq 100000)
    echo ';'
    cat "$HOSTILE/right.c"
} >edge-table-closed.c
cp "$HOSTILE/honest.h" .
