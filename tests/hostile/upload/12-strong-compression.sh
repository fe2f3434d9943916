# Tries: 300 MB of nothing in a small archive
# Stopped by: the ratio of unpacked to packed bytes
# expect: compile-error, archive-ratio

python3 - <<'P'
import os, zipfile
right = open(os.environ["HOSTILE"] + "/right.c", "rb").read()
with zipfile.ZipFile("upload.zip", "w", zipfile.ZIP_DEFLATED) as zip:
    with zip.open("edge-table-closed.c", "w") as file:
        for _ in range(300):
            file.write(bytes(1 << 20))
P
