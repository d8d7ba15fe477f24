#!/usr/bin/env python3
"""The recipes of docs/editors.md as they stand there: Neovim and Emacs show what the server says about a scene and a shader.

usage: recipes_test.py GLIBRA     Exit status 77: an editor is missing; with GLIBRA_NO_SKIPS set, as by tools/test, that is a failure.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SECONDS = 60
SCENE = "Vertex a.vert\nFragment a.frag\nProgram Show\nTeepot\n"
VERTEX = "#version 330\nin vec4 aVertex;\nvoid main() { gl_Position = aVertex; }\n"
FRAGMENT = "#version 330\nout vec4 color;\nvoid main() { color = vec4(missing); }\n"
EXPECTED = {"a.glib": (4, "Teapot"), "a.frag": (3, "missing")}

NEOVIM = """
vim.wait(SECONDS * 1000, function() return #vim.diagnostic.get(0) > 0 end, 100)
for _, each in ipairs(vim.diagnostic.get(0)) do io.write('found ', each.lnum + 1, ': ', each.message, '\\n') end
vim.cmd('qa!')
"""
EMACS = """
(find-file (getenv "FILE"))
(run-hooks (quote post-command-hook))  ; eglot begins after the command
(let ((end (time-add nil SECONDS)))
  (while (and (null (flymake-diagnostics)) (time-less-p nil end)) (accept-process-output nil 0.1)))
(dolist (each (flymake-diagnostics))
  (message "found %s: %s" (line-number-at-pos (flymake-diagnostic-beg each)) (flymake-diagnostic-text each)))
(kill-emacs)
"""


def recipe(language):
    return re.search(rf"```{language}\n(.*?)```", (ROOT / "docs/editors.md").read_text(), re.DOTALL)[1]


def said_by_neovim(folder, file):
    """What it prints with the recipe as its only settings."""
    settings = folder / "config/nvim"
    settings.mkdir(parents=True, exist_ok=True)
    subprocess.run(["glibra", "language", "--grammar", "vim", "-o", settings], check=True, capture_output=True)
    (settings / "init.lua").write_text(recipe("lua"))
    (folder / "ask.lua").write_text(NEOVIM.replace("SECONDS", str(SECONDS)))
    return ["nvim", "--headless", file, "-c", "luafile ask.lua"]


def said_by_emacs(folder, file):
    (folder / "init.el").write_text(recipe("elisp"))
    (folder / "ask.el").write_text(EMACS.replace("SECONDS", str(SECONDS)))
    os.environ["FILE"] = str(folder / file)
    return ["emacs", "--batch", "--eval", "(progn (require 'package) (package-initialize))", "-l", "init.el", "-l", "ask.el"]


def main():
    os.environ["PATH"] = f"{pathlib.Path(sys.argv[1]).resolve().parent}:{os.environ['PATH']}"
    missing = [each for each in ("nvim", "emacs") if not shutil.which(each)]
    problems = []
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made)
        os.environ.update(HOME=made, XDG_CONFIG_HOME=made + "/config", XDG_STATE_HOME=made + "/state", XDG_DATA_HOME=made + "/data")
        for name, text in {"a.glib": SCENE, "a.vert": VERTEX, "a.frag": FRAGMENT}.items():
            (folder / name).write_text(text)
        for editor, command in {"nvim": said_by_neovim, "emacs": said_by_emacs}.items():
            for file, (line, word) in EXPECTED.items() if editor not in missing else ():
                ran = subprocess.run(command(folder, file), cwd=folder, capture_output=True, text=True, timeout=2 * SECONDS,
                                     check=False)
                said = ran.stdout + ran.stderr
                if not re.search(rf"found {line}: .*{word}", said):
                    problems.append(f"{editor} does not show {word} of line {line} of {file}:\n{said[-2000:]}")
    if missing:
        print("missing:", *missing)
    print("\n".join(problems))
    sys.exit(1 if problems or (missing and os.environ.get("GLIBRA_NO_SKIPS")) else 77 if missing else 0)


if __name__ == "__main__":
    main()
