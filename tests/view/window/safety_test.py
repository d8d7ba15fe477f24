"""Tests of what must not be lost: the window while a shader does not end, text after the window was killed, tabs."""

import os
import shutil
import signal
import sys
import time
import unittest

from scenes_test import SHADER, ScenesTest

# Compilers remove a loop that never ends, so these end after years. Mesa 22 ends them after 65,535 rounds,
# which must take longer than the 2 s that the window waits, on a fast machine too: hence the many sines.
ENDLESS = """#version 330
uniform float uBlue; out vec4 c;
void main() {
    float sum = uBlue;
    while (sum < 1e9)
        for (int i = 0; i < 1000; ++i) sum += abs(sin(sin(sin(sin(sum + gl_FragCoord.x))))) * 1e-6;
    c = vec4(sum);
}
"""
LONG = (" for (int i = 0; i < 99999; ++i) for (int j = 0; j < 99999; ++j) "
        "c.g += sin(sin(sin(sin(sin(sin(sin(sin(c.g + float(i * j)))))))));")
REMOVED = """#version 330
uniform float uBlue; out vec4 c;
void main() {
    float sum = 0.;
    for (int i = 0; i < 10; ) sum += 1.;
    c = vec4(sum * uBlue);
}
"""


class Safety(ScenesTest):
    def open_with_state(self, scene, *arguments):
        """A window whose settings and unsaved texts are in a folder of the test."""
        folder = self.files / "settings"
        folder.mkdir(exist_ok=True)
        return self.open(scene, *arguments, settings=folder, variables={"XDG_STATE_HOME": str(self.files / "kept")})

    @staticmethod
    def kill(window):
        """Ends the window itself, which `glibra view` may have started as another process."""
        os.kill(int(window.xdotool("getwindowpid", window.id)), signal.SIGKILL)
        window.process.wait()

    def test_an_endless_shader_leaves_the_window_the_text_and_the_last_picture(self):
        window = self.open(self.files / "one.glib", "--size", "520x560")
        self.edit(window, 4)
        before = window.pixels()
        window.click("source/live", 0.1)
        self.edit(window, 4)
        begun = time.monotonic()
        window.type(LONG)
        # While it is drawn elsewhere, the window goes on.
        state = window.wait(lambda s: s["source"]["compiled"] == 1)
        kept = list((window.folder / "state/glibra/unsaved").iterdir())
        self.assertEqual(len(kept), 1)
        self.assertIn("99999", kept[0].read_text())
        frames = window.state()["framesPresented"]
        window.key("End")
        window.wait(lambda s: s["framesPresented"] > frames)
        state = window.wait(lambda s: any(m["id"] == "view-E05" for m in s["messages"]))
        self.assertLess(time.monotonic() - begun, 20)
        message = next(m for m in state["messages"] if m["id"] == "view-E05")
        self.assertTrue(message["file"].endswith("one.frag"))
        self.assertEqual(message["line"], 4)
        window.move(20, 20)
        seen = len(before[2]) // 2  # the list of messages covers what is below
        self.assertEqual(window.pixels()[2][:seen], before[2][:seen], "the last good picture stays")
        # The next edit draws again.
        window.click("source/revert")
        window.wait(lambda s: not s["messages"])
        window.settle()
        self.assertEqual(window.pixels()[2], before[2])

    def test_a_scene_that_does_not_end_can_be_opened_and_edited(self):
        (self.files / "one.frag").write_text(ENDLESS)
        begun = time.monotonic()
        window = self.open(self.files / "one.glib", "--size", "520x560")
        self.edit(window, 7)
        self.assertLess(time.monotonic() - begun, 15)
        window.wait(lambda s: any(m["id"] == "view-E05" and m["line"] == 5 for m in s["messages"]))
        (self.files / "one.frag").write_text(REMOVED)
        window.wait(lambda s: [(m["id"], m["line"]) for m in s["messages"]] == [("view-W02", 5)])
        (self.files / "one.frag").write_text(SHADER)
        window.wait(lambda s: not s["messages"])
        window.move(20, 20)
        self.assertShows(window, self.files / "one.glib")

    def test_a_slow_loop_is_drawn_with_the_same_bytes(self):
        (self.files / "one.frag").write_text(SHADER.replace(
            "c = vec4(1.", "float x = 0.; while (x < 3.) x += gl_FragCoord.x / 300. + .1; c = vec4(x / 4."))
        window = self.open(self.files / "one.glib", "--size", "520x560")
        window.wait(lambda s: s["framesDrawn"] > 0)
        self.assertShows(window, self.files / "one.glib")
        window.drag_widget("uniform/Plain/uBlue", 0.25, 0.8)
        window.wait_knob("uBlue", lambda v: 0.7 < v[0])
        window.move(20, 20)
        window.settle()
        self.assertShows(window, self.files / "one.glib", *self.set_of(window))

    def test_a_click_while_another_process_draws_picks_when_it_is_done(self):
        (self.files / "one.frag").write_text(SHADER.replace(
            "c = vec4(1.", "float x = 0.; while (x < 900.) x += abs(sin(gl_FragCoord.x + x)) + 1.; c = vec4(x / 1e3"))
        window = self.open(self.files / "one.glib", "--size", "520x560")
        window.wait(lambda s: s["framesDrawn"] > 0)
        window.settle()
        left, top, width, height = window.state()["picture"]
        window.move(left + width * .5, top + height * .5)
        for _ in range(3):
            self.assertNotIn("picked", window.state())
            window.key("a")  # axes: the picture is drawn anew, and the click comes meanwhile
            window.press()
            window.release()
            window.wait(lambda s: "picked" in s)
            window.key("Escape")
            window.wait(lambda s: "picked" not in s)
            window.settle()

    def test_text_comes_back_after_the_window_was_killed(self):
        window = self.open_with_state(self.files / "one.glib", "--size", "520x560")
        self.edit(window, 4)
        window.type(" // mine")
        window.wait(lambda s: s["source"]["changed"])
        time.sleep(1)
        self.kill(window)
        self.assertEqual((self.files / "one.frag").read_text(), SHADER)
        window = self.open_with_state(self.files / "one.glib", "--size", "520x560")
        window.wait(lambda s: "source/restore" in s["widgets"])
        window.settle()
        window.click("source/restore")
        window.wait(lambda s: s["source"]["changed"] and "source/restore" not in s["widgets"])
        window.key("ctrl+s")
        window.wait(lambda s: not s["source"]["changed"])
        self.assertEqual((self.files / "one.frag").read_text(), SHADER.replace("uBlue, 1.);", "uBlue, 1.); // mine"))
        self.assertFalse(list((self.files / "kept/glibra/unsaved").iterdir()))

    def test_a_second_window_leaves_the_text_of_the_first_alone(self):
        first = self.open_with_state(self.files / "one.glib", "--size", "520x560")
        self.edit(first, 4)
        first.type(" // mine")
        first.wait(lambda s: s["source"]["changed"])
        unsaved = self.files / "kept/glibra/unsaved"
        first.wait(lambda s: unsaved.is_dir() and any("mine" in each.read_text() for each in unsaved.iterdir()))
        second = self.open_with_state(self.files / "one.glib", "--size", "520x560")
        state = second.wait(lambda s: "another window has text of one.frag" in s["notice"])
        self.assertNotIn("source/restore", state["widgets"])
        second.xdotool("key", "ctrl+q")
        second.process.wait()
        # A copy that somebody removes is written again, though nobody touches the window.
        for each in unsaved.iterdir():
            each.unlink()
        first.wait(lambda s: any("mine" in each.read_text() for each in unsaved.iterdir()))
        self.kill(first)
        third = self.open_with_state(self.files / "one.glib", "--size", "520x560")
        third.wait(lambda s: "source/restore" in s["widgets"])

    def test_values_come_back_however_the_window_ends(self):
        value = None
        for ending in (None, "quit", signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
            window = self.open_with_state(self.files / "one.glib", "--size", "520x560")
            if value is not None:
                self.assertEqual(window.wait_knob("uBlue", lambda v: v != [.25])["knobs"][0]["current"], value)
                self.assertIn("values of the last time", window.state()["notice"])
            if ending is None:
                window.drag_widget("uniform/Plain/uBlue", .25, .8)
                window.wait_knob("uBlue", lambda v: v[0] > .7)
            else:
                before = window.knob("uBlue")
                window.drag_widget("uniform/Plain/uBlue", before[0], before[0] - .1)
                window.wait_knob("uBlue", lambda v: v[0] < before[0] - .05)
            value = window.settle()["knobs"][0]["current"]
            self.assertNotEqual(value, [.25])
            if ending == signal.SIGKILL:
                time.sleep(1)
                self.kill(window)
            elif ending in (None, "quit"):
                window.xdotool("key", "ctrl+q")
                self.assertEqual(window.process.wait(), 0)
            else:
                os.kill(int(window.xdotool("getwindowpid", window.id)), ending)
                self.assertNotEqual(window.process.wait(), 0)
        window = self.open_with_state(self.files / "one.glib", "--size", "520x560")
        window.wait_knob("uBlue", lambda v: v == value)
        window.key("ctrl+r")
        window.wait_knob("uBlue", lambda v: v == [.25])
        window.xdotool("key", "ctrl+q")
        window.process.wait()
        window = self.open_with_state(self.files / "one.glib", "--size", "520x560")
        self.assertEqual(window.settle()["knobs"][0]["current"], [.25])

    def test_text_that_is_not_saved_stays_when_the_system_ends_the_window(self):
        window = self.open_with_state(self.files / "one.glib", "--size", "520x560")
        self.edit(window, 4)
        window.type(" // mine")
        window.wait(lambda s: s["source"]["changed"])
        time.sleep(1)
        os.kill(int(window.xdotool("getwindowpid", window.id)), signal.SIGTERM)
        window.process.wait()
        window = self.open_with_state(self.files / "one.glib", "--size", "520x560")
        window.wait(lambda s: "source/restore" in s["widgets"])

    def test_tabs_of_the_last_window_stay_when_a_scene_is_opened_by_name(self):
        window = self.open_with_state(self.files / "one.glib", "--size", "520x560")
        window.xdotool("key", "ctrl+q")
        window.process.wait()
        window = self.open_with_state(self.files / "two.glib", "--size", "520x560")
        self.assertEqual(len(window.settle()["tabs"]), 1)
        window.xdotool("key", "ctrl+q")
        window.process.wait()
        window = self.open_with_state(None, "--size", "520x560")
        window.wait(lambda s: [t["label"] for t in s["tabs"]] == ["two", "one"] and s["shownTab"] == 0)

    def test_a_scene_whose_folder_is_replaced_is_read_again_and_again(self):
        folder = self.files / "hot"
        shutil.copytree(self.files, folder, ignore=shutil.ignore_patterns("hot"))
        window = self.open(folder / "one.glib", "--size", "520x560")
        for number, blue in enumerate((.1, .5, .9)):
            moved = self.files / f"hot{number}"
            folder.rename(moved)
            shutil.copytree(moved, folder)
            time.sleep(.5)
            loads = window.settle()["reloads"]
            (folder / "one.frag").write_text(SHADER.replace("uBlue, 1.", f"{blue} + uBlue, 1."))
            window.wait(lambda s: s["reloads"] > loads)
            window.move(20, 20)
            self.assertShows(window, folder / "one.glib")

    def test_an_include_that_is_made_later_is_noticed(self):
        (self.files / "one.frag").write_text(SHADER.replace("uniform", '#include "parts/later.glsl"\nuniform', 1))
        window = self.open(self.files / "one.glib", "--size", "520x560")
        window.wait(lambda s: any(m["severity"] == "error" for m in s["messages"]))
        (self.files / "parts").mkdir()
        (self.files / "parts/later.glsl").write_text('#include "inner.glsl"\n')
        window.wait(lambda s: any("inner.glsl" in m["text"] for m in s["messages"]))
        (self.files / "parts/inner.glsl").write_text("// nothing\n")
        window.wait(lambda s: not s["messages"])

    def test_a_slow_scene_that_moves_does_not_take_the_window(self):
        (self.files / "moving.frag").write_text("""#version 330
uniform float uR; out vec4 c;
void main() {
    float sum = uR + Timer;
    for (int i = 0; i < 500; ++i) sum += sin(sin(sum + gl_FragCoord.x)) * 1e-3;
    c = vec4(sum);
}
""")
        window = self.open(self.files / "moving.glib", "--size", "640x640")
        # At first each frame is one of the picture; later there are many while the other process draws one.
        window.wait(lambda s: s["framesPresented"] > 2 * s["framesDrawn"] + 10)
        begun = time.monotonic()
        window.key("l")
        window.wait(lambda s: s["labels"])
        self.assertLess(time.monotonic() - begun, 10)
        # After an edit the other process draws from the first frame on; once it is fast, this one does.
        before = window.state()
        shader = self.files / "moving.frag"
        shader.write_text(shader.read_text().replace("1e-3", "2e-3"))
        after = window.wait(lambda s: s["reloads"] > before["reloads"] and s["framesPresented"] > before["framesPresented"] + 40)
        self.assertLess(after["framesDrawn"] - before["framesDrawn"], 20)
        shader.write_text(shader.read_text().replace("500", "5"))
        begun = window.wait(lambda s: s["reloads"] > after["reloads"])
        window.wait(lambda s: s["framesDrawn"] > begun["framesDrawn"] + 20)

    def test_a_shader_that_was_removed_can_be_saved_again(self):
        window = self.open(self.files / "one.glib", "--size", "520x560")
        self.edit(window, 4)
        (self.files / "one.frag").unlink()
        window.wait(lambda s: s["banner"] and s["source"]["changed"])
        self.assertTrue(window.settle()["source"]["file"].endswith("one.frag"))
        window.click("source/save")
        window.wait(lambda s: not s["banner"] and not s["source"]["changed"])
        self.assertEqual((self.files / "one.frag").read_text(), SHADER)

    def test_closed_tabs_and_those_of_the_last_run_come_back(self):
        window = self.open_with_state(self.files / "one.glib", str(self.files / "two.glib"),
                                      str(self.files / "old.glib"), "--size", "520x560")
        window.key("ctrl+Next")
        window.wait(lambda s: s["shownTab"] == 1)
        window.settle()
        window.drag_widget("uniform/Plain/uBlue", 0.25, 0.8)
        window.wait_knob("uBlue", lambda v: 0.7 < v[0])
        value = window.settle()["knobs"][0]["current"]  # not one of the steps of the drag
        window.key("ctrl+w")
        window.wait(lambda s: s["question"] and "question/discard" in s["widgets"])
        window.settle()
        window.click("question/discard")
        window.wait(lambda s: len(s["tabs"]) == 2)
        window.key("ctrl+shift+t")
        state = window.wait(lambda s: [t["label"] for t in s["tabs"]] == ["one", "two", "old"] and s["shownTab"] == 1)
        self.assertEqual(state["knobs"][0]["current"], value)
        self.kill(window)  # the tabs are known before the window ends
        window = self.open_with_state(None)
        state = window.wait(lambda s: [t["label"] for t in s["tabs"]] == ["one", "two", "old"] and s["shownTab"] == 1)
        self.assertTrue(state["scene"].endswith("two.glib"))

    def test_a_missing_shader_is_made_and_an_unset_uniform_gets_a_slider_by_clicks(self):
        (self.files / "one.glib").write_text((self.files / "one.glib").read_text().replace("one.frag", "lit.frag").replace(
            " uBlue <0. .25 1.>", ""))
        (self.files / "two.frag").unlink()
        window = self.open(self.files / "one.glib", "--size", "640x560")
        self.edit(window, 2)
        state = window.wait(lambda s: any(k.startswith("source/message/") and "/fix/" in k for k in s["widgets"]))
        fix = next(k for k in state["widgets"] if "/fix/0" in k)
        window.settle()
        window.click(fix)
        window.wait(lambda s: not s["banner"] and s["source"]["file"].endswith("lit.frag"))
        self.assertIn("void main()", (self.files / "lit.frag").read_text())
        (self.files / "lit.frag").write_text(SHADER)
        state = window.wait(lambda s: any(m["id"] == "glib-W37" for m in s["messages"])
                            and any("/fix/" in k for k in s["widgets"]))
        window.settle()
        window.click(next(k for k in state["widgets"] if "/fix/0" in k))
        window.wait(lambda s: [k["tag"] for k in s["knobs"]] == ["uBlue"] and not s["messages"])
        self.assertIn("Program Plain uBlue <0. .5 1.>", (self.files / "one.glib").read_text())

    def test_commands_are_found_by_name_and_f11_fills_the_screen(self):
        window = self.open(self.files / "one.glib", "--size", "520x400")
        window.key("ctrl+shift+p")
        window.wait(lambda s: s["palette"]["open"] and s["takesText"])
        window.type("light theme")
        window.wait(lambda s: s["palette"]["found"] == ["Light or dark theme"])
        window.key("Return")
        window.wait(lambda s: s["lightTheme"] and not s["palette"]["open"])
        window.key("ctrl+shift+p")
        window.wait(lambda s: s["palette"]["open"] and s["takesText"])
        # What stands in the menu File, beside the source, and in the sections.
        every = window.state()["palette"]["found"]
        self.assertFalse([each for each in every if "#" in each or (each.startswith("Window '") and not each.endswith("'"))])
        for words in ("solution", "compare another", "template", "empty scene", "open scene", "save all", "save values",
                      "hardcopy", "verbose", "noise", "examples|example scenes", "quit", "revert", "live", "your own editor",
                      "restart", "smooth", "background", "measure", "reset transform", "copy command", "suite", "labels", "wrap long lines"):
            self.assertTrue(any(all(word in each.lower() for word in choice.split()) for each in every
                                for choice in words.split("|")), words)
        window.key("Escape")
        window.wait(lambda s: not s["palette"]["open"])
        before = window.settle()["window"]
        window.key("F11")
        window.wait(lambda s: s["window"] == [1400, 1100])
        # What an action did is said on the picture where there is no panel.
        window.key("ctrl+b")
        window.settle()
        window.key("ctrl+shift+t")
        window.wait(lambda s: s["noticeOverlay"] and s["notice"])
        window.key("F11")
        window.wait(lambda s: s["window"] == before)

    def test_a_long_tab_bar_stands_still(self):
        scenes = []
        for number in range(12):
            scenes.append(self.files / f"a_scene_with_a_long_name_{number}.glib")
            scenes[-1].write_text((self.files / "one.glib").read_text())
        window = self.open(scenes[0], *map(str, scenes[1:]), "--size", "520x400")
        for _ in range(11):
            window.key("ctrl+Next")
        window.wait(lambda s: s["shownTab"] == 11)
        before = {k: v for k, v in window.settle()["widgets"].items() if k.startswith("tab/")}
        self.assertIn("tab/11", before)
        left, top, width, height = before["tab/11"]
        for x in range(30, 500, 47):
            window.move(x, top + height / 2)
        after = {k: v for k, v in window.settle()["widgets"].items() if k.startswith("tab/")}
        self.assertEqual(after, before)


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
