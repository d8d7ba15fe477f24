#!/usr/bin/env python3
"""The HTML report in Chromium, from file://, as somebody uses it.

usage: browser_test.py SAMPLE_PROGRAM [--pictures FOLDER]     (the second writes screenshots to look at)
"""
import contextlib
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

import webdriver

PASSES = 5000
SAMPLE = None

# A pixel of the picture that a pane shows: the canvas pixel in the middle of it, where the whole picture is shown as
# large as it fits in whole numbers.
PIXEL = """
const [pane, width, height, x, y] = arguments;
const canvas = document.querySelector(`figure[data-pane=${pane}] canvas`);
const zoom = Math.floor(Math.min(canvas.width / width, canvas.height / height));
const left = Math.round((canvas.width - width * zoom) / 2), top = Math.round((canvas.height - height * zoom) / 2);
return [...canvas.getContext("2d").getImageData(left + Math.floor((x + .5) * zoom), top + Math.floor((y + .5) * zoom), 1, 1).data];
"""
PLACE = """
const [pane, width, height, x, y] = arguments;
const canvas = document.querySelector(`figure[data-pane=${pane}] canvas`), box = canvas.getBoundingClientRect();
const zoom = Math.floor(Math.min(canvas.width / width, canvas.height / height));
const left = Math.round((canvas.width - width * zoom) / 2), top = Math.round((canvas.height - height * zoom) / 2);
return [box.left + canvas.clientLeft + left + (x + .5) * zoom, box.top + canvas.clientTop + top + (y + .5) * zoom];
"""


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.stack = contextlib.ExitStack()
        cls.folder = cls.stack.enter_context(tempfile.TemporaryDirectory())
        subprocess.run([SAMPLE, cls.folder, str(PASSES)], check=True)
        cls.page = "file://" + os.path.join(cls.folder, "report", "index.html")
        cls.browser = cls.stack.enter_context(webdriver.Browser())
        cls.browser.open("about:blank")
        cls.browser.requests()  # what the browser's own first page asked for

    @classmethod
    def tearDownClass(cls):
        cls.stack.close()

    def setUp(self):
        self.browser.open("about:blank")
        self.browser.open(self.page)
        self.first = self.browser.wait("return document.querySelector('#panes').dataset.shown")
        self.go("sample/failed")

    def tearDown(self):
        # Reading the canvases back is the test's doing; the page never does.
        told = [each["message"] for each in self.browser.logs("browser") if "willReadFrequently" not in each["message"]]
        self.assertEqual(told, [], "the console is silent")

    def shown(self, shot):
        self.browser.wait("return document.querySelector('#panes').dataset.shown === arguments[0]", shot)

    def go(self, shot):
        self.browser.run("location.hash = '#' + encodeURIComponent(arguments[0])", shot)
        self.shown(shot)

    def pixel(self, pane, x, y, size=(64, 48)):
        return self.browser.run(PIXEL, pane, *size, x, y)

    def point(self, pane, x, y, size=(64, 48)):
        self.browser.pointer(("move", *self.browser.run(PLACE, pane, *size, x, y)))

    def values(self):
        return self.browser.run("""return Object.fromEntries([...document.querySelectorAll("#values b")]
            .map((each) => [each.dataset.value, each.textContent]))""")

    def listed(self):
        return self.browser.run("return [...document.querySelectorAll('#list .shot')].map((each) => each.dataset.id)")

    def test_failures_come_first_and_passes_are_folded(self):
        groups = self.browser.run("return [...document.querySelectorAll('.group')].map((each) => each.dataset.verdict)")
        self.assertEqual(groups, ["failed", "crashed", "timed-out", "unstable", "refused", "missing", "updated",
                                  "skipped", "changed", "passed"])
        self.assertEqual(self.first, "sample/failed")
        self.assertEqual(self.listed()[0], "sample/failed")
        tops = self.browser.run("return [...document.querySelectorAll('.group')].map((each) => each.offsetTop)")
        self.assertEqual(tops, sorted(tops))
        self.assertNotIn("sample/pass00000", self.listed())
        self.assertEqual(self.browser.run("return document.querySelector('h1').textContent"),
                         "8 of %d shots failed, 1 drawn without a golden" % (PASSES + 13))
        chips = self.browser.run("return [...document.querySelectorAll('#chips button')].map((each) => each.textContent)")
        self.assertEqual(chips, ["4 failed", "1 crashed", "1 timed-out", "1 unstable", "1 refused", "1 missing",
                                 "1 updated", "1 skipped", "1 changed", "%d passed" % (PASSES + 1)])

    def test_while_a_shot_loads_no_picture_is_said_to_be_missing(self):
        captions = "return [...document.querySelectorAll('figcaption'), document.querySelector('#zoomText')].map((each) => each.textContent)"
        told = self.browser.run("""[...document.querySelectorAll('#list .shot')].find((each) => each.dataset.id === 'sample/deep').click();
            """ + captions)
        self.assertEqual(told, ["expected", "got", "difference × 8", ""])
        self.shown("sample/deep")
        self.assertIn("expected, 8 × 8", self.browser.run(captions))
        self.go("sample/missing")
        self.assertIn("expected: no picture", self.browser.run(captions))

    def test_an_unstable_shot_shows_two_drawings(self):
        self.go("sample/unstable")
        told = self.browser.run("return [...document.querySelectorAll('figcaption')].map((each) => each.textContent)")
        self.assertEqual(told[:2], ["second drawing, 64 × 48", "first drawing, 64 × 48"])
        self.assertNotIn("golden picture", self.browser.run("return document.querySelector('#figures').textContent"))

    def test_many_passes_are_no_burden(self):
        self.assertLess(self.browser.run("return document.getElementsByTagName('*').length"), 500)
        self.assertEqual(self.browser.run("return document.images.length"),
                         len(self.listed()) - 3, "one a listed shot that has a picture")
        self.browser.run("document.querySelector('.group[data-verdict=passed] > button').click()")
        self.browser.wait("return document.querySelectorAll('.tiles .shot').length > 0")
        self.assertLess(len(self.listed()), 1500)
        last = "sample/pass%05d" % (PASSES - 1)
        self.browser.wait("""const list = document.querySelector('#list');
            list.scrollTop = list.scrollHeight;
            return [...document.querySelectorAll('.shot')].some((each) => each.dataset.id === arguments[0])""", last)

    def test_swap_changes_what_is_seen(self):
        # At 24 14: red 72 and blue 128 are expected, 77 and 119 were got.
        self.assertEqual(self.pixel("expected", 24, 14), [72, 56, 128, 255])
        self.assertEqual(self.pixel("got", 24, 14), [77, 56, 119, 255])
        before = self.browser.screenshot(selector="figure[data-pane=expected] canvas")
        self.browser.press("x")
        self.assertEqual(self.pixel("expected", 24, 14), [77, 56, 119, 255])
        self.assertEqual(self.pixel("got", 24, 14), [72, 56, 128, 255])
        self.assertNotEqual(self.browser.screenshot(selector="figure[data-pane=expected] canvas"), before)
        self.browser.press("x")
        self.assertEqual(self.browser.screenshot(selector="figure[data-pane=expected] canvas"), before)

    def test_swap_under_the_pointer_and_by_click(self):
        x, y = self.browser.run("""const box = document.querySelector('#swap').getBoundingClientRect();
            return [box.left + box.width / 2, box.top + box.height / 2]""")
        self.browser.pointer(("move", x, y))
        self.assertEqual(self.pixel("expected", 24, 14), [77, 56, 119, 255])
        self.browser.pointer(("move", x, y + 300))
        self.assertEqual(self.pixel("expected", 24, 14), [72, 56, 128, 255])
        self.browser.pointer(("move", x, y), "down", "up", ("move", x, y + 300))
        self.assertEqual(self.pixel("expected", 24, 14), [77, 56, 119, 255], "a click makes it stay")

    def test_difference_is_multiplied_by_the_factor(self):
        self.assertEqual(self.pixel("difference", 24, 14), [40, 0, 72, 255])
        self.assertEqual(self.pixel("difference", 19, 14), [0, 0, 0, 255])
        self.browser.press("]")
        self.assertEqual(self.pixel("difference", 24, 14), [80, 0, 144, 255])
        self.browser.run("""const slider = document.querySelector('#factor');
            slider.value = 0; slider.dispatchEvent(new Event('input'))""")
        self.assertEqual(self.pixel("difference", 24, 14), [5, 0, 9, 255])
        self.assertEqual(self.browser.run("return document.querySelector('#factorText').textContent"), "1")

    def test_d_shows_the_heat_map_of_the_run(self):
        self.browser.press("d")
        caption = "return document.querySelector('figure[data-pane=difference] figcaption').textContent"
        self.assertEqual(self.browser.run(caption), "heat map, 64 × 48")
        self.browser.press("d")
        self.assertEqual(self.browser.run(caption), "difference × 8, 64 × 48")

    def test_values_of_the_pixel_under_the_pointer(self):
        self.point("got", 29, 19)
        self.assertEqual(self.values(), {"pixel": "29 19", "expected": "87 76 128", "got": "92 76 119",
                                         "difference": "5 0 -9"})
        self.point("difference", 30, 19)
        self.assertEqual(self.values(), {"pixel": "30 19", "expected": "90 76 128", "got": "90 76 128",
                                         "difference": "0 0 0"})

    def test_the_pointer_is_marked_in_all_panes(self):
        sums = """return [...document.querySelectorAll('#panes canvas:not(.close)')].map((canvas) =>
            canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.reduce((a, b) => a + b, 0))"""
        before = self.browser.run(sums)
        self.point("expected", 40, 30)
        for old, new in zip(before, self.browser.run(sums)):
            self.assertNotEqual(old, new)

    def test_sixteen_bits_and_colour_under_no_alpha_are_exact(self):
        self.go("sample/deep")
        self.point("expected", 3, 2, (8, 8))
        self.assertEqual(self.values(), {"pixel": "3 2", "expected": "10000 20000 30001 0", "got": "10300 20000 30001 0",
                                         "difference": "300 0 0 0"})
        self.point("expected", 0, 0, (8, 8))
        self.assertEqual(self.values()["got"], "10300 20000 30001 65535")

    def test_pictures_of_two_sizes_are_laid_over_each_other(self):
        self.go("sample/size")
        self.assertEqual(self.pixel("difference", 10, 10), [0, 0, 0, 255])
        self.assertEqual(self.pixel("difference", 40, 10), [255, 255, 255, 255])
        self.point("got", 40, 10)
        self.assertEqual(self.values()["got"], "-")
        self.assertEqual(self.values()["expected"], "120 40 128")

    def test_a_plain_pass_is_blended_without_reading_pixels(self):
        self.go("sample/within")
        captions = self.browser.run("return [...document.querySelectorAll('figcaption')].map((each) => each.textContent)")
        self.assertEqual(captions, ["expected, 64 × 48", "got, 64 × 48", "difference × 8, 64 × 48"])
        one = self.browser.screenshot(selector="figure[data-pane=difference] canvas")
        self.browser.press("]", "]")
        self.assertNotEqual(self.browser.screenshot(selector="figure[data-pane=difference] canvas"), one)

    def test_wheel_and_drag_move_all_panes_and_f_shows_all_again(self):
        grid = """return [...document.querySelectorAll('#panes canvas:not(.close)')].map((canvas) =>
            canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.reduce((a, b) => (a * 31 + b) % 65521, 7))"""
        self.browser.pointer(("move", 5, 5))
        whole = self.browser.run(grid)
        x, y = self.browser.run(PLACE, "expected", 64, 48, 29, 19)
        self.point("expected", 29, 19)
        self.browser.wheel(x, y, -100)
        self.browser.wheel(x, y, -100)
        self.browser.pointer(("move", x, y))
        self.assertEqual(self.values()["pixel"], "29 19", "the wheel keeps the pixel under the pointer")
        self.browser.pointer(("move", 5, 5))
        larger = self.browser.run(grid)
        self.browser.pointer(("move", x, y), "down", ("move", x + 60, y + 20), "up", ("move", 5, 5))
        moved = self.browser.run(grid)
        for each in range(3):
            self.assertEqual(len({whole[each], larger[each], moved[each]}), 3)
        self.browser.press("f")
        self.assertEqual(self.browser.run(grid), whole)

    def test_the_place_that_differs_most_is_framed_and_enlarged(self):
        self.go("sample/failed")
        shown = "return [...document.querySelectorAll('#panes .close')].map((each) => !each.hidden && each.clientWidth > 0)"
        self.assertEqual(self.browser.run(shown), [True] * 3)
        place = self.browser.run("""const canvas = document.querySelector('figure[data-pane=difference] .close');
            const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
            return data.filter((each, at) => at % 4 < 3 && each > 0).length / data.length""")
        self.assertGreater(place, .05, "what differs is in it")
        zoom = "return Number.parseFloat(document.querySelector('#zoomText').textContent)"
        before = self.browser.run(zoom)
        self.browser.press("z")
        self.assertGreater(self.browser.run(zoom), before)
        self.browser.press("f")
        self.assertEqual(self.browser.run(zoom), before)
        self.go("sample/missing")
        self.assertEqual(self.browser.run(shown), [False] * 3, "nothing differs where one picture is missing")

    def test_keys_go_through_the_shots(self):
        def chosen():
            return self.browser.run("return document.querySelector('#shotName').textContent")
        order = self.listed()
        self.browser.press("k")
        self.assertEqual(chosen(), order[0])
        for expected in order[1:] + order[-1:]:
            self.browser.press("j")
            self.assertEqual(chosen(), expected)
        self.browser.press("k")
        self.assertEqual(chosen(), order[-2])
        self.assertEqual(self.browser.run("return document.querySelectorAll('[aria-current]').length"), 1)

    def test_search_and_verdicts_filter_the_list(self):
        self.browser.press("/", *"pass04")
        self.assertEqual(len(self.browser.wait("const all = [...document.querySelectorAll('.shot')]; return all.length && all.map((each) => each.dataset.id)")) % 80, 0)
        self.browser.press(*"999")
        self.assertEqual(self.listed(), ["sample/pass04999"])
        self.browser.press(*"9")
        self.assertEqual(self.browser.run("return document.querySelector('.nothing').textContent"), "No shot matches.")
        self.browser.run("""const search = document.querySelector('#search');
            search.value = ''; search.dispatchEvent(new Event('input'))""")
        self.browser.click("#chips [data-verdict=missing]")
        self.browser.click("#chips [data-verdict=crashed]")
        self.assertEqual(self.listed(), ["sample/crashed", "sample/missing"])

    def test_help_lists_the_keys(self):
        self.browser.press("?")
        self.assertTrue(self.browser.run("return document.querySelector('#help').open"))
        self.browser.press("Escape")
        self.assertFalse(self.browser.run("return document.querySelector('#help').open"))

    def test_scene_text_is_shown_as_it_is_with_its_diagnostics(self):
        self.go("sample/scene")
        with open(os.path.join(self.folder, "results", "scene.glib"), encoding="utf-8") as file:
            lines = file.read().splitlines()
        items = self.browser.run("return [...document.querySelectorAll('details .source li')].map((each) => [each.className, each.textContent])")
        self.assertEqual([text for kind, text in items if "remark" not in kind], lines)
        self.assertEqual([kind for kind, _ in items],
                         ["", "", "told", "remark error", "told", "remark warning", ""])
        self.assertIn("scene.glib:3:8: error: cannot find '<img", items[3][1])
        self.assertIn("other.frag:1:1: error: a place <outside> [glsl-E01]",
                      self.browser.run("return document.querySelector('#sources').textContent"))
        self.assertEqual(self.browser.run("return document.querySelector('#shotReason').textContent"),
                         "the scene has errors: </script><b>bold</b>")
        self.assertIsNone(self.browser.run("return document.querySelector('#sources img, #shotReason b')"))
        self.assertIsNone(self.browser.run("return window.hacked ?? null"))

    def test_commands_and_figures(self):
        codes = self.browser.run("return [...document.querySelectorAll('code')].map((each) => each.textContent)")
        self.assertEqual(codes, ["glibra render scene.glib --set 'uName=<b>\"x\" & y</b>' -o failed.png",
                                 "glibra test sample.toml --only failed --update"])
        rows = self.browser.run("return [...document.querySelectorAll('#figures tr')].map((each) => [...each.cells].map((cell) => cell.textContent))")
        self.assertIn(["largest difference", "9/255 (blue, at 20 10)", "limit 3/255"], rows)
        self.assertIn(["FLIP", "0.01230"], rows)
        self.browser.click("#commands .copy")
        self.browser.wait("return document.querySelector('#commands .copy').textContent === 'Copied'")
        self.assertEqual(self.browser.run("return document.querySelectorAll('td.beyond').length"), 3)

    def test_pictures_of_the_first_screen_do_not_wait_for_it(self):
        early = self.browser.run("return [...document.querySelectorAll('#list img')].map((each) => each.loading)")
        self.assertEqual(early[:24], ["eager"] * min(24, len(early)))
        self.browser.run("document.querySelector('.group[data-verdict=passed] button[aria-expanded=false]')?.click()")
        late = self.browser.run("return [...document.querySelectorAll('#list img')].map((each) => each.loading)")
        self.assertEqual(late, ["eager"] * 24 + ["lazy"] * (len(late) - 24))
        self.assertGreater(len(late), 24)

    def test_nothing_is_asked_of_the_network(self):
        for shot in ("sample/deep", "sample/within", "sample/scene"):
            self.browser.run("location.hash = '#' + encodeURIComponent(arguments[0])", shot)
            self.shown(shot)
        urls = self.browser.requests()
        self.assertTrue(any("pixels/%05d" % (PASSES + 9) in url for url in urls), "requests are seen")
        self.assertEqual(self.browser.foreign(urls), [])

    def test_without_scripts_everything_is_there(self):
        with open(os.path.join(self.folder, "report", "index.html"), encoding="utf-8") as file:
            page = file.read()
        plain = re.search(r"<noscript>(.*?)</noscript>", page, re.S).group(1)
        tree = xml.etree.ElementTree.fromstring(re.sub(r"(<img [^>]*)>", r"\1/>", plain))
        names = [each.text.strip() if each.text and each.text.strip() else each[-1].tail.strip() for each in tree.iter("h2")]
        self.assertEqual(names[:4], ["sample/failed", "sample/deep", "sample/size", "sample/scene"])
        self.assertIn("glibra test sample.toml --only failed --update", [each.text for each in tree.iter("code")])
        images = [each.get("src") for each in tree.iter("img")]
        self.assertGreater(len(images), 10)
        for image in images + [each.get("href") for each in tree.iter("a")]:
            self.assertTrue(os.path.isfile(os.path.join(self.folder, "report", image)), image)
        self.assertIn("sample/pass04999", [each.text for each in tree.iter("a")])

    def test_the_other_reports_of_the_sample(self):
        tree = xml.etree.ElementTree.parse(os.path.join(self.folder, "junit.xml")).getroot()
        cases = {each.get("name"): each for each in tree.iter("testcase")}
        self.assertEqual(len(cases), PASSES + 13)
        self.assertEqual(cases["scene"].find("failure").get("message"), "the scene has errors: </script><b>bold</b>")
        self.assertIsNotNone(cases["crashed"].find("error"))
        self.assertEqual(len(cases["pass00000"]), 0)
        with open(os.path.join(self.folder, "summary.txt"), encoding="utf-8") as file:
            self.assertIn("4 failed, 1 crashed", file.read().splitlines()[-1])


def pictures(folder):
    """Screenshots at two widths, light and dark."""
    os.makedirs(folder, exist_ok=True)
    with tempfile.TemporaryDirectory() as sample:
        subprocess.run([SAMPLE, sample, "300"], check=True)
        page = "file://" + os.path.join(os.environ.get("REPORT", os.path.join(sample, "report")), "index.html")
        for width, height in ((1400, 950), (420, 900)):
            with webdriver.Browser(width, height) as browser:
                browser.command("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                                mobile=False)
                for scheme in ("light", "dark"):
                    browser.command("Emulation.setEmulatedMedia", features=[
                        {"name": "prefers-color-scheme", "value": scheme}])
                    browser.open(page)
                    browser.wait("return document.querySelector('#panes').dataset.shown")
                    browser.screenshot(os.path.join(folder, "%d-%s.png" % (width, scheme)))


if __name__ == "__main__":
    if not shutil.which("chromedriver") or not shutil.which("chromium"):
        print("skipped: chromium and chromedriver are needed")
        sys.exit(77)
    SAMPLE = os.path.abspath(sys.argv[1])
    if len(sys.argv) > 3 and sys.argv[2] == "--pictures":
        pictures(sys.argv[3])
    else:
        unittest.main(argv=sys.argv[:1] + sys.argv[2:], verbosity=2)
