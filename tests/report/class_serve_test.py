#!/usr/bin/env python3
"""`glibra class --serve` in Chromium: points and comments are typed by two browsers at once, kept, and survive a new run.

usage: class_serve_test.py GLIBRA [--pictures FOLDER]     (the second writes screenshots to look at)
"""
import contextlib
import csv
import http.client
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

import class_test
import webdriver

PROGRAM = None
CY = class_test.possible("<b>Cy")
RUBRIC = """[[check]]
name = "is drawn"
drawn = true
points = 4
[[check]]
name = "report"
by-hand = true
points = 6
[[check]]
name = "a nice extra"
by-hand = true
bonus = true
points = 2
"""
POINTS = "#%s .points[data-check='%s'] input"


class Served(unittest.TestCase):
    def setUp(self):
        self.stack = contextlib.ExitStack()
        self.folder = self.stack.enter_context(tempfile.TemporaryDirectory())
        class_test.hand_in(self.folder, "solution")
        for name in ("Ada", "Bo", CY):
            class_test.hand_in(os.path.join(self.folder, "all", name), "ball", tone="wrong" if name == "Bo" else "uTone")
        self.write("class.toml", RUBRIC)
        self.server = None
        self.serve()

    def tearDown(self):
        self.end()
        self.stack.close()

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    def read(self, name):
        with open(os.path.join(self.folder, name), encoding="utf-8-sig") as file:
            return file.read()

    def grades(self):
        return {row["submission"]: row for row in csv.DictReader(self.read("site/grades.csv").splitlines())}

    def command(self, *more):
        return [PROGRAM, "class", "all", "--reference", "solution.glib", "-o", "site", "--rubric", "class.toml", "--size", "160x120", *more]

    def serve(self, *more):
        self.server = subprocess.Popen(self.command("--serve", *more), cwd=self.folder, stderr=subprocess.PIPE, text=True)
        for line in self.server.stderr:
            found = re.search(r"http://127\.0\.0\.1:(\d+)/([0-9a-f]+)/", line)
            if found:
                self.address, self.port, self.token = found.group(), int(found.group(1)), found.group(2)
                return
        self.fail("no address was printed")

    def end(self):
        if self.server:
            self.server.send_signal(signal.SIGINT)
            self.assertEqual(self.server.wait(20), 0)
            self.server.stderr.close()
            self.server = None

    def open(self):
        browser = self.stack.enter_context(webdriver.Browser(1366, 768))
        browser.open(self.address)
        browser.wait("return document.querySelectorAll('.commentField').length === 3")
        return browser

    @staticmethod
    def type(browser, selector, text):
        """As a teacher does: a click, the old text away, the new one, and away from the field."""
        browser.run("document.querySelector(arguments[0]).scrollIntoView({block: 'center'})", selector)
        browser.run("document.querySelector('.saved').textContent = ''")
        browser.click(selector)
        browser.run("document.activeElement.select()")
        browser.press("\ue003", *text)
        browser.run("document.activeElement.blur()")
        browser.wait("return /saved/.test(document.querySelector('.saved').textContent)")
        return browser.run("return document.querySelector('.saved').textContent")

    @staticmethod
    def card(browser, name):
        return browser.run("return [...document.querySelectorAll('.card')].find((each) => each.dataset.name === arguments[0]).id", name)

    def test_what_is_typed_is_shown_kept_and_survives_a_new_run(self):
        browser = self.open()
        ada, bo = self.card(browser, "Ada"), self.card(browser, "Bo")
        self.assertEqual(self.type(browser, POINTS % (ada, "report"), "4.5"), "saved")
        self.assertEqual(self.type(browser, POINTS % (ada, "a nice extra"), "2"), "saved")
        self.assertEqual(self.type(browser, f"#{bo} .commentField", 'It does <not> compile; ask "me"!'), "saved")
        said = self.type(browser, POINTS % (bo, "report"), "99")
        self.assertIn("not saved", said)
        self.assertIn("more than the 6 points", said)
        total = "return document.querySelector(`#${arguments[0]} .marks tfoot td`).textContent"
        self.assertEqual(browser.run(total, ada), "10.5")
        self.assertEqual(browser.run("return document.querySelector(arguments[0]).value", POINTS % (bo, "report")), "99", "it stays to be corrected")
        row = "return document.querySelector(`.overview a[href='#${arguments[0]}']`).closest('tr').querySelector('.points').textContent"
        self.assertEqual(browser.run(row, ada), "10.5")
        lines = """return [...document.querySelectorAll('.marks td:nth-child(3)')].map((each) =>
            { const text = document.createRange(); text.selectNodeContents(each); return text.getClientRects().length; })"""
        self.assertEqual(set(browser.run(lines)), {1}, "'of 10' stands in one line")
        # An empty field gives the points of the check back.
        drawn = POINTS % (ada, "is drawn")
        self.type(browser, drawn, "1")
        self.assertEqual(browser.run(total, ada), "7.5")
        self.type(browser, drawn, "")
        self.assertEqual(browser.run(total, ada), "10.5")
        kept = json.loads(self.read("site/marks.json"))
        self.assertEqual(kept["Ada"]["points"], {"report": 4.5, "a nice extra": 2})
        self.assertNotIn("report", kept["Bo"]["points"])
        self.assertEqual(kept["Bo"]["comment"], 'It does <not> compile; ask "me"!')
        self.assertEqual(self.grades()["Ada"]["points"], "10.50000")
        self.assertEqual([each["message"] for each in browser.logs("browser")], [], "the console is silent")
        self.end()
        self.write("class.toml", RUBRIC.replace("points = 6", "points = 4"))
        subprocess.run(self.command(), cwd=self.folder, check=True, capture_output=True)
        self.assertEqual(self.grades()["Ada"]["points"], "10.00000", "a check that gives less now has its most")
        self.assertEqual(self.grades()["Bo"]["comment"], 'It does <not> compile; ask "me"!')
        self.assertNotIn("grade.js", self.read("site/index.html"), "the page of the folder needs no server")
        self.write("class.toml", RUBRIC)
        self.serve()
        again = self.open()
        self.assertEqual(again.run("return document.querySelector(arguments[0]).value", POINTS % (ada, "report")), "4.5")
        self.assertEqual(again.run(f"return document.querySelector('#{bo} .commentField').value"), 'It does <not> compile; ask "me"!')

    def test_two_browsers_at_once_lose_nothing(self):
        first, second = self.open(), self.open()
        ada, cy = self.card(first, "Ada"), self.card(second, CY)
        self.assertEqual(first.run("return document.querySelectorAll('.card b').length"), 0)
        for points in ("1", "2", "3"):
            self.type(first, POINTS % (ada, "report"), points)
            self.type(second, POINTS % (cy, "report"), points)
        self.type(second, f"#{ada} .commentField", "from the second")
        self.type(first, POINTS % (ada, "a nice extra"), "1.5")
        kept = json.loads(self.read("site/marks.json"))
        self.assertEqual({name: (each["comment"], each["points"], each["folder"]) for name, each in kept.items()},
                         {"Ada": ("from the second", {"a nice extra": 1.5, "report": 3}, "Ada"), CY: ("", {"report": 3}, CY)})
        self.assertEqual(self.grades()[CY]["points"], "7.00000")
        first.open(self.address)
        first.wait("return document.querySelectorAll('.commentField').length === 3")
        self.assertEqual(first.run(f"return document.querySelector('#{ada} .commentField').value"), "from the second")

    def test_points_are_numbers_in_every_language_and_nothing_else(self):
        browser = self.open()
        ada = self.card(browser, "Ada")
        field, kept = POINTS % (ada, "report"), None
        for typed, wanted in (("2,5", 2.5), (" 3 ", 3), (".5", .5), ("6", 6), ("0", 0), ("4.", 4), ("1,25", 1.25)):
            self.assertEqual(self.type(browser, field, typed), "saved", typed)
            kept = json.loads(self.read("site/marks.json"))["Ada"]["points"]["report"]
            self.assertEqual(kept, wanted, typed)
            self.assertEqual(browser.run("return document.querySelector(arguments[0]).getAttribute('aria-invalid')", field), "false", typed)
        for typed in ("1e", "1e1", "2,5,1", "1.000,5", "6,01", "9", "-1", "x", "2 5", "NaN", "Infinity", "0x2", "+", ","):
            self.assertIn("not saved", self.type(browser, field, typed), typed)
            self.assertEqual(json.loads(self.read("site/marks.json"))["Ada"]["points"]["report"], kept, typed)
            self.assertEqual(browser.run("return document.querySelector(arguments[0]).getAttribute('aria-invalid')", field), "true", typed)
            self.assertEqual(browser.run("return document.querySelector(arguments[0]).value", field), typed, "it stays to be corrected")
        self.assertEqual(self.type(browser, field, ""), "saved")
        self.assertNotIn("report", json.loads(self.read("site/marks.json")).get("Ada", {}).get("points", {}))
        for points in (-1, 6.01, 1e9):
            body = json.dumps({"entry": 0, "check": "report", "points": points}).encode()
            self.assertEqual(self.ask("POST", f"/{self.token}/marks", body, Content_Type="application/json")[0], 400, points)

    def test_what_nobody_has_marked_is_counted_and_keys_lead_to_it(self):
        browser = self.open()
        names = browser.run("return [...document.querySelectorAll('.card')].map((each) => each.dataset.name)")
        self.assertIn("0 of 3 submissions are marked", browser.run("return document.querySelector('.unmarked').textContent"))
        self.assertEqual(self.grades()["Ada"]["not marked"], "1")
        self.assertEqual(self.grades()["Ada"]["points report"], "", "not 0")
        focused = "const card = document.activeElement.closest('.card'); return card && card.dataset.name"
        for key, name in (("j", names[0]), ("j", names[1]), ("k", names[0]), ("j", names[1]), ("j", names[2]), ("j", names[2])):
            browser.press(key)
            self.assertEqual(browser.run(focused), name, key)
        self.type(browser, POINTS % (self.card(browser, names[1]), "report"), "3")
        self.assertIn("1 of 3 submissions are marked", browser.run("return document.querySelector('.unmarked').textContent"))
        browser.run("document.querySelector('.card').focus()")
        browser.run("document.activeElement.blur()")
        browser.press("n")
        self.assertEqual(browser.run(focused), names[0])
        self.assertEqual(browser.run("return document.activeElement.tagName"), "INPUT", "its first field")
        self.assertEqual(self.grades()[names[1]]["not marked"], "0")

    def test_what_one_comment_says_can_be_added_to_another(self):
        browser = self.open()
        ada, bo = self.card(browser, "Ada"), self.card(browser, "Bo")
        self.type(browser, f"#{ada} .commentField", "No lighting.")
        browser.run("document.querySelector(arguments[0]).focus()", f"#{bo} .commentField")
        options = "return [...document.querySelectorAll(arguments[0])].map((each) => each.value)"
        self.assertEqual(browser.run(options, f"#{bo} .bank option"), ["", "No lighting."])
        self.type(browser, f"#{bo} .commentField", "Good dots.")
        browser.run("document.querySelector('.saved').textContent = ''")
        browser.run("""const bank = document.querySelector(arguments[0]); bank.focus(); bank.value = 'No lighting.';
            bank.dispatchEvent(new Event('change'));""", f"#{bo} .bank")
        browser.wait("return /saved/.test(document.querySelector('.saved').textContent)")
        self.assertEqual(json.loads(self.read("site/marks.json"))["Bo"]["comment"], "Good dots.\nNo lighting.")
        self.assertEqual(browser.run(options, f"#{bo} .bank option"), [""], "what it says already is left out")

    def test_one_judgement_serves_all_with_the_same_pictures_and_is_undone(self):
        browser = self.open()
        browser.wait("return document.body.dataset.ready === 'true'")
        ada, bo, cy = self.card(browser, "Ada"), self.card(browser, "Bo"), self.card(browser, CY)
        alike = "return [...document.querySelectorAll('.alike')].map((each) => [each.closest('.card').dataset.name, each.firstChild.textContent])"
        self.assertEqual(dict(browser.run(alike)), {"Ada": f"The same pictures: {CY}. ", CY: "The same pictures: Ada. "},
                         "which, and nothing for one that has no picture")
        self.assertIn("0 of 3 marked", browser.run("return document.querySelector('.progress').textContent"))
        self.type(browser, POINTS % (cy, "report"), "1")
        self.type(browser, POINTS % (ada, "report"), "4.5")
        self.type(browser, f"#{ada} .commentField", "No lighting.")
        before = json.loads(self.read("site/marks.json"))
        browser.click(f"#{ada} .alike button")
        browser.wait("return /^saved for/.test(document.querySelector('.saved').textContent)")
        self.assertEqual(browser.run("return document.querySelector('.saved').textContent"), f"saved for {CY}")
        kept = json.loads(self.read("site/marks.json"))
        self.assertEqual((kept[CY]["points"], kept[CY]["comment"]), ({"report": 4.5}, "No lighting."))
        self.assertEqual(kept["Ada"], before["Ada"])
        self.assertEqual(self.grades()[CY]["points"], "8.50000")
        self.assertEqual(browser.run("return document.querySelector(arguments[0]).value", POINTS % (cy, "report")), "4.5")
        self.assertEqual(browser.run(f"return document.querySelector('#{cy} .commentField').value"), "No lighting.")
        self.assertIn("2 of 3 marked", browser.run("return document.querySelector('.progress').textContent"))
        browser.click(".undo")
        browser.wait("return /^undone/.test(document.querySelector('.saved').textContent)")
        self.assertEqual(browser.run("return document.querySelector('.saved').textContent"), f"undone for {CY}")
        self.assertEqual(json.loads(self.read("site/marks.json")), before)
        self.assertEqual(browser.run("return document.querySelector(arguments[0]).value", POINTS % (cy, "report")), "1")
        self.assertEqual(browser.run(f"return document.querySelector('#{cy} .commentField').value"), "")
        # One step after another, by the key, down to what was there before.
        for _ in range(3):
            browser.run("document.querySelector('.saved').textContent = ''; document.activeElement.blur()")
            browser.press("u")
            browser.wait("return /^undone/.test(document.querySelector('.saved').textContent)")
        self.assertEqual(json.loads(self.read("site/marks.json")), {})
        self.assertTrue(browser.run("return document.querySelector('.undo').hidden"))
        self.assertEqual(self.grades()["Ada"]["not marked"], "1")
        own, json_type = f"/{self.token}/", {"Content_Type": "application/json"}
        self.assertEqual(self.ask("POST", own + "undo", b"{}", **json_type)[0], 400)
        shown = browser.run("return [...document.querySelectorAll('.card')].map((each) => [each.dataset.name, Number(each.id.slice(1)) - 1])")
        nobody = json.dumps({"entry": dict(shown)["Bo"], "alike": True}).encode()
        self.assertEqual(self.ask("POST", own + "marks", nobody, **json_type)[0], 400)
        self.assertEqual([each["message"] for each in browser.logs("browser") if "400" not in each["message"]], [])
        self.assertNotEqual(bo, ada)

    def test_kept_comments_are_added_by_click_and_key_and_outlive_the_server(self):
        browser = self.open()
        browser.wait("return document.body.dataset.ready === 'true'")
        ada, bo = self.card(browser, "Ada"), self.card(browser, "Bo")
        saved = "return /saved/.test(document.querySelector('.saved').textContent)"

        def press(selector):
            browser.run("document.querySelector('.saved').textContent = ''")
            browser.click(selector)
            browser.wait(saved)
        for text in ("No lighting.", 'Say <why> "here".'):
            self.type(browser, f"#{ada} .commentField", text)
            press(f"#{ada} .kept .keep")
        self.assertEqual(json.loads(self.read("site/comments.json")), ["No lighting.", 'Say <why> "here".'])
        browser.run("document.querySelector(arguments[0]).focus()", f"#{bo} .commentField")
        texts = "return [...document.querySelectorAll('.kept .add')].map((each) => each.textContent)"
        self.assertEqual(browser.run(texts), ["No lighting.", 'Say <why> "here".'])
        press(f"#{bo} .kept li:nth-child(2) .add")
        browser.run("document.querySelector('.saved').textContent = ''; document.querySelector(arguments[0]).focus()", f"#{bo} .commentField")
        browser.run("""document.activeElement.dispatchEvent(new KeyboardEvent('keydown', {code: 'Digit1', key: '1', altKey: true, bubbles: true}));""")
        browser.wait(saved)
        self.assertEqual(json.loads(self.read("site/marks.json"))["Bo"]["comment"], 'Say <why> "here".\nNo lighting.')
        self.end()
        self.serve()
        again = self.open()
        again.wait("return document.body.dataset.ready === 'true'")
        again.run("document.querySelector(arguments[0]).focus()", f"#{ada} .commentField")
        self.assertEqual(again.run(texts), ["No lighting.", 'Say <why> "here".'])
        again.run("document.querySelector('.saved').textContent = ''")
        again.click(".kept li:nth-child(1) button:last-child")
        again.wait(saved)
        self.assertEqual(json.loads(self.read("site/comments.json")), ['Say <why> "here".'])
        own, json_type = f"/{self.token}/", {"Content_Type": "application/json"}
        for wrong in (b"[]", b"{", b"{}", b'{"add": 3}', b'{"add": ""}', b'{"add": "' + b"x" * 10_001 + b'"}'):
            self.assertEqual(self.ask("POST", own + "comments", wrong, **json_type)[0], 400, wrong[:20])
        self.assertEqual([each["message"] for each in again.logs("browser")], [], "the console is silent")

    def test_points_stay_in_their_card_in_every_window(self):
        browser = self.open()
        for width in (320, 500, 760, 1024, 1400, 1920):
            browser.command("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=False)
            wide = browser.run("""return [...document.querySelectorAll('table.marks')].filter((each) =>
                each.getBoundingClientRect().right > each.closest('.card').getBoundingClientRect().right + 1).length""")
            self.assertEqual(wide, 0, width)
        browser.command("Emulation.clearDeviceMetricsOverride")

    def test_a_file_that_cannot_be_written_is_said_and_nothing_counts(self):
        browser = self.open()
        ada = self.card(browser, "Ada")
        os.mkdir(os.path.join(self.folder, "site", "marks.json"))
        self.assertIn("not saved", self.type(browser, POINTS % (ada, "report"), "4"))
        self.assertEqual(self.grades()["Ada"]["points"], "4.00000")
        os.rmdir(os.path.join(self.folder, "site", "marks.json"))
        self.assertEqual(self.type(browser, POINTS % (ada, "report"), "5"), "saved")
        self.assertEqual(self.grades()["Ada"]["points"], "9.00000")

    def test_another_site_in_the_same_browser_changes_and_reads_nothing(self):
        browser = self.open()
        browser.open("data:text/html,<h1>evil</h1>")
        mark = '{"entry": 0, "check": "report", "points": 1}'
        said = browser.run("""const [address, mark] = arguments;
            const tries = [
                () => fetch(address + 'marks', {method: 'POST', body: mark, headers: {'Content-Type': 'application/json'}}),
                () => fetch(address + 'marks', {method: 'POST', body: mark, mode: 'no-cors', headers: {'Content-Type': 'text/plain'}}),
                () => fetch(address),
                () => fetch(address + 'grades.csv', {mode: 'no-cors'}),
            ];
            return Promise.all(tries.map((each) => each().then((reply) => reply.type + reply.status, () => 'refused')));""",
                           self.address, mark)
        self.assertEqual(said[0], "refused")
        self.assertEqual(said[2], "refused")
        # A form that the page sends by itself, and a frame.
        browser.run("""const form = document.createElement('form');
            Object.assign(form, {method: 'POST', action: arguments[0] + 'marks', enctype: 'text/plain'});
            const field = document.createElement('input');
            Object.assign(field, {name: '{"entry": 0, "check": "report", "points": 1, "x": "', value: '"}'});
            form.append(field); document.body.append(form); form.submit();""", self.address)
        browser.wait("return !location.href.startsWith('data:')")
        self.assertIn("another site sent this request", browser.run("return document.body.innerText"))
        browser.open("data:text/html,<iframe src='%s'></iframe>" % self.address)
        browser.wait("return document.readyState === 'complete'")
        self.assertFalse(os.path.exists(os.path.join(self.folder, "site", "marks.json")))

    def ask(self, method, path, body=None, **headers):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=20)
        connection.putrequest(method, path, skip_host="Host" in headers)
        for name, value in headers.items():
            connection.putheader(name.replace("_", "-"), value)
        if body is not None:
            connection.putheader("Content-Length", str(len(body)))
        with contextlib.suppress(BrokenPipeError, ConnectionResetError):  # it does not wait for what is too long
            connection.endheaders(body)
        reply = connection.getresponse()
        text = reply.read().decode(errors="replace")
        connection.close()
        return reply.status, text

    def test_requests_without_token_of_other_hosts_and_paths_outside_are_refused(self):
        own, mark = f"/{self.token}/", b'{"entry": 0, "check": "report", "points": 1}'
        json_type = {"Content_Type": "application/json"}
        self.assertEqual(self.ask("GET", own)[0], 200)
        for path in ("/", "/marks", "//", "/" + "0" * 32 + "/", "/" + self.token[:-1] + "/", "/" + self.token, "/" + self.token.upper() + "x/"):
            self.assertGreaterEqual(self.ask("GET", path)[0], 400, path)
            self.assertGreaterEqual(self.ask("POST", path, mark, **json_type)[0], 400, path)
        for host in ("evil.example", "localhost:%d" % self.port, "127.0.0.1", "127.0.0.1:1", "[::1]:%d" % self.port, ""):
            self.assertEqual(self.ask("GET", own, Host=host)[0], 403, host)
            self.assertEqual(self.ask("POST", own + "marks", mark, Host=host, **json_type)[0], 403, host)
        for origin in ("http://evil.example", "null", "http://127.0.0.1:1", "https://127.0.0.1:%d" % self.port):
            self.assertEqual(self.ask("POST", own + "marks", mark, Origin=origin, **json_type)[0], 403, origin)
        for kind in ("application/x-www-form-urlencoded", "text/plain", "multipart/form-data; boundary=x"):
            self.assertEqual(self.ask("POST", own + "marks", mark, Content_Type=kind)[0], 415, kind)
        self.assertEqual(self.ask("POST", own + "marks", mark, Sec_Fetch_Site="cross-site", **json_type)[0], 403)
        for path in ("marks.json", "index.html", "../class.toml", "..%2fclass.toml", "%2e%2e/class.toml", "pictures/", "pictures/../marks.json",
                     "pictures/..%2f..%2fclass.toml", "pictures/0001-1.png/../../marks.json", "//etc/passwd", "pictures/0009-1.png", "\\..\\class.toml"):
            status, text = self.ask("GET", own + path)
            self.assertGreaterEqual(status, 400, path)
            self.assertNotIn("by-hand", text)
        self.assertEqual(self.ask("GET", own + "pictures/0001-1.png")[0], 200)
        # A picture that became a link leads nowhere.
        if "WINEPREFIX" not in os.environ:  # Wine follows it, and no program for Windows sees that
            picture = os.path.join(self.folder, "site", "pictures", "0001-1.png")
            os.remove(picture)
            os.symlink("/etc/hostname", picture)
            self.assertEqual(self.ask("GET", own + "pictures/0001-1.png")[0], 404)
        for method in ("PUT", "DELETE", "OPTIONS", "TRACE", "PATCH"):
            self.assertGreaterEqual(self.ask(method, own + "marks", mark, **json_type)[0], 400, method)
        for wrong in (b"[]", b"{", b'{"entry": "0", "comment": ""}', b'{"entry": 1e99, "comment": ""}', b'{"entry": 0, "comment": 3}',
                      b'{"entry": 0, "check": "report", "points": 1e999}', b'{"entry": 0, "comment": "' + b"x" * 10_001 + b'"}', b"\xff\xfe"):
            self.assertEqual(self.ask("POST", own + "marks", wrong, **json_type)[0], 400, wrong[:40])
        self.assertEqual(self.ask("POST", own + "marks", b"x" * (64 << 20), **json_type)[0], 413)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "site", "marks.json")))
        self.assertEqual(self.ask("POST", own + "marks", mark, **json_type)[0], 200)


def pictures(folder):
    """Screenshots of the served page with something typed, light and dark."""
    os.makedirs(folder, exist_ok=True)
    test = Served("test_two_browsers_at_once_lose_nothing")
    test.setUp()
    browser = test.open()
    ada = test.card(browser, "Ada")
    test.type(browser, POINTS % (ada, "report"), "4.5")
    test.type(browser, f"#{ada} .commentField", "A good report, but without pictures.")
    for scheme in ("light", "dark"):
        browser.command("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        browser.screenshot(os.path.join(folder, f"served-{scheme}.png"))
    test.tearDown()


if __name__ == "__main__":
    if not shutil.which("chromedriver") or not shutil.which("chromium"):
        print("skipped: chromium and chromedriver are needed")
        sys.exit(77)
    PROGRAM = class_test.PROGRAM = os.path.abspath(sys.argv[1])
    if len(sys.argv) > 3 and sys.argv[2] == "--pictures":
        pictures(sys.argv[3])
    else:
        unittest.main(argv=sys.argv[:1] + sys.argv[2:], verbosity=2)
