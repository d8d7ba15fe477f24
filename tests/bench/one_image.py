#!/usr/bin/env python3
"""One image, as whole processes: `glibra render` against the bare EGL program of floor.cpp, alternating in one run.

usage: tests/bench/one_image.py [RUNS]      (needs: cmake --preset bench && cmake --build build/bench)

Prints both wall times and the ratios of all pairs: minimum, median, maximum. The first pair warms Mesa's shader cache and
is not counted.
"""
import os
import sys
import tempfile

from processes import FLOOR, GLIBRA, measure, pairs, ratios, spread

SCENE = """WindowSize 600 600
Perspective 50 .1 1000
LookAt 0 0 3 0 0 0 0 1 0
Vertex lit.vert
Fragment lit.frag
Program Lit
Color 1 .5 0
Sphere 1 60 60
"""
VERTEX = """#version 450 core
out vec3 vN, vL;
out vec4 vColor;
void main() {
    vec4 position = uModelViewMatrix * aVertex;
    vN = uNormalMatrix * aNormal;
    vL = vec3(3., 5., 10.) - position.xyz;
    vColor = aColor;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
"""
FRAGMENT = """#version 450 core
in vec3 vN, vL;
in vec4 vColor;
out vec4 fColor;
uniform float Timer;
void main() {
    float d = max(0., dot(normalize(vN), normalize(vL)));
    fColor = vec4((1. - .5 * Timer) * (.2 + .8 * d) * vColor.rgb, 1.);
}
"""


def write_scene(folder):
    """The sphere of floor.cpp as a scene; returns its path."""
    for name, text in (("lit.glib", SCENE), ("lit.vert", VERTEX), ("lit.frag", FRAGMENT)):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)
    return os.path.join(folder, "lit.glib")


def main():
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 25
    with tempfile.TemporaryDirectory() as folder:
        scene = write_scene(folder)
        floor, glibra = pairs(lambda: measure([FLOOR, os.path.join(folder, "floor.png")]),
                              lambda: measure([GLIBRA, "render", scene, "-o", os.path.join(folder, "glibra.png")]),
                              runs)
    floor, glibra = [each.wall for each in floor], [each.wall for each in glibra]
    for name, values, unit in (("floor", floor, 1000), ("glibra", glibra, 1000), ("ratio", ratios(glibra, floor), 1)):
        least, median, most = (each * unit for each in spread(values))
        print(f"{name:7} min {least:8.3f}  median {median:8.3f}  max {most:8.3f}{'' if name == 'ratio' else ' ms'}")


if __name__ == "__main__":
    main()
