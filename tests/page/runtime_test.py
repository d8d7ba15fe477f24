#!/usr/bin/env python3
"""The runtime of live pages in Chromium: pictures of example scenes are those of `glibra render --driver gles`, and values,
keys, edits and lost contexts do what runtime.h says.

usage: runtime_test.py GLIBRA MODULE [SCENE...]     MODULE: glibra.wasm; without scenes some of each kind
"""
import base64
import functools
import http.server
import io
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading

from PIL import Image, ImageChops

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "report"))
import webdriver  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIZE = (320, 240)
LARGEST_FILE = 4_000_000
SCENES = ["start/teapot", "antialiasing/bricks", "basics/distance", "detail/star_sphere", "image/noise_octaves_rgb",
          "lighting/volume_shadow", "modern/weighted_glass", "pipeline/brick_pyramid", "projection/dome", "techniques/earth"]
# Rasterisers differ at edges: at most so many of a thousand pixels may differ by more than 16 of 255.
MOST_DIFFERENT = 15

BEGIN = """
const done = arguments[arguments.length - 1];
(async () => {
    const {Runtime} = await import("/src/page/web/runtime.js");
    const runtime = window.runtime = new Runtime(await WebAssembly.compile(await (await fetch("/glibra.wasm")).arrayBuffer()),
                                                 document.querySelector("canvas"));
    window.readFiles = async (names) => {
        for (const name of names) runtime.file(name, new Uint8Array(await (await fetch("/" + encodeURI(name))).arrayBuffer()));
    };
    window.drawn = (frame) => ({...runtime.draw({width: 320, height: 240, time: 0, ...frame}), url: runtime.canvas.toDataURL()});
    await readFiles(arguments[0]);
})().then(() => done(null), (error) => done(error.stack));
"""
DRAW = """
const done = arguments[arguments.length - 1], [scene, files] = arguments;
(async () => {
    await readFiles(files);
    const opened = await runtime.open(scene);
    return {opened, ...drawn({})};
})().then(done, (error) => done({error: error.stack}));
"""
BEHAVIOUR = """
const done = arguments[arguments.length - 1], results = {};
const text = (rest) => "##OpenGL GLIB\\nLet size <0 .5 1>\\nKey k size 1\\nVertex inline\\nvoid main() { gl_Position = " +
    "gl_Vertex; }\\nEndVertex\\nFragment inline\\nuniform vec4 uColor;\\nvoid main() { gl_FragColor = uColor; }\\nEndFragment\\n" +
    "Program Plain uColor {1 0 0 1}\\nQuadXY .9\\n" + rest;
(async () => {
    runtime.file("own.glib", text(""));
    results.opened = await runtime.open("own.glib");
    results.red = drawn({}).url;
    const knob = results.opened.knobs.findIndex((each) => each.name === "uColor");
    results.set = runtime.set({knob, values: [0, 1, 0, 1]});
    results.green = drawn({}).url;
    runtime.file("own.glib", text("QuadXY nothing\\n"));
    results.faulty = await runtime.open("own.glib");
    results.kept = drawn({}).url;
    const lost = new Promise((resolve) => runtime.canvas.addEventListener("webglcontextlost", resolve, {once: true}));
    const restored = new Promise((resolve) => { runtime.onrestored = resolve; });
    const loser = runtime.context.getExtension("WEBGL_lose_context");
    loser.loseContext();
    await lost;
    await new Promise((resolve) => setTimeout(resolve, 100));  // the event ends
    results.ended = runtime.draw({width: 320, height: 240, time: 0});
    loser.restoreContext();
    await restored;
    results.again = await runtime.open("own.glib");
    results.restored = drawn({}).url;
    return results;
})().then(done, (error) => done({error: error.stack}));
"""


class Server(http.server.SimpleHTTPRequestHandler):
    """The files of this tree, the module, and an empty page with a canvas."""

    def __init__(self, module, *arguments):
        self.module = module
        super().__init__(*arguments, directory=str(ROOT))

    def log_message(self, *_):
        pass

    def do_GET(self):
        if self.path in ("/", "/glibra.wasm"):
            body = b"<!doctype html><canvas></canvas>" if self.path == "/" else self.module
            self.send_response(200)
            self.send_header("Content-Type", "text/html" if self.path == "/" else "application/wasm")
            self.end_headers()
            self.wfile.write(body)
        else:
            super().do_GET()


def files_below(folder):
    return [path.relative_to(ROOT).as_posix() for path in (ROOT / folder).rglob("*")
            if path.is_file() and path.stat().st_size < LARGEST_FILE]


def picture(url):
    return Image.open(io.BytesIO(base64.b64decode(url.split(",")[1]))).convert("RGB")


def colour(url):
    return picture(url).getpixel((SIZE[0] // 2, SIZE[1] // 2))


def different(one, other):
    """How many of a thousand pixels differ clearly."""
    largest = functools.reduce(ImageChops.lighter, ImageChops.difference(one, other).split())
    return 1000 * sum(largest.histogram()[17:]) / (one.width * one.height)


def behaviour_problems(browser):
    got = browser.ask("POST", browser.session + "/execute/async", {"script": BEHAVIOUR, "args": []})
    if "error" in got:
        return [got["error"]]
    checks = {
        "the scene has a colour and a variable": {each["name"] for each in got["opened"]["knobs"]} == {"uColor", "size"},
        "its colour is drawn": colour(got["red"]) == (255, 0, 0),
        "set() answers what has changed": [each["current"] for each in got["set"]["knobs"]] == [[0, 1, 0, 1]],
        "another value is drawn": colour(got["green"]) == (0, 255, 0),
        "a faulty statement has a message with its line": any(each["line"] == 13 for each in got["faulty"]["messages"]),
        "values are kept over an edit": colour(got["kept"]) == (0, 255, 0),
        "nothing is drawn after the context is lost": got["ended"].get("ended") is True,
        "values are set again in a new context": got["again"]["drawn"] and colour(got["restored"]) == (0, 255, 0),
    }
    return [f"not so: {what}: {json.dumps(got, default=str)[:1500]}" for what, holds in checks.items() if not holds]


def main():
    if not shutil.which("chromedriver"):
        sys.exit(77)
    glibra, module = sys.argv[1:3]
    scenes = sys.argv[3:] or [f"glib/{each}.glib" for each in SCENES]
    server = http.server.ThreadingHTTPServer(
        ("127.0.0.1", 0), functools.partial(Server, pathlib.Path(module).read_bytes()))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    problems = []
    with tempfile.TemporaryDirectory() as folder, webdriver.Browser(gl=True) as browser:
        browser.ask("POST", browser.session + "/timeouts", {"script": 60_000})
        browser.open(f"http://127.0.0.1:{server.server_port}/")
        library = [each for name in ("shaders", "textures", "scenes/models") for each in files_below(name)]
        if error := browser.ask("POST", browser.session + "/execute/async", {"script": BEGIN, "args": [library]}):
            sys.exit(error)
        problems += behaviour_problems(browser)
        for scene in scenes:
            got = browser.ask("POST", browser.session + "/execute/async",
                              {"script": DRAW, "args": [scene, files_below(os.path.dirname(scene))]})
            native = os.path.join(folder, "native.png")
            subprocess.run([glibra, "render", scene, "--driver", "gles", "--size", "%dx%d" % SIZE, "--incomplete", "-o", native],
                           cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
            if not os.path.exists(native):
                print(f"{scene}: not drawn by glibra")
                continue
            if not got.get("drawn"):
                problems.append(f"{scene}: {json.dumps(got)[:600]}")
                continue
            count = different(picture(got["url"]), Image.open(native).convert("RGB"))
            errors = [each["text"] for each in got["opened"]["messages"] + got.get("messages", []) if each["severity"] == "error"]
            print(f"{scene}: {count:.1f} of 1000 pixels differ{'; ' + errors[0] if errors else ''}")
            if count > MOST_DIFFERENT:
                problems.append(f"{scene}: {count:.1f} of 1000 pixels differ")
        problems += sorted({each["message"] for each in browser.logs("browser") if "favicon" not in each["message"]
                            and "Context lost" not in each["message"] and "CONTEXT_LOST" not in each["message"]})
    server.shutdown()
    print("\n".join(problems) or f"{len(scenes)} scenes are drawn as they should be")
    sys.exit(bool(problems))


if __name__ == "__main__":
    main()
