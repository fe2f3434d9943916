# Tries: zero bytes, halves of surrogates and a line of a megabyte in what the compiler prints
# Stopped by: what is no text is replaced, what is long is cut
# expect: compile-error, syntax

{
    printf '#error \355\240\200 \355\277\277 \377\376 \302\233 '
    head -c 200000 /dev/zero | tr '\0' 'y'
    echo
} >edge-table-closed.c
