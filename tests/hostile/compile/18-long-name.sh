# Tries: a name of 900,000 letters
# Stopped by: the screen of the object: no honest name is so long
# expect: compile-error, object-malformed
{
    printf 'int '
    head -c 900000 /dev/zero | tr '\0' 'x'
    echo ';'
} >edge-table-closed.c
