# Tries: 255 folders in each other
# Stopped by: the depth of paths
# expect: compile-error, archive-path

python3 - <<'P'
import os, zipfile
right = open(os.environ["HOSTILE"] + "/right.c", "rb").read()
with zipfile.ZipFile("upload.zip", "w", zipfile.ZIP_DEFLATED) as zip:
    zip.writestr("a/" * 255 + "edge-table-closed.c", right)
P
