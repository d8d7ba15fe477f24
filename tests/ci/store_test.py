#!/usr/bin/env python3
"""Goldens whose pictures lie on a web server: runs against a server of this test, good and bad ones.

usage: store_test.py GLIBRA
"""
import hashlib
import http.server
import os
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import unittest

if not shutil.which("curl"):
    print("skipped: curl is missing")
    sys.exit("curl is missing" if os.environ.get("GLIBRA_NO_SKIPS") else 77)

PROGRAM = None


class Server(http.server.ThreadingHTTPServer):
    """Serves the files of a folder, in a way that the test chooses; notes what it was asked for."""
    daemon_threads = True

    def __init__(self, folder):
        self.folder, self.way, self.asked = folder, "good", []
        super().__init__(("127.0.0.1", 0), Answer)
        threading.Thread(target=self.serve_forever, daemon=True).start()

    def handle_error(self, request, client_address):
        pass  # a client that has enough


class Answer(http.server.BaseHTTPRequestHandler):
    def log_message(self, *arguments):
        pass

    def do_GET(self):
        server = self.server
        server.asked.append(self.path)
        way = server.way if not self.path.startswith("/moved") else "good"
        file = os.path.join(server.folder, os.path.basename(self.path))
        body = b""
        if os.path.exists(file):
            with open(file, "rb") as opened:
                body = opened.read()
        if way == "missing" or not body:
            return self.send_error(404)
        if way.startswith("to "):
            self.send_response(302)
            self.send_header("Location", way[3:] or f"/moved{self.path}")
            return self.end_headers()
        self.send_response(200)
        if way in ("good", "cut", "slow"):
            self.send_header("Content-Length", str(len(body)))
        elif way == "wrong":
            body = body[:-1] + bytes([body[-1] ^ 1])
        self.end_headers()
        if way == "cut":
            body = body[:len(body) // 2]
        if way == "endless":
            while True:
                self.wfile.write(bytes(65536))
        if way == "slow":
            for each in body:
                self.wfile.write(bytes([each]))
                time.sleep(1)
        self.wfile.write(body)
        return None


class Store(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = self.temporary.name
        os.makedirs(self.folder + "/tests")
        os.makedirs(self.folder + "/web")
        self.server = Server(self.folder + "/web")
        self.store = f"http://127.0.0.1:{self.server.server_address[1]}/g/{{hash}}.png"
        self.write("tests/s.toml", f'store = "{self.store}"\n[[shot]]\nscript = "*.glib"\n')
        for name in "ab":
            self.scene(name, .5)
        done = self.run_test("--update")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("glibra-results/upload' has 2 pictures for http://127.0.0.1", done.stderr)
        for each in os.listdir(self.folder + "/glibra-results/upload"):
            shutil.copy(f"{self.folder}/glibra-results/upload/{each}", self.folder + "/web")
        self.forget()

    def tearDown(self):
        self.server.shutdown()
        self.server.server_close()
        self.temporary.cleanup()

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    def scene(self, name, grey):
        """Each scene has a picture of its own."""
        self.write(f"tests/{name}.glib", f"WindowSize 64 48\nOrtho -1 1 -1 1\nColor {grey} {grey} {grey}\n"
                   f"{'Sphere .5' if name == 'a' else 'Cube 1 1 1'}\n")

    def forget(self):
        """The machine has no downloads, as a new one."""
        shutil.rmtree(self.folder + "/cache/glibra", ignore_errors=True)

    def downloads(self):
        folder = self.folder + "/cache/glibra/goldens"
        return os.listdir(folder) if os.path.isdir(folder) else []

    def run_test(self, *words):
        return subprocess.run([PROGRAM, "test", "tests/s.toml", *words], cwd=self.folder, check=False, capture_output=True,
                              text=True, env={**os.environ, "XDG_CACHE_HOME": self.folder + "/cache"})

    def test_the_repository_holds_pointers_and_a_run_without_differences_fetches_nothing(self):
        with open(self.folder + "/tests/golden/s/a.png", encoding="ascii") as file:
            pointer = file.read()
        digest = pointer.splitlines()[1].removeprefix("oid sha256:")
        with open(f"{self.folder}/web/{digest}.png", "rb") as file:
            self.assertEqual(hashlib.sha256(file.read()).hexdigest(), digest)
        self.assertEqual(self.run_test().returncode, 0)
        self.assertEqual(self.server.asked, [])

    def test_a_difference_fetches_the_golden_that_it_needs_once(self):
        self.scene("a", .8)
        for _ in range(2):
            done = self.run_test("--summary", "s.md")
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn("1 failed, 1 passed", done.stdout)
            self.assertIn("difference      glibra-results/s/a.difference.png", done.stdout)
            self.assertIn("by more than", done.stdout)
        self.assertEqual(len(self.server.asked), 1, self.server.asked)
        self.assertEqual(len(self.downloads()), 1)

    def test_a_difference_within_the_tolerance_passes_after_a_download(self):
        self.scene("a", .506)
        done = self.run_test()
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual(len(self.server.asked), 1)

    def test_update_compares_with_the_golden_before_it_replaces_it(self):
        self.scene("a", .8)
        done = self.run_test("--update")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("golden replaced: ", done.stdout)
        self.assertEqual(len(self.server.asked), 1)
        self.forget()
        self.assertEqual(self.run_test().returncode, 0)

    def bad(self, way, reason, most_seconds=30):
        self.server.way = way
        self.scene("a", .506)
        start = time.time()
        done = self.run_test("--junit", "j.xml")
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn(f"the picture of its golden cannot be downloaded from '{self.store.split('{')[0]}", done.stdout)
        self.assertRegex(done.stdout, reason)
        self.assertIn("suite-E34", done.stdout)
        self.assertEqual(self.downloads(), [], "nothing of a bad answer stays")
        self.assertLess(time.time() - start, most_seconds)
        with open(self.folder + "/j.xml", encoding="utf-8") as file:
            self.assertIn("cannot be downloaded", file.read())
        # The next run asks again, also with --resume.
        self.server.way = "good"
        self.assertEqual(self.run_test("--resume").returncode, 0)

    def test_what_is_missing(self):
        self.bad("missing", "404")

    def test_what_is_cut(self):
        self.bad("cut", r"curl: \(18\)")

    def test_what_is_another_picture(self):
        self.bad("wrong", "its SHA-256 is another one")

    def test_what_never_ends(self):
        self.bad("endless", "larger than the [0-9]+ bytes of its pointer|exceeded")

    def test_what_is_too_slow(self):
        self.bad("slow", r"curl: \(28\)", 60)

    def test_what_leads_to_a_file(self):
        self.bad("to file:///etc/passwd", r"curl: \(1\)")

    def test_what_leads_to_itself(self):
        self.bad(f"to /g/{os.listdir(self.folder + '/web')[0]}", r"curl: \(47\)")

    def test_what_leads_to_another_place_is_followed(self):
        self.server.way = "to "
        self.scene("a", .506)
        self.assertEqual(self.run_test().returncode, 0)

    def test_a_server_that_does_not_answer(self):
        self.server.shutdown()
        self.server.server_close()
        self.scene("a", .506)
        done = self.run_test()
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, r"curl: \(7\)")
        self.server = Server(self.folder + "/web")

    def test_untrusted_fetches_nothing(self):
        done = self.run_test("--untrusted")
        if done.returncode == 4:
            self.skipTest("no sandbox here")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.scene("a", .506)
        done = self.run_test("--untrusted")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("has to be downloaded from", done.stdout)
        self.assertEqual(self.server.asked, [])

    def test_many_failures_end_early(self):
        for i in range(30):
            self.write(f"tests/m{i}.glib", f"WindowSize 64 48\nOrtho -1 1 -1 1\nSphere {.2 + .02 * i}\n")
        self.assertEqual(self.run_test("--update=missing").returncode, 0)
        self.forget()
        for i in range(30):
            self.write(f"tests/m{i}.glib", f"WindowSize 64 48\nOrtho -1 1 -1 1\nColor .5 .5 .5\nSphere {.2 + .02 * i}\n")
        self.server.way = "missing"
        done = self.run_test()
        self.assertIn("not tried after", done.stdout)
        self.assertLess(len(self.server.asked), 20)


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv[1])
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
