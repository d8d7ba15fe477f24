"""Tests of hardcopies with labels and free names, of new scenes, copies and files that the scene asks for."""

import os
import pathlib
import shutil
import subprocess
import sys
import unittest

from desktop import read_ppm
from scenes_test import ScenesTest
from window_case import OVALS, PROGRAM, SOURCES

ASKING = """WindowSize 200 200
Ortho -1 1 -1 1
Vertex a.vert
Fragment one.frag
Program Plain uBlue <0. .25 1.>
Obj   # which one?
"""
TRIANGLE = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n"


class KeepingTest(ScenesTest):
    """The window stands in a folder of its own, so that hardcopies go there."""

    def setUp(self):
        super().setUp()
        self.here = self.files / "here"
        self.here.mkdir()
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.here)

    def ppm_of(self, file):
        return read_ppm(subprocess.run(["convert", str(file), "-strip", "-depth", "8", "ppm:-"], check=True,
                                       stdout=subprocess.PIPE).stdout)

    def type_into(self, window, field, text):
        window.click(field)
        window.key("ctrl+a")
        window.type(text)
        window.key("Return")


class Hardcopies(KeepingTest):
    def test_a_key_writes_to_the_next_free_name(self):
        window = self.open(self.files / "one.glib", "--size", "300x1000")
        window.move(20, 20)
        for name in ("one.png", "one-2.png"):
            window.key("h")
            window.wait(lambda s: s["hardcopyMessage"].startswith(f"written: {self.here / name}: 300 x 1000"))
        self.assertEqual(sorted(each.name for each in self.here.iterdir()), ["one-2.png", "one.png"])
        window.click("hardcopy")
        window.wait(lambda s: s["hardcopyFile"] == "one-3.png" and "hardcopy/file" in s["widgets"])
        self.type_into(window, "hardcopy/file", "mine.png")
        window.click("hardcopy/write")
        window.wait(lambda s: "mine.png: 300 x 1000 pixels" in s["hardcopyMessage"])
        window.wait(lambda s: s["hardcopyFile"] == "mine-2.png")

    def test_a_file_is_replaced_only_after_a_question(self):
        (self.here / "mine.png").write_text("old")
        window = self.open(self.files / "one.glib", "--size", "300x1000")
        window.click("hardcopy")
        window.wait(lambda s: "hardcopy/file" in s["widgets"])
        self.type_into(window, "hardcopy/file", "mine.png")
        window.click("hardcopy/write")
        window.wait(lambda s: "hardcopy/replace" in s["widgets"])
        window.settle()
        window.click("hardcopy/cancel")
        window.wait(lambda s: "hardcopy/replace" not in s["widgets"])
        self.assertEqual((self.here / "mine.png").read_text(), "old")
        window.click("hardcopy/write")
        window.wait(lambda s: "hardcopy/other" in s["widgets"])
        window.settle()
        window.click("hardcopy/other")
        window.wait(lambda s: "mine-2.png: " in s["hardcopyMessage"])
        self.assertEqual((self.here / "mine.png").read_text(), "old")
        self.type_into(window, "hardcopy/file", "mine.png")
        window.click("hardcopy/write")
        window.wait(lambda s: "hardcopy/replace" in s["widgets"])
        window.settle()
        window.click("hardcopy/replace")
        window.wait(lambda s: "mine.png: " in s["hardcopyMessage"])
        self.assertEqual(self.ppm_of(self.here / "mine.png")[:2], (300, 1000))

    def test_labels_are_in_the_file_as_on_the_screen(self):
        window = self.open(OVALS, "--size", "400x700")
        window.drag_widget("uniform/OvalNoise/uAd", 0.2, 0.7)
        window.move(20, 20)
        window.key("l")
        state = window.wait(lambda s: s["labels"])
        self.assertIn("OvalNoise : uUseChromaDepth = false", state["labels"])
        value = window.knob("uAd")[0]
        self.assertIn(f"OvalNoise : uAd = {value:.4f}", state["labels"])
        self.assertShows(window, OVALS, "--labels", "bottom-left", *self.set_of(window))
        window.key("h")
        window.wait(lambda s: s["hardcopyMessage"].startswith("written: "))
        self.assertEqual(self.ppm_of(self.here / "ovalnoise.png")[2], window.pixels()[2])

    def test_labels_in_another_corner(self):
        window = self.open(self.files / "one.glib", "--size", "400x1000")
        window.click("hardcopy")
        window.settle()
        window.click("hardcopy/labels")
        window.wait(lambda s: "hardcopy/labels/top right" in s["widgets"])
        window.click("hardcopy/labels/top right")
        window.wait(lambda s: s["labels"] == ["Plain : uBlue = 0.2500"])
        window.move(20, 20)
        self.assertShows(window, self.files / "one.glib", "--labels", "top-right")

    def test_sizes_from_the_menu_and_another_folder(self):
        (self.here / "pictures").mkdir()
        window = self.open(self.files / "one.glib", "--size", "300x1000")
        window.click("hardcopy")
        window.settle()
        window.click("hardcopy/size")
        window.wait(lambda s: "hardcopy/size/1280 x 720" in s["widgets"])
        window.click("hardcopy/size/1280 x 720")
        window.click("hardcopy/folder")
        window.wait(lambda s: "dialog/entry/pictures" in s["widgets"])
        window.settle()
        window.click("dialog/entry/pictures")
        window.wait(lambda s: s["folder"] == str(self.here / "pictures"))
        window.click("dialog/open")
        window.wait(lambda s: "dialog/open" not in s["widgets"])
        window.move(20, 20)
        window.key("h")
        file = self.here / "pictures/one.png"
        window.wait(lambda s: s["hardcopyMessage"] == f"written: {file}: 1280 x 720 pixels")
        self.assertEqual(self.ppm_of(file)[:2], (1280, 720))

    def test_sizes_are_typed_as_expressions(self):
        window = self.open(self.files / "moving.glib", "--size", "300x1000", "--paused")
        window.click("hardcopy")
        window.settle()
        window.click("hardcopy/size")
        window.wait(lambda s: "hardcopy/size/other" in s["widgets"])
        window.click("hardcopy/size/other")
        window.wait(lambda s: "hardcopy/pixels" in s["widgets"])
        for part, text in ((0.2, "1920/3"), (0.8, "2*100")):
            window.settle()
            window.click("hardcopy/pixels", part)
            window.key("ctrl+a")
            window.type(text)
            window.key("Return")
        window.click("hardcopy/write")
        window.wait(lambda s: s["hardcopyMessage"] == f"written: {self.here / 'moving.png'}: 640 x 200 pixels")

    def test_a_film_is_one_file(self):
        tools = self.files / "tools"
        tools.mkdir()
        (tools / "ffmpeg").write_text('#!/bin/sh\nfor last; do :; done\nhead -c 1000000 >"${last#file:}"\ncat >/dev/null\n')
        (tools / "ffmpeg").chmod(0o755)
        window = self.open(self.files / "moving.glib", "--size", "20x1000", "--paused",
                           variables={"PATH": f"{tools}:{os.environ['PATH']}"})
        width, height, screen = window.pixels()
        window.click("hardcopy")
        window.settle()
        window.click("hardcopy/format")
        window.wait(lambda s: "hardcopy/format/mp4" in s["widgets"])
        window.click("hardcopy/format/mp4")
        window.wait(lambda s: s["hardcopyFile"] == "moving.mp4")
        self.type_into(window, "hardcopy/frames", "4")
        window.wait(lambda s: "hardcopy/rate" in s["widgets"])
        window.click("hardcopy/write")
        window.wait(lambda s: s["hardcopyMessage"].startswith(f"written: {self.here / 'moving.mp4'}: 4 frames"))
        pixels = (self.here / "moving.mp4").read_bytes()
        self.assertEqual(len(pixels), 4 * width * height * 3)
        self.assertEqual(pixels[:len(screen)], screen)
        self.assertEqual([each.name for each in self.here.iterdir()], ["moving.mp4"])

    def test_a_film_that_fails_is_said_in_the_status_line(self):
        tools = self.files / "tools"
        tools.mkdir()
        (tools / "xdotool").symlink_to(shutil.which("xdotool"))
        window = self.open(self.files / "moving.glib", "--size", "100x1000", "--paused",
                           variables={"PATH": str(tools)})
        window.click("hardcopy")
        window.settle()
        self.type_into(window, "hardcopy/frames", "3")
        window.wait(lambda s: "hardcopy/rate" in s["widgets"])  # which moves what is below
        window.click("hardcopy/write")
        state = window.wait(lambda s: s["notice"].startswith("written: ") and "hardcopy/show" in s["widgets"])
        self.assertFalse(state["noticeIsError"])
        self.assertEqual(state["hardcopyFile"], "moving-2.png")
        window.click("hardcopy/format")
        window.wait(lambda s: "hardcopy/format/mp4" in s["widgets"])
        window.click("hardcopy/format/mp4")
        # There is no film of that name, so it needs no number.
        window.wait(lambda s: s["hardcopyFile"] == "moving.mp4")
        window.settle()
        window.click("hardcopy/write")
        state = window.wait(lambda s: s["noticeIsError"])
        self.assertIn("ffmpeg", state["notice"])
        self.assertIn("moving.mp4", state["notice"])
        state = window.settle()
        left, top, width, height = state["widgets"]["notice"]
        self.assertLessEqual(top + height, state["window"][1])
        self.assertNotIn("hardcopy/show", state["widgets"])
        self.assertEqual(len(list(self.here.iterdir())), 3)


class Files(KeepingTest):
    def test_an_example_opens_a_tab_and_is_not_written_to(self):
        before = OVALS.read_bytes()
        window = self.open(OVALS, "--size", "520x900")
        window.drag_widget("uniform/OvalNoise/uAd", 0.2, 0.7)
        window.wait_knob("uAd", lambda v: v[0] > 0.2)
        window.click("scene/save")
        window.wait(lambda s: s["dialog"].startswith("Save a copy of ovalnoise"))
        window.settle()
        window.wait(lambda s: s["takesText"])
        window.key("ctrl+a")
        window.type(str(self.here / "copy/mine.glib"))
        window.key("Return")
        copy = self.here / "copy/mine.glib"
        window.wait(lambda s: s["scene"] == str(copy) and len(s["tabs"]) == 2)
        self.assertEqual(OVALS.read_bytes(), before)
        self.assertTrue((self.here / "copy/ovalnoise.frag").exists())
        window.click("tab/0", across=0.3)
        window.wait(lambda s: s["shownTab"] == 0)
        self.assertGreater(window.knob("uAd")[0], 0.2, "the values are still there")
        window.key("e")
        window.wait(lambda s: s["source"]["shown"] and "source/copy" in s["widgets"])
        window.click("source/text")
        window.type("oops")
        self.assertFalse(window.settle()["source"]["changed"])

    def test_changed_values_are_not_lost_without_a_question(self):
        window = self.open(self.files / "one.glib", "--size", "520x560")
        window.drag_widget("uniform/Plain/uBlue", 0.25, 0.8)
        window.wait_knob("uBlue", lambda v: v[0] > 0.7)

        def open_two():
            window.key("ctrl+o")
            window.wait(lambda s: "scene/path" in s["widgets"] and s["takesText"])
            window.settle()
            window.type(str(self.files / "two.glib"))
            window.key("Return")
            window.wait(lambda s: s["question"])
            window.settle()

        open_two()
        window.click("question/cancel")
        window.wait(lambda s: not s["question"])
        self.assertGreater(window.knob("uBlue")[0], 0.7)
        open_two()
        window.click("question/newTab")
        window.wait(lambda s: [t["label"] for t in s["tabs"]] == ["one", "two"])
        window.key("ctrl+w")
        window.wait(lambda s: [t["label"] for t in s["tabs"]] == ["one"])
        open_two()
        window.click("question/save")
        window.wait(lambda s: s["scene"].endswith("two.glib"))
        self.assertNotIn("<0. .25 1.>", (self.files / "one.glib").read_text())

    def test_closing_asks_about_changed_values_and_quitting_keeps_them(self):
        settings = self.files / "settings"
        settings.mkdir()
        window = self.open(self.files / "one.glib", "--size", "520x560", settings=settings)
        window.drag_widget("uniform/Plain/uBlue", 0.25, 0.8)
        window.wait_knob("uBlue", lambda v: v[0] > 0.7)
        window.move(20, 20)
        window.key("ctrl+w")
        window.wait(lambda s: s["question"])
        window.settle()
        window.click("question/cancel")
        window.wait(lambda s: not s["question"])
        value = window.knob("uBlue")[0]
        self.assertGreater(value, 0.7)
        window.xdotool("key", "ctrl+q")
        self.assertEqual(window.process.wait(), 0)
        self.assertIn("<0. .25 1.>", (self.files / "one.glib").read_text())
        window = self.open(None, settings=settings)
        window.wait(lambda s: s["scene"].endswith("one.glib") and s["knobs"][0]["current"] == [value])
        window.key("ctrl+w")
        window.wait(lambda s: s["question"])
        window.settle()
        window.click("question/save")
        window.wait(lambda s: not s["question"])
        self.assertRegex((self.files / "one.glib").read_text(), r"<0\. 0\.[0-9]+ 1\.>")

    def test_a_copy_that_is_refused_keeps_the_dialog_open(self):
        (self.here / "glaze.frag").write_text("// mine\n")
        window = self.open(self.files / "one.glib", "--size", "520x560")
        window.click("file")
        window.wait(lambda s: "file/new" in s["widgets"])
        window.settle()
        window.click("file/new")
        window.wait(lambda s: "file/new/teapot" in s["widgets"])
        window.settle()
        window.click("file/new/teapot")
        window.wait(lambda s: s["dialog"].startswith("A new scene") and s["takesText"])
        window.settle()
        window.key("ctrl+a")
        window.type(str(self.here / "mine"))
        window.key("Return")
        state = window.wait(lambda s: "dialog/problem" in s["widgets"])
        self.assertTrue(state["dialog"].startswith("A new scene"))
        self.assertEqual([each.name for each in self.here.iterdir()], ["glaze.frag"])
        window.settle()
        window.click("scene/path", 0.5)
        window.key("ctrl+a")
        window.type(str(self.here / "other/mine"))
        window.wait(lambda s: "dialog/problem" not in s["widgets"])
        window.key("Return")
        window.wait(lambda s: s["scene"] == str(self.here / "other/mine.glib"))

    def test_a_click_opens_a_menu_in_the_menu_that_keys_have_opened(self):
        window = self.open(self.files / "one.glib", "--size", "900x700")
        window.key("e")
        window.wait(lambda s: "source/text" in s["widgets"])
        for _ in range(3):
            window.settle()
            window.click("source/text")
            window.wait(lambda s: s["source"]["active"])
            window.move(5, 5)
            window.key("F10")
            window.wait(lambda s: "file/new" in s["widgets"])
            window.settle()
            window.click("file/new")
            window.wait(lambda s: "file/new/empty" in s["widgets"])
            window.key("Escape", "Escape")
            window.wait(lambda s: "file/new/empty" not in s["widgets"] and "file/new" not in s["widgets"])

    def test_a_new_scene_from_a_template(self):
        window = self.open(self.files / "one.glib", "--size", "520x560")
        window.click("file")
        window.wait(lambda s: "file/new" in s["widgets"])
        window.click("file/new")
        window.wait(lambda s: "file/new/pass" in s["widgets"])
        window.click("file/new/pass")
        window.wait(lambda s: s["dialog"].startswith("A new scene") and s["takesText"])
        window.settle()
        window.key("ctrl+a")
        window.type(str(self.here / "mine"))
        window.key("Return")
        window.wait(lambda s: s["scene"] == str(self.here / "mine.glib") and len(s["tabs"]) == 2)
        self.assertEqual((self.here / "mine.glib").read_bytes(), (SOURCES / "glib/start/pass.glib").read_bytes())
        self.assertFalse([m for m in window.settle()["messages"] if m["severity"] == "error"])
        # It is the user's own now.
        window.move(20, 300)
        window.key("e")
        window.wait(lambda s: s["source"]["shown"] and "source/copy" not in s["widgets"])

    def test_save_as_asks_before_it_replaces(self):
        window = self.open(self.files / "one.glib", "--size", "520x560")
        before = (self.files / "two.glib").read_text()
        window.key("ctrl+shift+s")
        window.wait(lambda s: s["dialog"] == "Save as: one.glib" and s["takesText"])
        window.settle()
        window.key("ctrl+a")
        window.type("two.glib")
        window.key("Return")
        window.settle()
        self.assertEqual((self.files / "two.glib").read_text(), before)
        window.click("dialog/open")
        window.wait(lambda s: s["scene"].endswith("two.glib"))
        self.assertEqual((self.files / "two.glib").read_text(), (self.files / "one.glib").read_text())

    def test_a_model_without_a_name_is_asked_for(self):
        scene = self.files / "asking.glib"
        scene.write_text(ASKING)
        (self.files / "model.obj").write_text(TRIANGLE)
        window = self.open(scene, "--size", "300x560")
        window.wait(lambda s: s["dialog"] == "A file for Obj in line 6" and "dialog/entry/model.obj" in s["widgets"])
        window.settle()
        self.assertNotIn("dialog/entry/one.frag", window.state()["widgets"])
        window.click("dialog/entry/model.obj")
        window.click("dialog/open")
        window.wait(lambda s: not any(m["severity"] == "error" for m in s["messages"]))
        self.assertEqual(scene.read_text(), ASKING)
        window.click("scene/save")
        window.wait(lambda s: "saved the values" in s["notice"])
        self.assertEqual(scene.read_text(), ASKING.replace("Obj   #", 'Obj "model.obj"   #'))
        window.move(20, 20)  # away from the tooltip of the button
        self.assertShows(window, scene)

    def test_a_message_box_pops_up(self):
        scene = self.files / "telling.glib"
        scene.write_text("MessageBox Move the scene back\n" + (self.files / "one.glib").read_text())
        window = self.open(scene, "--size", "300x560")
        window.wait(lambda s: s["messageBox"] == ["Move the scene back"] and "messageBox/ok" in s["widgets"])
        window.settle()
        window.click("messageBox/ok")
        window.wait(lambda s: not s["messageBox"])
        window.key("F5")
        window.wait(lambda s: s["reloads"] >= 1)
        self.assertFalse(window.settle()["messageBox"], "the same text is not shown twice")

    def test_verbose_lists_what_the_scene_does(self):
        window = self.open(self.files / "one.glib", "--size", "520x560")
        window.click("file")
        window.wait(lambda s: "file/verbose" in s["widgets"])
        window.click("file/verbose")
        state = window.wait(lambda s: any(m["id"] == "glib-N02" for m in s["messages"]) and "verbose/text" in s["widgets"])
        self.assertTrue([m for m in state["messages"] if "QuadXY" in m["text"]])


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
