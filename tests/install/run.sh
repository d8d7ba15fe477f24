#!/bin/sh
# usage: run.sh SOURCE_DIR BUILD_DIR   installs to a temporary folder, builds the consumer against it, runs both.
set -eu
source=$1
build=$2
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cmake --install "$build" --prefix "$place/prefix" >"$place/log"
cmake -S "$source/tests/install" -B "$place/consumer" -DCMAKE_PREFIX_PATH="$place/prefix" >>"$place/log"
cmake --build "$place/consumer" >>"$place/log" || { cat "$place/log"; exit 1; }
LD_LIBRARY_PATH=$(dirname "$(find "$place/prefix" -name 'libglibra.so')") \
    "$place/consumer/consumer" "$source/glib/start/teapot.glib"
cd "$place"
# The module for picture formats is found from where it was installed to.
"$place/prefix/bin/glibra" render "$source/glib/start/teapot.glib" --size 64x48 -o teapot.jpg
test -s teapot.jpg
test -f "$place/prefix/share/glibra/shaders/builtin/flat.vert"
