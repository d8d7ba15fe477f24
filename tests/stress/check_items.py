#!/usr/bin/env python3
"""Compares tests/stress/README.md with the tests: every item of the two inventories has a row, every test that a
row names exists, and a row names every test of this folder.

usage: tests/stress/check_items.py
"""
import glob
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
TESTS = os.path.dirname(HERE)
TEST = re.compile(r"^TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", re.MULTILINE)
ROW = re.compile(r"^\| ((?:NM|A|S)\d\d) \| ([^|]+) \| ([^|]+) \|$", re.MULTILINE)
NAME = re.compile(r"`(\w+)\.(\w+|\*)`")
ITEMS = {f"NM{i:02}" for i in range(1, 49)} | {f"A{i:02}" for i in range(1, 61)}


def tests_below(folder):
    found = set()
    for path in glob.glob(os.path.join(folder, "**", "*.cpp"), recursive=True):
        with open(path, encoding="utf-8") as file:
            found.update(TEST.findall(file.read()))
    return found


def main():
    with open(os.path.join(HERE, "README.md"), encoding="utf-8") as file:
        rows = ROW.findall(file.read())
    problems = []
    ids = [row[0] for row in rows]
    problems += [f"{each} has {ids.count(each)} rows" for each in sorted(set(ids)) if ids.count(each) > 1]
    problems += [f"{each} has no row" for each in sorted(ITEMS - set(ids))]
    known = tests_below(TESTS)
    suites = {suite for suite, _ in known}
    named = set()
    for item, _, cell in rows:
        names = NAME.findall(cell)
        if not names and not cell.startswith("none: "):
            problems.append(f"{item} names no test and no reason")
        for suite, test in names:
            if test == "*":
                named.update(each for each in known if each[0] == suite)
                if suite not in suites:
                    problems.append(f"{item}: there is no test {suite}.*")
            elif (suite, test) in known:
                named.add((suite, test))
            else:
                problems.append(f"{item}: there is no test {suite}.{test}")
    problems += [f"{suite}.{test} is in no row" for suite, test in sorted(tests_below(HERE) - named)]
    if problems:
        sys.exit("tests/stress/README.md:\n  " + "\n  ".join(problems))


if __name__ == "__main__":
    main()
