#!/bin/sh
# usage: abi.sh SOURCE_DIR BUILD_DIR [--record]   compares the binary interface of the library with the recorded one: what it
# exports with debian/libglibra1.symbols, and how the types of its headers lie in memory with layout.txt beside this file. What a
# program was compiled with must still be there and look the same. --record writes both anew, for a new interface.
set -eu
source=$1
library=$2/libglibra.so
symbols=$source/debian/libglibra1.symbols
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

"${CXX:-c++}" -std=c++20 -w -I"$source/include" -I"$2/include" "$source/tests/install/layout.cpp" -o "$place/layout"
"$place/layout" >"$place/layout.txt"
soname=$(readelf -d "$library" | sed -n 's/.*SONAME.*\[\(.*\)\]/\1/p')
version=$(sed -n 's/^project(glibra VERSION \([0-9.]*\).*/\1/p' "$source/CMakeLists.txt")
nm -D --defined-only "$library" | awk '{ print $3 }' | LC_ALL=C sort >"$place/exported"
if [ "${3-}" = --record ]; then
    { echo "$soname libglibra1 #MINVER#"; sed "s/.*/ &@Base $version/" "$place/exported"; } >"$symbols"
    cp "$place/layout.txt" "$source/tests/install/layout.txt"
    exit
fi
status=0
[ "$(head -n 1 "$symbols")" = "$soname libglibra1 #MINVER#" ] || { echo "the record is of another library than $soname"; status=1; }
sed -n 's/^ \(.*\)@Base .*/\1/p' "$symbols" | LC_ALL=C sort >"$place/recorded"
if ! comm -23 "$place/recorded" "$place/exported" | c++filt >"$place/gone" || [ -s "$place/gone" ]; then
    echo "not exported any more:"
    cat "$place/gone"
    status=1
fi
comm -13 "$place/recorded" "$place/exported" | c++filt >"$place/new"
if [ -s "$place/new" ]; then
    echo "exported and not recorded:"
    cat "$place/new"
    status=1
fi
diff "$source/tests/install/layout.txt" "$place/layout.txt" || status=1
[ "$status" = 0 ] && exit
cat <<'END'
If the change is wanted: programs that were compiled before work with additions that are functions. For everything else raise
GLIBRA_ABI in CMakeLists.txt, once per release. Then record the interface: tests/install/abi.sh SOURCE_DIR BUILD_DIR --record
END
exit 1
