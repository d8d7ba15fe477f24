#!/usr/bin/env python3
"""Writes glib/README.md: every scene with the inventory ids that its header line and those of its shaders answer.

usage: tools/coverage.py [--check]     --check writes nothing and fails if the file is not up to date
"""
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
IDENTIFIER = re.compile(r"\b(?:GX|SH|EX|PF|NM|D|B|X)\d{2,3}(?:\.\d+)?\b")
STAGE = re.compile(r"^\s*(?:Vertex|TessControl|TessEvaluation|Geometry|Fragment)\s+(\S+)", re.IGNORECASE)


def first_line(path):
    with open(path, encoding="utf-8") as file:
        return file.readline().strip().lstrip("#/ ")


def identifiers(scene, topic):
    texts = [first_line(scene)]
    with open(scene, encoding="utf-8") as file:
        for line in file:
            match = STAGE.match(line)
            if match:
                texts.append(first_line(os.path.join(ROOT, "shaders", topic, match.group(1))))
    found = []
    for text in texts:
        for each in IDENTIFIER.findall(text):
            if each not in found:
                found.append(each)
    return found


def table():
    lines = ["# The example scenes", "",
             "One folder a topic; shaders lie in `shaders/TOPIC`, pictures and volumes in `textures`, models in",
             "`scenes/models`. The ids are those of the inventory that a scene and its shaders answer. Written by",
             "`tools/coverage.py` from the header lines.", "", "| scene | ids | what it shows |", "|---|---|---|"]
    folder = os.path.join(ROOT, "glib")
    for topic in sorted(os.listdir(folder)):
        if not os.path.isdir(os.path.join(folder, topic)):
            continue
        for name in sorted(os.listdir(os.path.join(folder, topic))):
            if not name.endswith(".glib"):
                continue
            path = os.path.join(folder, topic, name)
            header = first_line(path)
            ids = identifiers(path, topic)
            text = re.sub(r"^(?:" + IDENTIFIER.pattern + r"[\s,/()–-]*)+", "", header).replace("|", "\\|")
            lines.append(f"| [{topic}/{name[:-5]}]({topic}/{name}) | {' '.join(ids)} | {text} |")
    return "\n".join(lines) + "\n"


def main():
    path = os.path.join(ROOT, "glib", "README.md")
    text = table()
    if "--check" in sys.argv:
        with open(path, encoding="utf-8") as file:
            sys.exit(0 if file.read() == text else "glib/README.md is not up to date: run tools/coverage.py")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main()
