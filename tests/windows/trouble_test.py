#!/usr/bin/env python3
"""glibra.exe under Wine where something goes wrong: workers that crash, Ctrl+C, files that others hold, full disks; and with names
and texts as they are on Windows. What it says is compared with the program for Linux.

usage: trouble_test.py LINUX_PROGRAM TROUBLE_EXE [CLASS[.TEST]...]     (in a mount name space of its own, as tools/test-windows
makes one, with GLIBRA_PROGRAM=tools/windows/glibra-under-wine and what it needs)
"""

import filecmp
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
import urllib.parse
import zipfile

WINDOWS = os.environ["GLIBRA_PROGRAM"]
WINE = os.environ["GLIBRA_WINE"]
EXE = os.environ["GLIBRA_EXE"]
SOURCES = pathlib.Path(__file__).resolve().parents[2]
TEAPOT = SOURCES / "glib/start/teapot.glib"
LINUX = TROUBLE = None  # from the command line
VERTEX = "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n"
# The driver ends its loops after 65,535 rounds, which takes minutes in a large picture.
ENDLESS = """#version 330 compatibility
uniform float Timer;
void main() {
    float x = 0.;
    while (x < 1e9 + Timer) x = fract(x + .3);
    gl_FragColor = vec4(x);
}
"""
PLAIN = "#version 330 compatibility\nvoid main() { gl_FragColor = vec4(.2, .4, .6, 1.); }\n"
SCENE = "WindowSize 64 64\nLookAt 0 0 3  0 0 0  0 1 0\nVertex a.vert\nFragment a.frag\nProgram P\nSphere 1\n"


def dos(path):
    """A path as Windows has it: the root folder is drive Z: of Wine."""
    return "Z:" + str(path).replace("/", "\\")


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.write("a.vert", VERTEX)
        self.write("a.frag", PLAIN)
        self.write("a.glib", SCENE)

    def write(self, name, text):
        file = self.folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(text if isinstance(text, bytes) else text.encode())
        return file

    def run_program(self, program, *words, **more):
        """Into files: what Wine starts beside a program, such as its desktop, may hold pipes for longer."""
        with tempfile.TemporaryFile("w+") as output, tempfile.TemporaryFile("w+") as errors:
            ran = subprocess.run([program, *map(str, words)], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=output, stderr=errors,
                                 timeout=300, **more)
            for each in (output, errors):
                each.seek(0)
            return subprocess.CompletedProcess(ran.args, ran.returncode, output.read(), errors.read())

    def windows(self, *words):
        return self.run_program(WINDOWS, *words)

    def names(self, folder="out"):
        return sorted(each.name for each in (self.folder / folder).iterdir())

    def assertWhole(self, file):
        """A PNG file that ends where such files end."""
        self.assertTrue(file.read_bytes().endswith(b"IEND\xaeB`\x82"), file)


class Workers(Case):
    def trouble(self, action, awaited, *words):
        """The status of the program as Windows has it, and what it printed."""
        ran = self.run_program(WINE, TROUBLE, action, awaited, dos(EXE), *words)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        lines = ran.stdout.splitlines()
        return int(lines[-1], 16), ran.stderr

    def ended(self, action):
        self.write("endless.frag", ENDLESS)
        self.write("endless.glib", SCENE.replace("a.frag", "endless.frag").replace("64 64", "2000 2000"))
        return self.trouble(action, "out/a.png", "render", "endless.glib", "a.glib", "--timeout", 100, "--jobs", 2, "-o", "out")

    def test_a_crash_costs_its_own_scene(self):
        status, errors = self.ended("crash")
        self.assertEqual(status, 3)
        self.assertIn("endless.glib:1:1: error: the process that drew the scene ended with signal 11 [draw-E06]", errors)
        self.assertEqual(self.names(), ["a.png"])
        self.assertWhole(self.folder / "out/a.png")

    def test_an_end_from_outside_costs_its_own_scene(self):
        status, errors = self.ended("kill")
        self.assertEqual(status, 3)
        self.assertIn("endless.glib:1:1: error: the process that drew the scene ended by itself [draw-E06]", errors)
        self.assertEqual(self.names(), ["a.png"])

    def test_control_c_ends_a_batch_at_once_with_whole_files(self):
        begin = time.monotonic()
        status, errors = self.ended("ctrl-c")
        self.assertLess(time.monotonic() - begin, 90, "it did not wait for the shader without an end")
        self.assertEqual(status, 0xC000013A, errors)  # STATUS_CONTROL_C_EXIT
        self.assertEqual(self.names(), ["a.png"])
        self.assertWhole(self.folder / "out/a.png")

    def test_control_c_among_many_pictures_leaves_whole_ones(self):
        scenes = []
        for number in range(60):
            scenes.append(self.write(f"s{number:02}.glib", SCENE.replace("64 64", "1500 1500")).name)
        status, errors = self.trouble("ctrl-c", "out/s00.png", "render", *scenes, "--jobs", 2, "-o", "out")
        self.assertEqual(status, 0xC000013A, errors)
        names = self.names()
        self.assertTrue(0 < len(names) < len(scenes), names)
        for each in names:
            self.assertRegex(each, r"^s\d\d\.png$")
            self.assertWhole(self.folder / "out" / each)


class Files(Case):
    def test_that_others_hold_stay_as_they_are_and_are_named(self):
        file = self.write("a.png", "old")
        holder = subprocess.Popen([WINE, TROUBLE, "hold", dos(file)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.assertEqual(holder.stdout.readline().strip(), "held")
        ran = self.windows("render", "a.glib", "-o", "a.png")
        holder.communicate()
        self.assertEqual(ran.returncode, 3, ran.stderr)
        self.assertIn("cannot write 'a.png'", ran.stderr)
        self.assertIn("file-E10", ran.stderr)
        self.assertEqual(file.read_text(), "old")
        self.assertEqual(self.names("."), ["a.frag", "a.glib", "a.png", "a.vert"])
        self.assertEqual(self.windows("render", "a.glib", "-o", "a.png").returncode, 0)
        self.assertWhole(file)

    def test_that_a_scene_reads_are_not_written_over_by_names_in_another_case(self):
        self.assertEqual(self.windows("render", "a.glib", "-o", "wood.png").returncode, 0)
        self.write("wood.glib", SCENE.replace("Program P", "Texture2D 5 Wood.png\nProgram P"))
        before = (self.folder / "wood.png").read_bytes()
        for name in ("WOOD.png", dos(self.folder / "wood.png").replace("Z:", "z:"), f"../{self.folder.name.upper()}/wood.PNG"):
            ran = self.windows("render", "wood.glib", "--size", "20x20", "-o", name)
            self.assertEqual(ran.returncode, 3, ran.stderr)
            self.assertIn("the scene reads 'Wood.png', so nothing is written over it", ran.stderr)
        self.assertEqual((self.folder / "wood.png").read_bytes(), before)

    def mount(self, *words):
        (self.folder / "there").mkdir()
        subprocess.run(["mount", "-t", "tmpfs", *words, "none", self.folder / "there"], check=True)
        self.addCleanup(subprocess.run, ["umount", self.folder / "there"], check=True)

    def test_on_a_full_disk_are_the_old_ones(self):
        self.mount("-o", "size=16k")
        self.write("there/a.png", "old")
        for name in ("a.png", "new.png"):
            ran = self.windows("render", TEAPOT, "-o", f"there/{name}", "--size", "800x600")  # 40 kB
            self.assertEqual(ran.returncode, 3, ran.stderr)
            self.assertIn(f"cannot write 'there/{name}': no space left on device", ran.stderr.lower())
        self.assertEqual(self.names("there"), ["a.png"])
        self.assertEqual((self.folder / "there/a.png").read_text(), "old")

    def test_in_a_folder_that_cannot_be_written_to_are_an_error(self):
        self.mount("-o", "ro")
        ran = self.windows("render", "a.glib", "-o", "there/a.png")
        self.assertEqual(ran.returncode, 3, ran.stderr)
        self.assertIn("cannot write 'there/a.png'", ran.stderr)
        self.assertEqual(self.names("there"), [])

    def test_may_have_long_paths_with_all_letters(self):
        place = "ein Ördner 🫖 演示/" + "/".join("ä" * 60 for _ in range(5))
        for name in ("a.vert", "a.frag", "a.glib"):
            self.write(f"{place}/{name}", (self.folder / name).read_bytes())
        self.assertGreater(len(place), 300)
        ran = self.windows("render", f"{place}/a.glib", "-o", f"{place}/Bild 🫖.png")
        self.assertEqual((ran.returncode, ran.stderr), (0, ""))
        self.assertEqual(self.windows("render", "a.glib", "-o", "a.png").returncode, 0)
        self.assertTrue(filecmp.cmp(self.folder / "a.png", self.folder / place / "Bild 🫖.png", shallow=False))


class Texts(Case):
    def assertSame(self, *words):
        """Both programs print the same and end alike."""
        ran = [self.run_program(program, *words) for program in (LINUX, WINDOWS)]
        self.assertEqual(*[(each.returncode, each.stdout, each.stderr) for each in ran], words)
        return ran[0]

    def test_with_the_ends_and_marks_of_windows_are_read(self):
        self.write("crlf.glib", SCENE.replace("\n", "\r\n"))
        self.write("bom.glib", b"\xef\xbb\xbf" + SCENE.encode())
        self.write("wide.glib", SCENE.encode("utf-16"))
        self.write("page.glib", ("# Größe\n" + SCENE).encode("cp1252"))
        self.write("word.glib", (SCENE + "Sphäre 1\r\nSphere x\r\n").encode("cp1252"))
        self.write("utf8.glib", SCENE + "Sphäre 1\r\nSphere x\r\n")
        for name in ("crlf", "bom", "wide", "page", "word", "utf8"):
            self.assertSame("check", f"{name}.glib")
        self.assertEqual(self.assertSame("check", "crlf.glib").returncode, 0)
        self.assertEqual(self.assertSame("check", "utf8.glib").returncode, 3)

    def test_of_shaders_have_the_same_messages(self):
        self.write("a.frag", PLAIN.replace("\n", "\r\n").replace("vec4(.2", "vec4(größe, .2"))
        self.assertEqual(self.assertSame("check", "a.glib").returncode, 3)
        self.write("a.frag", b"\xef\xbb\xbf" + PLAIN.replace("\n", "\r\n").encode())
        self.assertSame("check", "a.glib")

    def test_name_files_in_another_case_or_not_at_all(self):
        for name in ("A.FRAG", "Sub/a.frag", "b.frag", "sub\\a.frag", "a.frag ", "con", "a.frag:x", "../a.frag", "a?.frag"):
            self.write("sub/a.frag", PLAIN)
            self.write("case.glib", SCENE.replace("Fragment a.frag", f"Fragment {name}"))
            with self.subTest(name):
                self.assertSame("check", "case.glib")

    def test_name_drives(self):
        there = self.write("elsewhere/a.frag", PLAIN)
        for name in (dos(there), dos(there).replace("\\", "/"), dos(there).replace("Z:", "z:")):
            self.write("drive.glib", SCENE.replace("Fragment a.frag", f"Fragment {name}"))
            ran = self.windows("render", "drive.glib", "-o", "a.png")
            self.assertEqual((ran.returncode, ran.stderr), (0, ""), name)
        self.write("far.glib", SCENE.replace("Fragment a.frag", "Fragment \\\\nowhere.invalid\\share\\a.frag"))
        ran = self.windows("check", "far.glib")
        self.assertEqual(ran.returncode, 0)
        # Of another machine it would ask with the name and the secret of the user.
        self.assertIn("far.glib:4:10: warning: '\\\\nowhere.invalid\\share\\a.frag' found as 'a.frag' beside the scene", ran.stderr)

    def test_name_folders_of_other_machines(self):
        share = pathlib.Path(os.environ["WINEPREFIX"]) / "dosdevices/unc/server"  # what Wine takes for a machine
        share.mkdir(parents=True)
        self.addCleanup(shutil.rmtree, share.parent)
        (share / "share").symlink_to(self.folder)
        for name in ("a.glib", "gone.glib"):
            for scene in (f"\\\\server\\share\\{name}", f"//server/share/{name}", f"\\\\?\\UNC\\server\\share\\{name}"):
                ran = self.windows("render", scene, "-o", "b.png")
                self.assertEqual(ran.returncode, 3, ran.stderr)
                self.assertRegex(ran.stderr, r"^/.*a?.glib:1:1: error: cannot read the scene: its path must begin with a drive, which "
                                 r"'net use S: \\\\server\\share' gives to a folder of another machine \[glib-E14\]\n$")
        self.write("sub/a.vert", VERTEX)
        for name in ("\\\\server\\share\\a.frag", "'//server/share/a.frag'", "\\??\\UNC\\server\\share\\a.frag",
                     "\\\\?\\UNC\\server\\share\\a.frag", "\\\\.\\UNC\\server\\share\\a.frag", "\\server\\share\\a.frag"):
            self.write("sub/far.glib", SCENE.replace("Fragment a.frag", f"Fragment {name}"))
            self.assertIn("cannot find", self.assertSame("check", "sub/far.glib").stderr)

    def test_on_the_command_line_may_have_backslashes(self):
        self.write("sub/a.glib", SCENE)
        self.write("sub/a.vert", VERTEX)
        self.write("sub/a.frag", PLAIN)
        for scene in ("sub\\a.glib", "SUB\\A.GLIB", dos(self.folder / "sub/a.glib"), ".\\sub\\..\\sub\\a.glib"):
            ran = self.windows("render", scene, "-o", "out\\b.png")
            self.assertEqual((ran.returncode, ran.stderr), (0, ""), scene)
            self.assertEqual(self.names(), ["b.png"])

    def test_written_to_standard_output_have_no_other_ends_of_lines(self):
        for words in (("help", "render"), ("info", "--json"), ("completion", "powershell")):
            ran = subprocess.run([WINDOWS, *words], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.assertNotIn(b"\r", ran.stdout, words)
        picture = subprocess.run([WINDOWS, "render", "a.glib", "-o", "-"], cwd=self.folder, stdout=subprocess.PIPE, check=True)
        self.assertEqual(self.windows("render", "a.glib", "-o", "a.png").returncode, 0)
        self.assertEqual(picture.stdout, (self.folder / "a.png").read_bytes())


class Classes(Case):
    """Zip files of students, pictures that are handed out, and goldens in a store."""

    def assertGood(self, ran, status=0):
        self.assertEqual(ran.returncode, status, ran.stdout + ran.stderr)
        self.assertNotIn("\\", ran.stdout + ran.stderr)
        return ran.stdout + ran.stderr

    def pack(self, name, **more):
        with zipfile.ZipFile(self.folder / name, "w") as archive:
            for each in ("a.glib", "a.vert", "a.frag"):
                archive.write(self.folder / each, each)
            for each, text in more.items():
                archive.writestr(each, text)

    def test_are_unpacked_without_leaving_their_folder(self):
        (self.folder / "class").mkdir()
        bad = [dos(self.folder / "out.txt"), dos(self.folder / "out.txt").replace("\\", "/"), "Z:out.txt", "a.frag:out",
               "nul.txt", "sub\\..\\..\\..\\out.txt", "\\\\?\\Z:\\out.txt", "a.vert."]
        self.pack("class/Ada.zip", **{each: "out" for each in bad})
        before = self.names(".")
        out = self.assertGood(self.windows("class", "class", "--reference", "a.glib", "-o", "site"))
        self.assertEqual(self.names("."), sorted([*before, "site"]), out)
        self.assertEqual(self.names("site/unpacked/Ada"), ["a.frag", "a.glib", "a.vert"])
        self.assertEqual((self.folder / "site/unpacked/Ada/a.vert").read_text(), VERTEX)

    def test_are_handed_out_and_checked_by_students(self):
        rubric = self.write("rubric.toml", "[[check]]\npoints = 4\nlike = 0.99\n")
        told = []
        for program, site in ((LINUX, "linux"), (WINDOWS, "windows")):
            out = self.assertGood(self.run_program(program, "class", "--hand-out", site, "--reference", "a.glib", "--rubric", rubric.name,
                                                   "--time", "0", "--time", "0.5"))
            told.append(out.replace(site, "SITE"))
        self.assertEqual(*told)
        self.assertEqual(self.names("linux"), self.names("windows"))
        for each in self.names("linux"):
            self.assertEqual((self.folder / "linux" / each).read_bytes(), (self.folder / "windows" / each).read_bytes(), each)
        self.pack("Ada.zip")
        mine = [self.run_program(program, "class", "Ada.zip", "--mine", "--reference", "windows", "-o", "mine")
                for program in (LINUX, WINDOWS)]
        self.assertEqual(*[(each.returncode, each.stdout, each.stderr) for each in mine])
        self.assertEqual(mine[0].returncode, 0, mine[0].stdout + mine[0].stderr)

    def test_have_goldens_in_a_store(self):
        (self.folder / "store").mkdir()
        self.write("suite.toml", 'store = "store"\n[[shot]]\nscript = "a.glib"\n')
        self.assertGood(self.windows("test", "suite.toml", "--update"))
        self.assertEqual(len(self.names("store")), 1)
        for program in (LINUX, WINDOWS):
            self.assertEqual(self.run_program(program, "test", "suite.toml").returncode, 0)
        self.write("a.frag", PLAIN.replace(".2", ".9"))
        self.assertIn("results/suite/a.got.png", self.assertGood(self.windows("test", "suite.toml", "--results", "results"), 1))
        self.assertGood(self.windows("review", "results", "--accept", "a*"))
        self.assertEqual(len(self.names("store")), 2)
        self.assertEqual(self.run_program(LINUX, "test", "suite.toml").returncode, 0)

    def test_have_goldens_in_a_store_of_a_server(self):
        shutil.copy(TROUBLE, self.folder / "curl.exe")
        variables = dict(os.environ, WINEPATH=dos(self.folder), SERVED=dos(self.folder / "glibra-results/upload"),
                         XDG_CACHE_HOME=str(self.folder / "ein Ördner"))
        self.write("suite.toml", 'store = "http://nowhere.invalid/{hash}.png"\n[[shot]]\nscript = "a.glib"\n')

        def test(*words, status):
            return self.assertGood(self.run_program(WINDOWS, "test", "suite.toml", *words, env=variables), status)

        test("--update", status=0)
        shutil.rmtree(self.folder / "ein Ördner")
        self.write("a.frag", PLAIN.replace(".2", ".9"))
        self.assertIn("by more than", test(status=1))
        self.assertEqual([f"{each}.png" for each in self.names("ein Ördner/glibra/goldens")], self.names("glibra-results/upload"))
        shutil.rmtree(self.folder / "ein Ördner")
        shutil.rmtree(self.folder / "glibra-results/upload")
        self.assertIn("curl ended with status 22", test(status=1))


class Pages(Case):
    def test_are_those_of_linux(self):
        """Films: browsers have no doubles."""
        self.write("a.frag", PLAIN.replace("330", "400").replace("void", "uniform float Timer;\nvoid").replace(
            "{ ", "{ double x = Timer; ").replace(".2", "float(x)"))
        pages = []
        for program in (LINUX, WINDOWS):
            ran = self.run_program(program, "publish", "a.glib", "-o", "a.html", "--frames", "2")
            pages.append((ran.returncode, ran.stdout, ran.stderr, (self.folder / "a.html").read_bytes()))
            (self.folder / "a.html").unlink()
        self.assertEqual(*pages)


class Films(Case):
    def test_are_given_to_ffmpeg(self):
        """Stand-ins for it write their words and the pixels that they are given."""
        shutil.copy(TROUBLE, self.folder / "ffmpeg.exe")
        self.write("ffmpeg", "#!/bin/sh\nfor last; do :; done\n{ printf '%s\\n' \"$@\"; cat; } >\"${last#file:}\"\n").chmod(0o755)
        film = self.folder / "ein Ördner/a.mp4"
        film.parent.mkdir()
        films = []
        for program, variables in ((LINUX, {"PATH": f"{self.folder}:{os.environ['PATH']}"}), (WINDOWS, {"WINEPATH": dos(self.folder)})):
            ran = self.run_program(program, "render", "a.glib", "--frames", "3", "-o", "ein Ördner/a.mp4",
                                   env=dict(os.environ, **variables))
            self.assertEqual(ran.returncode, 0, ran.stderr)
            words, name, pixels = re.split(rb"(\nfile:.*\n)", film.read_bytes(), maxsplit=1)
            self.assertRegex(name.decode(), "\nfile:ein Ördner/[.]glibra-.*[.]mp4\n")
            films.append((ran.stdout, ran.stderr, words, pixels))
            self.assertEqual(self.names("ein Ördner"), ["a.mp4"])
            film.unlink()
        self.assertEqual(*films)
        self.assertEqual(len(films[0][3]), 3 * 64 * 64 * 3)


class LanguageServer(Case):
    def setUp(self):
        super().setUp()
        self.server = subprocess.Popen([WINDOWS, "language-server"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.addCleanup(self.end)

    def end(self):
        self.server.kill()
        self.server.communicate()

    def send(self, method, parameters, number=None):
        message = {"jsonrpc": "2.0", "method": method, "params": parameters}
        if number is not None:
            message["id"] = number
        data = json.dumps(message).encode()
        self.server.stdin.write(b"Content-Length: %d\r\n\r\n" % len(data) + data)
        self.server.stdin.flush()

    def receive(self):
        head = b""
        while not head.endswith(b"\r\n\r\n"):
            byte = self.server.stdout.read(1)
            self.assertTrue(byte, "the server has ended")
            head += byte
        return json.loads(self.server.stdout.read(int(head.split(b":")[1])))

    def uri(self, file):
        return "file:///Z:" + urllib.parse.quote(str(file))

    def test_speaks_of_files_with_drives(self):
        scene = self.write("ein Ördner/ä 🫖.glib", SCENE + "Spere 1\n")
        self.write("ein Ördner/a.frag", PLAIN)
        self.write("ein Ördner/a.vert", VERTEX)
        self.send("initialize", {"capabilities": {}}, 1)
        self.assertIn("capabilities", self.receive()["result"])
        self.send("initialized", {})
        self.send("textDocument/didOpen", {"textDocument": {"uri": self.uri(scene), "languageId": "glib", "version": 1,
                                                            "text": scene.read_text()}})
        told = self.receive()
        self.assertEqual(told["method"], "textDocument/publishDiagnostics")
        self.assertEqual(told["params"]["uri"], self.uri(scene))
        self.assertEqual([each["code"] for each in told["params"]["diagnostics"]], ["glib-E01"])
        self.send("textDocument/definition", {"textDocument": {"uri": self.uri(scene)},
                                              "position": {"line": 3, "character": 11}}, 2)
        answer = self.receive()
        while answer.get("id") != 2:
            answer = self.receive()
        place = answer["result"][0] if isinstance(answer["result"], list) else answer["result"]
        self.assertEqual(urllib.parse.unquote(place["uri"]).lower(), "file:///z:" + str(scene.parent / "a.frag").lower())
        self.send("shutdown", {}, 3)
        self.send("exit", {})
        self.assertEqual(self.server.wait(60), 0)

    def test_ends_with_the_process_of_its_client(self):
        client = subprocess.Popen([WINE, TROUBLE, "number"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.send("initialize", {"processId": int(client.stdout.readline()), "capabilities": {}}, 1)
        self.receive()
        with self.assertRaises(subprocess.TimeoutExpired):
            self.server.wait(4)
        client.communicate()
        self.assertEqual(self.server.wait(60), 1)


if __name__ == "__main__":
    LINUX, TROUBLE = map(os.path.abspath, sys.argv[1:3])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
