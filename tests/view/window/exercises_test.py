"""A student opens the exercise of a chapter, copies and solves it, and sees the own picture beside the solution's."""

import json
import subprocess
import sys
import unittest

from desktop import read_ppm
from window_case import VERTEX, WindowTest

SOLUTION = """# X1 Quad: it is green.
WindowSize 200 150
Ortho -1 1 -1 1
Vertex quad.vert
Fragment inline
#version 330
uniform float uRed; out vec4 c;
void main() { c = vec4(uRed, 1., 0., 1.); }
EndFragment
Program Quad uRed <0. .25 1.>
QuadXY 0. .7
"""
TASK = SOLUTION.replace("# X1 Quad: it is green.", "# Exercise X1: make the quad green.").replace("1., 0., 1.); }", "0., 0., 1.); }")
TABLE = """| scene | what | source |
|---|---|---|
| [quads/quad](quads/quad.glib) | a quad | Book, chapter 7 |
| [quads/other](quads/other.glib) | another | Book, chapter 10 |
| [exercises/b07/quad](exercises/b07/quad.glib) | a task | Book, chapter 7 |
"""


class Exercises(WindowTest):
    def library(self):
        root = self.files / "library"
        for name, text in {"glib/quads/quad.glib": SOLUTION, "glib/quads/other.glib": SOLUTION, "glib/exercises/b07/quad.glib": TASK,
                           "glib/exercises/b07/quad.toml": 'solution = "../../quads/quad.glib"\nsweep = ["uRed=[0, 1]"]\n',
                           "glib/README.md": TABLE, "shaders/quad.vert": VERTEX}.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        return root

    def test_the_exercise_of_a_chapter_is_opened_copied_solved_and_compared(self):
        library = self.library()
        window = self.open(None, "--size", "1000x700", variables={"GLIBRA_PATH": str(library)})
        window.wait(lambda s: s["examples"]["scenes"] == 3 and not s["examples"]["drawing"])
        window.settle()
        window.click("examples/chapter")
        window.wait(lambda s: "examples/chapter/Book, chapter 7" in s["widgets"])
        window.settle()
        window.click("examples/chapter/Book, chapter 7")
        window.wait(lambda s: s["examples"]["found"] == 2 and "example/quads/other" not in s["widgets"])
        window.settle()
        window.click("example/exercises/b07/quad")
        window.wait(lambda s: s["scene"].endswith("b07/quad.glib") and not s["examples"]["open"])
        window.settle()
        window.key("e")
        state = window.wait(lambda s: s["source"]["shown"])
        self.assertTrue(state["source"]["file"].endswith("b07/quad.glib"), "the task comes first, not a shader")
        window.key("e")
        window.wait(lambda s: not s["source"]["shown"])

        window.settle()
        window.key("ctrl+shift+s")
        window.wait(lambda s: s["dialog"] and s["takesText"])
        window.settle()
        window.key("ctrl+a")
        mine = self.files / "mine/quad.glib"
        window.type(str(mine))
        window.key("Return")
        window.wait(lambda s: s["scene"] == str(mine))
        self.assertIn(f'solution = "{library / "glib/quads/quad.glib"}"', (mine.parent / "quad.toml").read_text())

        window.settle()
        window.click("file")
        window.wait(lambda s: "file/solution" in s["widgets"])
        window.settle()
        window.click("file/solution")
        state = window.wait(lambda s: s.get("compare", {}).get("score", [0])[0] > .05 and "compare/own" in s["widgets"])
        self.assertEqual(state["compare"]["scene"], str(library / "glib/quads/quad.glib"))
        own, other = (state["widgets"]["compare/" + each] for each in ("own", "other"))
        self.assertEqual(own[1:], other[1:], "side by side, of one size")
        self.assertLess(own[0] + own[2], other[0] + 1)
        window.wait(lambda s: s["compare"]["check"].startswith("not solved yet: at uRed=0 its picture differs"))
        window.settle()
        self.assertEqual(self.pixel(window, *window.point("compare/own")), (64, 0, 0))
        self.assertEqual(self.pixel(window, *window.point("compare/other")), (64, 255, 0))

        mine.write_text(SOLUTION)
        window.wait(lambda s: s.get("compare", {}).get("score") == [0, 0])
        window.settle()
        self.assertEqual(self.pixel(window, *window.point("compare/own")), (64, 255, 0))
        window.wait(lambda s: s["compare"]["check"] == "solved, with 2 sets of values")

    def test_a_right_answer_with_slanted_edges_and_time_does_not_differ(self):
        moving = SOLUTION.replace("QuadXY", "Timer 10\nRotate 20 0 0 1\nQuadXY").replace("uRed, 1., 0.", "uRed, 1., Timer")
        for name, scene in (("mine", moving), ("solution", "# The solution.\n" + moving)):
            (self.files / f"{name}.glib").write_text(scene)
        (self.files / "quad.vert").write_text(VERTEX)
        (self.files / "mine.toml").write_text('solution = "solution.glib"\n')
        window = self.open(self.files / "mine.glib", "--size", "700x1000", "--paused")
        window.wait(lambda s: s["samples"] > 1)
        window.settle()
        window.click("file")
        window.wait(lambda s: "file/solution" in s["widgets"])
        window.settle()
        window.click("file/solution")
        state = window.wait(lambda s: "score" in s.get("compare", {}) and "compare/other" in s["widgets"])
        self.assertEqual(state["compare"]["score"], [0, 0])
        self.assertGreater(window.settle()["samples"], 1)
        window.click("time/forward")
        window.wait(lambda s: s["time"] > 0)
        self.assertEqual(window.settle()["compare"]["score"], [0, 0])
        window.drag_widget("uniform/Quad/uRed", .25, .8)
        window.wait_knob("uRed", lambda v: v[0] > .6)
        self.assertEqual(window.settle()["compare"]["score"], [0, 0])

    def test_pictures_of_the_chosen_chapter_are_drawn_first(self):
        library = self.library()
        slow = SOLUTION.replace("QuadXY 0. .7", "Sphere .7 1500 1500")
        for i in range(150):
            (library / f"glib/quads/a{i:03}.glib").write_text(slow)
        window = self.open(None, "--size", "1000x700", variables={"GLIBRA_PATH": str(library)})
        window.wait(lambda s: s["examples"]["scenes"] == 153)
        window.click("examples/chapter")
        window.wait(lambda s: "examples/chapter/Book, chapter 7" in s["widgets"])
        window.settle()
        window.click("examples/chapter/Book, chapter 7")
        records = window.folder / "cache/glibra/thumbnails"
        drawn = lambda: [json.loads(each.read_text())["scene"] for each in records.glob("*.json")]
        window.wait(lambda s: str(library / "glib/quads/quad.glib") in drawn())
        self.assertLess(len(drawn()), 140, "by name it would be the last")

    def test_any_other_scene_may_be_compared(self):
        (self.files / "a.glib").write_text(SOLUTION)
        (self.files / "b.glib").write_text(TASK)
        (self.files / "quad.vert").write_text(VERTEX)
        window = self.open(self.files / "a.glib", "--size", "1000x700")
        window.click("file")
        window.wait(lambda s: "file/compare" in s["widgets"])
        window.settle()
        window.click("file/solution")  # it is no exercise, so this does nothing
        self.assertNotIn("compare", window.settle())
        if "file/compare" not in window.state()["widgets"]:
            window.click("file")
            window.wait(lambda s: "file/compare" in s["widgets"])
            window.settle()
        window.click("file/compare")
        window.wait(lambda s: s["dialog"] == "Compare with" and s["takesText"])
        window.settle()
        window.key("ctrl+a")
        window.type("b.glib")
        window.key("Return")
        window.wait(lambda s: s.get("compare", {}).get("scene", "").endswith("b.glib") and "score" in s["compare"])
        window.drag_widget("uniform/Quad/uRed", .25, .9)
        window.settle()
        red, green, _ = self.pixel(window, *window.point("compare/other"))
        self.assertGreater(red, 200, "it has the values of this scene")
        self.assertEqual(green, 0)

    def pixel(self, window, x, y):
        """Red, green, blue of one pixel of the window's content."""
        ppm = subprocess.run(["import", "-window", window.id, "-crop", f"1x1+{round(x)}+{round(y)}", "+repage", "-depth",
                              "8", "ppm:-"], env=window.environment, check=True, stdout=subprocess.PIPE).stdout
        return tuple(read_ppm(ppm)[2])


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
