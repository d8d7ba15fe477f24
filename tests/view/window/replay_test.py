"""Tests of recorded and random input that is played back."""

import json
import shutil
import subprocess
import sys
import unittest

from desktop import SETTINGS
from random_input import frames
from window_case import OVALS, PROGRAM, SOURCES, WindowTest


class Replay(WindowTest):
    def test_recorded_input_gives_the_same_values_again(self):
        record = self.files / "input.jsonl"
        scene = self.files / "kinds.glib"
        window = self.open(scene, "--size", "200x560", "--samples", "1", "--record", str(record))  # a key needs a frame of its own
        window.drag_widget("uniform/Kinds/uFloat", 0.25, 0.8)
        window.click("uniform/Kinds/uBool")
        window.wait_knob("uBool", lambda v: v == [1])
        window.drag((100, 280), (140, 250))
        window.key("a")
        recorded = window.wait(lambda s: s["axes"] and s["waiting"])
        window.close()
        # The input fits only where the same sections are open.
        (self.files / "fresh/glibra").mkdir(parents=True)
        (self.files / "fresh/glibra/view.json").write_text(SETTINGS)
        state = self.files / "state.json"
        subprocess.run([PROGRAM, "view", str(scene), "--size", "200x560", "--replay", str(record), "--state", str(state)],
                       env=dict(self.desktop.environment, XDG_CONFIG_HOME=str(self.files / "fresh")), check=True)
        replayed = json.loads(state.read_text())
        self.assertEqual(replayed["knobs"], recorded["knobs"])
        self.assertEqual(replayed["view"], recorded["view"])
        self.assertTrue(replayed["axes"])

    def test_a_mouse_move_in_the_frame_of_a_click_rotates_nothing(self):
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
        # Copies, since random input may also save files.
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


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
