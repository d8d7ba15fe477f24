#!/usr/bin/env python3
"""Writes docs/coverage.md, the pages of docs/chapters, and glib/README.md: what answers each row of the five sources.

tests/coverage/rows.csv lists every row: id, source, chapter, what it asks for, and, for a row without a scene, the
answer: the tests, pages or commands that answer it (files in backquotes; shots of suites as "shot `TOPIC/NAME`"),
`not yet`, `no picture: WHY`, or `not possible: WHY`. A scene answers the rows whose ids begin its first line, as in
`# SH113 SH114 Compact disc: ...`. A starting scene of glib/exercises begins with `# Exercise ID ID: ...`, and NAME.toml
beside it names the solution.

usage: tools/coverage.py             writes the pages, and clears the answer `not yet` of rows that have a scene
       tools/coverage.py --check     writes nothing; fails if something is wrong or a page is not current
       tools/coverage.py --missing   lists the rows that are not answered yet
"""
import csv
import fnmatch
import glob
import io
import os
import re
import sys
import tomllib
from dataclasses import dataclass, field

import coverage_pages

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
ROWS = "tests/coverage/rows.csv"
TOTAL = 969  # rows of all sources; none may get lost
UNANSWERED = re.compile(r"not yet$|no picture: |not possible: ")


@dataclass
class Row:
    id: str
    source: str
    chapter: str
    what: str
    answer: str
    scenes: list = field(default_factory=list)
    task: str = ""  # the starting scene of an exercise

    def state(self):
        if self.scenes:
            return "scene"
        found = UNANSWERED.match(self.answer)
        return found.group(0).rstrip(": ") if found else "elsewhere"


@dataclass
class Scene:
    path: str  # from the root: glib/TOPIC/NAME.glib
    sentence: str
    ids: list
    rows: list = field(default_factory=list)
    goldens: list = field(default_factory=list)  # paths from the root
    shots: list = field(default_factory=list)  # "TOPIC/NAME", with and without goldens

    def name(self):
        return self.path[len("glib/"):-len(".glib")]


def full(path):
    return os.path.join(ROOT, path)


def text_of(path):
    with open(full(path), encoding="utf-8") as file:
        return file.read()


def files(pattern):
    return sorted(os.path.relpath(each, ROOT) for each in glob.glob(full(pattern)))


def read_rows():
    with open(full(ROWS), encoding="utf-8", newline="") as file:
        return [Row(**each) for each in csv.DictReader(file)]


def rows_text(rows):
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["id", "source", "chapter", "what", "answer"])
    writer.writerows([row.id, row.source, row.chapter, row.what, row.answer] for row in rows)
    return text.getvalue()


def read_scene(path):
    """Ids are the words at the beginning of the first line that look like one. The sentence is the rest of the line; if
    that does not end with a full stop, it goes on up to the first one of the comment."""
    comment = []
    for line in text_of(path).splitlines():
        if not line.startswith("#"):
            break
        comment.append(line.lstrip("# ").rstrip())
    words = comment[0].split() if comment else []
    ids = []
    while words and re.fullmatch(r"[A-Z]{1,2}x?\d[\w.]*,?", words[0]):
        ids.append(words.pop(0).rstrip(","))
    sentence = " ".join(words)
    if sentence and not sentence.endswith("."):
        sentence = re.split(r"(?<=\.) ", " ".join([sentence, *comment[1:]]), maxsplit=1)[0]
    return Scene(path, sentence, ids)


def read_suite(path):
    """(scene, name of the shot, golden without its extension, whether it has to have one) of every shot of a suite."""
    suite = tomllib.loads(text_of(path))
    folder = os.path.dirname(path)
    patterns = lambda value: [value] if isinstance(value, str) else value or []
    for shot in suite.get("shot", []):
        shot = suite.get("defaults", {}) | shot
        inside = lambda key: [os.path.normpath(os.path.join(folder, each)) for each in patterns(shot.get(key))]
        scenes = [scene for each in inside("script") for scene in files(each)]
        for scene in scenes:
            if any(fnmatch.fnmatch(scene, each) for each in inside("except")):
                continue
            stem = os.path.splitext(os.path.basename(scene))[0]
            name = shot.get("name", stem) if len(scenes) == 1 else f"{shot['name']}/{stem}" if "name" in shot else stem
            goldens = os.path.normpath(os.path.join(folder, suite.get("goldens", "")))
            wants = shot.get("golden", True) and "expect-error" not in shot
            yield scene, name, f"{goldens}/{name}", wants


def read_scenes(problems):
    """The example scenes with their shots; adds what is wrong with these."""
    scenes = {path: read_scene(path) for path in files("glib/*/*.glib")}
    for suite in files("scenes/*.toml"):
        topic = os.path.splitext(os.path.basename(suite))[0]
        for path, name, golden, wants in read_suite(suite):
            goldens = [each for ending in (".png", "@*.png", ".exr", "@*.exr") for each in files(glob.escape(golden) + ending)]
            if wants and not goldens:
                problems.append(f"{suite}: the shot {name} has no golden")
            if path not in scenes:
                continue
            scenes[path].shots.append(f"{topic}/{name}")
            scenes[path].goldens += [each for each in goldens if each.endswith(".png") and each not in scenes[path].goldens]
    return list(scenes.values())


def connect(rows, scenes):
    """Gives rows their scenes and tasks, and scenes their rows. Yields what is wrong."""
    known = {}
    for row in rows:
        if row.id in known:
            yield f"{ROWS}: {row.id} stands there twice"
        known[row.id] = row
    if len(rows) != TOTAL:
        yield f"{ROWS}: {len(rows)} rows in place of {TOTAL}"
    for scene in scenes:
        for each in scene.ids:
            if each not in known:
                yield f"{scene.path}: {ROWS} has no row {each}"
            else:
                known[each].scenes.append(scene)
                scene.rows.append(known[each])
        if not scene.shots:
            yield f"{scene.path}: no suite of scenes/*.toml draws it"
        elif not scene.goldens and not re.search(r"^\s*Expect\b", text_of(scene.path), re.MULTILINE | re.IGNORECASE):
            yield f"{scene.path}: no golden, and no Expect"
    for path in files("glib/exercises/*/*.glib"):
        found = re.match(r"#\s*Exercise ([\w., ]+):", text_of(path))
        ids = re.split(r"[ ,]+", found.group(1)) if found else []
        if not ids or any(each not in known for each in ids):
            yield f"{path}: the first line is not '# Exercise ID: ...' with ids of {ROWS}"
        else:
            for each in ids:
                known[each].task = path
        grading = path.removesuffix(".glib") + ".toml"
        if not os.path.exists(full(grading)):
            yield f"{path}: {grading} is missing"
        elif not os.path.exists(os.path.join(full(os.path.dirname(path)), tomllib.loads(text_of(grading))["solution"])):
            yield f"{grading}: the solution does not exist"


def wrong_answers(rows, scenes):
    shots = {shot for scene in scenes for shot in scene.shots}
    for row in rows:
        if row.state() == "elsewhere" and not re.search(r"`[^`\s]+/[^`\s]+`", row.answer):
            yield f"{ROWS}: {row.id} names neither a scene nor a file"
        if not row.scenes and not row.answer:
            yield f"{ROWS}: {row.id} has no scene; name what answers it, or write `not yet`"
        for kind, word in re.findall(r"(shot )?`([^`\s]+/[^`\s]+)`", row.answer):
            if kind and word not in shots:
                yield f"{ROWS}: {row.id} names a shot that no suite has: {word}"
            elif not kind and not files(word):
                yield f"{ROWS}: {row.id} names a file that does not exist: {word}"


def main():
    problems = []
    rows, scenes = read_rows(), read_scenes(problems)
    problems += connect(rows, scenes)
    for row in rows:
        if row.scenes and UNANSWERED.match(row.answer):
            row.answer = ""
    problems += wrong_answers(rows, scenes)
    if "--missing" in sys.argv:
        for row in rows:
            if row.state() == "not yet":
                print(f"{row.id:8} {row.source}{', ' + row.chapter if row.chapter else ''}: {row.what}")
        return
    pages = {ROWS: rows_text(rows), **coverage_pages.pages(rows, scenes)}
    old = [path for path in files("docs/chapters/*.md") if path not in pages]
    if "--check" in sys.argv:
        for path, text in pages.items():
            if not os.path.exists(full(path)) or text_of(path) != text:
                problems.append(f"{path} is not current: run tools/coverage.py")
        problems += [f"{path} is of no chapter: run tools/coverage.py" for path in old]
    else:
        os.makedirs(full("docs/chapters"), exist_ok=True)
        for path, text in pages.items():
            with open(full(path), "w", encoding="utf-8") as file:
                file.write(text)
        for path in old:
            os.remove(full(path))
    if problems:
        sys.exit("\n".join(problems))


if __name__ == "__main__":
    main()
