#!/usr/bin/env python3
"""Reports what nothing of src uses any more: headers that only their own .cpp file and tests include, and functions whose
name stands nowhere in src but where they are declared and defined. A compiler does not report them, and a removal leaves
them behind. A name that something else has, too, is not found. Reports files that comments name and that are not there,
too. Prints one line for each, and exits with status 1 if there is one; also for an exception that is listed and not needed.

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

# Files of others that comments name.
FOREIGN = {"gstap.h", "jpeglib.h", "landlock.h", "osmesa.h", "windows.h", "winternl.h", "ntifs.h"}

COMMENT = re.compile(r"//[^\n]*")
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
WORD = re.compile(r"[A-Za-z_]\w*")
DEFINED = re.compile(r"^\S[^\n(]*\b([a-z]\w*)\(", re.MULTILINE)  # at the beginning of a line

NAMED = re.compile(r"\b(?:\w+/)*[a-z][a-z0-9_]*\.(?:h|cpp|def)\b")


def misnamed(path, text, files):
    """Files that comments name by their whole name, or by its end, and that are not there."""
    for number, line in enumerate(text.split("\n"), 1):
        for name in NAMED.findall("".join(COMMENT.findall(line))):
            if name.split("/")[-1] not in FOREIGN and not any(f"/{each}".endswith(f"/{name}") for each in files):
                yield f"src/{path}:{number}: there is no file {name}"


def main():
    texts = {path.relative_to(SOURCE): path.read_text() for path in SOURCE.rglob("*")
             if path.suffix in (".h", ".cpp", ".inc", ".def")}
    included = {(Path(name), path) for path, text in texts.items() for name in INCLUDE.findall(text)}
    words = {path: Counter(WORD.findall(COMMENT.sub("", text))) for path, text in texts.items()}
    everywhere = sum(words.values(), Counter())

    files = [str(path.relative_to(SOURCE.parent)) for folder in ("src", "include", "tests") for path in
             (SOURCE.parent / folder).rglob("*")]
    problems = [each for path, text in sorted(texts.items()) for each in misnamed(path, text, files)]
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
