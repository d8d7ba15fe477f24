#!/usr/bin/env python3
"""Checks that no include runs upward, and that no files include each other in a circle.

The rooms and their order are declared in CMakeLists.txt and tools/cmake/*.cmake: glibra_room(NAME ROOMS ...) may include
itself, the rooms that it names, and the rooms that those name. Programs (src/cli, src/python, src/view/window,
src/page/runtime and a room's folder program) may include every room and the command line, and no room may include them. The order of the
sub-folders of a room is ORDER, below. What differs between operating systems stands in src/system alone (the door): no
other file has a header, a condition, a call or a path of one system. A .cpp file and the header of the same name count as one file: the circle of two
headers and the circle that is closed by a .cpp file are the same mistake. Prints each include that breaks a rule, as
file:line, and exits with status 1 if there is one.

    tools/layers.py                                  # check all includes
    tools/layers.py --figures                        # and count the arrows between the sub-folders of each room
    tools/layers.py --table                          # the table of rooms of docs/architecture.md
    tools/layers.py --update docs/architecture.md    # write it there
    tools/layers.py --check docs/architecture.md     # compare: same rooms and sub-folders, lines within 10 percent
"""

import argparse
import itertools
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SOURCE = ROOT / "src"

# What the sub-folders of a folder may include of each other. A name that is no folder is a file of the folder itself
# (with its .cpp), and "" stands for all its other files. Each names only what stands above it in this list.
ORDER = {
    "system": {
        "": set(),  # the headers, which know no system
        "posix": {""},
        "linux": {"", "posix"},
        "windows": {""},
        "web": {""},
    },
    "geometry": {
        "": set(),
        "shapes": {""},
        "obj": {""},
    },
    "glib": {
        "": set(),
        "parse": {""},
    },
    "glsl": {
        "types": set(),
        "read": {"types"},
        "parse": {"types", "read"},
        "facts": {"types", "read", "parse"},
        "rules": {"types", "read", "parse", "facts"},
        "emit": {"types", "read", "parse", "rules", "facts"},
        "es": {"types", "read", "parse", "rules", "facts", "emit"},
        "": {"types", "read", "parse", "rules", "facts", "emit"},  # the contract, glsl/translate.h
    },
    "image": {
        "": set(),
        "png": {""},
        "formats": {""},
        "compare": {""},
        "video": {"", "png"},
        "format": {"", "png", "formats"},
        "module": set(),
        "module_loader": {"", "format", "module"},
        "read": {"", "format", "png", "formats", "module_loader"},
        "texture_file": {"", "format", "read"},
        "write": {"", "format", "png", "video", "module_loader"},
    },
    "gpu": {
        "context": set(),
        "format": {"context"},
        "object": {"context", "format"},
        "state": {"context", "format", "object"},
    },
    "scene": {
        "": set(),  # the Scene, and how files are found
        "run": {""},  # what all statements share while a script runs
        "classic": {"", "run"},
        "modern": {"", "run", "classic"},
        "actions": {"", "run", "classic", "modern"},
        "interpret": {"", "run", "classic", "modern", "actions"},
    },
    "render": {
        "stats": set(),
        "load": {"stats"},
        "draw": {"stats", "load"},
        "simulation": {"stats", "load", "draw"},
        "": {"stats", "load", "draw", "simulation"},  # Conductor, and SceneState, which draws pictures
        "live": {"stats", "load", "draw", "simulation", ""},
        "probe": {"stats", "load", "draw", "simulation", ""},
        "scene_renderer": {"stats", "load", "draw", "simulation", "", "probe"},
        "check": {"stats", "load", "draw", "simulation", "", "probe", "scene_renderer"},
        "file": {"stats", "load", "draw", "simulation", "", "probe", "scene_renderer", "check"},
    },
    "suite": {
        "": set(),
        "module": set(),
        "options": {""},
        "file": {"", "options"},
        "golden": {"", "options", "file"},
        "results": {"", "golden"},
        "report": {"", "options", "golden", "results"},
        "run": {"", "options", "file", "golden", "results", "report"},
        "serve": {"", "module", "options", "file", "golden", "results", "report", "run"},
    },
    "page": {
        "": set(),
        "runtime": set(),  # a program of WebAssembly
    },
    "bench": {
        "core": set(),
        "reference": set(),
        "subjects": {"core", "reference"},
        "report": {"core"},
        "program": {"core", "subjects", "report"},
    },
    "view": {
        "style": set(),
        "scene": set(),
        "debug_view": {"scene"},
        "edit": {"style", "scene"},
        "session": {"scene", "debug_view", "edit"},
        "browse": {"scene", "edit", "session"},
        "export": {"scene", "session"},
        "window": {"style", "scene", "debug_view", "edit", "session", "browse", "export"},
    },
    "view/window": {
        "platform": set(),
        "panels": {"platform"},
        "": {"platform", "panels"},
    },
}

INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"')

# Programs that are no room, and the CMake target that names what they link.
PROGRAMS = {"cli": "glibra_cli", "python": "glibra_python"}

# The door to the operating system. Headers of others in <>, besides those of the standard library, by their beginnings.
LIBRARIES = ("glibra/", "glm/", "fmt/", "CLI/", "nlohmann/", "glad/", "libdeflate.h", "spng.h", "xxhash.h", "minizip/",
             "GLFW/", "imgui", "backends/imgui_impl_", "stb_", "stb/", "embedded/", "math.h", "stddef.h", "stdint.h", "httplib.h", "OpenImageIO/", "Imath", "Imf", "half.h", "OpenEXR/", "webp/", "jpeglib.h", "tiffio.h", "pybind11/",
             "boost/", "toml++/")
# What an implementation in src/system may include besides. posix has no header that only Linux has.
POSIX = re.compile(r"(sys/(file|ioctl|mman|resource|socket|stat|types|utsname|wait)|dlfcn|fcntl|poll|pthread|signal|spawn|stdlib|"
                   r"termios|unistd)\.h")
LINUX = re.compile(r"(sys/(eventfd|inotify|prctl|syscall|xattr)|linux/\w+|link|sched|seccomp)\.h")
SYSTEM_WORDS = re.compile(
    r"\b_WIN32\b|\b_WIN64\b|__linux__|__unix__|__APPLE__|__FreeBSD__|__ANDROID__|__MINGW32__|__CYGWIN__|_POSIX_\w+"
    r"|(?<![\w:>.])::(open|read|write|close|fork|kill|stat|fstat|lstat|access|pipe|poll|mmap|dup2?|unlink|rename|getpid|"
    r"raise|signal|alarm|isatty|_exit|mkdir|dlopen|dlsym|send|recv|flock|uname|usleep)\("
    r"|\b(setenv|unsetenv|putenv|localtime_r|gmtime_r|timegm|tm_gmtoff|clock_gettime|clock_getcpuclockid|fileno|fdopen|"
    r"popen|mkstemp|mkdtemp|realpath|strsignal|pid_t|mode_t|sigaction|posix_\w+|dlopen|dlsym|waitpid|getpid)\b"
    r'|"/(proc|dev|sys|etc|usr|tmp|run|var)(/|")|"(XDG_\w+|HOME|APPDATA|LOCALAPPDATA|USERPROFILE)"')
# Files that have such a word all the same.
MAY_HAVE = {
    "include/glibra/export.h": "what a compiler needs to export a function; public headers include no room",
    "src/system/processors.h": "what a compiler and a loader can do together",
}

BEGIN, END = "<!-- rooms: the first, third and fourth column by tools/layers.py --update -->", "<!-- end of rooms -->"


def cmake_texts():
    """(file name, text without comments) of the files that declare rooms, in their order."""
    for file in [ROOT / "CMakeLists.txt", *sorted((ROOT / "tools" / "cmake").glob("*.cmake"))]:
        yield file.name, re.sub(r"#[^\n]*", "", file.read_text())


def named_rooms():
    """Room to the rooms that its declaration names, in the order of the declarations."""
    rooms = {}
    for file, text in cmake_texts():
        for call in re.findall(r"^\s*glibra_room\(([^)]*)\)", text, re.MULTILINE):
            words = call.split()
            named = words[words.index("ROOMS") + 1:] if "ROOMS" in words else []
            named = list(itertools.takewhile(lambda word: word not in ("WITHOUT", "LINK"), named))
            for each in named:
                if each not in rooms:
                    sys.exit(f"{file}: room {words[0]} names {each}, which is not declared before it")
            rooms[words[0]] = named
    return rooms


def reachable_rooms(named):
    """Room to all rooms that it may include."""
    rooms = {}
    for room, below in named.items():
        rooms[room] = set(below).union(*(rooms[each] for each in below))
    return rooms


def is_program(path):
    """True for files that belong to a program rather than to a room."""
    return (path.parts[0] in PROGRAMS or path.parts[1] == "program" or
            path.parts[:2] in (("view", "window"), ("page", "runtime")))


def sources(folder):
    return sorted(file for file in folder.rglob("*") if file.suffix in (".h", ".cpp", ".inc"))


def includes():
    """(file, line number, included path) of every include of a file of src by another one, with paths relative to src."""
    for file in sources(SOURCE):
        for number, line in enumerate(file.read_text().splitlines(), 1):
            found = INCLUDE.match(line)
            if found and (SOURCE / found.group(1)).is_file():  # else another project's, or generated
                yield file.relative_to(SOURCE), number, Path(found.group(1))


def arrow(file, included):
    """An include as text. A .cpp file and its header have one name."""
    return f"{file.with_suffix('')} -> {included.with_suffix('')}"


def steps(file, included):
    """(folder, own sub-folder, included sub-folder) for each folder with an order that both files are in."""
    for folder, order in ORDER.items():
        if not (file.is_relative_to(folder) and included.is_relative_to(folder)):
            continue
        names = []
        for path in (file.relative_to(folder), included.relative_to(folder)):
            name = path.parts[0] if len(path.parts) > 1 else path.stem
            names.append(name if len(path.parts) > 1 or name in order else "")
        if names[0] != names[1]:
            yield folder, *names


def faults_of_order():
    """What is wrong with ORDER itself."""
    for room in sorted(path for path in SOURCE.iterdir() if path.is_dir() and path.name not in ORDER):
        if any(path.is_dir() and sources(path) for path in room.iterdir()):
            yield f"tools/layers.py: ORDER does not say what the sub-folders of src/{room.name} may include of each other"
    for folder, order in ORDER.items():
        above = set()
        for name, allowed in order.items():
            if not allowed <= above:
                yield f"tools/layers.py: {folder}/{name} names {', '.join(sorted(allowed - above))}, not declared above it"
            if not any((SOURCE / folder / (name + suffix)).exists() for suffix in ("", ".h")):
                yield f"tools/layers.py: there is no src/{folder}/{name}"
            above.add(name)
        for child in sorted(path for path in (SOURCE / folder).iterdir() if path.is_dir() and sources(path)):
            if child.name not in order:
                yield f"tools/layers.py: ORDER does not say where src/{folder}/{child.name} stands"


def room_problem(file, included, rooms):
    """Which rule about rooms an include breaks, or None."""
    if is_program(file):
        return None
    if is_program(included):
        return "no room may include a program"
    room, other = file.parts[0], included.parts[0]
    if room not in rooms:
        return f"room {room} is not declared with glibra_room()"
    return None if other == room or other in rooms[room] else f"{room} may not include {other}"


def order_problem(file, included):
    """Which order of sub-folders an include breaks, or None."""
    for folder, own, below in steps(file, included):
        order = ORDER[folder]
        if own in order and below in order and below not in order[own]:
            return f"the files of {folder}/{own} may not include those of {folder}/{below}"
    return None


def door_problem(file, line):
    """What a line has that only src/system may have, or None. `file` is relative to the root."""
    folder = file.parent.name if file.is_relative_to("src/system") else ""
    if folder not in ("", "system"):  # an implementation
        header = re.match(r"\s*#\s*include\s*<([^>]+\.h)>", line)
        allowed = {"posix": (POSIX,), "linux": (POSIX, LINUX)}.get(folder)
        if header and allowed and not any(each.fullmatch(header.group(1)) for each in allowed):
            return f"<{header.group(1)}> is no header that src/system/{folder} may use"
        return None
    header = re.match(r"\s*#\s*include\s*<([^>]+)>", line)
    if header and (header.group(1) == "csignal" or
                   (re.search(r"[./]", header.group(1)) and not header.group(1).startswith(LIBRARIES))):
        return f"<{header.group(1)}> is for src/system alone, unless it is a library's: then LIBRARIES names it"
    code = re.sub(r"(^|\s)//.*", "", line)
    if re.search(r"(?<!str)(\.|->)string\(\)", code):
        return "string() of a path has other separators on Windows; generic_string() has the same everywhere"
    word = SYSTEM_WORDS.search(code)
    return f"{word.group(0)} is for src/system alone" if word and file.as_posix() not in MAY_HAVE else None


def door_problems():
    """Every line outside of src/system that has something of one operating system."""
    for folder in (SOURCE, ROOT / "include"):
        for path in sources(folder):
            file = path.relative_to(ROOT)
            for number, line in enumerate(path.read_text().splitlines(), 1):
                problem = door_problem(file, line)
                if problem:
                    yield f"{file}:{number}: {problem}"


def circles(graph):
    """The sets of two or more files that reach each other (Tarjan 1972)."""
    index, low, open_files, found = {}, {}, [], []

    def visit(file):
        index[file] = low[file] = len(index)
        open_files.append(file)
        for other in sorted(graph[file]):
            if other not in index:
                visit(other)
            if other in open_files:
                low[file] = min(low[file], low[other])
        if low[file] == index[file]:
            begin = open_files.index(file)
            if len(open_files) - begin > 1:
                found.append(set(open_files[begin:]))
            del open_files[begin:]

    for file in sorted(graph):
        if file not in index:
            visit(file)
    return found


def graph_of(arrows):
    graph = {}
    for each in arrows:
        file, included = each.split(" -> ")
        graph.setdefault(included, set())
        graph.setdefault(file, set()).update({included} - {file})
    return graph


def problems_of(all_includes, rooms):
    """Every include that breaks a rule."""
    problems = list(faults_of_order())
    for file, number, included in all_includes:
        problem = room_problem(file, included, rooms) or order_problem(file, included)
        if problem:
            problems.append(f'src/{file}:{number}: "{included}": {problem}')
    arrows = {arrow(file, included) for file, _, included in all_includes}
    for circle in circles(graph_of(arrows)):
        inside = [each for each in sorted(arrows) if set(each.split(" -> ")) <= circle and len(set(each.split(" -> "))) == 2]
        problems.append("these files of src include each other in a circle:\n    " + "\n    ".join(inside))
    return problems


def print_figures(all_includes):
    """Counts pairs of sub-folders of which one includes the other: those there are, could be, and are upward."""
    for folder, order in ORDER.items():
        pairs, upward = set(), set()
        for file, _, included in all_includes:
            for each, own, below in steps(file, included):
                if each == folder:
                    pairs.add((own, below))
                    if below not in order.get(own, set()):
                        upward.add((own, below))
        count = len(order)
        print(f"{folder}: {count} parts, {len(pairs)} of {count * (count - 1)} arrows between them, {len(upward)} upward")


def lines_of(room):
    """Lines of code and comments in thousands."""
    files = [*sources(SOURCE / room), *(SOURCE / room).rglob("*.py")]
    return sum(len(file.read_text().splitlines()) for file in files) / 1000


def table_facts(named):
    """Room to (what it may include, lines in thousands), in the order of the table."""
    facts = {room: (", ".join(below) or "-", lines_of(room)) for room, below in named.items()}
    texts = " ".join(text for _, text in cmake_texts())
    for program, target in PROGRAMS.items():
        linked = re.search(rf"target_link_libraries\({target} ([^)]*)\)", texts).group(1)
        facts[program] = (", ".join(re.findall(r"glibra_(\w+)", linked)), lines_of(program))
    return facts


def table_rows(page):
    """The rows of the table of rooms of a page: room to (what it holds, what it may include, lines)."""
    if BEGIN not in page or END not in page:
        sys.exit(f"the page has no table between '{BEGIN}' and '{END}'")
    table = page.split(BEGIN)[1].split(END)[0]
    return {row[0]: row[1:] for row in re.findall(r"^\| `(\w+)` \| (.*) \| ([^|]*) \| ([\d.]+) \|$", table, re.MULTILINE)}


def table_text(named, page):
    """The table, with what the rooms hold as the page has it."""
    held = table_rows(page)
    lines = ["| room | holds | may include | lines |", "|---|---|---|---|"]
    for room, (below, count) in table_facts(named).items():
        lines.append(f"| `{room}` | {held[room][0] if room in held else 'TO BE WRITTEN'} | {below} | {count:.1f} |")
    return "\n".join(lines)


def table_problems(named, page):
    """How the page differs from the tree: rooms, includes, lines, and the sub-folders that the second table names."""
    rows, facts = table_rows(page), table_facts(named)
    if list(rows) != list(facts):
        yield f"the page has the rooms {', '.join(rows)}; CMake declares {', '.join(facts)}"
    for room in rows.keys() & facts.keys():
        holds, below, count = rows[room]
        if "TO BE WRITTEN" in holds:
            yield f"the page does not say what {room} holds"
        if below != facts[room][0]:
            yield f"the page says that {room} may include {below}; CMake says {facts[room][0]}"
        if abs(float(count) - facts[room][1]) > 0.1 * facts[room][1] + 0.05:
            yield f"the page says that {room} has {count} thousand lines; it has {facts[room][1]:.1f}"
    for room in facts:
        found = re.search(rf"^\| `{room}` \| (`.*) \|$", page.split(END)[1], re.MULTILINE)
        cell = found.group(1) if found else ""
        while "(" in cell:  # what the sub-folders hold
            cell, inner = re.sub(r"\([^()]*\)", "", cell), cell
            if cell == inner:
                break
        told = set(re.findall(r"`(\w+)`", cell))
        folders = {path.name for path in (SOURCE / room).iterdir() if path.is_dir() and sources(path)}
        if told != folders:
            yield f"the page says that {room} has the sub-folders {sorted(told)}; it has {sorted(folders)}"


def main():
    parser = argparse.ArgumentParser(description="Checks that no include runs upward, and that there are no circles.")
    parser.add_argument("--figures", action="store_true", help="also count the arrows between sub-folders")
    parser.add_argument("--table", action="store_true", help="print the table of rooms")
    parser.add_argument("--update", metavar="PAGE", type=Path, help="write the table of rooms to a page")
    parser.add_argument("--check", metavar="PAGE", type=Path, help="compare a page's tables with the tree")
    arguments = parser.parse_args()
    named = named_rooms()

    if arguments.table:
        print(table_text(named, (ROOT / "docs" / "architecture.md").read_text()))
        return 0
    if arguments.update:
        page = arguments.update.read_text()
        table = table_text(named, page)
        arguments.update.write_text(f"{page.split(BEGIN)[0]}{BEGIN}\n{table}\n{END}{page.split(END)[1]}")
        return 0
    if arguments.check:
        problems = [f"{arguments.check}: {each}" for each in table_problems(named, arguments.check.read_text())]
        if problems:
            problems.append("tools/layers.py --update docs/architecture.md writes the table; the rest is written by hand")
        print("\n".join(problems) if problems else f"{arguments.check} agrees with the tree")
        return 1 if problems else 0

    all_includes = list(includes())
    problems = problems_of(all_includes, reachable_rooms(named)) + list(door_problems())
    if arguments.figures:
        print_figures(all_includes)
    print("\n".join(problems) if problems else f"{len(all_includes)} includes follow the order of the rooms")
    return 1 if problems or not all_includes else 0


if __name__ == "__main__":
    sys.exit(main())
