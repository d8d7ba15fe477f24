"""Tests of the window on screens of many sizes and densities, of the picture's shape and samples, and of the sections."""

import json
import os
import subprocess
import sys
import unittest

from desktop import Desktop
from window_case import OVALS, PROGRAM, WindowTest

PERSPECTIVE = """WindowSize 400 300
Perspective 50
LookAt 0 0 4 0 0 0 0 1 0
Color 1 .5 0
Box 1.6 1.6 1.6
"""


class LayoutTest(WindowTest):
    def assertInside(self, state, names=None):
        """Every widget of the panel that is on the screen lies between its left and its right edge."""
        width, height = state["window"]
        panel = state["room"][0] + state["room"][2]
        found = 0
        for name, (left, top, across, down) in state["widgets"].items():
            if left < panel - 1 or (names and not name.startswith(names)):
                continue
            found += 1
            self.assertGreaterEqual(left, panel, name)
            self.assertLessEqual(left + across, width + 0.5, name)
        self.assertGreater(found, 5)


class Sizes(LayoutTest):
    def test_no_button_is_cut_off_at_any_width(self):
        window = self.open(OVALS)
        for width, height in ((800, 600), (1366, 768), (520, 400), (360, 700), (1380, 1000)):
            window.resize(width, height)
            window.wait(lambda s: s["window"] == [width, height] and s["room"][3] == height and s["waiting"])
            state = window.settle()
            self.assertInside(state)
            self.assertGreaterEqual(state["room"][2], 0.29 * width)

    def test_the_buttons_at_the_top_stand_in_one_row(self):
        window = self.open(OVALS)
        for width in (1380, 800, 520, 400):
            window.resize(width, 600)
            state = window.wait(lambda s: s["window"] == [width, 600] and s["room"][3] == 600 and s["waiting"])
            rows = {state["widgets"][name][1] for name in
                    ("file", "scene/open", "scene/examples", "scene/source", "scene/reload", "help")}
            self.assertEqual(len(rows), 1, f"{width}: {rows}")

    def test_the_status_line_moves_nothing(self):
        folder = self.files / "here"
        folder.mkdir()
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(folder)
        window = self.open(OVALS)
        for height in (1000, 600):
            window.resize(1000, height)
            window.wait(lambda s: s["window"] == [1000, height] and s["room"][3] == height)
            window.move(20, 20)
            before = window.settle()["widgets"]
            if height == 600:
                window.move(900, 300)
                window.xdotool("click", "--repeat", "20", "5")
                window.settle()
                window.move(20, 20)
                before = window.settle()["widgets"]
            written = len(list(folder.iterdir()))
            window.key("h")
            window.wait(lambda s: s["notice"].startswith("written: ") and len(list(folder.iterdir())) > written)
            after = window.settle()["widgets"]
            same = [name for name in before if name in after and name != "notice"]
            self.assertGreater(len(same), 8)
            for name in same:
                self.assertEqual(before[name], after[name], name)

    def test_the_panel_scrolls_to_its_last_button(self):
        window = self.open(OVALS)
        window.resize(800, 400)
        window.wait(lambda s: s["window"] == [800, 400])
        window.move(600, 300)
        window.xdotool("click", "--repeat", "40", "5")
        window.wait(lambda s: "cost" in s["widgets"])
        window.settle()
        window.click("cost")
        window.xdotool("click", "--repeat", "40", "5")
        window.wait(lambda s: "cost/measure" in s["widgets"])
        window.settle()
        left, top, width, height = window.state()["widgets"]["cost/measure"]
        self.assertLessEqual(top + height, 400)

    def test_tool_windows_stay_inside_and_in_front(self):
        window = self.open(OVALS)
        window.resize(1200, 800)
        window.wait(lambda s: s["window"] == [1200, 800])
        window.key("n")
        left, top, width, height = window.wait(lambda s: "noise/graph" in s["widgets"])["widgets"]["noise/graph"]
        window.drag((left + 100, top - 20), (1190, 780))
        window.settle()
        for size in ((800, 600), (500, 400)):
            window.resize(*size)
            window.wait(lambda s: s["window"] == list(size))
            graph = window.settle()["widgets"]["noise/graph"]
            self.assertGreaterEqual(graph[0], 0)
            self.assertGreaterEqual(graph[1], 0)
            self.assertLessEqual(graph[0] + graph[2], size[0])
        # A click on the panel does not bring the panel in front of the tool window.
        window.resize(1200, 800)
        window.wait(lambda s: s["window"] == [1200, 800])
        window.settle()
        graph = window.state()["widgets"]["noise/graph"]
        window.drag((graph[0] + 100, graph[1] - 20), (1190, graph[1] - 20))
        state = window.settle()
        graph = state["widgets"]["noise/graph"]
        self.assertGreater(graph[0] + graph[2], state["room"][2], "it lies over the panel")
        window.move(1000, 790)
        window.press()
        window.release()
        window.settle()
        x, y = graph[0] + graph[2] - 5, graph[1] + graph[3] - 5
        ppm = subprocess.run(["import", "-window", window.id, "-crop", f"1x1+{round(x)}+{round(y)}", "+repage", "-depth",
                              "8", "txt:-"], env=window.environment, check=True, text=True, stdout=subprocess.PIPE).stdout
        self.assertIn("#FAFAFA", ppm, "the paper of the graph")

    def test_texts_grow_and_shrink(self):
        settings = self.files / "settings"
        window = self.open(OVALS, settings=settings)
        window.resize(1000, 700)
        before = window.wait(lambda s: s["window"] == [1000, 700] and s["waiting"])
        window.key("ctrl+equal", "ctrl+equal", "ctrl+equal")
        larger = window.wait(lambda s: abs(s["scale"] - 1.331) < 1e-3)
        window.settle()
        larger = window.state()
        one, other = (s["widgets"]["uniforms/reset"][3] for s in (before, larger))
        self.assertAlmostEqual(other / one, 1.331, delta=0.1)
        self.assertInside(larger)
        window.key("ctrl+q")
        window.process.wait()
        again = self.open(OVALS, settings=settings)
        again.wait(lambda s: abs(s["scale"] - 1.331) < 1e-3)
        again.key("ctrl+0")
        again.wait(lambda s: s["scale"] == 1)


class Density(LayoutTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.dense = Desktop(2560, 1600, dpi=192)

    @classmethod
    def tearDownClass(cls):
        cls.dense.close()
        super().tearDownClass()

    def open_on(self, desktop, *arguments, **options):
        own, type(self).desktop = self.desktop, desktop
        try:
            return self.open(*arguments, **options)
        finally:
            type(self).desktop = own

    def test_twice_the_dots_make_everything_twice_as_large(self):
        plain = self.open(OVALS)
        dense = self.open_on(self.dense, OVALS)
        one, two = plain.settle(), dense.settle()
        self.assertEqual((one["scale"], two["scale"]), (1, 2))
        self.assertEqual(two["window"], [2 * v for v in one["window"]])
        for name in ("uniforms/reset", "scene/open", "uniform/OvalNoise/uAd"):
            for a, b in zip(one["widgets"][name][2:], two["widgets"][name][2:]):
                self.assertAlmostEqual(b / a, 2, delta=0.1, msg=name)
        self.assertInside(two)

    def test_remembered_sizes_are_right_on_both_screens(self):
        settings = self.files / "settings"
        dense = self.open_on(self.dense, OVALS, settings=settings)
        dense.resize(2000, 1400)
        dense.wait(lambda s: s["window"] == [2000, 1400])
        dense.key("n")
        graph = dense.wait(lambda s: "noise/graph" in s["widgets"])["widgets"]["noise/graph"]
        dense.settle()
        dense.key("n", "ctrl+q")
        self.assertEqual(dense.process.wait(), 0)
        self.assertEqual(json.loads((settings / "glibra/view.json").read_text())["windowWidth"], 1000)
        plain = self.open(OVALS, settings=settings)
        plain.wait(lambda s: s["window"] == [1000, 700])
        plain.key("n")
        half = plain.wait(lambda s: "noise/graph" in s["widgets"])["widgets"]["noise/graph"]
        for a, b in zip(graph[:3], half[:3]):
            self.assertAlmostEqual(a / 2, b, delta=6)


class Shapes(LayoutTest):
    def test_the_picture_keeps_the_scenes_shape_beside_the_editor(self):
        scene = self.files / "box.glib"
        scene.write_text(PERSPECTIVE)
        window = self.open(scene)
        first = window.settle()
        self.assertEqual((first["width"], first["height"]), (400, 300))
        for width, height in ((1300, 500), (800, 900)):
            window.resize(width, height)
            state = window.wait(lambda s: s["window"] == [width, height] and s["room"][3] == height)
            self.assertAlmostEqual(state["width"] / state["height"], 4 / 3, delta=0.01)
            self.assertShows(window, scene)
        window.key("e")
        state = window.wait(lambda s: s["source"]["shown"] and s["room"][3] < 700)
        self.assertAlmostEqual(state["width"] / state["height"], 4 / 3, delta=0.02)
        room, picture = state["room"], state["picture"]
        for axis in (0, 1):
            self.assertGreaterEqual(picture[axis], room[axis])
            self.assertLessEqual(picture[axis] + picture[axis + 2], room[axis] + room[axis + 2])
            # In the middle.
            self.assertAlmostEqual(picture[axis] - room[axis],
                                   room[axis] + room[axis + 2] - picture[axis] - picture[axis + 2], delta=1.5)

    def columns(self, window):
        """The columns of the picture in which the box is seen."""
        width, height, rgb = window.pixels()
        row = rgb[3 * width * (height // 2):3 * width * (height // 2 + 1)]
        background = row[:3]
        return width, [x for x in range(width) if row[3 * x:3 * x + 3] != background]

    def test_a_picture_that_fills_the_room_crops_nothing(self):
        scene = self.files / "box.glib"
        scene.write_text(PERSPECTIVE)
        window = self.open(scene)
        window.resize(520, 800)
        window.wait(lambda s: s["window"] == [520, 800])
        window.settle()
        window.click("view/shape")
        window.click("view/shape/fill")
        state = window.wait(lambda s: s["picture"] == s["room"] and s["waiting"])
        self.assertGreater(state["height"], 3 * state["width"])
        width, box = self.columns(window)
        self.assertGreater(box[0], 0)
        self.assertLess(box[-1], width - 1)
        # As large as in a picture of the scene's shape and that width.
        self.assertAlmostEqual(len(box) / width, 0.8 / 3.2 / 0.4663 / (4 / 3), delta=0.08)


class Smoothness(LayoutTest):
    def test_edges_are_smooth_by_default_and_the_view_says_how(self):
        window = self.open(OVALS, "--size", "320x860", "--samples", "4")
        self.assertEqual(window.settle()["samples"], 4)
        self.assertShows(window, OVALS, "--samples", "4")
        window.click("view/samples")
        window.settle()
        window.click("view/samples/1")
        window.wait(lambda s: s["samples"] == 1)
        self.assertShows(window, OVALS)

    def test_without_the_option_it_is_four(self):
        from desktop import Window
        window = Window(self.desktop, PROGRAM, OVALS, "--size", "320x860")
        self.addCleanup(window.close)
        self.assertEqual(window.settle()["samples"], 4)
        window.click("view/samples")
        window.settle()
        window.click("view/samples/2")
        window.wait(lambda s: "view/samples/2" not in s["widgets"] and s["waiting"])
        window.key("ctrl+q")
        window.process.wait()
        kept = json.loads((window.folder / "glibra/view.json").read_text())
        self.assertEqual(kept["samples"], 2)

    def test_the_picture_is_smooth_again_after_an_edit(self):
        window = self.open(self.files / "kinds.glib", "--size", "320x860", "--samples", "4")
        window.move(20, 20)  # away from what has a tooltip
        window.settle()
        shader = self.files / "a.frag"
        shader.write_text(shader.read_text().replace("out vec4 c;", "out vec4 c; // edited"))
        window.wait(lambda s: s["reloads"] == 1 and s["editToPictureMilliseconds"] > 0)
        self.assertEqual(window.settle()["samples"], 4)
        self.assertShows(window, self.files / "kinds.glib", "--samples", "4")

    def test_wrong_numbers_are_refused(self):
        # The options are read before the display is opened.
        done = subprocess.run([PROGRAM, "view", "--samples", "-2", str(OVALS)], text=True, stderr=subprocess.PIPE,
                              env={**os.environ, "DISPLAY": ":none"})
        self.assertEqual(done.returncode, 2)
        self.assertIn("--samples", done.stderr)


class Sections(LayoutTest):
    def test_sections_remember_their_fold(self):
        settings = self.files / "settings"
        window = self.open(OVALS, settings=settings)
        state = window.wait(lambda s: "uniforms" in s["widgets"] and s["waiting"])
        self.assertNotIn("mode/Eye", state["widgets"], "the view is folded at first")
        self.assertIn("uniform/OvalNoise/uAd", state["widgets"], "the values are open")
        window.click("transforms")
        window.wait(lambda s: "mode/Eye" in s["widgets"])
        window.click("uniforms")
        window.wait(lambda s: "uniform/OvalNoise/uAd" not in s["widgets"])
        window.key("ctrl+q")
        window.process.wait()
        again = self.open(OVALS, settings=settings)
        state = again.wait(lambda s: "mode/Eye" in s["widgets"] and s["waiting"])
        self.assertNotIn("uniform/OvalNoise/uAd", state["widgets"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
