"""Tests of dropped files; of find, replace and undo in the source panel; of the user's own editor."""

import subprocess
import sys
import time
import unittest

from scenes_test import SCENE, SHADER, ScenesTest
from window_case import VERTEX

TEXTURED = """WindowSize 300 300
Ortho -1 1 -1 1
Texture2D 5 wood.ppm
Vertex st.vert
Fragment wood.frag
Program Wood uT 5
QuadXY 0. 1.
"""


class Dropping(ScenesTest):
    def test_a_scene_opens_a_tab_and_is_not_opened_twice(self):
        window = self.open(self.files / "one.glib", "--size", "520x560")
        window.drop(self.files / "two.glib")
        window.wait(lambda s: [t["label"] for t in s["tabs"]] == ["one", "two"] and s["shownTab"] == 1)
        window.move(260, 300)  # away from the tab, which has a tooltip
        self.assertShows(window, self.files / "two.glib")
        window.drop(self.files / "one.glib")
        window.wait(lambda s: s["shownTab"] == 0 and len(s["tabs"]) == 2)
        window.drop(self.files / "one.glib")
        window.wait(lambda s: s["notice"] == "one.glib is already open" and len(s["tabs"]) == 2)

    def test_a_window_without_a_scene_shows_the_dropped_one_in_its_only_tab(self):
        # A library without examples, so that no pictures of examples are drawn during the test.
        for folder in ("glib", "shaders"):
            (self.files / "library" / folder).mkdir(parents=True)
        window = self.open(None, variables={"GLIBRA_PATH": str(self.files / "library")})
        window.drop(self.files / "one.glib")
        window.wait(lambda s: [t["label"] for t in s["tabs"]] == ["one"] and s["scene"].endswith("one.glib"))

    def test_several_files_of_strange_names(self):
        odd = self.files / "b ü #1%.glib"
        odd.write_text(SCENE.format("two"))
        window = self.open(self.files / "one.glib", "--size", "520x560")
        window.drop(self.files / "two.glib", odd, self.files / "gone.glib", self.files / "a.vert")
        state = window.wait(lambda s: len(s["tabs"]) == 3)
        self.assertEqual([t["path"] for t in state["tabs"][1:]], [str(self.files / "two.glib"), str(odd)])
        window.wait(lambda s: "gone.glib: no such file" in s["notice"])
        window.wait(lambda s: s["source"]["shown"] and s["source"]["file"].endswith("a.vert"))

    def test_a_file_of_a_scene_is_shown_where_it_is_used(self):
        (self.files / "wood.glib").write_text(TEXTURED)
        (self.files / "wood.ppm").write_text("P3 2 1 255 200 100 50 10 20 30\n")
        (self.files / "st.vert").write_text(VERTEX.replace("void", "out vec4 vST; void").replace(
            "{ ", "{ vST = aTexCoord0; "))
        (self.files / "wood.frag").write_text("#version 330\nuniform sampler2D uT; in vec4 vST; out vec4 c;\n"
                                              "void main() { c = texture(uT, vST.st); }\n")
        window = self.open(self.files / "wood.glib", str(self.files / "one.glib"), "--size", "620x560")
        window.drop(self.files / "wood.frag")
        window.wait(lambda s: s["source"]["shown"] and s["source"]["file"].endswith("wood.frag") and
                    s["source"]["line"] == 1)
        window.drop(self.files / "wood.ppm")
        window.wait(lambda s: "inspector/image" in s["widgets"])
        left, top, _, _ = window.state()["widgets"]["inspector/image"]
        window.move(left + 0.3, top + 0.3)
        window.wait(lambda s: s["inspected"].startswith("0, 0: 0.784314 0.392157 0.196078"))
        # A file of the other tab's scene switches to that tab.
        window.drop(self.files / "one.frag")
        window.wait(lambda s: s["shownTab"] == 1 and s["source"]["file"].endswith("one.frag"))

    def test_other_files_are_refused_with_a_message(self):
        note = self.files / "notes.txt"
        note.write_text("notes")
        window = self.open(self.files / "one.glib", "--size", "520x560")
        window.drop(note)
        state = window.wait(lambda s: "notes.txt is neither a scene" in s["notice"])
        self.assertEqual([t["label"] for t in state["tabs"]], ["one"])
        window.drop(self.files / "gone.png")
        state = window.wait(lambda s: "no such file" in s["notice"])
        self.assertEqual([t["label"] for t in state["tabs"]], ["one"])
        window.drop("https://example.org/a.glib")
        state = window.wait(lambda s: "no such file" in s["notice"] and "gone" not in s["notice"])
        self.assertEqual([t["label"] for t in state["tabs"]], ["one"])
        self.assertShows(window, self.files / "one.glib")

    def test_a_folder_shows_its_scenes(self):
        folder = self.files / "deeper"
        folder.mkdir()
        (folder / "three.glib").write_text("WindowSize 200 200\nSphere 1\n")
        window = self.open(self.files / "one.glib", "--size", "520x560")
        window.drop(folder)
        window.wait(lambda s: s["folder"] == str(folder) and "dialog/entry/three.glib" in s["widgets"])


class Finding(ScenesTest):
    def setUp(self):
        super().setUp()
        self.text = SHADER + "// uBlue twice: UBLUE, uBluer\n" + "//\n" * 60 + "// uBlue at the end\n"
        (self.files / "one.frag").write_text(self.text)

    def found(self, window, shown, count):
        return window.wait(lambda s: s.get("find", {}).get("count") == count and s["find"]["shown"] == shown)

    def test_steps_through_the_places_and_selects_one(self):
        window = self.open(self.files / "one.glib", "--size", "620x660")
        self.edit(window, 1)
        window.key("ctrl+Home", "ctrl+f")
        window.wait(lambda s: "find" in s and s["takesText"])
        window.settle()
        window.type("uBlue")
        self.found(window, 0, 6)
        window.key("Return")
        self.found(window, 1, 6)
        window.key("Return")
        self.found(window, 2, 6)
        window.key("shift+Return")
        self.found(window, 1, 6)
        window.key("F3")
        self.found(window, 2, 6)
        window.click("source/find/case")
        window.wait(lambda s: s["find"]["count"] == 5)
        window.click("source/find/whole")
        self.found(window, 2, 4)
        window.key("F3")
        self.found(window, 3, 4)
        # Closing the bar selects the match, so typed text replaces it.
        window.key("Escape")
        window.wait(lambda s: "find" not in s and s["source"]["active"] and s["source"]["line"] == 67)
        window.settle()
        window.type("x")
        window.key("ctrl+s")
        window.wait(lambda s: not s["source"]["changed"] and "saved" in s["notice"])
        self.assertEqual((self.files / "one.frag").read_text(), self.text.replace("uBlue at", "x at"))

    def test_replaces_one_and_all_and_undo_brings_them_back(self):
        window = self.open(self.files / "one.glib", "--size", "620x660")
        self.edit(window, 1)
        window.key("ctrl+Home", "ctrl+h")
        window.wait(lambda s: "find" in s and s["takesText"] and "source/find/by" in s["widgets"])
        window.settle()
        window.type("uBlue")
        window.click("source/find/whole")
        window.click("source/find/case")
        self.found(window, 0, 4)
        window.click("source/find/by")
        window.settle()
        window.type("uB")
        window.click("source/find/replace")
        window.wait(lambda s: s["find"]["count"] == 3 and s["source"]["changed"])
        window.click("source/find/all")
        window.wait(lambda s: s["find"]["count"] == 0 and "replaced 3 matches" in s["notice"])
        window.key("ctrl+s")
        window.wait(lambda s: not s["source"]["changed"])
        new = self.text.replace("uBluer", "@").replace("uBlue", "uB").replace("@", "uBluer")
        self.assertEqual((self.files / "one.frag").read_text(), new)
        window.key("Escape")
        window.wait(lambda s: s["source"]["active"])
        window.settle()
        window.key("ctrl+z")
        window.wait(lambda s: s["source"]["changed"])
        window.key("ctrl+z")
        window.settle()
        window.key("ctrl+s")
        window.wait(lambda s: not s["source"]["changed"])
        self.assertEqual((self.files / "one.frag").read_text(), self.text)
        window.key("ctrl+y", "ctrl+shift+z", "ctrl+s")
        window.settle()
        self.assertEqual((self.files / "one.frag").read_text(), new)

    def test_undo_in_the_text_goes_by_words_and_leaves_the_values_alone(self):
        window = self.open(self.files / "one.glib", "--size", "520x560")
        window.drag_widget("uniform/Plain/uBlue", 0.25, 0.8)
        window.wait_knob("uBlue", lambda v: v[0] > 0.7)
        value = window.settle()["knobs"][0]["current"]  # not one of the steps of the drag
        self.edit(window, 4)
        window.type(" // one two")
        window.key("ctrl+z", "ctrl+s")
        window.wait(lambda s: "saved" in s["notice"] and not s["source"]["changed"])
        self.assertIn("1.); // one \n", (self.files / "one.frag").read_text())
        window.key("ctrl+z", "ctrl+z", "ctrl+z", "ctrl+z", "ctrl+z", "ctrl+s")
        window.settle()
        self.assertEqual((self.files / "one.frag").read_text(), self.text)
        self.assertEqual(window.knob("uBlue"), value)

    def test_goes_to_a_line(self):
        window = self.open(self.files / "one.glib", "--size", "520x560")
        self.edit(window, 2)
        window.key("ctrl+g")
        window.wait(lambda s: "source/line" in s["widgets"])
        window.settle()
        window.type("60")
        window.key("Return")
        window.wait(lambda s: s["source"]["line"] == 60 and s["source"]["active"])
        window.key("ctrl+g")
        window.wait(lambda s: "source/line" in s["widgets"])
        window.settle()
        window.type("99999")
        window.key("Return")
        window.wait(lambda s: s["source"]["line"] == self.text.count("\n") + 1)


class Editor(ScenesTest):
    def test_opens_the_file_at_its_line_and_leaves_no_process(self):
        arguments = self.files / "arguments"
        editor = self.files / "editor"
        editor.write_text(f"#!/bin/sh\nprintf '%s ' \"$@\" >{arguments}.part\nmv {arguments}.part {arguments}\n")
        editor.chmod(0o755)
        (self.files / "one.frag").write_text(SHADER.replace("uBlue, 1.", "uBleu, 1."))
        window = self.open(self.files / "one.glib", "--size", "520x900",
                           variables={"EDITOR": str(editor), "VISUAL": ""})
        for _ in range(3):
            arguments.unlink(missing_ok=True)
            window.click("message/0/edit")
            while not arguments.exists():
                self.assertIsNone(window.process.poll())
                time.sleep(0.02)
            self.assertEqual(arguments.read_text().split(), ["+4", str(self.files / "one.frag")])
        children = subprocess.run(["ps", "--ppid", str(window.process.pid), "-o", "stat="], text=True,
                                  stdout=subprocess.PIPE).stdout.split()
        self.assertEqual(children, [])

    def test_a_missing_editor_is_reported(self):
        (self.files / "one.frag").write_text(SHADER.replace("uBlue, 1.", "uBleu, 1."))
        window = self.open(self.files / "one.glib", "--size", "520x900",
                           variables={"EDITOR": "no-such-editor", "VISUAL": ""})
        window.click("message/0/edit")
        window.wait(lambda s: s["notice"] == "cannot start 'no-such-editor': No such file or directory")


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
