"""The base class of the window's tests: scenes in a temporary folder, and comparison with `glibra render`."""

import os
import pathlib
import tempfile
import unittest

from desktop import Desktop, Window, rendered

PROGRAM = os.environ["GLIBRA_PROGRAM"]
SOURCES = pathlib.Path(os.environ["GLIBRA_SOURCE_DIR"])
OVALS = SOURCES / "glib/patterns/ovalnoise.glib"

ALL_KINDS = """WindowSize 300 300
Ortho -1 1 -1 1
Vertex a.vert
Fragment a.frag
Program Kinds \\
    uFloat <0. .25 1.> \\
    uInt <0 1 8> \\
    uBool <false> \\
    uRgb {.2 .4 .6} \\
    uRgba {.2 .4 .6 1.} \\
    uVector [.1 .2] \\
    uArray [.1 .2 .3]
QuadXY 0. .7
"""
VERTEX = "#version 330\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n"
FRAGMENT = """#version 330
uniform float uFloat; uniform int uInt; uniform bool uBool; uniform vec3 uRgb; uniform vec4 uRgba;
uniform vec2 uVector; uniform float uArray[3]; out vec4 c;
void main() {
    c = vec4(uFloat, float(uInt) / 8., uBool ? 1. : 0., 1.);
    c.rgb = .5 * c.rgb + .2 * uRgb + .1 * uRgba.rgb * uRgba.a + vec3(uVector, uArray[0] + uArray[2]) * .1;
}
"""
VARIABLES = """# Variables of every kind that has a control, a group, a repetition, and the time.
Background .1 .1 .15
Camera eye LookAt 0 1 8  0 0 0  0 1 0  Perspective 40 .1 100
Let size <.2 .5 1>
Let shape <ball cube>
Let high <true>
Let tint {.9 .5 .2}

Group body x 0
    Translate (x) (high ? sin(time) : 0) 0
    Color (tint)
    When (shape == ball)
        Sphere (size)
    Else
        Box (2*size)
    EndWhen
EndGroup

Repeat 3
    Draw body x (2*i - 2)
EndRepeat
"""
MOVING = """WindowSize 200 200
Ortho -1 1 -1 1
Vertex a.vert
Fragment moving.frag
Program Moving uR <0. .5 1.>
QuadXY 0. 1.
"""
MOVING_FRAGMENT = "#version 330\nuniform float uR; out vec4 c;\nvoid main() { c = vec4(uR, Timer, 0., 1.); }\n"


class WindowTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.desktop = Desktop()

    @classmethod
    def tearDownClass(cls):
        cls.desktop.close()

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)  # a window that was killed may still write
        self.files = pathlib.Path(self.folder.name)
        (self.files / "kinds.glib").write_text(ALL_KINDS)
        (self.files / "moving.glib").write_text(MOVING)
        (self.files / "variables.glib").write_text(VARIABLES)
        (self.files / "a.vert").write_text(VERTEX)
        (self.files / "a.frag").write_text(FRAGMENT)
        (self.files / "moving.frag").write_text(MOVING_FRAGMENT)

    def tearDown(self):
        self.folder.cleanup()

    def open(self, scene, *arguments, **options):
        """Opens a window. Its pictures have as many samples per pixel as those of users, unless the arguments say another
        number."""
        window = Window(self.desktop, PROGRAM, scene, *arguments, **options)
        self.addCleanup(window.close)
        return window

    def assertShows(self, window, scene, *arguments):
        """The picture on the screen has the same bytes as `glibra render` with those arguments and as many samples."""
        width, height, screen = window.pixels()
        if "--samples" not in arguments:
            arguments = (*arguments, "--samples", str(max(1, window.state()["samples"])))
        picture = rendered(PROGRAM, scene, width, height, *arguments)
        self.assertEqual((width, height), picture[:2])
        different = sum(1 for a, b in zip(screen, picture[2]) if a != b)
        self.assertEqual(different, 0, f"of {len(screen)} bytes")

    def set_of(self, window):
        arguments = []
        for each in window.settle()["knobs"]:
            if each["current"] != each["initial"]:
                arguments += ["--set", each["tag"] + "=" + ",".join(repr(v) for v in each["current"])]
        return arguments
