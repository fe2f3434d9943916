# Tries: a header that says that the file has fewer bytes than none
# Stopped by: the reader of archives: broken
# expect: compile-error, archive-broken

python3 - <<'P'
import os
block = bytearray(1024)
block[0:19] = b"edge-table-closed.c"
block[100:107] = b"0000644"
block[124:136] = b"\xff" * 12
block[156] = ord("0")
block[257:263] = b"ustar\0"
block[148:156] = b" " * 8
block[148:156] = b"%06o\0 " % sum(block[:512])
open("upload.tar", "wb").write(block)
P
