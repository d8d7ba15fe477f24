#!/bin/sh
# usage: cached_headers.sh COMPILE_CACHED COMPILER   A precompiled header that is made in the place of an older one is new.
set -eu
launcher=$1
compiler=$2
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cd "$place"
export CCACHE_DIR="$place/cache" CCACHE_SLOPPINESS=pch_defines,time_macros
: >all.cpp
echo '#include "size.h"' >all.h
echo 'int main() { return sizeof(Size); }' >program.cpp
# ccache trusts no header that is as new as the compilation: these are a minute old.
size_of() {
    echo "struct Size { char bytes[$1]; };" >size.h
    touch -d '1 minute ago' size.h all.h all.cpp program.cpp
    "$launcher" "$compiler" -fpch-preprocess -x c++-header -include "$place/all.h" -o "$place/all.h.gch" -c all.cpp
    "$launcher" "$compiler" -fpch-preprocess -include "$place/all.h" -o program.o -c program.cpp
    "$compiler" program.o -o program
    status=0
    ./program || status=$?
    [ "$status" = "$1" ] || { echo "the program was built with a header of $status bytes instead of $1"; exit 1; }
}
size_of 4
cp all.h.gch first.gch
size_of 8
cp first.gch all.h.gch
size_of 12
