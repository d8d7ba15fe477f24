"""The driver resets the device while the window draws: a new context keeps tabs, values and edits, and the scene that was to
blame is stopped."""

import os
import unittest

from window_case import WindowTest

LIBRARY = os.environ["GLIBRA_LOSE_DEVICE"]
HANGS = """WindowSize 300 300
Ortho -1 1 -1 1
Vertex a.vert
Fragment hangs.frag
Program Hangs uRounds <0. {0} 9.>
QuadXY 0. .7
"""
HANGS_FRAGMENT = """#version 330
uniform float uRounds; out vec4 c;
float hang(float x) { return x; }
void main() { c = vec4(0., hang(uRounds), 0., 1.); }
"""


class LostDevice(WindowTest):
    def setUp(self):
        super().setUp()
        (self.files / "hangs.glib").write_text(HANGS.format("1."))
        (self.files / "hangs.frag").write_text(HANGS_FRAGMENT)
        library = self.files / "lose.so"
        library.symlink_to(LIBRARY)  # LD_PRELOAD separates libraries by blanks, and LIBRARY may have some
        self.device = self.files / "device"

    def open_on_device(self, *arguments, **variables):
        """The window on a device that hangs in programs with a function `hang`, or as the variables say."""
        return self.open(*arguments, variables=dict(LD_PRELOAD=str(self.files / "lose.so"),
                                                    GLIBRA_DEVICE=str(self.device), **variables))

    @staticmethod
    def follow(window):
        """The window after the reset is another one of the desktop."""
        window.id = window.xdotool("search", "--sync", "--onlyvisible", "--pid", str(window.process.pid)).split()[-1]
        window.xdotool("windowfocus", "--sync", window.id)
        window.move(20, 60)
        window.settle()

    def test_a_scene_that_hangs_is_stopped_and_the_other_tab_goes_on_with_its_values(self):
        for way in ("known", "unknown", "error"):
            with self.subTest(way):
                self.device.unlink(missing_ok=True)
                window = self.open_on_device(self.files / "kinds.glib", str(self.files / "hangs.glib"),
                                             "--set", "uFloat=.75", GLIBRA_RESET_AS=way)
                window.settle()
                window.key("ctrl+Next")
                state = window.wait(lambda s: any(m["id"] == "view-E04" for m in s["messages"]))
                self.assertIn("hangs.glib", state["notice"])
                self.assertIn("line 6", next(m["text"] for m in state["messages"] if m["id"] == "view-E04"))
                self.assertEqual([tab["label"] for tab in state["tabs"]], ["kinds", "hangs"])
                self.assertEqual(self.device.stat().st_size, 1, "it is not drawn again by itself")
                self.follow(window)
                window.click("tab/0", across=0.3)
                window.move(20, 250)
                window.wait(lambda s: s["shownTab"] == 0)
                state = window.settle()
                self.assertEqual(next(k["current"] for k in state["knobs"] if k["tag"] == "uFloat"), [0.75])
                self.assertShows(window, self.files / "kinds.glib", "--set", "uFloat=.75")
                self.assertEqual(self.device.stat().st_size, 1)
                window.close()

    def test_a_stopped_scene_is_drawn_again_when_its_text_has_changed(self):
        window = self.open_on_device(self.files / "hangs.glib")
        window.wait(lambda s: any(m["id"] == "view-E04" for m in s["messages"]))
        (self.files / "hangs.frag").write_text(HANGS_FRAGMENT.replace("hang(", "calm("))
        window.wait(lambda s: not any(m["id"] == "view-E04" for m in s["messages"]))
        self.follow(window)
        self.assertShows(window, self.files / "hangs.glib")

    def test_a_reset_by_another_program_stops_nothing(self):
        window = self.open_on_device(self.files / "kinds.glib", "--set", "uFloat=.75", GLIBRA_RESET_AS="other")
        window.settle()
        self.device.write_bytes(b"x")
        window.move(50, 50)
        state = window.wait(lambda s: "another program" in s["notice"])
        self.assertFalse(any(m["id"] == "view-E04" for m in state["messages"]))
        self.follow(window)
        self.assertShows(window, self.files / "kinds.glib", "--set", "uFloat=.75")


if __name__ == "__main__":
    unittest.main(verbosity=2)
