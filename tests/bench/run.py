#!/usr/bin/env python3
"""All speed figures: functions by Google Benchmark, commands as whole processes in pairs, in one run.

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
from processes import FLOOR, GLIBRA, TOOLS, pairs, ratios, spread, wall, wall_and_memory

PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "README.md")


class Row:
    """One line of the table. `values` are ratios, or nothing where `text` says it all."""

    def __init__(self, what, against, values, aim, figures):
        self.what, self.against, self.aim, self.figures = what, against, aim, figures
        least, median, most = spread(values)
        self.ratio = f"{median:.2f} ({least:.2f} .. {most:.2f})"

    def markdown(self):
        return f"| {self.what} | {self.against} | {self.ratio} | {self.aim} | {self.figures} |"


def milliseconds(values):
    median = spread(values)[1] * 1000
    return f"{median:.0f} ms" if median >= 100 else f"{median:.1f} ms"


def against_floor(what, first, second, runs, aim):
    floor, glibra = pairs(first, second, runs)
    return Row(what, "floor", ratios(glibra, floor), aim, f"{milliseconds(glibra)} / {milliseconds(floor)}")


def start_rows(folder, runs):
    """One picture, warm and cold."""
    scene, out = write_scene(folder), os.path.join(folder, "out.png")
    floor, glibra = [FLOOR, out], [GLIBRA, "render", scene, "-o", out]
    yield against_floor("one picture, 600 x 600", lambda: wall(floor), lambda: wall(glibra), runs, "1.10")

    def cold(command):
        with tempfile.TemporaryDirectory(dir=folder) as empty:
            return wall(command, {"MESA_SHADER_CACHE_DIR": empty, "XDG_CACHE_HOME": empty})

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
    yield against_floor("one picture, 4096 x 4096", lambda: wall(floor + ["4096"]), lambda: wall(glibra + large),
                        max(3, runs // 3), "1.10")


def animation_rows(folder, runs):
    """300 frames against the floor's 300 frames, which are drawn and read back and not encoded."""
    scene = write_scene(folder)
    frames = os.path.join(folder, "frame.png")
    for what, threads in (("all processors draw", {}), ("one is left to encode", {"LP_NUM_THREADS": "1"})):
        yield against_floor(f"300 frames, 600 x 600, software rasteriser: {what}",
                            lambda: wall([FLOOR, frames, "600", "300"], threads),
                            lambda: wall([GLIBRA, "render", scene, "--frames", "300", "-o", frames], threads),
                            max(3, runs // 4), "1.05")


def model_rows(folder, runs):
    """A model of 70 MB, as processes of their own."""
    model = os.path.join(folder, "grid.obj")
    loader = os.path.join(TOOLS, "glibra_load_obj")
    subprocess.run([loader, "grid", model], check=True)
    ours, theirs = pairs(lambda: wall_and_memory([loader, "glibra", model]),
                         lambda: wall_and_memory([loader, "tinyobjloader", model]), max(3, runs // 4))
    seconds = [a for a, _ in ours], [a for a, _ in theirs]
    memory = [b for _, b in ours], [b for _, b in theirs]
    yield Row("OBJ of 70 MB: file to mesh, process", "tinyobjloader, time / ours", ratios(seconds[1], seconds[0]),
              "4", f"{milliseconds(seconds[1])} / {milliseconds(seconds[0])}")
    yield Row("OBJ of 70 MB: most memory", "tinyobjloader, MiB / ours", ratios(memory[1], memory[0]), "1",
              f"{spread(memory[1])[1]:.0f} MiB / {spread(memory[0])[1]:.0f} MiB")


def measured_functions(filters, repetitions):
    """Per name the real times of the repetitions in ms, and the counters."""
    command = [os.path.join(TOOLS, "glibra_functions"), "--benchmark_format=json",
               f"--benchmark_filter={filters}", f"--benchmark_repetitions={repetitions}",
               "--benchmark_enable_random_interleaving=true", "--benchmark_min_time=0.1"]
    report = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    times, counters = {}, {}
    for each in report["benchmarks"]:
        if each["run_type"] != "iteration":
            continue
        name = each["run_name"].removesuffix("/real_time")
        times.setdefault(name, []).append(each["real_time"] / 1000)
        counters[name] = each
    return times, counters


def function_rows(_, runs):
    """Functions beside what they are measured against, repetitions in random order."""
    times, counters = measured_functions(".", max(3, runs // 2))

    def row(what, over, under, against, aim, note=""):
        # Repetitions are not in pairs: the median of one over each of the other.
        median = spread(times[over])[1]
        values = [median / each for each in times[under]]
        return Row(what, against, values, aim, f"{milliseconds(times[over])} / {milliseconds(times[under])}{note}")

    yield row("noise texture 256³", "noise3Of256", "writeNewMemory", "writing 64 MiB of new memory, all processors", "2")
    yield row("noise texture 4096²", "noise2Of4096", "writeNewMemory", "the same", "2")
    yield row("OBJ of 70 MB: text to polygons", "tinyobjToPolygons", "objToPolygons", "tinyobjloader, time / ours", "4")
    for picture in ("sphere", "marble"):
        ours, theirs = counters[f"encode/{picture}"]["bytes"], counters[f"encodeLibpng/{picture}"]["bytes"]
        yield row(f"PNG 1024² {picture}: encode", f"encodeLibpng/{picture}", f"encode/{picture}",
                  "libpng's defaults, time / ours", "8", f"; size {ours / theirs:.2f} of libpng's")
    yield row("PNG 1024² marble: decode", "decodeLibpng/marble", "decode/marble", "libpng, time / ours", "-")
    rate = 100_000 / spread(times["parseScene"])[1] / 1e6
    note = f"; {rate:.1f} million lines a second"
    yield row("GLIB of 100,000 lines", "parseScene", "splitIntoWordsAndNumbers", "splitting into words and numbers",
              "-", note)


GROUPS = (("pictures", start_rows), ("animation", animation_rows), ("models", model_rows),
          ("functions", function_rows), ("peers", lambda folder, runs: peer_rows(folder, runs)))


def peer_rows(folder, runs):
    for what, name, ours, theirs in peers.contests(folder):
        peer, glibra = pairs(theirs, ours, max(3, runs // 3))
        yield Row(what, f"{name}, time / ours", ratios(peer, glibra), "-",
                  f"{milliseconds(peer)} / {milliseconds(glibra)}")


def first_match(path, pattern):
    try:
        with open(path, encoding="utf-8") as file:
            found = re.search(pattern, file.read(), re.MULTILINE)
    except OSError:
        return None
    return found.group(1).strip() if found else None


def machine():
    """Processor, system and driver in a line."""
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
    lines = [f"Measured on: {machine()}.", "", "| what | against | ratio: median (least .. most) | aim | medians |",
             "|---|---|---|---|---|"]
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
