#!/usr/bin/env python3
"""Live pages as `glibra publish` writes them, opened from the disk in Chromium and operated by hand. By the rasteriser of this
machine their pictures are those of `glibra render --driver gles --samples 4`, byte by byte.

usage: live_test.py GLIBRA [TEST...]
"""
import base64
import gzip
import io
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

from PIL import Image, ImageChops

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "report"))
import webdriver  # noqa: E402

GLIBRA = None
SIZE = "320x240"
MARGIN = 12  # pixels, in which --incomplete marks a picture
MOST_SECONDS = 30  # for what should happen at once
LARGEST_PAGE, LARGEST_SCENE = 1_200_000, 60_000  # bytes, compressed by gzip

# In every page before its own script: each frame is counted and copied, because a canvas cannot be read later.
BEFORE = """
globalThis.violations = [];
document.addEventListener("securitypolicyviolation", (event) => violations.push(event.violatedDirective + " " + event.blockedURI));
const get = HTMLCanvasElement.prototype.getContext, ask = requestAnimationFrame;
HTMLCanvasElement.prototype.getContext = function (kind, options) {
    const context = get.call(this, kind, options);
    if (kind === "webgl2") globalThis.seen = {canvas: this, context, draws: 0, frames: 0, copy: document.createElement("canvas")};
    return context;
};
for (const name of ["drawArrays", "drawElements", "drawArraysInstanced", "drawElementsInstanced", "clearBufferfv", "clear"]) {
    const draw = WebGL2RenderingContext.prototype[name];
    WebGL2RenderingContext.prototype[name] = function (...values) {
        draw.apply(this, values);
        seen.draws += 1;
    };
}
globalThis.requestAnimationFrame = (act) => ask((time) => {
    const before = globalThis.seen?.draws;
    act(time);
    if (!before && !globalThis.seen?.draws || before === seen.draws) return;
    globalThis.firstPicture ??= performance.now();
    Object.assign(seen.copy, {width: seen.canvas.width, height: seen.canvas.height});
    get.call(seen.copy, "2d").drawImage(seen.canvas, 0, 0);
    seen.frames += 1;
});
"""
IS_DRAWN = "return globalThis.seen?.frames > 0 && seen.canvas.isConnected"
# What stands on the stage.
PICTURE = """const shown = document.querySelector(".stage").firstElementChild;
    return (shown === globalThis.seen?.canvas ? seen.copy : shown).toDataURL()"""
QUAD = """# A quad.
WindowSize 320 240
Background .1 .2 .3
Camera eye LookAt 0 0 3  0 0 0  0 1 0  Perspective 40 .1 100
Vertex quad.vert
Fragment quad.frag
Program P uG <0. .5 1.>
QuadXY 0 .8
"""
VERTEX = """#version 330
in vec3 aPosition;
uniform mat4 uModelViewProjectionMatrix;
void main() { gl_Position = uModelViewProjectionMatrix * vec4(aPosition, 1.); }
"""
FRAGMENT = """#version 330
uniform float uG;
out vec4 fColor;
void main() { fColor = vec4(uG, .5, 0., 1.); }
"""
STEPS = """# Every step adds a little to what was there.
WindowSize 320 240
Texture2D sum 64 64 rgba8 history
Fragment gather.frag
Program Gather uBefore sum.prev
Fragment show.frag
Program Show
Let rate <1 10 60>
Step 10
    Fill sum with Gather
EndStep
Fill window with Show
"""
GATHER = """#version 330
uniform sampler2D uBefore;
out vec4 fColor;
void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    fColor = fract(texelFetch(uBefore, (texel + ivec2(1, 0)) & 63, 0) + vec4(vec2(texel) / 640., .06, 0.));
}
"""
SHOW = "#version 330\nuniform sampler2D sum;\nin vec2 vST;\nout vec4 fColor;\nvoid main() { fColor = texture(sum, vST); }\n"


class Browser(webdriver.Browser):
    def wait(self, script, *arguments):
        end = time.time() + MOST_SECONDS
        while not (value := self.run(script, *arguments)):
            if time.time() > end:
                raise AssertionError(f"never: {script} {arguments}")
            time.sleep(0.02)
        return value

    def frame(self, selector=None, index=0):
        """The scripts that follow run in that frame of the page, or in the page itself."""
        place = None
        if selector:
            found = self.ask("POST", self.session + "/elements", {"using": "css selector", "value": selector})
            place = {webdriver.ELEMENT: found[index][webdriver.ELEMENT]}
        self.ask("POST", self.session + "/frame", {"id": place})


def glibra(*words):
    return subprocess.run([GLIBRA, *map(str, words)], cwd=ROOT, capture_output=True, check=False)


def decoded(url):
    with Image.open(io.BytesIO(base64.b64decode(url.split(",")[1]))) as picture:
        return picture.convert("RGB")


def different(one, other):
    """How many pixels differ."""
    if one.size != other.size:
        return f"{one.size} instead of {other.size}"
    worst = ImageChops.difference(one, other).split()
    return sum(ImageChops.lighter(ImageChops.lighter(worst[0], worst[1]), worst[2]).histogram()[1:])


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="glibra-live-"))
        cls.pages, cls.pictures = {}, {}
        cls.browser = Browser(1400, 1000, gl="mesa").__enter__()
        cls.browser.command("Page.addScriptToEvaluateOnNewDocument", source=BEFORE)

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        shutil.rmtree(cls.folder)

    def setUp(self):
        self.browser.frame()
        self.browser.command("Emulation.clearDeviceMetricsOverride")
        self.browser.open("about:blank")
        self.browser.logs("browser")
        self.browser.requests()

    def tearDown(self):
        self.browser.frame()
        self.assertEqual(self.browser.run("return globalThis.violations ?? []"), [])
        self.assertEqual([each["message"] for each in self.browser.logs("browser") if each["level"] == "SEVERE"], [])
        self.assertEqual(self.browser.foreign(self.browser.requests()), [])

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def scene(self, name):
        """A scene of the examples, or one of this test."""
        self.write("own/quad.glib", QUAD)
        self.write("own/quad.vert", VERTEX)
        self.write("own/quad.frag", FRAGMENT)
        self.write("own/cased.glib", QUAD.replace("Fragment quad", "Fragment Quad").replace("quad.vert", "QUAD.VERT"))
        self.write("own/steps.glib", STEPS)
        self.write("own/gather.frag", GATHER)
        self.write("own/show.frag", SHOW)
        return self.folder / f"{name}.glib" if name.startswith("own/") else ROOT / "glib" / f"{name}.glib"

    def publish(self, name, *options):
        key = (name, *options)
        if key not in self.pages:
            page = self.folder / f"page{len(self.pages)}.html"
            run = glibra("publish", self.scene(name), "--size", SIZE, *options, "-o", page)
            self.assertEqual(run.returncode, 0, run.stderr.decode())
            self.pages[key] = page
        return self.pages[key]

    def render(self, name, *options, size=SIZE):
        """The picture that glibra draws of a scene."""
        key = (name, size, *options)
        if key not in self.pictures:
            self.pictures[key] = self.rendered(self.scene(name), *options, size=size)
        return self.pictures[key]

    def rendered(self, scene, *options, size=SIZE):
        (self.folder / "render.png").unlink(missing_ok=True)
        run = glibra("render", scene, "--driver", "gles", "--samples", "4", "--size", size, *options, "-o", self.folder / "render.png")
        if "--incomplete" not in options:
            self.assertEqual(run.returncode, 0, run.stderr.decode())
        with Image.open(self.folder / "render.png") as picture:
            return picture.convert("RGB")

    def open(self, name, *options, hash=""):
        self.browser.open("about:blank")
        self.browser.pointer(("move", 1, 1))
        self.browser.open(f"file://{self.publish(name, *options)}{hash}")
        self.browser.wait(IS_DRAWN)

    def picture(self):
        return decoded(self.browser.run(PICTURE))

    def assert_shows(self, expected, margin=0):
        """The canvas gets that picture, but for a margin."""
        end = time.time() + MOST_SECONDS / 3

        def inner(picture):
            return picture.crop((margin, margin, picture.width - margin, picture.height - margin))

        while (count := different(inner(self.picture()), inner(expected))) != 0:
            if time.time() > end:
                self.fail(f"{count} pixels differ; {self.browser.run(TEXTS)}")
            time.sleep(0.05)

    def assert_shows_other_than(self, picture):
        end = time.time() + MOST_SECONDS / 3
        while different(self.picture(), picture) == 0:
            self.assertLess(time.time(), end, "the picture stays")
            time.sleep(0.05)

    def type_into(self, selector, value):
        """The value of an input, as from a user."""
        self.browser.run("""const field = document.querySelector(arguments[0]); field.value = arguments[1];
            for (const each of ["input", "change"]) field.dispatchEvent(new Event(each, {bubbles: true}));""", selector, value)

    def press_on(self, selector, *keys):
        self.browser.run("document.querySelector(arguments[0]).focus()", selector)
        self.browser.press(*keys)

    def box(self, selector):
        return self.browser.run("""const each = document.querySelector(arguments[0]); each.scrollIntoView({block: "nearest"});
            const box = each.getBoundingClientRect(); return [box.left, box.top, box.width, box.height]""", selector)

    def edit(self, tab, text, browser=None):
        (browser or self.browser).run("""[...document.querySelectorAll("[role=tab]")].find((each) => each.textContent === arguments[0]).click();
            const area = document.querySelector("textarea"); area.value = arguments[1]; area.dispatchEvent(new Event("input"));""", tab, text)


MARKED = "return [...document.querySelectorAll('.code li')].flatMap((each, i) => (each.classList.contains('error') ? [i] : []))"
TEXTS = "return [document.querySelector('.messages')?.innerText, document.querySelector('.note')?.innerText].join(' ')"
SHOWN = "return [...document.querySelectorAll(arguments[0])].filter((each) => each.checkVisibility()).length"
LEFT, UP, RIGHT = "\ue012", "\ue013", "\ue014"


class Values(Pages):
    def test_a_page_opens_with_the_picture_of_render(self):
        self.open("start/teapot")
        self.assert_shows(self.render("start/teapot"))
        self.open("lights/two_shadows", "--time", "1.25", "--set", "sun=0")
        self.press_on("canvas", " ")
        self.type_into(".seconds", "1.25")
        self.assert_shows(self.render("lights/two_shadows", "--time", "1.25", "--set", "sun=0"))

    def test_files_are_found_in_another_case(self):
        self.open("own/cased")
        self.assert_shows(self.render("own/quad"))

    def test_a_slider_is_moved_by_keys_the_mouse_and_its_field(self):
        self.open("start/teapot")
        self.press_on("[type=range][aria-label='uShininess of Glaze']", LEFT, LEFT, LEFT)
        value = self.browser.run("return document.querySelector(\"[aria-label='uShininess of Glaze, number']\").value")
        self.assertNotEqual(value, "60")
        self.assert_shows(self.render("start/teapot", "--set", "uShininess=" + value))
        left, top, width, height = self.box("[type=range][aria-label='uLightX of Glaze']")
        self.browser.pointer(("move", left + 0.3 * width, top + height / 2), "down", ("move", left + 0.8 * width, top + height / 2), "up")
        light = self.browser.run("return document.querySelector(\"[aria-label='uLightX of Glaze, number']\").value")
        self.assertGreater(float(light), 4)
        self.assert_shows(self.render("start/teapot", "--set", "uShininess=" + value, "--set", "uLightX=" + light))
        self.type_into("[aria-label='uAmbient of Glaze, number']", ".75")
        self.assert_shows(self.render("start/teapot", "--set", "uShininess=" + value, "--set", "uLightX=" + light, "--set", "uAmbient=.75"))
        self.browser.click("[aria-label='Reset uShininess of Glaze']")
        self.assert_shows(self.render("start/teapot", "--set", "uLightX=" + light, "--set", "uAmbient=.75"))
        self.browser.click(".reset-all")
        self.assert_shows(self.render("start/teapot"))

    def test_colours_check_boxes_and_choices(self):
        self.open("start/teapot")
        self.type_into("[aria-label='uGlazeColor of Glaze']", "#ff0033")
        self.browser.click("[type=checkbox][aria-label='uBands of Glaze']")
        self.assert_shows(self.render("start/teapot", "--set", "uGlazeColor=1,0,.2", "--set", "uBands=0"))
        self.browser.click(".reset-all")
        self.assert_shows(self.render("start/teapot"))
        self.open("arrays/checkered_shapes")
        self.type_into("select[aria-label^='shape']", "cylinder")
        self.assert_shows(self.render("arrays/checkered_shapes", "--set", "shape=cylinder"))

    def test_keys_of_the_scene(self):
        self.open("arrays/checkered_shapes")
        self.press_on("canvas", "t")
        self.assert_shows(self.render("arrays/checkered_shapes", "--set", "shape=sphere"))
        self.browser.click("[aria-label^='Key t:']")
        self.assert_shows(self.render("arrays/checkered_shapes", "--set", "shape=cylinder"))
        self.open("detail/fly_through")
        self.type_into(".seconds", "1")
        self.browser.run("document.querySelector('canvas').focus()")
        for act in ("keyDown", "keyUp"):
            self.browser.ask("POST", self.browser.session + "/actions", {"actions": [{"type": "key", "id": "keys", "actions": [{"type": act, "value": "r"}]}]})
            self.browser.wait("return document.querySelector(\"[type=number][aria-label='y, number']\").valueAsNumber > 1.3")
        height = self.browser.wait("return location.hash.match(/[#&:]y=([^&]*)/)?.[1]")
        self.assert_shows(self.render("detail/fly_through", "--time", "1", "--set", "y=" + height))

    def test_a_link_shows_what_one_saw(self):
        self.open("lights/two_shadows")
        self.type_into(".seconds", "2.5")
        self.type_into("[type=number][aria-label^='lampX']", "3.25")
        self.browser.click("[type=checkbox][aria-label^='sun']")
        self.assert_shows(self.render("lights/two_shadows", "--time", "2.5", "--set", "lampX=3.25", "--set", "sun=0"))
        left, top, width, height = self.box("canvas")
        self.browser.pointer(("move", left + 100, top + 100), "down", ("move", left + 180, top + 130), "up")
        self.browser.wait("return location.hash.includes('eye=')")
        picture, hash = self.picture(), self.browser.run("return location.hash")
        self.assertIn("lampX=3.25", hash)
        self.open("lights/two_shadows", hash=hash)
        self.assert_shows(picture)
        self.browser.run("location.hash = '#time=1'")
        self.browser.wait("return document.querySelector('.seconds').value === '1.00'")

    def test_values_of_the_command_are_set_and_reset(self):
        published = ("start/teapot", "--set", "uGlazeColor=1,0,.2", "--set", "uBands=0")
        is_reset = "return document.querySelector('.reset-all').disabled && document.querySelector(\"[aria-label='Reset uBands of Glaze']\").disabled"
        self.open(*published)
        self.assert_shows(self.render(*published))
        self.assertTrue(self.browser.run(is_reset))
        self.browser.click("[type=checkbox][aria-label='uBands of Glaze']")
        self.type_into("[aria-label='uGlazeColor of Glaze']", "#0000ff")
        self.assert_shows(self.render("start/teapot", "--set", "uGlazeColor=0,0,1"))
        self.assertFalse(self.browser.run(is_reset))
        self.browser.click("[aria-label='Reset uBands of Glaze']")
        self.assert_shows(self.render("start/teapot", "--set", "uGlazeColor=0,0,1", "--set", "uBands=0"))
        self.browser.click(".reset-all")
        self.assert_shows(self.render(*published))
        self.assertTrue(self.browser.run(is_reset))
        # The values of a link are the reader's.
        self.browser.click("[type=checkbox][aria-label='uBands of Glaze']")
        self.browser.wait("return location.hash.includes('uBands=1')")
        self.open(*published, hash=self.browser.run("return location.hash"))
        self.assert_shows(self.render("start/teapot", "--set", "uGlazeColor=1,0,.2"))
        self.assertFalse(self.browser.run(is_reset))
        self.browser.click(".reset-all")
        self.assert_shows(self.render(*published))


class Time(Pages):
    def test_a_time_is_typed_stepped_and_restarted(self):
        self.open("lights/two_shadows")
        self.type_into(".seconds", "1.5")
        self.assert_shows(self.render("lights/two_shadows", "--time", "1.5"))
        self.press_on("canvas", ".", ".", ".")
        self.assert_shows(self.render("lights/two_shadows", "--time", "1.6"))
        self.browser.click("[aria-label='Restart at 0 seconds']")
        self.assert_shows(self.render("lights/two_shadows"))
        self.browser.click("[aria-label='Play (Space)']")
        self.assert_shows_other_than(self.render("lights/two_shadows"))
        self.browser.click("[aria-label='Pause (Space)']")
        self.browser.wait("return location.hash.startsWith('#time=')")
        at = self.browser.run("return location.hash.slice(6)")
        self.assert_shows(self.render("lights/two_shadows", "--time", at))

    def test_steps_are_those_of_the_time(self):
        self.open("own/steps")
        for at in ("1.25", "0.45", "3"):
            self.type_into(".seconds", at)
            self.assert_shows(self.render("own/steps", "--time", at))
        self.browser.click("[aria-label='Next step (B)']")
        self.assert_shows(self.render("own/steps", "--time", "3.1"))
        self.browser.click("[aria-label='Restart at 0 seconds']")
        self.assert_shows(self.render("own/steps"))


class View(Pages):
    def test_the_mouse_and_the_wheel_move_the_view_and_home_brings_it_back(self):
        self.open("start/teapot")
        at_first = self.render("start/teapot")
        self.assert_shows(at_first)
        left, top, _, _ = self.box("canvas")
        for name, move in (("drag", lambda: self.browser.pointer(("move", left + 150, top + 100), "down", ("move", left + 200, top + 120), "up")),
                           ("wheel", lambda: self.browser.wheel(left + 150, top + 100, -100)),
                           ("projection", lambda: self.browser.press("p"))):
            with self.subTest(name):
                move()
                self.assert_shows_other_than(at_first)
                self.browser.click("[aria-label='Reset the view (R)']")
                self.assert_shows(at_first)
                self.browser.run("document.querySelector('canvas').focus()")

    def test_arrow_keys_turn_the_scene_while_the_picture_has_the_focus(self):
        self.open("start/teapot")
        at_first = self.render("start/teapot")
        self.press_on("body", RIGHT)
        self.browser.run("document.querySelector('.tabs button').focus()")
        self.browser.press(RIGHT)
        self.assert_shows(at_first)
        self.press_on("canvas", RIGHT, UP)
        self.assert_shows_other_than(at_first)
        self.browser.press("\ue015", LEFT)
        self.browser.press("r")
        self.assert_shows(at_first)
        self.open("detail/fly_through")  # whose own keys are taken first
        self.browser.press("f")
        self.assertEqual(self.browser.run("return document.fullscreenElement"), None)

    def test_the_full_screen_has_the_values(self):
        self.open("start/teapot")
        self.press_on("canvas", "f")
        self.browser.wait("return document.fullscreenElement && seen.copy.width === innerWidth")
        self.assertEqual(self.browser.run(SHOWN, ".sources, .messages, .panel, [aria-label^=Sources]"), 0)
        self.browser.click("[aria-label='Values (V)']")
        self.type_into("[aria-label='uAmbient of Glaze, number']", ".75")
        left, top, width, height = self.box("[type=range][aria-label='uLightX of Glaze']")
        self.assertTrue(self.browser.run("return document.elementFromPoint(...arguments).matches('[type=range]')", left + width / 2, top + height / 2))
        self.browser.press("v")
        self.assertEqual(self.browser.run(SHOWN, ".panel"), 0)
        self.browser.press("f")
        self.browser.wait("return !document.fullscreenElement && seen.copy.width === 320")
        self.assertEqual(self.browser.run(SHOWN, ".sources, .panel"), 2)
        self.assert_shows(self.render("start/teapot", "--set", "uAmbient=.75"))

    def test_cameras_are_chosen(self):
        self.open("lights/two_shadows")
        self.type_into(".seconds", "1")
        own = self.render("lights/two_shadows", "--time", "1")
        self.assert_shows(own)
        seen = [own]
        for name in ("lampEye", "sunEye"):
            self.type_into("[aria-label='Camera (C)']", name)
            for each in seen:
                self.assert_shows_other_than(each)
            time.sleep(0.3)
            seen.append(self.picture())
        self.browser.wait("return location.hash.includes('camera=sunEye')")
        self.press_on("canvas", "r")
        self.assert_shows(own)
        self.open("lights/two_shadows", hash="#time=1&camera=lampEye")
        self.assert_shows(seen[1])


class Edits(Pages):
    def test_a_scene_and_a_shader_are_edited_with_an_error_and_without(self):
        self.open("own/quad")
        at_first = self.render("own/quad")
        self.assert_shows(at_first)

        def changed(scene=QUAD, fragment=FRAGMENT):
            self.write("changed/quad.glib", scene)
            self.write("changed/quad.vert", VERTEX)
            self.write("changed/quad.frag", fragment)
            return self.rendered(self.folder / "changed/quad.glib", "--incomplete")

        sphere = QUAD.replace("QuadXY 0 .8", "Sphere .7 9 7")
        self.edit("quad.glib", sphere)
        with_sphere = changed(sphere)
        self.assert_shows(with_sphere)
        # A faulty statement is left out, as by --incomplete.
        faulty = sphere + "Spere 2\nTranslate .1 .2 0\nQuadXY .8 .3\n"
        self.edit("quad.glib", faulty)
        self.browser.wait("return document.querySelector('.messages').textContent.includes(\"quad.glib:9:1: error: unknown command 'Spere'\")")
        self.assertEqual(self.browser.run(MARKED), [8])
        self.assert_shows(changed(faulty), MARGIN)
        self.edit("quad.glib", "")
        self.browser.wait("return document.querySelector('.messages').textContent.includes('quad.glib')")
        self.edit("quad.glib", sphere)
        self.assert_shows(with_sphere)
        self.browser.wait("return document.querySelector('.messages').hidden")
        other = FRAGMENT.replace("uG, .5, 0.", "0., uG, gl_FragCoord.x / 320.")
        self.edit("quad.frag", other)
        with_other = changed(sphere, other)
        self.assert_shows(with_other)
        self.edit("quad.frag", other.replace("uG,", "uNone,"))
        self.browser.wait("return /quad.frag:4:\\d+: error/.test(document.querySelector('.messages').textContent)")
        self.assertEqual(self.browser.run(MARKED), [3])
        time.sleep(0.3)
        self.assert_shows(with_other)  # the last good program stays
        self.browser.click(".tabrow > button")
        self.assert_shows(with_sphere)
        self.type_into("[aria-label='uG of P, number']", ".25")
        self.edit("quad.glib", QUAD)  # values are kept
        self.assert_shows(self.render("own/quad", "--set", "uG=.25"))

    def test_a_lost_context_comes_back(self):
        self.open("start/teapot")
        self.type_into("[aria-label='uGlazeColor of Glaze']", "#ff0033")
        red = self.render("start/teapot", "--set", "uGlazeColor=1,0,.2")
        self.assert_shows(red)
        for _ in range(2):
            self.browser.run("globalThis.loser = seen.context.getExtension('WEBGL_lose_context'); loser.loseContext()")
            self.browser.wait("return !document.querySelector('.note').hidden")
            self.assertTrue(self.browser.run("return document.querySelector('.stage').firstElementChild.matches('img')"), "no picture stands there")
            self.browser.run("setTimeout(() => loser.restoreContext(), 50)")
            self.browser.wait("return document.querySelector('.note').hidden")
            self.assert_shows(red)
        self.browser.run("loser = seen.context.getExtension('WEBGL_lose_context'); loser.loseContext()")
        self.browser.wait("return !document.querySelector('.note').hidden")
        self.browser.click(".note button")
        self.assert_shows(red)


    def test_an_edit_brings_a_lost_context_back(self):
        self.open("own/quad")
        self.browser.run("seen.context.getExtension('WEBGL_lose_context').loseContext()")
        self.browser.wait("return /took the graphics away/.test(document.querySelector('.note:not([hidden])')?.textContent)")
        self.edit("quad.frag", FRAGMENT.replace(".5, 0.", ".25, 1."))
        self.browser.wait("return document.querySelector('.note').hidden")
        self.write("own/changed.frag", FRAGMENT.replace(".5, 0.", ".25, 1."))
        self.assert_shows(self.rendered(self.write("own/changed.glib", QUAD.replace("quad.frag", "changed.frag"))))

    def test_messages_stand_in_their_list(self):
        self.open("own/quad")
        self.edit("quad.frag", FRAGMENT.replace("uG,", "uNone,"))
        self.browser.wait("return document.querySelector('.messages .note')")
        self.assertEqual(self.browser.run("""const [note, list] = [".messages .note", ".messages"].map((each) => document.querySelector(each).getBoundingClientRect());
            return [note.left >= list.left, note.top >= list.top, note.bottom <= list.bottom, document.querySelector(".stage .note").hidden]"""), [True] * 4)

    def test_edits_are_saved_and_not_lost_without_a_question(self):
        self.open("own/quad")
        asks = "return !dispatchEvent(new Event('beforeunload', {cancelable: true}))"
        self.assertFalse(self.browser.run(asks))
        self.edit("quad.frag", FRAGMENT + "// more\n")
        self.assertTrue(self.browser.run(asks))
        self.browser.run("""globalThis.saved = [];
            HTMLAnchorElement.prototype.click = function () { saved.push(this.download); };
            URL.createObjectURL = (content) => { content.text().then((text) => saved.push(text)); return "#"; };""")
        self.browser.click(".tabrow > button:last-child")
        self.assertEqual(sorted(self.browser.wait("return saved.length > 1 && saved")), sorted(["quad.frag", FRAGMENT + "// more\n"]))
        self.assertFalse(self.browser.run(asks), "it is saved")
        self.edit("quad.frag", FRAGMENT + "// and more\n")
        self.assertTrue(self.browser.run(asks))
        self.browser.click(".tabrow > button")
        self.assertFalse(self.browser.run(asks))

    def test_sources_stand_beside_the_picture_or_below_it(self):
        page = self.folder / "large.html"
        self.assertEqual(glibra("publish", self.scene("start/teapot"), "--size", "600x600", "-o", page).returncode, 0)
        boxes = """return [".stage canvas", ".code", ".panel"].map((each) => document.querySelector(each).getBoundingClientRect())
            .map(({left, top, right, bottom}) => ({left, top, right, bottom, isWhole: top >= 0 && bottom <= innerHeight && right <= innerWidth}))"""
        try:
            for width, height in ((1280, 720), (1920, 1080), (1024, 700)):
                self.browser.command("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
                self.browser.open("about:blank")
                self.browser.open(f"file://{page}")
                self.browser.wait(IS_DRAWN)
                picture, code, values = self.browser.run(boxes)
                self.assertTrue(picture["isWhole"] and code["isWhole"] and values["isWhole"], (width, picture, code, values))
                self.assertGreaterEqual(code["left"], picture["right"])
                self.assertGreater(code["bottom"] - code["top"], 150)
            for width, height in ((800, 900), (390, 844)):
                self.browser.command("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=True)
                self.browser.open("about:blank")
                self.browser.open(f"file://{page}")
                self.browser.wait(IS_DRAWN)
                self.browser.click("[aria-label='Sources (E)']")
                for scroll in (0, 300):
                    self.browser.run("scrollTo(0, arguments[0])", scroll)
                    picture, code, _ = self.browser.run(boxes)
                    self.assertTrue(picture["isWhole"], (width, scroll, picture))
                    self.assertLessEqual(picture["bottom"] - picture["top"], 0.4 * height + 1)
                    self.assertGreater(code["bottom"], picture["bottom"])
        finally:
            self.browser.command("Emulation.clearDeviceMetricsOverride")


class Frames(Pages):
    def test_an_embedded_page_fits_its_frame(self):
        page = self.folder / "fitting.html"
        fits = """const {scrollWidth, scrollHeight} = document.documentElement, picture = document.querySelector(".stage canvas").getBoundingClientRect(),
            bar = document.querySelector(".bar").getBoundingClientRect();
            return [scrollWidth, scrollHeight, picture.top >= 0 && picture.right <= innerWidth && picture.height >= 100, bar.top >= picture.bottom && bar.bottom <= innerHeight + .5]"""
        for name in ("start/teapot", "tessellation/bezier_surface", "lights/two_shadows", "own/quad"):
            self.assertEqual(glibra("publish", self.scene(name), "--embed", "-o", page).returncode, 0)
            for width, height in ((520, 420), (400, 300), (320, 480), (900, 500), (1100, 600)):
                with self.subTest(f"{name} {width}x{height}"):
                    self.write("fitted.html", f'<!doctype html><body style="margin: 0"><iframe src="fitting.html" width="{width}" height="{height}" style="border: 0">')
                    self.browser.frame()
                    self.browser.open(f"file://{self.folder}/fitted.html")
                    self.browser.frame("iframe")
                    self.browser.wait(IS_DRAWN)
                    self.assertEqual(self.browser.run(fits), [width, height, True, True])
                    if width < 800:
                        self.browser.click("[aria-label='Values (V)']")
                        self.assertEqual(self.browser.run(SHOWN, ".panel"), 1)
                        self.assertEqual(self.browser.run(fits), [width, height, True, True])
                    self.browser.run("document.querySelector(\"[aria-label='Sources (E)']\").click()")
                    self.assertEqual(self.browser.run(fits), [width, height, True, True])
                    self.assertGreater(self.browser.run("return document.querySelector('.code').clientHeight"), 40)

    def test_twenty_frames_on_one_page(self):
        page = self.publish("start/teapot", "--embed")
        for gap, name in ((900, "apart.html"), (0, "together.html")):
            self.write(name, "<!doctype html>" + "".join(
                f'<iframe src="{page.name}#Glaze:uShininess={number + 20}" width="340" height="340" style="border: 0; display: {"block" if gap else "inline-block"};'
                f' margin-bottom: {gap}px"></iframe>' for number in range(20)))
        state = """const live = document.querySelector(".live"), picture = live.querySelector(".stage").firstElementChild;
            return [picture.matches("img") ? "poster" : globalThis.seen?.canvas === picture && !seen.context.isContextLost() ? "live" : "still", live.querySelector(".note").hidden]"""

        def states():
            found = []
            for number in range(20):
                self.browser.frame("iframe", number)
                found.append(self.browser.run(state))
                self.browser.frame()
            return found

        def wait_for(count, what):
            end = time.time() + MOST_SECONDS
            while [each[0] for each in states()].count(what) != count:
                self.assertLess(time.time(), end, states())
                time.sleep(0.2)
            now = states()
            return now

        self.browser.open(f"file://{self.folder}/apart.html")
        # The first is seen, and no other one has begun.
        self.assertEqual(wait_for(1, "live"), [["live", True]] + [["poster", True]] * 19)
        for number in range(20):
            self.browser.run("document.querySelectorAll('iframe')[arguments[0]].scrollIntoView()", number)
            self.browser.frame("iframe", number)
            self.browser.wait(IS_DRAWN)
            self.browser.frame()
        # All but the last one give their contexts back, and their pictures stay.
        self.assertEqual(wait_for(19, "still"), [["still", True]] * 19 + [["live", True]])
        for number in (0, 11):
            self.browser.frame("iframe", number)
            expected = self.render("start/teapot", "--set", f"uShininess={number + 20}")
            self.assert_shows(expected)
            self.browser.run("frameElement?.scrollIntoView(); globalThis.seen = undefined")
            self.browser.frame()
            self.browser.run("document.querySelectorAll('iframe')[arguments[0]].scrollIntoView()", number)
            self.browser.frame("iframe", number)
            self.browser.wait(IS_DRAWN)
            self.assert_shows(expected)
            self.browser.click("[aria-label='Values (V)']")
            self.browser.click("[type=checkbox][aria-label='uBands of Glaze']")
            self.assert_shows(self.render("start/teapot", "--set", f"uShininess={number + 20}", "--set", "uBands=0"))
            self.browser.frame()
        # More than a browser has contexts for can be seen at once: 16 are live, and the others show a picture and a button.
        self.browser.command("Emulation.setDeviceMetricsOverride", width=1800, height=1400, deviceScaleFactor=1, mobile=False)
        self.browser.open(f"file://{self.folder}/together.html")
        self.assertEqual(wait_for(16, "live").count(["poster", False]), 4)
        self.browser.logs("browser")  # the browser reports the contexts that it takes

    def test_a_phone(self):
        self.browser.command("Emulation.setDeviceMetricsOverride", width=390, height=844, deviceScaleFactor=3, mobile=True)
        self.browser.command("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=2)
        try:
            self.open("start/teapot")
            at_first = self.render("start/teapot", size="640x480")  # no more than two pixels for one of CSS
            self.assert_shows(at_first)
            self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), 390)
            left, top, _, _ = self.box("canvas")

            def touch(kind, *points):
                self.browser.command("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": left + x, "y": top + y, "id": i} for i, (x, y) in enumerate(points)])

            for gesture in ([(100, 100)], [(180, 130)]), ([(100, 100), (140, 100)], [(60, 100), (180, 100)]):
                touch("touchStart", *gesture[0])
                touch("touchMove", *gesture[1])
                touch("touchEnd")
                self.assert_shows_other_than(at_first)
                self.browser.click("[aria-label='Reset the view (R)']")
                self.assert_shows(at_first)
            # A finger that swipes upwards scrolls the page.
            self.browser.run("scrollTo(0, 0)")
            left, top, _, _ = self.box("canvas")
            touch("touchStart", (100, 200))
            for y in range(190, 90, -10):
                touch("touchMove", (100, y))
            touch("touchEnd")
            self.browser.wait("return scrollY > 50")
            self.assert_shows(at_first)
            left, top, width, height = self.box("[type=range][aria-label='uLightX of Glaze']")
            touch("touchStart", (0.75 * width, height / 2))
            touch("touchEnd")
            light = self.browser.run("return document.querySelector(\"[aria-label='uLightX of Glaze, number']\").value")
            self.assertNotEqual(light, "-4")
            self.assert_shows(self.render("start/teapot", "--set", "uLightX=" + light, size="640x480"))
        finally:
            self.browser.command("Emulation.setTouchEmulationEnabled", enabled=False)

    def framed(self, sandbox, *options):
        page = self.publish("start/teapot", *options)
        self.write("framed.html", f'<!doctype html><body style="margin: 0"><iframe sandbox="{sandbox}" src="{page.name}" width="900" height="700" style="border: 0">')
        self.browser.open(f"file://{self.folder}/framed.html")

    def test_a_sandbox_with_scripts(self):
        self.framed("allow-scripts")
        self.browser.frame("iframe")
        self.assertEqual(self.browser.run("return origin"), "null")
        self.browser.wait("return document.querySelector('.stage canvas')")
        self.type_into("[aria-label='uAmbient of Glaze, number']", ".75")
        left, top, width, height = self.box("canvas")
        self.browser.frame()
        self.assert_screen(left, top, self.render("start/teapot", "--set", "uAmbient=.75"))
        self.browser.frame("iframe")
        self.browser.click("[aria-label='Save the picture']")
        self.browser.wait("return document.querySelector('.note').textContent.startsWith('Nothing is saved')")
        self.browser.logs("browser")  # the browser reports that it has not saved

    def assert_screen(self, left, top, expected):
        """The window gets that picture there. The scripts of this test are not in every frame."""
        end = time.time() + MOST_SECONDS
        while True:
            with Image.open(io.BytesIO(self.browser.screenshot())) as screen:
                count = different(screen.convert("RGB").crop((left, top, left + expected.width, top + expected.height)), expected)
            if count == 0:
                return
            self.assertLess(time.time(), end, f"{count} pixels differ")

    def test_without_scripts_the_picture_stands_there(self):
        self.framed("", "--embed")
        self.assert_screen(0, 0, self.render("start/teapot"))
        # The browser says that it has run no script: this is the only thing that it may report.
        self.assertEqual([each["message"] for each in self.browser.logs("browser") if "Blocked script execution" not in each["message"]], [])

    def test_the_picture_stands_there_until_it_is_clicked(self):
        self.browser.open(f"file://{self.publish('start/teapot', '--poster', '--embed')}")
        time.sleep(0.5)
        self.assertIsNone(self.browser.run("return globalThis.seen ?? null"))
        self.press_on(".note button", "Enter")
        self.browser.wait(IS_DRAWN)
        self.assert_shows(self.render("start/teapot"))
        self.assertTrue(self.browser.run("return document.activeElement === seen.canvas"))


class Sites(Pages):
    SCENES = ("lighting/volume_shadow", "start/teapot", "arrays/checkered_shapes", "lights/two_shadows", "own/quad")

    def test_a_site_shares_one_runtime(self):
        site = self.folder / "site"
        run = glibra("publish", *(self.scene(name) for name in self.SCENES), "-o", site)
        self.assertEqual(run.returncode, 0, run.stderr.decode())
        self.browser.open(f"file://{site}/index.html")
        links = self.browser.run("return [...document.querySelectorAll('a[href]')].map((each) => each.href).filter((each) => each.includes('/scenes/'))")
        self.assertEqual(len(set(links)), len(self.SCENES))
        for name in ("start/teapot", "arrays/checkered_shapes"):
            self.browser.open(next(each for each in links if name.split("/")[1] in each))
            self.browser.wait(IS_DRAWN)
            self.assert_shows(self.render(name, size="x".join(map(str, self.picture().size))))
        runtime = sum(len(gzip.compress(each.read_bytes(), 9)) for each in (site / "live").iterdir())
        self.assertLess(runtime, LARGEST_PAGE)
        for each in sorted((site / "scenes").glob("*.html")):
            parts = (each, each.with_suffix(".js"))
            size = sum(len(gzip.compress(part.read_bytes(), 9)) for part in parts)
            print(f"{each.stem}: {size} bytes, compressed", file=sys.stderr)
        self.assertLess(len(gzip.compress(self.publish("start/teapot").read_bytes(), 9)), LARGEST_PAGE)


# What strangers may write: each stands in names, comments, messages and values of a scene, and would set `hacked` if it became
# part of a page.
HOSTILE = (
    "</script><script>hacked=1</script>", "<img/src=x/onerror=hacked=1>", "<!--<script>hacked=1//", '"onfocus="hacked=1"autofocus="', "'-(hacked=1)-'",
    "\\u003cscript>hacked=1</script>", "&lt;img/src=x/onerror=hacked=1&gt;", "javascript:hacked=1", "${hacked=1}", "{{content}}", "</textarea><svg/onload=hacked=1>",
    "</style><script>hacked=1</script>", "]]><script>hacked=1</script>", "\u2028hacked=1//", "a\0b<script>hacked=1</script>", b"\xff\xfe<script>hacked=1</script>\xc0",
)
NAMES = ("__proto__", "constructor", "hasOwnProperty", "toString", "innerHTML", "then")


def hostile_scenes():
    """The files of scenes, by a name. The scene is quad.glib."""
    for number, text in enumerate(HOSTILE):
        raw = text if isinstance(text, bytes) else text.encode()
        name = raw.replace(b" ", b"_")
        quad = QUAD.encode()
        yield f"comments {number}", {"quad.glib": b"# " + raw + b"\n" + quad.replace(b"# A quad.\n", b"") + b"MessageBox " + raw + b"\n# " + raw,
                                     "quad.frag": b"#version 330 // " + raw + b"\n" + FRAGMENT.encode().split(b"\n", 1)[1] + b"/* " + raw + b" */\n"}
        yield f"names {number}", {"quad.glib": quad.replace(b"Program P uG", b"Program " + name + b" " + name + b" 1 uG") + b"Let " + name + b" <0. 1. 2.>\n" + name + b" 1\n"
                                               b"Camera " + name + b" LookAt 0 0 3  0 0 0  0 1 0  Perspective 40 .1 100\nTexture2D t " + name + b"\nFragment " + name + b".frag\n"}
        yield f"shader {number}", {"quad.frag": FRAGMENT.encode() + b"#error " + raw + b"\n#include \"" + raw + b"\"\n" + raw}
    for name in NAMES:
        yield name, {"quad.glib": QUAD.replace("Program P uG", f"Program {name} {name} <0. 1. 2.> uG") + f"Let {name} <0. 1. 2.>\nLet other{name} <{name} plain>\nGroup {name}\nSphere .2 5 5\nEndGroup\n",
                     "quad.frag": FRAGMENT.replace("uniform float uG;", f"uniform float uG;\nuniform float {name};").replace(".5", f".5 * {name}"), name: b"\0" * 9}
    deep = 20_000
    for name, text in {
            "brackets": "Let a " + "(" * deep + "1" + ")" * deep + "\n", "groups": "Group\n" * deep + "EndGroup\n" * deep, "unary": "Let a (" + "-" * deep + "1)\n",
            "sphere": "Sphere 1 1000000000 1000000000\n", "numbers": "Let a <-1e400 1e400 1e999>\nTranslate 1e400 nan inf\nLet b <0. 5e-324 1e308>\n",
            "repeat": "Repeat 0 1000000000 1 as i\nRepeat 0 1000000000 1 as j\nSphere 1\nEndRepeat\nEndRepeat\n", "texture": "Texture2D t 1000000000 1000000000\n",
            "self": "Include quad.glib\n", "up": "Include ../../../etc/passwd\nTexture2D t /etc/passwd\n", "address": "Texture2D t https://example.com/a.png\nVertex http://example.com/a.vert\n",
            "long line": "# " + "<script>hacked=1</script>" * 40_000 + "\n", "knobs": "".join(f"Let k{i} <0. 1. 2.>\n" for i in range(2_000)), "size": "WindowSize 1000000000 0\n"}.items():
        yield name, {"quad.glib": QUAD + text}
    yield "empty", {"quad.glib": ""}
    yield "binary", {"quad.glib": bytes(range(256)) * 100, "quad.frag": bytes(range(256)) * 100}
    yield "deep shader", {"quad.frag": FRAGMENT.replace("uG,", "(" * deep + "uG" + ")" * deep + ",")}


class Hostile(Pages):
    def with_files(self, page, files):
        """The text of a page with other files, as it would be if glibra had let them onto it."""
        text = page.read_text()
        whole = re.search(r'(id="glibra-scene">)(.*?)(</script>)', text, re.DOTALL)
        data = json.loads(whole[2])
        folder = data["scene"].rpartition("/")[0]
        data["files"] = [{"name": f"{folder}/{name}".lstrip("/"), "bytes": len(content), "converted": False} for name, content in files.items()]
        data["content"] = base64.b64encode(gzip.compress(b"".join(files.values()))).decode()
        return text[:whole.start(2)] + json.dumps(data).replace("<", "\\u003c") + text[whole.end(2):]

    def test_no_scene_becomes_script(self):
        page, count = self.publish("own/quad"), {"published": 0, "refused": 0}
        for number, (name, changed) in enumerate(hostile_scenes()):
            with self.subTest(name):
                files = {each: text if isinstance(text, bytes) else text.encode() for each, text in {"quad.glib": QUAD, "quad.vert": VERTEX, "quad.frag": FRAGMENT, **changed}.items()}
                folder = f"hostile{number}"
                for each, text in files.items():
                    self.write(f"{folder}/{each}", text)
                run = glibra("publish", self.folder / folder / "quad.glib", "--size", SIZE, "-o", self.folder / f"{folder}.html")
                self.assertIn(run.returncode, (0, 2, 3), run.stderr[-500:])
                count["published" if run.returncode == 0 else "refused"] += 1
                pages = [self.write(f"{folder}_files.html", self.with_files(page, files))]
                if run.returncode == 0:
                    pages.append(self.folder / f"{folder}.html")
                for each in pages:
                    self.look_at(each)
        print(count, file=sys.stderr)

    def look_at(self, page):
        self.browser.open("about:blank")
        self.browser.open(f"file://{page}")
        self.browser.wait("return globalThis.seen?.frames > 0 || document.querySelector('.note:not([hidden]), .messages:not([hidden])') || !document.querySelector('script')")
        self.browser.run("""document.querySelectorAll("[role=tab], .messages button, summary").forEach((each) => each.click());
            document.querySelectorAll("[title], .poster").forEach((each) => each.dispatchEvent(new MouseEvent("mouseover", {bubbles: true})));
            document.querySelectorAll("input[type=range]").forEach((each, i) => { if (i < 5) { each.value = .7; each.dispatchEvent(new Event("input")); } });""")
        self.browser.wait("return document.readyState === 'complete'")
        self.assertEqual(self.browser.run("return [typeof hacked, document.querySelectorAll('img').length <= 1, document.querySelectorAll('script').length <= 3, globalThis.violations]"),
                         ["undefined", True, True, []])
        self.browser.logs("browser")  # faulty shaders are reported there

    def test_names_of_files(self):
        for name in ("<img src=x onerror=hacked=1>", "'\"onfocus=hacked=1 autofocus='", "&quot;><script>hacked=1<&script>", "{{scripts}}", "-o", "javascript:hacked=1"):
            with self.subTest(name):
                folder = self.folder / "names"
                self.write("own/quad.glib", QUAD)
                for each, text in ((f"{name}.glib", QUAD.replace("quad.frag", f"'{name}.frag'") if " " not in name and "'" not in name else QUAD), ("quad.vert", VERTEX), ("quad.frag", FRAGMENT), (f"{name}.frag", FRAGMENT)):
                    self.write(f"names/{each}", text)
                run = glibra("publish", folder / f"{name}.glib", "-o", self.folder / "named.html")
                self.assertIn(run.returncode, (0, 3), run.stderr)
                if run.returncode == 0:
                    self.look_at(self.folder / "named.html")
                    self.assertIn(name.replace("javascript:", ""), self.browser.run("return document.title"))

    def test_hostile_addresses(self):
        for hash in ("#P:uG=1e999", "#__proto__=1&constructor=1", "#P:uG=</script><script>hacked=1</script>", "#time=-1e308&speed=NaN", "#eye=" + ",".join(["1e38"] * 16),
                     "#eye=" + ",".join(["0"] * 16), "#camera=__proto__&projection=constructor", "#" + "P:uG=1&" * 5000, "#%ff%00%", "#P:uG=,,,,"):
            with self.subTest(hash[:40]):
                self.open("own/quad", hash=hash)
                self.assertEqual(self.browser.run("return typeof hacked"), "undefined")
                self.type_into("[aria-label='uG of P, number']", ".25")
                self.browser.click("[aria-label='Reset the view (R)']" if self.browser.run("return !document.querySelector(\"[aria-label='Reset the view (R)']\").disabled") else "canvas")
                self.assert_shows(self.render("own/quad", "--set", "uG=.25"))


class Loops(unittest.TestCase):
    """Loops without an end, by the rasteriser of this machine and by Chromium's own."""
    MOST = 8  # seconds

    LOOPS = {
        "while (true) n += uG;": "",
        "for (;;) { n += fract(n * uG + 1.); if (n < 0.) break; }": "",
        "for (int i = 0; i < 1000000000; ++i) n += fract(n + uG);": "up to 1,000,000,000 rounds",
        "for (int i = 0; i < 60000; ++i) for (int j = 0; j < 60000; ++j) n += fract(n + uG);": "rounds",
        "do n += uG; while (n > -1.);": "",
    }

    def alive(self, browser):
        """The page draws some frames, and its process for graphics is the same."""
        began = time.time()
        browser.run("globalThis.frames = 0; const count = () => { ++frames; requestAnimationFrame(count); }; count();")
        while browser.run("return frames") < 4:
            self.assertLess(time.time() - began, self.MOST, "the page stands still")
            time.sleep(0.05)
        self.assertFalse(browser.run("return seen.context.isContextLost()"))

    def test_they_leave_the_page_alive_and_are_named(self):
        for driver in ("mesa", True):
            with tempfile.TemporaryDirectory() as folder, Browser(1400, 1000, gl=driver) as browser:
                for name, text in (("quad.glib", QUAD), ("quad.vert", VERTEX), ("quad.frag", FRAGMENT)):
                    pathlib.Path(folder, name).write_text(text, encoding="utf-8")
                self.assertEqual(glibra("publish", f"{folder}/quad.glib", "-o", f"{folder}/page.html").returncode, 0)
                browser.command("Page.addScriptToEvaluateOnNewDocument", source=BEFORE)
                browser.open(f"file://{folder}/page.html")
                browser.wait(IS_DRAWN)
                before = browser.run(PICTURE)
                fragment = FRAGMENT.replace("main() { fColor = vec4(uG, ", "main() { float n = 0.;\n LOOP\n fColor = vec4(fract(n), ")
                vertex = VERTEX.replace("uniform", "uniform float uG;\nuniform").replace("main() {", "main() {\n float n = 0.;\n LOOP").replace("1.); }", "1. + step(n, -2.)); }")
                for name, original, text in (("quad.frag", FRAGMENT, fragment), ("quad.vert", VERTEX, vertex)):
                    line = text[:text.index("LOOP")].count("\n") + 1
                    for loop, said in self.LOOPS.items():
                        with self.subTest(driver=driver, file=name, loop=loop):
                            began = time.time()
                            Pages.edit(self, name, text.replace("LOOP", loop), browser)
                            browser.wait("return new RegExp(arguments[0]).test(document.querySelector('.messages').innerText)",
                                         f"{name}:{line}:\\d+: warning: .*{said}.*draw-W08")
                            self.assertLess(time.time() - began, self.MOST)
                            self.alive(browser)
                            Pages.edit(self, name, original, browser)
                            browser.wait("return document.querySelector('.messages').hidden")
                            browser.wait(f"{PICTURE} === arguments[0]", before)
                # A value decides how long it is.
                Pages.edit(self, "quad.frag", fragment.replace("LOOP", "while (n < uG * 1e9) n += uG;"), browser)
                named = "return /quad.frag:5:.*draw-W08/.test(document.querySelector('.messages').innerText)"
                browser.wait(named)
                for value, isLong in (("0", False), ("1", True), ("0", False)):
                    browser.run("""const field = document.querySelector("[aria-label='uG of P, number']"); field.value = arguments[0];
                        for (const each of ["input", "change"]) field.dispatchEvent(new Event(each, {bubbles: true}));""", value)
                    browser.wait(named if isLong else "return document.querySelector('.messages').hidden")
                    time.sleep(0.6)
                    self.assertEqual(browser.run(named), isLong, value)
                    self.alive(browser)


if __name__ == "__main__":
    if not shutil.which("chromium") or not shutil.which("chromedriver"):
        sys.exit(77)
    GLIBRA = os.path.abspath(sys.argv.pop(1))
    unittest.main(verbosity=2)
