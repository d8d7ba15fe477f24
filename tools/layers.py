#!/usr/bin/env python3
"""Checks that no include runs upward.

The rooms and their order are declared in CMakeLists.txt and tools/cmake/*.cmake: glibra_room(NAME ROOMS ...) may include
itself, the rooms that it names, and the rooms that those name. Programs (src/cli, src/view/window and a
room's folder program) may include every room and the command line, and no room may include them. Inside glsl the
sub-folders have an order of their own. Prints each include that breaks the order, as file:line, and exits with status 1
if there is one.

    tools/layers.py
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SOURCE = ROOT / "src"

# The sub-folders of glsl: what each may include besides itself. "" holds the contract, glsl/translate.h.
GLSL = {
    "types": set(),
    "read": {"types"},
    "parse": {"types", "read"},
    "facts": {"types", "read", "parse"},
    "rules": {"types", "read", "parse", "facts"},
    "emit": {"types", "read", "parse", "rules", "facts"},
    "": {"types", "read", "parse", "rules", "facts", "emit"},
}

INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"')


def declared_rooms():
    """Room to all rooms that it may include."""
    rooms = {}
    for file in [ROOT / "CMakeLists.txt", *sorted((ROOT / "tools" / "cmake").glob("*.cmake"))]:
        text = re.sub(r"#[^\n]*", "", file.read_text())
        for call in re.findall(r"^\s*glibra_room\(([^)]*)\)", text, re.MULTILINE):
            words = call.split()
            named = words[words.index("ROOMS") + 1:] if "ROOMS" in words else []
            named = named[: named.index("LINK")] if "LINK" in named else named
            for each in named:
                if each not in rooms:
                    sys.exit(f"{file.name}: room {words[0]} names {each}, which is not declared before it")
            rooms[words[0]] = set(named).union(*(rooms[each] for each in named))
    return rooms


def is_program(path):
    """True for files that belong to a program rather than to a room."""
    return path.parts[0] == "cli" or path.parts[1] == "program" or path.parts[:2] == ("view", "window")


def includes():
    """(file, line number, included path) of every include of a file of src, with paths relative to src."""
    for file in sorted(SOURCE.rglob("*")):
        if file.suffix not in (".h", ".cpp", ".inc"):
            continue
        for number, line in enumerate(file.read_text().splitlines(), 1):
            found = INCLUDE.match(line)
            if found:
                yield file.relative_to(SOURCE), number, Path(found.group(1))


def folder_of(path):
    """The sub-folder of glsl that a file is in."""
    return path.parts[1] if len(path.parts) > 2 else ""


def problem_of(file, included, rooms):
    """What is wrong with an include, or None."""
    if not (SOURCE / included).is_file():
        return None  # another project's, or generated
    if is_program(file):
        return None
    if is_program(included):
        return "no room may include a program"
    room, other = file.parts[0], included.parts[0]
    if room not in rooms:
        return f"room {room} is not declared with glibra_room()"
    if other != room:
        return None if other in rooms[room] else f"{room} may not include {other}"
    if room != "glsl":
        return None
    own, below = folder_of(file), folder_of(included)
    if own not in GLSL:
        return f"tools/layers.py does not know the folder glsl/{own}"
    return None if below == own or below in GLSL[own] else f"glsl/{own} may not include glsl/{below}"


def main():
    rooms = declared_rooms()
    count = 0
    problems = []
    for file, number, included in includes():
        count += 1
        problem = problem_of(file, included, rooms)
        if problem:
            problems.append(f'src/{file}:{number}: "{included}": {problem}')
    print("\n".join(problems) if problems else f"{count} includes follow the order of the rooms")
    return 1 if problems or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
