# Tries: a file outside of the folder it is unpacked to
# Stopped by: nothing is ever extracted to disk; the path is refused
# expect: compile-error, archive-path

python3 - <<'P'
import os, zipfile
right = open(os.environ["HOSTILE"] + "/right.c", "rb").read()
with zipfile.ZipFile("upload.zip", "w", zipfile.ZIP_DEFLATED) as zip:
    zip.writestr("../../../../tmp/x", right)
    zip.writestr("edge-table-closed.c", right)
P
