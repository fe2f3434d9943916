# Tries: 50,000 empty files
# Stopped by: the number of entries
# expect: compile-error, too-many-files

python3 - <<'P'
import os, zipfile
right = open(os.environ["HOSTILE"] + "/right.c", "rb").read()
with zipfile.ZipFile("upload.zip", "w", zipfile.ZIP_DEFLATED) as zip:
    for i in range(50000):
        zip.writestr("edge-table-closed/%d.c" % i, b"")
P
