#!/usr/bin/env python3
"""Figures that a graphics card should give: large pictures, an animation, and many scenes, as whole processes of `glibra render`.

usage: tests/bench/large.py [--runs N] [--part F] [--only WORD]...
       (needs: cmake --preset bench && cmake --build build/bench; GLIBRA_BENCH_BUILD names another folder with the program)

Prints a table: seconds of the whole process, the stages of --stats, and the GPU time. Then the seconds of all scenes of
the library with 1, 2, 4, 8 workers, one per processor, and as many as glibra chooses. A minute with a graphics card; with
the processor, --part .1 draws pictures of a tenth of the width. The first run of each warms the driver's cache of shaders
and is not counted.
"""
import argparse
import json
import os
import statistics
import subprocess
import tempfile
import time

from one_image import write_scene
from processes import GLIBRA, ROOT

LIBRARY = os.path.join(ROOT, "glib")


def scene(name):
    return os.path.join(LIBRARY, name + ".glib")


def subjects(sphere, part):
    """What is drawn: name, arguments of `glibra render`, width and height."""
    def size(width, height):
        return max(8, round(width * part)), max(8, round(height * part))

    return (
        ("lit sphere, 4K", [sphere], size(3840, 2160)),
        ("lit sphere, 4K, 16 samples", [sphere, "--samples", "16"], size(3840, 2160)),
        ("deferred shading", [scene("modern/deferred")], size(900, 600)),
        ("Mandelbrot set, 8000 x 8000", [scene("patterns/mandelbrot")], size(8000, 8000)),
        ("compute ray tracer, 4000 x 4000", [scene("modern/mirror_ball")], size(4000, 4000)),
        ("300 frames of 600 x 600", [sphere, "--frames", "300"], size(600, 600)),
    )


def render(arguments):
    """Seconds of the process."""
    start = time.perf_counter()
    done = subprocess.run([GLIBRA, "render", *arguments], capture_output=True, text=True, check=False)
    seconds = time.perf_counter() - start
    if done.returncode != 0:
        raise SystemExit(f"large.py: {' '.join(arguments)}: status {done.returncode}\n{done.stderr}")
    return seconds


def row(name, arguments, size, runs, folder):
    """A row of the table. The times are those without --stats, which draws all frames in one process; it has a run of its own."""
    picture = ["-o", os.path.join(folder, "picture.png"), "--size", f"{size[0]}x{size[1]}"]
    seconds = [render(arguments + picture) for _ in range(runs + 1)][1:]
    stats = os.path.join(folder, "stats.json")
    render(arguments + picture + ["--stats", stats])
    with open(stats, encoding="utf-8") as file:
        figures = json.load(file)
    stages = figures["milliseconds"]
    gpu = figures["gpuTime"]
    times = [f"{stages.get(each, 0):.1f}" for each in ("compile", "draw", "simulate", "readback", "write")]
    gpu_text = "not measured" if gpu is None else f"{sum(each['milliseconds'] for each in gpu):.2f}"
    return (f"| {name} | {size[0]} x {size[1]} | {statistics.median(seconds):.3f} s ({min(seconds):.3f} .. {max(seconds):.3f}) | "
            + " | ".join(times) + f" | {gpu_text} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=5, help="runs of each, without the first")
    parser.add_argument("--part", type=float, default=1, help="draws pictures of that part of the width and height")
    parser.add_argument("--only", action="append", metavar="WORD", help="what has this word in its name; 'jobs': the workers")
    options = parser.parse_args()

    def wants(name):
        return not options.only or any(each in name for each in options.only)

    info = subprocess.run([GLIBRA, "info"], capture_output=True, text=True, check=False).stdout
    print("\n".join(info.splitlines()[:6]) + "\n")
    with tempfile.TemporaryDirectory() as folder:
        print("| picture | size | seconds, median (least .. most) | compile | draw | simulate | readback | write, ms | GPU time, ms |\n"
              "|---|---|---|---|---|---|---|---|---|")
        for name, arguments, size in subjects(write_scene(folder), options.part):
            if wants(name):
                print(row(name, arguments, size, options.runs, folder), flush=True)
        if not wants("jobs"):
            return
        print("\n| all scenes at 320 x 240, workers | seconds |\n|---|---|")
        everything = [LIBRARY, "-o", os.path.join(folder, "all"), "--size", "320x240"]
        render(everything)
        for jobs in (*sorted({1, 2, 4, 8, os.cpu_count()}), None):
            seconds = render(everything + (["--jobs", str(jobs)] if jobs else []))
            print(f"| {jobs or 'as glibra chooses'} | {seconds:.2f} |", flush=True)


if __name__ == "__main__":
    main()
