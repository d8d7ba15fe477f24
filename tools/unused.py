#!/usr/bin/env python3
"""Reports what nothing of src uses any more: headers that only their own .cpp file and tests include, and functions whose
name stands nowhere in src but where they are declared and defined. A compiler does not report them, and a removal leaves
them behind. A name that something else has, too, is not found. Prints one line for each, and exits with status 1 if there
is one; also for an exception that is listed and not needed.

    tools/unused.py
"""

import re
import sys
from collections import Counter
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent / "src"

# What only tests use, and why it stands in src.
FOR_TESTS = {
    "view/style/palette.h": {"tinted"},  # what the drawing of ImGui does with a tint, to measure contrasts
}

# Headers of what no file of C++ calls.
FOR_OTHERS = {"page/runtime/runtime.h"}  # src/page/web/runtime.js

COMMENT = re.compile(r"//[^\n]*")
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
WORD = re.compile(r"[A-Za-z_]\w*")
DEFINED = re.compile(r"^\S[^\n(]*\b([a-z]\w*)\(", re.MULTILINE)  # at the beginning of a line


def main():
    texts = {path.relative_to(SOURCE): path.read_text() for path in SOURCE.rglob("*")
             if path.suffix in (".h", ".cpp", ".inc", ".def")}
    included = {(Path(name), path) for path, text in texts.items() for name in INCLUDE.findall(text)}
    words = {path: Counter(WORD.findall(COMMENT.sub("", text))) for path, text in texts.items()}
    everywhere = sum(words.values(), Counter())

    problems = []
    for header in sorted(path for path in texts if path.suffix == ".h"):
        own = header.with_suffix(".cpp")
        if str(header) not in FOR_OTHERS and not any(name == header and path != own for name, path in included):
            problems.append(f"src/{header}: no other file of src includes it; remove it with its .cpp file and its tests")
            continue
        defined = set(DEFINED.findall(COMMENT.sub("", texts.get(own, ""))))
        declared = {name for name in defined if everywhere[name] == 2 and words[header][name] == 1}
        allowed = FOR_TESTS.get(str(header), set())
        problems += [f"src/{header}: nothing of src uses {name}(); remove it" for name in sorted(declared - allowed)]
        problems += [f"tools/unused.py: the exception {name} of {header} is not needed any more; remove it"
                     for name in sorted(allowed - declared)]
    print("\n".join(problems) if problems else f"src uses all {len(texts)} of its files, and the functions of their headers")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
