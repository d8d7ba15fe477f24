"""Tests of editing sources, opening scenes, tabs and suite shots."""

import pathlib
import subprocess
import sys
import time
import unittest

from desktop import read_ppm
from window_case import MOVING_FRAGMENT, PROGRAM, VERTEX, WindowTest

SCENE = """WindowSize 300 300
Ortho -1 1 -1 1
Vertex a.vert
Fragment {0}.frag
Program Plain uBlue <0. .25 1.>
QuadXY 0. .7
"""
SHADER = """#version 330
uniform float uBlue; out vec4 c;
void main() {
    c = vec4(1., 0., uBlue, 1.);
}
"""
OLD_SHADER = """uniform float uBlue;
void main() {
    gl_FragColor = vec4(1., 0., uBlue, 1.);
}
"""
IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]


class ScenesTest(WindowTest):
    def setUp(self):
        super().setUp()
        for name, shader in (("one", SHADER), ("two", SHADER.replace("vec4(1.", "vec4(0.")), ("old", OLD_SHADER)):
            (self.files / f"{name}.glib").write_text(SCENE.format(name))
            (self.files / f"{name}.frag").write_text(shader)

    def pixel(self, window, x, y):
        """Red, green, blue of one pixel of the window's content."""
        ppm = subprocess.run(["import", "-window", window.id, "-crop", f"1x1+{round(x)}+{round(y)}", "+repage", "-depth",
                              "8", "ppm:-"], env=window.environment, check=True, stdout=subprocess.PIPE).stdout
        return tuple(read_ppm(ppm)[2])

    def edit(self, window, line):
        """Opens the source panel with the cursor at the end of that line: of the fragment shader if the panel was closed."""
        state = window.state()
        if not state["source"]["shown"]:
            window.move(20, 20)
            window.key("e")
            window.wait(lambda s: "source/text" in s["widgets"])
            window.settle()
            shader = f"source/file/{pathlib.Path(state['scene']).stem}.frag"
            if shader in window.state()["widgets"]:
                window.click(shader)
                window.wait(lambda s: s["source"]["file"].endswith(".frag"))
        window.wait(lambda s: "source/text" in s["widgets"])
        window.settle()
        window.move(*window.point("source/text", 0.5, 0.4))
        window.press()
        window.release()
        window.wait(lambda s: s["source"]["active"])
        window.key("ctrl+Home", *["Down"] * (line - 1), "End")
        window.wait(lambda s: s["source"]["line"] == line and s["source"]["column"] > 1)


class Source(ScenesTest):
    def test_an_edit_changes_the_file_and_the_picture_when_it_is_saved(self):
        window = self.open(self.files / "one.glib", "--size", "520x560")
        self.edit(window, 4)
        self.assertEqual(pathlib.Path(window.state()["source"]["file"]).name, "one.frag")
        window.key("Return")
        window.type("c.g = .6;")
        window.wait(lambda s: s["source"]["changed"] and s["source"]["line"] == 5)
        self.assertEqual((self.files / "one.frag").read_text(), SHADER, "nothing is written before it is saved")
        self.assertTrue(window.state()["tabs"][0]["unsaved"])
        window.key("ctrl+s")
        window.wait(lambda s: s["reloads"] >= 1 and not s["source"]["changed"])
        self.assertEqual((self.files / "one.frag").read_text(), SHADER.replace("1.);\n", "1.);\n    c.g = .6;\n"),
                         "the new line is indented like the one before")
        self.assertShows(window, self.files / "one.glib")
        left, top, width, height = window.state()["picture"]
        self.assertEqual(self.pixel(window, left + width / 2, top + height / 2), (255, 153, 64))

    def test_an_open_editor_draws_nothing_while_nobody_types(self):
        window = self.open(self.files / "one.glib", "--size", "520x560")
        self.edit(window, 4)
        before = window.settle()
        time.sleep(1.5)
        after = window.state()
        self.assertTrue(after["source"]["active"])
        self.assertEqual(after["framesPresented"], before["framesPresented"])

    def test_the_scene_can_be_edited_too(self):
        window = self.open(self.files / "one.glib", "--size", "520x560")
        self.edit(window, 4)
        window.click("source/file/one.glib")
        window.wait(lambda s: s["source"]["file"].endswith("one.glib"))
        self.edit(window, 5)
        window.key(*["BackSpace"] * 3)
        window.type("2.> uFree 3")
        window.key("ctrl+s")
        window.wait(lambda s: s["knobs"] and s["knobs"][0]["maximum"] == 2)
        self.assertIn("<0. .25 2.> uFree 3\n", (self.files / "one.glib").read_text())

    def test_an_error_is_marked_at_its_line_with_the_translated_line(self):
        window = self.open(self.files / "old.glib", "--size", "520x560")
        self.edit(window, 3)
        good = window.pixels()[2]
        window.type(" oops;")
        window.key("ctrl+s")
        broken = window.wait(lambda s: any(m["severity"] == "error" for m in s["messages"]) and
                             "source/message/0" in s["widgets"])
        self.assertEqual([m["line"] for m in broken["messages"] if m["severity"] == "error"][0], 3)
        self.assertEqual(window.settle()["source"]["translation"], "", "only on demand")
        window.click("source/message/0/core", 0.05)
        window.wait(lambda s: s["source"]["translation"])
        window.settle()
        state = window.state()
        self.assertIn("oops", state["source"]["translation"])
        self.assertNotIn("gl_FragColor", state["source"]["translation"])
        left, top, _, _ = state["widgets"]["source/text"]
        row = 14
        marked = self.pixel(window, left + 2, top + 2.5 * row)
        plain = self.pixel(window, left + 2, top + 4.5 * row)
        self.assertGreater(marked[0] - plain[0], 30, f"{marked} beside {plain}")
        half = len(good) // 2  # the upper half, where no message stands
        self.assertEqual(window.pixels()[2][:half], good[:half], "the last good picture stays")
        self.edit(window, 1)
        window.click("source/message/0")
        window.wait(lambda s: s["source"]["line"] == 3 and s["source"]["active"])
        window.key("End", *["BackSpace"] * 6)
        window.key("ctrl+s")
        window.wait(lambda s: not any(m["severity"] == "error" for m in s["messages"]))
        self.assertEqual((self.files / "old.frag").read_text(), OLD_SHADER)
        self.assertShows(window, self.files / "old.glib")

    def test_a_message_shows_its_line(self):
        (self.files / "old.frag").write_text(OLD_SHADER.replace("uBlue, 1.", "uBleu, 1."))
        window = self.open(self.files / "old.glib", "--size", "520x700")
        window.click("message/0/show")
        shown = window.wait(lambda s: s["source"]["shown"] and s["source"]["line"] == 3 and s["source"]["active"])
        self.assertTrue(shown["source"]["file"].endswith("old.frag"))

    def test_a_conflict_with_another_program_is_reported(self):
        shader = self.files / "one.frag"
        window = self.open(self.files / "one.glib", "--size", "520x560")
        self.edit(window, 4)
        window.type(" // mine")
        window.wait(lambda s: s["source"]["changed"])
        theirs = SHADER.replace("vec4(1.", "vec4(.5")
        shader.write_text(theirs)
        window.wait(lambda s: s["source"]["conflict"])
        window.key("ctrl+s")
        window.wait(lambda s: "was not saved" in s["notice"])
        self.assertEqual(shader.read_text(), theirs)
        window.click("source/keepMine")
        window.wait(lambda s: not s["source"]["conflict"])
        window.key("ctrl+s")
        window.wait(lambda s: not s["source"]["changed"])
        self.assertEqual(shader.read_text(), SHADER.replace("1.);", "1.); // mine"))

        self.edit(window, 4)
        window.type(" again")
        shader.write_text(theirs)
        window.wait(lambda s: s["source"]["conflict"])
        window.click("source/takeDisk")
        window.wait(lambda s: not s["source"]["conflict"] and not s["source"]["changed"])
        self.assertEqual(shader.read_text(), theirs)
        self.assertShows(window, self.files / "one.glib")

    def test_nothing_typed_is_lost_without_a_question(self):
        window = self.open(self.files / "one.glib", "--size", "520x560")
        self.edit(window, 4)
        window.type(" // mine")
        window.key("Escape", "ctrl+q")
        window.wait(lambda s: s["question"])
        window.click("question/cancel")
        window.wait(lambda s: not s["question"] and s["source"]["changed"])
        window.xdotool("key", "ctrl+q")
        window.wait(lambda s: s["question"])
        window.move(*window.point("question/save"))
        window.press()
        window.xdotool("mouseup", "1")
        self.assertEqual(window.process.wait(), 0)
        self.assertEqual((self.files / "one.frag").read_text(), SHADER.replace("1.);", "1.); // mine"))


class Scenes(ScenesTest):
    def test_the_dialog_opens_scenes(self):
        folder = self.files / "deeper"
        folder.mkdir()
        (folder / "three.glib").write_text("WindowSize 200 200\nSphere 1\n")
        window = self.open(self.files / "one.glib", "--size", "520x560")
        window.click("scene/open")
        window.wait(lambda s: "dialog/entry/two.glib" in s["widgets"])
        window.settle()
        self.assertNotIn("dialog/entry/one.frag", window.state()["widgets"])
        window.click("dialog/entry/two.glib")
        window.click("dialog/open")
        window.wait(lambda s: s["scene"].endswith("two.glib"))
        window.move(20, 20)  # away from widgets with tooltips
        self.assertShows(window, self.files / "two.glib")
        window.key("ctrl+o")
        window.wait(lambda s: "dialog/entry/deeper" in s["widgets"])
        window.settle()
        window.click("dialog/entry/deeper")
        window.wait(lambda s: "dialog/entry/three.glib" in s["widgets"])
        window.settle()
        self.assertEqual(window.state()["folder"], str(folder))
        # If frames are slow, the two clicks may be too far apart for a double click. A single click only selects.
        for _ in range(10):
            window.double_click("dialog/entry/three.glib")
            window.settle()
            if window.state()["scene"].endswith("three.glib"):
                break
        window.wait(lambda s: s["scene"].endswith("three.glib"))
        window.key("ctrl+o")
        window.wait(lambda s: "dialog/recent/2" in s["widgets"])
        window.settle()
        window.click("dialog/recent/2")
        window.wait(lambda s: s["scene"].endswith("one.glib"))
        window.key("ctrl+o")
        window.wait(lambda s: "scene/path" in s["widgets"] and s["takesText"])
        window.type("deeper")
        window.key("Return")
        window.wait(lambda s: s["folder"] == str(folder))
        window.settle()
        window.wait(lambda s: s["takesText"])
        window.type("../two.glib")
        window.key("Return")
        window.wait(lambda s: pathlib.Path(s["scene"]).name == "two.glib")

    def library(self):
        root = self.files / "library"
        for folder in ("glib/start", "glib/more", "shaders"):
            (root / folder).mkdir(parents=True)
        (root / "glib/start/red.glib").write_text("# SH001 Red: all of it.\n" + SCENE.format("red"))
        (root / "glib/more/black.glib").write_text(SCENE.format("black"))
        (root / "shaders/a.vert").write_text(VERTEX)
        (root / "shaders/red.frag").write_text(SHADER)
        (root / "shaders/black.frag").write_text(SHADER.replace("vec4(1., 0., uBlue", "vec4(0., 0., 0."))
        (root / "glib/more/wrong.glib").write_text("Vertex none.vert\nFragment none.frag\nProgram P\nSphere 1\n")
        return root

    def test_the_examples_are_shown_with_pictures_and_a_click_opens_one(self):
        window = self.open(None, variables={"GLIBRA_PATH": str(self.library())})
        shown = window.wait(lambda s: s["examples"]["pictures"] == 2 and not s["examples"]["drawing"])
        self.assertTrue(shown["examples"]["open"], "without a scene the window begins with the examples")
        self.assertEqual(shown["examples"]["scenes"], 3)
        window.settle()
        self.assertEqual(self.pixel(window, *window.point("example/start/red")), (255, 0, 64))
        self.assertEqual(self.pixel(window, *window.point("example/more/black")), (0, 0, 0))
        kept = sorted(window.folder.rglob("*.png"))
        self.assertEqual(len(kept), 2)
        window.click("example/start/red")
        window.wait(lambda s: s["scene"].endswith("red.glib") and not s["examples"]["open"])
        times = [each.stat().st_mtime_ns for each in kept]
        window.move(20, 20)
        window.key("x")
        window.wait(lambda s: s["examples"]["pictures"] == 2)
        self.assertFalse(window.state()["examples"]["drawing"], "the pictures are cached")
        self.assertEqual([each.stat().st_mtime_ns for each in kept], times)
        window.click("examples/search")
        window.wait(lambda s: s["takesText"])
        window.type("blac")
        window.wait(lambda s: "example/start/red" not in s["widgets"] and "example/more/black" in s["widgets"] and
                    s["examples"]["found"] == 1)
        window.key("Return")
        window.wait(lambda s: [t["label"] for t in s["tabs"]] == ["red", "black"] and not s["examples"]["open"])
        window.key("x")
        window.wait(lambda s: "examples/search" in s["widgets"] and s["takesText"])
        window.xdotool("keydown", "ctrl")
        window.click("example/more/black")
        window.xdotool("keyup", "ctrl")
        state = window.settle()
        self.assertTrue(state["examples"]["open"], "Ctrl+click keeps the list open")
        self.assertEqual([t["label"] for t in state["tabs"]], ["red", "black"], "it is open already")


class Tabs(ScenesTest):
    def open_two(self):
        window = self.open(self.files / "one.glib", "--size", "520x560")
        window.key("ctrl+t")
        window.wait(lambda s: "scene/path" in s["widgets"] and s["takesText"])
        window.type("two.glib")
        window.key("Return")
        window.wait(lambda s: [t["label"] for t in s["tabs"]] == ["one", "two"] and s["shownTab"] == 1)
        window.settle()
        return window

    def test_each_keeps_its_own_values_and_view(self):
        window = self.open_two()
        window.drag_widget("uniform/Plain/uBlue", 0.25, 0.8)
        window.wait_knob("uBlue", lambda v: 0.7 < v[0])
        two = window.settle()  # not one of the steps of the drag
        window.key("a")
        window.wait(lambda s: s["axes"])
        window.click("tab/0", across=0.3)
        one = window.wait(lambda s: s["shownTab"] == 0)
        window.move(20, 300)
        self.assertEqual((one["knobs"][0]["current"], one["axes"]), ([0.25], False))
        self.assertShows(window, self.files / "one.glib")
        left, top, width, height = window.state()["picture"]
        window.drag((left + width / 2, top + height / 2), (left + width / 2 + 60, top + height / 2))
        window.wait(lambda s: s["view"]["eye"] != IDENTITY)
        window.key("ctrl+Next")
        again = window.wait(lambda s: s["shownTab"] == 1)
        self.assertEqual(again["knobs"][0]["current"], two["knobs"][0]["current"])
        self.assertEqual((again["view"]["eye"], again["axes"]), (IDENTITY, True))
        window.key("ctrl+w")
        window.wait(lambda s: s["question"] and "question/discard" in s["widgets"])
        window.settle()
        window.click("question/discard")
        last = window.wait(lambda s: [t["label"] for t in s["tabs"]] == ["one"])
        self.assertNotEqual(last["view"]["eye"], IDENTITY)

    def test_a_hidden_tab_pauses_and_reloads_when_it_is_shown(self):
        (self.files / "two.frag").write_text(MOVING_FRAGMENT.replace("uR", "uBlue"))
        window = self.open_two()
        window.wait(lambda s: s["moving"] and s["framesDrawn"] > 3)
        window.key("ctrl+Prior")
        window.wait(lambda s: s["shownTab"] == 0)
        window.move(30, 300)
        before = window.settle()
        time.sleep(1.5)
        after = window.state()
        self.assertEqual(after["framesPresented"], before["framesPresented"])
        (self.files / "two.frag").write_text(SHADER)
        time.sleep(0.3)
        self.assertEqual(window.state()["reloads"], before["reloads"])
        window.key("ctrl+Next")
        window.wait(lambda s: s["shownTab"] == 1 and s["reloads"] > before["reloads"])
        self.assertShows(window, self.files / "two.glib")

    def test_closing_a_tab_with_unsaved_text_asks(self):
        window = self.open_two()
        self.edit(window, 4)
        window.type(" // mine")
        window.wait(lambda s: s["tabs"][1]["unsaved"])
        window.key("ctrl+w")
        window.wait(lambda s: s["question"])
        window.click("question/discard")
        window.wait(lambda s: [t["label"] for t in s["tabs"]] == ["one"])
        self.assertNotIn("mine", (self.files / "two.frag").read_text())

    def test_several_scenes_on_the_command_line(self):
        window = self.open(self.files / "one.glib", str(self.files / "two.glib"))
        window.wait(lambda s: [t["label"] for t in s["tabs"]] == ["one", "two"] and s["shownTab"] == 0)


class Suites(ScenesTest):
    def test_the_state_becomes_a_shot_that_glibra_test_holds(self):
        scene = self.files / "one.glib"
        # The samples of the screen are no part of a shot.
        window = self.open(scene, "--size", "320x820", "--samples", "1")
        window.drag_widget("uniform/Plain/uBlue", 0.25, 0.8)
        window.wait_knob("uBlue", lambda v: v[0] > 0.7)
        window.drag((160, 410), (220, 380))
        window.wait(lambda s: s["view"]["eye"] != IDENTITY)
        window.click("suite")
        window.click("suite/add")
        window.wait(lambda s: "to pictures.toml" in s["suiteMessage"])
        suite = self.files / "pictures.toml"
        window.move(20, 20)
        width, height, screen = window.pixels()
        self.assertEqual(subprocess.run([PROGRAM, "test", str(suite)], cwd=suite.parent, stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL).returncode, 1, "there is no golden yet")
        for arguments in (["--update"], []):
            done = subprocess.run([PROGRAM, "test", str(suite), *arguments], cwd=suite.parent, text=True, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT)
            self.assertEqual(done.returncode, 0, done.stdout)
        golden = self.files / "golden/pictures/one.png"
        ppm = subprocess.run(["convert", str(golden), "-depth", "8", "ppm:-"], check=True, stdout=subprocess.PIPE).stdout
        self.assertEqual(read_ppm(ppm)[:2], (width, height))
        self.assertEqual(ppm[-3 * width * height:], screen)
        window.click("suite/add")
        window.wait(lambda s: "'one-2'" in s["suiteMessage"])
        self.assertEqual(suite.read_text().count("[[shot]]"), 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
