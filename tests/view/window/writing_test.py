"""Tests of writing shaders in the window: errors that are said once, completion, comments, the text about a name, the
reference, compiling while typing, and the pixel probe."""

import sys
import time
import unittest

from scenes_test import SHADER, ScenesTest

TYPED = """#version 330
uniform float uBlue; out vec4 c;
void main() {

    c = vec4(1., 0., uBlue, 1.);
}
"""
BROKEN = """#version 330
uniform float uBlue; out vec4 c;
void main() {
    c = vec4(1., 0., uBleu, 1.);
    c.r = uGone;
    c.g = uLost;
}
"""
PASSES_ON = """#version 330
out vec2 vPlace; out float vThree;
void main() { vPlace = aVertex.xy; vThree = 3.; gl_Position = uModelViewProjectionMatrix * aVertex; }
"""
SHOWS_PLACE = """#version 330
uniform float uBlue; in vec2 vPlace; in float vThree; out vec4 c;
void main() { c = vec4(vPlace, uBlue, 1. + vThree); }
"""


class WritingTest(ScenesTest):
    """A window with the source of one.glib."""

    def text_of(self, window):
        window.key("ctrl+s")
        window.wait(lambda s: not s["source"]["changed"])
        return (self.files / "one.frag").read_text()


LONG = "    vec3 first = vec3(.1, .2, .3) + vec3(.4, .5, .6) + vec3(.7, .8, .9) + vec3(uBlue) * 2. + vec3(1., 2., 3.);\n"


class WrappedLines(WritingTest):
    """Lines that are too long continue in further rows."""

    def setUp(self):
        super().setUp()
        self.before = SHADER.replace("void main() {\n", "void main() {\n" + LONG)
        (self.files / "one.frag").write_text(self.before)

    def open_wrapped(self, **options):
        window = self.open(self.files / "one.glib", "--size", "300x560", **options)
        self.edit(window, 4)
        window.key("ctrl+shift+p")
        window.wait(lambda s: s["palette"]["open"] and s["takesText"])
        window.type("wrap long")
        window.wait(lambda s: len(s["palette"]["found"]) == 1)
        window.key("Return")
        window.wait(lambda s: s["source"]["wraps"] and not s["palette"]["open"])
        self.edit(window, 4)
        window.key("Home")
        window.wait(lambda s: (s["source"]["line"], s["source"]["column"]) == (4, 1))
        return window

    def place(self, window):
        """Line and column of the cursor, and its row."""
        state = window.settle()
        _, top, bottom = state["source"]["cursor"]
        return state["source"]["line"], state["source"]["column"], round((top - self.top) / (bottom - top))

    def test_the_cursor_goes_by_rows(self):
        window = self.open_wrapped()
        self.top = window.settle()["source"]["cursor"][1]
        rows = [self.place(window)]
        while True:
            window.key("Down")
            line, column, row = self.place(window)
            if line != 4:
                break
            rows.append((line, column, row))
        self.assertGreater(len(rows), 2, "the line has several rows")
        self.assertEqual([each[2] for each in rows], list(range(len(rows))))
        self.assertEqual((line, column, row), (5, 1, len(rows)))
        second = rows[1][1]
        self.assertEqual(LONG[second - 2], " ", "rows begin after blanks")
        window.key("Up")
        self.assertEqual(self.place(window), rows[-1])
        window.key(*["Up"] * (len(rows) - 1), "End")
        self.assertEqual(self.place(window), (4, second, 0), "the end of the first row")
        window.key("Right")
        self.assertEqual(self.place(window), (4, second + 1, 1))
        window.key("Left")
        self.assertEqual(self.place(window), (4, second, 1))
        window.key("Left")
        self.assertEqual(self.place(window), (4, second - 1, 0))
        # A click beside the third row.
        x, top, bottom = window.settle()["source"]["cursor"]
        left = window.state()["widgets"]["source/text"][0]
        window.move(left + window.state()["widgets"]["source/text"][2] - 30, top + 2.5 * (bottom - top))
        window.press()
        window.release()
        self.assertEqual(self.place(window)[2], 2)
        window.key("Home")
        self.assertEqual(self.place(window), rows[2])

    def test_text_is_written_without_the_breaks(self):
        window = self.open_wrapped()
        window.key("Down")
        second = window.settle()["source"]["column"]
        self.assertGreater(second, 1)
        window.type("1. * ")
        expected = self.before.replace(LONG, LONG[:second - 1] + "1. * " + LONG[second - 1:])
        self.assertEqual(self.text_of(window), expected)
        window.key(*["ctrl+z"] * 5)
        self.assertEqual(self.text_of(window), self.before)
        # Backspace at the beginning of a row, Delete at the end of one.
        window.key("ctrl+Home", "Down", "Down", "Down", "Down", "BackSpace")
        self.assertEqual(self.text_of(window), self.before.replace(LONG, LONG[:second - 2] + LONG[second - 1:]))
        window.key("ctrl+z")
        self.assertEqual(self.text_of(window), self.before)
        window.key("ctrl+Home", "Down", "Down", "Down", "End", "Delete")
        self.assertEqual(self.text_of(window), self.before.replace(LONG, LONG[:second - 1] + LONG[second:]))
        window.key("ctrl+z")
        # What is copied over several rows is the text.
        window.key("ctrl+Home", "Down", "Down", "Down", "shift+Down", "shift+Down", "ctrl+c", "ctrl+End", "ctrl+v")
        copied = self.text_of(window)[len(self.before):]
        self.assertGreater(len(copied), second)
        self.assertTrue(LONG.startswith(copied), copied)

    def test_lines_keep_their_numbers_and_the_setting_is_kept(self):
        settings = self.files / "settings"
        window = self.open_wrapped(settings=settings)
        text = window.settle()["widgets"]["source/text"]
        window.key("ctrl+g")
        window.wait(lambda s: "source/line" in s["widgets"])
        window.key("ctrl+a")
        window.type("2+3")
        window.key("Return")
        state = window.wait(lambda s: s["source"]["line"] == 5)
        self.assertEqual(state["source"]["column"], 1)
        window.key("ctrl+Home", "Down", "Down", "Down", "shift+End", "ctrl+f")
        window.wait(lambda s: "find" in s)
        window.key("ctrl+a")
        window.type("vec3(1., 2., 3.)")
        window.wait(lambda s: s.get("find", {}).get("count") == 1)
        window.key("Escape")
        state = window.wait(lambda s: s["source"]["active"] and s["source"]["line"] == 4 and s["source"]["column"] > 60)
        self.assertLess(state["source"]["cursor"][0], text[0] + text[2], "nothing is scrolled sideways")
        window.key("ctrl+q")
        self.assertEqual(window.process.wait(), 0)
        again = self.open(self.files / "one.glib", settings=settings)
        again.wait(lambda s: s["source"]["wraps"])


class Errors(WritingTest):
    def test_the_banner_counts_and_the_list_goes_to_the_place(self):
        (self.files / "one.frag").write_text(BROKEN)
        window = self.open(self.files / "one.glib", "--size", "640x900")
        state = window.wait(lambda s: s["banner"])
        errors = [m for m in state["messages"] if m["severity"] == "error"]
        self.assertGreaterEqual(len(errors), 3)
        self.assertTrue(state["banner"].startswith("one.frag:4:"), state["banner"])
        self.assertTrue(state["banner"].endswith(f"and {len(errors) - 1} more"), state["banner"])
        self.assertIn("messages", state["widgets"])
        window.click("banner", 0.3)
        shown = window.wait(lambda s: s["source"]["active"] and s["source"]["line"] == 4)
        self.assertEqual(shown["source"]["column"], errors[0]["column"])
        # The list stands below the source now, and nowhere else.
        state = window.settle()
        self.assertIn("source/message/2", state["widgets"])
        self.assertNotIn("messages", state["widgets"])
        x, y = window.point("banner", 0.3)
        window.move(x, y)
        window.wait(lambda s: errors[0]["text"] in s["source"]["hover"])
        last = max(each["line"] for each in errors)
        window.click(f"source/message/{[each['line'] for each in errors].index(last)}", 0.1)
        window.wait(lambda s: s["source"]["line"] == last)

    def test_values_of_a_program_that_does_not_compile_are_not_known(self):
        (self.files / "one.frag").write_text(BROKEN)
        window = self.open(self.files / "one.glib", "--size", "640x900")
        window.wait(lambda s: "uniforms/none: The program does not compile, so its values are not known." in s["widgets"])

    def test_the_place_is_marked_at_the_edge_and_underlined(self):
        (self.files / "one.frag").write_text(BROKEN)
        window = self.open(self.files / "one.glib", "--size", "640x560")
        window.click("banner", 0.3)
        window.wait(lambda s: s["source"]["active"] and s["source"]["line"] == 4)
        window.move(5, 5)
        state = window.settle()
        left = state["widgets"]["source/text"][0]
        x, top, bottom = state["source"]["cursor"]
        row = bottom - top
        marked = self.pixel(window, left + 2, top + row / 2)
        plain = self.pixel(window, left + 2, top - 1.5 * row)
        self.assertGreater(marked[0] - plain[0], 100, f"{marked} beside {plain}")

        def reds(foot):
            """Reddish pixels at the foot of a line, from the cursor on, where the wrong word stands."""
            return sum(1 for across in range(4, 30) for up in (1, 2, 3)
                       if self.is_red(self.pixel(window, x + across, foot - up)))
        self.assertGreater(reds(bottom), 10)
        self.assertEqual(reds(bottom - row), 0, "the line above is right")

    @staticmethod
    def is_red(pixel):
        return pixel[0] > 200 and pixel[1] < 190 and pixel[0] - pixel[2] > 60

    def test_an_error_in_one_tab_opens_no_list_in_another(self):
        (self.files / "one.frag").write_text(BROKEN)
        (self.files / "two.frag").write_text(SHADER + "#pragma optionNV(fastmath on)\n")
        window = self.open(self.files / "one.glib", "--size", "640x700")
        window.wait(lambda s: "message/0" in s["widgets"])
        window.xdotool("key", "ctrl+t")
        window.wait(lambda s: "files/entry" in s["widgets"] or s["takesText"])
        window.type(str(self.files / "kinds.glib"))
        window.key("Return")
        state = window.wait(lambda s: len(s["tabs"]) == 2 and s["shownTab"] == 1)
        state = window.settle()
        self.assertNotIn("message/0", state["widgets"])
        self.assertEqual(state["banner"], "")
        window.key("ctrl+Prior")
        window.wait(lambda s: s["shownTab"] == 0 and "message/0" in s["widgets"])


class Completion(WritingTest):
    def setUp(self):
        super().setUp()
        (self.files / "one.frag").write_text(TYPED)

    def words(self, state):
        return [each["word"] for each in state["completion"]["words"]]

    def test_two_letters_open_the_list_and_tab_accepts(self):
        window = self.open(self.files / "one.glib", "--size", "640x560")
        self.edit(window, 3)
        window.key("Return")
        window.type("float f = s")
        self.assertFalse(window.settle()["completion"]["open"])
        window.type("mo")
        state = window.wait(lambda s: s["completion"]["open"])
        self.assertEqual(self.words(state)[0], "smoothstep")
        self.assertEqual(state["completion"]["words"][0]["type"], "T smoothstep(T low, T high, T x)")
        window.key("Tab")
        window.wait(lambda s: not s["completion"]["open"])
        window.type("(0., 1., uB")
        state = window.wait(lambda s: s["completion"]["open"])
        self.assertEqual(state["completion"]["words"][0], {"word": "uBlue", "type": "float"})
        window.key("Return")
        window.wait(lambda s: not s["completion"]["open"])
        window.type(");")
        self.assertIn("float f = smoothstep(0., 1., uBlue);\n", self.text_of(window))
        window.wait(lambda s: not any(m["severity"] == "error" for m in s["messages"]))

    def test_control_space_asks_arrows_choose_and_escape_closes(self):
        window = self.open(self.files / "one.glib", "--size", "640x560")
        self.edit(window, 3)
        window.key("Return")
        window.type("f")
        window.key("ctrl+space")
        state = window.wait(lambda s: s["completion"]["open"])
        self.assertGreater(len(self.words(state)), 5)
        window.key("Down")
        window.wait(lambda s: s["completion"]["chosen"] == 1)
        window.key("Up", "Up")
        window.wait(lambda s: s["completion"]["chosen"] > 5)
        line = window.state()["source"]["line"]
        window.key("Escape")
        state = window.wait(lambda s: not s["completion"]["open"])
        self.assertEqual(state["source"]["line"], line, "the arrows moved no cursor")
        self.assertTrue(state["source"]["active"])
        window.key("Tab")
        window.type("x")
        self.assertIn("f   x\n", self.text_of(window), "without the list, Tab writes blanks again")

    def test_a_click_accepts(self):
        window = self.open(self.files / "one.glib", "--size", "640x560")
        self.edit(window, 3)
        window.key("Return")
        window.type("vec4 v = uModelV")
        state = window.wait(lambda s: len(s["completion"]["words"]) > 1 and "completion/1" in s["widgets"])
        self.assertEqual(state["completion"]["words"][0], {"word": "uModelViewMatrix", "type": "mat4"})
        word = state["completion"]["words"][1]["word"]
        window.click("completion/1", 0.1)
        window.wait(lambda s: not s["completion"]["open"] and s["source"]["active"])
        window.type(";")
        self.assertIn(f"vec4 v = {word};\n", self.text_of(window))

    def test_undo_brings_back_what_was_typed(self):
        window = self.open(self.files / "one.glib", "--size", "640x560")
        self.edit(window, 3)
        window.key("Return")
        window.type("smoo")
        window.wait(lambda s: s["completion"]["open"])
        window.key("Tab")
        window.wait(lambda s: not s["completion"]["open"])
        window.key("ctrl+z")
        window.settle()
        self.assertFalse(window.state()["completion"]["open"])
        self.assertIn("smoo\n", self.text_of(window))

    def test_enter_after_a_whole_word_in_other_case_is_a_new_line(self):
        window = self.open(self.files / "one.glib", "--size", "640x560")
        self.edit(window, 3)
        window.key("Return")
        window.type("UBlue")
        state = window.wait(lambda s: s["completion"]["open"])
        self.assertEqual(self.words(state)[0], "uBlue")
        window.key("Return")
        window.wait(lambda s: not s["completion"]["open"])
        self.assertIn("    UBlue\n", self.text_of(window))

    def test_scenes_get_their_own_words(self):
        window = self.open(self.files / "one.glib", "--size", "640x560")
        self.edit(window, 3)
        window.click("source/file/one.glib")
        window.wait(lambda s: s["source"]["file"].endswith("one.glib"))
        self.edit(window, 6)
        window.key("Return")
        window.type("Sph")
        state = window.wait(lambda s: s["completion"]["open"])
        self.assertEqual(state["completion"]["words"][0], {"word": "Sphere", "type": "command"})
        window.key("Tab")
        window.type(" .2")
        window.key("ctrl+s")
        window.wait(lambda s: not s["source"]["changed"])
        self.assertIn("QuadXY 0. .7\nSphere .2", (self.files / "one.glib").read_text())


class Editing(WritingTest):
    def test_control_slash_comments_and_uncomments(self):
        window = self.open(self.files / "one.glib", "--size", "640x560")
        self.edit(window, 4)
        window.key("ctrl+slash")
        self.assertIn("    // c = vec4(1., 0., uBlue, 1.);\n", self.text_of(window))
        window.key("ctrl+slash")
        self.assertEqual(self.text_of(window), SHADER)
        window.key("ctrl+Home", "shift+Down", "shift+Down", "ctrl+slash")
        self.assertTrue(self.text_of(window).startswith("// #version 330\n// uniform float uBlue; out vec4 c;\nvoid"))
        window.key("ctrl+z")
        self.assertEqual(self.text_of(window), SHADER)

    def test_tab_moves_the_selected_lines(self):
        window = self.open(self.files / "one.glib", "--size", "640x560")
        self.edit(window, 4)

        def saves(text, *keys, otherwise=None):
            window.key(*keys, "ctrl+s")
            window.wait(lambda s: (self.files / "one.frag").read_text() in (text, otherwise))
            window.settle()

        saves("".join(("    " if i < 2 else "") + line for i, line in enumerate(SHADER.splitlines(True))),
              "ctrl+Home", "shift+Down", "shift+Down", "Tab")
        saves(SHADER, "shift+Tab")
        saves("    " + SHADER, "ctrl+Home", "Tab")
        saves(SHADER, "ctrl+z")
        saves(SHADER.replace("#version", "#", 1), "ctrl+Home", "Right", "ctrl+Delete",
              otherwise=SHADER.replace("#version ", "#", 1))  # since ImGui 1.90 the blank goes, too

    def test_save_values_and_text_that_is_not_saved_do_not_meet_as_a_conflict(self):
        window = self.open(self.files / "one.glib", "--size", "640x560")
        self.edit(window, 4)
        window.click("source/file/one.glib")
        window.wait(lambda s: s["source"]["file"].endswith("one.glib"))
        self.edit(window, 1)
        window.type("  # typed")
        window.wait(lambda s: s["source"]["changed"])
        window.drag_widget("uniform/Plain/uBlue", .25, .8)
        window.wait_knob("uBlue", lambda v: v[0] > .7)
        window.click("scene/save")
        window.wait(lambda s: "<0. .25 1.>" not in (self.files / "one.glib").read_text())
        state = window.wait(lambda s: s["source"]["changed"] and not s["source"]["conflict"])
        saved = (self.files / "one.glib").read_text()
        self.assertNotIn("# typed", saved)
        window.settle()
        window.click("source/save")
        window.wait(lambda s: not s["source"]["changed"])
        self.assertEqual((self.files / "one.glib").read_text(), saved.replace("300 300", "300 300  # typed"))

    def test_a_name_under_the_mouse_shows_its_declaration_and_value(self):
        window = self.open(self.files / "one.glib", "--size", "640x560")
        self.edit(window, 4)
        window.key("Home", *["Right"] * SHADER.splitlines()[3].index("Blue"))
        x, top, bottom = window.settle()["source"]["cursor"]
        window.move(x, (top + bottom) / 2)
        state = window.wait(lambda s: "uBlue" in s["source"]["hover"])
        self.assertEqual(state["source"]["hover"], "uniform float uBlue\nnow: 0.25")
        window.move(x, bottom + 3 * (bottom - top))
        window.wait(lambda s: "uBlue" not in s["source"]["hover"])

    def test_f1_opens_the_entry_and_escape_closes_it(self):
        window = self.open(self.files / "one.glib", "--size", "640x560")
        self.edit(window, 4)
        window.key("Home", *["Right"] * 10, "F1")
        state = window.wait(lambda s: s["reference"]["open"])
        self.assertEqual(state["reference"]["word"], "vec4")
        window.click("reference/word", 0.5)
        window.type("smoothstep")
        state = window.wait(lambda s: s["reference"]["word"] == "smoothstep")
        self.assertEqual(state["reference"]["code"], ["T smoothstep(T low, T high, T x)"])
        window.key("Escape")
        window.wait(lambda s: not s["reference"]["open"])
        self.edit(window, 2)
        window.key("Home", "F1")
        window.wait(lambda s: s["reference"]["open"] and s["reference"]["word"] == "uniform")

    def test_the_text_gets_the_keyboard_back_from_what_escape_closes(self):
        window = self.open(self.files / "one.glib", "--size", "640x560")
        self.edit(window, 4)
        window.key("Home", *["Right"] * 10, "F1")
        window.wait(lambda s: s["reference"]["open"] and not s["source"]["active"])
        window.key("Escape")
        window.wait(lambda s: not s["reference"]["open"] and s["source"]["active"])
        window.key("End")
        window.type(" // 1")
        window.key("ctrl+o")
        window.wait(lambda s: "scene/path" in s["widgets"] and s["takesText"])
        window.settle()
        window.key("Escape")
        window.wait(lambda s: "scene/path" not in s["widgets"] and s["source"]["active"])
        window.type("2")
        self.assertIn("uBlue, 1.); // 12\n", self.text_of(window))
        # After a click on the picture the keys are not for the text.
        left, top, width, height = window.settle()["picture"]
        window.key("F1")
        window.wait(lambda s: s["reference"]["open"])
        window.move(left + width - 8, top + 8)
        window.press()
        window.release()
        window.key("Escape")
        window.wait(lambda s: not s["reference"]["open"])
        window.settle()
        self.assertFalse(window.state()["source"]["active"])

    def test_f1_takes_the_word_before_the_cursor_or_lists_the_words(self):
        window = self.open(self.files / "one.glib", "--size", "640x560")
        self.edit(window, 4)
        line = SHADER.splitlines()[3]
        window.key("Home", *["Right"] * (line.index("vec4(") + 5), "F1")
        window.wait(lambda s: s["reference"]["open"] and s["reference"]["word"] == "vec4")
        window.key("Escape")
        window.wait(lambda s: s["source"]["active"])
        window.key("Home", "F1")
        window.wait(lambda s: s["reference"]["open"] and s["reference"]["word"] == "")
        window.type("smooths")
        window.wait(lambda s: "reference/word/smoothstep" in s["widgets"])
        window.settle()
        window.click("reference/word/smoothstep", 0.1)
        state = window.wait(lambda s: s["reference"]["word"] == "smoothstep")
        self.assertEqual(state["reference"]["code"], ["T smoothstep(T low, T high, T x)"])

    def test_compiles_while_typing_and_writes_nothing(self):
        window = self.open(self.files / "one.glib", "--size", "640x560")
        self.edit(window, 4)
        before = window.settle()["reloads"]
        window.type(" c.r = 0.;")
        window.settle()
        self.assertEqual(window.state()["reloads"], before, "not unless it is wanted")
        window.click("source/live", 0.1)
        window.wait(lambda s: s["source"]["live"] and s["source"]["compiled"] == 1 and s["reloads"] > before)
        left, top, width, height = window.settle()["picture"]
        self.assertEqual(self.pixel(window, left + width / 2, top + height / 2)[:2], (0, 0))
        self.assertEqual((self.files / "one.frag").read_text(), SHADER)
        # A broken text keeps the last good picture.
        self.edit(window, 4)
        window.type(" oops")
        window.wait(lambda s: s["banner"])
        self.assertEqual(self.pixel(window, left + width / 2, top + height / 2)[:2], (0, 0))
        window.key(*["BackSpace"] * 5)
        window.wait(lambda s: not s["banner"])
        window.click("source/revert")
        window.wait(lambda s: s["source"]["compiled"] == 0)
        window.settle()
        self.assertEqual(self.pixel(window, left + width / 2, top + height / 2)[0], 255)
        self.assertEqual((self.files / "one.frag").read_text(), SHADER)

    def test_saving_does_not_compile_twice(self):
        window = self.open(self.files / "one.glib", "--size", "640x560")
        self.edit(window, 4)
        window.click("source/live", 0.1)
        self.edit(window, 4)
        window.type(" c.r = 0.;")
        window.wait(lambda s: s["source"]["compiled"] == 1)
        before = window.settle()["reloads"]
        window.key("ctrl+s")
        window.wait(lambda s: s["source"]["compiled"] == 0 and s["reloads"] > before)
        time.sleep(0.5)
        self.assertEqual(window.settle()["reloads"], before + 1)


class Probe(WritingTest):
    def setUp(self):
        super().setUp()
        (self.files / "a.vert").write_text(PASSES_ON)
        (self.files / "one.frag").write_text(SHOWS_PLACE)

    def test_a_click_shows_what_the_fragment_has(self):
        window = self.open(self.files / "one.glib", "--size", "800x600")
        window.move(20, 20)
        window.key("d")
        window.wait(lambda s: s["probe"]["on"])
        state = window.settle()
        left, top, width, height = state["picture"]
        # Beside the window of the probe, but on the square.
        across, down = 0.72, 0.6
        window.move(left + across * width, top + down * height)
        window.press()
        window.release()
        state = window.wait(lambda s: s["probe"]["drawn"])
        x = (state["probe"]["x"] + 0.5) / state["width"] * 2 - 1
        y = (state["probe"]["y"] + 0.5) / state["height"] * 2 - 1  # from the lower left corner
        x *= max(1, state["width"] / state["height"])
        y *= max(1, state["height"] / state["width"])
        values = state["probe"]["values"]
        self.assertEqual(state["probe"]["line"], 6)
        self.assertNotIn("picked", state, "the click picks nothing")
        self.assertAlmostEqual(values["vPlace"][0], x, delta=1e-4)
        self.assertAlmostEqual(values["vPlace"][1], y, delta=1e-4)
        self.assertEqual(values["vThree"], [3])
        self.assertEqual(values["uBlue"], [0.25])
        self.assertEqual(values["c"][2:], [0.25, 4])
        window.wait(lambda s: "probe/vPlace" in s["widgets"])
        # The numbers follow the values.
        window.drag_widget("uniform/Plain/uBlue", 0.25, 0.75)
        window.wait(lambda s: s["probe"]["values"].get("uBlue", [0])[0] > 0.5 and
                    s["probe"]["values"]["c"][2] == s["probe"]["values"]["uBlue"][0])
        window.move(20, 590)
        window.key("d")
        window.wait(lambda s: not s["probe"]["on"])

    def test_the_window_covers_no_pixel_and_shows_whole_names_at_once(self):
        window = self.open(self.files / "one.glib")
        for size in ((800, 600), (1300, 700)):
            window.resize(*size)
            window.wait(lambda s: s["window"] == list(size) and s["room"][3] == size[1])
            window.move(20, 20)
            window.key("d")
            state = window.wait(lambda s: "probeWindow" in s["widgets"])
            state = window.settle()
            left, top, width, height = state["picture"]
            self.assertGreaterEqual(state["widgets"]["probeWindow"][0], left + width)
            window.move(left + width / 2, top + height / 2)
            window.press()
            window.release()
            window.wait(lambda s: s["probe"]["drawn"] and "probe/type/vPlace" in s["widgets"])
            widgets = window.settle()["widgets"]
            for name in ("c", "vPlace", "vThree", "uBlue"):
                at, _, wide, _ = widgets[f"probe/{name}"]
                self.assertGreaterEqual(widgets[f"probe/type/{name}"][0], at + wide, name)
            window.key("d")
            window.wait(lambda s: not s["probe"]["on"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
