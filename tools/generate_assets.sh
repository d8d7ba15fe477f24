#!/bin/sh
# generate_assets.sh: makes the pictures, fields and models in textures/ and scenes/models/ anew. They are kept in
# the repository; run this after a change in tools/generate. Needs g++, libdeflate and python3; takes minutes.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
source=$root/tools/generate
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# No fused multiply-adds: every compiler and machine shall round alike.
compile="g++ -std=c++20 -O2 -ffp-contract=off -Wall -Wextra -Wconversion -Wshadow"
$compile "$source/model.cpp" -o "$work/model"
$compile "$source/pictures.cpp" "$source/march.cpp" "$source/png.cpp" "$source/fruit.cpp" "$source/places.cpp" \
    "$source/rooms.cpp" -o "$work/pictures" -ldeflate -pthread

mkdir -p "$root/textures" "$root/scenes/models"
"$work/model" "$root/scenes/models"
python3 "$source/pawn.py" "$root/scenes/models"
python3 "$source/shuttle.py" "$root/scenes/models"
python3 "$source/fields.py" "$root/textures"
"$work/pictures" "$root/textures" "$@"
