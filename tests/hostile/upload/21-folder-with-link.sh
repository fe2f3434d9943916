# Tries: a link to a file of the host, in a folder
# Stopped by: the upload: links are refused
# expect: compile-error, link

ln -s /etc/passwd edge-table-closed.c
