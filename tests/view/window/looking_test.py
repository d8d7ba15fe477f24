"""Tests of the inspector, the frame rate, debug views and the noise window."""

import subprocess
import sys
import unittest

from desktop import rendered
from window_case import PROGRAM, WindowTest


class Looking(WindowTest):
    def test_the_inspector_shows_the_numbers_under_the_mouse(self):
        window = self.open(self.files / "kinds.glib", "--size", "600x600")
        window.click("view/inspector")
        window.wait(lambda s: "inspector/image" in s["widgets"])
        window.move(*window.point("inspector/what"))
        left, top, _, _ = window.state()["widgets"]["inspector/image"]
        window.move(left + 40.5, top + 30.5)
        inspected = window.wait(lambda s: s["inspected"])["inspected"]
        place, values = inspected.split(": ")
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
        self.assertEqual([each["what"] for each in cost["nodes"]], ["pass into window"])
        self.assertGreater(cost["nodes"][0]["milliseconds"], 0)


class Pipeline(WindowTest):
    def test_a_debug_view_shows_its_numbers(self):
        (self.files / "layers.glib").write_text("WindowSize 200 200\nOrtho -1 1 -1 1 -1 1\nQuadXY -.5 .5\nQuadXY 0 .5\n"
                                                "Rotate 180 0 1 0\nQuadXY .5 .5\n")
        window = self.open(self.files / "layers.glib", "--size", "300x600")
        window.click("view/show")
        window.click("view/show/layers")
        window.wait(lambda s: s["debugView"] == "layers")
        window.move(150, 300)
        window.wait(lambda s: s["debugViewText"] == "3 fragments")
        window.move(150, 30)
        window.wait(lambda s: s["debugViewText"] == "nothing is drawn here")
        width, height, screen = window.pixels()
        at = 3 * (height // 2 * width + width // 2 - 20)
        self.assertEqual(tuple(screen[at:at + 3]), (30, 160, 180))
        window.key("v")
        window.wait(lambda s: s["debugView"] == "depth")
        window.move(151, 301)
        window.wait(lambda s: s["debugViewText"].startswith("depth 0.5"))
        window.key("v")
        window.wait(lambda s: s["debugView"] == "picture")
        self.assertShows(window, self.files / "layers.glib")

    def test_the_noise_window_moves_points_and_writes_what_the_command_does(self):
        window = self.open(self.files / "kinds.glib", "--size", "900x640")
        window.key("n")
        window.wait(lambda s: "noise" in s and "noise/graph" in s["widgets"])
        left, top, width, height = window.state()["widgets"]["noise/graph"]
        # A click at any height chooses the point above or below it.
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
        # The point is at its height; dragging it to the middle of the graph makes it 0.
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
        written = window.wait(lambda s: s["noise"]["message"] == f"wrote {file}")
        own = file.read_bytes()
        file.unlink()
        words = written["noise"]["command"].split()
        self.assertEqual(words[:2], ["glibra", "noise"])
        subprocess.run([PROGRAM, *words[1:]], check=True)
        self.assertEqual(file.read_bytes(), own)


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
