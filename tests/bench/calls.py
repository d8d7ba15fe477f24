#!/usr/bin/env python3
"""GL calls, and bytes copied, per step of the simulations: glibra's against those of the bare programs.

usage: tests/bench/calls.py
       (needs: cmake --preset bench && cmake --build build/bench; x86-64)

Each program runs twice, with 100 and with 1,100 steps. The difference of its calls is what 1,000 steps cost.
"""
import glob
import os
import struct
import subprocess
import tempfile

from processes import GLIBRA, ROOT, TOOLS

BARE = os.environ.get("GLIBRA_BARE", os.path.join(TOOLS, "glibra_bare"))
LIBRARY = os.environ.get("GLIBRA_COUNT_CALLS", os.path.join(TOOLS, "libglibra_count_calls.so"))
STEPS = (100, 1100)
# name, scene, what sets its size, the size, steps a second, bytes of a texel
SUBJECTS = (("life", "life", "side", 64, 10, 1), ("particles", "fountain", "count", 1000, 60, 1))


def counts(command):
    """How often each function was called, by its name."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL,
                       env=dict(os.environ, LD_PRELOAD=LIBRARY, GLIBRA_CALLS=folder))
        calls = {}
        for path in glob.glob(os.path.join(folder, "*")):
            with open(path, "rb") as file:
                for name, count in struct.iter_unpack("=56sQ", file.read()):
                    name = name.split(b"\0")[0].decode()
                    if name and count:
                        calls[name] = calls.get(name, 0) + count
        return calls


def per_step(commands):
    few, many = (counts(each) for each in commands)
    return {name: (many[name] - few.get(name, 0)) / (STEPS[1] - STEPS[0])
            for name in many if many[name] != few.get(name, 0)}


def row(what, steps, texel_bytes):
    copied = steps.pop("texels copied", 0) * texel_bytes + steps.pop("buffer bytes copied", 0)
    listed = ", ".join(f"{name} {count:g}" for name, count in sorted(steps.items()) if count >= .1)
    return f"| {what} | {sum(steps.values()):.2f} | {copied:,.0f} | {listed} |"


def main():
    print("| | calls / step | bytes copied / step | functions |\n|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        picture = os.path.join(folder, "picture.png")
        for name, scene, key, size, rate, texel_bytes in SUBJECTS:
            path = os.path.join(ROOT, "glib", "modern", scene + ".glib")
            glibra = [[GLIBRA, "render", path, "-o", picture, "--set", f"{key}={size}", "--time", str(steps / rate)]
                      for steps in STEPS]
            bare = [[BARE, name, picture, ROOT, str(size), str(steps)] for steps in STEPS]
            print(row(f"{name}, glibra", per_step(glibra), texel_bytes))
            if os.path.exists(BARE):
                print(row(f"{name}, bare", per_step(bare), texel_bytes))


if __name__ == "__main__":
    main()
