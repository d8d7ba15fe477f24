"""A frame of a moving scene allocates no heap memory, panels included."""

import os
import subprocess
import time
import unittest

from desktop import HANGING, PAUSE
from window_case import PROGRAM, WindowTest

COUNTER = os.environ["GLIBRA_COUNTER"]
SETTLED = 60  # frames after which everything has been allocated


class Memory(WindowTest):
    def test_frames_of_a_moving_scene_allocate_nothing(self):
        counts = self.files / "counts"
        counter = self.files / "counter.so"
        counter.symlink_to(COUNTER)  # LD_PRELOAD separates libraries by blanks, and COUNTER may have some
        environment = dict(self.desktop.environment, XDG_CONFIG_HOME=str(self.files / "settings"), LD_PRELOAD=str(counter),
                           GLIBRA_ALLOCATIONS=str(counts))
        window = subprocess.Popen([PROGRAM, "view", str(self.files / "moving.glib"), "--size", "300x700"],
                                  env=environment)
        try:
            end = time.monotonic() + HANGING
            lines = []
            while len(lines) < 2 * SETTLED and time.monotonic() < end:
                time.sleep(PAUSE)
                lines = counts.read_text().splitlines()[:-1] if counts.exists() else []
        finally:
            window.terminate()
            window.wait()
        self.assertGreaterEqual(len(lines), 2 * SETTLED)
        frames = [int(each) for each in lines]
        self.assertGreater(frames[0], 0, "the counter counts")
        self.assertEqual(frames[SETTLED:], [0] * len(frames[SETTLED:]))


if __name__ == "__main__":
    unittest.main(verbosity=2)
