"""Tests of the window "Frame", the picture before an edit, and the export of tables."""

import sys
import unittest

from window_case import WindowTest

SCENE = """WindowSize 400 300
Texture2D glow 64 64 rgba16f nearest
Camera eye LookAt 0 0 5  0 0 0  0 1 0  Ortho -1 1 -1 1 1 10
Vertex a.vert
Fragment flat.frag
Program Flat uColor {1. 0. 0.}
Fragment show.frag
Program Show uImage glow
Buffer Places vec4 3
Compute place.comp
Program Place
Dispatch Place over Places
Use Flat
Pass glow clear {0 0 .25 1}
    QuadXY 0 .5
    Set uColor {0. 1. 0.}
    QuadXY -1 .75
EndPass
Fill window with Show
"""
FILES = {
    "a.vert": "#version 330\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n",
    "flat.frag": "#version 330\nuniform vec3 uColor; out vec4 c;\nvoid main() { c = vec4(uColor, 1.); }\n",
    "show.frag": "#version 330\nuniform sampler2D uImage; out vec4 c;\n"
                 "void main() { c = texture(uImage, gl_FragCoord.xy / vec2(600., 450.)); }\n",
    "read.frag": "#version 430\nuniform sampler2D uImage; out vec4 c;\n"
                 "layout(std430) readonly buffer Places { vec4 places[]; };\n"
                 "void main() { c = places[0].y / 2. * texture(uImage, gl_FragCoord.xy / vec2(600., 450.)); }\n",
    "place.comp": "#version 430\nlayout(local_size_x = 1) in;\nlayout(std430) buffer Places { vec4 places[]; };\n"
                  "void main() { places[gl_GlobalInvocationID.x] = vec4(gl_GlobalInvocationID.x, 2., 3., 4.); }\n",
}


class FrameWindow(WindowTest):
    def open_frame(self, without=(), **options):
        for name, text in FILES.items():
            (self.files / name).write_text(text)
        lines = [each for each in SCENE.splitlines(True) if not any(word in each for word in without)]
        text = "".join(lines)
        (self.files / "frame.glib").write_text(text if without else text.replace("show.frag", "read.frag"))
        return self.open(self.files / "frame.glib", "--size", "1000x760", **options)

    @staticmethod
    def titles(state):
        return [each["title"] for each in state["frame"]["items"]]

    def click_texel(self, window, x, y, side=64):
        """Clicks a texel of the shown target, counted from the lower left corner."""
        left, top, width, height = window.wait(lambda s: "frame/image" in s["widgets"])["widgets"]["frame/image"]
        window.move(left + (x + 0.5) * width / side, top + height - (y + 0.5) * height / side)
        window.press()
        window.release()

    def test_it_lists_what_each_item_left(self):
        window = self.open_frame()
        window.settle()
        self.assertNotIn("frame", window.state())
        window.key("g")
        state = window.wait(lambda s: "frame" in s and s["frame"]["items"])
        self.assertEqual(self.titles(state), ["dispatch of Place", "pass into glow", "QuadXY", "QuadXY",
                                              "pass into window", "Fill"])
        items = state["frame"]["items"]
        self.assertTrue(all(each["drawn"] for each in items))
        self.assertTrue(all(each["thumbnail"] for each in items[1:]))
        self.assertEqual(state["frame"]["chosen"], items[4]["key"], "the pass into the window is chosen first")
        window.click("frame/item/" + items[3]["key"])
        state = window.wait(lambda s: s["frame"]["chosen"] == items[3]["key"] and "mask" in s["frame"])
        self.assertEqual(state["frame"]["size"], [64, 64])
        self.assertTrue(all(each["thumbnail"] for each in window.settle()["frame"]["items"][1:]), "all small pictures stay")
        self.assertEqual(state["frame"]["mask"], {"passed": 48 * 48 - 32 * 32, "hidden": 32 * 32})
        # The history of a pixel of the small quad: the large one is behind it.
        self.click_texel(window, 32, 20)
        state = window.wait(lambda s: s["frame"].get("pixel", {}).get("events"))
        pixel = state["frame"]["pixel"]
        self.assertEqual([pixel["x"], pixel["y"]], [32, 20])
        self.assertEqual([each["outcome"] for each in pixel["events"]],
                         ["the pass begins", "drawn", "hidden: the depth test fails"])
        self.assertEqual(pixel["events"][1]["after"]["color"], [1, 0, 0, 1])
        # A click on a line chooses the draw, and the probe tells its values there.
        window.click("frame/event/1")
        window.wait(lambda s: s["frame"]["chosen"] == items[2]["key"])
        window.click("frame/event/2")
        window.wait(lambda s: s["frame"]["chosen"] == items[3]["key"])
        window.click("frame/probe")
        probed = window.wait(lambda s: "probed" in s["frame"]["pixel"])["frame"]["pixel"]["probed"]
        self.assertTrue(probed["drawn"] and probed["hidden"])
        self.assertEqual(probed["values"]["uColor"], [0, 1, 0])
        self.assertEqual(probed["values"]["gl_FragCoord"][:2], [32.5, 20.5])
        # The debug view of the pass that the Fill hides.
        window.click("frame/show")
        window.click("frame/show/layers")
        window.wait(lambda s: s["frame"]["show"] == "layers" and not s["frame"]["problem"])
        left, top, width, height = window.state()["widgets"]["frame/image"]
        window.move(left + width / 2, top + height / 2)
        window.wait(lambda s: s["frame"]["hovered"].endswith("2 fragments"))
        window.key("Escape")
        window.wait(lambda s: "frame" not in s)

    def test_it_shows_state_and_vertices_and_follows_edits(self):
        window = self.open_frame()
        window.key("g")
        items = window.wait(lambda s: "frame" in s and s["frame"]["items"])["frame"]["items"]
        window.click("frame/item/" + items[2]["key"])
        window.click("frame/tab/state")
        window.wait(lambda s: "frame/state/depth test" in s["widgets"])
        window.click("frame/tab/mesh")
        mesh = window.wait(lambda s: "mesh" in s["frame"])["frame"]["mesh"]
        self.assertEqual([each["title"] for each in mesh], ["inputs", "after the vertex stage"])
        self.assertEqual([each["problem"] for each in mesh], ["", ""])
        self.assertEqual(mesh[0]["rows"], mesh[1]["rows"])
        seen = window.state()["reloads"]
        (self.files / "frame.glib").write_text((self.files / "frame.glib").read_text().replace(
            "    QuadXY -1 .75", "    QuadXY -1 .75\n    QuadXY -2 1"))
        state = window.wait(lambda s: s["reloads"] > seen and len(s["frame"]["items"]) == 7)
        self.assertEqual(state["frame"]["chosen"], items[2]["key"], "the choice stays")
        seen = state["reloads"]
        (self.files / "frame.glib").write_text((self.files / "frame.glib").read_text().replace(
            "    QuadXY 0 .5", "    # before it\n    QuadXY -1 .5\n    QuadXY 0 .5"))
        state = window.wait(lambda s: s["reloads"] > seen and len(s["frame"]["items"]) == 8)
        self.assertEqual(state["frame"]["chosen"], state["frame"]["items"][3]["key"], "also when its line moves")

    def test_another_state_is_tried(self):
        window = self.open_frame()
        before = window.pixels()
        window.key("g")
        items = window.wait(lambda s: "frame" in s and s["frame"]["items"])["frame"]["items"]
        window.click("frame/item/" + items[3]["key"])
        hidden = {"passed": 48 * 48 - 32 * 32, "hidden": 32 * 32}
        window.wait(lambda s: s["frame"].get("mask") == hidden)
        window.click("frame/tab/try")
        window.settle()
        for key, word in (("depth", "always"), ("cull", "back")):
            window.click("frame/try/" + key)
            window.wait(lambda s: f"frame/try/{key}/{word}" in s["widgets"])
            window.settle()
            window.click(f"frame/try/{key}/{word}")
            window.settle()
        window.wait(lambda s: s["frame"]["tried"] == ["State cull back  depth always"])
        window.wait(lambda s: s["frame"].get("mask") == {"passed": 48 * 48, "hidden": 0})
        window.click("frame/try/offset", 0.2)
        window.key("ctrl+a")
        window.type("1/2")
        window.key("Return")
        window.wait(lambda s: s["frame"]["tried"] == ["State cull back  depth always  offset 0.5 0"])
        window.click("frame/try/offset", 0.8)
        window.key("ctrl+a")
        window.type("1,5")
        window.key("Return")
        window.wait(lambda s: s["frame"]["tried"] == ["State cull back  depth always  offset 0.5 1.5"])
        window.key("Escape")
        window.wait(lambda s: "frame" not in s)
        self.assertNotEqual(window.pixels(), before, "the picture follows")
        window.key("g")
        window.wait(lambda s: "frame" in s and s["frame"]["items"])
        window.click("frame/item/" + items[3]["key"])
        window.click("frame/tab/try")
        window.settle()
        window.click("frame/try/end")
        window.wait(lambda s: s["frame"]["tried"] == [] and s["frame"].get("mask") == hidden)
        window.key("Escape")
        window.wait(lambda s: "frame" not in s)
        self.assertEqual(window.pixels(), before)

    def test_texels_are_shown_by_an_expression_and_items_have_times(self):
        window = self.open_frame()
        window.key("g")
        items = window.wait(lambda s: "frame" in s and s["frame"]["items"])["frame"]["items"]
        window.click("frame/item/" + items[1]["key"])
        window.click("frame/glsl")
        window.click("frame/expression")
        window.wait(lambda s: s["takesText"])
        window.type("10. * color.bgr")
        left, top, width, height = window.wait(lambda s: "frame/image" in s["widgets"])["widgets"]["frame/image"]
        window.settle()
        window.move(left + width / 2, top + height / 2)
        window.wait(lambda s: s["frame"]["hovered"].endswith(": 0 0 10 1"))
        window.click("frame/fitRange")
        window.wait(lambda s: s["frame"]["range"] == [0, 10])
        window.click("frame/expression")
        window.key("ctrl+a")
        window.type("colour")
        window.wait(lambda s: "frame/expressionProblem" in s["widgets"])
        window.click("frame/glsl")
        window.wait(lambda s: "frame/expressionProblem" not in s["widgets"])
        window.click("frame/times")
        times = window.wait(lambda s: s["frame"]["times"])["frame"]["times"]
        self.assertEqual(set(times), {each["key"] for each in items})

    def test_it_works_on_opengl_4_1(self):
        window = self.open_frame(without=("Buffer", "Comp", "Place"),
                                 variables={"MESA_GL_VERSION_OVERRIDE": "4.1", "MESA_GLSL_VERSION_OVERRIDE": "410"})
        window.key("g")
        state = window.wait(lambda s: "frame" in s and s["frame"]["items"])
        self.assertEqual(self.titles(state), ["pass into glow", "QuadXY", "QuadXY", "pass into window", "Fill"])
        items = state["frame"]["items"]
        window.click("frame/item/" + items[2]["key"])
        window.wait(lambda s: s["frame"].get("mask") == {"passed": 48 * 48 - 32 * 32, "hidden": 32 * 32})
        self.click_texel(window, 32, 20)
        pixel = window.wait(lambda s: s["frame"].get("pixel", {}).get("events"))["frame"]["pixel"]
        self.assertEqual(pixel["events"][2]["outcome"], "hidden: the depth test fails")
        window.click("frame/tab/mesh")
        mesh = window.wait(lambda s: "mesh" in s["frame"])["frame"]["mesh"]
        self.assertEqual([each["problem"] for each in mesh], ["", ""])

    def test_nothing_is_drawn_while_it_is_closed_or_nothing_changes(self):
        window = self.open_frame()
        before = window.settle()
        drawn = before["framesDrawn"]
        window.key("g")
        window.wait(lambda s: "frame" in s and s["frame"]["items"])
        state = window.settle()
        self.assertLessEqual(state["framesDrawn"], drawn + 1, "textures are kept from now on")
        presented = state["framesPresented"]
        self.assertEqual(window.settle()["framesPresented"], presented)

    def test_a_buffer_is_exported(self):
        window = self.open_frame()
        window.key("i")
        window.click("inspector/what")
        window.click("inspector/item/Places")
        window.click("inspector/export")
        window.wait(lambda s: s["dialog"].startswith("Write the buffer") and s["takesText"])
        window.key("ctrl+a")
        window.type(str(self.files / "places.csv"))
        window.key("Return")
        file = self.files / "places.csv"
        window.wait(lambda s: file.exists())
        lines = file.read_text().splitlines()
        self.assertEqual(len(lines), 4)
        self.assertEqual(lines[3].split(",")[-4:], ["2", "2", "3", "4"])


class BeforeAndAfter(WindowTest):
    def test_one_key_shows_the_picture_before_the_edit(self):
        window = self.open(self.files / "kinds.glib", "--size", "300x300")
        before = window.pixels()
        window.key("k")
        self.assertEqual(window.settle()["before"], {"known": False, "shown": False})
        seen = window.state()["reloads"]
        (self.files / "kinds.glib").write_text(
            (self.files / "kinds.glib").read_text().replace("QuadXY 0. .7", "QuadXY 0. .3"))
        window.wait(lambda s: s["reloads"] > seen)
        after = window.pixels()
        self.assertNotEqual(after, before)
        window.key("k")
        self.assertTrue(window.settle()["before"]["shown"])
        shown = window.pixels()[2]
        # Below the label in the corner.
        rows = 3 * 300 * 60
        self.assertEqual(shown[rows:], before[2][rows:])
        window.key("k")
        window.wait(lambda s: not s["before"]["shown"])
        self.assertEqual(window.pixels(), after)

    def test_it_keeps_its_proportions(self):
        scene = self.files / "square.glib"
        scene.write_text("WindowSize 300 300\nBackground .2 .4 .8\nOrtho -1 1 -1 1\nSphere .9 60 60\n")
        window = self.open(scene)
        seen = window.state()["reloads"]
        scene.write_text(scene.read_text().replace("300 300", "300 100"))
        window.wait(lambda s: s["reloads"] > seen and s["width"] > 2 * s["height"])
        window.key("k")
        self.assertTrue(window.settle()["before"]["shown"])
        width, height, shown = window.pixels()
        middle = shown[3 * width * (height // 2):3 * width * (height // 2 + 1)]
        colors = [middle[i:i + 3] for i in range(0, len(middle), 3)]
        blue = colors.count(bytes((51, 102, 204)))
        self.assertAlmostEqual((width - height) / 2, next(i for i, c in enumerate(colors)
                                                         if c == bytes((51, 102, 204))), delta=2)
        self.assertLess(blue, height / 5, "a disk of .9 of a square that is as high as the picture")


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
