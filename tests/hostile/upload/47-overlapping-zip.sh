# Tries: a .zip whose 1,000 entries share one compressed megabyte
# Stopped by: the archive reader: entries of one place are one entry; none is an exercise
# expect: compile-error, no-source

python3 - <<'P'
import struct, zlib
packer = zlib.compressobj(9, zlib.DEFLATED, -15)
plain = b"\0" * (1 << 20)
data = packer.compress(plain) + packer.flush()
crc, name = zlib.crc32(plain), b"f000.c"
local = struct.pack("<4s5H3L2H", b"PK\3\4", 20, 0, 8, 0, 0x21, crc, len(data), len(plain), len(name), 0) + name
central = b"".join(struct.pack("<4s6H3L5H2L", b"PK\1\2", 20, 20, 0, 8, 0, 0x21, crc, len(data), len(plain), 6, 0, 0, 0, 0, 0, 0)
                   + b"f%03d.c" % i for i in range(1000))
start = len(local) + len(data)
end = struct.pack("<4s4H2LH", b"PK\5\6", 0, 0, 1000, 1000, len(central), start, 0)
open("upload.zip", "wb").write(local + data + central + end)
P
