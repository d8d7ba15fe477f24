#!/usr/bin/env python3
"""Writes glib/README.md: every scene with what it shows and where it comes from.

The first line of a scene and of each of its shaders begins with the ids of the exercises that it answers, for example
`SH033`. This program turns the ids into the book and its chapters.

usage: tools/coverage.py [--check]     --check writes nothing and fails if the file is not current
"""
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
IDENTIFIER = re.compile(r"\b(?:(?:GX|SH|EX|PF|NM|D|B|X)\d{2,3}(?:\.\d+)?|G\d{1,2}\.\w+|S\d{2})\b")
STAGE = re.compile(r"^\s*(?:Vertex|TessControl|TessEvaluation|Geometry|Fragment|Compute)\s+(\S+)", re.IGNORECASE)

# The chapters of the book. GX: scenes, SH: shaders, D: pictures. An entry holds from its number on, up to the next one.
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


def chapter(identifier):
    """The number of a chapter, "G4" for chapter 4 of the second book, or "S" for the slides."""
    if re.match(r"G\d", identifier):
        return identifier.split(".")[0]
    if re.match(r"S\d", identifier):
        return "S"
    family = identifier.rstrip("0123456789.")
    number = int(re.sub(r"\D", "", identifier.split(".")[0]))
    starts = [start for start in CHAPTERS[family] if start <= number]
    return CHAPTERS[family][max(starts)]


def source(ids):
    chapters = sorted({chapter(each) for each in ids}, key=lambda each: (isinstance(each, str), each))
    return ", ".join(str(each) for each in chapters) if chapters else "-"


def table():
    lines = ["# The example scenes", "",
             "There is one folder per topic. Shaders are in `shaders/TOPIC`, pictures and volumes in",
             "[textures](../textures/README.md), models in [scenes/models](../scenes/models/README.md).", "",
             "Nearly all scenes answer exercises of the book \"Graphics Shaders: Theory and Practice\" (Bailey, Cunningham,",
             "second edition, 2012). The shaders were written anew from the behaviour that the book describes; the column",
             "\"chapter\" names the chapters. G and a number is a chapter of \"Computer Graphics Programming in OpenGL with",
             "Java\" (Gordon, Clevenger, third edition). S is a set of lecture slides about GLSL. The first lines of scenes and shaders",
             "have the exact ids of the exercises.", "",
             "`tools/coverage.py` writes this page from those first lines.", "",
             "| scene | what it shows | chapter |", "|---|---|---|"]
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
