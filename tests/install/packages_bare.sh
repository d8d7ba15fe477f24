#!/bin/sh
# usage: packages_bare.sh   in a folder with the .deb files of tools/package, in a Debian that has no package besides its own,
# as root: installs them, uses them as their users would, and removes them. (tools/test-bare -k runs it.)
set -eu
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
fail() { echo "$*"; cat "$place/log"; exit 1; }
quietly() { "$@" >"$place/log" 2>&1 || fail "failed: $*"; }
export DEBIAN_FRONTEND=noninteractive

quietly apt-get update
dpkg -l | sort >"$place/before"
begin=$(date +%s)
quietly apt-get install -y --no-install-recommends ./glibra_*.deb
cp /usr/share/glibra/glib/start/teapot.glib "$place"
cd "$place"
quietly glibra render /usr/share/glibra/glib/start/teapot.glib
[ "$(stat -c %s teapot.png)" -gt 5000 ] || fail "no picture"
echo "from apt-get install to the first picture: $(($(date +%s) - begin)) s"
quietly glibra check /usr/share/glibra/glib/start/teapot.glib
quietly glibra publish /usr/share/glibra/glib/start/teapot.glib
grep -q glibra-runtime teapot.html || fail "a page without its runtime"
# Without the recommended libraries, pictures in other formats are refused with their reason.
glibra render /usr/share/glibra/glib/start/teapot.glib -o teapot.jpg >log 2>&1 && fail "a JPEG without its library"
grep -q libOpenImageIO log || fail "no word about the library"
cd - >/dev/null

begin=$(date +%s)
quietly apt-get install -y --no-install-recommends ./libglibra1_*.deb ./python3-glibra_*.deb
quietly python3 -c 'import glibra
scene = glibra.Scene("/usr/share/glibra/glib/start/teapot.glib")
scene.uShininess = 20
picture = scene.draw(64, 48, time=1)
assert picture.shape == (48, 64, 3) and picture.min() < picture.max()'
echo "from apt-get install to the first array in Python: $(($(date +%s) - begin)) s"
# pytest knows the fixture by what is installed.
quietly apt-get install -y --no-install-recommends python3-pytest
printf 'def test_teapot(golden):\n    golden.check("/usr/share/glibra/glib/start/teapot.glib", time=2)\n' >"$place/test_it.py"
for words in --glibra-update --glibra-report=report; do
    (cd "$place" && python3 -m pytest -q $words test_it.py) >"$place/log" 2>&1 || fail "pytest $words"
done
[ -s "$place/golden/test_teapot.png" ] || fail "no golden picture"
# A package that is there already does not get what it recommends.
quietly apt-get purge -y glibra
quietly apt-get install -y ./glibra_*.deb ./libglibra1_*.deb ./libglibra-dev_*.deb ./python3-glibra_*.deb ./glibra-doc_*.deb
quietly apt-get install -y --no-install-recommends g++ cmake ninja-build pkg-config xvfb xauth x11-utils man-db desktop-file-utils
cp CMakeLists.txt consumer.cpp "$place"
cd "$place"
quietly glibra render /usr/share/glibra/glib/start/teapot.glib -o teapot.jpg
[ "$(stat -c %s teapot.jpg)" -gt 5000 ] || fail "no JPEG"
test -f /usr/share/doc/glibra-doc/docs/language.md || fail "no documentation"
quietly desktop-file-validate /usr/share/applications/glibra.desktop
# shellcheck disable=SC2016
quietly xvfb-run -a sh -c 'glibra view /usr/share/glibra/glib/start/teapot.glib & opened=$!
    for try in $(seq 60); do
        sleep 1
        if xwininfo -root -tree | grep -qi teapot; then kill $opened; exit 0; fi
    done
    exit 1'
mkdir scenes
cp /usr/share/glibra/glib/start/teapot.glib scenes
printf '[[shot]]\nscript = "/usr/share/glibra/glib/start/teapot.glib"\n' >scenes/pictures.toml
quietly cmake -G Ninja -S . -B build -DSCENES="$place/scenes"
quietly cmake --build build
quietly build/consumer /usr/share/glibra/glib/start/teapot.glib
# shellcheck disable=SC2046
quietly g++ -std=c++20 consumer.cpp -o by_pkg_config $(pkg-config --cflags --libs glibra)
quietly ./by_pkg_config /usr/share/glibra/glib/start/teapot.glib
cd - >/dev/null

# The tests of the packages themselves, by Debian's own program.
quietly apt-get install -y --no-install-recommends autopkgtest
quietly autopkgtest --no-built-binaries ./*.deb . -- null

quietly apt-get purge -y glibra libglibra1 libglibra-dev python3-glibra glibra-doc
find / -xdev -iname '*glibra*' ! -path '/proc/*' ! -path "$PWD/*" ! -path '/root/*' ! -path '/var/log/*' ! -path "$place/*" >"$place/log"
[ ! -s "$place/log" ] || fail "left behind:"
