# Tries: an archive in an archive in an archive
# Stopped by: the depth of nesting
# expect: compile-error, archive-nested

python3 - <<'P'
import io, os, zipfile
data, name = open(os.environ["HOSTILE"] + "/right.c", "rb").read(), "edge-table-closed.c"
for level in range(6):
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as zip:
        zip.writestr(name, data)
    data, name = packed.getvalue(), "level%d.zip" % level
open("upload.zip", "wb").write(data)
P
