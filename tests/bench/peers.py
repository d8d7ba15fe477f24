"""Other programs that draw the same picture, if they are installed. README.md describes what each does besides drawing."""
import math
import os
import shutil
import subprocess

from processes import GLIBRA, ROOT, TOOLS, measure

# A pattern as expensive as the fragment stage of an exercise, in the form that each program needs.
PATTERN = """
vec4 pattern(vec2 p) {
    vec3 sum = vec3(0.);
    for (int i = 1; i <= 12; ++i)
        sum += .5 + .5 * sin(float(i) * (p.x * vec3(3., 5., 7.) + p.y * vec3(7., 3., 5.)) + float(i));
    return vec4(sum / 12., 1.);
}
"""
FULL = "out vec4 fColor;\nvoid main() { fColor = pattern(gl_FragCoord.xy / 600.); }\n"
SHADER_TEST = ("[require]\nGLSL >= 3.30\nSIZE 600 600\n\n[vertex shader passthrough]\n\n[fragment shader]\n#version 330\n"
               + PATTERN + FULL + "\n[test]\ndraw rect -1 -1 2 2\n")
QUAD = ("WindowSize 600 600\nOrtho -1. 1. -1. 1.\nVertex quad.vert\nFragment quad.frag\nProgram Quad\nQuadXY 0. 1.\n",
        "#version 330\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n")
MODEL = ("WindowSize 600 600\nPerspective 50. .1 1000.\nLookAt 0. 0. {eye} 0. 0. 0. 0. 1. 0.\nVertex lit.vert\n"
         "Fragment lit.frag\nProgram Lit\nColor .8 .8 .8\nObj {model}\n")


def write(folder, name, text):
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def pattern_at(x, y):
    """The pattern's red, green and blue at a point of 0..1 times 0..1."""
    return [sum(.5 + .5 * math.sin(i * (x * a + y * b) + i) for i in range(1, 13)) / 12
            for a, b in ((3, 7), (5, 3), (7, 5))]


def runs(command, environment=None):
    """True if a peer does what it is asked for on this machine."""
    try:
        measure(command, environment)
        return True
    except (OSError, subprocess.CalledProcessError):
        return False


class Display:
    """An X server without a screen, for peers that want one."""

    def __enter__(self):
        self.server = None
        if shutil.which("Xvfb"):
            read, end = os.pipe()
            self.server = subprocess.Popen(["Xvfb", "-displayfd", str(end), "-screen", "0", "1280x1024x24"],
                                           pass_fds=[end], stderr=subprocess.DEVNULL)
            os.close(end)
            with os.fdopen(read, encoding="ascii") as file:
                self.environment = {"DISPLAY": ":" + file.readline().strip()}
        return self

    def __exit__(self, *_):
        if self.server:
            self.server.terminate()
            self.server.wait()


def piglit():
    found = shutil.which("shader_runner")
    usual = "/usr/lib/x86_64-linux-gnu/piglit/bin/shader_runner"
    return found or (usual if os.path.exists(usual) else None)


def contests(folder):
    """What is drawn, the peer's name, ours and theirs as functions that give their cost."""
    out = os.path.join(folder, "out.png")
    quad = write(folder, "quad.glib", QUAD[0])
    write(folder, "quad.vert", QUAD[1])
    write(folder, "quad.frag", "#version 330\n" + PATTERN + FULL)

    def ours(scene):
        return lambda: measure([GLIBRA, "render", scene, "-o", out])

    runner = piglit()
    test = [runner, write(folder, "quad.shader_test", SHADER_TEST + "probe rgb 300 300 {} {} {}\n".format(*pattern_at(300.5 / 600, 300.5 / 600))), "-auto", "-fbo"]
    surfaceless = {"PIGLIT_PLATFORM": "surfaceless_egl"}
    if runner and runs(test, surfaceless):
        yield "full-screen pattern, 600 x 600", "piglit shader_runner", ours(quad), lambda: measure(test, surfaceless)
    with Display() as display:
        if not display.server:
            return
        viewer = os.environ.get("GLIBRA_GLSLVIEWER")
        plain = write(folder, "plain.frag", "#version 330\n" + PATTERN + FULL)
        view = [viewer, plain, "--headless", "-w", "600", "-h", "600", "--noncurses", "-E",
                "screenshot," + os.path.join(folder, "viewer.png")]
        if viewer and runs(view, display.environment):
            yield "full-screen pattern, 600 x 600", "glslViewer", ours(quad), lambda: measure(view, display.environment)
        if shutil.which("f3d"):
            yield from models(folder, ours, display.environment)


def models(folder, ours, environment):
    from one_image import write_scene
    write_scene(folder)
    grid = os.path.join(folder, "grid.obj")
    subprocess.run([os.path.join(TOOLS, "glibra_load_obj"), "grid", grid], check=True)
    for what, model, eye in (("cow.obj, 0.4 MB, 600 x 600", os.path.join(ROOT, "scenes", "models", "cow.obj"), 4.2),
                             ("OBJ of 70 MB, 600 x 600", grid, 3)):
        scene = write(folder, "model.glib", MODEL.format(model='"' + model + '"', eye=eye))
        f3d = ["f3d", "--dry-run", "--resolution=600,600", "--output=" + os.path.join(folder, "f3d.png"), model]
        if runs(f3d, environment):
            yield what, "F3D", ours(scene), lambda command=f3d: measure(command, environment)
