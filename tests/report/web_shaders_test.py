#!/usr/bin/env python3
"""The shaders of all example scenes in GLSL ES 3.00, compiled and linked by Chromium: each program that it refuses is one
of a scene of which `check --web` says what WebGL 2 lacks.

usage: web_shaders_test.py GLIBRA
"""
import collections
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import webdriver

ROOT = pathlib.Path(__file__).resolve().parents[2]
# At least so many scenes lack nothing; docs/cli.md says how many do.
FEWEST_WHOLE = 442

COMPILE = """
const gl = document.createElement("canvas").getContext("webgl2");
const refused = {};
for (const [name, stages] of Object.entries(arguments[0])) {
    const program = gl.createProgram();
    let log = "";
    for (const [ending, kind] of [["vert", gl.VERTEX_SHADER], ["frag", gl.FRAGMENT_SHADER]]) {
        const shader = gl.createShader(kind);
        gl.shaderSource(shader, stages[ending]);
        gl.compileShader(shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) log += gl.getShaderInfoLog(shader);
        gl.attachShader(program, shader);
        gl.deleteShader(shader);
    }
    gl.linkProgram(program);
    if (!log && !gl.getProgramParameter(program, gl.LINK_STATUS)) log = gl.getProgramInfoLog(program);
    gl.deleteProgram(program);
    if (log) refused[name] = log;
}
return refused;
"""


def scenes_with_messages(folder):
    """The shaders of all scenes, written into `folder`, and the scenes of which something is missing."""
    ran = subprocess.run([sys.argv[1], "check", "--web", "--translated", folder, "--json", "glib"], cwd=ROOT,
                         capture_output=True, text=True, check=False)
    lacking = set()
    scenes = json.loads(ran.stdout)
    for scene in scenes:
        if any(each["id"].startswith("web-") for each in scene["diagnostics"]):
            lacking.add(os.path.splitext(os.path.relpath(scene["scene"], "glib"))[0])
    return len(scenes), lacking


def programs_in(folder):
    programs = collections.defaultdict(dict)
    for path in pathlib.Path(folder).rglob("*.*"):
        name = path.relative_to(folder)
        programs[str(name.with_suffix(""))][path.suffix[1:]] = path.read_text()
    return programs


def main():
    if not shutil.which("chromedriver"):
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        count, lacking = scenes_with_messages(folder)
        programs = programs_in(folder)
        if halves := [name for name, stages in programs.items() if set(stages) != {"vert", "frag"}]:
            sys.exit(f"programs without both stages: {halves}")
        with webdriver.Browser(gl=True) as browser:
            browser.open("about:blank")
            refused = browser.run(COMPILE, programs)
    wrong = {name: log for name, log in refused.items() if os.path.dirname(name) not in lacking}
    for name, log in wrong.items():
        print(f"{name}: {log}")
    print(f"{len(programs)} programs, {len(refused)} refused; {count - len(lacking)} of {count} scenes lack nothing")
    if count - len(lacking) < FEWEST_WHOLE:
        sys.exit(f"only {count - len(lacking)} scenes lack nothing, {FEWEST_WHOLE} did before")
    if wrong or not refused:
        sys.exit("refused though nothing was said" if wrong else "nothing was refused: was anything compiled?")


if __name__ == "__main__":
    main()
