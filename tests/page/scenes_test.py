#!/usr/bin/env python3
"""Every example scene that browsers can draw, drawn by the module in Chromium: at several times, with another value of a slider,
and from other sides. By the rasteriser of this machine it is what `--driver gles` makes, byte by byte; scenes.txt says where it
differs, and why. By Chromium's own, which is slow and draws three of these pictures, at most 2 % of the pixels of a picture are
off by more than 8 of 255. Values for which glibra has no picture, or takes long, are left out.

usage: scenes_test.py MODULE [--swiftshader] [SCENE...]     MODULE: glibra.wasm; the Python package is on PYTHONPATH
"""
import concurrent.futures
import functools
import http.server
import json
import math
import multiprocessing
import os
import pathlib
import sys
import threading
import time

from PIL import Image, ImageChops

import runtime_test as page
from runtime_test import ROOT, webdriver

# At least so many scenes are drawn; docs/cli.md says how many are.
FEWEST_DRAWN = 442
SECONDS = {"mesa": 60, "swiftshader": 240}  # for the pictures of a scene
SLOW_SECONDS = 20  # are said
SLOW_VALUE = 1  # seconds for a picture: browsers would take minutes with this value of the slider

DRAW = """
const done = arguments[arguments.length - 1], [scene, files, moments] = arguments;
(async () => {
    await readFiles(files);
    const opened = await runtime.open(scene);
    const pictures = [];
    for (const {frame, set} of opened.drawn ? moments : []) {
        const knob = set ? opened.knobs.findIndex((each) => each.owner === set.owner && each.name === set.name) : -1;
        if (set && knob < 0) throw new Error("no slider " + set.name);
        if (set) runtime.set({knob, values: [set.value]});
        pictures.push(drawn(frame));
    }
    return {opened, pictures};
})().then(done, (error) => done({error: error.stack}));
"""


def turned(degrees, axis):
    """The matrix of a rotation, column by column."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    if axis == "y":
        return [c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, 0, 1]
    return [1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1]


FRAMES = [{"time": 0}, {"time": 1.5}, {"time": 4}, {"time": 0, "view": {"eye": turned(35, "y")}},
          {"time": 1.5, "view": {"eye": turned(-20, "x")}}]


def moments_of(values):
    """The frames, and those with the first slider at a quarter and at three quarters of its range: at the ends scenes may take
    minutes. It is a slider that no other program has."""
    names = [(each.program, each.name) for each in values]
    sliders = [each for each in values if each.type == "float" and each.range and each.range[0] < each.range[1]
               and names.count((each.program, each.name)) == 1]
    sets = [{"owner": each.program, "name": each.name, "value": each.range[0] + share * (each.range[1] - each.range[0])}
            for each in sliders[:1] for share in (.25, .75)]
    return [{"frame": each} for each in FRAMES] + [{"frame": {"time": 0}, "set": each} for each in sets]


def native(scene):
    """The moments of a scene, and its pictures as glibra draws them. No moments: browsers lack something for it, and the page
    is a film. A text: why it cannot be drawn."""
    import glibra
    import numpy
    try:
        loaded = glibra.Scene(ROOT / scene)
    except glibra.SceneError as error:
        lacks = any(each.id.startswith("web-E") or each.id == "memory-E01" for each in error.diagnostics)
        return ([] if lacks else str(error)), []
    moments, pictures = [], []
    for each in moments_of(loaded.values):
        if one := each.get("set"):
            loaded[f"{one['owner']}.{one['name']}" if one["owner"] else one["name"]] = one["value"]
        frame = each["frame"]
        eye = numpy.reshape(frame["view"]["eye"], (4, 4)).T if "view" in frame else None
        began = time.monotonic()
        try:
            picture = loaded.draw(*page.SIZE, time=frame["time"], eye=eye)
        except glibra.SceneError as error:
            if one:
                break  # a value that the scene cannot use, such as a fraction of a count
            return str(error), []
        if one and time.monotonic() - began > SLOW_VALUE:
            break
        moments.append(each)
        pictures.append(picture)
    return moments, pictures


def exceptions(driver):
    """How many pixels may differ, by the name of the scene, where the driver is that of the row."""
    rows = {}
    for line in (pathlib.Path(__file__).parent / "scenes.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            name, of, pixels, _reason = line.split(maxsplit=3)
            if of == driver:
                rows[name] = int(pixels)
    return rows


def differing_pixels(one, other, most):
    """How many pixels have a component that differs by more than that."""
    difference = ImageChops.difference(one, other)
    return sum(functools.reduce(ImageChops.lighter, difference.split()).histogram()[most + 1:])


def begun(driver, port):
    """A browser whose page has the runtime and the library."""
    browser = webdriver.Browser(gl="mesa" if driver == "mesa" else True).start()
    browser.patience = SECONDS[driver]
    browser.open(f"http://127.0.0.1:{port}/")
    library = [each for name in ("shaders", "textures", "scenes/models") for each in page.files_below(name)]
    if error := browser.ask("POST", browser.session + "/execute/async", {"script": page.BEGIN, "args": [library]}):
        sys.exit(error)
    browser.ask("POST", browser.session + "/timeouts", {"script": 1000 * SECONDS[driver]})
    return browser


class Comparison:
    def __init__(self, begin, driver):
        self.begin, self.browser, self.driver = begin, None, driver
        self.allowed, self.most = exceptions(driver), 8 if driver == "swiftshader" else 0
        # Points and edges of one sample lie elsewhere with another rasteriser.
        self.share = 0.02 if driver == "swiftshader" else 0
        self.failures, self.differing, self.count, self.pictures = [], set(), 0, 0

    def end(self):
        if self.browser:
            self.browser.stop()
            self.browser = None

    def add(self, scene, moments, pictures):
        name = scene.removeprefix("glib/").removesuffix(".glib")
        self.browser = self.browser or self.begin()
        try:
            got = self.browser.ask("POST", self.browser.session + "/execute/async",
                                   {"script": DRAW, "args": [scene, page.files_below(os.path.dirname(scene)), moments]})
        except (TimeoutError, RuntimeError, ConnectionError) as problem:
            self.failures.append(f"{name}: no picture after {SECONDS[self.driver]} s: {problem}")
            print(self.failures[-1], file=sys.stderr)
            self.end()
            return
        if "error" in got or not got["opened"]["drawn"]:
            self.failures.append(f"{name}: {json.dumps(got)[:300]}")
            return
        self.count += 1
        most = self.allowed.get(name, self.share * page.SIZE[0] * page.SIZE[1])
        for moment, drawn, expected in zip(moments, got["pictures"], pictures):
            self.pictures += 1
            errors = [each["text"] for each in drawn.get("messages", []) if each["severity"] == "error"]
            self.failures += [f"{name}: {each[:200]}" for each in errors]
            pixels = differing_pixels(page.picture(drawn["url"]), Image.fromarray(expected), self.most)
            if pixels > self.share * page.SIZE[0] * page.SIZE[1]:
                self.differing.add(name)
            if pixels > most:
                self.failures.append(f"{name}: {pixels} pixels differ: {json.dumps(moment)}")


def main():
    words = [each for each in sys.argv[1:] if each != "--swiftshader"]
    driver = "swiftshader" if "--swiftshader" in sys.argv else "mesa"
    module, *wanted = words
    os.environ["GLIBRA_DRIVER"] = "gles"
    scenes = sorted(str(each.relative_to(ROOT)) for each in (ROOT / "glib").rglob("*.glib"))
    scenes = wanted or scenes
    server = http.server.ThreadingHTTPServer(
        ("127.0.0.1", 0), functools.partial(page.Server, pathlib.Path(module).read_bytes()))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    compared = Comparison(lambda: begun(driver, server.server_port), driver)
    with concurrent.futures.ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:
        for scene, (moments, pictures) in zip(scenes, pool.map(native, scenes)):
            if driver == "swiftshader" and pictures:
                few = [i for i, each in enumerate(moments) if i < 2 or "set" in each][:3]
                moments, pictures = [moments[i] for i in few], [pictures[i] for i in few]
            if not pictures:
                compared.failures += [f"{scene}: {moments}"] if moments else []
                continue
            began = time.monotonic()
            compared.add(scene, moments, pictures)
            if time.monotonic() - began > SLOW_SECONDS:
                print(f"{scene} takes {time.monotonic() - began:.0f} s", file=sys.stderr)
    compared.end()
    server.shutdown()
    failures = compared.failures
    if not wanted and compared.count < FEWEST_DRAWN:
        failures.append(f"only {compared.count} scenes are drawn")
    if not wanted:
        failures += [f"{name} in scenes.txt does not differ ({driver})"
                     for name in sorted(set(compared.allowed) - compared.differing)]
    print("\n".join(failures) or f"{compared.count} scenes are drawn, {compared.count - len(compared.differing)} of them "
          f"{'byte by byte' if driver == 'mesa' else 'alike'}, in {compared.pictures} pictures")
    sys.exit(bool(failures))


if __name__ == "__main__":
    main()
