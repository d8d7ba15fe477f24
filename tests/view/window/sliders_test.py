"""Tests of sliders with the keyboard and fine dragging, of animated values, and of gestures without a middle button."""

import sys
import time
import unittest

from window_case import FRAGMENT, OVALS, VERTEX, WindowTest

SCENE = """WindowSize 300 300
Ortho -1 1 -1 1
Vertex a.vert
Fragment ranges.frag
Program Ranges \\
    uFirst <0. .25 1.> \\
    uCount <0 1 8> \\
    uWide <.001 .1 10.> \\
    uSpan <-1. 0. 1.>
QuadXY 0. .7
"""
RANGES = """#version 330
uniform float uFirst; uniform int uCount; uniform float uWide; uniform float uSpan; out vec4 c;
void main() { c = vec4(uFirst, float(uCount) / 8. + uWide, uSpan, 1.); }
"""
SECOND = """Fragment a.frag
Program Kinds uFloat <0. .25 1.>
QuadXY 0. .3
"""
IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]


class SlidersTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.scene = self.files / "ranges.glib"
        self.scene.write_text(SCENE)
        (self.files / "ranges.frag").write_text(RANGES)

    def focused(self, window, name):
        window.wait(lambda s: s["focused"] == f"uniform/Ranges/{name}")


class Sliders(SlidersTest):
    def test_tab_chooses_a_slider_and_keys_move_it(self):
        window = self.open(self.scene, "--size", "300x700")
        window.move(20, 20)
        self.assertEqual(window.state()["focused"], "")
        window.key("Tab")
        self.focused(window, "uFirst")
        window.key("Right")
        window.wait_knob("uFirst", lambda v: v == [0.26])
        window.key("Down", "Left")
        window.wait_knob("uFirst", lambda v: v == [0.24])
        window.key("Prior")
        window.wait_knob("uFirst", lambda v: v == [0.34])
        window.key("Next", "Next")
        window.wait_knob("uFirst", lambda v: v == [0.14])
        window.key("shift+Up")
        window.wait_knob("uFirst", lambda v: v == [0.141])
        window.key("End")
        window.wait_knob("uFirst", lambda v: v == [1])
        window.key("Home")
        window.wait_knob("uFirst", lambda v: v == [0])
        window.key("Tab")
        self.focused(window, "uCount")
        window.key("Right", "Right")
        window.wait_knob("uCount", lambda v: v == [3])
        window.key("Tab", "Tab")
        self.focused(window, "uSpan")
        window.key("shift+Tab")
        self.focused(window, "uWide")
        window.key("Prior")
        # Four decades; a page is a tenth of the scale.
        window.wait_knob("uWide", lambda v: abs(v[0] - 0.1 * 10 ** 0.4) < 0.0005)
        self.assertShows(window, self.scene, *self.set_of(window))
        # A click elsewhere takes the keys away.
        left, top, width, height = window.state()["picture"]
        window.move(left + width / 2, top + height / 2)
        window.press()
        window.release()
        window.wait(lambda s: s["focused"] == "")
        before = window.knob("uWide")
        window.key("Right")
        window.settle()
        self.assertEqual(window.knob("uWide"), before)

    def test_enter_types_a_value(self):
        window = self.open(self.scene, "--size", "300x700")
        window.key("Tab", "Return")
        window.wait(lambda s: s["typing"] == "uniform/Ranges/uFirst" and s["takesText"])
        window.type("0.875")
        window.key("Return")
        window.wait_knob("uFirst", lambda v: v == [0.875])
        self.focused(window, "uFirst")
        window.key("Left")
        window.wait_knob("uFirst", lambda v: v == [0.865])

    def test_typed_numbers_have_a_comma_or_are_expressions(self):
        window = self.open(self.scene, "--size", "300x700")
        window.key("Tab")
        for typed, value in (("0,5", .5), ("1/3", 1 / 3), ("2*.3", .6), ("what", .6), ("sqrt(.25)", .5)):
            window.key("Return")
            window.wait(lambda s: s["typing"] == "uniform/Ranges/uFirst" and s["takesText"])
            window.type(typed)
            window.key("Return")
            state = window.wait(lambda s: not s["typing"])
            window.wait_knob("uFirst", lambda v: abs(v[0] - value) < 1e-9)
            if typed == "what":
                self.assertIn("is no number", state["notice"])

    def test_undo_of_a_typed_value_returns_to_the_value_before(self):
        window = self.open(self.scene, "--size", "300x700")
        before = window.knob("uFirst")
        window.double_click("uniform/Ranges/uFirst")
        window.wait(lambda s: s["typing"] == "uniform/Ranges/uFirst" and s["takesText"])
        window.key("ctrl+a")
        window.type(".7")
        window.key("Return")
        window.wait_knob("uFirst", lambda v: v == [.7])
        window.settle()
        window.move(20, 20)
        window.key("ctrl+z")
        window.wait_knob("uFirst", lambda v: v != [.7])
        self.assertEqual(window.settle() and window.knob("uFirst"), before)

    def test_the_panel_is_hidden_and_shown(self):
        window = self.open(self.scene, "--size", "300x700")
        narrow = window.state()["room"][2]
        window.key("ctrl+b")
        window.wait(lambda s: s["room"][2] == s["window"][0] > narrow)
        window.key("ctrl+b")
        window.wait(lambda s: s["room"][2] == narrow)

    def test_a_narrow_window_leaves_room_for_the_picture(self):
        for size in (), ("--size", "300x400"):
            window = self.open(self.scene, *size)
            window.resize(500, 400)
            state = window.wait(lambda s: s["window"] == [500, 400])
            self.assertGreaterEqual(window.settle()["room"][2], 200)
            self.assertGreaterEqual(state["window"][0] - window.state()["room"][2], 220, "the panel is there")

    def test_keys_of_the_scene_stay_with_the_scene(self):
        scene = self.files / "variables.glib"
        scene.write_text(scene.read_text() + "Key up high true false\n")
        window = self.open(scene, "--size", "300x700", "--paused")
        window.key("Tab")
        window.wait(lambda s: s["focused"] == "uniform/Variables/size")
        window.key("Up")
        window.wait_knob("high", lambda v: v == [0])
        self.assertEqual(window.knob("size"), [0.5])
        window.key("Right")
        window.wait_knob("size", lambda v: v[0] > 0.5)

    def test_shift_drags_ten_times_finer(self):
        window = self.open(self.scene, "--size", "300x700")
        begin, end = window.point("uniform/Ranges/uFirst", 0.25), window.point("uniform/Ranges/uFirst", 0.65)
        window.keydown("shift")
        window.drag(begin, end)
        window.keyup("shift")
        value = window.settle() and window.knob("uFirst")[0]
        self.assertAlmostEqual(value, 0.25 + 0.04, delta=0.01)
        window.drag(window.point("uniform/Ranges/uFirst", value), window.point("uniform/Ranges/uFirst", value + 0.4))
        window.wait_knob("uFirst", lambda v: abs(v[0] - value - 0.4) < 0.05)

    def test_a_wide_range_is_logarithmic(self):
        window = self.open(self.scene, "--size", "300x700")
        window.drag_widget("uniform/Ranges/uWide", 0.5, 0.75)
        # From 0.1 in the middle of four decades by one decade.
        window.wait_knob("uWide", lambda v: 0.8 < v[0] < 1.3)

    def test_groups_of_programs_fold_and_stay_folded(self):
        scene = self.files / "ranges.glib"
        scene.write_text(SCENE + SECOND)
        settings = self.files / "settings"
        window = self.open(scene, "--size", "300x700", settings=settings)
        window.wait(lambda s: "uniform/Kinds/uFloat" in s["widgets"])
        window.click("section/Ranges")
        window.wait(lambda s: "uniform/Ranges/uFirst" not in s["widgets"] and "uniform/Kinds/uFloat" in s["widgets"])
        window.key("Tab")
        window.wait(lambda s: s["focused"] == "uniform/Kinds/uFloat")
        window.key("ctrl+q")
        window.process.wait()
        again = self.open(scene, settings=settings)
        again.wait(lambda s: "uniform/Ranges/uFirst" not in s["widgets"] and "uniform/Kinds/uFloat" in s["widgets"])

    def test_moves_there_and_back_leave_no_tiny_numbers(self):
        window = self.open(OVALS, "--size", "400x760")
        left, top, width, height = window.state()["picture"]
        centre = (left + width / 2, top + height / 2)
        for there in ((61, 13), (-27, 44), (33, -71)):
            window.drag(centre, (centre[0] + there[0], centre[1] + there[1]), button=3)
            window.drag((centre[0] + there[0], centre[1] + there[1]), centre, button=3)
            window.drag(centre, (centre[0] + there[0], centre[1]))
            window.drag((centre[0] + there[0], centre[1]), centre)
        matrix = window.settle()["view"]["eye"]
        self.assertEqual([v for v in matrix if 0 < abs(v) < 1e-12], [])
        # The fields of the section View drag by rounded steps.
        for to in (0.9, 0.2, 0.6, 0.5):
            window.drag_widget("transform/Translate", 0.5, to)
        matrix = window.settle()["view"]["eye"]
        self.assertEqual([v for v in matrix if 0 < abs(v) < 1e-12], [])


class Animations(SlidersTest):
    def test_a_value_moves_until_it_is_stopped_and_undo_returns_to_before(self):
        window = self.open(self.scene, "--size", "300x700")
        window.click("animate/Ranges/uFirst")
        window.wait(lambda s: s["knobs"][0]["animated"] and s["moving"])
        seen = {window.wait_knob("uFirst", lambda v: v[0] > 0.4)["knobs"][0]["current"][0]}
        for _ in range(3):
            time.sleep(0.2)
            seen.add(window.knob("uFirst")[0])
        self.assertGreater(len(seen), 2)
        self.assertTrue(all(0 <= v <= 1 for v in seen))
        window.click("animate/Ranges/uFirst")
        stopped = window.wait(lambda s: not s["knobs"][0]["animated"] and s["waiting"])["knobs"][0]["current"]
        time.sleep(0.3)
        self.assertEqual(window.knob("uFirst"), stopped)
        self.assertShows(window, self.scene, *self.set_of(window))
        window.key("ctrl+z")
        window.wait_knob("uFirst", lambda v: v == [0.25])
        window.key("ctrl+y")
        window.wait_knob("uFirst", lambda v: v == stopped)

    def test_the_same_time_shows_the_same_value(self):
        window = self.open(self.scene, "--size", "300x700", "--paused")
        window.move(*window.point("uniform/Ranges/uFirst"))
        window.xdotool("click", "3")
        window.click("menu/animate")
        window.wait(lambda s: s["playing"] and s["time"] > 0.5)
        window.key("space")
        paused = window.wait(lambda s: not s["playing"] and s["waiting"])
        value, moment = paused["knobs"][0]["current"][0], paused["time"]
        self.assertAlmostEqual(value, 0.25 + moment / 4, delta=1e-4)
        window.key("period", "period", "period")
        window.wait(lambda s: s["knobs"][0]["current"][0] != value)
        window.key("comma", "comma", "comma")
        window.wait(lambda s: abs(s["time"] - moment) < 1e-9)
        self.assertAlmostEqual(window.settle()["knobs"][0]["current"][0], value, delta=2e-5)

    def test_dragging_the_slider_ends_its_animation(self):
        window = self.open(self.scene, "--size", "300x700")
        window.click("animate/Ranges/uFirst")
        window.wait(lambda s: s["knobs"][0]["animated"])
        window.drag_widget("uniform/Ranges/uFirst", 0.5, 0.8)
        window.wait(lambda s: not s["knobs"][0]["animated"] and abs(s["knobs"][0]["current"][0] - 0.8) < 0.06)

    def test_the_menu_resets_one_value(self):
        window = self.open(self.scene, "--size", "300x700", "--set", "uFirst=.75", "--set", "uCount=5")
        window.move(*window.point("label/Ranges/uFirst"))
        window.xdotool("click", "3")
        window.click("menu/reset")
        window.wait_knob("uFirst", lambda v: v == [0.25])
        self.assertEqual(window.knob("uCount"), [5])


class Gestures(SlidersTest):
    def test_every_gesture_has_one_of_the_left_button(self):
        window = self.open(OVALS, "--size", "400x400")
        left, top, width, height = window.state()["picture"]
        centre = (left + width / 2, top + height / 2)
        window.keydown("ctrl")
        window.drag(centre, (centre[0], centre[1] - 60))
        window.keyup("ctrl")
        scaled = window.wait(lambda s: s["view"]["eye"] != IDENTITY)
        scaled = window.settle()["view"]["eye"]
        self.assertGreater(scaled[0], 1.1)
        self.assertAlmostEqual(scaled[0], scaled[5])
        self.assertAlmostEqual(scaled[1], 0)
        window.key("r")
        window.wait(lambda s: s["view"]["eye"] == IDENTITY)
        window.keydown("shift")
        window.drag(centre, (centre[0] + 50, centre[1]))
        window.keyup("shift")
        window.wait(lambda s: s["view"]["eye"] != IDENTITY)
        panned = window.settle()["view"]["eye"]
        self.assertEqual(panned[:12], [float(v) for v in IDENTITY[:12]])
        self.assertGreater(panned[12], 0)

    def test_scrolling_scales_in_even_steps(self):
        window = self.open(OVALS, "--size", "400x400")
        left, top, width, height = window.state()["picture"]
        window.move(left + width / 2, top + height / 2)
        sizes = [1]
        for _ in range(4):
            window.xdotool("click", "4")
            window.wait(lambda s: s["view"]["eye"][0] != sizes[-1])
            sizes.append(window.settle()["view"]["eye"][0])
        factors = [b / a for a, b in zip(sizes, sizes[1:])]
        for each in factors:
            self.assertAlmostEqual(each, factors[0], places=9)


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
