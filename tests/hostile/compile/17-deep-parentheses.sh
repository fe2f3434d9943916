# Tries: 200,000 nested parentheses: the compiler's own stack
# Stopped by: the build box: a compiler that dies is a compile error
# expect: compile-error, syntax
{
    echo '#include "edge-table-closed.h"'
    printf 'int x = '
    head -c 200000 /dev/zero | tr '\0' '('
    printf 1
    head -c 200000 /dev/zero | tr '\0' ')'
    echo ';'
} >edge-table-closed.c
