#!/bin/sh
# usage: portable_bare.sh FOLDER   the unpacked archive in a Debian that has no package besides its own, as root: without a
# driver, then with Mesa. (tools/test-bare -p runs it.)
set -eu
tree=$(CDPATH='' cd -- "$1" && pwd)
place=$(mktemp -d)
trap 'umount "$tree" 2>/dev/null || true; rm -rf "$place"' EXIT
cd "$place"
fail() { echo "$*"; cat log; exit 1; }
# ends STATUS COMMAND...: messages are in the file log
ends() {
    wanted=$1
    shift
    status=0
    "$@" >log 2>&1 || status=$?
    [ "$status" = "$wanted" ] || fail "status $status, not $wanted: $*"
}
says() { grep -q -- "$1" log || fail "no word '$1'"; }

ln -s "$tree/bin/glibra" glibra
scene=$tree/glib/start/teapot.glib
ends 0 ./glibra language Sphere
ends 4 ./glibra render "$scene"
says 'no usable OpenGL driver'
says 'libegl1 libgl1-mesa-dri'
ends 4 ./glibra view "$scene"
says 'there is no display'
ends 4 env DISPLAY=:7 ./glibra view "$scene"
says 'needs the library libX11.so.6'

ends 0 sh -c 'apt-get update && apt-get install -y --no-install-recommends libegl1 libgl1-mesa-dri'
ends 0 ./glibra render "$scene"
[ "$(stat -c %s teapot.png)" -gt 5000 ] || fail "no picture"
ends 0 ./glibra test "$tree/scenes/start.toml"
ends 0 ./glibra bench --list
ends 3 ./glibra render "$scene" -o teapot.jpg
says 'the image module that reads it cannot be loaded: libOpenImageIO'
[ "$(grep -c error: log)" = 1 ] || fail "more than one message"

# Where nobody may write, and where the C++ library is missing.
mount --bind "$tree" "$tree"
mount -o remount,bind,ro "$tree"
ends 0 ./glibra test "$tree/scenes/start.toml"
for each in /usr/lib/*/libstdc++.so.6* /usr/lib/*/libz.so.1*; do mv "$each" "$place"; done
ends 0 ./glibra language Sphere
