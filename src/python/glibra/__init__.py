"""Renders GLIB shader scenes to NumPy arrays.

    import glibra
    scene = glibra.Scene("teapot.glib")
    scene.uShininess = 20
    picture = scene.draw(320, 240, time=2.5)      # numpy uint8, (240, 320, 3)

A scene belongs to the thread that made it, and to its process: a process that is forked after a scene was loaded cannot draw.
"""
import base64
import math
import operator
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import threading
import warnings as _warnings

import numpy

from . import _core
from ._core import Comparison, Diagnostic, Value, __version__

__all__ = ["Comparison", "Diagnostic", "Scene", "SceneError", "Value", "compare", "render", "save", "__version__"]


class SceneError(RuntimeError):
    """What prevented a picture; ``diagnostics`` are the single messages. ``id``, ``file``, ``line`` and ``column`` are those of the
    first error."""

    def __init__(self, message="", diagnostics=()):
        super().__init__(message)
        self.diagnostics = list(diagnostics)
        first = next((each for each in self.diagnostics if each.severity == "error"), None)
        self.id, self.file = (first.id, first.file) if first else ("", "")
        self.line, self.column = (first.line, first.column) if first else (0, 0)

    def __reduce__(self):
        return type(self), (str(self), self.diagnostics)


for _public in SceneError, Comparison, Diagnostic, Value:
    _public.__module__ = __name__
_core.use_error(SceneError)

_thread = threading.local()
_windows = []  # processes of view() that nobody waits for, and the folders of what they show


def _renderer(current=False):
    """The renderer of this thread, which its scenes share; with ``current`` one in the context that is current on it."""
    if current:
        return _core.Renderer.current()
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
    """Writes an array as a picture file: .png, .exr, .jpg and others, by the name. Whole numbers with a sign or of 32 bits
    become floats, in .exr and .pfm."""
    _core.save(numpy.asarray(picture), os.fspath(file))


def compare(got, expected, *, largest=3.0, fraction=0.0003, cluster=8, line=16, bias=1.0, flip=None, structure=None,
            relative=1e-4, absolute=1e-6, exact=False):
    """Compares two pictures, arrays or names of files, as golden-image tests do. The result is true if they are the same
    within the tolerance; `reason` says which figure decided. ``relative`` and ``absolute`` are for float pictures, in place
    of ``largest``; whole numbers with a sign or of 32 bits may differ by ``absolute`` alone."""
    as_picture = lambda one: one if isinstance(one, numpy.ndarray) else os.fspath(one)
    found = _core.compare(as_picture(got), as_picture(expected), largest, fraction, cluster, line, bias, flip, structure,
                          relative, absolute, exact)
    for each in found.diagnostics:  # other programs may show another picture of a file
        _warnings.warn(str(each), stacklevel=2)
    arrays = [each for each in (got, expected) if isinstance(each, numpy.ndarray) and each.dtype.kind == "f"]
    if exact and found and len(arrays) == 2 and got.shape == expected.shape:
        if not numpy.array_equal(got, expected, equal_nan=True):
            raise ValueError("exact: the arrays differ in numbers that 32-bit floats, as pictures have, do not tell apart")
    return found


def _float(number):
    """A number as a float: infinite, which no value takes, if it is a whole number beyond all floats."""
    try:
        return float(number)
    except OverflowError:
        return math.inf if number > 0 else -math.inf


def _array_of(value, name):
    """The numbers of a value as an array of floats; a single number has no dimension."""
    array = numpy.asarray(value)
    try:
        if array.dtype == object:
            return numpy.array([_float(each) for each in array.flat], dtype=float).reshape(array.shape)
        if array.dtype.kind in "biuf":
            return array.astype(float)
    except TypeError:
        pass
    raise TypeError(f"'{name}' takes a number, a text, a sequence or an array of numbers, found {value!r}")


def _content_of(file, content):
    """The content of a file in memory, as a text or bytes."""
    if isinstance(content, (str, bytes)):
        return content
    if isinstance(content, os.PathLike):
        with open(content, "rb") as other:
            return other.read()
    try:
        return bytes(memoryview(content))
    except TypeError:
        raise TypeError(f"the content of '{file}' is a text, bytes or a path, found {type(content).__name__}") from None


def _shape_of(type):
    """The shape of a GLSL type as NumPy has it: () for a scalar, (3,) for vec3, rows and columns for a matrix."""
    matrix = re.fullmatch(r"d?mat(\d)(?:x(\d))?", type)
    if matrix:
        return int(matrix[2] or matrix[1]), int(matrix[1])  # GLSL names the columns first
    vector = re.fullmatch(r"[bdiu]?vec(\d)", type)
    return (int(vector[1]),) if vector else ()


def _numbers_of(array, declared, element):
    """The numbers of an array in the order of OpenGL: one element after the other, matrices by columns. A flat array has
    this order already. ``element``: the value is that of one element."""
    if array.ndim < 2:
        return array.ravel().tolist()
    one = _shape_of(declared.type)
    whole = (1 if element is not None else len(declared.value) // math.prod(one), *one)
    if array.shape != whole and (1, *array.shape) != whole:
        expected = whole[1:] if whole[0] == 1 and one else whole
        raise ValueError(f"'{declared.name}' is an array of shape {expected} or {math.prod(whole)} numbers, "
                         f"found an array of shape {array.shape}")
    return (array.swapaxes(-1, -2) if len(one) == 2 else array).ravel().tolist()


def _subscripted(name):
    """The name and the number of "uColors[1]"; a name that no value has without a subscript."""
    found = re.fullmatch(r"(.+)\[(\d+)\]", name)
    return (found[1], int(found[2])) if found else (None, None)


def _has(value, element):
    return element is None or (element + 1) * math.prod(_shape_of(value.type)) <= len(value.value)


def _control_of(value, label, widgets):
    """The widget that shows a value as it is; None if it has none. A slider reaches to a value outside of its range."""
    if len(value.value) != 1:
        return None
    now = value.value[0]
    if value.words:
        return widgets.Dropdown(options=value.words, value=value.words[int(now)], description=label)
    if value.type == "bool":
        return widgets.Checkbox(value=now != 0, description=label)
    if value.range is None:
        return None
    low, high = min(value.range[0], now), max(value.range[1], now)
    if value.type in ("int", "uint"):
        low, high = math.ceil(low), math.floor(high)
        return widgets.IntSlider(value=int(now), min=low, max=high, step=max(1, round((high - low) / 200)), description=label)
    return widgets.FloatSlider(value=now, min=low, max=high, step=(high - low) / 200 or 1, description=label)


def _is_float(dtype):
    kind = numpy.dtype(dtype)
    if kind not in (numpy.dtype("uint8"), numpy.dtype("float32")):
        raise ValueError("dtype is uint8 or float32")
    return kind == numpy.dtype("float32")


def _columns_of(eye):
    """A matrix as OpenGL has it."""
    turned = numpy.identity(4) if eye is None else numpy.asarray(eye, dtype=float)
    if turned.shape != (4, 4):
        raise ValueError(f"eye is a matrix of shape (4, 4), found {turned.shape}")
    return turned.T.ravel().tolist()


def _setting_of(name, value):
    """NAME=VALUE, as the command line has it."""
    if isinstance(value, str):
        return f"{name}={value}"
    array = _array_of(value, name)
    if array.ndim > 1:  # rows of a matrix and elements of an array look the same, and the type is not known yet
        raise ValueError(f"'{name}' takes its numbers in one row, a matrix by columns, found an array of shape {array.shape}; "
                         "a Scene takes arrays of any shape")
    return f"{name}={','.join(f'{each:.17g}' for each in array.ravel())}"


def render(path, width=0, height=0, *, time=0.0, samples=0, alpha=False, dtype="uint8", eye=None, axes=False, max_error=0.0,
           override_counts=False, set=None, within="", library=(), strict=False):
    """Reads a scene file and draws one picture, an array as of `Scene.draw`. With ``max_error``, the counts, samples and noise
    sizes that the scene leaves open are chosen so that nothing is drawn more than so many pixels from its place; with
    ``override_counts``, so are those that it states. ``set`` gives values by their names. Warnings of the scene are Python's
    warnings. To draw a scene more than once, load it as a `Scene`."""
    options = {"width": width, "height": height, "time": time, "samples": samples, "alpha": alpha, "floats": _is_float(dtype),
               "eye": _columns_of(eye), "axes": axes, "max_error": max_error, "override_counts": override_counts,
               "set": [_setting_of(name, value) for name, value in (set or {}).items()], **_places(within, library, strict)}
    picture, remarks = _renderer().render(os.fspath(path), options)
    for each in remarks:
        if each.severity == "warning":
            _warnings.warn(str(each), stacklevel=2)
    return picture


def _places(within, library, strict):
    return {"within": os.fspath(within), "library": [os.fspath(each) for each in library], "strict": strict}


class Scene:
    """A loaded scene. Its values are attributes: ``scene.uShininess = 20``, ``scene.uColor = 1, 0, 0``,
    ``scene.method = "linear"``. Names that are no Python names, or are those of methods: ``scene["lights[0].color"] = ...``.
    """

    def __init__(self, path=None, *, text=None, name="scene.glib", files=None, within="", library=(), strict=False, current=False):
        """Reads a scene file, or with ``text`` a scene in memory; ``files`` are then the contents of the files that it reads,
        by their names, as texts, bytes, or paths of files that have it. With ``within``, it may read only files below that folder and the ``library``
        folders, which are searched besides its own. With ``strict``, warnings are errors. With ``current``, it draws in the
        OpenGL context that is current on this thread, which must be current in all later calls."""
        if (path is None) == (text is None):
            raise TypeError("Scene takes a path or a text")
        if text is None and files:
            raise TypeError("files are those of a text; a scene of a path reads its own")
        options = _places(within, library, strict)
        contents = {os.fspath(file): _content_of(file, content) for file, content in (files or {}).items()}
        renderer = _renderer(current)
        made = (renderer.load(os.fspath(path), options) if text is None
                else renderer.load_text(text, os.fspath(name), contents, options))
        object.__setattr__(self, "_memory", None if text is None else {os.fspath(name): text, **{
            os.path.join(os.path.dirname(os.fspath(name)), file): content for file, content in contents.items()}})
        object.__setattr__(self, "_scene", made)
        object.__setattr__(self, "_names", {each.name for each in made.values()})
        object.__setattr__(self, "_warnings", [])

    def draw(self, width=0, height=0, *, time=0.0, samples=0, alpha=False, dtype="uint8", eye=None, axes=False):
        """The picture at a time in seconds: an array of height x width x 3 (4 with ``alpha``) numbers, top row first; uint8,
        or float32, which is not limited to 0..1. A size of 0 is the scene's. ``eye`` moves the camera: a 4 x 4 matrix, rows
        first, that is multiplied from the left to the scene's model-view matrices. ``axes`` draws those of world space. Ctrl-C
        ends it when the picture is complete, as KeyboardInterrupt."""
        picture, warnings = self._scene.draw(width, height, time, samples, alpha, _is_float(dtype), _columns_of(eye), axes)
        object.__setattr__(self, "_warnings", warnings)
        return picture

    def draw_into(self, framebuffer=0, *, texture=0, x=0, y=0, width=0, height=0, time=0.0, samples=0, alpha=False, eye=None,
                  axes=False):
        """Draws the picture into a framebuffer of the program's own context, by its OpenGL name (0: the window's), or into
        level 0 of a 2D texture, with (x, y) as its lower left pixel, and reads nothing back. The scene was loaded with
        ``current``. A size of 0 is the texture's, else the scene's. Afterwards the state of OpenGL is the library's."""
        surface = [operator.index(each) for each in (framebuffer, texture, x, y, width, height)]
        object.__setattr__(self, "_warnings", self._scene.draw_into(
            surface, time, samples, alpha, _columns_of(eye), axes))

    def device_texture(self, name):
        """A texture after the last picture as OpenGL has it, for draws of the program's own in the same context or one that
        shares its objects: a dictionary of ``name``, ``target``, ``format``, ``size`` (width, height, depth) and ``levels``.
        The scene was loaded with ``current``."""
        return self._scene.device_texture(name)

    @property
    def warnings(self):
        """What was reported of the last picture: warnings and notes."""
        return self._warnings

    @property
    def values(self):
        """All values that can be set, in the order of the scene, with types and ranges."""
        return self._scene.values()

    def _declared(self, name):
        """The value "uKd", of the first program that has it, "Glaze.uKd", or "12:uKd", of the program in line 12, and None;
        for "uColors[1]" the number of the element. None if there is none."""
        values = self._scene.values()
        for plain, element in (name, None), _subscripted(name):
            for each in values:
                owners = "", f"{each.program}.", f"{each.program}:", f"{each.program_line}:"
                if plain in [owner + each.name for owner in owners] and _has(each, element):
                    return each, element
        return None, None

    def __contains__(self, name):
        return self._declared(name)[0] is not None

    def __iter__(self):
        """The names of its values."""
        return iter(dict.fromkeys(each.name for each in self._scene.values()))

    def __getitem__(self, name):
        found, element = self._declared(name)
        if found is None:
            raise KeyError(name)
        if found.words:
            return found.words[int(found.value[0])]
        size = math.prod(_shape_of(found.type))
        numbers = found.value if element is None else found.value[element * size:(element + 1) * size]
        if found.type == "bool" and len(numbers) == 1:
            return numbers[0] != 0
        return numbers[0] if len(numbers) == 1 else tuple(numbers)

    def __setitem__(self, name, value):
        if isinstance(value, str):
            return self._scene.set(name, value)
        array = _array_of(value, name)
        declared, element = self._declared(name) if array.ndim > 1 else (None, None)
        # An unknown name is reported by set_numbers.
        numbers = _numbers_of(array, declared, element) if declared else array.ravel().tolist()
        self._scene.set_numbers(name, numbers)

    def __getattr__(self, name):
        # Without "_names" this is an object that is being copied.
        if name.startswith("_") and name not in self.__dict__.get("_names", ()):
            raise AttributeError(name)
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"the scene has no value '{name}'") from None

    def __setattr__(self, name, value):
        if hasattr(Scene, name) or name in self.__dict__:
            raise AttributeError(f"'{name}' is what glibra.Scene has itself; a value of that name is scene[{name!r}]")
        if hasattr(type(self), name):  # of a class that is derived from this one
            object.__setattr__(self, name, value)
        else:
            self[name] = value

    def __dir__(self):
        return sorted(set(super().__dir__()) | {each for each in self._names if each.isidentifier()})

    def buffer(self, name, *, head=False):
        """The content of a buffer after the last picture: a structured array with a record for each element. A matrix is its
        numbers by columns. With ``head``, one record of the members before the array, which is also what a buffer without an
        array has."""
        return self._scene.buffer(name, head)

    def target(self, name="window"):
        """A texture or a part of one after the last picture, as "shadow" or "glow.level(2)": rows x columns x components of
        its format, integers as the integers of its bits. "window" is the picture in floats."""
        return self._scene.target(name)

    def write(self, name, data, *, first=None, head=False):
        """Replaces the content of a texture or buffer for the pictures that follow, until the scene is read again. A texture
        takes what `target` gives, in the shape and type of its format; a volume is depth x height x width, with the texel (0, 0,
        0) first. A buffer takes what `buffer` gives, or an array of elements x numbers. With ``first``, the array replaces
        elements from that one on; with ``head``, one record the members before the array. Another name, type or shape raises
        SceneError and changes nothing."""
        if first is not None and operator.index(first) < 0:
            raise ValueError(f"first counts elements from 0, found {first}")
        array = numpy.asarray(data)
        array = numpy.ascontiguousarray(array, dtype=array.dtype.newbyteorder("="))
        self._scene.write(name, array, first, head)

    def check(self, time=0.0):
        """The messages of the Expect statements that do not hold; an empty list if all do."""
        return self._scene.check(time)

    def reload(self):
        """Reads the files again. Values that were set stay."""
        self._scene.reload()
        object.__setattr__(self, "_names", {each.name for each in self._scene.values()})

    @property
    def diagnostics(self):
        """What was reported when the scene was read."""
        return self._scene.diagnostics()

    @property
    def files(self):
        """Every file that was read for it, the scene first."""
        return self._scene.files()

    @property
    def stats(self):
        """Counts of all pictures since loading, as "frames" and "draws"."""
        return self._scene.stats()

    def __repr__(self):
        return f"<glibra.Scene {self.files[0]}>"

    def _repr_png_(self):
        return _png_of(self.draw())

    def interact(self, width=0, height=0):
        """In a notebook: the picture with a slider for every value that has a range (needs ipywidgets). The scene changes when
        a slider is moved."""
        import ipywidgets
        time = ipywidgets.FloatSlider(min=0, max=10, step=.05, description="time")
        picture = ipywidgets.Image(format="png")
        controls = [time]

        def redraw(_=None):
            picture.value = _png_of(self.draw(width, height, time=time.value))

        def show(value, label):
            control = _control_of(value, label, ipywidgets)
            if control is None:
                return
            name = f"{value.program_line}:{value.name}" if value.program_line else value.name

            def change(change):
                self[name] = change["new"]
                redraw()

            control.observe(change, names="value")
            controls.append(control)

        time.observe(redraw, names="value")
        values = self.values
        names = [each.name for each in values]
        owned = [f"{each.program}.{each.name}" for each in values]
        for value, own in zip(values, owned):
            show(value, value.name if names.count(value.name) == 1 else own if owned.count(own) == 1
                 else f"{value.program_line}:{value.name}")
        redraw()
        return ipywidgets.HBox([picture, ipywidgets.VBox(controls)])

    def view(self, *, time=0.0, wait=True):
        """Opens the window on the scene with its present values, and waits until it is closed; otherwise returns the process.
        A scene in memory is shown from copies of its files, so that edits in the window end with it. Needs the program
        glibra."""
        program = os.environ.get("GLIBRA") or shutil.which("glibra")
        if program is None:
            raise RuntimeError("view() needs the program glibra, which is not in PATH")
        folder = tempfile.TemporaryDirectory(prefix="glibra-")
        arguments = [program, "view", self._copied_to(folder.name), "--time", f"{time:.17g}"]
        for each in self.values:
            if each.value != each.initial:
                name = f"{each.program_line}:{each.name}" if each.program_line else each.name
                arguments += ["--set", f"{name}={','.join(f'{number:.17g}' for number in each.value)}"]
        process = subprocess.Popen(arguments, stderr=subprocess.PIPE if wait else None, text=True)
        if not wait:
            _windows[:] = [each for each in _windows if each[0].poll() is None]
            _windows.append((process, folder))
            return process
        with folder:
            _, said = process.communicate()
        if process.returncode != 0:
            raise RuntimeError(said.strip() or f"the window ended with status {process.returncode}")

    def _copied_to(self, folder):
        """The path of the scene; one in memory is written below a folder with the files that it read beside itself."""
        if self._memory is None:
            return str(self.files[0])
        scene = next(iter(self._memory))
        home = os.path.dirname(os.path.abspath(scene))
        contents = {os.path.abspath(file): content for file, content in self._memory.items()}
        for file in map(os.path.abspath, map(str, self.files)):
            if file not in contents and os.path.isfile(file):
                contents[file] = _content_of(file, pathlib.Path(file))
        for file, content in contents.items():
            below = os.path.relpath(file, home)
            if below.startswith(os.pardir):
                continue
            copy = os.path.join(folder, below)
            os.makedirs(os.path.dirname(copy), exist_ok=True)
            with open(copy, "wb") as to:
                to.write(content.encode() if isinstance(content, str) else content)
        return os.path.join(folder, os.path.basename(scene))

    def film(self, seconds=4.0, *, rate=25, width=0, height=0):
        """In a notebook: a film of the scene (needs ffmpeg). Returns an object that shows itself as a video."""
        first = self.draw(width, height)
        rows, columns = first.shape[0] // 2 * 2, first.shape[1] // 2 * 2  # what the codec takes
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "film.mp4")
            command = ["ffmpeg", "-v", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{columns}x{rows}", "-r",
                       str(rate), "-i", "-", "-pix_fmt", "yuv420p", "-movflags", "faststart", file]
            try:
                writer = subprocess.Popen(command, stdin=subprocess.PIPE)
            except FileNotFoundError:
                raise RuntimeError("film() needs the program ffmpeg, which is not installed") from None
            try:
                for frame in range(round(seconds * rate)):
                    picture = self.draw(width, height, time=frame / rate)
                    writer.stdin.write(picture[:rows, :columns].tobytes())
                writer.stdin.close()
            except BrokenPipeError:
                pass  # it has ended, and says why
            if writer.wait() != 0:
                raise RuntimeError("ffmpeg cannot write the film")
            with open(file, "rb") as film:
                return _Film(film.read())


class _Film:
    def __init__(self, mp4):
        self.mp4 = mp4

    def _repr_html_(self):
        return f'<video controls loop src="data:video/mp4;base64,{base64.b64encode(self.mp4).decode()}"></video>'
