"""Tests of modern scenes: parts of textures, buffers, keys of the scene, cameras, steps and their costs."""

import sys
import unittest

from window_case import WindowTest

STEPS = """WindowSize 300 300
Background 0 0 .2
Let shade <.1 .5 1>
Let mode <plain lit toon>
Buffer Sums Sum 250
Texture2D glow 64 32 rgba32f levels 6 generate
Compute count.comp
Program Count
Fragment glow.frag
Program Glow
Vertex a.vert
Fragment a.frag
Program Show uGlow glow uShade shade
Camera eye LookAt 0 0 5  0 0 0  0 1 0  Perspective 50 .1 100
Camera top LookAt 0 5 0  0 0 0  0 0 -1  Perspective 50 .1 100
Key m mode plain lit toon
Key r restart
Step 20
    Dispatch Count over Sums
EndStep
Fill glow with Glow
Pass window from eye
    Box 1 2 1
EndPass
"""
COUNT = """#version 430
layout(local_size_x = 50) in;
struct Sum { vec3 place; uint steps; };
layout(std430) buffer Sums { Sum all[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < 250u) { all[i].place = vec3(i, .5, -1); all[i].steps += 1u; }
}
"""
GLOW = "#version 330\nout vec4 c;\nvoid main() { c = vec4(4. * gl_FragCoord.x, gl_FragCoord.y, 0., 1.); }\n"
VERTEX = "#version 330\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n"
FRAGMENT = """#version 430
struct Sum { vec3 place; uint steps; };
layout(std430) readonly buffer Sums { Sum all[]; };
uniform sampler2D uGlow; uniform float uShade; out vec4 c;
void main() { c = vec4(uShade, texture(uGlow, vec2(.5)).r / 255., float(all[249].steps) / 255., 1.); }
"""


class Modern(WindowTest):
    def setUp(self):
        super().setUp()
        self.scene = self.files / "steps.glib"
        self.scene.write_text(STEPS)
        for name, text in (("count.comp", COUNT), ("glow.frag", GLOW), ("a.vert", VERTEX), ("a.frag", FRAGMENT)):
            (self.files / name).write_text(text)

    def inspect(self, window, item):
        window.click("inspector/what")
        window.click(f"inspector/item/{item}")
        return window.wait(lambda s: s["inspector"]["chosen"] == item)["inspector"]

    def test_levels_of_a_texture_are_shown_with_their_numbers(self):
        window = self.open(self.scene, "--size", "700x860", "--paused")
        window.key("i")
        self.assertEqual(self.inspect(window, "glow")["width"], 64)
        window.click("inspector/level", 0.4)
        shown = window.wait(lambda s: s["inspector"]["level"] == 2)["inspector"]
        self.assertEqual((shown["width"], shown["height"]), (16, 8))
        window.click("inspector/fitRange")
        window.wait(lambda s: s["inspector"]["range"] == [0, 248])
        window.click("inspector/fit")
        zoom = window.wait(lambda s: s["inspector"]["zoom"] > 20)["inspector"]["zoom"]
        left, top, _, _ = window.wait(lambda s: "inspector/image" in s["widgets"])["widgets"]["inspector/image"]
        window.move(left + 3.5 * zoom, top + 1.5 * zoom)
        self.assertEqual(window.wait(lambda s: s["inspected"])["inspected"], "3, 6: 56 26 0 1")
        window.xdotool("click", "4")
        window.wait(lambda s: s["inspector"]["zoom"] > zoom and s["inspected"].startswith("3, 6:"))
        window.drag((left + 60, top + 60), (left + 30, top + 40))
        window.wait(lambda s: s["widgets"]["inspector/image"][0] < left)

    def test_a_buffer_is_a_table_that_follows_the_steps(self):
        window = self.open(self.scene, "--size", "700x720", "--paused", "--time", "0.12")
        window.key("i")
        self.inspect(window, "Sums")
        shown = window.wait(lambda s: s["inspector"]["rows"])["inspector"]
        self.assertEqual(shown["columns"], ["place", "steps"])
        self.assertEqual(len(shown["rows"]), 100)
        self.assertEqual(shown["rows"][7], ["7 0.5 -1", "2"])
        window.click("inspector/pageForward")
        window.wait(lambda s: s["inspector"]["firstRow"] == 100)
        window.click("inspector/pageForward")
        shown = window.wait(lambda s: len(s["inspector"]["rows"]) == 50)["inspector"]
        self.assertEqual(shown["rows"][49], ["249 0.5 -1", "2"])
        window.click("time/step")
        window.wait(lambda s: s["inspector"]["rows"][49] == ["249 0.5 -1", "3"] and s["steps"][0]["steps"] == 3)
        window.key("b")
        state = window.wait(lambda s: s["inspector"]["rows"][49][1] == "4")
        self.assertEqual(state["time"], 0.2)
        window.key("i")
        self.assertShows(window, self.scene, "--time", "0.2")

    def test_keys_of_the_scene_act_and_those_of_the_window_need_shift(self):
        window = self.open(self.scene, "--size", "500x860", "--paused", "--time", "1")
        window.key("m")
        window.wait_knob("mode", lambda v: v == [1])
        window.click("key/m")
        window.wait_knob("mode", lambda v: v == [2])
        window.key("ctrl+z")
        window.wait_knob("mode", lambda v: v == [1])
        window.drag((100, 200), (160, 200))
        moved = window.wait(lambda s: s["view"]["eye"][0] != 1)["view"]["eye"]
        window.key("r")
        state = window.wait(lambda s: s["time"] == 0 and s["steps"][0]["steps"] == 0)
        self.assertEqual(state["view"]["eye"], moved, "the window's own R needs Shift")
        window.key("shift+r")
        window.wait(lambda s: s["view"]["eye"][0] == 1)
        window.key("question")
        window.wait(lambda s: "help/key/m" in s["widgets"] and "help/key/r" in s["widgets"])

    def test_the_picture_is_seen_through_another_camera(self):
        window = self.open(self.scene, "--size", "500x600", "--paused")
        self.assertShows(window, self.scene)
        window.click("view/camera")
        window.click("view/camera/top")
        window.wait(lambda s: s["camera"] == "top")
        other = self.files / "top.glib"
        other.write_text(STEPS.replace("Camera eye", "Camera x").replace("Camera top", "Camera eye"))
        self.assertShows(window, other)
        window.drag((100, 200), (160, 200))
        window.wait(lambda s: s["view"]["eye"][0] != 1)
        window.key("p")
        state = window.wait(lambda s: s["camera"] == "" and s["view"]["eye"][0] == 1)
        self.assertEqual(state["view"]["projection"], "scene")
        self.assertShows(window, self.scene)
        window.key("c")
        window.wait(lambda s: s["camera"] == "eye")

    def test_what_lasts_survives_an_edit_of_a_shader(self):
        window = self.open(self.scene, "--size", "500x600", "--paused", "--time", "0.5")
        window.key("m")
        window.key("c", "c")
        window.wait(lambda s: s["camera"] == "top" and s["steps"][0]["steps"] == 10)
        (self.files / "a.frag").write_text(FRAGMENT.replace("uShade, ", "1. - uShade, "))
        state = window.wait(lambda s: s["reloads"] == 1)
        self.assertEqual((state["camera"], state["time"]), ("top", 0.5))
        self.assertEqual(window.knob("mode"), [1])
        self.assertEqual(window.settle()["steps"][0]["steps"], 10)

    def test_the_frame_rate_lists_passes_and_steps(self):
        window = self.open(self.scene, "--size", "300x860", "--paused", "--time", "1")
        window.wait(lambda s: s["steps"][0]["steps"] == 20)
        window.click("cost")
        window.click("cost/measure")
        cost = window.wait(lambda s: "cost" in s)["cost"]
        self.assertEqual([each["what"] for each in cost["nodes"]], ["pass into glow", "pass into window"])
        self.assertEqual([(each["what"], each["runs"]) for each in cost["blocks"]], [("Step 20", 5)])
        self.assertEqual([each["what"] for each in cost["blocks"][0]["nodes"]], ["dispatch of Count"])
        self.assertEqual(window.settle()["steps"][0]["steps"], 20)

    def test_a_still_scene_stays_still(self):
        window = self.open(self.scene, "--size", "700x600", "--paused")
        window.key("i")
        self.inspect(window, "glow")
        before = window.settle()["framesDrawn"]
        for x in range(600, 690, 10):
            window.move(x, 580)
        self.assertEqual(window.settle()["framesDrawn"], before)


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
