"""A live page with mock_runtime.js in place of the runtime, as the program would write it."""
import base64
import gzip
import hashlib
import json
import os
import re
import struct
import zlib

HERE = os.path.dirname(os.path.abspath(__file__))
WEB = os.path.join(HERE, "..", "..", "src", "page", "web")
SCENE = "# A ball that blinks.\nWindowSize 512 384\nTimer 2\nVertex ball.vert\nFragment ball.frag\nProgram Ball uTone <0. .8 1.>\nSphere 1 30 30\n"
FILES = {"ball.glib": SCENE, "ball.frag": "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(1.); }\n",
         "ball.vert": "#version 330 core\nvoid main() {\n    gl_Position = uModelViewProjectionMatrix * aVertex;\n}\n"}


def text_of(name):
    with open(name, encoding="utf-8") as file:
        return file.read()


def script():
    names = sorted(each for each in os.listdir(WEB) if each.endswith(".js") and each not in ("main.js", "runtime.js", "gl.js", "wasi.js"))
    texts = [text_of(os.path.join(WEB, each)) for each in names]
    texts += [text_of(os.path.join(HERE, "mock_runtime.js")), text_of(os.path.join(WEB, "main.js"))]
    texts = [re.sub(r"(^|\n)export ", r"\1", re.sub(r"(^|\n)import [^;]*;", r"\1", each)) for each in texts]
    return '"use strict";\n(() => {\n' + "".join(texts) + "})();\n"


def png(width, height, color):
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    rows = (b"\0" + bytes(color) * width) * height
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def policy_hash(text):
    return "'sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() + "'"


def page(files=None, **data):
    """The text of a page. `data`: what differs from the usual data."""
    files = dict(FILES, **(files or {}))
    contents = {name: text.encode() for name, text in files.items()}
    whole = {"scene": "ball.glib", "files": [{"name": name, "bytes": len(text), "converted": False} for name, text in contents.items()],
             "content": base64.b64encode(gzip.compress(b"".join(contents.values()))).decode(), "set": [], "time": 0, "width": 0, "height": 0,
             "embed": False, "poster": False, **data}
    style, code = text_of(os.path.join(WEB, "live.css")), script()
    poster = "data:image/png;base64," + base64.b64encode(png(512, 384, (120, 150, 180))).decode()
    module = base64.b64encode(gzip.compress(b"\0asm\1\0\0\0")).decode()
    slots = {
        "policy": f"default-src 'none'; img-src data: blob:; style-src {policy_hash(style)}; script-src {policy_hash(code)} 'wasm-unsafe-eval'; base-uri 'none'; form-action 'none'",
        "title": "ball", "style": style, "kind": "page embedded" if whole["embed"] else "page", "text": "" if whole["embed"] else "<div class=\"text\"><p>A ball that blinks.</p></div>",
        "content": f'<div class="live"><img class="poster" src="{poster}" width="512" height="384" alt="the picture"></div>',
        "scripts": '<script type="application/json" id="glibra-scene">' + json.dumps(whole).replace("<", "\\u003c") + "</script>\n"
                   f'<script type="text/plain" id="glibra-runtime">{module}</script>\n<script>{code}</script>'}
    return re.sub(r"\{{2,3}(\w+)\}{2,3}", lambda found: slots[found.group(1)], text_of(os.path.join(WEB, "page.html")))
