#!/usr/bin/env python3
"""One image, as whole processes: `glibra render` against the bare EGL program of floor.cpp, in turn, in one run.

usage: tests/bench/one_image.py [RUNS]      (needs: cmake --preset bench && cmake --build build/bench)

Prints both wall times and their ratio, pair by pair: minimum, median, maximum. The first pair warms Mesa's shader cache and
is not counted.
"""
import os
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BUILD = os.path.join(ROOT, "build", "bench")

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
void main() {
    float d = max(0., dot(normalize(vN), normalize(vL)));
    fColor = vec4((.2 + .8 * d) * vColor.rgb, 1.);
}
"""


def wall(command):
    start = time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return time.perf_counter() - start


def main():
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 25
    with tempfile.TemporaryDirectory() as folder:
        for name, text in (("lit.glib", SCENE), ("lit.vert", VERTEX), ("lit.frag", FRAGMENT)):
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        floor = [os.path.join(BUILD, "tests", "bench", "glibra_floor"), os.path.join(folder, "floor.png")]
        glibra = [os.path.join(BUILD, "glibra"), "render", os.path.join(folder, "lit.glib"), "-o",
                  os.path.join(folder, "glibra.png")]
        pairs = [(wall(floor), wall(glibra)) for _ in range(runs + 1)][1:]
    for name, values in (("floor", [a for a, _ in pairs]), ("glibra", [b for _, b in pairs]),
                         ("ratio", [b / a for a, b in pairs])):
        unit = 1 if name == "ratio" else 1000
        print(f"{name:7} min {min(values) * unit:8.3f}  median {statistics.median(values) * unit:8.3f}  "
              f"max {max(values) * unit:8.3f}{'' if name == 'ratio' else ' ms'}")


if __name__ == "__main__":
    main()
