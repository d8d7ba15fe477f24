"""Tests of what the keyboard alone reaches: every widget by Tab, menus, lists, dialogs and examples by arrows and Enter."""

import sys
import unittest

from scenes_test import ScenesTest, SCENE

FOCUS = """WindowSize 300 300
Ortho -1 1 -1 1
Vertex a.vert
Fragment a.frag
Program Kinds uFloat <0. .25 1.> uBool <false> uRgba {.2 .4 .6 1.} uVector [.1 .2]
QuadXY 0. .7
"""


class Keyboard(ScenesTest):
    def focused(self, window, name):
        return window.wait(lambda s: s["focused"] == name)

    def tab(self, window, key="Tab"):
        """Goes to the next widget, and returns its name; empty if it has none for tests."""
        presented = window.state()["framesPresented"]
        window.xdotool("key", key)
        return window.wait(lambda s: s["framesPresented"] > presented and s["waiting"])["focused"]

    def choose(self, window, name, key="Down"):
        """Goes on until that entry of a menu or list is chosen, and takes it."""
        for _ in range(20):
            if window.settle()["focused"] == name:
                break
            window.key(key)
        self.focused(window, name)
        window.key("Return")

    def test_tab_goes_from_widget_to_widget_and_enter_does_what_a_click_does(self):
        (self.files / "focus.glib").write_text(FOCUS)
        window = self.open(self.files / "focus.glib", "--size", "300x900")
        window.move(20, 20)
        window.key("Tab")
        self.focused(window, "uniform/Kinds/uFloat")
        window.key("Right", "Tab")
        window.wait_knob("uFloat", lambda v: v == [0.26])
        self.focused(window, "uniform/Kinds/uBool")
        window.key("Return")
        window.wait_knob("uBool", lambda v: v == [1])
        window.key("space")
        state = window.wait_knob("uBool", lambda v: v == [0])
        self.assertFalse(state["playing"] and state["moving"])
        window.key("Tab")
        self.focused(window, "uniform/Kinds/uRgba/swatch")
        # The numbers of a colour are text fields.
        window.key("Tab")
        window.wait(lambda s: s["takesText"])
        window.key("ctrl+a")
        window.type("0.5")
        window.key("Tab")
        window.wait_knob("uRgba", lambda v: v == [0.5, 0.4, 0.6, 1])
        # Back to the buttons above the values, and to the sections below.
        for _ in range(3):
            window.key("Escape", "shift+Tab")
        missing = {"uniforms/reset", "scene/save", "uniforms/labels", "file", "scene/open", "help", "uniforms",
                   "transforms", "mode/Eye", "view/axes", "view/show", "hardcopy", "suite", "cost"}
        for _ in range(80):
            missing.discard(self.tab(window))
            if not missing:
                break
        self.assertEqual(missing, set())
        window.key("Escape")

    def test_a_section_folds_and_a_list_is_chosen_from(self):
        window = self.open(self.files / "one.glib", "--size", "300x900")
        window.move(20, 20)
        for _ in range(60):
            if self.tab(window) == "view/samples":
                break
        self.focused(window, "view/samples")
        window.key("Return")
        window.wait(lambda s: "view/samples/8" in s["widgets"])
        self.choose(window, "view/samples/4")
        window.wait(lambda s: "view/samples/8" not in s["widgets"])
        window.key("shift+Tab", "shift+Tab", "shift+Tab")
        for _ in range(40):
            if self.tab(window, "shift+Tab") == "uniforms":
                break
        self.focused(window, "uniforms")
        window.key("Return")
        window.wait(lambda s: "uniform/Plain/uBlue" not in s["widgets"])
        window.key("Return")
        window.wait(lambda s: "uniform/Plain/uBlue" in s["widgets"])

    def test_the_menu_of_a_value_and_the_menu_file_open_by_keys(self):
        window = self.open(self.files / "one.glib", "--size", "400x700", "--set", "uBlue=.75")
        window.move(20, 20)
        window.key("Tab")
        self.focused(window, "uniform/Plain/uBlue")
        window.key("shift+F10")
        window.wait(lambda s: "menu/reset" in s["widgets"])
        self.choose(window, "menu/reset")
        window.wait_knob("uBlue", lambda v: v == [0.25])
        for keys in (("F10",), ("alt",)):
            window.key(*keys)
            window.wait(lambda s: "file/open" in s["widgets"])
            window.settle()
            window.key("Down", "Down")
            window.key("Escape")
            window.wait(lambda s: "file/open" not in s["widgets"])
        window.key("F10")
        window.wait(lambda s: "file/open" in s["widgets"])
        window.settle()
        for _ in range(3):
            window.key("Down")
        window.key("Escape")
        # A dialog: the text has the keyboard, the arrows go to the list.
        window.key("ctrl+o")
        window.wait(lambda s: "scene/path" in s["widgets"] and s["takesText"])
        window.settle()
        window.type("two.glib")
        window.key("Return")
        window.wait(lambda s: s["question"] or s["scene"].endswith("two.glib"))

    def library(self):
        root = self.files / "library"
        for folder in ("glib/start", "shaders"):
            (root / folder).mkdir(parents=True)
        for name in ("one", "two", "three", "four"):
            (root / f"glib/start/{name}.glib").write_text(SCENE.format("one"))
        for name in ("a.vert", "one.frag"):
            (root / "shaders" / name).write_text((self.files / name).read_text())
        return root

    def test_arrows_and_enter_open_an_example(self):
        window = self.open(None, variables={"GLIBRA_PATH": str(self.library())})
        window.wait(lambda s: s["examples"]["open"] and s["examples"]["scenes"] == 4 and s["takesText"])
        window.settle()
        window.key("Down")
        first = window.wait(lambda s: s["examples"]["chosen"])["examples"]["chosen"]
        window.key("Right")
        second = window.wait(lambda s: s["examples"]["chosen"] not in ("", first))["examples"]["chosen"]
        window.key("Left", "Right", "Return")
        window.wait(lambda s: s["scene"].endswith(second.split("/")[1] + ".glib") and not s["examples"]["open"])

    def test_f6_goes_to_the_source_and_back(self):
        window = self.open(self.files / "one.glib", "--size", "700x700")
        window.move(20, 20)
        window.key("e")
        window.wait(lambda s: s["source"]["shown"])
        window.key("Tab")
        self.focused(window, "uniform/Plain/uBlue")
        window.key("F6")
        window.wait(lambda s: s["focused"].startswith("source/"))
        for _ in range(12):
            if window.settle()["focused"] == "source/text":
                break
            window.key("Tab")
        self.focused(window, "source/text")
        window.key("Return")
        window.wait(lambda s: s["source"]["active"])
        window.key("ctrl+End")
        window.type("# by keys")
        window.wait(lambda s: s["source"]["changed"])
        window.key("F6")
        window.wait(lambda s: not s["source"]["active"] and not s["focused"].startswith("source/"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
