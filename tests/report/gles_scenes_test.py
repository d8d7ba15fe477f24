#!/usr/bin/env python3
"""Every example scene that OpenGL ES can draw has the picture of OpenGL, at two times; gles_scenes.txt says where it
differs, and why.

usage: gles_scenes_test.py GLIBRA
"""
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
# At least so many scenes are drawn; docs/cli.md says how many are.
FEWEST_DRAWN = 442
SIZE = "160x160"


def exceptions():
    """How many pixels may differ with this driver, by the name of the scene."""
    said = subprocess.run([sys.argv[1], "info", "--driver", "gles"], capture_output=True, text=True, check=False).stdout
    mesa = re.search(r"Mesa ([0-9]+)", said)
    rows = {}
    for line in (HERE / "gles_scenes.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            name, pixels, _reason = line.split(maxsplit=2)
            version, _, scene = name.rpartition(":")
            if not version or (mesa and version == mesa[1]):
                rows[scene] = int(pixels)
    return rows


def drawn(driver, time, folder):
    subprocess.run([sys.argv[1], "render", "glib", "--driver", driver, "--time", time, "--size", SIZE, "-o", folder],
                   cwd=ROOT, capture_output=True, check=False)
    return {str(each.relative_to(folder).with_suffix("")): each for each in pathlib.Path(folder).rglob("*.png")}


def differing(one, other):
    """The number of pixels that differ."""
    if one.read_bytes() == other.read_bytes():
        return 0
    from PIL import Image, ImageChops
    with Image.open(one) as a, Image.open(other) as b:
        difference = ImageChops.difference(a.convert("RGB"), b.convert("RGB"))
    return sum(any(pixel) for pixel in difference.getdata())


def main():
    allowed, failures = exceptions(), []
    seen = set()
    for time in ("0", "1.5"):
        with tempfile.TemporaryDirectory() as gl, tempfile.TemporaryDirectory() as es:
            whole, drawn_by_es = drawn("egl", time, gl), drawn("gles", time, es)
            if not whole:
                print("no picture: no driver")
                return 77
            if len(drawn_by_es) < FEWEST_DRAWN:
                failures.append(f"at {time} s only {len(drawn_by_es)} scenes were drawn")
            for name, picture in sorted(drawn_by_es.items()):
                pixels = differing(picture, whole[name])
                if pixels > 0:
                    seen.add(name)
                if pixels > allowed.get(name, 0):
                    failures.append(f"{name} at {time} s: {pixels} pixels differ")
    failures += [f"{name} in gles_scenes.txt does not differ" for name in sorted(set(allowed) - seen)]
    print("\n".join(failures) or f"{len(seen)} scenes differ, as their rows say")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
