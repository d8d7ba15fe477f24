#!/usr/bin/env python3
"""The page of a class in Chromium, from file://, at the width of a small laptop, light and dark, without scripts.

usage: class_test.py GLIBRA [--pictures FOLDER [SITE]]     (the second writes screenshots to look at, of SITE if given)
"""
import base64
import contextlib
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import webdriver

PROGRAM = None
WIDTH, HEIGHT = 1366, 768

VERTEX = """#version 330 core
out vec3 vN;
void main() { vN = uNormalMatrix * aNormal; gl_Position = uModelViewProjectionMatrix * aVertex; }
"""
FRAGMENT = """#version 330 core
in vec3 vN;
uniform float uTone, uEdge;
out vec4 f;
OWN
void main() {
    vec3 n = normalize(vN);
    float shade = uEdge + TONE * max(n.z, 0.);
    f = vec4(shade * vec3(.9, .7, .4) * smoothstep(uEdge, .4, n.z), 1.);
}
"""
COPIED = """vec3 tint(vec3 at, float by) {
    vec3 sum = vec3(0.);
    for (int i = 0; i < 4; ++i) {
        sum += mix(at, at.zxy, by) * float(i) / 6.;
        at = reflect(at, normalize(sum + .1));
    }
    return clamp(sum, 0., 1.);
}"""
SCENE = """WindowSize 320 240
LookAt 0 0 3.4 0 0 0 0 1 0
Vertex NAME.vert
Fragment NAME.frag
Program Ball uTone <0. .8 1.> uEdge .1
Sphere 1 60 60
"""


def possible(name):
    """The name, or, for a program of Windows, one that Windows has."""
    return re.sub("[<>='.]", "_", name) if "WINEPREFIX" in os.environ else name


NAMES = ["Ada Lovelace", "Bo", possible("<img src=x onerror=document.title='hacked'>"), "Dörte Müller-Lüdenscheidt-von-der-Heide",
         "Erin", "Farid", "Grace", "Hedy", "Ines", "a-very-long-name-without-any-blank-" * 4]

# Contrast of the text of an element with the nearest background that is not transparent (WCAG 2.1).
CONTRAST = """
const parse = (text) => text.match(/[\\d.]+/g).map(Number);
const luminance = (color) => {
    const [r, g, b] = color.slice(0, 3).map((each) => each / 255).map((each) => each <= 0.03928 ? each / 12.92 : ((each + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
};
const result = {};
for (const selector of arguments[0]) {
    const element = document.querySelector(selector);
    let behind = element;
    while (behind && (parse(getComputedStyle(behind).backgroundColor)[3] ?? 1) === 0) behind = behind.parentElement;
    const one = luminance(parse(getComputedStyle(element).color)), other = luminance(parse(getComputedStyle(behind).backgroundColor));
    result[selector] = (Math.max(one, other) + 0.05) / (Math.min(one, other) + 0.05);
}
return result;
"""


def hand_in(folder, name, own="", tone="uTone"):
    os.makedirs(folder, exist_ok=True)
    if "tint(" in own:  # code that nobody calls is compared with none; this call changes no pixel
        tone = f"({tone} * step(-1., tint(vec3(uTone), uTone).x))"
    files = {".vert": VERTEX, ".frag": FRAGMENT.replace("OWN", own).replace("TONE", tone),
             ".glib": SCENE.replace("NAME", name)}
    for ending, text in files.items():
        with open(os.path.join(folder, name + ending), "w", encoding="utf-8") as file:
            file.write(text)


def make_site(folder, *more):
    hand_in(folder, "solution")
    tones = ["uTone", "uTone * .95", "(1. - uTone)", "uTone * n.x", "wrong", "uTone", "uTone", "uTone", "uTone", "uTone"]
    for number, (name, tone) in enumerate(zip(NAMES, tones)):
        own = COPIED if number in (0, 3) else COPIED.replace("sum", "total") if number == 1 else ""
        hand_in(os.path.join(folder, "all", name), "ball", own, tone)
    os.makedirs(os.path.join(folder, "all", "Zoe"))
    subprocess.run([PROGRAM, "class", "all", "--reference", "solution.glib", "-o", "site", *more], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return "file://" + os.path.join(folder, "site", "index.html")


class ClassPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.stack = contextlib.ExitStack()
        cls.folder = cls.stack.enter_context(tempfile.TemporaryDirectory())
        cls.page = make_site(cls.folder, "--sweep", "uEdge = [0.1, 0.3]")
        cls.browser = cls.stack.enter_context(webdriver.Browser(WIDTH, HEIGHT))
        cls.browser.command("Emulation.setDeviceMetricsOverride", width=WIDTH, height=HEIGHT, deviceScaleFactor=1, mobile=False)
        cls.browser.requests()

    @classmethod
    def tearDownClass(cls):
        cls.stack.close()

    def setUp(self):
        self.size(WIDTH, HEIGHT)
        self.browser.open("about:blank")
        self.browser.open(self.page)

    def tearDown(self):
        self.assertEqual([each["message"] for each in self.browser.logs("browser")], [], "the console is silent")

    def size(self, width, height):
        self.browser.command("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                             mobile=False)

    def test_everybody_has_a_card_and_a_line(self):
        names = self.browser.run("return [...document.querySelectorAll('.card h3 bdi')].map((each) => each.textContent)")
        self.assertEqual(sorted(names), sorted(NAMES + ["Zoe"]))
        lines = self.browser.run("return [...document.querySelectorAll('.overview tbody th')].map((each) => each.textContent)")
        self.assertEqual(sorted(lines), sorted(names))
        self.assertEqual(self.browser.run("return document.querySelector('h1').textContent"),
                         "11 submissions: 9 drawn, 1 failed, 1 without a scene")

    def test_pictures_of_the_first_screen_do_not_wait_for_it(self):
        self.browser.wait("return document.readyState === 'complete'")
        early = self.browser.run("return [...document.images].filter((each) => each.loading !== 'lazy').map((each) => each.complete && each.naturalWidth)")
        self.assertEqual(early, [320] * 24)
        self.assertGreater(self.browser.run("return [...document.images].filter((each) => each.loading === 'lazy').length"), 5)

    def test_pictures_are_beside_the_reference_in_its_size(self):
        pairs = self.browser.run("""return [...document.querySelectorAll('#drawn .pair')].map((pair) =>
            [...pair.querySelectorAll('img')].map((each) => { each.loading = 'eager'; return each.getAttribute('src'); }))""")
        self.assertEqual(len(pairs), 9 * 2)
        for reference, own in pairs:
            self.assertRegex(reference, r"^pictures/0000-[12]\.png$")
            self.assertEqual(reference[-5], own[-5], "the same moment")
        self.browser.wait("return [...document.querySelectorAll('#drawn img')].every((each) => each.complete)")
        sizes = self.browser.run("return [...document.querySelectorAll('#drawn img')].map((each) => [each.naturalWidth, each.naturalHeight])")
        self.assertEqual(sizes, [[320, 240]] * len(sizes))
        boxes = self.browser.run("""return [...document.querySelectorAll('#drawn .pair')].map((pair) =>
            [...pair.querySelectorAll('img')].map((each) => each.getBoundingClientRect().top))""")
        for left, right in boxes:
            self.assertAlmostEqual(left, right, delta=1)

    def test_what_strangers_wrote_is_text(self):
        self.assertNotEqual(self.browser.run("return document.title"), "hacked")
        self.assertEqual(self.browser.run("return document.querySelectorAll('img[src=x], script:not([src$=js])').length"), 0)

    def test_the_message_of_the_failed_one_is_open(self):
        text = self.browser.run("return document.querySelector('#failed').innerText")
        self.assertIn("wrong", text)
        self.assertIn("ball.frag:", text)
        self.assertIn("the folder has no scene", text)

    def test_similar_code_opens_side_by_side(self):
        first = "document.querySelector('.similar')"
        share = re.match(r"\s*(\d+) % of ", self.browser.run(f"return {first}.querySelector('summary').textContent"))
        self.assertGreater(int(share[1]), 80)  # the copied function; what they call it with is their own
        self.browser.run(f"{first}.querySelector('summary').click()")
        self.assertTrue(self.browser.run(f"return {first}.open"))
        left, right = self.browser.run(f"""return [...{first}.querySelectorAll('.sides > div')].slice(0, 2).map((each) =>
            {{ const box = each.getBoundingClientRect(); return [box.left, box.top, box.width]; }})""")
        self.assertLess(left[0] + left[2], right[0] + 1)
        self.assertEqual(left[1], right[1])
        texts = self.browser.run(f"return [...{first}.querySelectorAll('.source')].map((each) => each.textContent)")
        self.assertIn("mix(at, at.zxy, by)", texts[0])
        self.assertIn("mix(at, at.zxy, by)", texts[1])

    def test_links_lead_to_their_places(self):
        links = self.browser.run("return [...document.querySelectorAll('a[href^=\"#\"]')].map((each) => each.getAttribute('href').slice(1))")
        self.assertGreater(len(links), 11)
        self.assertEqual([each for each in links if not self.browser.run("return !!document.getElementById(arguments[0])", each)], [])
        self.browser.run("document.querySelector('.overview tbody a').click()")
        target = self.browser.run("return document.querySelector('.card:target').getBoundingClientRect().top")
        header = self.browser.run("return document.querySelector('header').getBoundingClientRect().bottom")
        self.assertGreaterEqual(target, header - 1, "it is not below the header")

    def test_nothing_is_wider_than_the_window(self):
        for width, height in ((WIDTH, HEIGHT), (800, 600), (420, 900)):
            self.size(width, height)
            self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), width)
        self.size(WIDTH, HEIGHT)
        columns = self.browser.run("return new Set([...document.querySelectorAll('#drawn .card')].map((each) => each.offsetLeft)).size")
        self.assertEqual(columns, 3)

    def test_text_is_readable_light_and_dark(self):
        wanted = ["h1", "nav a", ".card h3 a, .card h3 bdi", "figcaption", ".near", ".near a", ".verdict.passed", ".verdict.failed",
                  ".verdict.missing", ".remark.error", ".overview th", ".overview a", "small", ".run summary"]
        backs = []
        for scheme in ("light", "dark"):
            self.browser.command("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
            for selector, contrast in self.browser.run(CONTRAST, wanted).items():
                self.assertGreaterEqual(contrast, 4.5, f"{selector}, {scheme}")
            backs.append(self.browser.run("return getComputedStyle(document.body).backgroundColor"))
        self.assertNotEqual(backs[0], backs[1])

    def test_pictures_are_compared_in_five_ways_by_buttons_and_keys(self):
        shown = "return getComputedStyle(document.querySelector('#drawn .compared figure:nth-child(%d) .shown'))[arguments[0]]"
        pressed = "return document.querySelector('.modes [aria-pressed=true]').textContent"
        place = "#drawn .compared"
        self.browser.run("document.querySelector(arguments[0]).scrollIntoView({block: 'center'})", place)
        self.assertEqual(self.browser.run(pressed), "side by side")
        seen = {}
        for key, words in (("s", "swap"), ("w", "wipe"), ("d", "difference"), ("h", "heat map"), ("b", "side by side")):
            self.browser.press(key)
            self.assertEqual(self.browser.run(pressed), words)
            self.browser.run("document.querySelector(arguments[0]).scrollIntoView({block: 'center'})", place)
            self.browser.wait("return [...document.querySelectorAll('#drawn .compared:first-of-type img')].slice(0, 2).every((each) => each.complete)")
            seen[words] = self.browser.screenshot(selector=place)
            if words == "swap":
                self.assertEqual(self.browser.run(shown % 1, "visibility"), "hidden")
                self.browser.run("document.querySelector('#drawn .compared figure:nth-child(2) .shown').click()")
                self.assertEqual(self.browser.run(shown % 1, "visibility"), "visible")
                self.assertEqual(self.browser.run(shown % 2, "visibility"), "hidden")
            if words == "wipe":
                self.browser.run("""const wipe = document.querySelector('#drawn .wipe'); wipe.value = 100;
                    wipe.dispatchEvent(new Event('input'));""")
                self.assertIn("100%", self.browser.run(shown % 2, "clipPath"))
        self.assertEqual(len(set(seen.values())), 5)
        self.browser.run("document.querySelectorAll('.modes button')[3].click()")
        self.assertEqual(self.browser.run(pressed), "difference")

    def test_the_table_is_sorted_by_each_column_and_filtered(self):
        heads = self.browser.run("return [...document.querySelectorAll('.overview thead th')].map((each) => each.textContent)")
        column = "return [...document.querySelectorAll('.overview tbody tr')].map((each) => each.cells[arguments[0]].textContent)"
        for number, head in enumerate(heads):
            before = self.browser.run(column, number)
            self.browser.run("document.querySelectorAll('.overview .sort')[arguments[0]].click()", number)
            up = self.browser.run(column, number)
            self.browser.run("document.querySelectorAll('.overview .sort')[arguments[0]].click()", number)
            down = self.browser.run(column, number)
            self.assertEqual(sorted(before), sorted(up), head)
            self.assertEqual(sorted(before), sorted(down), head)
            if head in ("likeness", "FLIP", "structure", "errors", "warnings"):
                figures = [float(each) for each in up if each]
                self.assertEqual(figures, sorted(figures), head)
                self.assertEqual([float(each) for each in down if each], sorted(figures, reverse=True), head)
        self.browser.run("""const filter = document.querySelector('.filter'); filter.value = 'no scene';
            filter.dispatchEvent(new Event('input'));""")
        left = self.browser.run("return [...document.querySelectorAll('.overview tbody tr')].filter((each) => !each.hidden).length")
        self.assertEqual(left, 1)
        cards = self.browser.run("return [...document.querySelectorAll('.card')].filter((each) => !each.hidden).map((each) => each.dataset.name)")
        self.assertEqual(cards, ["Zoe"])

    def test_each_picture_of_one_that_failed_is_beside_the_references(self):
        self.assertEqual(self.browser.run("return document.querySelectorAll('#reference .strip figure').length"), 2)
        shown = self.browser.run("return [...document.querySelectorAll('#failed img')].map((each) => each.getAttribute('src'))")
        self.assertEqual([each for each in shown if "/0000-" in each], ["pictures/0000-1.png", "pictures/0000-2.png"])
        self.assertEqual(len(shown), 4, "it has two pictures of its own, as far as it could be drawn")

    def test_printed_it_has_no_controls_and_becomes_a_pdf_file(self):
        self.browser.command("Emulation.setEmulatedMedia", media="print")
        hidden = self.browser.run("return ['.modes', '.filter', 'header nav'].map((each) => getComputedStyle(document.querySelector(each)).display)")
        self.assertEqual(hidden, ["none"] * 3)
        self.browser.command("Emulation.setEmulatedMedia", media="")
        pdf = base64.b64decode(self.browser.command("Page.printToPDF")["data"])
        self.assertTrue(pdf.startswith(b"%PDF-"))

    def test_the_page_of_a_student_is_one_file_without_the_others(self):
        with tempfile.TemporaryDirectory() as folder:
            make_site(folder, "--student-pages")
            alone = os.path.join(folder, "ada.html")
            os.rename(os.path.join(folder, "site", "students", "Ada Lovelace.html"), alone)
            shutil.rmtree(os.path.join(folder, "site"))
            self.browser.requests()
            self.browser.open("file://" + alone)
            self.browser.wait("return document.readyState === 'complete'")
            sizes = self.browser.run("return [...document.images].map((each) => each.naturalWidth)")
            self.assertEqual(sizes, [256, 256], "its picture and the reference's, made small")
            text = self.browser.run("return document.documentElement.outerHTML")
            for name in NAMES[1:]:
                if len(name) > 4:
                    self.assertNotIn(name, text)
            self.assertNotIn("like that of", text)
            self.assertEqual([url for url in self.browser.requests() if not url.startswith(("data:", "file://" + alone))], [])

    def test_nothing_is_asked_of_the_network(self):
        urls = self.browser.requests()
        self.assertTrue(any("pictures/0000-1.png" in url for url in urls), "requests are seen")
        self.assertEqual(self.browser.foreign(urls), [])


def pictures(folder, site=None):
    """Screenshots of the top, the cards and the similar code, light and dark."""
    os.makedirs(folder, exist_ok=True)
    with tempfile.TemporaryDirectory() as made, webdriver.Browser(WIDTH, HEIGHT) as browser:
        page = "file://" + os.path.abspath(os.path.join(site, "index.html")) if site else make_site(made)
        for width, height in ((WIDTH, HEIGHT), (420, 900)):
            browser.command("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
            for scheme in ("light", "dark"):
                browser.command("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
                browser.open("about:blank")
                browser.open(page)
                browser.run("[...document.images].forEach((each) => { each.loading = 'eager'; })")
                for place in ("reference", "failed", "drawn", "similar"):
                    browser.run("""const place = document.getElementById(arguments[0]);
                        document.querySelector('.similar')?.setAttribute('open', '');
                        place?.scrollIntoView()""", place)
                    browser.wait("return [...document.images].filter((each) => { const box = each.getBoundingClientRect();"
                                 " return box.bottom > 0 && box.top < innerHeight; }).every((each) => each.complete)")
                    browser.screenshot(os.path.join(folder, "%d-%s-%s.png" % (width, scheme, place)))


if __name__ == "__main__":
    if not shutil.which("chromedriver") or not shutil.which("chromium"):
        print("skipped: chromium and chromedriver are needed")
        sys.exit(77)
    PROGRAM = os.path.abspath(sys.argv[1])
    if len(sys.argv) > 3 and sys.argv[2] == "--pictures":
        pictures(*sys.argv[3:5])
    else:
        unittest.main(argv=sys.argv[:1] + sys.argv[2:], verbosity=2)
