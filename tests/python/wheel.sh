#!/bin/sh
# usage: wheel.sh SOURCE_DIR BUILD_DIR   builds the wheel without a network from what BUILD_DIR has compiled, installs it in an
# empty virtual environment (and NumPy, which it requires, from this system), and draws. Exit status 77: pip is missing; with
# GLIBRA_NO_SKIPS set, as by tools/test, that is a failure.
set -eu
source=$1
python=/usr/bin/python3
$python -c 'import setuptools, pip, venv, wheel, numpy' 2>/dev/null || {
    echo "skipped: no pip, setuptools or venv"
    if [ -n "${GLIBRA_NO_SKIPS-}" ]; then exit 1; else exit 77; fi
}
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
fail() { echo "$*"; cat "$place/log"; exit 1; }

before=$(ls -A "$source" "$source/src/python")
(cd "$source" && GLIBRA_BUILD=$2 $python -m pip wheel src/python --no-build-isolation --no-index --no-deps -w "$place/wheels") \
    >"$place/log" 2>&1 || fail "pip wheel"
[ "$(ls -A "$source" "$source/src/python")" = "$before" ] || fail "pip wheel leaves files in the source"

$python -m venv --without-pip "$place/env"
inside=$place/env/bin/python
$inside -c 'import glibra' 2>/dev/null && fail "the environment is not empty"
$python -m pip --python "$inside" install --no-index --no-deps "$place"/wheels/glibra-*.whl >"$place/log" 2>&1 || fail "pip install"
site=$($inside -c 'import sysconfig; print(sysconfig.get_path("platlib"))')
for each in $($python -c 'import glob, numpy; print(*glob.glob(numpy.__path__[0] + "*"))'); do ln -s "$each" "$site"; done
cd "$place"
$inside - "$source/glib/start/teapot.glib" "$place/env" >"$place/log" 2>&1 <<'END' || fail "the installed wheel"
import sys
import glibra
assert glibra.__file__.startswith(sys.argv[2]), glibra.__file__
scene = glibra.Scene(sys.argv[1])
scene.uShininess = 20
picture = scene.draw(64, 48, time=1)
assert picture.shape == (48, 64, 3) and picture.min() < picture.max()
assert glibra.compare(picture, picture).same
glibra.save(picture, "picture.jpg")
END
$python -m pip --python "$inside" uninstall -y glibra >"$place/log" 2>&1 || fail "pip uninstall"
[ -z "$(find "$place/env" -name '*glibra*')" ] || fail "pip uninstall leaves files"
