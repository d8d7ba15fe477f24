#!/usr/bin/env python3
"""Tests that were written for Linux, with the programs for Windows under Wine, all but those that tests/windows.txt leaves out.

usage: run.py window|pages [CLASS[.TEST]...]     (with GLIBRA_PROGRAM=tools/windows/glibra-under-wine and what it needs)
"""

import importlib
import os
import pathlib
import sys
import unittest

TESTS = pathlib.Path(__file__).resolve().parents[1]
# Of the window all but those that preload libraries of Linux, and the random ones, which take hours.
FOLDERS = {
    "window": ("view/window", ["widgets", "scenes", "keeping", "writing", "safety", "sliders", "keyboard", "frame", "looking",
                               "replay", "modern", "exercises", "lecture", "tutorial", "layout", "frame_window", "files"]),
    "pages": ("report", ["review", "class", "gallery", "class_serve"])}


def each_of(suite):
    for each in suite:
        if isinstance(each, unittest.TestSuite):
            yield from each_of(each)
        else:
            yield each


def main(part, wanted):
    folder, files = FOLDERS[part]
    sys.path.insert(0, str(TESTS / folder))
    left_out = {line.split()[0] for line in (TESTS / "windows.txt").read_text().splitlines() if line.strip()}
    chosen = unittest.TestSuite()
    for name in files:
        module = importlib.import_module(name + "_test")
        module.PROGRAM = os.environ["GLIBRA_PROGRAM"]
        for test in each_of(unittest.defaultTestLoader.loadTestsFromModule(module)):
            group, method = test.id().split(".")[-2:]
            names = {group, f"{group}.{method}"}
            if not names & left_out and (not wanted or names & set(wanted)):
                chosen.addTest(test)
    if chosen.countTestCases() == 0:
        sys.exit("no such test")
    sys.exit(not unittest.TextTestRunner(verbosity=2 if wanted else 1).run(chosen).wasSuccessful())


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
