# Tries: an archive with a password
# Stopped by: the reader of archives
# expect: compile-error, archive-encrypted

python3 - <<'P'
import os, zipfile
right = open(os.environ["HOSTILE"] + "/right.c", "rb").read()
with zipfile.ZipFile("upload.zip", "w", zipfile.ZIP_DEFLATED) as zip:
    zip.writestr("edge-table-closed.c", right)
data = bytearray(open("upload.zip", "rb").read())
data[6] |= 1
data[data.index(b"PK\x01\x02") + 8] |= 1
open("upload.zip", "wb").write(data)
P
