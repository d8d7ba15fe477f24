"""The Python package as its users use it: scenes as objects, arrays, notebooks, pytest. Run by CTest with the package of the
build tree on PYTHONPATH."""
import ctypes
import itertools
import os
import pathlib
import pickle
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import types
import unittest
import unittest.mock

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

    def test_moves_the_camera(self):
        scene = glibra.Scene(TEAPOT)
        before = scene.draw(64, 48)
        self.assertTrue(numpy.array_equal(before, scene.draw(64, 48, eye=numpy.identity(4))))
        half_turn = numpy.diag([-1, -1, 1, 1])  # about the line of sight
        self.assertTrue(glibra.compare(scene.draw(64, 48, eye=half_turn)[::-1, ::-1].copy(), before, flip=.2))
        self.assertFalse(glibra.compare(scene.draw(64, 48, eye=half_turn), before))
        with self.assertRaises(ValueError):
            scene.draw(64, 48, eye=[1, 2, 3])
        with self.assertRaisesRegex(glibra.SceneError, "library-E01"):
            scene.draw(64, 48, eye=numpy.full((4, 4), numpy.nan))

    def test_of_one_picture_takes_the_options_of_the_program(self):
        scene = glibra.Scene(TEAPOT)
        plain = glibra.render(TEAPOT, 64, 48, time=2.5)
        self.assertTrue((plain == scene.draw(64, 48, time=2.5)).all())
        axes = glibra.render(TEAPOT, 64, 48, time=2.5, axes=True)
        self.assertFalse((axes == plain).all())
        self.assertTrue((axes == scene.draw(64, 48, time=2.5, axes=True)).all())
        scene.uShininess = 2
        self.assertTrue((glibra.render(TEAPOT, 64, 48, set={"uShininess": 2}) == scene.draw(64, 48)).all())
        text = "WindowSize 64 64\nPerspective 40\nLookAt 0 0 3 0 0 0 0 1 0\nSphere\n"
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "sphere.glib"
            file.write_text(text)
            coarse, fine = (glibra.render(file, max_error=error, dtype="float32", alpha=True) for error in (8, .1))
            self.assertEqual((coarse.shape, coarse.dtype), ((64, 64, 4), numpy.float32))
            self.assertFalse((coarse == fine).all())
            file.write_text(text + "Cube 1 2 3 4\n")
            with self.assertRaises(glibra.SceneError):
                glibra.render(file, strict=True)
        for wrong in {"max_error": -1}, {"set": {"uNope": 1}}, {"set": {"uShininess": [[2, 3], [4, 5]]}}, {"width": -3}, {"dtype": "int8"}, {"eye": [1]}:
            with self.assertRaises((glibra.SceneError, ValueError)):
                glibra.render(TEAPOT, **wrong)

    def test_ends_with_ctrl_c(self):
        code = """
import os, signal, threading, glibra
scene = glibra.Scene(%r)
scene.draw(16, 12)
threading.Timer(.2, os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    while True: scene.draw(640, 480)
except KeyboardInterrupt:
    print("ended", scene.draw(16, 12).shape)
""" % str(TEAPOT)
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (0, "ended (12, 16, 3)\n"), done.stderr)

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

        def read():
            for each in (lambda: scene.uLevel, lambda: scene.values, lambda: scene["uLevel"]):
                with self.assertRaisesRegex(glibra.SceneError, "gpu-E08"):
                    each()

        thread = threading.Thread(target=draw)
        thread.start()
        thread.join()
        reading = threading.Thread(target=read)
        with unittest.mock.patch("threading.excepthook") as failed:
            reading.start()
            reading.join()
        failed.assert_not_called()
        self.assertIn("another thread", messages[0])
        self.assertEqual(messages[1], square().draw().tolist())


class Values(unittest.TestCase):
    def test_beyond_their_type_are_refused(self):
        fragment = ("#version 330\nuniform int uI; uniform uint uU; uniform float uF; uniform ivec2 uV; out vec4 color;\n"
                    "void main() { color = vec4(float(uI) + float(uU) + uF + float(uV.x + uV.y)); }\n")
        scene = glibra.Scene(text="Vertex square.vert\nFragment f.frag\nProgram P uI 1 uU 1 uF 1 uV [1 2]\nQuadXY 0 10\n",
                             files={"square.vert": FILES["square.vert"], "f.frag": fragment})
        for name, value in [("uI", 2**31), ("uI", -2**31 - 1), ("uI", 10**20), ("uI", 10**400), ("uI", numpy.int64(2**40)),
                            ("uI", numpy.uint32(2**32 - 1)), ("uI", "3000000000"), ("uU", -1), ("uU", 2**32), ("uU", numpy.int8(-1)),
                            ("uF", 1e300), ("uF", -10**39), ("uF", numpy.float64(1e39)), ("uF", float("nan")), ("uV", [1, 2**31]),
                            ("uV", numpy.array([1, 2**40])), ("uV", [1, 10**400]), ("P.uI", 2**31)]:
            with self.assertRaisesRegex(glibra.SceneError, "library-E03", msg=f"{name} {value}"):
                scene[name] = value
        self.assertEqual((scene.uI, scene.uU, scene.uF, scene.uV), (1, 1, 1, (1, 2)))
        for name, value in [("uI", 2**31 - 1), ("uI", numpy.int16(-5)), ("uU", numpy.uint32(2**32 - 1)), ("uF", numpy.float32(.5)),
                            ("uF", numpy.bool_(True)), ("uV", numpy.array([1, 2], numpy.uint8))]:
            scene[name] = value
            self.assertTrue(numpy.array_equal(scene[name], value), name)
        for value in None, 1j, [1j, 2], ["a", "b"], {}, numpy.array([1j, 2]):
            with self.assertRaisesRegex(TypeError, "takes a number", msg=repr(value)):
                scene.uV = value
        for width in 2**31, 10**30, 70000, -1:
            with self.assertRaisesRegex(glibra.SceneError, "library-E01"):
                scene.draw(width, 5)
        with self.assertRaises(TypeError):
            scene.draw(5.5, 5)

    def test_with_the_name_of_a_method_are_set_or_an_error(self):
        names = "target", "draw", "film", "check", "reload", "stats", "values", "_own", "buffer", "_scene", "__doc__"
        fragment = ("#version 330\n" + "".join(f"uniform float {each};" for each in names[:8]) + "\nout vec4 color;\n"
                    f"void main() {{ color = vec4(vec3({' + '.join(names[:8])}), 1); }}\n")
        scene = glibra.Scene(text="WindowSize 4 4\nVertex square.vert\nFragment f.frag\nProgram P "
                             + " ".join(f"{each} 0" for each in names[:8]) + "\nQuadXY 0 10\n",
                             files={"square.vert": FILES["square.vert"], "f.frag": fragment})
        for name in names:
            if name == "_own":
                continue
            with self.assertRaisesRegex(AttributeError, name):
                setattr(scene, name, .25)
        scene._own = .2
        self.assertEqual(scene._own, .2)
        scene["target"] = .2
        self.assertEqual(scene["target"], .2)
        self.assertEqual(scene.draw()[0, 0].tolist(), [102, 102, 102])
        with self.assertRaisesRegex(glibra.SceneError, "library-E02"):
            scene._other = 1
        with self.assertRaises(AttributeError):
            scene._other
        with self.assertRaises(AttributeError):
            scene.draw = 3
        self.assertEqual(sorted(scene), sorted(names[:8]))
        self.assertIn("_own", scene)
        self.assertNotIn("_other", scene)

        class Derived(glibra.Scene):
            note = None

        derived = Derived(text=SQUARE, files=FILES)
        derived.note = 5
        self.assertEqual(derived.note, 5)

    def test_of_arrays_have_the_declared_length(self):
        fragment = ("#version 330\nuniform float uA[4]; uniform mat2 uM[2]; out vec4 color;\n"
                    "void main() { color = vec4(vec3(uA[2] + uM[0][0].x), 1); }\n")
        scene = glibra.Scene(text="WindowSize 4 4\nVertex square.vert\nFragment a.frag\nProgram P uA [0 0 0 0]\nQuadXY 0 10\n",
                             files={"square.vert": FILES["square.vert"], "a.frag": fragment})
        scene.uA = numpy.array([0, 0, .2, 9])
        self.assertEqual(scene.uA, (0, 0, .2, 9))
        scene["uA[3]"] = 4
        self.assertEqual(scene["uA[3]"], 4)
        scene["uM[0]"] = [(0, 2), (3, 4)]  # which the scene does not set; rows first
        self.assertEqual(scene["uM[0]"], (0, 3, 2, 4))
        self.assertEqual(scene.uM, (0, 3, 2, 4, 0, 0, 0, 0))
        self.assertEqual(scene.draw()[0, 0].tolist(), [51, 51, 51])
        with self.assertRaises(KeyError):
            scene["uA[4]"]


class Processes(unittest.TestCase):
    def test_that_are_forked_are_refused(self):
        code = """
import os, pickle, signal, sys
import numpy, glibra
scene = glibra.Scene(%r)
if %r: scene.draw(16, 12)
def child(work):
    reading, writing = os.pipe()
    process = os.fork()
    if process == 0:
        signal.alarm(30)
        try: text = str(work())
        except BaseException as error: text = type(error).__name__ + ": " + str(error)
        os.write(writing, text.encode())
        sys.exit(0)  # with all that ends then
    os.close(writing)
    text = os.fdopen(reading, "rb").read().decode()
    print(os.waitpid(process, 0)[1], text.splitlines()[0], flush=True)
def assign(): scene.uShininess = 5
for work in (lambda: scene.draw(16, 12), lambda: glibra.Scene(%r).draw(16, 12), lambda: scene.uShininess, assign,
             lambda: scene.values, lambda: scene.target(), lambda: scene.reload(), lambda: scene.check(),
             lambda: scene.write("all", numpy.zeros(4, "f4"))):
    child(work)
child(lambda: glibra.compare(numpy.zeros((2, 2, 3), "uint8"), numpy.zeros((2, 2, 3), "uint8")))
print(scene.draw(16, 12).shape)
"""
        for is_drawn in False, True:
            ran = subprocess.run([sys.executable, "-c", code % (str(TEAPOT), is_drawn, str(TEAPOT))], capture_output=True,
                                 text=True, timeout=300)
            self.assertEqual(ran.returncode, 0, ran.stderr)
            lines = ran.stdout.splitlines()
            for line in lines[:9]:
                self.assertRegex(line, r"^0 SceneError: .*forked.*\[gpu-E08\]")
            self.assertEqual(lines[9:], ["0 <same: equal>", "(12, 16, 3)"])

    def test_of_pools_give_pictures_or_errors(self):
        code = """
import multiprocessing, sys
import glibra
def mean(time): return float(glibra.Scene(%r).draw(16, 12, time=time).mean())
if __name__ == "__main__":
    own = mean(0)
    for method in "spawn", "forkserver", "fork":
        with multiprocessing.get_context(method).Pool(2) as pool:
            try: print(method, pool.map(mean, [0, 0]) == [own, own], flush=True)
            except glibra.SceneError as error: print(method, error.diagnostics[0].id)
"""
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "pools.py")
            file.write_text(code % str(TEAPOT))
            ran = subprocess.run([sys.executable, str(file)], capture_output=True, text=True, timeout=300)
        self.assertEqual(ran.stdout.split("\n")[:3], ["spawn True", "forkserver True", "fork gpu-E08"], ran.stderr)

    def test_exchange_what_is_no_scene(self):
        scene = square()
        values = pickle.loads(pickle.dumps(scene.values))
        self.assertEqual([repr(each) for each in values], [repr(each) for each in scene.values])
        self.assertEqual([(each.range, each.words, each.program_line, each.line) for each in values],
                         [(each.range, each.words, each.program_line, each.line) for each in scene.values])
        found = glibra.compare(scene.draw(), scene.draw() // 2)
        again = pickle.loads(pickle.dumps(found))
        self.assertEqual((repr(again), again.x, again.y, again.largest, bool(again)),
                         (repr(found), found.x, found.y, found.largest, False))
        try:
            glibra.Scene(text="Sphere 1\nSpere 1\n", name="mine.glib")
            self.fail("a wrong scene")
        except glibra.SceneError as error:
            again = pickle.loads(pickle.dumps(error))
            self.assertEqual(str(again), str(error))
            self.assertEqual(again.diagnostics, error.diagnostics)
            self.assertEqual((again.diagnostics[0].line, again.diagnostics[0].id), (2, "glib-E01"))
            self.assertEqual((again.id, again.file, again.line, again.column), ("glib-E01", "mine.glib", 2, 1))
        self.assertEqual((glibra.SceneError("text").id, glibra.SceneError("text").line), ("", 0))


class Contents(unittest.TestCase):
    def test_of_buffers_are_the_numbers_of_the_shader(self):
        def written(declarations, block, statements, layout="std430"):
            scene = glibra.Scene(text=f"WindowSize 4 4\nBuffer all 2\nCompute inline\n#version 430\nlayout(local_size_x = 1) in;\n"
                                 f"{declarations}\nlayout({layout}) buffer all {{ {block} }};\nvoid main() {{ uint i = "
                                 f"gl_GlobalInvocationID.x; {statements} }}\nEndCompute\nProgram Write\nDispatch Write 2 1 1\n")
            scene.draw()
            return scene

        for layout in "std430", "std140", "std430, row_major", "std140, row_major":
            for columns, rows in itertools.product((2, 3, 4), (2, 3, 4)):
                for kind in "mat", "dmat":
                    numbers = [each + 1. for each in range(columns * rows)]
                    records = written(f"struct E {{ float a; {kind}{columns}x{rows} m; float z; }};", "E e[];",
                                      f"e[i].m = {kind}{columns}x{rows}({', '.join(map(str, numbers))}); e[i].z = 7;",
                                      layout).buffer("all")
                    which = f"{kind}{columns}x{rows} {layout}"
                    self.assertEqual(records["m"][1].tolist(), numbers, which)
                    self.assertEqual(records["z"].tolist(), [7, 7], which)
                    self.assertEqual(records["m"].dtype, "f4" if kind == "mat" else "f8")
        records = written("struct E { mat3 q[2]; bvec2 b; uint u; };", "E e[];",
                          "e[i].q[0] = mat3(1, 2, 3, 4, 5, 6, 7, 8, 9); e[i].q[1] = 2. * e[i].q[0]; e[i].b = bvec2(true, false); "
                          "e[i].u = 4000000000u;").buffer("all")
        self.assertEqual(records["q[1]"][0].tolist(), [2, 4, 6, 8, 10, 12, 14, 16, 18])
        self.assertEqual((records["b"][0].tolist(), int(records["u"][1])), ([1, 0], 4000000000))
        scene = written("", "uint count; mat3 turn; float e[];", "count = 3u; turn = mat3(2.); e[i] = float(i);")
        head = scene.buffer("all", head=True)
        self.assertEqual((int(head["count"][0]), head["turn"][0].tolist()), (3, [2, 0, 0, 0, 2, 0, 0, 0, 2]))
        self.assertEqual(scene.buffer("all")["e"].tolist(), [0, 1])

    def test_of_textures_have_the_numbers_of_their_format(self):
        for format, output, numbers, kind in [("r32ui", "uvec4", "16777217u, 0u, 0u, 0u", "uint32"),
                                              ("rg32i", "ivec4", "-2147483647, 16777217, 0, 0", "int32"),
                                              ("rgba16i", "ivec4", "-32768, 1, 2, 3", "int16"), ("r8i", "ivec4", "-128, 0, 0, 0", "int8"),
                                              ("rg8ui", "uvec4", "255u, 1u, 0u, 0u", "uint8"), ("r16ui", "uvec4", "65535u, 0u, 0u, 0u", "uint16"),
                                              ("rg16", "vec4", "1, 0, 0, 0", "uint16"), ("rg8", "vec4", "1, 0, 0, 0", "uint8"),
                                              ("rg16f", "vec4", "1, 0, 0, 0", "float32")]:
            scene = glibra.Scene(text=f"WindowSize 4 4\nTexture2D made 3 2 {format}\nPass made\nVertex square.vert\nFragment inline\n"
                                 f"#version 430\nout {output} color;\nvoid main() {{ color = {output}({numbers}); }}\nEndFragment\n"
                                 "Program Fill\nQuadXY 0 10\nEndPass\nPass window clear {.5 .5 .5}\nEndPass\n", files={"square.vert": FILES["square.vert"]})
            scene.draw()
            texture = scene.target("made")
            components = {"r": 1, "rg": 2, "rgba": 4}[format.rstrip("fiu0123456789")]
            self.assertEqual((texture.shape, texture.dtype), ((2, 3, components), kind), format)
            expected = [int(each.strip(" u")) for each in numbers.split(",")][:components]
            scale = {"rg16": 65535, "rg8": 255}.get(format, 1)
            self.assertEqual(texture[1, 2].tolist(), [each * scale for each in expected], format)
            self.assertTrue(glibra.compare(texture, texture.copy(), exact=True))
            if kind in ("int32", "uint32"):
                self.assertFalse(glibra.compare(texture, texture - numpy.ones((), kind)))
                with self.assertRaisesRegex(glibra.SceneError, "library-E06"):
                    glibra.save(texture, "none.png")

    def test_in_memory_have_paths_and_bytes(self):
        scene = glibra.Scene(text=SQUARE, name=pathlib.Path("square.glib"),
                             files={pathlib.Path("square.vert"): bytearray(FILES["square.vert"].encode()),
                                    "square.frag": memoryview(FILES["square.frag"].encode())})
        self.assertEqual(scene.draw()[0, 0].tolist(), [51, 102, 153])
        with tempfile.TemporaryDirectory() as folder:
            kept = pathlib.Path(folder) / "kept.txt"
            kept.write_text(FILES["square.frag"])
            content = numpy.frombuffer(FILES["square.vert"].encode(), "uint8")
            same = glibra.Scene(text=SQUARE, files={"square.vert": content, "square.frag": kept})
        self.assertTrue((same.draw() == square().draw()).all())
        with self.assertRaisesRegex(TypeError, "the content of 'square.vert' is a text, bytes or a path, found int"):
            glibra.Scene(text=SQUARE, files={"square.vert": 5})
        with self.assertRaises(TypeError):
            glibra.Scene(TEAPOT, files=FILES)

    def test_outside_of_a_folder_are_refused(self):
        with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as elsewhere:
            glibra.save(numpy.full((2, 2, 3), 200, "uint8"), os.path.join(elsewhere, "secret.png"))
            text = (f'WindowSize 8 6\nTexture2D 5 "{elsewhere}/secret.png"\nVertex square.vert\nFragment photo.frag\n'
                    "Program Photo uPhoto 5\nQuadXY 0 10\n")
            files = dict(FILES, **{"photo.frag": "#version 330\nuniform sampler2D uPhoto;\nout vec4 color;\n"
                                   "void main() { color = texture(uPhoto, vec2(.5)); }\n"})
            name = os.path.join(folder, "a.glib")
            self.assertEqual(glibra.Scene(text=text, name=name, files=files).draw()[0, 0].tolist(), [200, 200, 200])
            with self.assertRaisesRegex(glibra.SceneError, "file-E12"):
                glibra.Scene(text=text, name=name, files=files, within=folder).draw()

    def test_report_the_messages_of_a_picture(self):
        scene = square()
        self.assertEqual(scene.warnings, [])
        scene.draw()
        self.assertEqual([each.id for each in scene.warnings], ["draw-N01"])


def showing(statements, declarations, color):
    return glibra.Scene(text=f"WindowSize 4 3\n{statements}\nFragment inline\n#version 430\n{declarations}\nout vec4 fColor;\n"
                        f"void main() {{ ivec2 at = ivec2(gl_FragCoord.xy); fColor = {color}; }}\nEndFragment\nProgram Show\n"
                        "Fill window with Show\n", name="show.glib")


def copying(layout, structure, statements, count):
    """The scene of a buffer `all` of two elements, and the numbers of it that a compute shader copies."""
    return showing(f"Buffer all 2\nBuffer copied double {count}\nCompute inline\n#version 430\nlayout(local_size_x = 1) in;\n"
                   f"struct E {{ {structure} }};\nlayout({layout}) readonly buffer all {{ E e[]; }};\nlayout(std430) buffer copied "
                   f"{{ double to[]; }};\nvoid main() {{ {statements} }}\nEndCompute\nProgram Copy\nDispatch Copy 1 1 1",
                   "layout(std430) readonly buffer copied { double to[]; };", "vec4(to[0])")


def copied(scene):
    scene.draw()
    numbers = scene.buffer("copied")
    return numbers[numbers.dtype.names[0]].tolist()


class Writing(unittest.TestCase):
    def test_of_time_steps_gives_the_pictures_of_the_expression(self):
        scene = showing("Texture3D volume 4 3 2 r32f", "uniform sampler3D volume;", "texelFetch(volume, ivec3(at, 1), 0).rrrr")
        same = showing("", "uniform float uTime;", "vec4(uTime + .01 * at.x + .1 * at.y + .5)")
        z, y, x = numpy.mgrid[:2, :3, :4]
        for step in range(20):
            volume = (.02 * step + .01 * x + .1 * y + .5 * z).astype("float32")
            scene.write("volume", volume if step % 2 else volume[..., numpy.newaxis])
            same.uTime = .02 * step
            self.assertLess(abs(scene.draw(dtype="float32") - same.draw(dtype="float32")).max(), 1e-6, step)
            self.assertEqual(scene.warnings, [])
        self.assertTrue((scene.target("volume.layer(1)")[::-1, :, 0] == volume[1]).all())

    def test_takes_arrays_of_any_layout_and_byte_order(self):
        scene = showing("Texture2D field 4 3 rg32f", "uniform sampler2D field;", "texelFetch(field, at, 0)")
        field = numpy.arange(24, dtype="float32").reshape(3, 4, 2)
        padded = numpy.zeros((6, 8, 2), "float32")
        padded[::2, ::2] = field
        for array in (field, field.astype(">f4"), numpy.asfortranarray(field), padded[::2, ::2], field[::-1][::-1], memoryview(field)):
            scene.write("field", numpy.zeros((3, 4, 2), "float32"))
            scene.write("field", array)
            scene.draw()
            self.assertTrue((scene.target("field") == field).all())
        scene.write("field", scene.target("field"))
        self.assertTrue((scene.target("field") == field).all())

    def test_takes_what_reading_gives(self):
        for format, sampler, kind in (("rgba8", "sampler2D", "uint8"), ("r16", "sampler2D", "uint16"), ("rg16i", "isampler2D", "int16"),
                                      ("r32ui", "usampler2D", "uint32"), ("rgba16f", "sampler2D", "float32")):
            scene = showing(f"Texture2D made 4 3 {format}", f"uniform {sampler} made;", "vec4(texelFetch(made, at, 0))")
            scene.draw()
            array = scene.target("made") + numpy.arange(4, dtype=kind).reshape(1, 4, 1)
            self.assertEqual(array.dtype, kind)
            scene.write("made", array)
            self.assertTrue((scene.target("made") == array).all(), format)
            for wrong in (array.astype("float64"), array.astype("complex64"), array[:2], array.swapaxes(0, 1), array.ravel(),
                          array.astype("O"), numpy.zeros((3, 4), "i4,f4"), 1.5):
                with self.assertRaisesRegex(glibra.SceneError, f"'made' .*takes {kind} of shape .3, 4.*library-E03") as raised:
                    scene.write("made", wrong)
                self.assertEqual([(each.id, each.line) for each in raised.exception.diagnostics], [("library-E03", 2)])
            self.assertTrue((scene.target("made") == array).all(), format)
        with self.assertRaisesRegex(glibra.SceneError, "did you mean 'made'.*library-E02"):
            scene.write("mad", array)

    def test_fills_padded_structures(self):
        statements = "".join(f"to[{13 * i}] = e[{i}].before; to[{13 * i + 10}] = e[{i}].p.x; to[{13 * i + 11}] = e[{i}].p.y; "
                             f"to[{13 * i + 12}] = e[{i}].p.z; " +
                             "".join(f"to[{13 * i + 1 + n}] = e[{i}].m[{n // 3}][{n % 3}]; " for n in range(9)) for i in (0, 1))
        for layout in "std430", "std140", "std140, row_major":
            scene = copying(layout, "float before; mat3 m; vec3 p;", statements, 26)
            records = numpy.zeros(2, [("before", "f4"), ("m", "f4", 9), ("p", "f4", 3)])
            records["before"] = 1, 2
            records["m"] = numpy.arange(18).reshape(2, 9)
            records["p"] = [[5, 6, 7], [8, 9, 10]]
            expected = [1., *range(9), 5, 6, 7, 2, *range(9, 18), 8, 9, 10]
            turned = numpy.zeros(2, [("p", ">f4", 3), ("m", "f4", (3, 3)), ("before", ">f4")])
            for name in records.dtype.names:
                turned[name] = records[name].reshape(turned[name].shape)
            for array in records, turned, numpy.array(expected, "f4").reshape(2, 13):
                scene.write("all", numpy.zeros(2, records.dtype))
                scene.write("all", array)
                self.assertEqual(copied(scene), expected, layout)
                self.assertEqual(scene.buffer("all").tolist()[1][0], 2)
            scene.write("all", records[:1], first=1)
            self.assertEqual(copied(scene)[13:], expected[:13])
            scene.write("all", scene.buffer("all"))
            self.assertEqual(copied(scene), expected[:13] * 2)
            for wrong, first in ((records[:1], None), (records, 1), (records["m"], None), (numpy.zeros((2, 13)), None),
                                 (numpy.zeros((13, 2), "f4"), None), (records[["before", "m"]], None)):
                with self.assertRaisesRegex(glibra.SceneError, "has 2 elements of before .float32., m .9 float32., p .*library-E03"):
                    scene.write("all", wrong, first=first)
            with self.assertRaises(ValueError):
                scene.write("all", records, first=-1)

    def test_replaces_the_members_before_the_array(self):
        scene = showing("Buffer all 4", "layout(std430) readonly buffer all { uint count; mat3 turn; float e[]; };",
                        "vec4(count, turn[1][2], e[0], 1)")
        scene.write("all", numpy.array([.5, 0, 0, 0], "f4"))
        head = numpy.zeros(1, [("count", "u4"), ("turn", "f4", 9)])
        head["count"], head["turn"][0, 5] = 7, .25
        scene.write("all", head[0], head=True)
        self.assertEqual(scene.draw(dtype="float32")[0, 0].tolist(), [7, .25, .5])
        self.assertEqual(scene.buffer("all", head=True)["turn"][0].tolist(), head["turn"][0].tolist())


class Window(unittest.TestCase):
    def test_shows_the_present_values_and_files_in_memory(self):
        scene = square()
        scene.uLevel, scene.uOn, scene.uColor = .5, True, (.1, .3, .9)
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(folder, "program")
            with open(program, "w") as script:
                script.write('#!/bin/sh\nshift; scene=$1; shift; exec "$REAL" render "$scene" "$@" -o "$PICTURE"\n')
            os.chmod(program, 0o755)
            picture = os.path.join(folder, "seen.png")
            with unittest.mock.patch.dict(os.environ, REAL=os.environ["GLIBRA"], GLIBRA=program, PICTURE=picture):
                scene.view(time=1.5)
                self.assertTrue(glibra.compare(scene.draw(time=1.5), picture, exact=True))
                os.remove(picture)
                process = scene.view(wait=False)
                self.assertEqual(process.wait(), 0)
                self.assertTrue(glibra.compare(scene.draw(), picture, exact=True))

    def test_says_what_it_lacks(self):
        shown = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
        with unittest.mock.patch.dict(os.environ, shown, clear=True):
            with self.assertRaisesRegex(RuntimeError, "render"):  # what the program says without a display
                square().view()
        with unittest.mock.patch.dict(os.environ, {"PATH": ""}):
            del os.environ["GLIBRA"]
            with self.assertRaisesRegex(RuntimeError, "PATH"):
                square().view()


class Surfaces(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        glibra.Scene(TEAPOT).draw(8, 8)  # whose context stands for the program's own
        egl = ctypes.CDLL("libEGL.so.1")
        egl.eglGetProcAddress.restype = ctypes.c_void_p
        cls.function = staticmethod(lambda name: ctypes.CFUNCTYPE(None)(egl.eglGetProcAddress(name.encode())))

    def call(self, name, *arguments):
        self.function(name)(*arguments)

    def texture(self, width, height):
        name = ctypes.c_uint()
        self.call("glGenTextures", 1, ctypes.byref(name))
        self.call("glBindTexture", 0x0DE1, name)  # GL_TEXTURE_2D, RGBA8, RGBA, unsigned bytes
        self.call("glTexImage2D", 0x0DE1, 0, 0x8058, width, height, 0, 0x1908, 0x1401, None)
        return name.value

    def pixels(self, texture, width, height):
        array = numpy.zeros((height, width, 4), "uint8")
        self.call("glBindTexture", 0x0DE1, texture)
        self.call("glGetTexImage", 0x0DE1, 0, 0x1908, 0x1401, ctypes.c_void_p(array.ctypes.data))
        return array[::-1]

    def test_take_pictures_without_reading_them(self):
        scene = glibra.Scene(TEAPOT, current=True)
        name = self.texture(32, 24)
        scene.draw_into(texture=name, time=2.5, samples=4)
        expected = scene.draw(32, 24, time=2.5, samples=4)
        numpy.testing.assert_array_equal(self.pixels(name, 32, 24)[:, :, :3], expected)
        scene.draw_into(texture=numpy.int64(name), x=8, y=4, width=16, height=12)
        numpy.testing.assert_array_equal(self.pixels(name, 32, 24)[8:20, 8:24, :3], scene.draw(16, 12))

    def test_are_those_of_the_scene_too(self):
        scene = glibra.Scene(text="WindowSize 8 6\nTexture2D red 4 2 rgba8\nPass red clear {1 0 0}\nEndPass\n"
                             "Fragment inline\n#version 330\nuniform sampler2D red; in vec2 vST; out vec4 color;\n"
                             "void main() { color = texture(red, vST); }\nEndFragment\nProgram Show\nFill window with Show\n",
                             current=True)
        scene.draw()
        texture = scene.device_texture("red")
        self.assertEqual((texture["target"], texture["format"], texture["size"], texture["levels"]),
                         (0x0DE1, 0x8058, (4, 2, 1), 1))
        self.assertEqual(self.pixels(texture["name"], 4, 2).tolist(), [[[255, 0, 0, 255]] * 4] * 2)

    def test_that_are_none_are_refused(self):
        with self.assertRaisesRegex(glibra.SceneError, "own"):
            square().draw_into(1)
        scene = glibra.Scene(text=SQUARE, files=FILES, current=True)
        for wrong in {"framebuffer": 4711}, {"texture": -1}, {"framebuffer": 0}:
            with self.assertRaises(glibra.SceneError) as caught:
                scene.draw_into(**wrong)
            self.assertEqual(caught.exception.id, "library-E08", wrong)
        for wrong in {"framebuffer": 1.5}, {"texture": "window"}:
            with self.assertRaises(TypeError):
                scene.draw_into(**wrong)
        with self.assertRaisesRegex(glibra.SceneError, "width"):
            scene.draw_into(1, width=10**9)


class Control:
    """A widget as ipywidgets has them: it limits its value and calls those who observe it."""

    def __init__(self, **given):
        self.__dict__.update(given)
        self.calls = []
        if "min" in given:
            self.value = min(max(given.get("value", given["min"]), given["min"]), given["max"])

    def observe(self, call, names):
        self.calls.append(call)

    def move(self, value):
        self.value = value
        for call in self.calls:
            call({"new": value})


class Widgets(unittest.TestCase):
    def shown(self, scene):
        module = types.ModuleType("ipywidgets")
        for kind in "FloatSlider", "IntSlider", "Dropdown", "Checkbox", "Image":
            setattr(module, kind, type(kind, (Control,), {}))
        module.HBox = module.VBox = list
        with unittest.mock.patch.dict(sys.modules, ipywidgets=module):
            picture, controls = scene.interact(8, 8)
        return picture, {each.description: each for each in controls}

    def test_leave_the_scene_as_it_is(self):
        fragment = "#version 330\nout vec4 c; uniform float uF; uniform int uI; void main() { c = vec4(uF * .1 + float(uI) * .01); }\n"
        for text in ("Program P uF <0 1 2> uI <0 3 209>\nQuadXY 0 1\nProgram Q uF <0 9 10> uI <0 1 2>\nQuadXY .1 .5\n",
                     "Program P uF <0 5 2> uI <0 -4 3>\nQuadXY 0 1\n", "Program P uF <0 .001 2> uI 1\nQuadXY 0 1\n",
                     "Program P uF <0 .5 2> uI 1\nQuadXY 0 1\nProgram P uF <0 1.5 2> uI 1\nQuadXY .1 .5\n"):
            scene = glibra.Scene(text="WindowSize 8 8\nVertex square.vert\nFragment f.frag\n" + text,
                                 files={"square.vert": FILES["square.vert"], "f.frag": fragment})
            before, values = scene.draw(), [each.value for each in scene.values]
            picture, controls = self.shown(scene)
            self.assertEqual([each.value for each in scene.values], values)
            self.assertTrue(numpy.array_equal(before, scene.draw()))
            self.assertEqual(len(controls), 1 + sum(each.range is not None for each in scene.values))
            for each in [each for each in scene.values if each.range]:
                control = next(control for name, control in controls.items() if control.value == each.value[0] and name != "time"
                               and name.endswith(each.name))
                moved = 1 if each.type == "int" else 1.25
                control.move(moved)
                now = next(now for now in scene.values if (now.program_line, now.name) == (each.program_line, each.name))
                self.assertEqual(now.value, [moved])
                self.assertEqual(type(control).__name__, "IntSlider" if each.type == "int" else "FloatSlider")
                if each.type == "int":
                    self.assertEqual((control.step, int(control.step)), (int(control.step), control.step))
                control.move(each.value[0])
            self.assertEqual([each.value for each in scene.values], values)
            self.assertEqual(picture.value[:4], b"\x89PNG")


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
        for wrong in (dict(relative=float("nan")), dict(absolute=float("inf")), dict(largest=-1), dict(flip=float("nan")),
                      dict(structure=float("inf")), dict(fraction=float("nan")), dict(bias=float("nan")), dict(cluster=-1),
                      dict(cluster=float("nan")), dict(line=2.5), dict(line=1e12)):
            with self.assertRaisesRegex(glibra.SceneError, "library-E01", msg=str(wrong)):
                glibra.compare(one, one, **wrong)
        ones = numpy.ones((2, 2, 3))
        self.assertTrue(glibra.compare(ones * .1, ones * .1, exact=True))
        self.assertFalse(glibra.compare(ones * 1.01, ones, exact=True))
        with self.assertRaisesRegex(ValueError, "32-bit"):
            glibra.compare(ones + 2.**-40, ones, exact=True)
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
                for number, block in enumerate(blocks):
                    pathlib.Path(folder, f"block{number}.py").write_text(block)
                    ran = subprocess.run([sys.executable, f"block{number}.py"], cwd=folder, capture_output=True, text=True,
                                         timeout=120)
                    self.assertEqual(ran.returncode, 0, page + ran.stderr)
                    if (page, number) == ("docs/python.md", 0):
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

    TWO = "import numpy\ndef test_a(golden): golden.check_picture(numpy.full((4, 4, 3), 200, 'uint8'))\n" \
          "def test_same(golden): golden.check_picture(numpy.zeros((4, 4, 3), 'uint8'))\n"

    def differing(self, folder):
        """Two folders with a test that differs from its golden picture and one that does not."""
        for each in "a", "b":
            (folder / each / "golden").mkdir(parents=True)
            for name in "test_a", "test_same":
                glibra.save(numpy.zeros((4, 4, 3), "uint8"), folder / each / f"golden/{name}.png")
            (folder / each / f"test_{each}.py").write_text(self.TWO)

    def test_reports_what_other_processes_found(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            self.differing(folder)
            # As pytest-xdist does: the tests run in processes with `workerinput`, and this one runs none.
            (folder / "conftest.py").write_text(
                "import os, subprocess, sys, pytest\n"
                "@pytest.hookimpl(tryfirst=True)\n"
                "def pytest_configure(config):\n"
                "    if 'WORKER' in os.environ: config.workerinput = {}\n"
                "def pytest_runtestloop(session):\n"
                "    if 'WORKER' in os.environ: return None\n"
                "    workers = [subprocess.Popen([sys.executable, '-m', 'pytest', '-q', each, '--glibra-report', 'report'],\n"
                "                                env=dict(os.environ, WORKER=each)) for each in ('a', 'b')]\n"
                "    session.testsfailed = sum(each.wait() for each in workers)\n"
                "    return True\n")
            for _ in range(2):  # the second time over the first report
                ran = self.run_pytest(folder, "--glibra-report", "report")
                self.assertEqual(ran.returncode, 1, ran.stdout + ran.stderr)
                page = (folder / "report/index.html").read_text()
                self.assertEqual(page.count("<section>"), 2, page)
                for each in "a/test_a.py::test_a", "b/test_b.py::test_a", "test_a.got.png", "test_a (2).got.png":
                    self.assertIn(each, page)
                self.assertNotIn("test_same", page)
                self.assertEqual(sorted(each.name for each in (folder / "report").iterdir()),
                                 ["index.html", "test_a (2).expected.png", "test_a (2).got.png", "test_a.expected.png",
                                  "test_a.got.png"])

    def test_reports_what_the_workers_of_xdist_found(self):
        try:
            import xdist
        except ImportError:
            self.skipTest("there is no pytest-xdist")
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            self.differing(folder)
            ran = self.run_pytest(folder, "-n", "2", "--glibra-report", "report")
            self.assertEqual(ran.returncode, 1, ran.stdout + ran.stderr)
            self.assertEqual((folder / "report/index.html").read_text().count("<section>"), 2)

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
