#!/usr/bin/env python3
"""Does a golden picture catch a mistake? Makes mutants of the example scenes, each with one small change, and compares
them with the goldens of the originals at the default tolerance (an equal hash does not count).

usage: tests/mutation/mutate.py GLIBRA [--floor SHARE] [--least COUNT] [--keep FOLDER] [--write | --only TOPIC/NAME]

Mutants whose pictures equal the originals bit for bit are left out. Prints how many are caught, and one line with
figures for each that is not; --write puts that into README.md beside this file. The exit status is 1 if
fewer than SHARE of the visible mutants are caught, or if there are fewer than COUNT mutants. --only limits all this to one
scene, as start/teapot.
"""
import argparse
import collections
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TOPICS = ("bump", "effects", "geometry", "noise", "patterns", "projection", "shading", "start", "tessellation", "texture",
          "visualization")
SIZE = 200
BEGIN, END = "<!-- figures -->", "<!-- end of figures -->"
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


class Scene:
    """An example and its shaders."""

    def __init__(self, path):
        self.path = path
        self.topic = os.path.basename(os.path.dirname(path))
        self.name = os.path.splitext(os.path.basename(path))[0]
        self.text = read(path)
        self.code = re.sub(r"(#|//).*", lambda m: " " * len(m.group()), self.text)
        self.shaders = {}
        for name in re.findall(r"\b([\w/]+\.(?:vert|tesc|tese|geom|frag))\b", self.code):
            for folder in (os.path.join("shaders", self.topic), "shaders"):
                file = os.path.join(ROOT, folder, name)
                if os.path.exists(file):
                    self.shaders[name] = read(file)
                    break


class Mutant:
    """One change of the scene's text, of files beside it, of a uniform, or of the golden."""

    def __init__(self, kind, scene, what, files=None, copies=None, sets=None, golden=None):
        self.kind, self.scene, self.what, self.golden = kind, scene, what, golden
        self.files, self.copies, self.sets = files or {}, copies or {}, sets or {}


def uniform_mutants(scene):
    """Each <min current max> moved by 2 % of its range, inwards if it is at an end."""
    for name, *texts in re.findall(rf"(\w+)\s*<\s*({NUMBER})\s+({NUMBER})\s+({NUMBER})\s*>", scene.code):
        low, now, high = (float(each) for each in texts)
        step = .02 * (high - low)
        if not any("." in each for each in texts):  # whole numbers only
            step = max(1, round(step))
        value = now + step if now + step <= high else now - step
        yield Mutant("uniform 2 %", scene, f"{name} {now:g} -> {value:g}", sets={name: value})


def light_mutants(scene):
    """Each constant light rotated by one degree around the vertical axis."""
    turn = math.radians(1)
    for name, text in scene.shaders.items():
        for match in re.finditer(rf"(const vec3 kLight\w*\s*=\s*vec3\()({NUMBER}),\s*({NUMBER}),\s*({NUMBER})\)", text):
            x, y, z = (float(each) for each in match.groups()[1:])
            turned = (x * math.cos(turn) + z * math.sin(turn), y, z * math.cos(turn) - x * math.sin(turn))
            if math.hypot(x, z) < 1e-6:  # straight above: it must leave the axis
                turned = (y * math.sin(turn), y * math.cos(turn), z)
            changed = text[:match.start()] + match.group(1) + ", ".join(f"{v:.9f}" for v in turned) + ")" + \
                text[match.end():]
            yield Mutant("light 1 degree", scene, name, files={name: changed})


def texture_mutants(scene, folder):
    """Each picture upside down, and each mirrored."""
    for name in sorted(set(re.findall(r"^\s*Texture2D\s+\d+\s+(\w+\.png)", scene.code, re.M))):
        for way in ("flip", "flop"):
            file = os.path.join(folder, f"{way}-{name}")
            source = os.path.join(ROOT, "textures", name)
            if not os.path.exists(file):
                subprocess.run(["convert", source, f"-{way}", file], check=True)
            yield Mutant("texture flipped", scene, f"{name} {way}", copies={name: file})


def triangle_mutants(scene):
    """One face of a model removed, at eight places in its file."""
    for name in sorted(set(re.findall(r"^\s*Obj(?:Adj)?\s+(\w+\.obj)", scene.code, re.M))):
        lines = read(os.path.join(ROOT, "scenes", "models", name)).splitlines(keepends=True)
        faces = [i for i, line in enumerate(lines) if line.startswith("f ")]
        for part in range(8):
            lost = faces[(2 * part + 1) * len(faces) // 16]
            yield Mutant("triangle lost", scene, f"{name} line {lost + 1}",
                         files={name: "".join(lines[:lost] + lines[lost + 1:])})


def precision_mutants(scene):
    """Each interpolated input of the fragment stage in steps of 1/128."""
    for name, text in scene.shaders.items():
        if not name.endswith(".frag"):
            continue
        for kind, varying in re.findall(r"^in (float|vec[234]) (v\w+);", text, re.M):
            head, line, body = text.partition(f"in {kind} {varying};")
            coarse = f"{line} {kind} coarse_{varying}() {{ return floor({varying} * 128. + .5) / 128.; }}"
            changed = head + coarse + re.sub(rf"\b{varying}\b", f"coarse_{varying}()", body)
            yield Mutant("precision lowered", scene, f"{varying} of {name}", files={name: changed})


def noise_mutants(scene):
    """Each noise texture sampled at another place."""
    for name, text in scene.shaders.items():
        for match in re.finditer(r"texture\(\s*Noise([23])\s*,", text):
            offset = "vec3(.371, .173, .713) + " if match.group(1) == "3" else "vec2(.371, .173) + "
            yield Mutant("noise offset", scene, f"{name} at {match.start()}",
                         files={name: text[:match.end()] + " " + offset + text[match.end():]})


def shift_row(pixels, width, height):
    """The most detailed of three rows, shifted one pixel to the right."""
    rows = [pixels[3 * width * y:3 * width * (y + 1)] for y in range(height)]
    y = max((height // 3, height // 2, 2 * height // 3), key=lambda each: len(set(rows[each])))
    rows[y] = rows[y][:3] + rows[y][:-3]
    return b"".join(rows)


def gamma(pixels, _width, _height):
    table = bytes(round(255 * (v / 255) ** (1 / 1.02)) for v in range(256))
    return pixels.translate(table)


def picture_mutants(scene):
    yield Mutant("row shifted", scene, "one row by one pixel", golden=shift_row)
    yield Mutant("gamma 1.02", scene, "", golden=gamma)


def change_picture(source, target, change):
    ppm = subprocess.run(["convert", source, "ppm:-"], check=True, capture_output=True).stdout
    head = re.match(rb"P6\s+(\d+)\s+(\d+)\s+255\s", ppm)
    width, height = int(head.group(1)), int(head.group(2))
    changed = change(ppm[head.end():], width, height)
    subprocess.run(["convert", "ppm:-", target], check=True, input=ppm[:head.end()] + changed)


def run(glibra, arguments, expected):
    environment = dict(os.environ, GLIBRA_PATH=ROOT)
    done = subprocess.run([glibra] + arguments, env=environment, capture_output=True, text=True)
    if done.returncode not in expected:
        sys.exit(f"glibra {' '.join(arguments)}: status {done.returncode}\n{done.stdout}{done.stderr}")


def results_of(folder):
    with open(os.path.join(folder, "results.jsonl"), encoding="utf-8") as file:
        return {each["shot"]: each for each in map(json.loads, file) if "shot" in each}


def place(mutant, folder):
    """Writes the mutant's scene and files, and returns the path of the scene."""
    path = os.path.join(folder, mutant.scene.topic, mutant.scene.name + ".glib")
    write(path, mutant.scene.text)
    for name, content in mutant.files.items():
        write(os.path.join(os.path.dirname(path), name), content)
    for name, source in mutant.copies.items():
        shutil.copy(source, os.path.join(os.path.dirname(path), name))
    parts = os.path.join(ROOT, "glib", mutant.scene.topic, "parts")  # what Include statements name
    if os.path.isdir(parts):
        shutil.copytree(parts, os.path.join(os.path.dirname(path), "parts"), dirs_exist_ok=True)
    return path


def suite(shots, goldens):
    text = f'goldens = "{goldens}"\n[defaults]\nsize = [{SIZE}, {SIZE}]\n'
    for name, script, sets in shots:
        text += f'[[shot]]\nname = "{name}"\nscript = "{script}"\n'
        if sets:
            text += "set = { " + ", ".join(f"{k} = {v!r}" for k, v in sets.items()) + " }\n"
    return text


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("glibra")
    parser.add_argument("--floor", type=float, default=0)
    parser.add_argument("--least", type=int)
    parser.add_argument("--keep")
    extent = parser.add_mutually_exclusive_group()
    extent.add_argument("--write", action="store_true")
    extent.add_argument("--only", metavar="TOPIC/NAME")
    options = parser.parse_args()
    if options.least is None:
        options.least = 1 if options.only else 200
    glibra = os.path.abspath(options.glibra)
    folder = options.keep or tempfile.mkdtemp(prefix="glibra-mutation-")
    os.makedirs(folder, exist_ok=True)
    try:
        sys.exit(test(glibra, folder, options))
    finally:
        if not options.keep:
            shutil.rmtree(folder)


def test(glibra, folder, options):
    scenes = []
    for path, _, names in sorted(os.walk(os.path.join(ROOT, "glib"))):
        if os.path.basename(os.path.dirname(path)) != "exercises":
            scenes += [Scene(os.path.join(path, each)) for each in sorted(names) if each.endswith(".glib")]
    if options.only:
        scenes = [each for each in scenes if f"{each.topic}/{each.name}" == options.only]
        if not scenes:
            sys.exit(f"there is no scene '{options.only}' in glib")
    elif not options.write:  # the others take many times as long and say nothing new about the tolerance
        scenes = [each for each in scenes if each.topic in TOPICS]
    mutants = []
    for scene in scenes:
        for make in (uniform_mutants, light_mutants, lambda s: texture_mutants(s, folder), triangle_mutants,
                     precision_mutants, noise_mutants, picture_mutants):
            mutants += list(make(scene))

    originals = os.path.join(folder, "originals")
    write(os.path.join(folder, "originals.toml"),
          suite([(f"{each.topic}/{each.name}", each.path, {}) for each in scenes], originals))
    run(glibra, ["test", os.path.join(folder, "originals.toml"), "--update", "--results", folder + "/r0"], (0,))
    goldens = os.path.join(folder, "goldens")
    shots = []
    for i, mutant in enumerate(mutants):
        mutant.name = f"m{i:04}"
        original = os.path.join(originals, mutant.scene.topic, mutant.scene.name + ".png")
        golden = os.path.join(goldens, mutant.name + ".png")
        os.makedirs(goldens, exist_ok=True)
        if mutant.golden:
            change_picture(original, golden, mutant.golden)
        else:
            shutil.copy(original, golden)
        shots.append((mutant.name, place(mutant, os.path.join(folder, "scenes", mutant.name)), mutant.sets))
    write(os.path.join(folder, "mutants.toml"), suite(shots, goldens))
    results = os.path.join(folder, "results")
    run(glibra, ["test", os.path.join(folder, "mutants.toml"), "--results", results], (0, 1, 3))
    return tell(mutants, results_of(results), options)


def could_be_seen(result):
    """A change is not visible if no value changes by more than 3/255 and no block by 1/255. Single pixels that change more
    are visible to somebody who switches between the two pictures."""
    return result["judgement"]["beyond"] > 0


def tell(mutants, results, options):
    caught, missed, same, broken = collections.Counter(), [], 0, []
    for mutant in mutants:
        result = results[mutant.name]
        if result["verdict"] == "passed" and result.get("exact"):
            same += 1
        elif result["verdict"] == "failed" and result.get("width", 0) > 0:
            caught[mutant.kind] += 1
        elif result["verdict"] == "passed":
            missed.append(mutant)
        else:
            broken.append(f"BROKEN {mutant.kind} {mutant.scene.name}: {mutant.what}: {result.get('reason')}")
    of_kind = collections.Counter(each.kind for each in missed)
    visible = sum(could_be_seen(results[each.name]) for each in missed)
    all_caught = sum(caught.values())
    share = all_caught / (all_caught + visible)
    text = [f"{all_caught + len(missed)} mutants, {all_caught} caught. Of the other {len(missed)}, {len(missed) - visible} cannot",
            f"be seen and {visible} are visible only by switching between the pictures. {100 * share:.1f} % of the mutants that are visible",
            f"in any way are caught. ({same} more changed no pixel.)", "",
            "| kind | mutants | caught |", "|---|---|---|"]
    text += [f"| {kind} | {caught[kind] + of_kind[kind]} | {caught[kind]} |"
             for kind in dict.fromkeys(each.kind for each in mutants)]
    text += ["", "Not caught, those that are visible by switching first:", "",
             "| kind | scene | change | pixels that differ | largest | pixels beyond 3/255 | bias of a block |",
             "|---|---|---|---|---|---|---|"]
    for mutant in sorted(missed, key=lambda each: not could_be_seen(results[each.name])):
        judgement = results[mutant.name]["judgement"]
        figures = judgement["comparison"]
        text.append(f"| {mutant.kind} | {mutant.scene.topic}/{mutant.scene.name} | {mutant.what} | "
                    f"{figures['differingPixels']} | {figures['largest'] * 255:.0f}/255 | {judgement['beyond']} | "
                    f"{judgement['bias']:.2f} |")
    print("\n".join(text + broken))
    if options.write:
        path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "README.md")
        head, rest = read(path).split(BEGIN)
        write(path, head + BEGIN + "\n" + "\n".join(text) + "\n" + END + rest.split(END)[1])
    return 1 if broken or all_caught + len(missed) < options.least or share < options.floor else 0


if __name__ == "__main__":
    main()
