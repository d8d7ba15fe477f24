#!/usr/bin/env python3
"""Measures all speed figures in one run: functions by Google Benchmark, commands as whole processes in pairs.

usage: tests/bench/run.py [--runs N] [--only WORD]... [--quick] [--write]

Needs: cmake --preset bench && cmake --build build/bench (or GLIBRA_BENCH_BUILD, another folder that was configured with
-DGLIBRA_BENCH=ON). Peers are measured if they are installed: shader_runner (Debian package piglit), f3d (package f3d,
with xvfb), glslViewer (GLIBRA_GLSLVIEWER, the path of its program). As root the page cache is emptied for the coldest
start. --write puts the tables into README.md beside this file; --quick makes few runs.
"""
import argparse
import fnmatch
import json
import os
import platform
import re
import subprocess
import sys
import tempfile

import peers
from one_image import write_scene
from processes import FLOOR, GLIBRA, TOOLS, Cost, measure, pairs, ratios, spread

PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "README.md")


class Row:
    """One row of the table: the costs of `over` divided by those of `under`, pair by pair."""

    def __init__(self, what, against, over, under, aim, note=""):
        self.what, self.against, self.aim = what, against, aim
        walls = [each.wall for each in over], [each.wall for each in under]
        self.wall = self.ratio(walls)
        self.processor = self.ratio(([each.processor for each in over], [each.processor for each in under]))
        self.figures = f"{milliseconds(walls[0])} / {milliseconds(walls[1])}{note}"

    @staticmethod
    def ratio(values):
        least, median, most = spread(ratios(*values))
        return f"{median:.2f} ({least:.2f} .. {most:.2f})"

    def markdown(self):
        return f"| {self.what} | {self.against} | {self.wall} | {self.processor} | {self.aim} | {self.figures} |"


def milliseconds(values):
    median = spread(values)[1] * 1000
    return f"{median:.0f} ms" if median >= 100 else f"{median:.1f} ms"


def against_floor(what, first, second, runs, aim):
    floor, glibra = pairs(first, second, runs)
    return Row(what, "floor", glibra, floor, aim)


def start_rows(folder, runs):
    """One picture, warm and cold."""
    scene, out = write_scene(folder), os.path.join(folder, "out.png")
    floor, glibra = [FLOOR, out], [GLIBRA, "render", scene, "-o", out]
    yield against_floor("one picture, 600 x 600", lambda: measure(floor), lambda: measure(glibra), runs, "1.10")

    def cold(command):
        with tempfile.TemporaryDirectory(dir=folder) as empty:
            return measure(command, {"MESA_SHADER_CACHE_DIR": empty, "XDG_CACHE_HOME": empty})

    yield against_floor("cold: no shader cache, no cache of our own", lambda: cold(floor), lambda: cold(glibra),
                        runs, "-")

    def coldest(command):
        os.sync()
        with open("/proc/sys/vm/drop_caches", "w", encoding="ascii") as file:
            file.write("1")
        return cold(command)

    if platform.system() == "Linux" and os.geteuid() == 0:
        yield against_floor("coldest: page cache emptied besides", lambda: coldest(floor), lambda: coldest(glibra),
                            max(3, runs // 4), "-")
    large = ["--size", "4096x4096"]
    yield against_floor("one picture, 4096 x 4096", lambda: measure(floor + ["4096"]), lambda: measure(glibra + large),
                        max(3, runs // 3), "1.10")


def animation_rows(folder, runs):
    """300 frames against 300 frames of the floor, which draws and reads them back but does not encode them."""
    scene = write_scene(folder)
    frames = os.path.join(folder, "frame.png")
    for what, threads in (("all processors draw", {}), ("one is left to encode", {"LP_NUM_THREADS": "1"})):
        yield against_floor(f"300 frames, 600 x 600, software rasteriser: {what}",
                            lambda: measure([FLOOR, frames, "600", "300"], threads),
                            lambda: measure([GLIBRA, "render", scene, "--frames", "300", "-o", frames],
                                            threads),
                            max(3, runs // 4), "1.05")


def model_rows(folder, runs):
    """A model of 70 MB, read by processes of their own."""
    model = os.path.join(folder, "grid.obj")
    loader = os.path.join(TOOLS, "glibra_load_obj")
    subprocess.run([loader, "grid", model], check=True)
    ours, theirs = pairs(lambda: measure([loader, "glibra", model]),
                         lambda: measure([loader, "tinyobjloader", model]), max(3, runs // 4))
    memory = [spread([each.memory for each in costs])[1] for costs in (theirs, ours)]
    yield Row("OBJ of 70 MB: file to mesh, process", "tinyobjloader, time / ours", theirs, ours, "4",
              f"; memory {memory[0]:.0f} MiB / {memory[1]:.0f} MiB")


def measured_functions(filters, repetitions):
    """For each name, the costs of all repetitions and the counters of the last one."""
    command = [os.path.join(TOOLS, "glibra_functions"), "--benchmark_format=json",
               f"--benchmark_filter={filters}", f"--benchmark_repetitions={repetitions}",
               "--benchmark_enable_random_interleaving=true", "--benchmark_min_time=0.1"]
    report = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    scale = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}
    costs, counters = {}, {}
    for each in report["benchmarks"]:
        if each["run_type"] != "iteration":
            continue
        name = each["run_name"].split("/process_time")[0].removesuffix("/real_time")
        unit = scale[each["time_unit"]]
        costs.setdefault(name, []).append(Cost(each["real_time"] * unit, each["cpu_time"] * unit))
        counters[name] = each
    return costs, counters


def function_rows(_, runs):
    """Functions and those they are compared with, repetitions in random order."""
    costs, counters = measured_functions(".", max(3, runs // 2))

    def row(what, over, under, against, aim, note=""):
        # Repetitions are not paired: the median of one over each repetition of the other.
        median = Cost(*(spread(values)[1] for values in zip(*costs[over])))
        return Row(what, against, [median] * len(costs[under]), costs[under], aim, note)

    yield row("noise texture 256³", "noise3Of256", "writeNewMemory", "writing 64 MiB of new memory, all processors", "2")
    yield row("noise texture 4096²", "noise2Of4096", "writeNewMemory", "the same", "2")
    yield row("OBJ of 70 MB: text to polygons", "tinyobjToPolygons", "objToPolygons", "tinyobjloader, time / ours", "4")
    for picture in ("sphere", "marble"):
        ours, theirs = counters[f"encode/{picture}"]["bytes"], counters[f"encodeLibpng/{picture}"]["bytes"]
        yield row(f"PNG 1024² {picture}: encode", f"encodeLibpng/{picture}", f"encode/{picture}",
                  "libpng's defaults, time / ours", "8", f"; size {ours / theirs:.2f} of libpng's")
    yield row("PNG 1024² marble: decode", "decodeLibpng/marble", "decode/marble", "libpng, time / ours", "-")
    rate = 100_000 / spread([each.wall for each in costs["parseScene"]])[1] / 1e6
    note = f"; {rate:.1f} million lines a second"
    yield row("GLIB of 100,000 lines", "parseScene", "splitIntoWordsAndNumbers", "splitting into words and numbers",
              "-", note)


GROUPS = (("pictures", start_rows), ("animation", animation_rows), ("models", model_rows),
          ("functions", function_rows), ("peers", lambda folder, runs: peer_rows(folder, runs)))


def peer_rows(folder, runs):
    for what, name, ours, theirs in peers.contests(folder):
        peer, glibra = pairs(theirs, ours, max(3, runs // 3))
        yield Row(what, f"{name}, time / ours", peer, glibra, "-")


def first_match(path, pattern):
    try:
        with open(path, encoding="utf-8") as file:
            found = re.search(pattern, file.read(), re.MULTILINE)
    except OSError:
        return None
    return found.group(1).strip() if found else None


def machine():
    """Processor, system and driver on one line."""
    processor = first_match("/proc/cpuinfo", r"^model name\s*:\s*(.*)$") or platform.processor()
    system = first_match("/etc/os-release", r'^PRETTY_NAME="(.*)"$') or platform.platform()
    information = subprocess.run([GLIBRA, "info"], check=True, capture_output=True, text=True).stdout
    driver = [line.split(":", 1)[1].strip() for line in information.splitlines()
              if re.match(r"(renderer|OpenGL):", line)]
    return f"{processor}, {os.cpu_count()} processors; {system}, {platform.machine()}; {', '.join(driver)}"


def write_page(text):
    with open(PAGE, encoding="utf-8") as file:
        page = file.read()
    begin, end = "<!-- figures -->\n", "<!-- end of figures -->"
    head, rest = page.split(begin)
    with open(PAGE, "w", encoding="utf-8") as file:
        file.write(head + begin + text + end + rest.split(end)[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=21, help="pairs of the quickest commands; slow ones get fewer")
    parser.add_argument("--only", action="append", metavar="WORD",
                        help="groups by name: " + ", ".join(name for name, _ in GROUPS))
    parser.add_argument("--quick", action="store_true", help="three runs of everything")
    parser.add_argument("--write", action="store_true", help="rewrite the table in README.md")
    options = parser.parse_args()
    runs = 3 if options.quick else options.runs
    lines = [f"Measured on: {machine()}.", "", "| what | against | ratio: median (least .. most) | of processor time | aim | medians |",
             "|---|---|---|---|---|---|"]
    print("\n".join(lines))
    for name, rows in GROUPS:
        if options.only and not any(fnmatch.fnmatch(name, f"*{word}*") for word in options.only):
            continue
        with tempfile.TemporaryDirectory() as folder:
            for row in rows(folder, runs):
                lines.append(row.markdown())
                print(lines[-1], flush=True)
    if options.write:
        if options.only:
            sys.exit("run.py: --write needs all groups")
        write_page("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
