#!/usr/bin/env python3
"""A hilly terrain of many triangles, for measuring the compiler and the reader.

    terrain.py FACES FOLDER [--obj]    writes FOLDER/terrain.toml, with --obj also FOLDER/terrain.obj

The terrain is a square of FACES triangles, two to a cell of 20 m: three waves and a hash of the cell for roughness, so that
it has ridges, hollows and slopes that hide one another. No randomness: the same bytes every time.
"""
import math
import pathlib
import sys

CELL_M = 20.0

DATABASE = """[database]
name = "terrain"

[[colour]]
name = "earth"
rgb = [118, 132, 92]

[[sun]]
name = "world"

[[cluster]]
name = "terrain"
priority = 20

[[object_list]]
name = "terrain"
cluster = "terrain"
sun = "world"
"""


def roughness(i, j):
    value = (i * 73856093 ^ j * 19349663) & 0xFFFFFFFF
    value = (value * 2654435761) & 0xFFFFFFFF
    return (value >> 16) / 65536.0 - 0.5


def height_m(i, j):
    x, y = i * CELL_M, j * CELL_M
    return round(180 * math.sin(x / 1900) * math.cos(y / 1500) + 60 * math.sin((x + 2 * y) / 610)
                 + 12 * math.sin(x / 90) * math.sin(y / 110) + 2 * roughness(i, j), 2)


def sections(first, end, side):
    """Rows of points along y: the loft's faces look up."""
    half = side * CELL_M / 2
    for i in range(first, end + 1):
        yield [(i * CELL_M - half, j * CELL_M - half, height_m(i, j)) for j in range(side + 1)]


def write_loft(out, side):
    for part, first in enumerate(range(0, side, 250)):  # a loft may make a million faces at most
        end = min(side, first + 250)
        out.write(f'\n[[object]]\nname = "terrain {part + 1}"\nlist = "terrain"\ncolour = "earth"\n'
                  'shading = "vertex"\n\n[[object.loft]]\nflip = true\nsections_m = [\n')
        for row in sections(first, end, side):
            out.write("[" + ",".join(f"[{x:g},{y:g},{z:g}]" for x, y, z in row) + "],\n")
        out.write("]\n")


def write_obj(out, side):
    out.write("usemtl earth\n")
    for row in sections(0, side, side):
        out.writelines(f"v {x:g} {y:g} {z:g}\n" for x, y, z in row)
    for i in range(side):
        for j in range(side):
            a = i * (side + 1) + j + 1
            b, c, d = a + side + 1, a + side + 2, a + 1
            out.write(f"f {a} {b} {c}\nf {a} {c} {d}\n")


def main():
    faces, folder = int(sys.argv[1]), pathlib.Path(sys.argv[2])
    side = math.ceil(math.sqrt(faces / 2))
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / "terrain.toml", "w", encoding="ascii") as out:
        out.write(DATABASE)
        write_loft(out, side)
    if "--obj" in sys.argv[3:]:
        with open(folder / "terrain.obj", "w", encoding="ascii") as out:
            write_obj(out, side)


if __name__ == "__main__":
    main()
