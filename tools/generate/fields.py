#!/usr/bin/env python3
"""Makes the raw float textures in textures/: fields.py FOLDER.

A raw texture is d little-endian integers (its sizes), then RGBA float texels, s fastest. Randomness is an integer
hash of the lattice point, so every machine makes the same files.
"""
import array
import math
import os
import sys


def write_raw(path, sizes, texels):
    """sizes: 2 or 3 integers; texels: RGBA tuples, s fastest."""
    data = array.array("f")
    for texel in texels:
        data.extend(texel)
    header = array.array("i", sizes)
    if sys.byteorder == "big":
        header.byteswap()
        data.byteswap()
    with open(path, "wb") as out:
        out.write(header.tobytes())
        out.write(data.tobytes())


def hashed(i, j, stream):
    """A number in 0 <= x < 1 for a lattice point."""
    h = (i * 0x8DA6B343 ^ j * 0xD8163841 ^ stream * 0xCB1AB31F) & 0xFFFFFFFF
    h = ((h ^ h >> 16) * 0x7FEB352D) & 0xFFFFFFFF
    h = ((h ^ h >> 15) * 0x846CA68B) & 0xFFFFFFFF
    return (h ^ h >> 16) / 4294967296.0


def noise(x, y, stream):
    """Value noise with quintic weights: value in 0..1 and its two derivatives."""
    i, j = math.floor(x), math.floor(y)
    u, v = x - i, y - j
    a, b = hashed(i, j, stream), hashed(i + 1, j, stream)
    c, d = hashed(i, j + 1, stream), hashed(i + 1, j + 1, stream)
    wu, wv = u * u * u * (u * (6 * u - 15) + 10), v * v * v * (v * (6 * v - 15) + 10)
    du, dv = 30 * u * u * (u - 1) ** 2, 30 * v * v * (v - 1) ** 2
    k = a - b - c + d
    return a + (b - a) * wu + (c - a) * wv + k * wu * wv, du * (b - a + k * wv), dv * (c - a + k * wu)


def terrain(width, height):
    """Heights in metres, 0 (sea) to 2891: octaves that fade where the ground is steep, as in eroded mountains."""
    rows = []
    for t in range(height):
        for s in range(width):
            x, y = 5.2 * (s + 0.5) / width + 11.3, 5.2 * (t + 0.5) / width + 4.1
            total = slope_x = slope_y = 0.0
            amplitude = 1.0
            for octave in range(8):
                value, dx, dy = noise(x, y, octave)
                slope_x += dx * 0.9
                slope_y += dy * 0.9
                total += amplitude * value / (1 + slope_x * slope_x + slope_y * slope_y)
                amplitude *= 0.52
                x, y = 1.62 * x - 1.22 * y, 1.22 * x + 1.62 * y
            rows.append(total)
    low, high = sorted(rows)[len(rows) // 5], max(rows)
    for value in rows:
        metres = 2891 * max((value - low) / (high - low), 0.0) ** 1.25
        yield (metres, 0.0, 0.0, 1.0)


def volume(n):
    """A scalar on the cube -1..1: four decaying exponentials, 0..100 in red."""
    centres = ((-0.45, -0.35, 0.40, 3.0, 1.0), (0.50, 0.40, -0.35, 4.5, 0.9), (0.35, -0.50, -0.30, 7.0, 0.75),
               (-0.40, 0.55, 0.10, 9.0, 0.85))
    values = []
    for k in range(n):
        for j in range(n):
            for i in range(n):
                x, y, z = (2 * (c + 0.5) / n - 1 for c in (i, j, k))
                values.append(sum(w * math.exp(-a * ((x - p) ** 2 + (y - q) ** 2 + (z - r) ** 2))
                                  for p, q, r, a, w in centres))
    largest = max(values)
    for value in values:
        yield (100 * value / largest, 0.0, 0.0, 1.0)


def flow(n):
    """A unit vector field on the square in red and green: three eddies, one of which rotates the other way."""
    for j in range(n):
        for i in range(n):
            x, y = 2 * (i + 0.5) / n - 1, 2 * (j + 0.5) / n - 1
            vx = vy = 0.0
            for cx, cy, strength in ((-0.45, 0.25, 1.0), (0.50, -0.30, -1.0), (0.55, 0.65, 0.6)):
                dx, dy = x - cx, y - cy
                fall = strength / (0.03 + dx * dx + dy * dy)
                vx -= dy * fall
                vy += dx * fall
            size = math.hypot(vx, vy)
            yield (vx / size, vy / size, 0.0, 1.0)


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: fields.py FOLDER")
    folder = sys.argv[1]
    write_raw(os.path.join(folder, "terrain.tex"), (256, 144), terrain(256, 144))
    write_raw(os.path.join(folder, "vis3dtexture.tex"), (32, 32, 32), volume(32))
    write_raw(os.path.join(folder, "flow.tex"), (64, 64), flow(64))


if __name__ == "__main__":
    main()
