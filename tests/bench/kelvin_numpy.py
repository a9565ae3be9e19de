#!/usr/bin/env python3
"""The column's straight wake as NumPy's users would write it, and linkdig's, in turns: prints both times and the ratio.

    tests/bench/kelvin_numpy.py build/release/tools/linkdig [ROUNDS]
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np

SPEC = """
[field]
cells = 512
side_m = 512.0
[sampling]
psi_per_cell = 75
u_steps = 750
kind = "column"
[[swimmer]]
name = "boat"
speed_mps = 5.0
damping_per_s = 0.02
[[swimmer.path]]
kind = "line"
points_m = [[40.0, 256.0], [480.0, 256.0]]
"""


def numpy_field():
    field = np.zeros((512, 512))
    u = np.pi * ((np.arange(750) + 0.5) / 750 - 0.5)
    along = -(5 * np.cos(u) - np.cos(3 * u)) / 4
    aside = -(np.sin(u) + np.sin(3 * u)) / 4
    for k in range(440 * 75):
        psi = (k + 0.5) / 75
        t = psi / 5.0
        amplitude = np.cos(9.80665 / 5.0 * t) * np.exp(-((0.02 * t) ** 2))
        x = 480.0 + psi * along - 0.5
        y = 256.0 + psi * aside - 0.5
        i = np.floor(x).astype(int)
        j = np.floor(y).astype(int)
        right, up = x - i, y - j
        keep = (i >= 0) & (j >= 0) & (i < 511) & (j < 511)
        i, j, right, up = i[keep], j[keep], right[keep], up[keep]
        np.add.at(field, (j, i), amplitude * (1 - right) * (1 - up))
        np.add.at(field, (j, i + 1), amplitude * right * (1 - up))
        np.add.at(field, (j + 1, i), amplitude * (1 - right) * up)
        np.add.at(field, (j + 1, i + 1), amplitude * right * up)
    return field


def main():
    binary = sys.argv[1]
    ratios = []
    for _ in range(int(sys.argv[2]) if len(sys.argv) > 2 else 3):
        with tempfile.TemporaryDirectory() as folder:
            spec = pathlib.Path(folder, "spec.toml")
            spec.write_text(SPEC)
            told = subprocess.run([binary, "wake", spec, "-o", pathlib.Path(folder, "f.exr"), "--json"],
                                  check=True, capture_output=True, text=True)
        ours = json.loads(told.stdout)
        begin = time.perf_counter()
        field = numpy_field()
        theirs = time.perf_counter() - begin
        rms = float(np.sqrt(np.mean(field * field)))
        assert abs(rms - ours["rms"]) < 1e-3 * rms, (rms, ours["rms"])  # the same work
        ratios.append(theirs / ours["seconds"])
        print(f"linkdig {ours['seconds']:.3f} s, {ours['samples'] / ours['seconds'] / 1e6:.0f} million samples a second; "
              f"NumPy {theirs:.2f} s; {ratios[-1]:.1f} times")
    print(f"median {np.median(ratios):.1f} times, {min(ratios):.1f} to {max(ratios):.1f}")


main()
