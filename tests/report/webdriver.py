"""A Chromium without a window, driven by the W3C WebDriver protocol through chromedriver; standard library only."""
import base64
import http.client
import json
import os
import shutil
import subprocess
import tempfile
import time

ELEMENT = "element-6066-11e4-a52e-4f735466cecf"
KEYS = {"Escape": "\ue00c", "Enter": "\ue007", "Tab": "\ue004", "End": "\ue010", "Home": "\ue011", "Right": "\ue014", "F1": "\ue031",
        "F2": "\ue032", "Control": "\ue009", "Shift": "\ue008"}


class Browser:
    """One window. Leaves nothing behind when its `with` ends. `gl`: pages get WebGL 2, by Chromium's own rasteriser, or, if it
    is "mesa", by that of this machine, with the settings that glibra draws with."""

    def __init__(self, width=1400, height=900, gl=False):
        self.size = (width, height)
        self.patience = 300  # seconds, for an answer
        self.gl = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"] if gl else ["--disable-gpu"]
        self.environment = None
        if gl == "mesa":
            self.gl = ["--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist"]
            self.environment = {**os.environ, "GALLIVM_PERF": "no_aos_sampling"}

    def __enter__(self):
        try:
            return self.start()
        except BaseException:
            self.stop()
            raise

    def start(self):
        self.session = None
        self.profile = tempfile.mkdtemp(prefix="glibra-browser-")
        # Port 0 lets the system choose; chromedriver prints which it is.
        self.driver = subprocess.Popen(["chromedriver", "--port=0", "--allowed-ips=127.0.0.1"], stdout=subprocess.PIPE,
                                       stderr=subprocess.STDOUT, text=True, env=self.environment)
        self.port = None
        for line in self.driver.stdout:
            if "started successfully on port" in line:
                self.port = int(line.rstrip().rstrip(".").rsplit(" ", 1)[1])
                break
        if self.port is None:
            raise RuntimeError("chromedriver did not start")
        options = {
            "binary": shutil.which("chromium"),
            "args": ["--headless=new", "--no-sandbox", "--disable-quic", "--no-first-run", *self.gl,
                     "--remote-debugging-pipe",  # needs no name of this machine
                     "--disable-background-networking", "--disable-component-update", "--disable-sync",
                     "--disable-dev-shm-usage", "--force-device-scale-factor=1",
                     "--user-data-dir=" + os.path.join(self.profile, "profile"),
                     "--window-size=%d,%d" % self.size],
        }
        answer = self.ask("POST", "/session", {"capabilities": {"alwaysMatch": {
            "browserName": "chrome", "goog:chromeOptions": options,
            "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"}}}})
        self.session = "/session/" + answer["sessionId"]
        return self

    def __exit__(self, *_):
        try:
            if self.session:
                self.ask("DELETE", self.session)
        finally:
            self.stop()

    def stop(self):
        self.driver.terminate()
        self.driver.wait()
        self.driver.stdout.close()
        shutil.rmtree(self.profile, ignore_errors=True)

    def ask(self, method, path, body=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=self.patience)
        connection.request(method, path, None if body is None else json.dumps(body),
                           {"Content-Type": "application/json"})
        answer = json.load(connection.getresponse())["value"]
        connection.close()
        if isinstance(answer, dict) and "error" in answer and "message" in answer:  # not a script's own answer
            raise RuntimeError(answer["error"] + ": " + answer["message"])
        return answer

    def open(self, url):
        self.ask("POST", self.session + "/url", {"url": url})

    def run(self, script, *arguments):
        """What the body of a JavaScript function returns."""
        return self.ask("POST", self.session + "/execute/sync", {"script": script, "args": list(arguments)})

    def wait(self, script, *arguments):
        """Waits until the script gives something true, and returns it. What never comes is named before ctest ends the test."""
        end = time.monotonic() + self.patience / 3
        while time.monotonic() < end:
            value = self.run(script, *arguments)
            if value:
                return value
            time.sleep(0.02)
        raise TimeoutError("not in %d s: %s %s; the page says: %s"
                           % (self.patience / 3, script, arguments, self.run("return JSON.stringify(document.body.dataset)")))

    def element(self, selector):
        return self.ask("POST", self.session + "/element", {"using": "css selector", "value": selector})[ELEMENT]

    def elements(self, selector):
        found = self.ask("POST", self.session + "/elements", {"using": "css selector", "value": selector})
        return [each[ELEMENT] for each in found]

    def click(self, selector):
        self.ask("POST", self.session + "/element/" + self.element(selector) + "/click", {})

    def press(self, *keys):
        actions = []
        for key in keys:
            value = KEYS.get(key, key)
            actions += [{"type": "keyDown", "value": value}, {"type": "keyUp", "value": value}]
        self.ask("POST", self.session + "/actions", {"actions": [{"type": "key", "id": "keys", "actions": actions}]})

    def chord(self, *keys):
        """Keys that are down together, as Control and s."""
        values = [KEYS.get(key, key) for key in keys]
        actions = [{"type": "keyDown", "value": each} for each in values] + [{"type": "keyUp", "value": each} for each in values[::-1]]
        self.ask("POST", self.session + "/actions", {"actions": [{"type": "key", "id": "keys", "actions": actions}]})

    def frame(self, element=None):
        """Scripts and elements are those of this frame of the present one, or of the whole page."""
        self.ask("POST", self.session + "/frame", {"id": element and {ELEMENT: element}})

    def pointer(self, *steps):
        """Steps: ("move", x, y) in CSS pixels of the window, "down", "up"."""
        actions = []
        for step in steps:
            if step == "down" or step == "up":
                actions.append({"type": "pointerDown" if step == "down" else "pointerUp", "button": 0})
            else:
                actions.append({"type": "pointerMove", "duration": 0, "x": round(step[1]), "y": round(step[2])})
        self.ask("POST", self.session + "/actions", {"actions": [
            {"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": actions}]})

    def wheel(self, x, y, delta):
        self.ask("POST", self.session + "/actions", {"actions": [{"type": "wheel", "id": "wheel", "actions": [
            {"type": "scroll", "x": round(x), "y": round(y), "deltaX": 0, "deltaY": delta, "duration": 0}]}]})

    def command(self, name, **parameters):
        """A command of the DevTools protocol."""
        return self.ask("POST", self.session + "/goog/cdp/execute", {"cmd": name, "params": parameters})

    def logs(self, kind):
        return self.ask("POST", self.session + "/se/log", {"type": kind})

    def requests(self):
        """The URLs that pages have asked for since the last call; not those of the browser's own pages, which may load late."""
        messages = [json.loads(each["message"])["message"] for each in self.logs("performance")]
        urls = [each["params"]["request"]["url"] for each in messages if each["method"] == "Network.requestWillBeSent"]
        return [url for url in urls if not url.startswith("chrome:")]

    @staticmethod
    def foreign(urls):
        """Those that lead out of this machine."""
        return [url for url in urls if not url.startswith(("file:///", "data:", "blob:", "about:"))]

    def screenshot(self, path=None, selector=None):
        where = "/element/" + self.element(selector) if selector else ""
        picture = base64.b64decode(self.ask("GET", self.session + where + "/screenshot"))
        if path:
            with open(path, "wb") as file:
                file.write(picture)
        return picture
