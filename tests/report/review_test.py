#!/usr/bin/env python3
"""`glibra review --serve` in Chromium: shots that failed are looked at, accepted and rejected, by two browsers at once.

usage: review_test.py GLIBRA
"""
import contextlib
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
import urllib.error
import urllib.request

import webdriver

PROGRAM = None
SCENE = "WindowSize 48 48\nOrtho -1 1 -1 1\nSphere RADIUS\n"
SUITE = """goldens = "golden"
[[shot]]
script = "ball.glib"
time = [1, 2, 3]
[[shot]]
script = "other.glib"
[[shot]]
script = "broken.glib"
"""


class Review(unittest.TestCase):
    def setUp(self):
        self.stack = contextlib.ExitStack()
        self.folder = self.stack.enter_context(tempfile.TemporaryDirectory())
        self.write("s.toml", SUITE)
        self.scene(".5")
        self.assertEqual(self.glibra("test", "s.toml", "--update"), 0)
        self.scene(".8")
        self.write("broken.glib", "WindowSize 48 48\nSpere 1\n")
        self.assertEqual(self.glibra("test", "s.toml"), 3)
        self.serve()
        self.stack.callback(self.end)

    def serve(self):
        self.server = subprocess.Popen([PROGRAM, "review", "glibra-results", "--serve"], cwd=self.folder,
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.address = self.server.stdout.readline().strip()

    def restart(self):
        self.end()
        self.serve()

    def tearDown(self):
        self.stack.close()

    def end(self):
        self.server.send_signal(signal.SIGINT)
        self.assertEqual(self.server.wait(10), 0)
        self.server.stdout.close()
        self.server.stderr.close()

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    def scene(self, radius):
        for name in ("ball", "other", "broken"):
            self.write(name + ".glib", SCENE.replace("RADIUS", radius))

    def glibra(self, *arguments):
        return subprocess.run([PROGRAM, *arguments], cwd=self.folder, capture_output=True, check=False).returncode

    def golden(self, name):
        with open(os.path.join(self.folder, "golden", name + ".png"), "rb") as file:
            return file.read()

    def open(self):
        browser = self.stack.enter_context(webdriver.Browser())
        browser.open(self.address)
        browser.wait("return document.body.dataset.ready === '0'")
        self.seen(browser, 0)
        return browser

    @staticmethod
    def seen(browser, shot):
        browser.wait("return (document.body.dataset.seen || '').split(' ').includes(arguments[0])", str(shot))

    @staticmethod
    def key(browser, key):
        browser.run("document.dispatchEvent(new KeyboardEvent('keydown', {key: arguments[0]}))", key)

    @staticmethod
    def said(browser, text):
        browser.wait("return document.querySelector('#said').textContent.includes(arguments[0])", text)

    def test_shots_are_accepted_and_rejected_by_key(self):
        browser = self.open()
        groups = browser.run("return [...document.querySelectorAll('#list h2')].map((each) => each.textContent)")
        self.assertEqual(groups, ["ball.glib: differences (3)", "other.glib: differences (1)", "broken.glib: failed (1)"])
        before = self.golden("ball@time=1")
        sources = "return [...document.querySelectorAll('#pictures img')].map((each) => each.src.split('what=')[1])"
        self.assertEqual(browser.run(sources), ["expected", "got"])
        self.key(browser, "x")
        browser.wait("return document.body.dataset.ready === '0'")
        self.assertEqual(browser.run(sources), ["got", "expected"])
        self.key(browser, "w")
        browser.wait("return document.body.dataset.ready === '0' && document.querySelectorAll('.layers img').length === 2")
        wiped = browser.screenshot(selector=".layers")
        browser.run("const wipe = document.querySelector('#wipe'); wipe.value = 100; wipe.dispatchEvent(new Event('input'));")
        self.assertNotEqual(browser.screenshot(selector=".layers"), wiped)
        self.key(browser, "w")
        browser.wait("return document.body.dataset.ready === '0'")
        self.key(browser, "r")
        self.said(browser, "1 rejected")
        browser.wait("return document.body.dataset.ready === '1'")
        self.assertEqual(self.golden("ball@time=1"), before)
        self.seen(browser, 1)
        self.key(browser, "a")
        self.said(browser, "1 accepted")
        browser.wait("return document.body.dataset.ready === '2'")
        self.assertNotEqual(self.golden("ball@time=2"), before)
        self.seen(browser, 2)
        self.key(browser, "b")
        self.said(browser, "1 accepted")
        self.assertTrue(os.path.exists(os.path.join(self.folder, "golden", "ball@time=3.also1.png")))
        self.assertEqual(self.golden("ball@time=3"), before)
        self.write("broken.glib", SCENE.replace("RADIUS", ".5"))
        self.assertEqual(self.glibra("test", "s.toml", "--only", "ball@time=2", "--only", "ball@time=3"), 0)
        self.assertEqual(self.glibra("test", "s.toml", "--only", "ball@time=1"), 1)

    def test_what_is_accepted_is_what_update_writes(self):
        browser = self.open()
        self.key(browser, "a")
        self.said(browser, "1 accepted")
        accepted = self.golden("ball@time=1")
        self.glibra("test", "s.toml", "--only", "ball@time=2", "--update")
        self.assertEqual(accepted, self.golden("ball@time=2"), "both show the same picture")
        with open(os.path.join(self.folder, "golden", "s.hashes"), encoding="utf-8") as file:
            lines = {each.split(" ", 1)[0]: each.split(" ", 1)[1] for each in file if each.startswith("ball@")}
        self.assertEqual(lines["ball@time=1"], lines["ball@time=2"], "and have the same line in the list of hashes")
        self.glibra("test", "s.toml", "--only", "ball@time=1", "--results", "again")
        with open(os.path.join(self.folder, "again", "results.jsonl"), encoding="utf-8") as file:
            self.assertIn('"exact":true,"changed":false', file.read(), "the hash decides")

    def test_decisions_survive_a_restart_as_long_as_their_pictures_are_the_same(self):
        browser = self.open()
        self.key(browser, "r")
        self.said(browser, "1 rejected")
        browser.wait("return document.body.dataset.ready === '1'")
        self.seen(browser, 1)
        self.key(browser, "a")
        self.said(browser, "1 accepted")
        browser.run("document.querySelector('[data-shot=\"4\"]').click()")
        browser.wait("return document.body.dataset.ready === '4'")
        self.key(browser, "r")
        self.said(browser, "1 rejected")
        listed = subprocess.run([PROGRAM, "review", "glibra-results"], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(listed.returncode, 1)
        self.assertIn("rejected: s/ball@time=1", listed.stdout)
        decided = "return [...document.querySelectorAll('#list button')].map((each) => each.dataset.decided)"
        self.restart()
        self.assertEqual(self.open().run(decided), ["rejected", "accepted", "", "", "rejected"])
        # Results of others do not make a picture accepted, and a golden that was restored is not the picture any more.
        path = os.path.join(self.folder, "glibra-results", "review.json")
        with open(path, encoding="utf-8") as file:
            text = file.read()
        with open(path, "w", encoding="utf-8") as file:
            file.write(text.replace('"rejected"', '"accepted"'))
        os.replace(os.path.join(self.folder, "golden", "ball@time=1.png"), os.path.join(self.folder, "golden", "ball@time=2.png"))
        self.restart()
        self.assertEqual(self.open().run(decided), ["", "", "", "", ""])
        for wrong in ("[]", "{", '{"s/ball@time=1": 3}', '{"s/ball@time=1": [1, 2]}', ""):
            with open(path, "w", encoding="utf-8") as file:
                file.write(wrong)
            self.assertEqual(self.glibra("review", "glibra-results"), 1, wrong)

    def test_pictures_of_a_group_that_nobody_has_scrolled_to_are_not_accepted(self):
        times = ", ".join(str(each) for each in range(40))
        self.write("s.toml", SUITE.replace("time = [1, 2, 3]", "time = [%s]\nsize = [300, 300]" % times))
        self.scene(".5")
        self.glibra("test", "s.toml", "--update")
        self.scene(".8")
        self.glibra("test", "s.toml")
        self.restart()
        browser = self.open()
        self.key(browser, "g")
        browser.wait("return document.body.dataset.ready === '0' && document.querySelectorAll('#pictures img').length === 80")
        browser.wait("return document.body.dataset.seen.split(' ').length > 1")
        self.key(browser, "A")
        self.said(browser, "nobody has looked at its picture")
        said = browser.run("return document.querySelector('#said').textContent").splitlines()
        self.assertEqual(len(said), 2, "what was accepted, and one line for all others")
        accepted = "return document.querySelectorAll('[data-decided=accepted]').length"
        first = browser.run(accepted)
        self.assertTrue(1 <= first < 40, first)
        browser.wait("return document.body.dataset.ready !== ''")
        for _ in range(60):
            browser.run("document.querySelector('main').scrollBy(0, 150)")
            browser.run("return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
        browser.wait("return document.body.dataset.seen.split(' ').length === 40")
        self.key(browser, "A")
        self.said(browser, "accepted")
        browser.wait(accepted + " === 40")

    def test_a_group_is_accepted_at_once_and_another_browser_sees_it(self):
        first, second = self.open(), self.open()
        self.key(first, "g")
        first.wait("return document.body.dataset.ready === '0' && document.querySelectorAll('#pictures img').length === 6")
        self.key(first, "A")
        self.said(first, "3 accepted")
        self.key(second, "a")
        self.said(second, "it has been accepted already")
        self.assertEqual(second.run("return document.querySelectorAll('[data-decided=accepted]').length"), 3)
        self.assertEqual(self.glibra("test", "s.toml", "--only", "ball"), 0)

    def test_a_group_is_small_pictures_with_their_goldens_and_alike_ones_together(self):
        browser = self.open()
        self.key(browser, "g")
        browser.wait("return document.body.dataset.ready === '0' && document.querySelectorAll('#pictures img').length === 6")
        kinds = "return [...document.querySelectorAll('#pictures img')].map((each) => each.src.split('what=')[1])"
        self.assertEqual(browser.run(kinds), ["expected", "got"] * 3)
        self.assertEqual(browser.run("return [...document.querySelectorAll('#pictures img')].map((each) => each.clientWidth)"), [48] * 6)
        heads = browser.run("return [...document.querySelectorAll('#pictures h2')].map((each) => each.textContent)")
        self.assertEqual(len(heads), 1, heads)
        self.assertRegex(heads[0], r"^3 × .* of 255 .* % of the pixels Accept these 3$")
        self.key(browser, "x")
        browser.wait("return document.body.dataset.ready === '0'")
        self.assertEqual(browser.run(kinds), ["got", "expected"] * 3)
        self.key(browser, "d")
        browser.wait("return document.body.dataset.ready === '0'")
        self.assertEqual(browser.run(kinds), ["got", "difference"] * 3, "the group stays")
        browser.wait("return document.body.dataset.seen.split(' ').length === 3")
        browser.run("document.querySelector('#pictures h2 button').click()")
        self.said(browser, "3 accepted")
        self.assertEqual(self.glibra("test", "s.toml", "--only", "ball"), 0)

    VERTEX = "#version 330\nin vec4 aVertex;\nvoid main() { gl_Position = vec4(aVertex.xy, 0., 1.); }\n"
    FRAGMENT = '#version 330\n#include "common.glsl"\nout vec4 o;\nvoid main() { o = vec4(shade() * PART, gl_FragCoord.x / 64., 0., 1.); }\n'

    def shaded(self):
        """Four scenes of one vertex shader, two of each fragment shader, and what both include."""
        self.write("all.vert", self.VERTEX)
        self.write("common.glsl", "float shade() { return .5; }\n")
        for part in ("1", "2"):
            self.write("f%s.frag" % part, self.FRAGMENT.replace("PART", "." + part))
            for name in ("a", "b"):
                self.write(name + part + ".glib", "WindowSize 48 48\nVertex all.vert\nFragment f%s.frag\nProgram P\nQuadXY 0 1\n" % part)
        self.write("s.toml", 'goldens = "golden"\n[[shot]]\nscript = "[ab]*.glib"\nexcept = "b*n.glib"\n')
        os.remove(os.path.join(self.folder, "ball.glib"))
        self.assertEqual(self.glibra("test", "s.toml", "--update"), 0)

    def causes(self):
        self.glibra("test", "s.toml")
        listed = subprocess.run([PROGRAM, "review", "glibra-results"], cwd=self.folder, capture_output=True, text=True, check=False)
        return [line for line in listed.stdout.splitlines() if not line.startswith(" ")]

    def test_files_that_have_changed_since_the_golden_are_the_cause(self):
        self.shaded()
        self.write("common.glsl", "float shade() { return .9; }\n")
        self.assertEqual(self.causes(), ["common.glsl: differences (4)"])
        self.assertEqual(self.glibra("test", "s.toml", "--update"), 0)
        for part in ("1", "2"):
            self.write("f%s.frag" % part, self.FRAGMENT.replace("PART", ".6"))
        self.assertEqual(sorted(self.causes()), ["f1.frag: differences (2)", "f2.frag: differences (2)"])

    def test_git_knows_what_has_changed_since_the_commit_of_the_golden(self):
        if not shutil.which("git"):
            self.skipTest("git is missing")
        self.shaded()
        git = lambda *words: subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b", *words], cwd=self.folder, check=True,
                                            capture_output=True)
        git("init", "-q")
        git("add", ".")
        git("commit", "-qm", "goldens")
        self.write("f1.frag", self.FRAGMENT.replace("PART", ".6"))
        git("commit", "-qam", "a shader")
        # As in a fresh clone, all files are of one time, or of any.
        for name in os.listdir(self.folder):
            os.utime(os.path.join(self.folder, name))
        self.write("f2.frag", self.FRAGMENT.replace("PART", ".7"))
        self.assertEqual(sorted(self.causes()), ["f1.frag: differences (2)", "f2.frag: differences (2)"])

    def test_without_a_file_that_has_changed_all_that_is_shared_is_named(self):
        self.shaded()
        self.write("common.glsl", "float shade() { return .9; }\n")
        for folder, _, names in os.walk(os.path.join(self.folder, "golden")):
            for name in names:
                os.utime(os.path.join(folder, name))
        self.assertEqual(self.causes(), ["all.vert, common.glsl: differences (4)"])

    def test_a_changed_pass_can_be_looked_at(self):
        self.scene(".5")
        path = os.path.join(self.folder, "golden", "s.hashes")
        with open(path, encoding="utf-8") as file:
            text = file.read()
        line = next(each for each in text.splitlines() if each.startswith("other "))
        words = line.split(" ")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text.replace(line, " ".join([*words[:3], "0" * 32, *words[4:]])))
        self.assertEqual(self.glibra("test", "s.toml", "--report", "report"), 0)
        self.assertEqual(self.glibra("review", "glibra-results"), 0, "it is no failure")
        self.restart()
        browser = self.open()
        groups = browser.run("return [...document.querySelectorAll('#list h2')].map((each) => each.textContent)")
        self.assertEqual(groups, ["other.glib: changed within the tolerance (1)"])
        self.assertEqual(browser.run("return document.querySelectorAll('#pictures img').length"), 2)
        with open(os.path.join(self.folder, "report", "index.html"), encoding="utf-8") as file:
            self.assertRegex(file.read(), r'"shot":"other"[^}]*"got":"pictures/')

    def post(self, path, body, **headers):
        request = urllib.request.Request(self.address + path, body.encode(), {"Content-Type": "application/json", **headers})
        try:
            with urllib.request.urlopen(request) as reply:
                return reply.status, reply.read().decode()
        except urllib.error.HTTPError as problem:
            return problem.code, problem.read().decode()

    def test_nothing_is_accepted_unseen_or_from_elsewhere(self):
        before = self.golden("ball@time=1")
        self.assertIn("nobody has looked", self.post("accept", '{"shots": [0]}')[1])
        self.assertEqual(self.post("see", '{"shots": [0]}')[0], 200)
        self.assertIn("nobody has looked", self.post("accept", '{"shots": [0]}')[1], "no browser has its picture")
        urllib.request.urlopen(self.address + "picture?shot=1&what=got").close()
        self.assertIn("nobody has looked", self.post("accept", '{"shots": [1]}')[1], "it was fetched, but not in view")
        self.assertEqual(self.post("see", '{"shots": [99]}')[0], 400)
        for body in ('{"shots": [99]}', '{"shots": ["0"]}', '{"shots": [-1]}', "[]", "", "{", '{"shots": [0.5]}'):
            self.assertEqual(self.post("accept", body)[0], 400, body)
        self.assertEqual(self.post("accept", '{"shots": [0]}', Origin="http://evil.example")[0], 403)
        self.assertEqual(self.post("accept", "shots=0", **{"Content-Type": "application/x-www-form-urlencoded"})[0], 415)
        for what in ("../s.toml", "golden", "", "got&shot=1"):
            with self.assertRaises(urllib.error.HTTPError) if what != "got&shot=1" else contextlib.nullcontext():
                urllib.request.urlopen(self.address + "picture?shot=0&what=" + what).close()
        for shot in ("-1", "99", "0]}", "x", "0,1"):
            with self.assertRaises(urllib.error.HTTPError):
                urllib.request.urlopen(self.address + "picture?what=got&shot=" + shot).close()
        self.assertEqual(self.golden("ball@time=1"), before)
        # A picture that has changed since it was shown is another picture.
        urllib.request.urlopen(self.address + "picture?shot=0&what=got").close()
        self.post("see", '{"shots": [0]}')
        results = os.path.join(self.folder, "glibra-results", "s")
        os.replace(os.path.join(results, "other.expected.png"), os.path.join(results, "ball@time=1.got.png"))
        self.assertIn("has changed since", self.post("accept", '{"shots": [0]}')[1])
        self.assertEqual(self.golden("ball@time=1"), before)
        self.assertIn("there is no picture", self.post("accept", '{"shots": [4]}')[1])

    def test_results_that_name_files_elsewhere_show_and_write_nothing_there(self):
        self.end_and_restart(lambda text: re.sub(r'"got":"[^"]*"', '"got":"/etc/hostname"', text))
        with self.assertRaises(urllib.error.HTTPError):
            urllib.request.urlopen(self.address + "picture?shot=0&what=got").close()
        with tempfile.TemporaryDirectory() as elsewhere:
            suite = os.path.join(elsewhere, "s.toml")
            with open(suite, "w", encoding="utf-8") as file:
                file.write("goldens = \"golden\"\n[[shot]]\nscript = \"%s/ball.glib\"\n" % self.folder)
            self.end_and_restart(lambda text: text.replace('"file":"s.toml"', '"file":"%s"' % suite))
            urllib.request.urlopen(self.address + "picture?shot=3&what=got").close()
            self.post("see", '{"shots": [3]}')
            self.assertIn("no such shot", self.post("accept", '{"shots": [3]}')[1])
            self.assertFalse(os.path.exists(os.path.join(elsewhere, "golden")))

    def end_and_restart(self, change):
        self.glibra("test", "s.toml")
        path = os.path.join(self.folder, "glibra-results", "results.jsonl")
        with open(path, encoding="utf-8") as file:
            text = change(file.read())
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        self.restart()


if __name__ == "__main__":
    if not shutil.which("chromedriver") or not shutil.which("chromium"):
        print("skipped: chromium and chromedriver are needed")
        sys.exit(77)
    PROGRAM = os.path.abspath(sys.argv[1])
    unittest.main(argv=sys.argv[:1])
