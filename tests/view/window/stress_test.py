"""Ten thousand random events, while the open files are damaged, replaced, removed and restored. The window must end by
itself, without errors of OpenGL or of a sanitizer. To run it with sanitizers:

    ctest --test-dir build/asan-ubsan -C Long -L view-long

The variables GLIBRA_EVENTS and GLIBRA_SEED change the run."""

import json
import os
import pathlib
import random
import shutil
import subprocess
import threading
import unittest

from random_input import frames
from window_case import OVALS, PROGRAM, SOURCES, WindowTest

EVENTS = int(os.environ.get("GLIBRA_EVENTS", "10000"))
SEED = int(os.environ.get("GLIBRA_SEED", "1"))
COMMAND = [os.environ["GLIBRA_WINDOW"]] if "GLIBRA_WINDOW" in os.environ else [PROGRAM, "view"]
PARTS = 10  # scripts; the program is started once for each

PASSES = """WindowSize 160 160
Ortho -1 1 -1 1 -1 1
Texture2D 6 32 32 RGBA16F
RenderToTexture 6
Vertex a.vert
Fragment moving.frag
Program First uR <0. .5 1.>
QuadXY 0. 1.
RenderToTexture
Fragment texture.frag
Program Second uT 6
QuadXY 0. .8
Rotate 40 0 1 0
Sphere .4 12 12
"""
TEXTURE_FRAGMENT = ("#version 330\nuniform sampler2D uT; out vec4 c;\n"
                    "void main() { c = texture(uT, gl_FragCoord.xy / 160.); }\n")


class Vandal(threading.Thread):
    """Changes the files as editors, git and people do."""

    def __init__(self, folder, seed):
        super().__init__(daemon=True)
        self.choose = random.Random(seed)
        self.files = {each: each.read_bytes() for each in folder.iterdir() if each.suffix in (".glib", ".frag", ".vert")}
        self.done = threading.Event()
        self.deeds = 0

    def run(self):
        while not self.done.wait(self.choose.uniform(0.01, 0.08)):
            file, whole = self.choose.choice(list(self.files.items()))
            deed = self.choose.choice(["cut", "garble", "remove", "restore", "restore", "restore", "rename"])
            if deed == "cut":
                file.write_bytes(whole[: self.choose.randrange(len(whole))])
            elif deed == "garble":
                at = self.choose.randrange(len(whole))
                file.write_bytes(whole[:at] + bytes([self.choose.randrange(256)]) + whole[at + 1:])
            elif deed == "remove":
                file.unlink(missing_ok=True)
            elif deed == "rename":
                new = file.with_suffix(".new")
                new.write_bytes(whole)
                new.rename(file)
            else:
                file.write_bytes(whole)
            self.deeds += 1

    def stop(self):
        self.done.set()
        self.join()


class Stress(WindowTest):
    def test_random_events_do_no_harm(self):
        (self.files / "broken.glib").write_text("Program {\nSphere -1 9999999 2\nVertex none.vert\nObj none.obj\n")
        (self.files / "passes.glib").write_text(PASSES)
        (self.files / "texture.frag").write_text(TEXTURE_FRAGMENT)
        shutil.copy(OVALS, self.files / "ovals.glib")
        scenes = [str(self.files / each) for each in ("kinds.glib", "broken.glib", "none.glib", "moving.glib",
                                                      "passes.glib", "ovals.glib")]
        drops = [str(self.files / each) for each in ("a.frag", "moving.frag", "a.vert", "gone.txt", "nothing.png", ".")]
        (self.files / "gone.txt").write_text("text")
        # An editor that does nothing, and a folder for the files that buttons write.
        written = self.files / "written"
        written.mkdir()
        suppressions = f"suppressions={SOURCES / 'tests/lsan.supp'}:print_suppressions=0"
        environment = dict(self.desktop.environment, EDITOR="true", VISUAL="true", GLIBRA_PATH=str(SOURCES),
                           XDG_CONFIG_HOME=str(self.files / "settings"), LSAN_OPTIONS=suppressions,
                           ASAN_OPTIONS="detect_stack_use_after_return=1",
                           LD_PRELOAD=os.environ.get("GLIBRA_PRELOAD", ""))
        for part in range(PARTS):
            with self.subTest(part=part):
                script = self.files / "random.jsonl"
                events = frames(SEED * 1000 + part, EVENTS // PARTS, scenes, drops)
                script.write_text("".join(json.dumps(each) + "\n" for each in events))
                state_file = written / "state.json"
                vandal = Vandal(self.files, SEED * 1000 + part)
                vandal.start()
                try:
                    done = subprocess.run(
                        [*COMMAND, scenes[part % len(scenes)], "--replay", str(script), "--state", str(state_file)],
                        text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment, cwd=written)
                finally:
                    vandal.stop()
                    for file, whole in vandal.files.items():
                        file.write_bytes(whole)
                self.assertEqual((done.returncode, done.stderr[-6000:]), (0, ""))
                state = json.loads(state_file.read_text())
                self.assertEqual([each for each in state["messages"] if each["id"].startswith("gpu")], [])
                self.assertGreater(vandal.deeds, 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
