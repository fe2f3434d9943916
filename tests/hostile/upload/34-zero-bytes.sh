# Tries: a source that ends early for who reads it as a string
# Stopped by: the build takes files by length: all of it is compiled
# expect: compile-error, syntax

cp "$HOSTILE/honest.h" .
{
    cat "$HOSTILE/right.c"
    printf '\000'
    echo '#error "behind the zero"'
} >edge-table-closed.c
