#!/usr/bin/env python3
"""Writes glib/README.md: every scene with what it shows and where it comes from.

The first line of a scene and of each of its shaders begins with the ids of the exercises that it answers, for example
`SH033`. This program turns the ids into the book and its chapters; the window reads them from the page.

usage: tools/coverage.py [--check]     --check writes nothing and fails if the file is not current
"""
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
IDENTIFIER = re.compile(r"\b(?:(?:GX|SH|EX|PF|NM|D|B|X)\d{2,3}(?:\.\d+)?|Gx?\d{1,2}(?:\.\w+)?|S\d{2})\b")
STAGE = re.compile(r"^\s*(?:Vertex|TessControl|TessEvaluation|Geometry|Fragment|Compute)\s+(\S+)", re.IGNORECASE)

# The chapters of "Graphics Shaders". GX: scenes, SH: shaders, D: pictures. An entry holds from its number on, up to the
# next one. The ids of "OpenGL with Java" (G, Gx) begin with the chapter, and those of the slides (S) have none.
CHAPTERS = {
    "GX": {1: 3, 3: 4, 7: 7, 8: 9, 10: 11, 13: 12, 14: 13, 18: 15},
    "SH": {1: 3, 8: 4, 10: 6, 16: 7, 20: 8, 27: 9, 36: 10, 45: 11, 74: 12, 78: 13, 94: 14, 95: 15, 113: 16},
    "D": {1: 9, 3: 6, 6: 7, 8: 8, 9: 9, 13: 10, 15: 11, 17: 13, 18: 15, 23: 16},
}


def first_line(path):
    with open(path, encoding="utf-8") as file:
        return file.readline().strip().lstrip("#/ ")


def summary(path):
    """The first line, or the first sentence if the line ends within it."""
    comment = []
    with open(path, encoding="utf-8") as file:
        for line in file:
            if not re.match(r"#|//", line):
                break
            comment.append(line.strip().lstrip("#/ "))
    if not comment or comment[0].endswith("."):
        return comment[0] if comment else ""
    return re.split(r"(?<=\.) ", " ".join(comment), maxsplit=1)[0]


def identifiers(scene, topic):
    texts = [first_line(scene)]
    with open(scene, encoding="utf-8") as file:
        for line in file:
            match = STAGE.match(line)
            if match and match.group(1) != "inline":
                texts.append(first_line(os.path.join(ROOT, "shaders", topic, match.group(1))))
    found = []
    for text in texts:
        for each in IDENTIFIER.findall(text):
            if each not in found:
                found.append(each)
    return found


def place(identifier):
    """The source and the chapter; 0 for slides, which have none."""
    if match := re.match(r"Gx?(\d+)", identifier):
        return "OpenGL with Java", int(match.group(1))
    if re.match(r"S\d", identifier):
        return "GLSL slides", 0
    family = identifier.rstrip("0123456789.")
    number = int(re.sub(r"\D", "", identifier.split(".")[0]))
    starts = [start for start in CHAPTERS[family] if start <= number]
    return "Graphics Shaders", CHAPTERS[family][max(starts)]


def source(ids):
    """For example "Graphics Shaders, chapters 4 and 9; OpenGL with Java, chapter 14"."""
    chapters = {}
    for title, chapter in sorted({place(each) for each in ids}):
        chapters.setdefault(title, []).append(str(chapter))
    texts = []
    for title, numbers in chapters.items():
        if numbers == ["0"]:
            texts.append(title)
        elif len(numbers) == 1:
            texts.append(f"{title}, chapter {numbers[0]}")
        else:
            texts.append(f"{title}, chapters {', '.join(numbers[:-1])} and {numbers[-1]}")
    return "; ".join(texts) if texts else "-"


def table():
    lines = ["# The example scenes", "",
             "There is one folder per topic. Shaders are in `shaders/TOPIC`, pictures and volumes in",
             "[textures](../textures/README.md), models in [scenes/models](../scenes/models/README.md).", "",
             "The last column says which book and chapter a scene is about, as the window does in its examples:", "",
             "- Graphics Shaders: \"Graphics Shaders: Theory and Practice\" (Bailey, Cunningham, second edition, 2012). The shaders",
             "  were written anew from the behaviour that the book describes.",
             "- OpenGL with Java: \"Computer Graphics Programming in OpenGL with Java\" (Gordon, Clevenger, third edition).",
             "- GLSL slides: a set of lecture slides about GLSL.", "",
             "`tools/coverage.py` writes this page from the numbers of exercises (such as SH033) in the first lines of the scenes and",
             "their shaders.", "",
             "| scene | what it shows | source |", "|---|---|---|"]
    folder = os.path.join(ROOT, "glib")
    for topic in sorted(os.listdir(folder)):
        if not os.path.isdir(os.path.join(folder, topic)):
            continue
        for name in sorted(os.listdir(os.path.join(folder, topic))):
            if not name.endswith(".glib"):
                continue
            path = os.path.join(folder, topic, name)
            text = re.sub(r"^(?:" + IDENTIFIER.pattern + r"[\s,/()–-]*)+", "", summary(path)).replace("|", "\\|")
            lines.append(f"| [{topic}/{name[:-5]}]({topic}/{name}) | {text} | {source(identifiers(path, topic))} |")
    lines += ["", "---", "", "[README](../README.md) · [Tutorial](../docs/tutorial.md) · "
              "[The scene language](../docs/language.md)"]
    return "\n".join(lines) + "\n"


def main():
    path = os.path.join(ROOT, "glib", "README.md")
    text = table()
    if "--check" in sys.argv:
        with open(path, encoding="utf-8") as file:
            sys.exit(0 if file.read() == text else "glib/README.md is not current: run tools/coverage.py")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main()
