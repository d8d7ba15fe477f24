#!/usr/bin/env python3
"""Every example scene that browsers can draw, drawn by the module in Chromium: by the rasteriser of this machine it is what
`glibra render --driver gles` makes, byte by byte; scenes.txt says where it differs, and why.

usage: scenes_test.py GLIBRA MODULE [SCENE...]     MODULE: glibra.wasm
"""
import functools
import http.server
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import threading

from PIL import Image, ImageChops

import runtime_test as page
from runtime_test import ROOT, webdriver

TIMES = ("0", "1.5")
# At least so many scenes are drawn; docs/cli.md says how many are.
FEWEST_DRAWN = 438
DRAW = """
const done = arguments[arguments.length - 1], [scene, files, times] = arguments;
(async () => {
    await readFiles(files);
    const opened = await runtime.open(scene);
    return {opened, pictures: opened.drawn ? times.map((time) => drawn({time: Number(time)})) : []};
})().then(done, (error) => done({error: error.stack}));
"""


def exceptions():
    """How many pixels may differ, by the name of the scene."""
    rows = {}
    for line in (pathlib.Path(__file__).parent / "scenes.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            name, pixels, _reason = line.split(maxsplit=2)
            rows[name] = int(pixels)
    return rows


def native(glibra, time, folder):
    """The pictures that glibra draws, by scene."""
    subprocess.run([glibra, "render", "glib", "--driver", "gles", "--time", time, "--size", "%dx%d" % page.SIZE, "-o", folder],
                   cwd=ROOT, capture_output=True, check=False)
    return {str(each.relative_to(folder).with_suffix("")): each for each in pathlib.Path(folder).rglob("*.png")}


def main():
    glibra, module = sys.argv[1:3]
    wanted = {each.removeprefix("glib/").removesuffix(".glib") for each in sys.argv[3:]}
    server = http.server.ThreadingHTTPServer(
        ("127.0.0.1", 0), functools.partial(page.Server, pathlib.Path(module).read_bytes()))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    allowed, failures, differing, count = exceptions(), [], set(), 0
    with tempfile.TemporaryDirectory() as folder, webdriver.Browser(gl="mesa") as browser:
        pictures = {time: native(glibra, time, os.path.join(folder, time)) for time in TIMES}
        browser.ask("POST", browser.session + "/timeouts", {"script": 120_000})
        browser.open(f"http://127.0.0.1:{server.server_port}/")
        library = [each for name in ("shaders", "textures", "scenes/models") for each in page.files_below(name)]
        if error := browser.ask("POST", browser.session + "/execute/async", {"script": page.BEGIN, "args": [library]}):
            sys.exit(error)
        for name in sorted(pictures[TIMES[0]]):
            if wanted and name not in wanted:
                continue
            scene = f"glib/{name}.glib"
            got = browser.ask("POST", browser.session + "/execute/async",
                              {"script": DRAW, "args": [scene, page.files_below(os.path.dirname(scene)), TIMES]})
            if "error" in got or not got["opened"]["drawn"]:
                failures.append(f"{name}: {json.dumps(got)[:300]}")
                continue
            count += 1
            for time, drawn in zip(TIMES, got["pictures"]):
                errors = [each["text"] for each in drawn.get("messages", []) if each["severity"] == "error"]
                failures += [f"{name}: {each[:200]}" for each in errors]
                with Image.open(pictures[time][name]) as picture:
                    difference = ImageChops.difference(page.picture(drawn["url"]), picture.convert("RGB"))
                pixels = sum(functools.reduce(ImageChops.lighter, difference.split()).histogram()[1:])
                if pixels > 0:
                    differing.add(name)
                if pixels > allowed.get(name, 0):
                    failures.append(f"{name} at {time} s: {pixels} pixels differ")
    server.shutdown()
    if not wanted and count < FEWEST_DRAWN:
        failures.append(f"only {count} scenes are drawn")
    if not wanted:
        failures += [f"{name} in scenes.txt does not differ" for name in sorted(set(allowed) - differing)]
    print("\n".join(failures) or f"{count} scenes are drawn, {count - len(differing)} of them byte by byte")
    sys.exit(bool(failures))


if __name__ == "__main__":
    main()
