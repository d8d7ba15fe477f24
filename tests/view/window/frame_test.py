"""Tests of reloading, resizing, hardcopies, settings, and of starting without a display."""

import json
import os
import pathlib
import subprocess
import sys
import unittest

from window_case import ALL_KINDS, FRAGMENT, OVALS, PROGRAM, WindowTest


class Reload(WindowTest):
    def test_an_edit_is_shown_at_once_and_values_stay(self):
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
            state = window.wait(lambda s: s["window"] == [width, height] and s["room"][3] == height)
            self.assertAlmostEqual(state["width"] / state["height"], 320 / 240, delta=0.02)
            self.assertShows(window, OVALS)

    def test_hardcopy_is_what_the_screen_shows(self):
        window = self.open(OVALS, "--size", "320x1020", "--set", "uAd=0.4")
        window.click("hardcopy")
        window.click("hardcopy/file", across=0.9)
        file = self.files / "copy.png"
        window.type(str(file))
        window.key("Return")
        window.click("hardcopy/write")
        window.wait(lambda s: s["hardcopyMessage"].startswith(f"written: {file}: "))
        ppm = subprocess.run(["convert", str(file), "-depth", "8", "ppm:-"], check=True, stdout=subprocess.PIPE).stdout
        width, height, screen = window.pixels()
        self.assertEqual(ppm[-3 * width * height:], screen)
        comment = subprocess.run(["identify", "-format", "%[Comment]", str(file)], check=True, text=True,
                                 stdout=subprocess.PIPE).stdout
        self.assertIn("--set uAd=0.4", comment)

    def test_settings_are_kept(self):
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
        message = window.wait(lambda s: s["hardcopyMessage"] and s["waiting"])["hardcopyMessage"]
        written = len(list(self.files.glob("film_*.png")))
        self.assertTrue(message.startswith(f"stopped after {written} of 100000 frames; written: "), message)
        self.assertIn(f"film_{written - 1:05}.png: {written} files of 200 x", message)
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


class NoDisplay(unittest.TestCase):
    def test_a_missing_display_is_reported_in_one_line(self):
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        done = subprocess.run([PROGRAM, "view", str(OVALS)], env=environment, text=True, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 4)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn("glibra render", done.stderr)

    def test_help_and_wrong_usage(self):
        done = subprocess.run([PROGRAM, "view", "--help"], text=True, stdout=subprocess.PIPE)
        self.assertEqual(done.returncode, 0)
        self.assertIn("--state", done.stdout)
        # The options are read before the display is opened.
        environment = {**os.environ, "DISPLAY": ":none"}
        done = subprocess.run([PROGRAM, "view", "--size", "big", str(OVALS)], env=environment, text=True,
                              stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
