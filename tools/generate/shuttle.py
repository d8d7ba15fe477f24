#!/usr/bin/env python3
"""shuttle.py FOLDER: writes shuttle.obj, a small space plane with texture coordinates and normals, nose along -z.

Parts of the texture: left half the hull (s around it from below, t from the nose to the tail), lower right the wings from
above, upper right the fin and the engines.
"""
import math
import sys

vertices, coordinates, normals, faces = [], [], [], []


def corner(place, coordinate, normal):
    length = math.sqrt(sum(x * x for x in normal)) or 1.0
    vertices.append(place)
    coordinates.append(coordinate)
    normals.append([x / length for x in normal])
    return len(vertices)


def grid(columns, rows, point):
    """Quads over 0..1 x 0..1; point(s, t) gives a place and a texture coordinate."""
    h = 1e-4
    numbers = []
    for j in range(rows + 1):
        for i in range(columns + 1):
            s, t = i / columns, j / rows
            place, coordinate = point(s, t)
            tn = min(max(t, 2 * h), 1 - 2 * h)
            a = [x - y for x, y in zip(point(s + h, tn)[0], point(s - h, tn)[0])]
            b = [x - y for x, y in zip(point(s, tn + h)[0], point(s, tn - h)[0])]
            n = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
            numbers.append(corner(place, coordinate, n))
    for j in range(rows):
        for i in range(columns):
            k = j * (columns + 1) + i
            faces.append([numbers[k], numbers[k + 1], numbers[k + columns + 2], numbers[k + columns + 1]])


def hull(s, t):
    # A blunt nose, a long middle, a slightly narrower tail; flat below.
    z = -1.3 + 2.3 * t
    radius = 0.30 * min(1.0, math.sqrt(max(1 - (1 - t / 0.3) ** 2, 0.0)) if t < 0.3 else 1.0) * (1 - 0.12 * max(t - 0.7, 0) / 0.3)
    angle = 2 * math.pi * s - math.pi / 2
    x, y = radius * math.cos(angle), radius * math.sin(angle) * (0.8 if math.sin(angle) < 0 else 1.0)
    y -= 0.06 * (1 - min(t / 0.3, 1.0)) ** 2
    return [x, y, z], [0.5 * s, t]


def flat(points, thickness, up, place_coordinate):
    """A plate with these corners, on both sides, and its rim."""
    for side in (1, -1):
        numbers = []
        for p in points if side > 0 else reversed(points):
            place = [x + 0.5 * side * thickness * u for x, u in zip(p, up)]
            numbers.append(corner(place, place_coordinate(p), [side * u for u in up]))
        faces.append(numbers)
    for p, q in zip(points, points[1:] + points[:1]):
        along = [b - a for a, b in zip(p, q)]
        out = [along[1] * up[2] - along[2] * up[1], along[2] * up[0] - along[0] * up[2], along[0] * up[1] - along[1] * up[0]]
        numbers = []
        for r, side in ((p, -1), (q, -1), (q, 1), (p, 1)):
            place = [x + 0.5 * side * thickness * u for x, u in zip(r, up)]
            numbers.append(corner(place, place_coordinate(r), out))
        faces.append(numbers)


def engine(x, y):
    def bell(s, t):
        radius = 0.05 + 0.05 * t
        angle = 2 * math.pi * s
        return [x + radius * math.cos(angle), y + radius * math.sin(angle), 0.98 + 0.2 * t], [0.8 + 0.15 * s, 0.55 + 0.4 * t]

    grid(12, 2, bell)


def tail(s, t):
    # A disk that closes the hull.
    place, _ = hull(s, 1.0)
    return [place[0] * (1 - t), place[1] * (1 - t), 1.0], [0.5 * s, 0.99]


grid(24, 16, hull)
grid(24, 1, tail)
wing = [[0.2, -0.16, -0.55], [0.2, -0.16, 0.95], [1.0, -0.16, 0.9], [1.0, -0.16, 0.55], [0.48, -0.16, 0.1]]
for mirrored in (False, True):
    points = [[-p[0], p[1], p[2]] for p in reversed(wing)] if mirrored else wing
    flat(points, 0.05, [0, 1, 0], lambda p: [0.5 + 0.5 * abs(p[0]), 0.5 * (0.95 - p[2]) / 1.5])
flat([[0, 0.2, 0.35], [0, 0.2, 0.95], [0, 0.78, 1.12], [0, 0.78, 0.85]], 0.05, [-1, 0, 0],
     lambda p: [0.5 + 0.28 * (p[2] - 0.3), 0.5 + 0.5 * (p[1] - 0.2) / 0.58])
for x, y in ((0, 0.13), (-0.12, -0.06), (0.12, -0.06)):
    engine(x, y)


def key(values):
    return " ".join(("%.4f" % (v + 0.0)).replace("-0.0000", "0.0000") for v in values)


def indexed(lines, word, values):
    table, numbers = {}, []
    for v in values:
        text = key(v)
        if text not in table:
            table[text] = len(table) + 1
            lines.append(word + " " + text)
        numbers.append(table[text])
    return numbers


lines = ["# A space plane, made by tools/generate/shuttle.py."]
v, vt, vn = indexed(lines, "v", vertices), indexed(lines, "vt", coordinates), indexed(lines, "vn", normals)
for face in faces:
    lines.append("f " + " ".join("%d/%d/%d" % (v[k - 1], vt[k - 1], vn[k - 1]) for k in face))
with open(sys.argv[1] + "/shuttle.obj", "w", encoding="ascii") as file:
    file.write("\n".join(lines) + "\n")
