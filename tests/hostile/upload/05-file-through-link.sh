# Tries: a link to a folder, and a file through it
# Stopped by: links are refused; nothing is extracted
# expect: compile-error, archive-link

python3 - <<'P'
import io, os, tarfile
right = open(os.environ["HOSTILE"] + "/right.c", "rb").read()
with tarfile.open("upload.tar", "w") as tar:
    def add(name, kind=tarfile.REGTYPE, link="", mode=0o644, data=right):
        entry = tarfile.TarInfo(name)
        entry.type, entry.linkname, entry.mode = kind, link, mode
        entry.size = len(data) if kind == tarfile.REGTYPE else 0
        tar.addfile(entry, io.BytesIO(data))
    add("sub", tarfile.SYMTYPE, "/tmp")
    add("sub/x.c")
    add("edge-table-closed.c")
P
