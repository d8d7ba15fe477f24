#!/usr/bin/env python3
"""The site of a gallery in Chromium, from file://: search, chapters, films, sources in colours, light and dark, no network.

usage: gallery_test.py GLIBRA [--pictures FOLDER SITE]     (the second writes screenshots of a site to look at)
"""
import contextlib
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import webdriver
from class_test import CONTRAST, possible

PROGRAM = None
WIDTH, HEIGHT = 1366, 768
HOSTILE = possible("<img src=x onerror=document.title='hacked'>")

CLASSIC = """# SH113 Classic ball: a ball that blinks.
WindowSize 320 240
LookAt 0 0 3.4 0 0 0 0 1 0
Timer 2
Vertex ball.vert
Fragment ball.frag
Program Ball uTone <0. .8 1.> uOn <true> uTint {1 .5 .2}
Sphere 1 30 30
"""
VERTEX = """#version 330 core
// The normal, in eye space.
out vec3 vN;
void main() { vN = uNormalMatrix * aNormal; gl_Position = uModelViewProjectionMatrix * aVertex; }
"""
FRAGMENT = """#version 330 core
#include "shade.glsl"
in vec3 vN;
uniform float uTone; uniform bool uOn; uniform vec3 uTint;
out vec4 f;
void main() { f = vec4(shade(normalize(vN), uTone) * uTint * (uOn ? .4 + .6 * Timer : 1.), 1.); }
"""
SHADE = "float shade(vec3 n, float tone) { return .1 + tone * max(n.z, 0.); }\n"
MODERN = """# G7.1 Modern box: %s turns about itself.
WindowSize 300 300
Background .1 .1 .1
Camera eye LookAt 0 1 4  0 0 0  0 1 0  Perspective 40 .1 10
Let size <.2 1. 2.>
Let show <plain striped>
Key k size .5
Fragment inline
#version 330 core
out vec4 f;
void main() { f = vec4(.8, .6, .2, 1.); }
EndFragment
Vertex inline
#version 330 core
void main() { gl_Position = uModelViewProjectionMatrix * aVertex; }
EndVertex
Program Box
Rotate (90*time) 0 1 0
Box (size) (size) (size)
""" % HOSTILE
TASK = MODERN.replace("# G7.1 Modern box:", "# Exercise G7.1: Make the box turn.\n#\n# 1. Use time.\n#").replace("(90*time)", "20")
TABLE = """# Scenes

| scene | what | source |
|---|---|---|
| [classic/ball](classic/ball.glib) | a ball | Book, chapters 2 and 10; Slides |
| [modern/box](modern/box.glib) | a box | Book, chapter 2 |
"""


def make_folder(folder):
    files = {"classic/ball.glib": CLASSIC, "classic/ball.vert": VERTEX, "classic/ball.frag": FRAGMENT, "classic/shade.glsl": SHADE,
             "modern/box.glib": MODERN, "tasks/b/box.glib": TASK, "tasks/b/box.toml": 'solution = "../../modern/box.glib"\n',
             "broken.glib": "# Broken: it has no shader.\nVertex none.vert\nFragment none.frag\nProgram P\nSphere 1\n",
             f"{HOSTILE.replace('/', '')}.glib": CLASSIC.replace("ball.", "classic/ball."), "README.md": TABLE}
    for name, text in files.items():
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)


class GallerySite(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.stack = contextlib.ExitStack()
        cls.folder = cls.stack.enter_context(tempfile.TemporaryDirectory())
        make_folder(os.path.join(cls.folder, "week 3"))
        made = subprocess.run([PROGRAM, "gallery", os.path.join(cls.folder, "week 3"), "-o", "made"], cwd=cls.folder, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True)
        assert made.returncode == 3, made.stderr
        # A site is copied to another place, under a name with blanks.
        cls.site = os.path.join(cls.folder, "another place", "site")
        shutil.copytree(os.path.join(cls.folder, "made"), cls.site)
        shutil.rmtree(os.path.join(cls.folder, "made"))
        shutil.rmtree(os.path.join(cls.folder, "week 3"))
        cls.browser = cls.stack.enter_context(webdriver.Browser(WIDTH, HEIGHT))
        cls.size(WIDTH, HEIGHT)
        cls.browser.requests()

    @classmethod
    def tearDownClass(cls):
        cls.stack.close()

    @classmethod
    def size(cls, width, height):
        cls.browser.command("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def setUp(self):
        self.size(WIDTH, HEIGHT)
        self.open("index.html")

    def tearDown(self):
        self.assertEqual([each["message"] for each in self.browser.logs("browser")], [], "the console is silent")
        urls = self.browser.requests()
        self.assertTrue(any("/site/" in url for url in urls), "requests are seen")
        self.assertEqual(self.browser.foreign(urls), [], "nothing is asked of the network")

    def open(self, page):
        self.browser.open("about:blank")
        self.browser.open("file://" + os.path.join(self.site, page).replace(" ", "%20"))
        self.browser.wait("return document.readyState === 'complete'")

    def type(self, text):
        self.browser.run("const search = document.getElementById('search'); search.value = arguments[0];"
                         "search.dispatchEvent(new Event('input'))", text)

    def shown(self):
        return self.browser.run("return [...document.querySelectorAll('.tile')].filter((each) => each.offsetParent)"
                                ".map((each) => each.getAttribute('href'))")

    def test_every_scene_is_shown_by_its_folder(self):
        names = self.browser.run("return [...document.querySelectorAll('section')].map((each) => [each.querySelector('h2').textContent,"
                                 "[...each.querySelectorAll('.tile b')].map((tile) => tile.textContent)])")
        folders = {name: tiles for name, tiles in names}
        self.assertEqual(folders["classic"], ["ball"])
        self.assertEqual(folders["modern"], ["box"])
        self.assertEqual(folders["tasks/b"], ["box"])
        self.assertEqual(sorted(folders["Scenes"]), sorted(["broken", HOSTILE.replace("/", "")]))
        self.assertEqual(self.browser.run("return document.title"), "week 3")
        self.assertEqual(self.browser.run("return document.getElementById('count').textContent"), "5 scenes")

    def test_the_search_finds_words_of_names_texts_values_and_chapters(self):
        for text, found in (("BALL blinks", 2), ("uTint", 2), ("chapter 10", 1), ("modern", 1), ("none", 0), ("film", 3), ("", 5)):
            self.type(text)
            self.assertEqual(len(self.shown()), found, text)
            self.assertEqual(self.browser.run("return document.getElementById('nothing').hidden"), found > 0)
            count = self.browser.run("return document.getElementById('count').textContent")
            self.assertEqual(count, f"{found} of 5 scenes" if text else "5 scenes")
        self.type("modern")
        self.assertEqual(self.browser.run("return [...document.querySelectorAll('section')].filter((each) => each.offsetParent).length"), 1)

    def test_keys_search_and_open(self):
        self.browser.press("/")
        self.assertEqual(self.browser.run("return document.activeElement.id"), "search")
        self.browser.press(*"modern")
        self.assertEqual(len(self.shown()), 1)
        self.browser.press("Escape")
        self.assertEqual(len(self.shown()), 5)
        self.browser.press(*"modern", "Enter")
        self.browser.wait("return document.readyState === 'complete' && document.querySelector('body.scene')")
        self.assertEqual(self.browser.run("return document.querySelector('h1').textContent"), "modern/box")

    def test_chapters_are_a_page_of_their_own(self):
        self.browser.run("document.querySelector('a[href=\"chapters.html\"]').click()")
        self.browser.wait("return document.readyState === 'complete' && location.href.endsWith('chapters.html')")
        chapters = self.browser.run("return [...document.querySelectorAll('section h2')].map((each) => each.textContent)")
        self.assertEqual(chapters, ["Book, chapter 2", "Book, chapter 10", "Slides"])
        self.type("ball")
        self.assertEqual(self.browser.run("return document.getElementById('count').textContent"), "1 of 5 scenes",
                         "a scene of three chapters counts once")
        self.type("")
        self.browser.run("document.querySelector('.tile').click()")
        self.browser.wait("return document.querySelector('body.scene')")

    def test_all_links_lead_to_files(self):
        pages = [os.path.join(folder, name) for folder, _, names in os.walk(self.site) for name in names if name.endswith(".html")]
        self.assertEqual(len(pages), 7)
        for page in pages:
            with open(page, encoding="utf-8") as text:
                self.assertNotIn(self.folder, text.read(), "where the scenes lie on this machine is nobody's business")
            self.open(os.path.relpath(page, self.site))
            links = self.browser.run("return [...document.querySelectorAll('[href], [src], [srcset], [data-film]')].flatMap((each) =>"
                                     "['href', 'src', 'srcset', 'data-film'].map((name) => each.getAttribute(name))).filter(Boolean)")
            for link in links:
                if link.startswith("#"):
                    self.assertTrue(self.browser.run("return !!document.getElementById(arguments[0])", link[1:]), link)
                elif not link.startswith("data:"):
                    self.assertTrue(os.path.isfile(os.path.join(os.path.dirname(page), link)), f"{page}: {link}")

    def test_a_film_plays(self):
        self.open("scenes/classic-ball.html")
        film = "document.querySelector('picture img')"
        self.browser.wait(f"return {film}.complete && {film}.naturalWidth === 200")
        still = self.browser.run("return document.querySelector('figure > img').naturalWidth")
        self.assertEqual(still, 400)
        first = self.browser.screenshot(selector="picture img")
        for _ in range(100):
            if self.browser.screenshot(selector="picture img") != first:
                return
        self.fail("its picture does not change")

    def test_a_film_plays_while_the_mouse_is_on_its_tile(self):
        image = "document.querySelector('.tile[href$=\"classic-ball.html\"] img')"
        self.assertIn("pictures/", self.browser.run(f"return {image}.getAttribute('src')"))
        x, y = self.browser.run(f"{image}.scrollIntoView({{block: 'center'}}); const box = {image}.getBoundingClientRect();"
                                "return [box.left + box.width / 2, box.top + box.height / 2]")
        self.browser.pointer(("move", x, y))
        self.browser.wait(f"return {image}.getAttribute('src') === 'films/classic-ball.png' && {image}.complete")
        self.browser.pointer(("move", 1, 1))
        self.browser.wait(f"return {image}.getAttribute('src').startsWith('pictures/')")

    def test_reduced_motion_shows_stills(self):
        self.browser.command("Emulation.setEmulatedMedia", features=[{"name": "prefers-reduced-motion", "value": "reduce"}])
        self.open("scenes/classic-ball.html")
        self.assertIn("pictures/", self.browser.run("return document.querySelector('picture img').currentSrc"))
        self.browser.command("Emulation.setEmulatedMedia", features=[])

    def test_sources_have_colours_and_lines(self):
        self.open("scenes/classic-ball.html")
        names = self.browser.run("return [...document.querySelectorAll('details summary strong')].map((each) => each.textContent)")
        self.assertEqual(names, ["classic/ball.glib", "classic/ball.vert", "classic/ball.frag", "classic/shade.glsl"])
        words = self.browser.run("return Object.fromEntries(['keyword', 'type', 'comment', 'directive', 'builtin', 'number'].map((kind) =>"
                                 "[kind, document.querySelector('.source .' + kind)?.textContent]))")
        self.assertEqual(words["comment"], "# SH113 Classic ball: a ball that blinks.")
        self.assertEqual(words["keyword"], "WindowSize")
        self.assertEqual(words["type"], "vec3")
        self.assertEqual(words["directive"], "#version 330 core")
        self.assertEqual(words["builtin"], "gl_Position")
        colors = self.browser.run("return ['keyword', 'type', 'comment', 'directive', 'builtin', 'number'].map((kind) =>"
                                  "getComputedStyle(document.querySelector('.source .' + kind)).color)")
        self.assertEqual(len(set(colors)), 6)
        text = self.browser.run("return [...document.querySelectorAll('.source')][2].innerText")
        self.assertIn('#include "shade.glsl"', text)

    def test_values_have_their_ranges(self):
        rows = "return [...document.querySelectorAll('.controls tbody tr')].map((each) => [...each.children].map((cell) => cell.textContent))"
        self.open("scenes/classic-ball.html")
        self.assertEqual(self.browser.run(rows), [["uTone", "0", "1", "0.8", "Ball"], ["uOn", "true or false", "true", "Ball"],
                                                  ["uTint", "a colour", "1 0.5 0.2", "Ball"]])
        self.open("scenes/modern-box.html")
        self.assertEqual(self.browser.run(rows), [["size", "0.2", "2", "1", "scene"], ["show", "one of plain, striped", "plain", "scene"]])
        self.assertEqual(self.browser.run("return document.querySelector('kbd').textContent"), "k")

    def test_an_exercise_and_its_solution_link_to_each_other(self):
        self.open("scenes/tasks-b-box.html")
        text = self.browser.run("return document.querySelector('.text').innerText")
        self.assertIn("Exercise G7.1: Make the box turn.", text)
        self.assertIn("1. Use time.", text)
        self.browser.click(".solution a")
        self.browser.wait("return document.querySelector('h1').textContent === 'modern/box'")
        self.browser.click(".task a")
        self.browser.wait("return document.querySelector('h1').textContent === 'tasks/b/box'")

    def test_a_broken_scene_shows_its_message(self):
        tile = self.browser.run("return document.querySelector('.tile[href$=\"broken.html\"]').innerText")
        self.assertIn("none.vert", tile)
        self.open("scenes/broken.html")
        self.assertIn("none.vert", self.browser.run("return document.querySelector('.messages').innerText"))
        self.assertIn("Sphere 1", self.browser.run("return document.querySelector('.source').innerText"))

    def test_what_strangers_wrote_is_text(self):
        for page in os.listdir(os.path.join(self.site, "scenes")):
            self.open("scenes/" + page)
            self.assertEqual(self.browser.run("return document.querySelectorAll('img[src=x], script').length"), 0)
        self.open("index.html")
        self.assertEqual(self.browser.run("return document.querySelectorAll('img[src=x]').length"), 0)
        self.assertNotEqual(self.browser.run("return document.title"), "hacked")
        self.open("scenes/modern-box.html")
        self.assertIn(HOSTILE, self.browser.run("return document.querySelector('.text').textContent"))

    def test_text_is_readable_light_and_dark(self):
        wanted = {"index.html": ["h1", ".tile b", ".tile small", ".tile .none", "#count", ".moves", "nav b", "summary"],
                  "scenes/classic-ball.html": ["h1", "nav a", ".text p", "small", ".controls th", ".controls td", ".source li"]
                  + [".source ." + each for each in ("keyword", "type", "comment", "directive", "builtin", "number")],
                  "scenes/broken.html": [".remark.error"]}
        backs = set()
        for scheme in ("light", "dark"):
            self.browser.command("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
            for page, selectors in wanted.items():
                self.open(page)
                for selector, contrast in self.browser.run(CONTRAST, selectors).items():
                    self.assertGreaterEqual(contrast, 4.5, f"{page}, {selector}, {scheme}")
            backs.add(self.browser.run("return getComputedStyle(document.body).backgroundColor"))
        self.assertEqual(len(backs), 2)
        self.browser.command("Emulation.setEmulatedMedia", features=[])

    def test_nothing_is_wider_than_the_window(self):
        for page in ("index.html", "chapters.html", "scenes/classic-ball.html", "scenes/broken.html"):
            self.open(page)
            for width, height in ((WIDTH, HEIGHT), (800, 600), (420, 900)):
                self.size(width, height)
                self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), width, page)


def pictures(folder, site):
    os.makedirs(folder, exist_ok=True)
    with webdriver.Browser(WIDTH, HEIGHT) as browser:
        pages = ["index.html", "chapters.html"] + ["scenes/" + each for each in sorted(os.listdir(os.path.join(site, "scenes")))[:200:40]]
        for scheme in ("light", "dark"):
            browser.command("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
            for page in pages:
                browser.open("file://" + os.path.abspath(os.path.join(site, page)))
                browser.wait("return document.readyState === 'complete'")
                browser.screenshot(os.path.join(folder, f"{scheme}-{os.path.basename(page)}.png"))


if __name__ == "__main__":
    if not shutil.which("chromedriver") or not shutil.which("chromium"):
        print("skipped: chromium and chromedriver are needed")
        sys.exit(77)
    PROGRAM = os.path.abspath(sys.argv[1])
    if len(sys.argv) > 4 and sys.argv[2] == "--pictures":
        pictures(*sys.argv[3:5])
    else:
        unittest.main(argv=sys.argv[:1] + sys.argv[2:], verbosity=2)
