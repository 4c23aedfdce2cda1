"""A PNG writer: standard library only."""

import struct
import zlib


def encode(width, height, channels, rows):
    """8-bit PNG; `rows` are `height` rows of `width` × `channels` values from 0 to 255, top first."""
    def chunk(kind, payload):
        body = kind + payload
        return struct.pack(">I", len(payload)) + body + struct.pack(">I", zlib.crc32(body))

    raw = b"".join(b"\0" + bytes(row) for row in rows)
    kinds = {1: 0, 3: 2, 4: 6}
    header = struct.pack(">IIBBBBB", width, height, 8, kinds[channels], 0, 0, 0)
    # The pixels are the same anywhere; the packed bytes are those of the zlib that Python was built with.
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(raw, 9)) +
            chunk(b"IEND", b""))


def write(file, width, height, channels, rows):
    with open(file, "wb") as out:
        out.write(encode(width, height, channels, rows))
