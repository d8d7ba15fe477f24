#!/usr/bin/env python3
"""The interface of live pages in Chromium, with mock_runtime.js in place of the runtime: from file://, without a network.

usage: page_test.py [--pictures FOLDER]     (writes screenshots to look at)
"""
import os
import shutil
import sys
import tempfile
import time
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "report"), HERE]
import mock_page  # noqa: E402
import webdriver  # noqa: E402

HOSTILE = "</script><img/src=x/onerror=document.title='hacked'><!--"
LAST = "return told.frames.at(-1)?.[arguments[0]] ?? null"
VALUE = "return runtime.knobs[arguments[0]].current"


class Browser(webdriver.Browser):
    def wait(self, script, *arguments):
        end = time.time() + 20
        while not (value := self.run(script, *arguments)):
            if time.time() > end:
                raise AssertionError("never: " + script)
            time.sleep(0.02)
        return value


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp(prefix="glibra-page-")
        cls.browser = Browser(1400, 1000, gl=True).__enter__()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        shutil.rmtree(cls.folder)

    def setUp(self):
        self.browser.command("Emulation.clearDeviceMetricsOverride")
        self.browser.logs("browser")
        self.browser.requests()

    def tearDown(self):
        self.assertEqual([each["message"] for each in self.browser.logs("browser") if each["level"] == "SEVERE"], [])
        self.assertEqual(self.browser.foreign(self.browser.requests()), [])

    def open(self, files=None, hash="", **data):
        name = os.path.join(self.folder, "page.html")
        with open(name, "w", encoding="utf-8", errors="surrogateescape") as file:
            file.write(mock_page.page(files, **data))
        self.browser.open("about:blank")
        self.browser.open(f"file://{name}{hash}")
        if not data.get("poster"):
            self.browser.wait("return told.frames.length > 0")

    def still(self, **more):
        self.open({"ball.glib": mock_page.SCENE.replace("Timer 2\n", "")}, **more)

    def type_into(self, selector, value):
        self.browser.run("""const field = document.querySelector(arguments[0]); field.value = arguments[1];
            for (const each of ["input", "change"]) field.dispatchEvent(new Event(each, {bubbles: true}));""", selector, value)

    def test_a_moved_slider_moves_the_knob_the_number_and_the_link(self):
        self.still()
        self.type_into("[type=range][aria-label='uTone of Ball']", "0.25")
        self.assertEqual(self.browser.run(VALUE, 2), [0.25])
        self.assertEqual(self.browser.run("return document.querySelector(\"[aria-label='uTone of Ball, number']\").value"), "0.25")
        self.browser.wait("return location.hash === '#Ball:uTone=0.25'")
        self.browser.click("[aria-label='Reset uTone of Ball']")
        self.assertEqual(self.browser.run(VALUE, 2), [0.8])
        self.browser.wait("return location.hash === ''")

    def test_all_kinds_of_values_have_inputs(self):
        self.still()
        self.type_into("[aria-label='show']", "striped")
        self.type_into("[aria-label='uTint of Ball']", "#ff0080")
        self.type_into("[aria-label='uPlace of Ball, z']", "2.5")
        self.type_into("[aria-label='uCount of Ball']", "0.4")
        self.type_into("[aria-label='size, number']", "5")
        self.type_into("[type=range][aria-label='uKd']", "1")
        self.browser.run("document.querySelector(\"[aria-label='uOn of Ball']\").click()")
        got = [self.browser.run(VALUE, each) for each in range(9)]
        self.assertEqual(got, [[5], [1], [0.8], [0], [1, 0, 128 / 255], [0, 1, 2.5], [4], [1], [1]])
        self.browser.click(".reset-all")
        self.assertEqual(self.browser.run(VALUE, 0), [1])
        self.assertTrue(self.browser.run("return document.querySelector('.reset-all').disabled"))

    def test_every_control_has_a_name(self):
        self.open()
        self.assertEqual(self.browser.run("""return [...document.querySelectorAll("button, input, select, textarea, canvas")]
            .filter((each) => !(each.getAttribute("aria-label") || each.textContent.trim() || each.labels?.[0]?.textContent.trim())).map((each) => each.outerHTML)"""), [])

    def test_a_link_shows_what_one_saw(self):
        self.open(hash="#Ball:uTone=.3&show=1&:show=1&time=2.5&speed=2&camera=lamp&projection=orthographic&eye=1,0,0,0,0,1,0,0,0,0,1,0,0,0,-3,1&uNone=1&scene=1,2")
        self.assertEqual(self.browser.run(VALUE, 2), [0.3])
        self.assertEqual(self.browser.run(VALUE, 1), [1])
        self.browser.wait("return told.frames.at(-1).time === 2.5")
        view = self.browser.run(LAST, "view")
        self.assertEqual((view["eye"][14], view["projection"], view["scene"][0]), (-3, "orthographic", 1))
        self.assertEqual(self.browser.run("return [runtime.camera, document.querySelector('.speed').value]"), ["lamp", "2"])
        # The address is the same after the page has written it itself.
        self.browser.wait("return location.hash.includes('eye=1,0')")
        self.assertIn("time=2.5", self.browser.run("return location.hash"))
        self.browser.run("location.hash = '#Ball:uTone=0.9'")
        self.browser.wait("return runtime.knobs[2].current[0] === 0.9")

    def test_nothing_is_drawn_while_nothing_moves_or_can_be_seen(self):
        self.still()
        count = "return told.frames.length"
        time.sleep(0.4)
        before = self.browser.run(count)
        time.sleep(0.4)
        self.assertEqual(self.browser.run(count), before)
        self.open()
        before = self.browser.run(count)
        self.browser.wait("return told.frames.length > arguments[0] + 3", before)
        self.browser.click("[aria-label='Pause (Space)']")
        time.sleep(0.2)
        before = self.browser.run(count)
        time.sleep(0.3)
        self.assertEqual(self.browser.run(count), before)
        self.browser.press(" ")
        self.browser.wait("return told.frames.length > arguments[0] + 3", before)
        self.browser.run("document.body.style.paddingTop = '3000px'; scrollTo(0, 0)")
        time.sleep(0.4)
        before = self.browser.run(count)
        time.sleep(0.4)
        self.assertEqual(self.browser.run(count), before)

    def test_time_is_stepped_typed_and_restarted(self):
        self.open()
        self.type_into(".seconds", "1.5")
        self.browser.wait("return told.frames.at(-1).time === 1.5")
        self.browser.press(".")
        self.browser.wait("return Math.abs(told.frames.at(-1).time - 1.5 - 1 / 30) < 1e-9")
        self.browser.press(",", ",")
        self.browser.wait("return Math.abs(told.frames.at(-1).time - 1.5 + 1 / 30) < 1e-9")
        self.browser.click("[aria-label='Restart at 0 seconds']")
        self.browser.wait("return told.frames.at(-1).time === 0")

    def test_the_mouse_rotates_scales_and_pans_as_in_the_window(self):
        self.still()
        box = self.browser.run("const r = document.querySelector('canvas').getBoundingClientRect(); return [r.left, r.top]")
        x, y = box[0] + 100, box[1] + 100
        # A drag across the shorter side, 384 pixels, rotates by 180 degrees about the origin, which is 5 away.
        self.browser.pointer(("move", x, y), "down", ("move", x + 192, y), "up")
        eye = self.browser.run(LAST, "view")["eye"]
        for got, wanted in zip(eye, [0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 5, 0, -5, 1]):
            self.assertAlmostEqual(got, wanted, places=9)
        self.browser.press("r")
        self.browser.wait("return told.frames.at(-1).view.eye[12] === 0")
        self.browser.wheel(x, y, -100)
        self.browser.wait("return told.frames.at(-1).view.eye[0] > 1")
        self.assertAlmostEqual(self.browser.run(LAST, "view")["eye"][0], 10 ** (20 / 384), places=9)
        self.browser.press("1")
        self.browser.pointer(("move", x, y), "down", ("move", x, y + 96), "up")
        self.assertAlmostEqual(self.browser.run(LAST, "view")["scene"][6], 2 ** -0.5, places=9)
        self.browser.press("p")
        self.browser.wait("return told.frames.at(-1).view.projection === 'orthographic'")

    def test_two_fingers_scale(self):
        self.still()
        left, top = self.browser.run("const r = document.querySelector('canvas').getBoundingClientRect(); return [r.left, r.top]")
        def touch(kind, *points):
            self.browser.command("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": left + a, "y": top + b, "id": i} for i, (a, b) in enumerate(points)])
        touch("touchStart", (200, 200), (300, 200))
        touch("touchMove", (150, 200), (350, 200))
        touch("touchEnd")
        self.browser.wait("return Math.abs(told.frames.at(-1).view.eye[0] - 2) < 1e-6")

    def test_keys_of_the_scene_come_first_and_cameras_change(self):
        self.still()
        self.browser.press("k")
        self.assertEqual(self.browser.run(VALUE, 0), [1.5])
        self.browser.press("c")
        self.assertEqual(self.browser.run("return runtime.camera"), "eye")
        self.type_into("[aria-label='Camera (C)']", "lamp")
        self.assertEqual(self.browser.run("return runtime.camera"), "lamp")
        for act in ("keyDown", "keyUp"):
            self.browser.ask("POST", self.browser.session + "/actions", {"actions": [{"type": "key", "id": "keys", "actions": [{"type": act, "value": "g"}]}]})
            self.browser.wait("return runtime.knobs[0].current[0] > 1.55")
        # What is typed is no key.
        self.browser.run("document.querySelector('textarea').focus()")
        self.browser.press("k", "c")
        self.assertEqual(self.browser.run("return runtime.camera"), "lamp")

    def test_a_text_is_edited_with_an_error_and_without(self):
        self.still()
        self.browser.run("const area = document.querySelector('textarea'); area.value += 'Spere 1\\n'; area.dispatchEvent(new Event('input'))")
        self.browser.wait("return document.querySelector('.messages button')?.textContent === \"ball.glib:7:1: error: unknown command 'Spere'; did you mean 'Sphere'? [glib-E01]\"")
        self.assertEqual(self.browser.run("return [...document.querySelectorAll('.code li')].map((each) => each.className).join()"), ",,,,,,error,")
        self.browser.click(".messages button")
        self.assertEqual(self.browser.run("const a = document.activeElement; return a.value.slice(a.selectionStart, a.selectionEnd)"), "Spere 1")
        self.browser.click(".tabrow > button")
        self.browser.wait("return document.querySelector('.messages').hidden && !document.querySelector('.code .error')")
        self.assertEqual(self.browser.run("return runtime.files.get('ball.glib')"), mock_page.SCENE.replace("Timer 2\n", ""))
        self.browser.click(".tabs button:nth-child(2)")
        self.assertEqual(self.browser.run("return document.querySelector('textarea').value"), mock_page.FILES["ball.frag"])

    def test_lines_of_the_text_and_of_its_colours_are_in_the_same_places(self):
        self.still()
        self.assertEqual(self.browser.run("""const area = document.querySelector("textarea"), style = getComputedStyle(area), item = getComputedStyle(document.querySelector(".code li"));
            const rows = document.querySelectorAll(".code li"), box = area.getBoundingClientRect();
            return [style.font === item.font, Math.abs(box.top + parseFloat(style.paddingTop) - rows[0].getBoundingClientRect().top) < .6,
                    Math.abs(box.left + parseFloat(style.paddingLeft) - rows[0].getBoundingClientRect().left - parseFloat(item.paddingLeft)) < .6,
                    Math.abs(rows[1].offsetTop - rows[0].offsetTop - parseFloat(style.lineHeight)) < .1]"""), [True] * 4)

    def test_nothing_of_a_scene_becomes_script(self):
        scene = mock_page.SCENE.replace("Timer 2\n", "").replace("Program Ball uTone", f"Program {HOSTILE} {HOSTILE}") + f"Spere{HOSTILE} 1\n"
        self.open({"ball.glib": scene, f"a{HOSTILE.replace('/', '')}.frag": HOSTILE, "nul.frag": "a\0b\x01"})
        self.assertEqual(self.browser.run("return [document.title, document.querySelectorAll('img').length]"), ["ball", 0])
        self.assertIn(HOSTILE, self.browser.run("return document.querySelector('.panel').textContent"))
        for number in range(1, 6):
            self.browser.click(f".tabs button:nth-child({number})")
        self.browser.run("document.querySelectorAll('[title]').forEach((each) => each.dispatchEvent(new MouseEvent('mouseover')))")
        self.assertEqual(self.browser.run("return document.title"), "ball")

    def test_the_picture_stands_there_until_it_is_clicked(self):
        self.open(poster=True, embed=True)
        self.assertEqual(self.browser.run("return [told.opened, document.querySelector('.poster').complete, document.querySelector('canvas')]"), [0, True, None])
        self.browser.click(".note button")
        self.browser.wait("return told.frames.length > 0 && !document.querySelector('.poster')")

    def test_values_of_the_command_are_there_at_first(self):
        self.open(set=[{"program": "", "name": "show", "values": [], "word": "striped"}, {"program": "Floor", "name": "uKd", "values": [.25], "word": ""}], time=3, width=256, height=192)
        self.assertEqual([self.browser.run(VALUE, each) for each in (1, 7, 8)], [[1], [0.5], [0.25]])
        self.assertTrue(self.browser.run("return document.querySelector('.reset-all').disabled"))
        self.assertGreaterEqual(self.browser.run(LAST, "time"), 3)
        self.assertEqual(self.browser.run(LAST, "width"), 256)

    def test_a_lost_context_comes_back_with_all_values(self):
        self.still()
        self.type_into("[type=range][aria-label='uTone of Ball']", "0.25")
        self.browser.run("globalThis.loser = runtime.context.getExtension('WEBGL_lose_context'); loser.loseContext()")
        self.browser.wait("return !document.querySelector('.note').hidden")
        self.browser.run("told.frames.length = 0; loser.restoreContext()")
        self.browser.wait("return document.querySelector('.note').hidden && told.frames.length > 0")
        self.browser.run("runtime.context.getExtension('WEBGL_lose_context').loseContext()")
        self.browser.wait("return !document.querySelector('.note').hidden")
        self.browser.run("told.frames.length = 0")
        self.browser.click(".note button")  # a new context
        self.browser.wait("return told.frames.length > 0 && runtime.knobs[2].current[0] === 0.25")

    def test_a_phone_has_it_all_in_one_column(self):
        self.browser.command("Emulation.setDeviceMetricsOverride", width=390, height=844, deviceScaleFactor=3, mobile=True)
        self.open()
        self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), 390)
        self.assertLessEqual(self.browser.run(LAST, "width"), 2 * 390)
        self.assertTrue(self.browser.run("return [...document.querySelectorAll('.bar button')].every((each) => each.hidden || each.offsetWidth === 0 || each.offsetWidth >= 36)"))

    def test_the_picture_is_saved_and_shown_on_the_full_screen(self):
        self.open()
        self.browser.run("""globalThis.saved = []; HTMLAnchorElement.prototype.click = function () { saved.push(this.download); };""")
        self.browser.click("[aria-label='Save the picture']")
        self.browser.wait("return saved[0] === 'ball.png'")
        self.browser.click("[aria-label='Full screen (F)']")
        self.browser.wait("return document.fullscreenElement?.matches('.live') && told.frames.at(-1).width === innerWidth")
        self.browser.run("document.exitFullscreen()")
        self.browser.wait("return told.frames.at(-1).width === 512")

    def test_it_runs_in_a_sandbox_without_an_origin(self):
        for name, text in (("page.html", mock_page.page()), ("outer.html", '<!doctype html><iframe sandbox="allow-scripts" src="page.html" width="900" height="700"></iframe>')):
            with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        self.browser.open(f"file://{self.folder}/outer.html")
        self.browser.ask("POST", self.browser.session + "/frame", {"id": {webdriver.ELEMENT: self.browser.element("iframe")}})
        self.browser.wait("return globalThis.told?.frames.length > 3")
        self.type_into("[type=range][aria-label='uTone of Ball']", "0.25")
        self.browser.wait("return location.hash.startsWith('#Ball:uTone=0.25')")
        self.browser.ask("POST", self.browser.session + "/frame", {"id": None})


def pictures(folder):
    os.makedirs(folder, exist_ok=True)
    with webdriver.Browser(1400, 1000, gl=True) as browser:
        for name, data in {"page": {}, "wrong": {"files": {"ball.glib": mock_page.SCENE + "Spere 1\n"}}, "embed": {"embed": True}, "poster": {"poster": True}}.items():
            for scheme in ("light", "dark"):
                browser.command("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
                with open(os.path.join(folder, "page.html"), "w", encoding="utf-8") as file:
                    file.write(mock_page.page(**data))
                browser.open("file://" + os.path.abspath(os.path.join(folder, "page.html")))
                time.sleep(1)
                browser.screenshot(os.path.join(folder, f"{name}_{scheme}.png"))


if __name__ == "__main__":
    if sys.argv[1:2] == ["--pictures"]:
        sys.exit(pictures(sys.argv[2]))
    if not shutil.which("chromium") or not shutil.which("chromedriver"):
        sys.exit(77)
    unittest.main(argv=sys.argv[:1], verbosity=2)
