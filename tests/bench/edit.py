#!/usr/bin/env python3
"""From a saved file to the picture in the window: the shipped teapot at 800 x 600 under Xvfb, with the program's defaults.

usage: tests/bench/edit.py [EDITS]      (needs: build/release/glibra, glibra-view, Xvfb, libX11)

A file is replaced as editors do it, by renaming, and one pixel of the screen is read until it changes. Prints the median and
the range in milliseconds for three edits: of the scene (the background), of a short shader and of the teapot's own shader.
The shaders differ in every edit and every run, so that no cache of the driver helps. Nothing else should run.
"""
import ctypes
import os
import random
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LIMIT = 3.  # seconds until an edit counts as lost
BACKGROUND, TEAPOT = (30, 30), (400, 280)  # pixels of the screen
SHORT = """#version 330 core
in vec3 vNormal;
out vec4 fColor;
void main() { fColor = vec4(vec3(.2 + .8 * abs(normalize(vNormal).z)) * vec3(COLOR), 1.); }
"""


class Screen:
    """Pixels of an X display."""

    def __init__(self, display):
        self.x = ctypes.CDLL("libX11.so.6")
        for name, result, arguments in (
                ("XOpenDisplay", ctypes.c_void_p, [ctypes.c_char_p]),
                ("XDefaultRootWindow", ctypes.c_ulong, [ctypes.c_void_p]),
                ("XGetImage", ctypes.c_void_p, [ctypes.c_void_p, ctypes.c_ulong] + [ctypes.c_int] * 2 +
                 [ctypes.c_uint] * 2 + [ctypes.c_ulong, ctypes.c_int]),
                ("XGetPixel", ctypes.c_ulong, [ctypes.c_void_p, ctypes.c_int, ctypes.c_int]),
                ("XDestroyImage", ctypes.c_int, [ctypes.c_void_p])):
            function = getattr(self.x, name)
            function.restype, function.argtypes = result, arguments
        self.display = None
        deadline = time.monotonic() + 10
        while not self.display:
            self.display = self.x.XOpenDisplay(display.encode())
            if time.monotonic() > deadline:
                sys.exit("edit.py: Xvfb does not start")
        self.root = self.x.XDefaultRootWindow(self.display)

    def pixel(self, place):
        z_pixmap = 2
        image = self.x.XGetImage(self.display, self.root, *place, 1, 1, 0xffffff, z_pixmap)
        value = self.x.XGetPixel(image, 0, 0)
        self.x.XDestroyImage(image)
        return value


def replace(file, text):
    """Saves as editors do."""
    beside = file.with_name(file.name + "~")
    beside.write_text(text)
    beside.replace(file)


def measure(screen, place, file, texts):
    """Milliseconds from each save until the pixel changes."""
    times = []
    for text in texts:
        time.sleep(.4)  # until the window rests
        before = screen.pixel(place)
        begin = time.perf_counter()
        replace(file, text)
        while screen.pixel(place) == before:
            if time.perf_counter() - begin > LIMIT:
                sys.exit(f"edit.py: {file.name}: the picture does not change")
            time.sleep(.0003)
        times.append(1e3 * (time.perf_counter() - begin))
    return times


def main():
    edits = int(sys.argv[1]) if len(sys.argv) > 1 else 40
    display = f":{random.randrange(100, 1000)}"
    with tempfile.TemporaryDirectory() as folder, \
            subprocess.Popen(["Xvfb", display, "-screen", "0", "1280x800x24"], stderr=subprocess.DEVNULL) as server:
        try:
            folder = Path(folder)
            for each in (ROOT / "shaders/start").iterdir():
                shutil.copy(each, folder)
            scene = (ROOT / "glib/start/teapot.glib").read_text()
            glaze = (folder / "glaze.frag").read_text()
            (folder / "teapot.glib").write_text(scene)
            screen = Screen(display)
            empty = screen.pixel(TEAPOT)
            environment = {**os.environ, "DISPLAY": display, "HOME": str(folder)}
            with subprocess.Popen([ROOT / "build/release/glibra", "view", folder / "teapot.glib"],
                                  env=environment) as window:
                try:
                    deadline = time.monotonic() + 20
                    while screen.pixel(TEAPOT) == empty and time.monotonic() < deadline:
                        time.sleep(.1)
                    time.sleep(1)
                    run = random.randrange(10**6)
                    colors = [f"{i % 2}., {(i + 1) % 2}., .{i + 1:03}{run:06}" for i in range(edits)]
                    kinds = (
                        ("scene", BACKGROUND, "teapot.glib",
                         [scene.replace("Background .16 .18 .21", f"Background {.1 + .8 * (i % 2):.1f} .2 .2")
                          .replace("QuadXZ -.75 6.", "QuadXZ -.75 1.") for i in range(edits)]),
                        ("short shader", TEAPOT, "glaze.frag", [SHORT.replace("COLOR", each) for each in colors]),
                        ("teapot's shader", TEAPOT, "glaze.frag",
                         [glaze.replace("= uGlazeColor;", f"= vec3({each});") for each in colors]))
                    for name, place, file, texts in kinds:
                        times = measure(screen, place, folder / file, texts)
                        print(f"{name}: {statistics.median(times):.1f} ms ({min(times):.1f} .. {max(times):.1f})")
                finally:
                    window.terminate()
        finally:
            server.terminate()


if __name__ == "__main__":
    main()
