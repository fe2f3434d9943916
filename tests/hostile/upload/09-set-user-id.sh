# Tries: a file that would run as its owner
# Stopped by: nothing is extracted; the answer is taken
# expect: passed

python3 - <<'P'
import io, os, tarfile
right = open(os.environ["HOSTILE"] + "/right.c", "rb").read()
with tarfile.open("upload.tar", "w") as tar:
    def add(name, kind=tarfile.REGTYPE, link="", mode=0o644, data=right):
        entry = tarfile.TarInfo(name)
        entry.type, entry.linkname, entry.mode = kind, link, mode
        entry.size = len(data) if kind == tarfile.REGTYPE else 0
        tar.addfile(entry, io.BytesIO(data))
    add("edge-table-closed.c", mode=0o6777)
    add("honest.h", data=open(os.environ["HOSTILE"] + "/honest.h", "rb").read())
P
