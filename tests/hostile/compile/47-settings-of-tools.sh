# Tries: settings of make, the debugger, valgrind and the sanitizers
# Stopped by: the upload: only .c and .h are taken
# expect: passed

mkdir edge-table-closed
cd edge-table-closed
cp "$HOSTILE/right.c" edge-table-closed.c
cp "$HOSTILE/honest.h" .
printf 'all:\n\ttouch /tmp/made\n' | tee Makefile >GNUmakefile
echo 'shell touch /tmp/made' | tee .gdbinit >.lldbinit
echo '--error-exitcode=0 --tool=none' >.valgrindrc
printf '{\n any\n Memcheck:Leak\n ...\n}\n' >default.supp
