#!/bin/sh
# usage: portable.sh SOURCE_DIR BUILD_DIR   what tools/package-portable makes of the build, in another place. (tools/test-bare -p
# tries the archive on systems without packages.)
set -eu
source=$1
build=$2
place=$(mktemp -d)
trap 'chmod -R u+w "$place"; rm -rf "$place"' EXIT
fail() { echo "$*"; cat "$place/log"; exit 1; }

"$source/tools/package-portable" -b "$build" -o "$place" -u 2>"$place/log" || fail "no folder"
mkdir "$place/another place"
mv "$place"/glibra-* "$place/another place/glibra"
tree="$place/another place/glibra"

# Nothing of the system is inside, and all that is needed is inside or of the system: the C library, X, and what each system
# with a driver has (C++, zlib).
find "$tree" -type f \( -path '*/bin/*' -o -path '*/lib/glibra/*' \) ! -path '*/licences/*' >"$place/objects"
sed 's|.*/||' "$place/objects" | grep '\.so\.' >"$place/inside"
grep -E '^(libc\.|libm\.|ld-linux|libX|libxcb|libEGL|libGL|libOpenGL|libOSMesa)' "$place/inside" >"$place/log" && fail "of the system:"
while read -r each; do
    case $each in */glibra_openimageio.so | *.wasm) continue ;; esac
    readelf -d "$each" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p'
done <"$place/objects" | sort -u | grep -vE '^(libc|libm|libdl|libpthread|libX11|ld-linux.*)\.so' | grep -vxF -f "$place/inside" \
    >"$place/log" && fail "neither inside nor of the system:"
[ "$(du -s "$tree" | cut -f1)" -lt 80000 ] || fail "more than 80 MB, which is no archive of 30"

# As somebody who may not write there, through a link, from another folder: all parts are found.
chmod -R a-w "$tree"
chmod 755 "$place" "$place/another place"
mkdir "$place/work" "$place/bin"
chmod 777 "$place/work"
ln -s "$tree/bin/glibra" "$place/bin/glibra"
cd "$place/work"
unprivileged=
[ "$(id -u)" != 0 ] || unprivileged="setpriv --reuid=65534 --regid=65534 --clear-groups env HOME=$place/work"
moved() {
    # shellcheck disable=SC2086
    $unprivileged "$place/bin/glibra" "$@" >"$place/log" 2>&1
}
LD_DEBUG=files moved render "$tree/glib/start/teapot.glib" --size 64x48 -o a.png || fail "no picture"
test -s a.png || fail "no picture"
for each in fmt deflate seccomp spng tomlplusplus; do
    grep -q "calling init: $tree/.*/lib$each.so" "$place/log" || fail "another lib$each:"
done
if grep "calling init: $tree/.*/spare/" "$place/log"; then fail "not the libraries of the system, which has them:"; fi
moved test "$tree/scenes/start.toml" || fail "the goldens of the archive do not hold"
moved render "$tree/glib/start/teapot.glib" --size 64x48 -o a.jpg || fail "the module is not found"
moved view --help || fail "the window is not found"
moved bench --list || fail "the benchmarks are not found"
moved check "$tree"/glib/*/*.glib || fail "an example lacks a file"
printf 'Vertex noise/solid.vert\nFragment noise/marble.frag\nProgram Marble\nSphere 1\n' >mine.glib
moved render mine.glib --size 64x48 -o mine.png && fail "a file of the library is found by itself"
grep -q -- "--library '$tree' finds it" "$place/log" || fail "no word about the library"
