#!/usr/bin/env python3
"""Films as `glibra publish` writes them, opened from the disk in Chromium: what they show is what `glibra render` draws.

usage: film_test.py GLIBRA [TEST...]
"""
import base64
import io
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

from PIL import Image

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "report"))
import webdriver  # noqa: E402

GLIBRA = None
SIZE = "64x48"
# Red: the time. Green: a value of a shared uniform. Blue: a value of the scene. The block is what WebGL 2 lacks.
SCENE = """# A film.
WindowSize 640 480
Ortho -1 1 -1 1
Let blue <0. .2 1.>
Let kind <plain striped>
Let vector <0. .5 .25 1.>
Let color {1. 0. 0.}
Buffer Values Value [ 1 ]
{timer}
Vertex q.vert
Fragment q.frag
Program P uGreen <0. .5 1.> uBlue blue uOn <true> uCount <1 2 3> uKind kind uVector vector uSame <0. .5 1.>
QuadXY 0 1
"""
VERTEX = "#version 430\nvoid main() { gl_Position = vec4(aVertex.xy, 0., 1.); }\n"
FRAGMENT = """#version 430
struct Value { float one; };
layout(std430) readonly buffer Values { Value values[]; };
uniform float uGreen, uBlue, uSame;
uniform bool uOn;
uniform int uCount, uKind;
uniform vec2 uVector;
out vec4 c;
void main() {
    c = vec4({red}, uGreen, uOn ? uBlue : 1., 1.) * values[0].one;
    c.rgb += uSame * (values[0].one - 1.);  // 0
    if (gl_FragCoord.x < 10.) c.r = float(uCount) * .25;
    if (uKind == 1 && mod(gl_FragCoord.y, 8.) < 4.) c.rgb = vec3(1.);
    if (gl_FragCoord.x > 50.) c = vec4(uVector, 0., 1.);
}
"""
STEPS = """WindowSize 64 48
Vertex q.vert
Fragment cells.frag
Program Cells
Texture2D cells 64 48 rgba8
Compute count.comp
Program Count uCells cells
Step 10
    Dispatch Count over cells
EndStep
"""
MOVED = "[type=range][aria-label='{}']"
PICTURE = "const shown = document.querySelector('canvas'); return shown ? shown.toDataURL() : ''"


class Film(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = webdriver.Browser(1200, 900).__enter__()
        cls.browser.command("Page.addScriptToEvaluateOnNewDocument", source="""globalThis.violations = [];
            document.addEventListener("securitypolicyviolation", (event) => violations.push(event.violatedDirective));""")

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="glibra-film-")
        self.write("q.vert", VERTEX)
        self.scene()
        self.browser.logs("browser")
        self.browser.requests()

    def tearDown(self):
        shutil.rmtree(self.folder)
        self.assertEqual([each["message"] for each in self.browser.logs("browser") if each["level"] == "SEVERE"], [])
        self.assertEqual(self.browser.foreign(self.browser.requests()), [])

    def write(self, name, text):
        os.makedirs(os.path.dirname(os.path.join(self.folder, name)), exist_ok=True)
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    def read(self, name):
        with open(os.path.join(self.folder, name), encoding="utf-8", errors="surrogateescape") as file:
            return file.read()

    def scene(self, timer="Timer 2", red="Timer", name="a.glib"):
        self.write(name, SCENE.replace("{timer}", timer))
        self.write("q.frag", FRAGMENT.replace("{red}", red))

    def glibra(self, *words, status=0):
        run = subprocess.run([GLIBRA, *words], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, status, run.stderr)
        return run.stderr

    def publish(self, *words, scene="a.glib", size=SIZE):
        self.glibra("publish", scene, "-o", "page.html", "--size", size, *words)
        self.page = self.read("page.html")
        return json.loads(re.search(r'id="glibra-scene">(.*?)</script>', self.page, re.DOTALL)[1])

    def rendered(self, *words, scene="a.glib", size=SIZE):
        self.glibra("render", scene, "-o", "picture.png", "--samples", "4", "--size", size, *words)
        return self.pixels(os.path.join(self.folder, "picture.png"))

    @staticmethod
    def pixels(file):
        with Image.open(file) as picture:
            return picture.size, picture.convert("RGB").tobytes()

    @staticmethod
    def pictures(film):
        """The pixels of all pictures."""
        all_pictures = [Image.open(io.BytesIO(base64.b64decode(each))) for each in film["pictures"]]
        for i in film["parts"]:
            whole = all_pictures[0].convert("RGBA")
            whole.alpha_composite(all_pictures[i].convert("RGBA"))
            all_pictures[i] = whole
        return [(each.size, each.convert("RGB").tobytes()) for each in all_pictures]

    def open(self, hash="", name="page.html", played=False):
        self.browser.open("about:blank")
        self.browser.open(f"file://{self.folder}/{name}{hash}")
        self.browser.wait("return document.querySelector('canvas')?.isConnected && !document.querySelector('.bar').hidden")
        if not played and self.browser.run("return document.querySelector('[title^=Pause]') !== null && !document.querySelector('.time').hidden"):
            self.browser.click("[title^=Pause]")

    def shown(self):
        return self.pixels(io.BytesIO(base64.b64decode(self.browser.run(PICTURE).split(",")[1])))

    def shows(self, wanted):
        end = time.time() + 10
        while self.shown() != wanted:
            self.assertLess(time.time(), end, "the picture never comes")
            time.sleep(0.05)

    def set(self, selector, value):
        self.browser.run("""const field = document.querySelector(arguments[0]);
            if (field.type === "checkbox") field.checked = arguments[1]; else field.value = arguments[1];
            for (const each of ["input", "change"]) field.dispatchEvent(new Event(each, {bubbles: true}));""", selector, value)

    def number(self, label):
        return float(self.browser.run("return document.querySelector(arguments[0]).value", f"[aria-label='{label}, number']"))

    # ---- The data of the film

    def test_all_pictures_are_those_of_render(self):
        data = self.publish("--frames", "6")
        film = data["film"]
        pictures = self.pictures(film)
        self.assertEqual((film["begin"], film["length"], len(film["frames"])), (0, 2, 6))  # once round
        for i, picture in enumerate(film["frames"]):
            self.assertEqual(pictures[picture], self.rendered("--time", str(2 * i / 6)), i)
        knobs = {each["name"]: each for each in film["knobs"]}
        self.assertEqual(len(knobs.pop("color")["words"]), 8)
        self.assertEqual(sorted(knobs), ["blue", "kind", "uCount", "uGreen", "uOn", "uSame", "vector"])
        self.assertEqual(knobs["uCount"]["stops"], [[1, 2, 3]])
        self.assertEqual(knobs["kind"]["stops"], [[0, 1]])
        self.assertEqual(knobs["uOn"]["stops"], [[0, 1]])
        self.assertEqual(knobs["uGreen"]["stops"][0][0], 0)
        self.assertIn(0.5, knobs["uGreen"]["stops"][0])
        self.assertEqual(len(knobs["vector"]["stops"]), 2)
        for name, knob in knobs.items():
            for component, stops in enumerate(knob["stops"]):
                self.assertEqual(stops, sorted(stops))
                for stop, picture in zip(stops, knob["pictures"][component], strict=True):
                    values = knob["initial"][:component] + [stop] + knob["initial"][component + 1:]
                    text = knob["words"][int(stop)] if "words" in knob else ("false", "true")[int(stop)] if name == "uOn" else ",".join(map(repr, values))
                    self.assertEqual(pictures[picture], self.rendered("--set", f"{name}={text}"), (name, values))
        self.assertEqual(len(set(pictures)), len(pictures))
        self.assertEqual(set(knobs["uSame"]["pictures"][0]), {0})

    def test_it_begins_at_the_values_and_the_time_of_the_command(self):
        film = self.publish("--frames", "3", "--seconds", "1.5", "--time", ".25", "--set", "uGreen=.7", "--set", "blue=.9")["film"]
        pictures = self.pictures(film)
        self.assertEqual([pictures[each] for each in film["frames"]],
                         [self.rendered("--time", time, "--set", "uGreen=.7", "--set", "blue=.9") for time in (".25", ".75", "1.25")])
        knob = next(each for each in film["knobs"] if each["name"] == "uGreen")
        self.assertEqual(knob["initial"], [0.7])
        self.assertEqual(pictures[knob["pictures"][0][0]], self.rendered("--time", ".25", "--set", "uGreen=0", "--set", "blue=.9"))
        self.open("#:blue=0")
        self.browser.wait("return document.querySelector('.seconds').value === '0.25'")
        self.browser.element("[title='Restart at 0.25 seconds']")
        self.shows(self.rendered("--time", ".25", "--set", "uGreen=.7", "--set", "blue=0"))

    def test_steps_are_one_run_in_order(self):
        self.write("count.comp", """#version 430
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba8) uniform image2D uCells;
void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    vec4 c = imageLoad(uCells, at);
    imageStore(uCells, at, vec4(fract(c.r + (float(at.x % 7) + 1.) / 64.), c.g + 1. / 255., .5, 1.));
}
""")
        self.write("cells.frag", "#version 430\nuniform sampler2D uCells; out vec4 c;\nvoid main() { c = texelFetch(uCells, ivec2(gl_FragCoord.xy), 0); }\n")
        self.write("s.glib", STEPS.replace("Program Cells", "Program Cells uCells cells") + "Ortho -1 1 -1 1\nQuadXY 0 1\n")
        text = self.read("s.glib").splitlines()
        order = [each for each in text if each.startswith("Texture2D")] + [each for each in text if not each.startswith("Texture2D")]
        self.write("s.glib", "\n".join(order) + "\n")
        film = self.publish("--frames", "12", scene="s.glib")["film"]
        self.assertEqual((film["length"], len(film["frames"])), (3, 12))
        pictures = self.pictures(film)
        self.glibra("render", "s.glib", "-o", "f.png", "--samples", "4", "--size", SIZE, "--frames", "12", "--fps", "4")
        for i, each in enumerate(film["frames"]):
            self.assertEqual(pictures[each], self.pixels(os.path.join(self.folder, f"f_{i:04}.png")), i)
        self.assertGreater(len(pictures), 8)

    def test_what_nothing_moves_is_one_picture(self):
        self.write("still.glib", "WindowSize 40 30\nOrtho -1 1 -1 1\nBuffer Values Value [ 1 ]\nVertex q.vert\nFragment q.frag\nProgram P\nQuadXY 0 1\n")
        self.scene(red="0.")
        film = self.publish(scene="still.glib")["film"]
        self.assertEqual((len(film["pictures"]), film["frames"], film["knobs"]), (1, [0], []))
        self.assertIn("This is a picture, because", self.page)
        self.open()
        self.shows(self.rendered(scene="still.glib"))
        self.assertTrue(self.browser.run("return document.querySelector('.time').hidden && document.querySelector('.panel').hidden"))

    def test_a_value_that_cannot_be_drawn_is_left_out(self):
        self.write("a.glib", SCENE.replace("{timer}", "").replace("[ 1 ]", "[ 1 ]\nLet size <1 2 5>\nTexture2D t (size * 30000) 2 rgba8")
                   .replace("uBlue blue", "uBlue blue uTexture t"))
        self.write("q.frag", FRAGMENT.replace("{red}", "textureLod(uTexture, vec2(0.), 0.).r").replace("out vec4 c", "uniform sampler2D uTexture; out vec4 c"))
        self.glibra("publish", "a.glib", status=3)  # already the first picture cannot be drawn
        self.write("a.glib", self.read("a.glib").replace("30000", "6000"))
        message = self.glibra("publish", "a.glib", "-o", "page.html", "--size", SIZE)
        self.assertRegex(message, r"warning: the film is without size=[\d.]+: .*\[page-W02\]")
        self.open()
        self.browser.element("[aria-label='size']")

    # ---- The page

    def test_colours_keys_and_cameras_are_choices(self):
        self.write("b.glib", SCENE.replace("{timer}", "Camera side LookAt 0 0 3  0 0 0  0 1 0  Ortho -4 4 -4 4 1 9\nCamera eye LookAt 0 0 3  0 0 0  0 1 0  Ortho -1 1 -1 1 1 9\n"
                                           "Let level 0.\nKey l level .25 1\nLet plain .5\nVertex camera.vert\n")
                   .replace("Vertex q.vert\n", "").replace("Ortho -1 1 -1 1\n", "", 1)
                   .replace("uSame <0. .5 1.>", "uSame <0. .5 1.> uTint color uLevel level uPlain plain"))
        self.write("camera.vert", VERTEX.replace("vec4(aVertex.xy, 0., 1.)", "uModelViewProjectionMatrix * aVertex"))
        self.write("q.frag", FRAGMENT.replace("{red}", "uLevel").replace("out vec4 c;", "uniform vec3 uTint; uniform float uLevel, uPlain; out vec4 c;")
                   .replace("    if (uKind", "    if (gl_FragCoord.y < 10.) c.rgb = uTint * uPlain * 2.;\n    if (uKind"))
        told = self.glibra("publish", "b.glib", "-o", "page.html", "--size", SIZE)
        self.assertRegex(told, r"note: the film has no pictures over 'plain': give a range")
        film = self.publish(scene="b.glib")["film"]
        pictures = self.pictures(film)
        first, plain = self.rendered(scene="b.glib"), ["of the scene", "black", "red", "green", "yellow", "blue", "magenta", "cyan", "white"]
        knobs = {each["name"]: each for each in film["knobs"]}
        self.assertEqual(knobs["color"]["words"], [each for each in plain if each != "red"])  # it is red
        self.assertEqual(knobs["level"]["words"], ["of the scene", "0.25", "1"])
        self.assertEqual(knobs["Camera"]["words"], ["of the scene", "eye", "side"])
        self.assertEqual(pictures[0], first)
        for name, index, value in (("color", 2, "0,1,0"), ("color", 7, "1,1,1"), ("level", 1, ".25"), ("level", 2, "1")):
            self.assertEqual(pictures[knobs[name]["pictures"][0][index]], self.rendered("--set", f"{name}={value}", scene="b.glib"), name)
        self.assertEqual(pictures[knobs["Camera"]["pictures"][0][1]], first)  # the last one is the scene's own
        self.assertNotEqual(pictures[knobs["Camera"]["pictures"][0][2]], first)

    def test_one_control_moves_at_a_time(self):
        self.publish("--frames", "8")
        self.open()
        self.set(MOVED.format("blue"), "1")
        self.shows(self.rendered("--set", "blue=1"))
        self.assertEqual(self.number("blue"), 1)
        self.set(MOVED.format("uGreen of P"), "0")
        self.shows(self.rendered("--set", "uGreen=0"))
        self.assertEqual((self.number("blue"), self.number("uGreen of P")), (0.2, 0))
        self.set("[aria-label='kind']", "striped")
        self.shows(self.rendered("--set", "kind=striped"))
        self.assertEqual(self.number("uGreen of P"), 0.5)
        self.set("[aria-label='uOn of P']", False)
        self.shows(self.rendered("--set", "uOn=false"))
        self.set("[aria-label='uCount of P, number']", "2.6")
        self.shows(self.rendered("--set", "uCount=3"))
        self.set(MOVED.format("vector, y"), "1")
        self.shows(self.rendered("--set", "vector=.5,1"))
        self.set(MOVED.format("vector, x"), "1")
        self.shows(self.rendered("--set", "vector=1,.25"))
        self.set(".scrub", "3")
        self.shows(self.rendered("--time", ".75"))
        self.assertEqual(self.number("vector, x"), 0.5)
        self.set(MOVED.format("blue"), "1")
        self.shows(self.rendered("--set", "blue=1"))
        self.assertEqual(self.browser.run("return [document.querySelector('.seconds').value, document.querySelector('.scrub').value]"), ["0.00", "0"])
        self.browser.click(".reset-all")
        self.shows(self.rendered())

    def test_a_slider_moves_by_keys_from_picture_to_picture(self):
        self.publish("--frames", "1")
        self.open()
        self.browser.run("document.querySelector(arguments[0]).focus()", MOVED.format("blue"))
        self.browser.press("\ue014")  # right
        first = self.number("blue")
        self.assertGreater(first, 0.2)
        self.shows(self.rendered("--set", f"blue={first}"))
        self.browser.press("\ue014")
        self.assertGreater(self.number("blue"), first)

    def test_time_plays_again_and_again_and_stands_still(self):
        self.publish("--frames", "4", "--seconds", ".4")
        self.open(played=True)
        self.browser.run("""globalThis.seen = []; const each = () => { seen.push(Number(document.querySelector(".seconds").value)); requestAnimationFrame(each); }; each();""")
        self.browser.wait("return seen.some((each, i) => i > 0 && each < seen[i - 1])")
        self.assertEqual(self.browser.run("return [...new Set(seen)].sort()"), [0, 0.1, 0.2, 0.3])
        self.browser.press(" ")
        self.set(".seconds", "0.25")
        self.shows(self.rendered("--time", ".2"))
        self.browser.press(".")
        self.shows(self.rendered("--time", ".30000000000000004"))
        self.browser.press(".")
        self.shows(self.rendered("--time", ".30000000000000004"))
        self.browser.press(",")
        self.shows(self.rendered("--time", ".2"))
        self.browser.click("[title='Restart at 0 seconds']")
        self.browser.wait("return document.querySelector('.seconds').value === '0.00'")
        # A value holds the time; to play lets go of the value.
        self.set(MOVED.format("blue"), "1")
        self.shows(self.rendered("--set", "blue=1"))
        self.browser.press(" ")
        self.browser.wait("return document.querySelector(\"[aria-label='blue, number']\").value === '0.2'")

    def test_a_link_shows_what_one_saw(self):
        self.publish("--frames", "8")
        self.open("#P:uGreen=1")
        self.shows(self.rendered("--set", "uGreen=1"))
        self.set(MOVED.format("blue"), "0")
        self.browser.wait("return location.hash === '#:blue=0&time=0'")
        self.open(self.browser.run("return location.hash"))
        self.shows(self.rendered("--set", "blue=0"))
        self.set(".seconds", "1.3")
        self.browser.wait("return location.hash === '#time=1.25'")
        self.open("#time=1.25&eye=1,0,0,0,0,1,0,0,0,0,1,0,0,0,-3,1&projection=orthographic&speed=2")
        self.shows(self.rendered("--time", "1.25"))
        self.browser.wait("return location.hash === '#time=1.25&speed=2'")
        for key in "rcp124":
            self.browser.press(key)
        self.assertEqual(self.browser.run("return location.hash"), "#time=1.25&speed=2")
        self.browser.run("location.hash = '#:vector=0.5,1'")
        self.shows(self.rendered("--set", "vector=.5,1"))

    def test_sources_are_in_colours_and_cannot_be_changed(self):
        self.publish()
        self.open()
        self.assertEqual(self.browser.run("return [...document.querySelectorAll('[role=tab]')].map((each) => each.textContent)"), ["a.glib", "q.vert", "q.frag"])
        self.assertEqual(self.browser.run("return document.querySelector('.lines .keyword').textContent"), "WindowSize")
        self.browser.run("document.querySelector('textarea').focus()")
        before = self.browser.run("return document.querySelector('textarea').value")
        self.browser.press("x", "Enter")
        self.assertEqual(self.browser.run("return document.querySelector('textarea').value"), before)
        self.assertEqual(before, self.read("a.glib"))

    def test_the_picture_is_saved_as_it_is(self):
        self.publish()
        self.open()
        self.browser.run("""globalThis.saved = null; const make = URL.createObjectURL;
            URL.createObjectURL = (blob) => { blob.arrayBuffer().then((bytes) => { saved = [...new Uint8Array(bytes)]; }); return make(blob); };
            HTMLAnchorElement.prototype.click = () => {};""")
        self.set(MOVED.format("blue"), "1")
        self.shows(self.rendered("--set", "blue=1"))
        self.browser.click("[title='Save the picture']")
        self.assertEqual(self.pixels(io.BytesIO(bytes(self.browser.wait("return saved")))), self.rendered("--set", "blue=1"))

    def test_full_screen_keeps_the_shape(self):
        self.publish()
        self.open()
        self.browser.click("[aria-label='Full screen (F)']")
        self.browser.wait("return document.fullscreenElement?.matches('.live')")
        self.assertEqual(self.browser.run("const c = document.querySelector('canvas'); return [c.width, c.height, getComputedStyle(c).objectFit]"), [64, 48, "contain"])
        self.browser.run("return document.exitFullscreen()")

    def test_a_poster_waits_and_an_embedded_film_has_no_sources(self):
        self.publish("--poster", "--embed")
        self.browser.open(f"file://{self.folder}/page.html")
        self.assertTrue(self.browser.run("return document.querySelector('img.poster').width === 64 && document.querySelector('canvas') === null"))
        self.browser.click(".note button")
        self.browser.wait("return document.querySelector('canvas')?.isConnected && !document.querySelector('.bar').hidden")
        self.assertTrue(self.browser.run("return document.querySelector('.sources').hidden"))
        self.assertIn("This is a film", self.browser.run("return document.body.innerText"))

    def test_without_scripts_it_is_a_picture(self):
        self.publish()
        self.browser.command("Emulation.setScriptExecutionDisabled", value=True)
        try:
            self.browser.open(f"file://{self.folder}/page.html")
            picture = self.browser.screenshot(selector="img.poster")
        finally:
            self.browser.command("Emulation.setScriptExecutionDisabled", value=False)
        self.assertEqual(self.pixels(io.BytesIO(picture)), self.rendered())

    def test_names_of_strangers_are_data(self):
        name = "<img src=x onerror=document.title='hacked'>'\"&{{content}}"
        self.scene(name=name + ".glib")
        with open(os.path.join(self.folder, name + ".glib"), "ab") as file:
            file.write(b"# </script><script>document.title='hacked'</script><img src=x onerror=\"document.title='hacked'\"> \xff\n")
        with open(os.path.join(self.folder, "q.frag"), "ab") as file:
            file.write(b"// <img src=x onerror=document.title='hacked'>\n")
        self.publish(scene=name + ".glib")
        self.assertEqual([self.page.count(each) for each in ("<script", "</script", "<img", "<!--")], [2, 2, 1, 0])
        self.open()
        for i in range(2):
            self.browser.run("document.querySelectorAll('[role=tab]')[arguments[0]].click()", i)
        time.sleep(0.2)
        self.assertEqual(self.browser.run("return [document.querySelectorAll('img').length, document.querySelectorAll('.lines script').length, violations.length]"), [0, 0, 0])
        self.assertNotEqual(self.browser.run("return document.title"), "hacked")

    def test_it_plays_on_a_site_and_in_a_sandbox(self):
        os.mkdir(os.path.join(self.folder, "in"))
        for each in ("a.glib", "q.vert", "q.frag"):
            shutil.move(os.path.join(self.folder, each), os.path.join(self.folder, "in", each))
        run = subprocess.run([GLIBRA, "publish", "in", "-o", "site", "--frames", "4"], cwd=self.folder, capture_output=True, text=True, check=False)
        if "[page-E01]" in run.stderr:
            self.skipTest("a site needs the runtime")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.open(name="site/scenes/a.html")
        self.set(MOVED.format("blue"), "1")
        self.shows(self.rendered("--set", "blue=1", scene="in/a.glib", size="400x300"))
        self.assertIn("This is a film", self.browser.run("return document.body.innerText"))
        self.assertEqual(self.browser.run("return violations"), [])
        with open(os.path.join(self.folder, "outer.html"), "w", encoding="utf-8") as file:
            file.write('<!doctype html><iframe sandbox="allow-scripts" src="page.html" width="900" height="700"></iframe>')
        self.publish("--embed", scene="in/a.glib")
        self.browser.open(f"file://{self.folder}/outer.html")
        self.browser.ask("POST", self.browser.session + "/frame", {"id": {webdriver.ELEMENT: self.browser.element("iframe")}})
        self.browser.wait("return document.querySelector('canvas')?.isConnected && !document.querySelector('.bar').hidden")
        self.set(MOVED.format("blue"), "1")
        self.shows(self.rendered("--set", "blue=1", scene="in/a.glib"))
        self.browser.ask("POST", self.browser.session + "/frame", {"id": None})


if __name__ == "__main__":
    if not shutil.which("chromium") or not shutil.which("chromedriver"):
        sys.exit(77)
    GLIBRA = os.path.abspath(sys.argv.pop(1))
    unittest.main(verbosity=2)
