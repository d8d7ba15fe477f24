#!/usr/bin/env python3
"""`glibra publish` and `glibra gallery --live`, run as a user runs them, with a file in place of the runtime.

usage: publish_test.py GLIBRA
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = None
VERTEX = "#version 330 core\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n"
FRAGMENT = "#version 330 core\nuniform float uG; out vec4 c;\nvoid main() { c = vec4(uG, .5, 0., 1.); }\n"
SCENE = "# A quad.\nWindowSize 40 30\nOrtho -1 1 -1 1\nVertex q.vert\nFragment q.frag\nProgram P uG <0. .5 1.>\nQuadXY 0 1\n"
LACKING = FRAGMENT.replace("out vec4 c", "noperspective in vec3 v; out vec4 c").replace("uG, .5", "uG, v.x")


class Publish(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.programs = tempfile.mkdtemp(prefix="glibra-publish-")
        cls.program = os.path.join(cls.programs, "glibra")
        shutil.copy(PROGRAM, cls.program)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.programs)

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="glibra-publish-")
        self.write("glibra.wasm", "a runtime", self.programs)
        self.write("in/a.glib", SCENE)
        self.write("in/q.vert", VERTEX)
        self.write("in/q.frag", FRAGMENT)

    def tearDown(self):
        shutil.rmtree(self.folder)

    def write(self, name, text, folder=None):
        path = os.path.join(folder or self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb") as file:
            file.write(text if isinstance(text, bytes) else text.encode())

    def read(self, name):
        with open(os.path.join(self.folder, name), "rb") as file:
            return file.read().decode()

    def glibra(self, *words, status=0):
        run = subprocess.run([self.program, *words], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, status, run.stderr)
        return run.stderr

    def test_one_scene_is_one_page_and_always_the_same(self):
        self.glibra("publish", "in/a.glib")
        page = self.read("a.html")
        self.assertIn("<title>a</title>", page)
        self.assertIn("<p>A quad.</p>", page)
        self.assertIn("data:image/png;base64,", page)
        self.glibra("publish", "in/a.glib", "-o", "b.html")
        self.assertEqual(self.read("b.html"), page)
        os.mkdir(os.path.join(self.folder, "site"))
        self.glibra("publish", "in/a.glib", "-o", "site", "--title", "Week <3>", "--embed", "--poster", "--set", "uG=.25", "--size", "80x60")
        page = self.read("site/a.html")
        self.assertIn("<h1>Week &lt;3&gt;</h1>", page)
        for each in ('"embed":true', '"poster":true', '"values":[0.25]', '"width":80', 'class="page embedded"', 'width="80" height="60"'):
            self.assertIn(each, page)

    def test_several_scenes_are_a_site_with_one_runtime(self):
        self.write("in/deep/b.glib", SCENE.replace("q.vert", "../q.vert").replace("q.frag", "../q.frag"))
        for words in (["publish", "in"], ["publish", "in/a.glib", "in/deep/b.glib"], ["gallery", "in", "--live"]):
            self.glibra(*words, "-o", "site")
            names = sorted(os.path.relpath(os.path.join(folder, name), os.path.join(self.folder, "site"))
                           for folder, _, all_names in os.walk(os.path.join(self.folder, "site")) for name in all_names)
            self.assertEqual(names, [".glibra-gallery", "gallery.css", "gallery.js", "index.html", "live/live.css", "live/live.js", "live/runtime.js",
                                     "pictures/a.png", "pictures/deep-b.png", "scenes/a.html", "scenes/a.js", "scenes/deep-b.html", "scenes/deep-b.js"])
            page = self.read("site/scenes/a.html")
            for each in ("'wasm-unsafe-eval'", 'src="a.js"', 'src="../live/live.js"', 'src="../pictures/a.png"'):
                self.assertIn(each, page)
            shutil.rmtree(os.path.join(self.folder, "site"))

    def test_the_pages_of_a_site_may_be_for_frames(self):
        self.write("in/b.glib", SCENE)
        self.glibra("publish", "in", "-o", "site", "--embed")
        page = self.read("site/scenes/a.html")
        self.assertIn('<body class="page embedded">', page)
        self.assertIn("../live/runtime.js", page)
        for absent in ("<nav", "<h1", "A quad."):
            self.assertNotIn(absent, page)
        self.assertIn("scenes/b.html", self.read("site/index.html"))

    def test_folders_of_a_page_are_made(self):
        self.glibra("publish", "in/a.glib", "-o", "new/folder/")
        self.assertIn("<title>a</title>", self.read("new/folder/a.html"))
        self.glibra("publish", "in/none.glib", "-o", "other/", status=3)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "other")))

    def test_what_browsers_lack_is_reported_and_the_page_is_a_film(self):
        self.write("in/q.vert", VERTEX.replace("void main() {", "noperspective out vec3 v;\nvoid main() { v = vec3(.5);"))
        self.write("in/q.frag", LACKING)
        os.remove(os.path.join(self.programs, "glibra.wasm"))  # a film does not need it
        message = self.glibra("publish", "in/a.glib")
        self.assertRegex(message, r"in/q\.(vert|frag):\d+:\d+: warning: .*\[web-E04\]")
        page = self.read("a.html")
        self.assertRegex(page, r'<p class="remark">This is a film, .*: in/q\.(vert|frag):\d+:\d+: error: .*\[web-E04\]\. It shows one change at a time')
        self.assertIn("data:image/png", page)
        self.assertNotIn("glibra-runtime\">", page)
        self.assertNotIn("wasm-unsafe-eval';", page)
        self.assertNotIn(self.folder, page)
        self.glibra("publish", "in/a.glib", "-o", "b.html")
        self.assertEqual(self.read("b.html"), page)
        self.write("glibra.wasm", "a runtime", self.programs)
        self.glibra("publish", "in", "-o", "site")
        page = self.read("site/scenes/a.html")
        self.assertIn("[web-E04]", page)
        self.assertIn('src="../live/live.js"', page)
        self.assertNotIn("runtime.js", page)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "site/live/runtime.js")))
        self.assertIn('"film":{', self.read("site/scenes/a.js"))

    def test_a_faulty_scene_leaves_no_page(self):
        self.write("in/a.glib", SCENE.replace("QuadXY", "QuadYX"))
        self.assertIn("QuadYX", self.glibra("publish", "in/a.glib", status=3))
        self.assertIn("none.glib", self.glibra("publish", "none.glib", status=3))
        self.assertFalse(os.path.exists(os.path.join(self.folder, "a.html")))

    def test_an_exercise_has_the_page_of_a_faulty_scene(self):
        self.write("in/q.frag", FRAGMENT.replace("uG, .5", "uNone, .5"))
        told = self.glibra("publish", "in/a.glib", "--exercise")
        self.assertRegex(told, r"q\.frag:3:.*uNone.*\[glsl-E01\]")
        self.assertIn("a.html (an exercise: the scene has errors)", told)
        page = self.read("a.html")
        self.assertIn('id="glibra-runtime"', page)
        self.assertNotIn("<img", page)
        self.assertIn("--exercise", self.glibra("publish", "in", "-o", "site", "--exercise", status=2))
        self.write("in/q.frag", FRAGMENT)
        self.assertNotIn("exercise", self.glibra("publish", "in/a.glib", "--exercise"))
        self.assertIn("<img", self.read("a.html"))

    def test_a_note_names_the_largest_files_of_a_large_page(self):
        self.assertNotIn("note", self.glibra("publish", "in/a.glib"))
        self.write("in/a.glib", SCENE.replace("Vertex", "Texture2D uBig big.ppm\nTexture2D uSmall small.ppm\nVertex").replace("P uG", "P uBig uBig uSmall uSmall uG"))
        self.write("in/q.frag", FRAGMENT.replace("uniform", "uniform sampler2D uBig, uSmall;\nuniform").replace(", 1.)", ", 1.) + texture(uBig, vec2(.5)) + texture(uSmall, vec2(.5))"))
        self.write("in/big.ppm", b"P6 3000 2000 255\n" + bytes(18_000_000))
        self.write("in/small.ppm", b"P6 600 500 255\n" + bytes(900_000))
        told = [each for each in self.glibra("publish", "in/a.glib").splitlines() if "note" in each]
        self.assertEqual(len(told), 1, told)
        self.assertRegex(told[0], r"in/a\.glib:1:1: note: readers of the page load 18\.1 MiB of files; 'in/big\.ppm' has 17\.2 MiB, 'in/small\.ppm' has 900015 bytes, 'in/a\.glib' has \d+ bytes")

    def test_nothing_from_outside_is_on_a_page(self):
        self.write("secret.frag", "theSecret")
        os.symlink("../secret.frag", os.path.join(self.folder, "in/link.frag"))
        for each in ("../secret.frag", "link.frag"):
            self.write("in/a.glib", SCENE.replace("q.frag", each))
            self.assertIn("file-E12", self.glibra("publish", "in/a.glib", status=3))
            self.assertFalse(os.path.exists(os.path.join(self.folder, "a.html")))

    def test_a_scene_is_told_how_it_gets_files_that_it_may_not_read(self):
        self.write("two/shared/q.frag", FRAGMENT)
        self.write("two/week/q.vert", VERTEX)
        self.write("two/week/a.glib", SCENE.replace("q.frag", "../shared/q.frag"))
        told = self.glibra("publish", "two/week/a.glib", status=3)
        self.assertIn("[file-E12]", told)
        self.assertIn("glibra publish FOLDER -o site/", told)
        self.glibra("publish", "two", "-o", "site")
        self.write("in/b.glib", SCENE.replace("q.frag", "noise/marble.frag"))
        # The program in its own place, where its library is.
        run = subprocess.run([PROGRAM, "publish", "in/b.glib"], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertIn("note: the library of glibra has 'noise/marble.frag'; --library", run.stderr)

    def test_what_is_read_is_not_written_over(self):
        self.assertIn("file-E13", self.glibra("publish", "in/a.glib", "-o", "in/q.frag", status=3))
        self.assertEqual(self.read("in/q.frag"), FRAGMENT)
        self.assertIn("file-E10", self.glibra("publish", "in/a.glib", "-o", "none/a.html", status=3))

    def test_wrong_usage_is_refused(self):
        for words in (["publish"], ["publish", "-"], ["publish", "in"], ["publish", "in", "-o", "site", "--set", "uG=1"], ["publish", "in/a.glib", "--set", "x"],
                      ["publish", "in/a.glib", "-o", "-"], ["publish", "in", "-o", "in"]):
            self.assertTrue(self.glibra(*words, status=2))

    def test_a_missing_runtime_is_reported_before_anything_is_written(self):
        os.remove(os.path.join(self.programs, "glibra.wasm"))
        for words in (["publish", "in/a.glib"], ["publish", "in", "-o", "site"], ["gallery", "in", "-o", "site", "--live"]):
            self.assertIn("[page-E01]", self.glibra(*words, status=3))
        self.assertEqual(sorted(os.listdir(self.folder)), ["in"])

    def test_names_and_texts_of_strangers_are_data(self):
        name = "<img src=x onerror=alert(1)>'\"&{{content}}"
        self.write(f"in/{name}.glib", b"# </script><script>alert(1)</script> <!-- \xff\n" + SCENE.encode() + b"# </script>\n")
        self.glibra("publish", f"in/{name}.glib", "-o", "a.html")
        page = self.read("a.html")
        self.assertEqual([page.count(each) for each in ("<script", "</script", "<img", "<!--")], [3, 3, 1, 0])
        self.glibra("publish", "in", "-o", "site")
        for each in os.listdir(os.path.join(self.folder, "site/scenes")):
            text = self.read("site/scenes/" + each)
            self.assertEqual(re.findall(r"alert\(1\)>|<!--|<script>", text), [], each)

    def test_it_is_the_same_in_a_sandbox(self):
        self.write("in/film.glib", SCENE.replace("q.frag", "lacking.frag").replace("q.vert", "lacking.vert"))
        self.write("in/lacking.vert", VERTEX.replace("void main() {", "noperspective out vec3 v;\nvoid main() { v = vec3(.5);"))
        self.write("in/lacking.frag", LACKING)
        for each in ("in/a.glib", "in/film.glib"):
            self.glibra("publish", each, "-o", "a.html")
            run = subprocess.run([self.program, "publish", each, "-o", "b.html", "--untrusted"], cwd=self.folder, capture_output=True, text=True, check=False)
            if run.returncode == 4:
                self.skipTest(run.stderr)
            self.assertEqual((run.returncode, self.read("b.html")), (0, self.read("a.html")), run.stderr)
        self.assertIn('"film":{', self.read("b.html"))


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main(verbosity=2)
