#!/usr/bin/env python3
"""Many small scenes: `glibra render --suite` against as many single processes, and against the sum of the times of drawing
alone, alternating in one run.

usage: tests/bench/batch.py [GLIBRA] [SHOTS] [ROUNDS]      (default: build/release/glibra 200 5)

A batch is drawn by one worker with one rasteriser thread ("one"), and by one worker per processor ("all"). The sum of
drawing is the time of the stages draw and readback that a single worker measures while it draws the same shots
(render --stats). Prints the ratios of all rounds: minimum, median, maximum. The first round warms Mesa's
shader cache and is not counted.
"""
import glob
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def wall(command, threads=None):
    environment = dict(os.environ, **({"LP_NUM_THREADS": str(threads)} if threads is not None else {}))
    start = time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment)
    return time.perf_counter() - start


def drawing(glibra, scripts, folder):
    """Seconds that one worker with one thread spends in each stage for these scenes."""
    stats = os.path.join(folder, "stats.json")
    wall([glibra, "render", *scripts, "--size", "128x128", "--jobs", "1", "-o", os.path.join(folder, "stats"),
          "--stats", stats], 1)
    seconds = {}
    with open(stats, encoding="utf-8") as file:
        for scene in json.load(file):
            for stage, value in scene["milliseconds"].items():
                seconds[stage] = seconds.get(stage, 0) + value / 1000
    return seconds


def main():
    glibra = os.path.abspath(sys.argv[1]) if len(sys.argv) > 1 else os.path.join(ROOT, "build", "release", "glibra")
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 200
    rounds = int(sys.argv[3]) if len(sys.argv) > 3 else 5
    scenes = sorted(glob.glob(os.path.join(ROOT, "glib", "*", "*.glib")))
    scripts = [scenes[i % len(scenes)] for i in range(count)]
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        suite = os.path.join(folder, "batch.toml")
        with open(suite, "w", encoding="utf-8") as file:
            file.write("[defaults]\nsize = [128, 128]\n")
            for i, script in enumerate(scripts):
                file.write(f'[[shot]]\nname = "s{i}"\nscript = "{script}"\n')
        batch = [glibra, "render", "--suite", suite, "-o", os.path.join(folder, "batch")]
        for _ in range(rounds + 1):
            one = wall(batch + ["--jobs", "1"], 1)
            everyone = wall(batch)
            stages = drawing(glibra, scripts, folder)
            single = sum(wall([glibra, "render", each, "--size", "128x128", "-o", os.path.join(folder, "x.png")])
                         for each in scripts)
            drawn = stages["draw"] + stages["readback"]
            rows.append({"one s": one, "all s": everyone, "single processes s": single, "drawing s": drawn,
                         "single / all": single / everyone, "one / drawing": one / drawn, "all / drawing": everyone / drawn,
                         "one / all stages": one / sum(stages.values())})
    print(f"{count} shots of 128 x 128 pixels")
    for name in rows[0]:
        values = [each[name] for each in rows[1:]]
        print(f"{name:20} min {min(values):7.3f}  median {statistics.median(values):7.3f}  max {max(values):7.3f}")


if __name__ == "__main__":
    main()
