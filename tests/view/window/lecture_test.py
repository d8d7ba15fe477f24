"""Tests of a lecture: the source over or beside a large picture, labels of chosen values, legends, shared sliders; of the
offers of an empty window; and of the window on screens from 800 x 600 to 3840 x 2160."""

import json
import os
import shutil
import subprocess
import sys
import unittest

from desktop import Desktop, read_ppm
from scenes_test import SCENE, SHADER, ScenesTest
from window_case import OVALS, PROGRAM

FOUR = "WindowSize 400 300\nOrtho -1 1 -1 1\nVertex a.vert\nFragment shared.frag\n" + "".join(
    f"Program P{i} uKd <0. .5 1.> uTint {{1. .6 .2}} uOwn{i} <0. .{i} 1.>\nQuadXY 0. .{i + 1}\n" for i in range(1, 5))
SHARED = """#version 330
uniform float uKd, uOwn1, uOwn2, uOwn3, uOwn4; uniform vec3 uTint; out vec4 c;
void main() { c = vec4(uKd * uTint + vec3(uOwn1, uOwn2, uOwn3) * uOwn4, 1.); }
"""
LONG = "uAVeryLongNameOfAUniformThatIsTheAmplitude"


class LectureTest(ScenesTest):
    def setUp(self):
        super().setUp()
        (self.files / "four.glib").write_text(FOUR)
        (self.files / "shared.frag").write_text(SHARED)

    def open_on(self, desktop, *arguments, **options):
        own, type(self).desktop = self.desktop, desktop
        try:
            return self.open(*arguments, **options)
        finally:
            type(self).desktop = own


class Lecture(LectureTest):
    def columns(self, window, left, right):
        """The pixels between two columns, below a notice."""
        ppm = subprocess.run(["import", "-window", window.id, "-crop", f"{round(right - left)}x1000+{round(left)}+80", "+repage",
                              "-depth", "8", "ppm:-"], env=window.environment, check=True, stdout=subprocess.PIPE).stdout
        return read_ppm(ppm)[2]

    def test_the_picture_keeps_its_size_when_texts_grow(self):
        window = self.open(self.files / "four.glib")
        window.resize(1366, 768)
        window.wait(lambda s: s["window"] == [1366, 768] and s["room"][3] == 768)
        window.move(20, 20)
        window.key("e")
        before = window.wait(lambda s: s["source"]["shown"] and s["room"][3] < 768 and s["waiting"])
        before = window.settle()
        window.key(*["ctrl+equal"] * 4)
        window.wait(lambda s: abs(s["scale"] - 1.4641) < 1e-3)
        after = window.settle()
        # The panel is larger then, but the source leaves the picture its part of the room: 340 x 255 it was.
        self.assertGreater(after["picture"][2] * after["picture"][3], 1.6 * 340 * 255)
        self.assertAlmostEqual(after["room"][3], before["room"][3], delta=2)

    def test_shift_f11_is_a_lecture_and_ends_as_it_was(self):
        # The picture is white, and as large as the screen, so that it is behind the text.
        (self.files / "white.glib").write_text(FOUR.replace("400 300", "1400 1100").replace("Ortho", "Background 1 1 1\nOrtho"))
        window = self.open(self.files / "white.glib")
        window.resize(776, 600)
        before = window.wait(lambda s: s["window"] == [776, 600])
        window.move(760, 590)
        window.key("shift+F11")
        notice = window.wait(lambda s: s["window"] == [1400, 1100] and s["source"]["shown"] and abs(s["scale"] - 1.4) < 1e-3 and
                             "notice/overlay" in s["widgets"])["widgets"]["notice/overlay"]
        state = window.settle()
        self.assertEqual(state["room"], [0, 0, 1400, 1100], "the source stands over the picture")
        self.assertEqual(state["sourcePlace"], "over the picture")
        self.assertIn("Lecture", state["notice"])
        left, top, width, height = state["widgets"]["source"]
        self.assertAlmostEqual(width, 700, delta=2)
        # The picture is seen behind the text, which stays legible.
        self.assertEqual(state["picture"], [0, 0, 1400, 1100])
        left, top, width, height = state["widgets"]["source/text"]
        behind = self.pixel(window, left + width * .5, top + height * .9)
        self.assertGreater(min(behind), 40, behind)
        self.assertLess(max(behind), 90, behind)
        # What stands on the picture stands where the source does not cover it: the notice, the legend, labels.
        edge = state["widgets"]["source"][2]
        self.assertGreater(notice[0], edge)
        plain = self.columns(window, edge, 1400)
        window.move(1390, 1090)
        window.key("l")
        window.wait(lambda s: s["labels"])
        window.settle()
        self.assertTrue(self.columns(window, edge, 1400) != plain, "the labels are seen")
        window.key("l")
        window.settle()
        window.key("ctrl+e")
        window.wait(lambda s: not s["source"]["shown"])
        window.key("shift+F11")
        state = window.wait(lambda s: s["window"] == before["window"] and s["scale"] == 1)
        self.assertFalse(state["source"]["shown"])

    def test_the_source_stands_where_it_is_wanted(self):
        window = self.open(self.files / "four.glib")
        window.resize(1300, 700)
        window.wait(lambda s: s["window"] == [1300, 700])
        window.move(20, 20)
        window.key("e")
        window.wait(lambda s: s["source"]["shown"])
        rooms = {}
        for _ in range(4):
            window.key("ctrl+shift+e")
            state = window.settle()
            rooms[state["sourcePlace"]] = state["room"]
        self.assertGreater(rooms["beside the picture"][0], 300)
        self.assertLess(rooms["below the picture"][3], 500)
        self.assertEqual(rooms["over the picture"][:2], [0, 0])
        self.assertEqual(rooms["over the picture"][3], 700)
        window.click("source/place")
        window.wait(lambda s: "source/place/beside the picture" in s["widgets"])
        window.settle()
        window.click("source/place/beside the picture")
        window.wait(lambda s: s["sourcePlace"] == "beside the picture")
        edge = window.settle()["room"][0]
        window.drag((edge - 1, 400), (edge - 150, 400))
        window.wait(lambda s: abs(s["room"][0] - edge + 150) < 12)

    def test_labels_of_changed_and_of_chosen_values(self):
        here = self.files / "here"
        here.mkdir()
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(here)
        window = self.open(self.files / "four.glib", "--size", "400x900")
        window.move(20, 20)
        window.key("l")
        self.assertEqual(len(window.wait(lambda s: s["labels"])["labels"]), 12)
        window.click("uniforms/labelChoice")
        window.wait(lambda s: "uniforms/labelChoice/changed" in s["widgets"])
        window.settle()
        window.click("uniforms/labelChoice/changed")
        window.wait(lambda s: s["labels"] == [])
        window.drag_widget("uniform/P2/uOwn2", 0.2, 0.7)
        state = window.wait(lambda s: len(s["labels"]) == 1 and s["waiting"])
        value = next(k["current"][0] for k in state["knobs"] if k["tag"] == "uOwn2")
        self.assertEqual(window.settle()["labels"], [f"P2 : uOwn2 = {window.knob('uOwn2')[0]:.4f}"], value)
        # A hardcopy has the same pixels.
        window.move(20, 20)
        window.key("h")
        window.wait(lambda s: s["hardcopyMessage"].startswith("written: "))
        picture = subprocess.run(["convert", str(here / "four.png"), "-strip", "-depth", "8", "ppm:-"], check=True,
                                 stdout=subprocess.PIPE).stdout
        self.assertEqual(read_ppm(picture)[2], window.pixels()[2])
        window.move(*window.point("label/P3/uOwn3"))
        window.xdotool("click", "3")
        window.click("menu/label")
        window.wait(lambda s: s["labels"] == ["P3 : uOwn3 = 0.3000"])

    def test_the_view_has_its_legend_on_the_picture(self):
        window = self.open(self.files / "four.glib", "--size", "400x600")
        window.move(20, 20)
        window.key("ctrl+b")
        self.assertEqual(window.settle()["legend"], "")
        seen = []
        for _ in range(6):
            window.key("v")
            seen.append(window.wait(lambda s: s["legend"] and s["legend"].split()[0] not in [x.split()[0] for x in seen])
                        ["legend"])
        self.assertIn("overdraw 1 2 3 4 5 6 7 8+ most: 4", seen)
        self.assertIn("layers 1 2 3 4 5 6 7 8+ most: 4", seen)
        self.assertTrue(any(each.startswith("facing front back") for each in seen), seen)

    def test_one_slider_moves_what_four_programs_share(self):
        window = self.open(self.files / "four.glib", "--size", "400x900")
        state = window.settle()
        self.assertIn("uniform/shared/uKd", state["widgets"])
        self.assertNotIn("uniform/P1/uKd", state["widgets"], "below a fold")
        window.drag_widget("uniform/shared/uKd", 0.5, 0.9)
        window.wait(lambda s: all(k["current"][0] > .8 for k in s["knobs"] if k["tag"] == "uKd"))
        self.assertEqual(len({k["current"][0] for k in window.settle()["knobs"] if k["tag"] == "uKd"}), 1)
        window.click("shared/P2")
        window.wait(lambda s: "uniform/P2/uKd" in s["widgets"])
        window.settle()
        window.drag_widget("uniform/P2/uKd", 0.9, 0.2)
        window.wait(lambda s: [k["current"][0] < .4 for k in s["knobs"] if k["tag"] == "uKd"] == [False, True, False, False])
        window.click("reset/shared/uKd")
        window.wait(lambda s: all(k["current"] == [.5] for k in s["knobs"] if k["tag"] == "uKd"))

    def test_a_gif_is_written_without_ffmpeg(self):
        here = self.files / "here"
        here.mkdir()
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(here)
        tools = self.files / "tools"
        tools.mkdir()
        (tools / "xdotool").symlink_to(shutil.which("xdotool"))
        window = self.open(self.files / "moving.glib", "--size", "60x900", "--paused", variables={"PATH": str(tools)})
        window.click("hardcopy")
        window.settle()
        window.click("hardcopy/format")
        window.wait(lambda s: "hardcopy/format/gif" in s["widgets"])
        window.click("hardcopy/format/gif")
        window.wait(lambda s: s["hardcopyFile"] == "moving.gif")
        window.click("hardcopy/frames")
        window.key("ctrl+a")
        window.type("4")
        window.key("Return")
        window.settle()
        window.click("hardcopy/write")
        window.wait(lambda s: s["hardcopyMessage"].startswith(f"written: {here / 'moving.gif'}: 4 frames"))
        frames = subprocess.run(["identify", str(here / "moving.gif")], check=True, text=True, stdout=subprocess.PIPE).stdout
        self.assertEqual(len(frames.splitlines()), 4, frames)
        self.assertIn("60x900", frames)


class Lists(LectureTest):
    def test_many_values_are_filtered_and_long_names_keep_both_ends(self):
        count = 200
        names = [f"uValue{i}" for i in range(count)] + [LONG]
        program = "Program Many " + " ".join(f"{name} <0. .5 1.>" for name in names)
        (self.files / "many.glib").write_text(SCENE.format("many").replace("Program Plain uBlue <0. .25 1.>", program))
        (self.files / "many.frag").write_text("#version 330\nuniform float " + ", ".join(names) + "; out vec4 c;\nvoid main() { c = vec4(" +
                                              " + ".join(names) + "); }\n")
        window = self.open(self.files / "many.glib", "--size", "400x600")
        window.click("uniforms/filter")
        window.wait(lambda s: s["takesText"])
        window.type("e17")
        shown = lambda s: {k.split("/")[2] for k in s["widgets"] if k.startswith("label/Many/")}
        window.wait(lambda s: shown(s) == {"uValue17"} | {f"uValue17{i}" for i in range(10)})
        window.key("ctrl+a")
        window.type("amplitude")
        state = window.wait(lambda s: shown(s) == {LONG})
        state = window.settle()
        left, _, width, _ = state["widgets"][f"label/Many/{LONG}"]
        self.assertLessEqual(left + width, state["widgets"][f"uniform/Many/{LONG}"][0] + 1)
        window.move(*window.point(f"label/Many/{LONG}"))
        window.wait(lambda s: LONG in s["source"]["hover"])

    def test_an_empty_window_offers_new_open_recent_scenes_and_examples(self):
        settings = self.files / "settings"
        (settings / "glibra").mkdir(parents=True)
        for folder in ("first", "second"):
            (self.files / folder).mkdir()
            (self.files / folder / "planet.glib").write_text("Sphere 1\n")
        (settings / "glibra/view.json").write_text(json.dumps(
            {"recent": [str(self.files / f / "planet.glib") for f in ("first", "second")]}))
        window = self.open(None, settings=settings)
        window.wait(lambda s: "welcome/new" in s["widgets"])
        state = window.settle()
        for name in ("welcome/new", "welcome/open", "welcome/examples", "welcome/recent/0", "welcome/recent/1"):
            self.assertIn(name, state["widgets"])
        window.key("ctrl+o")
        state = window.wait(lambda s: "dialog/recent/folder/1" in s["widgets"])
        window.key("Escape")
        window.wait(lambda s: "dialog/recent/folder/1" not in s["widgets"])
        window.settle()
        window.click("welcome/recent/1")
        window.wait(lambda s: s["scene"].endswith("second/planet.glib"))
        window.key("ctrl+t")
        window.wait(lambda s: "scene/path" in s["widgets"] and s["takesText"])
        window.type(str(self.files / "first/planet.glib"))
        window.key("Return")
        window.wait(lambda s: [t["label"] for t in s["tabs"]] == ["second/planet", "first/planet"])

    def test_a_recent_scene_whose_file_is_gone_says_so_and_can_be_removed(self):
        settings = self.files / "settings"
        (settings / "glibra").mkdir(parents=True)
        (self.files / "here.glib").write_text("Sphere 1\n")
        recent = ["/nowhere/gone.glib", str(self.files / "here.glib"), "/nowhere/lost.glib"]
        (settings / "glibra/view.json").write_text(json.dumps({"recent": recent}))
        window = self.open(None, settings=settings)
        window.wait(lambda s: "welcome/recent/1" in s["widgets"])
        state = window.settle()
        self.assertNotIn("welcome/recent/0", state["widgets"], "it cannot be chosen")
        self.assertIn("welcome/recent/gone/0", state["widgets"])
        window.click("welcome/recent/remove/0")
        window.wait(lambda s: "welcome/recent/0" in s["widgets"] and "welcome/recent/remove/1" in s["widgets"])
        window.key("ctrl+o")
        window.wait(lambda s: "dialog/recent/remove/1" in s["widgets"])
        window.settle()
        window.click("dialog/recent/remove/1")
        window.wait(lambda s: "dialog/recent/gone/1" not in s["widgets"])
        window.settle()
        window.click("dialog/recent/0")
        window.wait(lambda s: s["scene"].endswith("here.glib"))
        window.key("ctrl+q")
        window.process.wait(20)
        self.assertEqual(json.loads((settings / "glibra/view.json").read_text())["recent"],
                         [str(self.files / "here.glib")])

    def test_a_message_has_one_line_and_more_on_demand(self):
        (self.files / "one.frag").write_text(SHADER.replace("uBlue, 1.", "uBleu + " + "oops + " * 30 + "uGone, 1."))
        window = self.open(self.files / "one.glib", "--size", "640x900")
        window.click("banner", 0.3)
        window.wait(lambda s: "source/message/2" in s["widgets"])
        window.settle()
        heights = lambda: [window.state()["widgets"][f"source/message/{i}"][3] for i in range(3)]
        window.click("source/message/1", 0.1)
        window.wait(lambda s: s["source"]["active"])
        window.settle()
        first, second, third = heights()
        self.assertEqual(first, third)
        window.click("source/message/0", 0.1)
        window.settle()
        self.assertEqual(heights()[1], heights()[2])

    def test_textures_stand_below_the_tabs(self):
        window = self.open(self.files / "one.glib", str(self.files / "two.glib"), "--size", "700x700")
        window.move(20, 300)
        window.key("i")
        window.wait(lambda s: "inspector/what" in s["widgets"])
        state = window.settle()
        tab = state["widgets"]["tab/1"]
        self.assertGreaterEqual(state["widgets"]["inspector/what"][1], tab[1] + tab[3])


class Screens(LectureTest):
    """On each screen and in both themes everything of the panel is inside, whatever is open."""

    def check(self, width, height, dpi, light):
        desktop = Desktop(width, height, dpi=dpi)
        self.addCleanup(desktop.close)
        settings = self.files / f"settings-{width}-{light}"
        (settings / "glibra").mkdir(parents=True)
        (settings / "glibra/view.json").write_text(json.dumps(
            {"lightTheme": light, "folds": {"transforms": True, "shown": True, "toolWindows": True, "time": True}}))
        window = self.open_on(desktop, self.files / "kinds.glib", settings=settings)
        state = window.settle()
        self.assertLessEqual(state["window"][0], width)
        self.assertLessEqual(state["window"][1], height)
        self.assertEqual(state["lightTheme"], light)
        self.assertGreaterEqual(state["window"][1], min(560 * dpi / 96, height - 60), "the panel of a small scene has room")
        panel = state["room"][0] + state["room"][2]
        for name, (left, top, across, down) in state["widgets"].items():
            if left >= panel:
                self.assertLessEqual(left + across, state["window"][0] + .5, name)
        x, y = window.position()
        self.assertLessEqual(y + state["window"][1], height)
        self.assertGreaterEqual(min(x, y), 0)
        # The four numbers of a colour have room for their digits.
        window.point("uniform/Kinds/uRgba")
        window.move(5, 5)
        window.key("e")
        window.wait(lambda s: s["source"]["shown"])
        state = window.settle()
        self.assertGreater(min(state["picture"][2:]), 100)
        window.close()

    def test_800_by_600(self):
        for light in (False, True):
            self.check(800, 600, 96, light)

    def test_1366_by_768(self):
        for light in (False, True):
            self.check(1366, 768, 96, light)

    def test_1920_by_1080(self):
        for light in (False, True):
            self.check(1920, 1080, 96, light)

    def test_3840_by_2160_at_192_dots_per_inch(self):
        for light in (False, True):
            self.check(3840, 2160, 192, light)

    def test_a_tall_scene_fits_the_screen(self):
        desktop = Desktop(1366, 768)
        self.addCleanup(desktop.close)
        (self.files / "tall.glib").write_text(SCENE.format("one").replace("WindowSize 300 300", "WindowSize 600 2000"))
        window = self.open_on(desktop, self.files / "tall.glib")
        state = window.settle()
        _, y = window.position()
        self.assertLessEqual(y + state["window"][1], 768)
        self.assertGreaterEqual(y, 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
