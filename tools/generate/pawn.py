#!/usr/bin/env python3
"""pawn.py FOLDER: writes pawn_coarse.obj, a chess pawn of few triangles with normals, for PN triangles (EX13.6)."""
import sys
from math import cos, hypot, pi, sin

SIDES = 7
# Radius, height and the direction of the normal (outward, up), from the foot to the top.
PROFILE = [(.62, 0, 1, 0), (.60, .22, .8, .6), (.34, .42, .6, .8), (.22, .80, 1, .15), (.26, 1.05, 1, -.3),
           (.36, 1.30, 1, -.1), (.30, 1.55, .75, .66)]
TOP = 1.70


def main(folder):
    lines = ["# A coarse chess pawn with normals, made by tools/generate/pawn.py"]
    for radius, height, _, _ in PROFILE:
        for k in range(SIDES):
            a = 2 * pi * k / SIDES
            lines.append(f"v {radius * cos(a):.4f} {height:.4f} {radius * sin(a):.4f}")
    lines.append(f"v 0 {TOP:.4f} 0")
    for _, _, out, up in PROFILE:
        size = hypot(out, up)
        for k in range(SIDES):
            a = 2 * pi * k / SIDES
            lines.append(f"vn {out / size * cos(a):.4f} {up / size:.4f} {out / size * sin(a):.4f}")
    lines.append("vn 0 1 0")

    def corner(row, k):
        n = row * SIDES + k % SIDES + 1
        return f"{n}//{n}"

    for row in range(len(PROFILE) - 1):
        for k in range(SIDES):
            a, b, c, d = corner(row, k), corner(row + 1, k), corner(row + 1, k + 1), corner(row, k + 1)
            lines += [f"f {a} {b} {c}", f"f {a} {c} {d}"]
    top = len(PROFILE) * SIDES + 1
    for k in range(SIDES):
        lines.append(f"f {corner(len(PROFILE) - 1, k)} {top}//{top} {corner(len(PROFILE) - 1, k + 1)}")
    with open(folder + "/pawn_coarse.obj", "w", encoding="ascii") as file:
        file.write("\n".join(lines) + "\n")


main(sys.argv[1])
