# Tries: markup, escapes and ]]> in what the compiler prints
# Stopped by: text stays text in every report
# expect: compile-error, syntax

printf '#error </pre><script>alert(1)</script> \033[2J\033]8;;http://x\007 ]]> =HYPERLINK("x") \342\200\256\n' >edge-table-closed.c
