"""The Python package as its users use it: scenes as objects, arrays, notebooks, pytest. Run by CTest with the package of the
build tree on PYTHONPATH."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy

import glibra

SOURCE = pathlib.Path(__file__).resolve().parents[2]
TEAPOT = SOURCE / "glib/start/teapot.glib"
SQUARE = ("WindowSize 8 6\nBackground 0 0 0\nVertex square.vert\nFragment square.frag\n"
          "Program Square uColor {.2 .4 .6} uLevel <0 1 2> uOn <true>\nQuadXY 0 10\n")
FILES = {
    "square.vert": "#version 330\nin vec4 aVertex;\nvoid main() { gl_Position = vec4(aVertex.xy, 0, 1); }\n",
    "square.frag": "#version 330\nuniform vec3 uColor; uniform float uLevel; uniform bool uOn;\nout vec4 color;\n"
                   "void main() { color = vec4(uOn ? uLevel * uColor : vec3(1), 1); }\n"}


def square():
    return glibra.Scene(text=SQUARE, name="square.glib", files=FILES)


def arrays():
    vertex = ("#version 330\nuniform mat4 uMatrices[2]; uniform mat2x3 uTurn; in vec4 aVertex;\n"
              "void main() { gl_Position = uMatrices[0] * uMatrices[1] * aVertex + vec4(uTurn * aVertex.xy, 0); }\n")
    fragment = ("#version 330\nuniform vec3 uColors[2]; out vec4 color;\n"
                "void main() { color = vec4(uColors[0] + uColors[1], 1); }\n")
    identity = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"
    return glibra.Scene(text="WindowSize 8 6\nVertex a.vert\nFragment a.frag\nProgram Show uColors [1 0 0 0 1 0] "
                        f"uMatrices [{identity} {identity}] uTurn [1 2 3 4 5 6]\nQuadXY 0 10\n",
                        name="arrays.glib", files={"a.vert": vertex, "a.frag": fragment})


class Drawing(unittest.TestCase):
    def test_gives_arrays_of_the_size_and_type_asked_for(self):
        scene = glibra.Scene(TEAPOT)
        picture = scene.draw(32, 24, time=2.5)
        self.assertEqual((picture.shape, picture.dtype), ((24, 32, 3), numpy.uint8))
        self.assertEqual(scene.draw(32, 24, alpha=True).shape, (24, 32, 4))
        floats = scene.draw(32, 24, time=2.5, dtype="float32")
        self.assertEqual(floats.dtype, numpy.float32)
        self.assertLess(abs(floats * 255 - picture).max(), 2)  # bytes are blended as bytes
        with self.assertRaises(ValueError):
            scene.draw(dtype="int32")

    def test_is_the_picture_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "teapot.png")
            subprocess.run([os.environ["GLIBRA"], "render", str(TEAPOT), "-o", file, "--size", "64x48", "--time", "1"],
                           check=True, capture_output=True)
            found = glibra.compare(glibra.Scene(TEAPOT).draw(64, 48, time=1), file, exact=True)
            self.assertTrue(found, found.reason)

    def test_takes_values_as_attributes(self):
        scene = square()
        scene.uColor = 1, 0, .2
        self.assertEqual(scene.draw()[0, 0].tolist(), [255, 0, 51])
        scene.uColor = numpy.array([0, 1, 0])
        scene.uLevel = .5
        self.assertEqual(scene.draw()[0, 0].tolist(), [0, 128, 0])
        scene.uOn = False
        self.assertEqual(scene.draw()[0, 0].tolist(), [255, 255, 255])
        self.assertEqual(scene.uLevel, .5)
        self.assertIs(scene.uOn, False)
        self.assertEqual(scene["uColor"], (0, 1, 0))
        self.assertIn("uLevel", dir(scene))
        level = next(each for each in scene.values if each.name == "uLevel")
        self.assertEqual((level.type, level.range, level.initial), ("float", (0, 2), [1]))

    def test_takes_arrays_of_uniforms_element_after_element(self):
        scene = arrays()
        scene.uColors = [(1, 2, 3), (4, 5, 6)]
        self.assertEqual(scene.uColors, (1, 2, 3, 4, 5, 6))
        scene.uColors = numpy.array([[7, 8, 9], [4, 5, 6]])
        self.assertEqual(scene.uColors, (7, 8, 9, 4, 5, 6))
        scene.uColors = 1, 2, 3, 4, 5, 6
        self.assertEqual(scene.uColors, (1, 2, 3, 4, 5, 6))
        for wrong in [(1, 4), (2, 5), (3, 6)], [[(1, 2, 3), (4, 5, 6)]], [(1, 2, 3, 4, 5, 6)]:
            with self.assertRaisesRegex(ValueError, r"'uColors' is an array of shape \(2, 3\) or 6 numbers, found"):
                scene.uColors = wrong
        self.assertEqual(scene.uColors, (1, 2, 3, 4, 5, 6))

    def test_takes_the_rows_of_matrices_first(self):
        scene = arrays()
        one, other = numpy.arange(16).reshape(4, 4), numpy.arange(16, 32).reshape(4, 4)
        by_columns = tuple(one.T.ravel()) + tuple(other.T.ravel())
        scene.uMatrices = numpy.stack([one, other])
        self.assertEqual(scene.uMatrices, by_columns)
        scene.uMatrices = scene.uMatrices  # a flat sequence has the order that is read
        self.assertEqual(scene.uMatrices, by_columns)
        scene.uTurn = [(1, 4), (2, 5), (3, 6)]  # mat2x3: two columns, three rows
        self.assertEqual(scene.uTurn, (1, 2, 3, 4, 5, 6))
        scene.uTurn = [[(6, 3), (5, 2), (4, 1)]]
        self.assertEqual(scene["Show.uTurn"], (6, 5, 4, 3, 2, 1))
        with self.assertRaisesRegex(ValueError, r"shape \(3, 2\) or 6 numbers, found an array of shape \(2, 3\)"):
            scene["Show.uTurn"] = [(1, 2, 3), (4, 5, 6)]
        with self.assertRaises(ValueError):
            scene.uMatrices = numpy.zeros((8, 4))

    def test_reads_pictures_from_memory(self):
        files = dict(FILES, **{"photo.ppm": b"P6 1 1 255\n\xff\x33\x00", "photo.frag": "#version 330\nuniform sampler2D uPhoto;\n"
                               "out vec4 color;\nvoid main() { color = texture(uPhoto, vec2(.5)); }\n"})
        scene = glibra.Scene(text="WindowSize 8 6\nTexture2D 5 photo.ppm\nVertex square.vert\nFragment photo.frag\n"
                             "Program Photo uPhoto 5\nQuadXY 0 10\n", files=files)
        self.assertEqual(scene.draw()[0, 0].tolist(), [255, 51, 0])

    def test_reports_what_is_wrong(self):
        scene = square()
        with self.assertRaisesRegex(glibra.SceneError, "did you mean 'uLevel'"):
            scene.uLevle = 1
        with self.assertRaisesRegex(glibra.SceneError, "takes 3 numbers"):
            scene.uColor = 1
        with self.assertRaises(AttributeError):
            scene.uNothing
        with self.assertRaisesRegex(glibra.SceneError, r"mine.glib:1:1: error"):
            glibra.Scene(text="Spere 1\n", name="mine.glib")
        try:
            glibra.Scene("no/such.glib")
            self.fail("a file that is missing")
        except glibra.SceneError as error:
            self.assertEqual(error.diagnostics[0].severity, "error")
        with self.assertRaisesRegex(glibra.SceneError, "width"):
            scene.draw(-1, 5)
        with self.assertRaises(TypeError):
            glibra.Scene()

    def test_gives_buffers_as_records(self):
        scene = glibra.Scene(name="buffer.glib", text="WindowSize 8 8\nBuffer numbers vec4 3 (vec4(i, 2*i, 3, 4))\n"
                             "Compute inline\n#version 430\nlayout(local_size_x = 1) in;\n"
                             "layout(std430) buffer numbers { vec4 all[]; };\nvoid main() { all[2] = all[0] + all[1]; }\n"
                             "EndCompute\nProgram Fill\nDispatch Fill 1 1 1\n"
                             "Fragment inline\n#version 430\nlayout(std430) buffer numbers { vec4 all[]; };\nout vec4 color;\n"
                             "void main() { color = all[2] / 10.; }\nEndFragment\nProgram Show\nFill window with Show\n")
        scene.draw(8, 8)
        numbers = scene.buffer("numbers")
        self.assertEqual(len(numbers), 3)
        self.assertEqual(numbers[2][numbers.dtype.names[0]].tolist(), [1, 2, 6, 8])

    def test_answers_checks(self):
        scene = glibra.Scene(text=SQUARE + "Expect pixel 1 1 [.2 .4 .6] within .01\n", name="square.glib", files=FILES)
        self.assertEqual(scene.check(), [])
        scene.uLevel = 2
        self.assertEqual([each.id for each in scene.check()], ["check-E01"])

    def test_belongs_to_its_thread(self):
        scene = square()
        messages = []

        def draw():
            try:
                scene.draw()
            except glibra.SceneError as error:
                messages.append(str(error))
            messages.append(square().draw().tolist())  # a thread has scenes of its own

        thread = threading.Thread(target=draw)
        thread.start()
        thread.join()
        self.assertIn("another thread", messages[0])
        self.assertEqual(messages[1], square().draw().tolist())


class Pictures(unittest.TestCase):
    def test_are_compared_and_saved(self):
        scene = square()
        one = scene.draw()
        self.assertTrue(glibra.compare(one, one).same)
        scene.uLevel = 2
        found = glibra.compare(scene.draw(), one)
        self.assertFalse(found)
        self.assertEqual(found.differing_pixels, 48)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "a.png")
            glibra.save(one, file)
            self.assertTrue(glibra.compare(file, one, exact=True))
            glibra.save(one[::-1], file)  # not contiguous
            self.assertTrue(glibra.compare(one[::-1].copy(), file))
        with self.assertRaises(glibra.SceneError):
            glibra.compare("no.png", "such.png")
        floats = scene.draw(dtype="float32")
        near = floats * numpy.float32(1.01)
        self.assertFalse(glibra.compare(near, floats))
        self.assertTrue(glibra.compare(near, floats, relative=.1))
        self.assertTrue(glibra.compare(near, floats, absolute=1))
        with self.assertRaises(ValueError):
            glibra.save(numpy.zeros(5), "a.png")

    def test_show_themselves_in_notebooks(self):
        self.assertEqual(repr(square()), "<glibra.Scene square.glib>")
        self.assertEqual(square()._repr_png_()[:8], b"\x89PNG\r\n\x1a\n")


class Pages(unittest.TestCase):
    def test_have_programs_that_run(self):
        with tempfile.TemporaryDirectory() as folder:
            for each in [TEAPOT, *(SOURCE / "shaders/start").iterdir()]:
                shutil.copy(each, folder)
            first = glibra.Scene(os.path.join(folder, "teapot.glib"))
            first.uShininess = 20
            glibra.save(first.draw(320, 240, time=2.5), os.path.join(folder, "golden.png"))
            for page in "README.md", "docs/python.md":
                blocks = re.findall(r"```python\n(import.*?)```", (SOURCE / page).read_text(), re.DOTALL)
                self.assertTrue(blocks, page)
                for block in blocks:
                    ran = subprocess.run([sys.executable, "-c", block], cwd=folder, capture_output=True, text=True)
                    self.assertEqual(ran.returncode, 0, page + ran.stderr)
            self.assertIn("same", ran.stdout)


class Pytest(unittest.TestCase):
    def run_pytest(self, folder, *words):
        command = [sys.executable, "-m", "pytest", "-q", *words]
        return subprocess.run(command, cwd=folder, capture_output=True, text=True)

    def test_compares_golden_pictures(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "test_it.py").write_text(
                f"def test_teapot(golden):\n    golden.check({str(TEAPOT)!r}, width=48, height=36, time=2)\n")
            missing = self.run_pytest(folder)
            self.assertEqual(missing.returncode, 1)
            self.assertIn("--glibra-update", missing.stdout)
            self.assertEqual(self.run_pytest(folder, "--glibra-update").returncode, 0)
            self.assertTrue((folder / "golden/test_teapot.png").exists())
            self.assertEqual(self.run_pytest(folder).returncode, 0)
            (folder / "test_it.py").write_text(
                f"def test_teapot(golden):\n    golden.check({str(TEAPOT)!r}, width=48, height=36, "
                "set={'uGlazeColor': (1, 0, 0)})\n")
            failed = self.run_pytest(folder, "--glibra-report", "report")
            self.assertEqual(failed.returncode, 1, failed.stdout)
            self.assertIn("test_teapot.got.png", (folder / "report/index.html").read_text())

    def test_refuses_one_golden_picture_for_two_tests(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "test_it.py").write_text(
                "import numpy, pytest\n"
                "def picture(level): return numpy.full((4, 4, 3), level, 'uint8')\n"
                "def test_teapot(golden):\n    golden.check_picture(picture(9))\n    golden.check_picture(picture(8))\n"
                "class TestC:\n    def test_teapot(self, golden): golden.check_picture(picture(200))\n"
                "@pytest.mark.parametrize('n', ['a/b', 'a b'])\n"
                "def test_n(golden, n): golden.check_picture(picture(len(n)))\n"
                "def test_shared(golden): golden.check_picture(picture(9), name='test_teapot')\n")
            made = self.run_pytest(folder, "--glibra-update")
            self.assertIn("2 failed, 3 passed", made.stdout)
            self.assertIn("test_it.py::test_teapot and test_it.py::TestC::test_teapot have the same golden picture", made.stdout)
            self.assertIn("test_it.py::test_n[a/b] and test_it.py::test_n[a b] have the same golden picture", made.stdout)
            goldens = sorted(each.name for each in (folder / "golden").iterdir())
            self.assertEqual(goldens, ["test_n_a_b_.png", "test_teapot-2.png", "test_teapot.png"])

    def test_reports_tests_of_one_name_in_two_folders(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for each, level in ("a", 10), ("b", 200):
                (folder / each / "golden").mkdir(parents=True)
                glibra.save(numpy.zeros((4, 4, 3), "uint8"), folder / each / "golden/test_it.png")
                (folder / each / f"test_{each}.py").write_text(
                    "import numpy\ndef test_it(golden): golden.check_picture(numpy.full((4, 4, 3), %d, 'uint8'))\n" % level)
            self.assertEqual(self.run_pytest(folder, "--glibra-report", "report").returncode, 1)
            levels = [glibra.compare(folder / "report" / each, numpy.zeros((4, 4, 3), "uint8")).largest
                      for each in ("test_it.got.png", "test_it (2).got.png")]
            self.assertEqual([round(each) for each in levels], [10, 200])
            self.assertIn("test_it (2).got.png", (folder / "report/index.html").read_text())


if __name__ == "__main__":
    unittest.main()
