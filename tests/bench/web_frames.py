#!/usr/bin/env python3
"""A frame of five scenes on a live page against a page of plain WebGL 2 that draws the same, and the time from the opening of a
page to its first picture; both in Chromium by the rasteriser of this machine.

usage: web_frames.py GLIBRA

The plain page makes what the live page's scene made (shaders as `glibra check --web --translated` writes them, buffers, textures),
and calls for each frame what the second frame of the live page called, without the calls that set what is set already. So its
numbers are what the calls themselves cost.
"""
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "report"))
import webdriver  # noqa: E402

SCENES = ("start/teapot", "lighting/volume_shadow", "arrays/checkered_shapes", "lights/two_shadows", "projection/dome")
FRAMES, SIZE = 40, "640x480"

# Notes what a frame calls; then repeats it without what would set the same again.
BEFORE = """
const get = HTMLCanvasElement.prototype.getContext, ask = requestAnimationFrame;
globalThis.acts = [];
HTMLCanvasElement.prototype.getContext = function (kind, options) {
    const gl = get.call(this, kind, options);
    if (kind !== "webgl2" || globalThis.noted) return gl;
    globalThis.noted = {gl, calls: null};
    return gl;
};
// Numbers in the memory of the module, with their place and length, as an array of their own.
const copied = (values) => {
    const at = values.findIndex((each) => ArrayBuffer.isView(each));
    if (at < 0) return values;
    const [view, begin = 0, length = Math.min(16, view.length - begin)] = values.slice(at);
    return [...values.slice(0, at), view.slice(begin, begin + length)];
};
for (const name of Object.getOwnPropertyNames(WebGL2RenderingContext.prototype)) {
    const {value} = Object.getOwnPropertyDescriptor(WebGL2RenderingContext.prototype, name);
    if (typeof value !== "function" || /^(get|is|check|constructor|finish|flush|fence|client|delete)/.test(name)) continue;
    WebGL2RenderingContext.prototype[name] = function (...values) {
        if (noted.calls) noted.calls.push([value, copied(values), name]);
        return value.apply(this, values);
    };
}
globalThis.requestAnimationFrame = (act) => {
    globalThis.act = act;
    return ask((time) => {
        if (globalThis.isHeld) return;
        act(time);
        if (!globalThis.firstPicture && globalThis.noted) globalThis.firstPicture = performance.now();
    });
};
"""
MEASURE = """
const done = arguments[arguments.length - 1], [frames] = arguments, pixel = new Uint8Array(4);
const {gl} = noted, wait = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
(async () => {
    document.querySelector("[aria-label='Pause (Space)']:not([hidden])")?.click();
    await new Promise((resolve) => setTimeout(resolve, 400));
    globalThis.isHeld = true;
    const one = () => globalThis.act(performance.now());
    await new Promise((resolve) => setTimeout(resolve, 100));
    one();
    noted.calls = [];
    one();
    const calls = noted.calls;
    noted.calls = null;
    const last = new Map(), needed = calls.filter(([, values, name]) => {
        if (/^(draw|clear$|clearBuffer|blit|uniform|bufferSubData|bufferData|copy|invalidate|generate|read|tex|bind|use|framebuffer|begin|end)/.test(name)) return true;
        const key = name + (/enable|disable|vertexAttrib/i.test(name) ? values[0] : ""), text = String(values);
        if (last.get(key) === text) return false;
        last.set(key, text);
        return true;
    });
    const plain = () => { for (const [call, values] of needed) call.apply(gl, values); };
    const timed = (act) => {
        wait();
        const begin = performance.now();
        act();
        wait();
        return performance.now() - begin;
    };
    const times = [];
    for (let i = 0; i < frames; ++i) {  // by turns, because other programs run on the machine
        const bare = i % 2 ? timed(plain) : 0, ours = timed(one);
        times.push([ours, i % 2 ? bare : timed(plain)]);
    }
    return {times, calls: calls.length, needed: needed.length, glError: gl.getError()};
})().then(done, (error) => done({failure: error.stack}));
"""


def main():
    glibra = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder, webdriver.Browser(gl="mesa") as browser:
        browser.ask("POST", browser.session + "/timeouts", {"script": 300_000})
        browser.command("Page.addScriptToEvaluateOnNewDocument", source=BEFORE)
        print("| scene | first picture, ms | frame / the bare calls: medians (quarters) | medians | calls of a frame / bare |\n|---|---|---|---|---|")
        for scene in SCENES:
            page = os.path.join(folder, scene.replace("/", "-") + ".html")
            subprocess.run([glibra, "publish", ROOT / "glib" / f"{scene}.glib", "--size", SIZE, "-o", page], check=True, stderr=subprocess.DEVNULL)
            first = []
            for _ in range(3):
                browser.open("about:blank")
                browser.open("file://" + page)
                while not (at := browser.run("return globalThis.firstPicture ?? null")):
                    time.sleep(0.02)
                first.append(at)
            got = browser.ask("POST", browser.session + "/execute/async", {"script": MEASURE, "args": [FRAMES]})
            if got.get("failure") or got["glError"]:
                sys.exit(f"{scene}: {got}")
            ours, bare = zip(*got["times"])
            ratios = sorted(one / other for one, other in got["times"])
            print(f"| {scene} | {statistics.median(first):.0f} | {statistics.median(ours) / statistics.median(bare):.2f} ({ratios[FRAMES // 4]:.2f} .. {ratios[FRAMES * 3 // 4]:.2f})"
                  f" | {statistics.median(ours):.2f} ms / {statistics.median(bare):.2f} ms | {got['calls']} / {got['needed']} |", flush=True)


if __name__ == "__main__":
    main()
