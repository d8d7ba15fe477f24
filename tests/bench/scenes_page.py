#!/usr/bin/env python3
"""Writes scenes.md from reports of `glibra bench scenes budget --json FILE`: the shipped scenes under --max-error."""
import argparse
import json
import os
import sys

BOUND = .25  # pixels, as src/bench/subjects/error_bound.cpp has it
PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "scenes.md")
BEGIN, END = "<!-- figures -->\n", "<!-- end of figures -->\n"


def figure(report, subject, name):
    """The curves of a figure by name, each a dictionary from scene to point, and its findings; nothing if it is not there."""
    for each in report["subjects"]:
        for found in each["figures"]:
            if each["name"] == subject and found["name"] == name:
                curves = {curve["name"]: {point["label"]: point for point in curve["points"]} for curve in found["curves"]}
                return curves, found["findings"]
    return None, []


def table(report):
    bound, findings = figure(report, "budget", "bound")
    if bound is None:
        sys.exit("the report has nothing of the subject 'budget'")
    default, kept, free = bound["default"], bound["--max-error"], bound["--max-error --override-counts"]
    fine = bound["four times as fine"]
    pictures, _ = figure(report, "scenes", "root-mean-square")
    machine = report["machine"]
    lines = [f"Measured on: {machine['processor']}, {machine['cores']} processors; {machine['system']}; {machine['renderer']}, "
             f"{machine['version']}; {report['date'][:10]}.", ""]
    lines += [f"- {each}" for each in findings] + [""]
    heads = ["scene", "off by default", "`--max-error`", "and `--override-counts`", "bound kept", "time of the default",
             "`--max-error`", "and `--override-counts`", "all four times as fine"]
    if pictures:
        heads += ["picture: 1 sample", "`--max-error`"]
    lines += ["| " + " | ".join(heads) + " |", "|---" * len(heads) + "|"]
    for scene in sorted(default):
        times = [f"{curve[scene]['time']['median'] / default[scene]['time']['median']:.2f}" for curve in (kept, free, fine)]
        is_kept = kept[scene]["error"] <= BOUND, free[scene]["error"] <= BOUND
        words = {(True, True): "yes", (False, True): "with `--override-counts`", (True, False): "as stated", (False, False): "no"}
        cells = [scene] + [f"{curve[scene]['error']:g}" for curve in (default, kept, free)] + [words[is_kept]]
        cells += [f"{1e3 * default[scene]['time']['median']:.1f} ms"] + times
        if pictures:
            cells += [f"{pictures[curve][scene]['error']:.4f}" for curve in ("1 sample", "--max-error 0.25")]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("report", help="written by `glibra bench scenes budget --json FILE`")
    parser.add_argument("--write", action="store_true", help="put the table into scenes.md instead of printing it")
    arguments = parser.parse_args()
    with open(arguments.report, encoding="utf-8") as file:
        text = table(json.load(file))
    if not arguments.write:
        print(text, end="")
        return
    with open(PAGE, encoding="utf-8") as file:
        page = file.read()
    before, rest = page.split(BEGIN)
    after = rest.split(END)[1]
    with open(PAGE, "w", encoding="utf-8") as file:
        file.write(before + BEGIN + text + END + after)


if __name__ == "__main__":
    main()
