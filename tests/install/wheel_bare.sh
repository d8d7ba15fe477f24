#!/bin/sh
# usage: wheel_bare.sh WHEEL   as root, in the tree, in a Debian that has no package of glibra's: the wheel with Python, NumPy and
# Mesa, and nothing else. It draws, and writes and reads pictures of all formats that it carries a library for.
# (tools/test-bare -p runs it.)
set -eu
wheel=$(realpath "$1")
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
export DEBIAN_FRONTEND=noninteractive
apt-get update -qq
apt-get install -y -qq --no-install-recommends python3-venv python3-numpy libegl1 libgl1-mesa-dri >/dev/null
[ -z "$(dpkg-query -W 'libfmt*' 'libspng*' 'libopenexr*' 'libtiff*' 2>/dev/null)" ] || { echo "the system has the libraries"; exit 1; }
python3 -m venv --system-site-packages "$place/env"
"$place/env/bin/pip" install -q --no-index "$wheel"
cp -r glib shaders textures "$place"
cd "$place/glib"
"$place/env/bin/python" - <<'END'
import glibra

scene = glibra.Scene("start/teapot.glib")
picture = scene.draw(64, 48)
assert picture.shape == (48, 64, 3) and picture.min() < picture.max(), picture.shape
for ending in ("png", "jpg", "tif", "webp", "exr"):
    glibra.save(picture, "picture." + ending)
    with open("read.glib", "w") as script:
        script.write("Texture2D 5 picture.%s\nVertex show.vert\nFragment show.frag\nProgram Show uPicture 5\nQuadXY 0 1\n" % ending)
    with open("show.vert", "w") as text:
        text.write("#version 330\nin vec4 aVertex;\nvoid main() { gl_Position = aVertex; }\n")
    with open("show.frag", "w") as text:
        text.write("#version 330\nuniform sampler2D uPicture;\nout vec4 color;\n"
                   "void main() { color = texelFetch(uPicture, ivec2(gl_FragCoord.xy), 0); }\n")
    again = glibra.Scene("read.glib").draw(64, 48)
    off = abs(again.astype(int) - picture.astype(int)).mean()
    assert off < 3, (ending, off)
    print(ending, off)
END
