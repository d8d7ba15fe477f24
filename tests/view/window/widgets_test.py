"""Tests of widgets for values, of the mouse for transforms, and of the time section."""

import sys
import time
import unittest

from window_case import ALL_KINDS, OVALS, WindowTest


class Widgets(WindowTest):
    def test_the_picture_is_that_of_render(self):
        window = self.open(OVALS, "--size", "320x240")
        self.assertShows(window, OVALS)

    def test_sliders_change_the_picture_while_they_are_dragged(self):
        window = self.open(OVALS, "--size", "320x240")
        window.drag_widget("uniform/OvalNoise/uAd", 0.3, 0.9)
        window.wait_knob("uAd", lambda v: v[0] > 0.4)
        self.assertShows(window, OVALS, *self.set_of(window))

    def test_every_kind_of_widget(self):
        scene = self.files / "kinds.glib"
        window = self.open(scene, "--size", "200x560")
        window.drag_widget("uniform/Kinds/uFloat", 0.25, 0.8)
        window.wait_knob("uFloat", lambda v: 0.7 < v[0] < 0.9)
        window.drag_widget("uniform/Kinds/uInt", 0.15, 0.97)
        window.wait_knob("uInt", lambda v: v == [8])
        window.click("uniform/Kinds/uBool")
        window.wait_knob("uBool", lambda v: v == [1])
        window.drag(window.point("uniform/Kinds/uRgb", 0.1), window.point("uniform/Kinds/uRgb", 0.6))
        window.wait_knob("uRgb", lambda v: v[0] > 0.2 and v[1:] == [0.4, 0.6])
        window.drag(window.point("uniform/Kinds/uRgba", 0.1, 0.2), window.point("uniform/Kinds/uRgba", 0.5, 0.2))
        window.wait_knob("uRgba", lambda v: v[0] > 0.2 and v[1:] == [0.4, 0.6, 1])
        window.drag_widget("uniform/Kinds/uVector/1", 0.2, 0.9)
        window.wait_knob("uVector", lambda v: v[0] == 0.1 and v[1] > 0.2)
        window.drag_widget("uniform/Kinds/uArray/2", 0.2, 0.9)
        window.wait_knob("uArray", lambda v: v[:2] == [0.1, 0.2] and v[2] > 0.3)
        self.assertShows(window, scene, *self.set_of(window))
        window.click("reset/Kinds/uInt")
        window.wait_knob("uInt", lambda v: v == [1])
        self.assertEqual(window.knob("uBool"), [1])
        window.click("uniforms/reset")
        window.wait(lambda s: all(k["current"] == k["initial"] for k in s["knobs"]))
        self.assertShows(window, scene)

    def test_variables_change_the_scene(self):
        scene = self.files / "variables.glib"
        at = ("--time", "1.25")
        window = self.open(scene, "--size", "320x240", "--paused", *at)
        self.assertShows(window, scene, *at)
        window.drag_widget("uniform/Variables/size", 0.4, 0.9)
        window.wait_knob("size", lambda v: v[0] > 0.7)
        self.assertShows(window, scene, *at, *self.set_of(window))
        window.click("uniform/Variables/high")
        window.wait_knob("high", lambda v: v == [0])
        self.assertShows(window, scene, *at, *self.set_of(window))
        window.click("uniforms/reset")
        window.wait(lambda s: all(k["current"] == k["initial"] for k in s["knobs"]))
        self.assertShows(window, scene, *at)

    def test_a_scene_that_changes_with_time_shows_every_moment(self):
        scene = self.files / "variables.glib"
        window = self.open(scene, "--size", "240x600")
        window.wait(lambda s: s["time"] > 0.5)
        window.key("space")
        moments = [window.settle()["time"]]
        window.drag_widget("time/scrub", 0.2, 0.75)
        window.wait(lambda s: s["time"] != moments[0] and s["waiting"])
        self.assertShows(window, scene, "--time", repr(window.settle()["time"]))

    def test_a_double_click_takes_a_value_past_the_range(self):
        scene = self.files / "kinds.glib"
        window = self.open(scene, "--size", "200x560")
        window.double_click("uniform/Kinds/uFloat")
        window.wait(lambda s: s["typing"] == "uniform/Kinds/uFloat")
        self.assertEqual(window.knob("uFloat"), [0.25], "the clicks alone change nothing")
        window.type("1.75")
        window.key("Return")
        window.wait_knob("uFloat", lambda v: v == [1.75])
        self.assertShows(window, scene, "--set", "uFloat=1.75")
        window.double_click("uniform/Kinds/uInt")
        window.wait(lambda s: s["typing"] == "uniform/Kinds/uInt")
        window.type("-3")
        window.key("Return")
        window.wait_knob("uInt", lambda v: v == [-3])

    def test_undo_and_redo(self):
        window = self.open(self.files / "kinds.glib", "--size", "200x560")
        window.drag_widget("uniform/Kinds/uFloat", 0.25, 0.8)
        changed = window.settle()
        value = window.knob("uFloat")
        self.assertNotEqual(value, [0.25], changed["knobs"])
        window.key("ctrl+z")
        window.wait_knob("uFloat", lambda v: v == [0.25])
        window.key("ctrl+y")
        window.wait_knob("uFloat", lambda v: v == value)

    def test_save_puts_the_values_into_the_scene(self):
        scene = self.files / "kinds.glib"
        window = self.open(scene, "--size", "200x560", "--set", "uFloat=0.5")
        window.wait_knob("uFloat", lambda v: v == [0.5])
        window.click("scene/save")
        window.wait(lambda s: s["reloads"] >= 1)
        self.assertEqual(scene.read_text(), ALL_KINDS.replace("<0. .25 1.>", "<0. 0.5 1.>"))

    def test_copies_the_program_line(self):
        window = self.open(self.files / "kinds.glib", "--size", "200x560", "--set", "uInt=5")
        window.click("copy/0")
        window.settle()
        # Only the window can read its clipboard. Paste it into the path field and open that: the error message has
        # the text.
        window.click("uniforms/copyValues")
        window.click("scene/open")
        window.wait(lambda s: "scene/path" in s["widgets"] and s["takesText"])
        window.key("ctrl+v")
        window.key("Return")
        window.click("question/discard")
        window.wait(lambda s: any("--set uInt=5" in m["file"] + m["text"] for m in s["messages"]))


class Mouse(WindowTest):
    def picture_point(self, window, across, down):
        left, top, width, height = window.state()["picture"]
        return left + width * across, top + height * down

    def test_turns_pans_and_scales_in_the_matrix_of_the_mode(self):
        window = self.open(OVALS, "--size", "320x240")
        centre = self.picture_point(window, 0.5, 0.5)
        identity = window.state()["view"]["eye"]
        window.drag(centre, self.picture_point(window, 0.7, 0.4))
        turned = window.wait(lambda s: s["view"]["eye"] != identity)
        self.assertEqual(turned["view"]["scene"], identity)
        self.assertShows(window, OVALS, "--eye-transform", ",".join(repr(v) for v in window.settle()["view"]["eye"]))
        window.key("r")
        window.wait(lambda s: s["view"]["eye"] == identity)
        window.key("1")
        window.wait(lambda s: s["mode"] == 0)
        window.drag(centre, self.picture_point(window, 0.6, 0.5), button=3)
        moved = window.wait(lambda s: s["view"]["scene"] != identity)
        self.assertEqual(moved["view"]["eye"], identity)
        self.assertGreater(window.settle()["view"]["scene"][12], 0)
        before = window.settle()["view"]["scene"][0]
        window.move(*centre)
        window.xdotool("click", "4")
        window.wait(lambda s: s["view"]["scene"][0] != before)
        self.assertShows(window, OVALS, "--scene-transform",
                         ",".join(repr(v) for v in window.settle()["view"]["scene"]))

    def test_a_click_picks_and_the_object_mode_moves_it(self):
        window = self.open(OVALS, "--size", "320x240")
        window.move(*self.picture_point(window, 0.5, 0.55))
        window.press()
        window.release()
        picked = window.wait(lambda s: "picked" in s)["picked"]
        lines = OVALS.read_text().splitlines()
        self.assertTrue(lines[picked["line"] - 1].strip().startswith(picked["word"]))
        window.key("3")
        window.drag(self.picture_point(window, 0.5, 0.5), self.picture_point(window, 0.6, 0.5), button=3)
        objects = window.wait(lambda s: s["view"]["objects"])["view"]["objects"]
        self.assertEqual(objects[0]["line"], picked["line"])
        window.move(*self.picture_point(window, 0.02, 0.02))
        window.press()
        window.release()
        window.wait(lambda s: "picked" not in s)

    def test_axes_projection_and_wireframe(self):
        window = self.open(OVALS, "--size", "320x760")
        window.click("view/axes")
        window.wait(lambda s: s["axes"])
        self.assertShows(window, OVALS, "--axes")
        window.click("view/axes")
        window.wait(lambda s: not s["axes"])
        window.move(*self.picture_point(window, 0.1, 0.1))
        window.key("p")
        window.wait(lambda s: s["view"]["projection"] == "orthographic")
        self.assertShows(window, OVALS, "--projection", "orthographic")
        window.key("p")
        window.wait(lambda s: s["view"]["projection"] == "scene")
        filled = window.pixels()[2]
        window.click("view/wireframe")
        window.wait(lambda s: s["wireframe"])
        self.assertNotEqual(window.pixels()[2], filled)


class Time(WindowTest):
    def test_a_still_scene_draws_no_frame(self):
        window = self.open(OVALS, "--size", "320x240")
        window.move(5, 5)
        before = window.settle()
        time.sleep(2)
        self.assertEqual(window.state()["framesPresented"], before["framesPresented"])
        self.assertEqual(window.state()["framesDrawn"], before["framesDrawn"])
        window.move(7, 7)
        after = window.wait(lambda s: s["framesPresented"] > before["framesPresented"])
        self.assertEqual(after["framesDrawn"], before["framesDrawn"], "the mouse over the picture changes no picture")
        self.assertLess(after["cpuSeconds"] - before["cpuSeconds"], 0.5)

    def test_a_scene_that_reads_timer_moves_until_it_is_paused(self):
        scene = self.files / "moving.glib"
        window = self.open(scene, "--size", "200x600")
        first = window.wait(lambda s: s["moving"] and s["framesDrawn"] > 5)
        window.wait(lambda s: s["framesDrawn"] > first["framesDrawn"] + 10 and s["time"] > first["time"])
                # The window draws no more frames than the screen shows, although this driver does not wait for the screen. A
        # slow window advances its time by less than the real time.
        begin = window.state()
        end = window.wait(lambda s: s["time"] > begin["time"] + 1)
        self.assertEqual(end["refreshRate"], 60)
        self.assertFalse(end["swapControl"], "the driver of a virtual display")
        self.assertLess(end["framesPresented"] - begin["framesPresented"], 1.1 * 60 * (end["time"] - begin["time"]) + 2)
        window.key("space")
        window.wait(lambda s: not s["playing"])
        paused = window.settle()
        self.assertShows(window, scene, "--time", repr(paused["time"]))
        window.key("period")
        stepped = window.wait(lambda s: s["time"] > paused["time"])
        self.assertAlmostEqual(stepped["time"] - paused["time"], 1 / 30, 6)
        window.drag_widget("time/scrub", 0.2, 0.75)
        scrubbed = window.wait(lambda s: 6 < s["time"] <= 10 and s["waiting"])
        self.assertFalse(scrubbed["playing"])
        self.assertShows(window, scene, "--time", repr(window.settle()["time"]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
