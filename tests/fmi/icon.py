"""Exits with 0 where the file is a PNG of grey pixels whose checksums hold and that shows a pin at least: icon.py FILE"""
import struct
import sys
import zlib

data = open(sys.argv[1], "rb").read()
assert data[:8] == b"\x89PNG\r\n\x1a\n"
at, chunks = 8, {}
while at < len(data):
    size, = struct.unpack(">I", data[at:at + 4])
    kind, content = data[at + 4:at + 8], data[at + 8:at + 8 + size]
    assert struct.unpack(">I", data[at + 8 + size:at + 12 + size])[0] == zlib.crc32(kind + content)
    chunks[kind] = content
    at += 12 + size
width, height = struct.unpack(">II", chunks[b"IHDR"][:8])
rows = zlib.decompress(chunks[b"IDAT"])
assert len(rows) == (width + 1) * height
pixels = b"".join(rows[y * (width + 1) + 1:(y + 1) * (width + 1)] for y in range(height))
dark = sum(pixel < 128 for pixel in pixels)
assert 40 <= dark < len(pixels) / 2, dark  # a pin has 50
