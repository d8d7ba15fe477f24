"""Renders GLIB shader scenes to NumPy arrays.

    import glibra
    scene = glibra.Scene("teapot.glib")
    scene.uShininess = 20
    picture = scene.draw(320, 240, time=2.5)      # numpy uint8, (240, 320, 3)

A scene belongs to the thread that made it.
"""
import base64
import math
import numbers
import os
import re
import subprocess
import tempfile
import threading

import numpy

from . import _core
from ._core import Comparison, Diagnostic, SceneError, Value, __version__

__all__ = ["Comparison", "Diagnostic", "Scene", "SceneError", "Value", "compare", "save", "__version__"]

_thread = threading.local()


def _renderer():
    """The renderer of this thread, which its scenes share."""
    if not hasattr(_thread, "renderer"):
        _thread.renderer = _core.Renderer(os.environ.get("GLIBRA_DRIVER", "auto"))
    return _thread.renderer


def _png_of(picture):
    """The bytes of a PNG file."""
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "picture.png")
        save(picture, file)
        with open(file, "rb") as png:
            return png.read()


def save(picture, file):
    """Writes an array as a picture file: .png, .exr, .jpg and others, by the name."""
    _core.save(numpy.asarray(picture), os.fspath(file))


def compare(got, expected, *, largest=3.0, fraction=0.0003, cluster=8, line=16, bias=1.0, flip=None, structure=None,
            relative=1e-4, absolute=1e-6, exact=False):
    """Compares two pictures, arrays or names of files, as golden-image tests do. The result is true if they are the same
    within the tolerance; `reason` says which figure decided. ``relative`` and ``absolute`` are for float pictures, in place
    of ``largest``."""
    as_picture = lambda one: one if isinstance(one, numpy.ndarray) else os.fspath(one)
    return _core.compare(as_picture(got), as_picture(expected), largest, fraction, cluster, line, bias, flip, structure,
                         relative, absolute, exact)


def _shape_of(type):
    """The shape of a GLSL type as NumPy has it: () for a scalar, (3,) for vec3, rows and columns for a matrix."""
    matrix = re.fullmatch(r"d?mat(\d)(?:x(\d))?", type)
    if matrix:
        return int(matrix[2] or matrix[1]), int(matrix[1])  # GLSL names the columns first
    vector = re.fullmatch(r"[bdiu]?vec(\d)", type)
    return (int(vector[1]),) if vector else ()


def _numbers_of(array, declared):
    """The numbers of an array in the order of OpenGL: one element after the other, matrices by columns. A flat array has
    this order already."""
    if array.ndim < 2:
        return array.ravel().tolist()
    one = _shape_of(declared.type)
    whole = (len(declared.value) // math.prod(one), *one)
    if array.shape != whole and (1, *array.shape) != whole:
        expected = whole[1:] if whole[0] == 1 and one else whole
        raise ValueError(f"'{declared.name}' is an array of shape {expected} or {len(declared.value)} numbers, "
                         f"found an array of shape {array.shape}")
    return (array.swapaxes(-1, -2) if len(one) == 2 else array).ravel().tolist()


class Scene:
    """A loaded scene. Its values are attributes: ``scene.uShininess = 20``, ``scene.uColor = 1, 0, 0``,
    ``scene.method = "linear"``. Names that are no Python names, or are those of methods: ``scene["lights[0].color"] = ...``.
    """

    def __init__(self, path=None, *, text=None, name="scene.glib", files=None):
        """Reads a scene file, or with ``text`` a scene in memory; ``files`` are the contents of the files
        that it reads, by their names, as texts or bytes."""
        if (path is None) == (text is None):
            raise TypeError("Scene takes a path or a text")
        made = (_renderer().load(os.fspath(path)) if text is None
                else _renderer().load_text(text, name, dict(files or {})))
        object.__setattr__(self, "_scene", made)
        object.__setattr__(self, "_names", {each.name for each in made.values()})

    def draw(self, width=0, height=0, *, time=0.0, samples=0, alpha=False, dtype="uint8"):
        """The picture at a time in seconds: an array of height x width x 3 (4 with ``alpha``) numbers, top row first; uint8,
        or float32, which is not limited to 0..1. A size of 0 is the scene's."""
        kind = numpy.dtype(dtype)
        if kind not in (numpy.dtype("uint8"), numpy.dtype("float32")):
            raise ValueError("dtype is uint8 or float32")
        return self._scene.draw(width, height, time, samples, alpha, kind == numpy.dtype("float32"))

    @property
    def values(self):
        """All values that can be set, in the order of the scene, with types and ranges."""
        return self._scene.values()

    def _declared(self, name):
        """The value "uKd", of the first program that has it, or "Glaze.uKd"; None if there is none."""
        name = re.sub(r"^\d+:", "", name).replace(":", ".")  # 12:uKd is that of the program in line 12
        for each in self._scene.values():
            if name in (each.name, f"{each.program}.{each.name}"):
                return each
        return None

    def __getitem__(self, name):
        found = self._declared(name)
        if found is None:
            raise KeyError(name)
        if found.words:
            return found.words[int(found.value[0])]
        if found.type == "bool" and len(found.value) == 1:
            return found.value[0] != 0
        return found.value[0] if len(found.value) == 1 else tuple(found.value)

    def __setitem__(self, name, value):
        if isinstance(value, str):
            self._scene.set(name, value)
        elif isinstance(value, numbers.Number):  # bool too
            self._scene.set_numbers(name, [float(value)])
        else:
            array = numpy.asarray(value, dtype=float)
            declared = self._declared(name)
            # An unknown name is reported by set_numbers.
            self._scene.set_numbers(name, _numbers_of(array, declared) if declared else array.ravel().tolist())

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"the scene has no value '{name}'") from None

    def __setattr__(self, name, value):
        if name.startswith("_") or hasattr(type(self), name):
            object.__setattr__(self, name, value)
        else:
            self[name] = value

    def __dir__(self):
        return sorted(set(super().__dir__()) | {each for each in self._names if each.isidentifier()})

    def buffer(self, name):
        """The content of a buffer after the last picture: a structured array with a record for each element."""
        return self._scene.buffer(name)

    def target(self, name="window"):
        """A texture or a part of one after the last picture, as "shadow" or "glow.level(2)"; "window" is the picture in
        floats."""
        return self._scene.target(name)

    def check(self, time=0.0):
        """The messages of the Expect statements that do not hold; an empty list if all do."""
        return self._scene.check(time)

    def reload(self):
        """Reads the files again. Values that were set stay."""
        self._scene.reload()

    @property
    def diagnostics(self):
        """What was reported when the scene was read."""
        return self._scene.diagnostics()

    @property
    def files(self):
        return self._scene.files()

    @property
    def stats(self):
        return self._scene.stats()

    def __repr__(self):
        return f"<glibra.Scene {self.files[0]}>"

    def _repr_png_(self):
        return _png_of(self.draw())

    def interact(self, width=0, height=0):
        """In a notebook: the picture with a slider for every value that has a range (needs ipywidgets)."""
        import ipywidgets
        controls = {"time": ipywidgets.FloatSlider(min=0, max=10, step=.05, description="time")}
        for each in self.values:
            if each.words:
                controls[each.name] = ipywidgets.Dropdown(options=each.words, value=each.words[int(each.value[0])],
                                                          description=each.name)
            elif each.type == "bool":
                controls[each.name] = ipywidgets.Checkbox(value=each.value[0] != 0, description=each.name)
            elif each.range and len(each.value) == 1:
                low, high = each.range
                controls[each.name] = ipywidgets.FloatSlider(value=each.value[0], min=low, max=high, step=(high - low) / 200,
                                                             description=each.name)

        picture = ipywidgets.Image(format="png")

        def redraw(_=None):
            for name, control in controls.items():
                if name != "time":
                    self[name] = control.value
            picture.value = _png_of(self.draw(width, height, time=controls["time"].value))

        for control in controls.values():
            control.observe(redraw, names="value")
        redraw()
        return ipywidgets.HBox([picture, ipywidgets.VBox(list(controls.values()))])

    def film(self, seconds=4.0, *, rate=25, width=0, height=0):
        """In a notebook: a film of the scene (needs ffmpeg). Returns an object that shows itself as a video."""
        first = self.draw(width, height)
        rows, columns = first.shape[0] // 2 * 2, first.shape[1] // 2 * 2  # what the codec takes
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "film.mp4")
            command = ["ffmpeg", "-v", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{columns}x{rows}", "-r",
                       str(rate), "-i", "-", "-pix_fmt", "yuv420p", "-movflags", "faststart", file]
            writer = subprocess.Popen(command, stdin=subprocess.PIPE)
            for frame in range(round(seconds * rate)):
                picture = self.draw(width, height, time=frame / rate)
                writer.stdin.write(picture[:rows, :columns].tobytes())
            writer.stdin.close()
            if writer.wait() != 0:
                raise RuntimeError("ffmpeg cannot write the film")
            with open(file, "rb") as film:
                return _Film(film.read())


class _Film:
    def __init__(self, mp4):
        self.mp4 = mp4

    def _repr_html_(self):
        return f'<video controls loop src="data:video/mp4;base64,{base64.b64encode(self.mp4).decode()}"></video>'
