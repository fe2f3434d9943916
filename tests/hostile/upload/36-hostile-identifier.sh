# Tries: an identifier that is markup by its escapes
# Stopped by: text stays text in every report
# expect: compile-error, syntax

printf 'int \\u202e_\\u00e9 = <img src=x onerror=alert(1)>;\n' >edge-table-closed.c
