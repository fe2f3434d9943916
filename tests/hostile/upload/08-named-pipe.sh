# Tries: a pipe that makes the reader wait
# Stopped by: only plain files
# expect: compile-error, archive-device

python3 - <<'P'
import io, os, tarfile
right = open(os.environ["HOSTILE"] + "/right.c", "rb").read()
with tarfile.open("upload.tar", "w") as tar:
    def add(name, kind=tarfile.REGTYPE, link="", mode=0o644, data=right):
        entry = tarfile.TarInfo(name)
        entry.type, entry.linkname, entry.mode = kind, link, mode
        entry.size = len(data) if kind == tarfile.REGTYPE else 0
        tar.addfile(entry, io.BytesIO(data))
    add("edge-table-closed.c", tarfile.FIFOTYPE)
P
