#!/usr/bin/env python3
"""The extension for Visual Studio Code, installed into code-server and operated by hand in Chromium. Its pictures are those of
`glibra render`, byte by byte.

usage: vscode_test.py GLIBRA VSIX NODE CODE_SERVER [TEST...]     NODE runs CODE_SERVER, a file named entry.js
"""
import base64
import contextlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "report"))
import webdriver  # noqa: E402

SECONDS = 60  # for anything
SHOTS = os.environ.get("GLIBRA_SHOTS")  # a folder for a screenshot of what failed
SETTINGS = {"workbench.startupEditor": "none", "chat.disableAIFeatures": True, "workbench.secondarySideBar.defaultVisibility": "hidden",
            "telemetry.telemetryLevel": "off", "editor.acceptSuggestionOnEnter": "off", "files.autoSave": "off",
            "security.workspace.trust.startupPrompt": "never", "workbench.editor.enablePreview": False, "window.zoomLevel": 0}
SCENE = """WindowSize 160 120
Background .1 .2 .3
Camera eye LookAt 0 0 4  0 0 0  0 1 0  Perspective 40 .1 100
Vertex a.vert
Fragment a.frag
Program Show uG <0. .25 1.> uCount <0 1 3>
Teapot
"""
VERTEX = """#version 330
in vec4 aVertex;
uniform mat4 uModelViewProjectionMatrix;
void main() { gl_Position = uModelViewProjectionMatrix * aVertex; }
"""
FRAGMENT = """#version 330
uniform float uG;
uniform int uCount;
out vec4 fColor;
void main() { fColor = vec4(uG, float(uCount) / 3., 0., 1.); }
"""
ENDLESS = """#version 330
out vec4 fColor;
void main() { float s = 0.; for (int i = 0; i < 2000000000; ++i) s += sin(s + float(i)); fColor = vec4(s); }
"""
TABS = "return [...document.querySelectorAll('.editor-group-container.active .tab.active')].map(e => e.getAttribute('aria-label'))"
IS_QUICK = """const box = document.querySelector('.quick-input-widget');
    return Boolean(box && box.style.display !== 'none' && box.contains(document.activeElement))"""
QUICK = IS_QUICK.replace("return", "const isShown =") + """;
    return isShown ? [...box.querySelectorAll('.monaco-list-row')].map(e => e.getAttribute('aria-label')) : []"""
PROBLEMS = "return [...document.querySelectorAll('.markers-panel .monaco-list-row')].map(e => e.innerText.replace(/\\s+/g, ' '))"
LINES = """return [...document.querySelectorAll('.editor-group-container .monaco-editor .view-line')]
    .sort((a, b) => parseInt(a.style.top) - parseInt(b.style.top)).map(e => e.innerText.replaceAll('\\u00a0', ' '))"""
NOTES = "return [...document.querySelectorAll('.notification-toast')].map(e => e.innerText)"
PANEL = """const byId = (id) => document.getElementById(id);
    if (!byId('picture')) return null;
    return {picture: byId('picture').src.replace(/^[^,]*,/, ''), isShown: byId('picture').naturalWidth > 0,
            messages: byId('messages').innerText, isOld: !byId('age').hidden, isToKeep: !byId('keep').hidden,
            sliders: [...document.querySelectorAll('label')].map(e => [e.children[0].innerText, e.children[2].innerText])}"""


def until(get, is_right=bool, seconds=SECONDS):
    """What `get` gives, as soon as it is right."""
    end = time.time() + seconds
    while True:
        got = get()
        if is_right(got):
            return got
        if time.time() > end:
            raise AssertionError(f"not within {seconds} seconds; now {got!r:.3000}")
        time.sleep(0.05)


class Server:
    """code-server with the extension. `is_known`: glibra is in the PATH; `asks`: folders are not trusted at first."""

    def __init__(self, is_known=True, asks=False):
        self.home = pathlib.Path(tempfile.mkdtemp(prefix="glibra-code-"))
        if is_known:  # the editor takes the PATH of a login shell
            (self.home / ".profile").write_text(f"PATH='{GLIBRA.parent}':$PATH\n")
        data = self.home / "data"
        (data / "User").mkdir(parents=True)
        (data / "User" / "settings.json").write_text(json.dumps(SETTINGS))
        environment = {**os.environ, "HOME": str(self.home)}
        for name in list(environment):
            if name.startswith(("XDG_", "GLIBRA_", "VSCODE_")):
                del environment[name]
        command = [NODE, CODE_SERVER, "--user-data-dir", data, "--extensions-dir", self.home / "extensions",
                   "--config", self.home / "config.yaml", "--disable-telemetry", "--disable-update-check"]
        made = subprocess.run([*command, "--install-extension", VSIX], env=environment, capture_output=True, text=True, check=True)
        if "successfully installed" not in made.stdout:
            raise AssertionError(made.stdout + made.stderr)
        trust = [] if asks else ["--disable-workspace-trust"]
        self.process = subprocess.Popen([*command, "--auth", "none", "--bind-addr", "127.0.0.1:0", *trust], env=environment,
                                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        for line in self.process.stdout:
            if found := re.search(r"listening on (http://\S+?)/?$", line):
                self.address = found[1]
                break
        threading.Thread(target=self.process.stdout.read, daemon=True).start()

    def stop(self):
        self.process.terminate()
        self.process.wait()
        shutil.rmtree(self.home, ignore_errors=True)


class Editor(webdriver.Browser):
    """A window of the editor with a folder."""

    def __init__(self, server, folder):
        super().__init__(1400, 1000)
        self.address = f"{server.address}/?folder={urllib.parse.quote(str(folder))}"

    def start(self):
        super().start()
        self.load()
        return self

    def load(self):
        self.open(self.address)
        until(lambda: self.run("return document.querySelector('.explorer-folders-view .monaco-list-row') !== null"))

    def pick(self, keys, text):
        """Opens a list by keys, and takes the row that begins with the text. A list has only what the editor knew as it was opened."""
        def row():
            self.chord(*keys)
            until(lambda: self.run(IS_QUICK))
            self.press(*text)
            try:
                return until(lambda: self.run(QUICK), lambda rows: rows and rows[0].startswith(text), 3)
            except AssertionError:
                self.press("Escape", "Escape")
                return None
        until(row)
        self.press("Enter")
        until(lambda: self.run(QUICK), lambda rows: not rows or not rows[0].startswith(text))

    def command(self, title):
        self.pick(["F1"], title)

    def show(self, name):
        self.pick(["Control", "p"], name)
        until(lambda: self.run(TABS), lambda tabs: any(each.startswith(name) for each in tabs))

    def go(self, place):
        self.chord("Control", "g")
        until(lambda: self.run(IS_QUICK))
        self.press(*place, "Enter")
        until(lambda: not self.run(IS_QUICK))

    def type(self, text):
        self.press(*text)
        self.press("Escape")  # the list of suggestions

    def line(self, number, text):
        """Writes the line anew."""
        self.chord("Control", "1")
        self.go(f"{number}:1")
        self.chord("Shift", "End")
        self.type(text)

    def lines(self):
        return self.run(LINES)

    def problems(self):
        return self.run(PROBLEMS)

    def watch_problems(self):
        self.command("Problems: Focus on Problems View")
        self.chord("Control", "1")

    def wait_problem(self, *words):
        return until(self.problems, lambda rows: any(all(word in row for word in words) for row in rows))

    def wait_no_problem(self):
        return until(self.problems, lambda rows: not any("[Ln" in row for row in rows))

    @contextlib.contextmanager
    def inside(self, number=0):
        """The page of a picture."""
        try:
            self.frame(self.elements("iframe.webview")[number])
            self.frame(self.element("#active-frame"))
            yield
        finally:
            self.frame()

    def panel(self, number=0):
        try:
            with self.inside(number):
                return self.run(PANEL)
        except (RuntimeError, IndexError):
            return None  # not yet

    def panels(self):
        return [each for each in (self.panel(i) for i in range(len(self.elements("iframe.webview")))) if each]

    def close(self, title):
        """By the mouse."""
        tabs = "return [...document.querySelectorAll('.tab')].filter(e => e.getAttribute('aria-label').startsWith(arguments[0]))"
        self.run(tabs + ".forEach(e => e.querySelector('.tab-actions a').click())", title)
        until(lambda: not self.run(tabs, title))

    def show_picture(self):
        self.command("glibra: Show the Picture Beside the Scene")

    def wait_panel(self, is_right, number=0):
        return until(lambda: self.panel(number), lambda panel: panel is not None and is_right(panel))

    def wait_picture(self, picture, number=0):
        panel = self.wait_panel(lambda panel: panel["picture"] == picture, number)
        until(lambda: self.panel(number)["isShown"])
        return panel

    def move_slider(self, name, part):
        """To this part of its way, by the mouse."""
        left, top = self.run("const place = document.querySelector('iframe.webview').getBoundingClientRect(); return [place.left, place.top]")
        with self.inside():
            x, y, wide, high = self.run("""const place = [...document.querySelectorAll('label')]
                .find(e => e.children[0].innerText === arguments[0]).children[1].getBoundingClientRect();
                return [place.left, place.top, place.width, place.height]""", name)
        x, y = left + x, top + y + high / 2
        self.pointer(("move", x + wide / 2, y), "down", ("move", x + 8 + part * (wide - 16), y), "up")

    def press_keep(self):
        with self.inside():
            self.click("#keep")


def rendered(folder, text, *settings):
    """The picture of the text, as the panel has it."""
    picture = subprocess.run([GLIBRA, "render", "-", "-o", "-", *(f"--set={each}" for each in settings)], cwd=folder,
                             input=text.encode(), capture_output=True, check=True).stdout
    return base64.b64encode(picture).decode()


class Case(unittest.TestCase):
    server_options = {}

    @classmethod
    def setUpClass(cls):
        cls.server = Server(**cls.server_options)

    @classmethod
    def tearDownClass(cls):
        cls.server.stop()

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(dir=self.server.home)) / "scenes of a course"
        self.folder.mkdir()
        for name, text in {"a.glib": SCENE, "a.vert": VERTEX, "a.frag": FRAGMENT}.items():
            (self.folder / name).write_text(text)
        self.editor = self.enterContext(Editor(self.server, self.folder))

    def enterContext(self, context):  # unittest has it from Python 3.11 on
        value = context.__enter__()
        self.addCleanup(context.__exit__, None, None, None)
        return value

    def run(self, result=None):
        before = len(result.failures) + len(result.errors)
        method = getattr(self, self._testMethodName)

        def shot():
            try:
                method()
            except BaseException:
                if SHOTS:
                    self.editor.frame()
                    self.editor.screenshot(f"{SHOTS}/{self._testMethodName}.png")
                raise
        setattr(self, self._testMethodName, shot)
        super().run(result)
        return len(result.failures) + len(result.errors) == before


class Language(Case):
    def test_messages_while_typing(self):
        editor = self.editor
        editor.show("a.glib")
        editor.watch_problems()
        editor.line(7, "Teepot")
        editor.wait_problem("Teapot", "[Ln 7")
        editor.line(7, "Teapot")
        editor.wait_no_problem()

    def test_messages_of_a_shader(self):
        editor = self.editor
        editor.show("a.frag")
        editor.watch_problems()
        editor.line(5, "void main() { fColor = vec4(missing); }")
        editor.wait_problem("missing", "[Ln 5")
        editor.line(5, "void main() { fColor = vec4(uG, float(uCount), 0., 1.); }")
        editor.wait_no_problem()

    def test_completion(self):
        editor = self.editor
        editor.show("a.glib")
        editor.line(7, "Tea")
        editor.chord("Control", " ")
        rows = "return [...document.querySelectorAll('.suggest-widget.visible .monaco-list-row')].map(e => e.getAttribute('aria-label'))"
        until(lambda: editor.run(rows), lambda rows: any(each.startswith("Teapot") for each in rows))
        editor.press("Tab")
        until(editor.lines, lambda lines: "Teapot" in lines[6])

    def test_correction(self):
        editor = self.editor
        editor.show("a.glib")
        editor.watch_problems()
        editor.line(7, "Teepot")
        editor.wait_problem("Teapot", "[Ln 7")
        editor.chord("Control", ".")
        until(lambda: editor.run("return document.querySelector('.action-widget')?.innerText"),
              lambda text: text and "Change 'Teepot' to 'Teapot'" in text)
        editor.press("Enter")
        until(editor.lines, lambda lines: lines[6] == "Teapot")

    def test_renaming_changes_scene_and_shader(self):
        editor = self.editor
        editor.show("a.frag")
        editor.show("a.glib")
        editor.go("6:14")
        editor.press("F2")
        until(lambda: editor.run("return document.activeElement.closest('.rename-box') && document.activeElement.value"), lambda value: value == "uG")
        editor.press(*"uGlow", "Enter")
        until(editor.lines, lambda lines: "Program Show uGlow <0. .25 1.>" in lines[5])
        editor.show("a.frag")
        until(editor.lines, lambda lines: lines[1].startswith("uniform float uGlow") and "vec4(uGlow," in lines[4])

    def test_colours_and_snippets(self):
        editor = self.editor
        editor.show("a.glib")
        colours = "return new Set([...document.querySelectorAll('.view-line span span')].map(e => getComputedStyle(e).color)).size"
        until(lambda: editor.run(colours), lambda count: count >= 3)
        editor.show("a.frag")
        until(lambda: editor.run(colours), lambda count: count >= 3)
        editor.command("Snippets: Insert Snippet")
        until(lambda: editor.run(QUICK), lambda rows: any("A vertex shader with a normal" in each for each in rows))

    def test_formatting(self):
        editor = self.editor
        editor.show("a.glib")
        (self.folder / "b.glib").write_text(SCENE)
        subprocess.run([GLIBRA, "format", self.folder / "b.glib"], check=True, capture_output=True)
        formatted = (self.folder / "b.glib").read_text()
        editor.line(2, "Background   .1    .2 .3")
        editor.command("Format Document")
        editor.chord("Control", "s")
        until(lambda: (self.folder / "a.glib").read_text(), lambda text: text == formatted)


class Pictures(Case):
    def begin(self):
        self.editor.show("a.glib")
        self.editor.show_picture()
        return self.editor.wait_picture(rendered(self.folder, SCENE))

    def text_in_editor(self):
        """With what is not saved; the widgets of the server do not count."""
        return "\n".join(self.editor.lines()).rstrip() + "\n"

    def test_follows_text_and_shader(self):
        panel = self.begin()
        self.assertEqual(panel["sliders"], [["uG", "0.2500"], ["uCount", "1.000"]])
        self.assertFalse(panel["isOld"] or panel["isToKeep"])
        editor = self.editor
        editor.line(2, "Background .9 .2 .3")
        changed = SCENE.replace(" .1 ", " .9 ")
        editor.wait_picture(rendered(self.folder, changed))
        (self.folder / "a.frag").write_text(FRAGMENT.replace("0., 1.)", ".5, 1.)"))  # by another program
        editor.wait_picture(rendered(self.folder, changed))
        editor.show("a.frag")
        editor.line(5, "void main() { fColor = vec4(1.); }")
        editor.chord("Control", "s")
        until(lambda: "vec4(1.)" in (self.folder / "a.frag").read_text())
        editor.wait_picture(rendered(self.folder, changed))

    def test_sliders_are_written_into_the_scene(self):
        before = self.begin()["picture"]
        editor = self.editor
        editor.move_slider("uG", 0.75)
        value = editor.wait_panel(lambda panel: panel["sliders"][0][1] != "0.2500" and panel["picture"] != before)["sliders"][0][1]
        self.assertAlmostEqual(float(value), 0.75, delta=0.05)
        editor.wait_picture(rendered(self.folder, SCENE, f"uG={float(value)}"))
        editor.move_slider("uCount", 1)
        editor.wait_picture(rendered(self.folder, SCENE, f"uG={float(value)}", "uCount=3"))
        self.assertTrue(editor.panel()["isToKeep"])
        self.assertEqual(editor.lines()[5], "Program Show uG <0. .25 1.> uCount <0 1 3>")
        editor.press_keep()
        until(editor.lines, lambda lines: lines[5] == f"Program Show uG <0. {float(value)} 1.> uCount <0 3 3>")
        editor.wait_panel(lambda panel: not panel["isToKeep"])
        self.assertEqual((self.folder / "a.glib").read_text(), SCENE)  # to be saved or undone by hand
        editor.wait_picture(rendered(self.folder, SCENE, f"uG={float(value)}", "uCount=3"))
        editor.chord("Control", "1")
        editor.chord("Control", "z")
        editor.wait_picture(rendered(self.folder, SCENE))

    def test_whole_numbers_for_whole_variables(self):
        self.begin()
        self.editor.move_slider("uCount", 0.55)
        panel = self.editor.wait_panel(lambda panel: panel["sliders"][1][1] == "2" and "W27" not in panel["messages"])
        self.assertEqual(panel["picture"], rendered(self.folder, SCENE, "uCount=2"))

    def test_a_value_that_is_written_counts_more_than_its_slider(self):
        self.begin()
        self.editor.move_slider("uG", 0.75)
        self.editor.wait_panel(lambda panel: panel["isToKeep"])
        self.editor.line(6, "Program Show uG <0. .5 1.> uCount <0 1 3>")
        panel = self.editor.wait_picture(rendered(self.folder, SCENE.replace(".25", ".5")))
        self.assertFalse(panel["isToKeep"])
        self.assertEqual(panel["sliders"][0], ["uG", "0.5000"])

    def test_an_error_keeps_the_picture_and_is_said(self):
        picture = self.begin()["picture"]
        editor = self.editor
        editor.line(7, "Teepot")
        panel = editor.wait_panel(lambda panel: panel["isOld"])
        self.assertEqual(panel["picture"], picture)
        self.assertRegex(panel["messages"], r"a\.glib:7:1: error: .*Teapot")
        editor.line(7, "Sphere")
        panel = editor.wait_picture(rendered(self.folder, SCENE.replace("Teapot", "Sphere")))
        self.assertFalse(panel["isOld"] or "error" in panel["messages"])

    def test_closed_and_shown_again(self):
        picture = self.begin()["picture"]
        editor = self.editor
        editor.show_picture()  # is there already
        self.assertEqual(len(editor.panels()), 1)
        editor.close("Picture of a.glib")
        until(lambda: not editor.elements("iframe.webview"))
        editor.show_picture()
        editor.wait_picture(picture)
        editor.close("a.glib")  # now the text is closed, and shown again
        editor.move_slider("uCount", 1)
        editor.wait_picture(rendered(self.folder, SCENE, "uCount=3"))
        # Out of the picture, which takes the keys.
        editor.run("[...document.querySelectorAll('.explorer-folders-view .monaco-list-row')].find(e => e.innerText.trim() === 'a.glib').focus()")
        editor.show("a.glib")
        editor.go("2:1")
        editor.chord("Shift", "End")
        editor.type("Background .9 .2 .3")
        editor.wait_picture(rendered(self.folder, SCENE.replace(" .1 ", " .9 "), "uCount=3"))

    def test_several_scenes(self):
        other = SCENE.replace("Teapot", "Sphere")
        (self.folder / "b.glib").write_text(other)
        self.begin()
        editor = self.editor
        editor.chord("Control", "1")
        editor.show("b.glib")
        editor.show_picture()
        until(lambda: {each["picture"] for each in editor.panels()},
              lambda all: all == {rendered(self.folder, SCENE), rendered(self.folder, other)})
        editor.line(7, "Torus .3 1")
        other = SCENE.replace("Teapot", "Torus .3 1")
        until(lambda: {each["picture"] for each in editor.panels()},
              lambda all: all == {rendered(self.folder, SCENE), rendered(self.folder, other)})

    def test_slow_scenes_do_not_pile_up(self):
        self.begin()
        editor = self.editor
        (self.folder / "endless.frag").write_text(ENDLESS)
        editor.line(5, "Fragment endless.frag")
        at_work = lambda: subprocess.run(["pgrep", "-fxc", f"{GLIBRA.name} render - -o -"], capture_output=True, text=True).stdout.strip()
        until(at_work, lambda count: int(count) >= 1)
        most = 0
        for blue in range(1, 9):
            editor.line(2, f"Background .1 .2 .{blue}")
            most = max(most, int(at_work()))
        self.assertLessEqual(most, 2)  # the program and the process in which it draws
        editor.line(5, "Fragment a.frag")
        begin = time.time()
        editor.wait_picture(rendered(self.folder, SCENE.replace(".2 .3", ".2 .8")))
        self.assertLess(time.time() - begin, 10)
        editor.line(5, "Fragment endless.frag")
        until(at_work, lambda count: int(count) >= 1)
        editor.close("Picture of a.glib")
        until(at_work, lambda count: count == "0", 10)

    def test_is_there_after_loading_again(self):
        picture = self.begin()["picture"]
        time.sleep(2)  # the editor keeps its state now and then
        self.editor.load()
        self.editor.wait_picture(picture)


class Missing(Case):
    server_options = {"is_known": False}

    def test_says_what_to_do(self):
        editor = self.editor
        editor.show("a.glib")
        note = until(lambda: editor.run(NOTES), lambda notes: any("glibra" in each for each in notes))
        self.assertEqual(len(note), 1, note)
        self.assertRegex(note[0].replace("\n", " "), "no program 'glibra'.*Install glibra.*glibra.program")
        editor.show_picture()
        editor.wait_panel(lambda panel: "glibra.program" in panel["messages"] and not panel["isOld"])
        editor.chord("Control", "1")
        editor.watch_problems()
        editor.line(7, "Teepot")
        machine = self.server.home / "data" / "Machine"
        machine.mkdir(exist_ok=True)
        (machine / "settings.json").write_text(json.dumps({"glibra.program": str(GLIBRA)}))
        editor.wait_problem("Teapot", "[Ln 7")
        editor.line(7, "Teapot")
        editor.wait_picture(rendered(self.folder, SCENE))


class Restricted(Case):
    server_options = {"asks": True}

    def test_begins_with_trust(self):
        editor = self.editor
        editor.show("a.glib")
        editor.watch_problems()
        editor.line(7, "Teepot")
        colours = "return new Set([...document.querySelectorAll('.view-line span span')].map(e => getComputedStyle(e).color)).size"
        until(lambda: editor.run(colours), lambda count: count >= 3)
        time.sleep(5)
        self.assertFalse([each for each in editor.problems() if "[Ln" in each])
        self.assertFalse(editor.run(NOTES))
        editor.command("Workspaces: Manage Workspace Trust")
        until(lambda: editor.elements(".workspace-trust-editor .workspace-trust-buttons-row .monaco-button"))
        editor.run("""[...document.querySelectorAll('.workspace-trust-editor .monaco-button')]
            .find(e => e.innerText.trim() === 'Trust').click()""")
        editor.wait_problem("Teapot", "[Ln 7")


if __name__ == "__main__":
    GLIBRA, VSIX, NODE, CODE_SERVER = (pathlib.Path(each).resolve() for each in sys.argv[1:5])
    unittest.main(argv=[sys.argv[0], *sys.argv[5:]], verbosity=2)
