"""The window as a user has it: a real one, driven by mouse and keys, judged by the screen and by the printed state."""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

from desktop import Desktop, Window, rendered
from random_input import frames

PROGRAM = os.environ["GLIBRA_PROGRAM"]
SOURCES = pathlib.Path(os.environ["GLIBRA_SOURCE_DIR"])
OVALS = SOURCES / "glib/patterns/ovalnoise.glib"

ALL_KINDS = """WindowSize 300 300
Ortho -1 1 -1 1
Vertex a.vert
Fragment a.frag
Program Kinds \\
    uFloat <0. .25 1.> \\
    uInt <0 1 8> \\
    uBool <false> \\
    uRgb {.2 .4 .6} \\
    uRgba {.2 .4 .6 1.} \\
    uVector [.1 .2] \\
    uArray [.1 .2 .3]
QuadXY 0. .7
"""
VERTEX = "#version 330\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n"
FRAGMENT = """#version 330
uniform float uFloat; uniform int uInt; uniform bool uBool; uniform vec3 uRgb; uniform vec4 uRgba;
uniform vec2 uVector; uniform float uArray[3]; out vec4 c;
void main() {
    c = vec4(uFloat, float(uInt) / 8., uBool ? 1. : 0., 1.);
    c.rgb = .5 * c.rgb + .2 * uRgb + .1 * uRgba.rgb * uRgba.a + vec3(uVector, uArray[0] + uArray[2]) * .1;
}
"""
MOVING = """WindowSize 200 200
Ortho -1 1 -1 1
Vertex a.vert
Fragment moving.frag
Program Moving uR <0. .5 1.>
QuadXY 0. 1.
"""
MOVING_FRAGMENT = "#version 330\nuniform float uR; out vec4 c;\nvoid main() { c = vec4(uR, Timer, 0., 1.); }\n"


class WindowTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.desktop = Desktop()

    @classmethod
    def tearDownClass(cls):
        cls.desktop.close()

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.files = pathlib.Path(self.folder.name)
        (self.files / "kinds.glib").write_text(ALL_KINDS)
        (self.files / "moving.glib").write_text(MOVING)
        (self.files / "a.vert").write_text(VERTEX)
        (self.files / "a.frag").write_text(FRAGMENT)
        (self.files / "moving.frag").write_text(MOVING_FRAGMENT)

    def tearDown(self):
        self.folder.cleanup()

    def open(self, scene, *arguments, **options):
        window = Window(self.desktop, PROGRAM, scene, *arguments, **options)
        self.addCleanup(window.close)
        return window

    def assertShows(self, window, scene, *arguments):
        """The screen has the bytes of `glibra render` with those arguments."""
        width, height, screen = window.pixels()
        picture = rendered(PROGRAM, scene, width, height, *arguments)
        self.assertEqual((width, height), picture[:2])
        different = sum(1 for a, b in zip(screen, picture[2]) if a != b)
        self.assertEqual(different, 0, f"of {len(screen)} bytes")

    def set_of(self, window):
        arguments = []
        for each in window.settle()["knobs"]:
            if each["current"] != each["initial"]:
                arguments += ["--set", each["tag"] + "=" + ",".join(repr(v) for v in each["current"])]
        return arguments


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
        window.drag(window.point("uniform/Kinds/uRgba", 0.1), window.point("uniform/Kinds/uRgba", 0.5))
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

    def test_a_double_click_takes_a_value_past_the_range(self):
        scene = self.files / "kinds.glib"
        window = self.open(scene, "--size", "200x560")
        window.double_click("uniform/Kinds/uFloat")
        window.wait(lambda s: s["typing"] == "uniform/Kinds/uFloat")
        self.assertEqual(window.knob("uFloat"), [0.25], "the clicks themselves change nothing")
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
        self.assertEqual(scene.read_text(), ALL_KINDS.replace("<0. .25 1.>", "<0 0.5 1>"))

    def test_copies_the_program_line(self):
        window = self.open(self.files / "kinds.glib", "--size", "200x560", "--set", "uInt=5")
        window.click("copy/0")
        window.settle()
        # The clipboard belongs to the window: it is pasted into the path entry, where the state shows nothing of it,
        # so the number of its lines is judged by opening what it names.
        window.click("uniforms/copySet")
        window.click("scene/open")
        window.wait(lambda s: "scene/path" in s["widgets"] and s["takesText"])
        window.key("ctrl+v")
        window.key("Return")
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
        window = self.open(OVALS, "--size", "320x600")
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
        # No more pictures than the screen shows, although nothing here waits for a screen. A window that falls behind
        # counts less time than has passed.
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


class Reload(WindowTest):
    def test_an_edit_is_seen_at_once_and_values_stay(self):
        scene = self.files / "kinds.glib"
        window = self.open(scene, "--size", "200x560", "--set", "uFloat=0.75")
        shader = self.files / "a.frag"
        shader.write_text(FRAGMENT.replace(".5 * c.rgb", ".7 * c.rgb"))
        window.wait(lambda s: s["reloads"] >= 1)
        self.assertShows(window, scene, "--set", "uFloat=0.75")
        new = self.files / "a.frag~"
        new.write_text(FRAGMENT.replace(".5 * c.rgb", ".1 * c.rgb"))
        new.rename(shader)
        window.wait(lambda s: s["reloads"] >= 2)
        self.assertShows(window, scene, "--set", "uFloat=0.75")
        good = window.pixels()[2]

        shader.write_text(FRAGMENT.replace("uInt)", "uIntt)"))
        broken = window.wait(lambda s: any(m["severity"] == "error" for m in s["messages"]))
        message = next(m for m in broken["messages"] if m["severity"] == "error")
        self.assertEqual((pathlib.Path(message["file"]).name, message["line"]), ("a.frag", 5))
        window.settle()
        self.assertEqual(window.pixels()[2][:3 * 200 * 400], good[:3 * 200 * 400], "the last good picture stays")
        shader.write_text(FRAGMENT)
        window.wait(lambda s: not any(m["severity"] == "error" for m in s["messages"]))
        self.assertShows(window, scene, "--set", "uFloat=0.75")
        self.assertGreater(window.state()["editToPictureMilliseconds"], 0)

    def test_an_edited_scene_has_its_new_knobs(self):
        scene = self.files / "kinds.glib"
        window = self.open(scene, "--size", "200x560")
        scene.write_text(ALL_KINDS.replace("uInt <0 1 8>", "uInt <0 6 8>"))
        window.wait_knob("uInt", lambda v: v == [6])
        self.assertShows(window, scene)


class Frame(WindowTest):
    def test_resizing_does_not_distort(self):
        window = self.open(OVALS, "--size", "320x240")
        for width, height in ((1100, 420), (700, 820), (420, 300)):
            window.resize(width, height)
            window.wait(lambda s: s["window"] == [width, height] and s["height"] == height)
            self.assertShows(window, OVALS)

    def test_hardcopy_is_what_the_screen_shows(self):
        window = self.open(OVALS, "--size", "320x1020", "--set", "uAd=0.4")
        window.click("hardcopy")
        window.click("hardcopy/file", across=0.9)
        file = self.files / "copy.png"
        window.type(str(file))
        window.key("Return")
        window.click("hardcopy/write")
        window.wait(lambda s: s["hardcopyMessage"] == f"written: {file}")
        ppm = subprocess.run(["convert", str(file), "-depth", "8", "ppm:-"], check=True, stdout=subprocess.PIPE).stdout
        width, height, screen = window.pixels()
        self.assertEqual(ppm[-3 * width * height:], screen)
        comment = subprocess.run(["identify", "-format", "%[Comment]", str(file)], check=True, text=True,
                                 stdout=subprocess.PIPE).stdout
        self.assertIn("--set uAd=0.4", comment)

    def test_what_the_window_remembers(self):
        settings = self.files / "settings"
        window = self.open(OVALS, settings=settings)
        window.resize(913, 517)
        window.wait(lambda s: s["window"] == [913, 517])
        window.key("t")
        window.wait(lambda s: s["lightTheme"])
        window.key("ctrl+q")
        self.assertEqual(window.process.wait(), 0)
        remembered = json.loads((settings / "glibra/view.json").read_text())
        self.assertEqual(remembered["recent"], [str(OVALS)])
        again = self.open(OVALS, settings=settings)
        again.wait(lambda s: s["window"] == [913, 517] and s["lightTheme"])

    def test_a_long_hardcopy_leaves_the_window_usable_and_can_be_stopped(self):
        window = self.open(self.files / "moving.glib", "--size", "200x900", "--paused")
        window.click("hardcopy")
        window.click("hardcopy/file")
        window.type(str(self.files / "film.png"))
        window.click("hardcopy/frames")
        window.key("ctrl+a")
        window.type("100000")
        window.key("Return")
        window.click("hardcopy/write")
        window.wait(lambda s: "hardcopy/stop" in s["widgets"])
        window.move(20, 20)
        window.key("a")
        window.wait(lambda s: s["axes"] and "hardcopy/stop" in s["widgets"])
        window.click("hardcopy/stop")
        told = window.wait(lambda s: s["hardcopyMessage"] and s["waiting"])["hardcopyMessage"]
        written = len(list(self.files.glob("film_*.png")))
        self.assertEqual(told, f"stopped after {written} of 100000 frames")
        self.assertLess(written, 100000)

    def test_floating_windows_stand_where_they_stood(self):
        settings = self.files / "settings"
        window = self.open(OVALS, "--size", "700x500", settings=settings)
        window.key("n")
        left, top, _, _ = window.wait(lambda s: "noise/graph" in s["widgets"])["widgets"]["noise/graph"]
        window.drag((left + 100, top - 20), (left + 160, top + 30))
        moved = window.wait(lambda s: s["widgets"]["noise/graph"][0] == left + 60)["widgets"]["noise/graph"]
        window.key("n", "ctrl+q")
        window.process.wait()
        again = self.open(OVALS, settings=settings)
        again.move(20, 400)
        again.key("n")
        again.wait(lambda s: s["widgets"].get("noise/graph") == moved)

    def test_help_lists_the_keys(self):
        window = self.open(OVALS, "--size", "600x600")
        window.click("help")
        window.wait(lambda s: "helpWindow" in s["widgets"])


class Looking(WindowTest):
    def test_the_inspector_tells_the_numbers_under_the_mouse(self):
        window = self.open(self.files / "kinds.glib", "--size", "600x600")
        window.click("view/inspector")
        window.wait(lambda s: "inspector/image" in s["widgets"])
        window.move(*window.point("inspector/what"))
        left, top, _, _ = window.state()["widgets"]["inspector/image"]
        window.move(left + 40.5, top + 30.5)
        told = window.wait(lambda s: s["inspected"])["inspected"]
        place, values = told.split(": ")
        x, row = (int(each) for each in place.split(", "))
        width, height, screen = rendered(PROGRAM, self.files / "kinds.glib", 600, 600)
        at = 3 * ((height - 1 - row) * width + x)
        for channel, value in zip(screen[at:at + 3], values.split()):
            self.assertEqual(round(float(value) * 255), channel)

    def test_the_frame_rate_is_measured(self):
        window = self.open(self.files / "kinds.glib", "--size", "300x860")
        window.click("cost")
        window.click("cost/measure")
        cost = window.wait(lambda s: "cost" in s)["cost"]
        self.assertGreaterEqual(cost["frames"], 20)
        self.assertGreater(cost["milliseconds"], 0)
        self.assertEqual([each["target"] for each in cost["passes"]], ["window"])
        self.assertGreater(cost["passes"][0]["milliseconds"], 0)


class Pipeline(WindowTest):
    def test_a_view_is_chosen_and_tells_its_numbers(self):
        (self.files / "layers.glib").write_text("WindowSize 200 200\nOrtho -1 1 -1 1 -1 1\nQuadXY -.5 .5\nQuadXY 0 .5\n"
                                                "Rotate 180 0 1 0\nQuadXY .5 .5\n")
        window = self.open(self.files / "layers.glib", "--size", "300x600")
        window.click("view/lens")
        window.click("view/lens/layers")
        window.wait(lambda s: s["lens"] == "layers")
        window.move(150, 300)
        window.wait(lambda s: s["lensWords"] == "3 fragments")
        window.move(150, 30)
        window.wait(lambda s: s["lensWords"] == "nothing is drawn here")
        width, height, screen = window.pixels()
        at = 3 * (height // 2 * width + width // 2 - 20)
        self.assertEqual(tuple(screen[at:at + 3]), (30, 160, 180))
        window.key("v")
        window.wait(lambda s: s["lens"] == "depth")
        window.move(151, 301)
        window.wait(lambda s: s["lensWords"].startswith("depth 0.5"))
        window.key("v")
        window.wait(lambda s: s["lens"] == "picture")
        self.assertShows(window, self.files / "layers.glib")

    def test_the_noise_window_moves_points_and_writes_what_the_command_does(self):
        window = self.open(self.files / "kinds.glib", "--size", "900x640")
        window.key("n")
        window.wait(lambda s: "noise" in s and "noise/graph" in s["widgets"])
        left, top, width, height = window.state()["widgets"]["noise/graph"]
        # Any point is taken hold of where the graph passes it; the others of the eight stay.
        window.click("noise/Lattice")
        window.click("noise/Lattice/both")
        window.move(left + width * 3 / 8, top + 4)
        window.press()
        window.release()
        window.wait(lambda s: s["noise"]["point"] == 3)
        window.drag_widget("noise/Height", 0.4, 0.6)
        window.drag_widget("noise/Curvature", 0.5, 0.9)
        command = window.wait(lambda s: "--curvature 3=" in s["noise"]["command"])["noise"]["command"]
        self.assertIn("--lattice both", command)
        value = float(command.split("--height 3=")[1].split()[0])
        self.assertTrue(0.2 < value < 0.95, value)
        # The point stands at its height; dragging it to the middle of the graph makes it 0.
        span = 2 * (1 + 5 / 16)
        x, y = left + width * 3 / 8, top + height * (0.5 - value / span)
        window.drag((x, y), (x, top + height / 2))
        window.wait(lambda s: abs(float(s["noise"]["command"].split("--height 3=")[1].split()[0])) < 0.02)
        file = self.files / "graph.svg"
        window.click("noise/File")
        window.key("ctrl+a")
        window.type(str(file))
        window.key("Return")
        window.click("noise/WriteGraph")
        written = window.wait(lambda s: s["noise"]["message"] == f"written: {file}")
        own = file.read_bytes()
        file.unlink()
        words = written["noise"]["command"].split()
        self.assertEqual(words[:2], ["glibra", "noise"])
        subprocess.run([PROGRAM, *words[1:]], check=True)
        self.assertEqual(file.read_bytes(), own)


class Replay(WindowTest):
    def test_recorded_input_gives_the_same_values_again(self):
        record = self.files / "input.jsonl"
        scene = self.files / "kinds.glib"
        window = self.open(scene, "--size", "200x560", "--record", str(record))
        window.drag_widget("uniform/Kinds/uFloat", 0.25, 0.8)
        window.click("uniform/Kinds/uBool")
        window.wait_knob("uBool", lambda v: v == [1])
        window.drag((100, 280), (140, 250))
        window.key("a")
        recorded = window.wait(lambda s: s["axes"] and s["waiting"])
        window.close()
        state = self.files / "state.json"
        subprocess.run([PROGRAM, "view", str(scene), "--size", "200x560", "--replay", str(record), "--state", str(state)],
                       env=dict(self.desktop.environment, XDG_CONFIG_HOME=str(self.files / "fresh")), check=True)
        replayed = json.loads(state.read_text())
        self.assertEqual(replayed["knobs"], recorded["knobs"])
        self.assertEqual(replayed["view"], recorded["view"])
        self.assertTrue(replayed["axes"])

    def test_the_way_to_a_click_in_the_same_frame_turns_nothing(self):
        script, state = self.files / "click.jsonl", self.files / "state.json"
        frames = 4 * [{"mouse": [10, 10], "buttons": 0}] + [{"mouse": [150, 120], "buttons": 1}] + [{"buttons": 0}] * 2
        script.write_text("".join(json.dumps(each) + "\n" for each in frames))
        subprocess.run([PROGRAM, "view", str(OVALS), "--size", "320x240", "--replay", str(script), "--state", str(state)],
                       env=dict(self.desktop.environment, XDG_CONFIG_HOME=str(self.files / "fresh")), check=True)
        end = json.loads(state.read_text())
        self.assertIn("picked", end)
        self.assertEqual(end["view"]["eye"], [float(i % 5 == 0) for i in range(16)])

    def test_random_input_does_no_harm(self):
        (self.files / "broken.glib").write_text("Program {\nSphere -1 9999999 2\nVertex none.vert\nObj none.obj\n")
        # Copies: who clicks and types anything may save it too.
        for folder in ("glib/patterns", "shaders/patterns", "shaders/common"):
            shutil.copytree(SOURCES / folder, self.files / "library" / folder)
        ovals = self.files / "library/glib/patterns/ovalnoise.glib"
        scenes = [str(self.files / "kinds.glib"), str(self.files / "broken.glib"), str(self.files / "none.glib"),
                  str(self.files / "moving.glib"), str(ovals)]
        script = self.files / "random.jsonl"
        script.write_text("".join(json.dumps(each) + "\n" for each in frames(1, 400, scenes)))
        done = subprocess.run([PROGRAM, "view", str(ovals), "--replay", str(script)], text=True, stderr=subprocess.PIPE,
                              env=dict(self.desktop.environment, XDG_CONFIG_HOME=str(self.files / "fresh")))
        self.assertEqual((done.returncode, done.stderr), (0, ""))


class NoDisplay(unittest.TestCase):
    def test_is_told_in_one_sentence(self):
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        done = subprocess.run([PROGRAM, "view", str(OVALS)], env=environment, text=True, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 4)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn("glibra render", done.stderr)

    def test_help_and_wrong_usage(self):
        done = subprocess.run([PROGRAM, "view", "--help"], text=True, stdout=subprocess.PIPE)
        self.assertEqual(done.returncode, 0)
        self.assertIn("--state", done.stdout)
        done = subprocess.run([PROGRAM, "view", "--size", "big", str(OVALS)], text=True, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
