# Tries: an archive that ends in the middle
# Stopped by: the reader of archives: broken
# expect: compile-error, archive-broken

python3 - <<'P'
import os, zipfile
right = open(os.environ["HOSTILE"] + "/right.c", "rb").read()
with zipfile.ZipFile("upload.zip", "w", zipfile.ZIP_DEFLATED) as zip:
    zip.writestr("edge-table-closed.c", right * 50)
data = open("upload.zip", "rb").read()
open("upload.zip", "wb").write(data[: len(data) // 2])
P
