"""A student does the tutorial in the window alone: a new, empty scene, shaders that messages create, texts that are typed, values
that are moved, and a hardcopy. Nothing is written by other means. TUTORIAL_STEPS=1-13 does all steps, which takes minutes."""

import os
import pathlib
import re
import sys
import time
import unittest
import unittest.mock

from scenes_test import ScenesTest
from window_case import SOURCES

EXAMPLES = SOURCES / "docs/examples/tutorial"
FIRST, LAST = (int(each) for each in os.environ.get("TUTORIAL_STEPS", "1-5").split("-"))


class Tutorial(ScenesTest):
    def fill(self, window, text):
        """Replaces the shown text by typing, as the editor indents lines by itself."""
        left, top, width, height = window.wait(lambda s: "source/text" in s["widgets"])["widgets"]["source/text"]
        window.settle()
        window.move(left + width * .6, top + height * .5)
        window.press()
        window.release()
        window.wait(lambda s: s["source"]["active"])
        window.key("ctrl+a", "Delete")
        indented = 0  # blanks that the editor has set
        for number, line in enumerate(text.rstrip("\n").split("\n")):
            if number:
                window.xdotool("key", "Return")
            wanted = len(line) - len(line.lstrip(" "))
            if line and line.startswith(" " * wanted + "}") and indented == wanted + 4:
                wanted = indented
            if line.strip():
                for _ in range(indented - wanted):
                    window.xdotool("key", "BackSpace")
                typed = " " * max(0, wanted - indented) + line.lstrip(" ")
                window.xdotool("type", "--delay", "7", "--", typed)
                indented = len(line) - len(line.lstrip(" ")) + (4 if line.rstrip().endswith("{") else 0)
        window.xdotool("key", "Return")
        window.settle()

    @staticmethod
    def rest(window):
        """Waits until a new menu, dialog or button has found its place, also while a scene moves, which never settles."""
        window.settle()
        if window.state()["moving"]:
            time.sleep(.5)

    def save(self, window):
        seen = window.state()["reloads"]
        window.key("ctrl+s")
        # Scenes that move never settle, so it waits for the messages of the new text.
        window.wait(lambda s: not s["source"]["changed"] and s["reloads"] > seen)
        return window.settle()

    @staticmethod
    def same(a, b):
        """Blanks at the ends of lines aside."""
        strip = lambda text: [line.rstrip() for line in text.rstrip().split("\n")]
        return strip(a) == strip(b)

    def step(self, window, folder, number):
        name = "planet" if number <= 10 else {11: "moons", 12: "glow", 13: "dust"}[number]
        scene = folder / f"{name}.glib"
        if not scene.exists():
            window.key("F10")
            window.wait(lambda s: "file/new" in s["widgets"])
            self.rest(window)
            window.click("file/new")
            window.wait(lambda s: "file/new/empty" in s["widgets"])
            self.rest(window)
            window.click("file/new/empty")
            state = window.wait(lambda s: s["dialog"].startswith("A new, empty scene") and s["takesText"])
            self.assertTrue(pathlib.Path(state["folder"]).is_dir(), "that of the last scene is gone")
            self.rest(window)
            window.key("ctrl+a")
            window.type(str(scene))
            window.key("Return")
            state = window.wait(lambda s: s["scene"] == str(scene) and s["source"]["shown"])
            self.assertEqual(state["source"]["file"], str(scene), "the source opens on the scene")
        window.click(f"source/file/{scene.name}")
        window.wait(lambda s: s["source"]["file"] == str(scene))
        text = (EXAMPLES / f"step{number:02}.glib").read_text()
        self.fill(window, text)
        state = self.save(window)
        self.assertTrue(self.same(scene.read_text(), text), scene.read_text())
        while missing := [m for m in state["messages"] if m["id"] == "file-E01"]:
            shader = re.search(r"'([^']+)'", missing[0]["text"])[1]
            window.wait(lambda s: any("/fix/0" in k for k in s["widgets"]))
            self.rest(window)
            state = window.state()
            window.click(next(k for k in state["widgets"] if "/fix/0" in k))
            window.wait(lambda s: s["source"]["file"].endswith(shader) and (folder / shader).exists())
            window.settle()
            text = (EXAMPLES / shader).read_text()
            self.fill(window, text)
            state = self.save(window)
            self.assertTrue(self.same((folder / shader).read_text(), text), (folder / shader).read_text())
        errors = [m for m in state["messages"] if m["severity"] != "note"]
        self.assertEqual(errors, [], f"step {number}")
        window.move(5, 5)
        if not state["moving"]:
            self.assertShows(window, scene)

    def test_the_tutorial_in_the_window_alone(self):
        folder = self.files / "mine"
        folder.mkdir()
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(folder)
        # The files of the library, for the window and for the pictures to compare with.
        library = unittest.mock.patch.dict(os.environ, {"GLIBRA_PATH": str(SOURCES)})
        library.start()
        self.addCleanup(library.stop)
        settings = self.files / "settings"
        (settings / "glibra").mkdir(parents=True)
        (settings / "glibra/view.json").write_text('{"recent": ["/nowhere/x.glib"]}')
        window = self.open(None, settings=settings, variables={"GLIBRA_PATH": str(SOURCES)})
        window.resize(1366, 760)
        window.wait(lambda s: s["window"] == [1366, 760] and "welcome/new" in s["widgets"])
        for number in [each for each in range(FIRST, LAST + 1) if each != 10]:
            self.step(window, folder, number)
            print("step", number, flush=True)
        if LAST >= 5:
            window.drag_widget("uniform/Shiny/uAmbient" if LAST == 5 else next(
                k for k in window.state()["widgets"] if k.startswith("uniform/")), .15, .6)
            window.wait(lambda s: any(k["current"] != k["initial"] for k in s["knobs"]))
        window.move(5, 5)
        window.key("Escape", "F6")
        window.wait(lambda s: not s["source"]["active"])
        window.key("h")
        window.wait(lambda s: s["notice"].startswith("written: "))
        self.assertTrue(list(folder.glob("*.png")))


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
