#!/usr/bin/env python3
"""Seven modern scenes as whole processes, against programs in plain OpenGL for the same pictures, alternating in one run.

usage: tests/bench/modern.py [--runs N] [--only SUBJECT]... [--small]
       (needs: cmake --preset bench && cmake --build build/bench)

The programs are in tests/bench/bare. Before a subject is measured, its two pictures must have equal pixels. Prints a table of
ratios, glibra's time divided by the bare program's: by the clock and by the time of all processors, each as the median and the
quartiles of all pairs. The first pair warms Mesa's shader cache and is not counted. --small shrinks the two simulations to a few
groups of threads but gives them more steps, so that the cost of a step itself is seen.
"""
import argparse
import os
import statistics
import subprocess
import sys
import tempfile
from typing import NamedTuple

from processes import GLIBRA, ROOT, TOOLS, measure, pairs, ratios

BARE = os.environ.get("GLIBRA_BARE", os.path.join(TOOLS, "glibra_bare"))


class Subject(NamedTuple):
    """A picture that both draw; `share` of the pairs are measured, since some take a minute."""
    name: str
    what: str
    scene: str
    options: tuple = ()  # of glibra
    size: tuple = ()     # of the bare program
    share: float = 1


SUBJECTS = (
    Subject("shadow-map", "shadow map, 64 samples per pixel", "soft_shadow"),
    Subject("cubes", "100,000 instanced cubes", "cube_cloud"),
    Subject("life", "life, 1024 x 1024, 600 steps", "life", ("--set", "side=1024", "--time", "60"), share=.15),
    Subject("particles", "1,000,000 particles, 300 steps", "fountain",
            ("--set", "count=1000000", "--time", "5"), share=.2),
    Subject("deferred", "deferred shading, 64 lamps", "deferred", ("--set", "lamps=64")),
    Subject("water", "water, two more cameras", "flat_water"),
    Subject("ray-tracer", "compute ray tracer", "mirror_ball"),
)
SMALL = (
    Subject("life", "life, 16 x 16, 20,000 steps", "life", ("--set", "side=16", "--time", "2000"), ("16", "20000")),
    Subject("particles", "1,000 particles, 6,000 steps", "fountain", ("--set", "count=1000", "--time", "100"),
            ("1000", "6000")),
)


def spread(values):
    """The median, and the quartiles."""
    if len(values) < 2:
        return f"{values[0]:.3f}"
    low, _, high = statistics.quantiles(values, method="inclusive")
    return f"{statistics.median(values):.3f} ({low:.3f} .. {high:.3f})"


def row(subject, runs, folder):
    scene = os.path.join(ROOT, "glib", "modern", subject.scene + ".glib")
    pictures = [os.path.join(folder, each + ".png") for each in ("bare", "glibra")]
    bare = [BARE, subject.name, pictures[0], ROOT, *subject.size]
    glibra = [GLIBRA, "render", scene, "-o", pictures[1], *subject.options]
    same = [GLIBRA, "compare", *pictures, "--exact"]

    def draw(command, picture):
        cost = measure(command)
        if picture == pictures[1] and subprocess.run(same, stdout=subprocess.DEVNULL, check=False).returncode != 0:
            sys.exit(f"modern.py: the pictures of '{subject.name}' differ")
        return cost

    count = max(3, round(runs * subject.share))
    floor, ours = pairs(lambda: draw(bare, pictures[0]), lambda: draw(glibra, pictures[1]), count)
    wall = ratios([each.wall for each in ours], [each.wall for each in floor])
    processor = ratios([each.processor for each in ours], [each.processor for each in floor])
    medians = " / ".join(f"{statistics.median(each.processor for each in costs):.3f} s" for costs in (floor, ours))
    return f"| {subject.what} | {spread(wall)} | {spread(processor)} | {count} | {medians} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=21, help="pairs of the quick subjects; slow ones get fewer")
    parser.add_argument("--only", action="append", metavar="SUBJECT", help="this subject alone; may be repeated")
    parser.add_argument("--small", action="store_true", help="small simulations of many steps")
    options = parser.parse_args()
    print("| picture | ratio by the clock | ratio of processor time | pairs | processor time, bare / glibra |\n"
          "|---|---|---|---|---|")
    for subject in SMALL if options.small else SUBJECTS:
        if options.only and subject.name not in options.only:
            continue
        with tempfile.TemporaryDirectory() as folder:
            print(row(subject, options.runs, folder), flush=True)


if __name__ == "__main__":
    main()
