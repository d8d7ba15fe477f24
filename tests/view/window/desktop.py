"""A virtual display with a window manager, and a glibra window on it. Tests drive the window as a user does, with the
mouse and the keyboard, and check the screen and the state that `--state` writes."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import time

PAUSE = 0.02
SETTINGS = '{"folds": {"transforms": true, "shown": true, "toolWindows": true, "time": true}}'  # the sections that are open in tests
HANGING = 60  # seconds after which a window counts as hanging; not a measurement


class Desktop:
    """Xvfb and openbox; close() ends both."""

    def __init__(self, width=1400, height=1100, dpi=96):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{width}x{height}x24", "-noreset", "-nolisten", "tcp"],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as answer:
            self.name = ":" + answer.readline().strip()
        self.environment = dict(os.environ, DISPLAY=self.name)
        # The density of the screen, where desktops store it.
        subprocess.run(["xprop", "-root", "-f", "RESOURCE_MANAGER", "8s", "-set", "RESOURCE_MANAGER", f"Xft.dpi: {dpi}"],
                       env=self.environment, check=True)
        self.manager = subprocess.Popen(["openbox"], env=self.environment, stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL)
        self.await_manager()

    def await_manager(self):
        """A window asks once, when it starts, what the window manager can do: full screen, the sizes of frames."""
        end = time.monotonic() + HANGING
        while "window id" not in subprocess.run(["xprop", "-root", "_NET_SUPPORTING_WM_CHECK"], env=self.environment, text=True,
                                                stdout=subprocess.PIPE).stdout:
            if time.monotonic() > end:
                raise AssertionError("the window manager has not started")
            time.sleep(PAUSE)

    def close(self):
        for each in (self.manager, self.server):
            each.terminate()
            each.wait()


class Window:
    """`glibra view SCENE ARGUMENTS...` with its own folder for settings, pictures and state. `scene` may be None. `settings`: a
    folder that several windows share; without one, the sections that tests look at are open."""

    def __init__(self, desktop, program, scene, *arguments, settings=None, variables=None):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="glibra-window-"))
        self.state_file = self.folder / "state.json"
        self.settings = settings or self.folder
        if not settings:
            (self.folder / "glibra").mkdir()
            (self.folder / "glibra/view.json").write_text(SETTINGS)
        self.environment = dict(desktop.environment, XDG_CONFIG_HOME=str(self.settings),
                                **{"XDG_CACHE_HOME": str(self.folder / "cache"),
                                   "XDG_STATE_HOME": str(self.settings / "state"), **(variables or {})})
        self.process = subprocess.Popen(
            [program, "view", *([str(scene)] if scene else []), "--state", str(self.state_file), *arguments],
            env=self.environment, stderr=subprocess.PIPE, text=True)
        self.wait(lambda s: s["framesPresented"] >= 3 or s["moving"])
        self.id = self.xdotool("search", "--sync", "--onlyvisible", "--pid", str(self.process.pid)).split()[-1]
        self.xdotool("windowfocus", "--sync", self.id)

    def close(self):
        if self.process.poll() is None:
            self.process.terminate()
        self.process.wait()
        self.process.stderr.close()
        shutil.rmtree(self.folder, ignore_errors=True)

    def xdotool(self, *arguments):
        return subprocess.run(["xdotool", *arguments], env=self.environment, check=True, text=True,
                              stdout=subprocess.PIPE).stdout

    # What the window reports.

    def state(self):
        try:
            text = self.state_file.read_text()
        except FileNotFoundError:
            return None
        if "WINEPREFIX" in os.environ:  # whose drive Z: is the root folder
            text = re.sub(r"Z:(/|\\\\)[^'\"]*", lambda path: path[0][2:].replace("\\\\", "/"), text)
        return json.loads(text)

    def wait(self, holds):
        """Waits for a state for which `holds` is true, and returns it. Fails with the last state after HANGING seconds."""
        end = time.monotonic() + HANGING
        while True:
            if time.monotonic() > end:
                shown = {k: v for k, v in (self.state() or {}).items() if k != "widgets"}
                raise AssertionError(f"the expected state did not come; the last one is {shown}")
            if self.process.poll() is not None:
                raise AssertionError("the window has ended: " + self.process.stderr.read())
            state = self.state()
            for each in (state or {}).get("messages", []):
                if each["id"].startswith("gpu"):
                    raise AssertionError("OpenGL error: " + each["text"])
            if state and holds(state):
                return state
            time.sleep(PAUSE)

    def settle(self):
        """Waits until the window has handled all input and waits for events. Returns the state."""
        before = None
        while True:
            state = self.wait(lambda s: s["waiting"] or s["moving"])
            if before == (state["framesPresented"], state["knobs"], state["view"]) or state["moving"]:
                return state
            before = (state["framesPresented"], state["knobs"], state["view"])
            time.sleep(6 * PAUSE)

    def knob(self, tag):
        return next(each for each in self.state()["knobs"] if each["tag"] == tag)["current"]

    def wait_knob(self, tag, holds):
        return self.wait(lambda s: any(k["tag"] == tag and holds(k["current"]) for k in s["knobs"]))

    # What a user does. Positions are relative to the window's content.

    def is_whole(self, widget):
        """True if the widget is on the screen, and not cut off at the lower edge of the window or below the status line."""
        state = self.state() or {}
        widgets = state.get("widgets", {})
        if widget not in widgets:
            return False
        left, top, width, height = widgets[widget]
        end = state["window"][1]
        if "notice" in widgets and not widget.startswith("notice"):
            begin, line, wide, _ = widgets["notice"]
            if left < begin + wide and begin < left + width:
                end = min(end, line)
        return top >= 0 and top + height <= end

    def scroll_to(self, widget):
        """Scrolls the panel until the widget is on the screen, if it has any."""
        end = time.monotonic() + 1.5
        while not self.is_whole(widget) and time.monotonic() < end:
            time.sleep(PAUSE)
        state = self.state() or {}
        if self.is_whole(widget) or "room" not in state or state["question"]:
            return
        panel = state["room"][0] + state["room"][2] + 40
        if panel >= state["window"][0]:
            return
        self.move(panel, state["window"][1] * 0.7)
        for button in ("5", "4"):
            for _ in range(20):
                self.xdotool("click", button)
                time.sleep(6 * PAUSE)
                if self.is_whole(widget):
                    self.settle()
                    return

    def point(self, widget, across=0.5, down=0.5):
        self.scroll_to(widget)
        x, y, width, height = self.wait(lambda s: widget in s["widgets"])["widgets"][widget]
        return x + width * across, y + height * down

    def move(self, x, y):
        self.xdotool("mousemove", "--window", self.id, str(round(x)), str(round(y)))
        time.sleep(2 * PAUSE)

    def press(self, button=1):
        self.xdotool("mousedown", str(button))
        time.sleep(3 * PAUSE)

    def release(self, button=1):
        self.xdotool("mouseup", str(button))
        time.sleep(3 * PAUSE)

    def click(self, widget, across=0.5):
        self.move(*self.point(widget, across))
        self.press()
        self.release()

    def double_click(self, widget):
        self.move(*self.point(widget))
        self.xdotool("click", "--repeat", "2", "--delay", "60", "1")
        time.sleep(4 * PAUSE)

    def drag(self, start, end, button=1):
        self.move(*start)
        self.press(button)
        for step in range(1, 6):
            self.move(start[0] + (end[0] - start[0]) * step / 5, start[1] + (end[1] - start[1]) * step / 5)
        self.release(button)

    def drag_widget(self, widget, begin, end):
        self.drag(self.point(widget, begin), self.point(widget, end))

    def key(self, *keys):
        self.xdotool("key", "--delay", "40", *keys)
        time.sleep(3 * PAUSE)

    def type(self, text):
        self.xdotool("type", "--delay", "40", "--", text)
        time.sleep(3 * PAUSE)

    def drop(self, *files):
        """Drops files (paths or URIs) on the window, as a file manager does. Returns when the window has them."""
        uris = [each if "://" in str(each) else pathlib.Path(each).as_uri() for each in files]
        subprocess.run([os.environ["GLIBRA_DROP"], self.id, *uris], env=self.environment, check=True)

    def keydown(self, key):
        self.xdotool("keydown", key)
        time.sleep(3 * PAUSE)

    def keyup(self, key):
        self.xdotool("keyup", key)
        time.sleep(3 * PAUSE)

    def position(self):
        """Left and top of the window's content on the screen. (xdotool counts the window's frame twice.)"""
        text = subprocess.run(["xwininfo", "-id", self.id], env=self.environment, check=True, text=True,
                              stdout=subprocess.PIPE).stdout
        return [int(re.search(rf"Absolute upper-left {each}: +(-?\d+)", text)[1]) for each in "XY"]

    def resize(self, width, height):
        self.xdotool("windowsize", "--sync", self.id, str(width), str(height))

    # What a user sees.

    def screenshot(self, file):
        subprocess.run(["import", "-window", self.id, str(file)], env=self.environment, check=True)

    def pixels(self):
        """Width, height and RGB bytes of the picture on the screen."""
        state = self.settle()
        left, top, _, _ = state["picture"]
        width, height = state["width"], state["height"]
        ppm = subprocess.run(
            ["import", "-window", self.id, "-crop", f"{width}x{height}+{round(left)}+{round(top)}", "+repage",
             "-depth", "8", "ppm:-"], env=self.environment, check=True, stdout=subprocess.PIPE).stdout
        return read_ppm(ppm)


def read_ppm(data):
    fields = data.split(None, 3)
    width, height = int(fields[1]), int(fields[2])
    return width, height, data[len(data) - 3 * width * height:]


def rendered(program, scene, width, height, *arguments):
    """The picture that `glibra render` makes: width, height and RGB bytes."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "picture.ppm"
        subprocess.run([program, "render", str(scene), "-o", str(file.with_suffix(".png")), "--size",
                        f"{width}x{height}", *arguments], check=True, stderr=subprocess.DEVNULL)
        ppm = subprocess.run(["convert", str(file.with_suffix(".png")), "-depth", "8", "ppm:-"], check=True,
                             stdout=subprocess.PIPE).stdout
        return read_ppm(ppm)
