# Tries: 10^6 errors: a log without end
# Stopped by: the compiler stops after 20 errors
# expect: compile-error, syntax

{
    echo '#define A x; x; x; x; x; x; x; x; x; x;'
    echo '#define B A A A A A A A A A A'
    echo '#define C B B B B B B B B B B'
    echo '#define D C C C C C C C C C C'
    echo 'int f(void) {'
    for i in $(seq 100); do echo D; done
    echo '}'
} >edge-table-closed.c
