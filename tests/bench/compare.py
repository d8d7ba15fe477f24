#!/usr/bin/env python3
"""Comparing pictures, as whole processes: `glibra compare` against OpenImageIO's `idiff`, alternating in one run.

usage: tests/bench/compare.py [RUNS]        (needs: cmake --preset bench && cmake --build build/bench, and the Debian
                                             package openimageio-tools)

A 1024 x 1024 picture of a scene is compared with a copy of its file, with the same pixels in another file, and with a picture that
differs by one step in some pixels, where a tolerance decides. Prints both wall times and the ratios of all pairs: minimum,
median, maximum. The first pair is not counted.

Then FLIP, in one process, against the authors' program if CMake was given -DGLIBRA_FLIP_H=.../src/cpp/FLIP.h
(github.com/NVlabs/flip): two pictures of 1024 x 1024 pixels of noise, so that no pixel is equal.
"""
import os
import statistics
import subprocess
import sys
import tempfile
import time
import zlib

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BUILD = os.environ.get("GLIBRA_BENCH_BUILD", os.path.join(ROOT, "build", "bench"))
GLIBRA = os.path.join(BUILD, "glibra")
SIDE = 1024  # pixels


def chunk(kind, content):
    return (len(content).to_bytes(4, "big") + kind + content + zlib.crc32(kind + content).to_bytes(4, "big"))


def predicted(kind, left, up, corner):
    """What a PNG filter subtracts (W3C PNG, 9.2)."""
    if kind == 4:
        guess = left + up - corner
        return min((left, up, corner), key=lambda each: abs(guess - each))
    return (0, left, up, (left + up) // 2)[kind]


def png_parts(data):
    """The rows of an RGB file with 8 bits a component, and its chunks before the pixels."""
    at, before, packed = 8, data[:8], b""
    while at < len(data):
        length = int.from_bytes(data[at:at + 4], "big")
        kind = data[at + 4:at + 8]
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        elif kind != b"IEND":
            before += data[at:at + 12 + length]
        at += 12 + length
    filtered, stride, rows = zlib.decompress(packed), 3 * SIDE, []
    above = bytearray(stride)
    for y in range(SIDE):
        kind, *row = filtered[y * (stride + 1):(y + 1) * (stride + 1)]
        for i in range(stride):
            left, corner = (row[i - 3], above[i - 3]) if i >= 3 else (0, 0)
            row[i] = (row[i] + predicted(kind, left, above[i], corner)) % 256
        above = bytearray(row)
        rows.append(above)
    return before, rows


def write_png(path, before, rows):
    """With the filter "up" for all rows."""
    filtered, above = bytearray(), bytes(3 * SIDE)
    for row in rows:
        filtered += b"\2" + bytes((a - b) % 256 for a, b in zip(row, above))
        above = row
    with open(path, "wb") as file:
        file.write(before + chunk(b"IDAT", zlib.compress(bytes(filtered), 1)) + chunk(b"IEND", b""))


def wall(command):
    start = time.perf_counter()
    status = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False).returncode
    if status not in (0, 1):  # idiff gives 1 for what it only warns of
        raise RuntimeError(f"{command}: exit status {status}")
    return time.perf_counter() - start


def show(title, first, second, pairs):
    print(title)
    for name, values in ((first, [a for a, _ in pairs]), (second, [b for _, b in pairs]),
                         ("ratio", [a / b for a, b in pairs])):
        unit = 1 if name == "ratio" else 1000
        print(f"  {name:7} min {min(values) * unit:8.3f}  median {statistics.median(values) * unit:8.3f}  "
              f"max {max(values) * unit:8.3f}{'' if name == 'ratio' else ' ms'}")


def files(folder):
    picture = os.path.join(folder, "a.png")
    subprocess.run([GLIBRA, "render", os.path.join(ROOT, "glib", "noise", "marble.glib"), "--size", f"{SIDE}x{SIDE}", "-o",
                    picture], check=True)
    with open(picture, "rb") as file:
        data = file.read()
    copy, repacked, near = (os.path.join(folder, name) for name in ("copy.png", "repacked.png", "near.png"))
    with open(copy, "wb") as file:
        file.write(data)
    before, rows = png_parts(data)
    write_png(repacked, before, rows)
    for y in range(3, SIDE - 3, 7):  # one step in one pixel
        at = (y * 97) % (3 * SIDE)
        rows[y][at] += 1 if rows[y][at] < 255 else -1
    write_png(near, before, rows)
    return picture, (("equal files", copy), ("equal pixels, other files", repacked), ("a tolerance decides", near))


def main():
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 15
    with tempfile.TemporaryDirectory() as folder:
        picture, others = files(folder)
        for title, other in others:
            idiff = ["idiff", "-fail", "0.0118", "-warn", "0.0118", picture, other]
            glibra = [GLIBRA, "compare", picture, other]
            show(title, "idiff", "glibra", [(wall(idiff), wall(glibra)) for _ in range(runs + 1)][1:])
    flip = os.path.join(BUILD, "tests", "bench", "glibra_flip")
    if os.path.exists(flip):
        subprocess.run([flip, str(runs)], check=True)


if __name__ == "__main__":
    main()
