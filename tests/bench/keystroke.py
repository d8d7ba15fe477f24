#!/usr/bin/env python3
"""A keystroke in a scene with 2,000 lines of shaders: the language server's answers against one run of glslangValidator.

usage: tests/bench/keystroke.py [PROGRAM]      (needs: build/release/glibra, glslangValidator)

A letter is typed into the scene, and what an editor asks for then is asked for; the time counts from the letter to the answer.
Prints the median of each in milliseconds, and its ratio to the median of glslangValidator on the fragment shader alone, which
alternates with them. Nothing else should run.
"""
import json
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ROUNDS = 21
FUNCTION = """float f{0}(vec3 n, float r) {{
    float d = dot(n, vec3(r, {0}., 1.));
    for (int i = 0; i < 3; ++i) d += sin(d * r);
    return max(d, uScale);
}}
"""
FUNCTIONS = "".join(FUNCTION.format(i) for i in range(199))
VERTEX = ("#version 330\nout vec3 vNormal;\n" + FUNCTIONS.replace("uScale", "1.") + "void main() {\n    vNormal = aNormal;\n"
          "    gl_Position = uModelViewProjectionMatrix * aVertex;\n}\n")
FRAGMENT = ("#version 330\nuniform float uScale;\nin vec3 vNormal;\nout vec4 fColor;\n" + FUNCTIONS +
            "void main() {\n    float sum = 0.;\n    sum += f3(vNormal, uScale);\n    fColor = vec4(sum);\n}\n")
SCENE = f"Vertex inline\n{VERTEX}EndVertex\nFragment inline\n{FRAGMENT}EndFragment\nProgram P uScale <0 1 2>\nSphere\n"
LINE = SCENE[:SCENE.index("sum += f3")].count("\n")


class Client:
    """A client of the language server, over its standard streams."""

    def __init__(self, program, folder):
        self.process = subprocess.Popen([program, "language-server"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, cwd=folder)
        self.uri = (Path(folder) / "a.glib").as_uri()
        self.count = 0
        self.ask("initialize", {"capabilities": {}})
        self.send({"method": "textDocument/didOpen",
                   "params": {"textDocument": {"uri": self.uri, "languageId": "glib", "version": 1, "text": SCENE}}})
        while self.receive().get("method") != "textDocument/publishDiagnostics":
            pass

    def send(self, message):
        data = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n" % len(data) + data)
        self.process.stdin.flush()

    def receive(self):
        length = 0
        while line := self.process.stdout.readline().strip():
            length = int(line.split(b":")[1])
        return json.loads(self.process.stdout.read(length))

    def ask(self, method, params):
        self.count += 1
        self.send({"id": self.count, "method": method, "params": params})
        while (answer := self.receive()).get("id") != self.count:
            pass
        if "error" in answer:
            sys.exit(f"keystroke.py: {method}: {answer['error']['message']}")

    def type(self, text, end):
        """Replaces the letters from the fourth one on in the line."""
        place = {"start": {"line": LINE, "character": 4}, "end": {"line": LINE, "character": end}}
        self.send({"method": "textDocument/didChange",
                   "params": {"textDocument": {"uri": self.uri, "version": self.count},
                              "contentChanges": [{"range": place, "text": text}]}})


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "build/release/glibra")
    with tempfile.TemporaryDirectory() as folder:
        shader = Path(folder) / "a.frag"
        shader.write_text(FRAGMENT, encoding="utf-8")
        client = Client(program, folder)
        document = {"textDocument": {"uri": client.uri}}
        whole = {"start": {"line": 0, "character": 0}, "end": {"line": 9999, "character": 0}}
        asked = {"completion": {"position": {"line": LINE, "character": 5}},
                 "signatureHelp": {"position": {"line": LINE, "character": 18}},
                 "documentHighlight": {"position": {"line": LINE, "character": 13}},
                 "semanticTokens/full": {}, "foldingRange": {}, "documentSymbol": {}, "inlayHint": {"range": whole},
                 "documentColor": {}, "documentLink": {}}
        times = {name: [] for name in ("glslangValidator", *asked)}
        for _ in range(ROUNDS):
            begin = time.perf_counter()
            subprocess.run(["glslangValidator", "-S", "frag", shader], stdout=subprocess.DEVNULL, check=True)
            times["glslangValidator"].append(time.perf_counter() - begin)
            for name, more in asked.items():
                begin = time.perf_counter()
                client.type("s", 4)
                client.ask("textDocument/" + name, {**document, **more})
                times[name].append(time.perf_counter() - begin)
                client.type("", 5)
        client.process.stdin.close()
        client.process.wait()
    reference = statistics.median(times["glslangValidator"])
    for name, each in times.items():
        print(f"{name:<20} {1000 * statistics.median(each):6.1f} ms  {statistics.median(each) / reference:5.2f}")


if __name__ == "__main__":
    main()
