"""Looks at the screen of an Xvfb that was started with -fbdir: the whole screen lies in a file, in XWD's layout.

    screen.py FILE grab COPY                keeps the screen as it is now
    screen.py COPY png PICTURE.png          for people
    screen.py COPY same OTHER X Y W H       exit code 0 if the rectangle shows the same in both, 1 if not
"""
import struct
import sys
import zlib


def load(path):
    """Width, height and rows of 4-byte pixels (blue, green, red, unused) of an XWD file of 32 bits per pixel."""
    data = open(path, "rb").read()
    header = struct.unpack(">25I", data[:100])
    size, width, height, bits, stride, colours = header[0], header[4], header[5], header[11], header[12], header[19]
    if bits != 32:
        sys.exit(f"{path}: {bits} bits per pixel; expected 32")
    first = size + 12 * colours
    return width, height, [data[first + y * stride:first + y * stride + 4 * width] for y in range(height)]


def write_png(path, width, height, rows):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    raw = bytearray()
    for row in rows:
        line = bytearray(3 * width)
        line[0::3], line[1::3], line[2::3] = row[2::4], row[1::4], row[0::4]
        raw += b"\0" + line
    header = struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(bytes(raw), 1))
                   + chunk(b"IEND", b""))


def rectangle(path, x, y, width, height):
    return [row[4 * x:4 * (x + width)] for row in load(path)[2][y:y + height]]


def main(file, verb, other, *area):
    if verb == "grab":
        data = open(file, "rb").read()
        open(other, "wb").write(data)
    elif verb == "png":
        write_png(other, *load(file))
    elif verb == "same":
        numbers = [int(number) for number in area]
        sys.exit(0 if rectangle(file, *numbers) == rectangle(other, *numbers) else 1)


main(*sys.argv[1:])
