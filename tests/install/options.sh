#!/bin/sh
# usage: options.sh SOURCE_DIR [--static]   configures with what packagers and other projects set: options, standards, unity builds,
# absent libraries. --static builds the archive of BUILD_SHARED_LIBS=OFF, which takes minutes, and programs with it.
set -eu
source=$1
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
fail() { echo "$*"; cat "$place/log"; exit 1; }
configure() { rm -rf "$place/build"; cmake -G Ninja -S "$source" -B "$place/build" -DGLIBRA_TESTS=OFF "$@" >"$place/log" 2>&1; }
none='-DGLIBRA_WINDOW=OFF -DGLIBRA_IMAGE_MODULE=OFF -DGLIBRA_SERVER_MODULE=OFF -DGLIBRA_BENCH_PROGRAM=OFF'

if [ "${2-}" = --static ]; then
    # shellcheck disable=SC2086
    configure $none -DBUILD_SHARED_LIBS=OFF -DCMAKE_UNITY_BUILD=ON -DCMAKE_CXX_COMPILER_LAUNCHER="$source/tools/cmake/compile-cached" ||
        fail "a static library cannot be configured"
    cmake --build "$place/build" --target libglibra.a >"$place/log" 2>&1 || fail "a static library cannot be built"
    cmake --install "$place/build" --prefix "$place/prefix" --component devel >"$place/log" 2>&1 || fail "it cannot be installed"
    rm -r "$place/build"
    scene=$source/glib/start/teapot.glib
    mkdir "$place/consumer"
    cp "$source/tests/install/consumer.cpp" "$place/consumer"
    printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(consumer LANGUAGES CXX)' \
        'find_package(glibra REQUIRED COMPONENTS library)' 'add_executable(consumer consumer.cpp)' \
        'target_link_libraries(consumer PRIVATE glibra::glibra)' >"$place/consumer/CMakeLists.txt"
    cmake -G Ninja -S "$place/consumer" -B "$place/consumer" -DCMAKE_PREFIX_PATH="$place/prefix" >"$place/log" 2>&1 ||
        fail "the static library is not found"
    cmake --build "$place/consumer" >>"$place/log" 2>&1 || fail "a program with the static library by find_package"
    "$place/consumer/consumer" "$scene" >"$place/log" 2>&1 || fail "the program of find_package"
    pc=$(dirname "$(find "$place/prefix" -name glibra.pc)")
    # shellcheck disable=SC2046
    ${CXX:-c++} -std=c++20 "$place/consumer/consumer.cpp" -o "$place/by_pkg_config" \
        $(PKG_CONFIG_PATH=$pc pkg-config --cflags --libs glibra) >"$place/log" 2>&1 || fail "a program with it by pkg-config"
    "$place/by_pkg_config" "$scene" >"$place/log" 2>&1 || fail "the program of pkg-config"
    ldd "$place/by_pkg_config" | grep libglibra && fail "the program needs a shared library"
    exit 0
fi

# A system without the libraries of the optional parts: pkg-config sees the others alone.
mkdir "$place/pc"
pkg-config --variable pc_path pkg-config | tr : '\n' | while read -r folder; do
    [ ! -d "$folder" ] || find "$folder" -name '*.pc' -exec ln -sf -t "$place/pc" {} +
done
(cd "$place/pc" && rm -f glfw3.pc imgui.pc OpenImageIO.pc OpenEXR.pc libwebp.pc libwebpdemux.pc cpp-httplib.pc)
lacking="-DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON -DCMAKE_DISABLE_FIND_PACKAGE_httplib=ON -DCMAKE_DISABLE_FIND_PACKAGE_pybind11=ON"
full=${PKG_CONFIG_LIBDIR-}
export PKG_CONFIG_LIBDIR="$place/pc"

# Everything optional is left out; with the other wishes of a packager at the same time.
# shellcheck disable=SC2086
configure $none $lacking -DCMAKE_CXX_STANDARD=23 -DCMAKE_UNITY_BUILD=ON -DBUILD_SHARED_LIBS=OFF || fail "without optional libraries"
rules=$place/build/build.ninja
for each in glibra-view glibra-bench glibra_openimageio.so glibra_server.so libglibra.so; do
    grep -q "^build ${each}[: ]" "$rules" && fail "made all the same: $each"
done
grep -q '^build libglibra.a:' "$rules" || fail "no static library"
grep -q -- '-std=c++23' "$rules" || fail "not compiled as C++23"
grep -q -- '-std=\(c\|gnu\)++20' "$rules" && fail "compiled as C++20"
grep -q '^build .*Unity/unity_0_cxx' "$rules" || fail "no unity build"

# Where one is wanted and missing, one message names it and the option.
refused() { # WORDS OPTION...
    words=$1
    shift
    # shellcheck disable=SC2086
    configure $none $lacking "$@" && fail "taken: $*"
    tr -s '\n ' ' ' <"$place/log" | grep -q "$words" || fail "no word about: $words"
    [ "$(grep -c 'CMake Error' "$place/log")" = 1 ] || fail "more than one message"
}
refused 'GLFW is missing.*-DGLIBRA_WINDOW=OFF' -DGLIBRA_WINDOW=ON
refused 'OpenImageIO is missing.*-DGLIBRA_IMAGE_MODULE=OFF' -DGLIBRA_IMAGE_MODULE=ON
refused 'cpp-httplib is missing.*-DGLIBRA_SERVER_MODULE=OFF' -DGLIBRA_SERVER_MODULE=ON
refused 'Boost 1.74 is missing.*-DGLIBRA_BENCH_PROGRAM=OFF' -DGLIBRA_BENCH_PROGRAM=ON
refused 'pybind11 is missing.*-DGLIBRA_PYTHON=OFF' -DGLIBRA_PYTHON=ON
refused 'glibra needs C++20 or later: CMAKE_CXX_STANDARD is 17' -DCMAKE_CXX_STANDARD=17

# The defaults: a shared library, C++20, each file on its own.
if [ -n "$full" ]; then PKG_CONFIG_LIBDIR=$full; else unset PKG_CONFIG_LIBDIR; fi
# shellcheck disable=SC2086
configure $none || fail "the defaults"
grep -q '^build libglibra.so[.0-9]*:' "$rules" || fail "no shared library"
grep -q -- '-std=c++20' "$rules" || fail "not compiled as C++20"
grep -q Unity/unity_ "$rules" && fail "a unity build that nobody asked for"

# The targets that debian/rules names link all that is installed; `glibra` alone is the program, not the library.
configure -DGLIBRA_PYTHON=ON || fail "all parts"
targets=$(sed -n 's/^\tdh_auto_build -- //p' "$source/debian/rules")
[ -n "$targets" ] || fail "debian/rules names no targets"
# shellcheck disable=SC2086
ninja -C "$place/build" -t commands $targets >"$place/log" 2>&1 ||
    fail "targets of debian/rules"
ninja -C "$place/build" -t targets all | sed -n 's/: CXX_\(EXECUTABLE\|[A-Z]*_LIBRARY\)_LINKER__.*//p' | while read -r file; do
    ! grep -q "\"$place/build/$file\"" "$place/build/cmake_install.cmake" || grep -q -- "-o $file " "$place/log" || echo "$file"
done >"$place/missing"
[ ! -s "$place/missing" ] || fail "installed, and not made by debian/rules: $(cat "$place/missing")"
