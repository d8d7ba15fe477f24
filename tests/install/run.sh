#!/bin/sh
# usage: run.sh SOURCE_DIR BUILD_DIR   installs to a temporary folder, builds the consumer against it, runs both.
set -eu
source=$1
build=$2
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
export CMAKE_GENERATOR=Ninja  # a bare machine has no make
fail() { echo "$*"; cat "$place/log"; exit 1; }

# A project's scene and its suite; the first pictures become the goldens.
mkdir "$place/scenes"
cp "$source/scenes/expectations/sphere.glib" "$source/scenes/expectations/plain.vert" \
   "$source/scenes/expectations/plain.frag" "$place/scenes"
cat >"$place/scenes/pictures.toml" <<'END'
[defaults]
size = [64, 48]
[[shot]]
script = "sphere.glib"
[[shot]]
name = "far/away/blue"
script = "sphere.glib"
set = { uColor = [0, 0, 1] }
[[shot]]
name = "red"
script = "sphere.glib"
set = { uColor = [1, 0, 0] }
END

cmake --install "$build" --prefix "$place/prefix" >"$place/log"

# What the library exports: what include/glibra marks, and nothing of the libraries inside.
library=$(find "$place/prefix" -name 'libglibra.so')
nm -D --defined-only -C "$library" | sed 's/^[0-9a-f]* . //' >"$place/exported"
grep -v '^\(typeinfo\( name\)\? for \|vtable for \)\?glibra::' "$place/exported" >"$place/log" && fail "exported by mistake"
grep -q '^glibra::Renderer::open' "$place/exported" || fail "not exported: glibra::Renderer::open"
[ "$(wc -l <"$place/exported")" -lt 300 ] || fail "the library exports $(wc -l <"$place/exported") symbols"

# Debian's packages have all that is installed.
for each in "$place"/prefix/* "$place"/prefix/share/* "${library%/*}"/*; do
    name=${each#"$place/prefix/"}
    case $each in
        "${library%/*}" | "${library%/*}/$(uname -m)"* | */share) continue ;;
        */lib/python3*) name=lib/python3 ;;
        *.so.*) name='lib/*/libglibra.so.*' ;;
        "${library%/*}"/*) name="lib/*/${each##*/}" ;;
    esac
    cat "$source"/debian/*.install | grep -qxF "usr/$name" || fail "no package of debian has usr/$name"
done

# The components: a library without the program is a whole package, and one asked for that there is not is refused.
for each in library devel; do cmake --install "$build" --prefix "$place/split" --component "$each" >>"$place/log"; done
find_glibra() { # FOLDER ARGUMENT...: configures a project that calls find_package(glibra ARGUMENT...)
    mkdir -p "$place/find"
    printf 'cmake_minimum_required(VERSION 3.25)\nproject(find LANGUAGES CXX)\nfind_package(glibra %s)\n' "$2" >"$place/find/CMakeLists.txt"
    # shellcheck disable=SC2016
    echo 'file(WRITE ${CMAKE_BINARY_DIR}/found "${glibra_FOUND}")
          if(TARGET glibra::program)
              file(APPEND ${CMAKE_BINARY_DIR}/found program)
          endif()' >>"$place/find/CMakeLists.txt"
    rm -rf "$place/found"
    cmake -S "$place/find" -B "$place/found" "$1" >"$place/log" 2>&1
}
find_glibra "-DCMAKE_PREFIX_PATH=$place/split" 'REQUIRED COMPONENTS library' || fail "the library alone is not found"
find_glibra "-DCMAKE_PREFIX_PATH=$place/split" 'REQUIRED COMPONENTS program' && fail "a program that is not there is found"
find_glibra "-DCMAKE_PREFIX_PATH=$place/prefix" 'REQUIRED COMPONENTS library program' || fail "the program is not found"
grep -q program "$place/found/found" || fail "no target glibra::program"
find_glibra "-DCMAKE_PREFIX_PATH=$place/prefix" 'REQUIRED COMPONENTS python3' && fail "an unknown component is found"
grep -q "no 'python3'" "$place/log" || fail "no word about the component"
find_glibra "-Dglibra_DIR=$build" 'REQUIRED COMPONENTS library program' || fail "a build tree is not found"
find_glibra "-DCMAKE_PREFIX_PATH=$place/prefix" '99.0 REQUIRED' && fail "version 99 is found"

# As a part of another project, by add_subdirectory and by FetchContent: with its alias, and without its tests.
# shellcheck disable=SC2016
for way in 'add_subdirectory(${GLIBRA} glibra)' 'include(FetchContent)
FetchContent_Declare(glibra SOURCE_DIR ${GLIBRA})
FetchContent_MakeAvailable(glibra)'; do
    mkdir -p "$place/part"
    printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(part LANGUAGES CXX)' 'set(CMAKE_CXX_STANDARD 23)' "$way" \
        'add_executable(part part.cpp)' 'target_link_libraries(part PRIVATE glibra::glibra)' \
        'if(TARGET glibra_base_tests OR NOT CMAKE_CXX_STANDARD EQUAL 23)' '    message(FATAL_ERROR "not a part")' 'endif()' \
        >"$place/part/CMakeLists.txt"
    cp "$source/tests/install/consumer.cpp" "$place/part/part.cpp"
    rm -rf "$place/part/build"
    cmake -S "$place/part" -B "$place/part/build" -DGLIBRA="$source" >"$place/log" 2>&1 || fail "a part of another project: $way"
done

# pkg-config, also where the installation has moved.
mv "$place/split" "$place/moved"
pc=$(dirname "$(find "$place/moved" -name glibra.pc)")
# shellcheck disable=SC2046
${CXX:-c++} -std=c++20 "$source/tests/install/consumer.cpp" -o "$place/by_pkg_config" \
    $(PKG_CONFIG_PATH=$pc pkg-config --cflags --libs glibra) >"$place/log" 2>&1 || fail "pkg-config's flags do not build"
rm -r "$place/moved"

# The program of docs/library.md, as it stands there.
mkdir "$place/tour"
# shellcheck disable=SC2016
sed -n '/^```cpp$/,/^```$/p' "$source/docs/library.md" | sed '1d;/^```$/,$d' >"$place/tour/tour.cpp"
cp "$source/glib/start/teapot.glib" "$place/tour"
cp -r "$source/shaders/start/." "$place/tour"
# shellcheck disable=SC2046
${CXX:-c++} -std=c++20 -Wall -Wextra -Werror -I"$place/prefix/include" "$place/tour/tour.cpp" -o "$place/tour/tour" \
    -L"$(dirname "$library")" -lglibra -Wl,-rpath,"$(dirname "$library")" >"$place/log" 2>&1 || fail "the program of docs/library.md"
(cd "$place/tour" && "$place/prefix/bin/glibra" render teapot.glib -o golden.png --size 320x240 --time 3.3 --set uShininess=20 &&
    ./tour) >"$place/log" 2>&1 || fail "the program of docs/library.md ends with another status"
grep -q 'uShininess float' "$place/log" || fail "the program of docs/library.md lists no values"

# The blocks of the pages that are parts of a program, and the one above, by both compilers.
# shellcheck disable=SC2016
for page in README.md docs/library.md docs/classic.md; do
    awk -v out="$place/tour/$(basename "$page" .md)" '
        function close_block() { if (isOpen) { if (!isWhole) print "}" >file; close(file) } isOpen = 0 }
        /^```cpp$/ { file = out "_" ++number ".cpp"; isOpen = 1; begun = 0; next }
        /^```$/ { close_block(); next }
        isOpen && !begun { begun = 1; isWhole = /^#include/ ? 2 : 0
            if (!isWhole) print "#include <glibra/classic/classic.h>\nusing namespace glibra::classic;\nint program(float aspect) {" >file }
        isOpen && isWhole == 2 && !/^#include/ && !/^$/ { isWhole = /^int main/; if (!isWhole) print "int program() {" >file }
        isOpen { print >file }' "$source/$page"
done
ls "$place"/tour/README_1.cpp "$place"/tour/library_1.cpp "$place"/tour/classic_1.cpp >"$place/log" 2>&1 || fail "no blocks of the pages"
for compiler in ${CXX:-c++} clang++-19; do
    command -v "$compiler" >/dev/null || continue
    for each in "$place"/tour/*_*.cpp; do
        "$compiler" -std=c++20 -Wall -Werror -Wno-return-type -Wno-unused-variable -Wno-unused-but-set-variable -fsyntax-only \
            -I"$place/prefix/include" "$each" >"$place/log" 2>&1 || fail "$compiler: a block of $(basename "$each")"
    done
done

# A project of Meson.
if command -v meson >/dev/null; then
    mkdir "$place/meson"
    cp "$source/tests/install/consumer.cpp" "$place/meson"
    printf "%s\n" "project('consumer', 'cpp', default_options: ['cpp_std=c++20'])" \
        "executable('consumer', 'consumer.cpp', dependencies: dependency('glibra'))" >"$place/meson/meson.build"
    meson setup "$place/meson/build" "$place/meson" --pkg-config-path "$(dirname "$(find "$place/prefix" -name glibra.pc)")" \
        >"$place/log" 2>&1 || fail "a project of Meson cannot be configured"
    meson compile -C "$place/meson/build" >"$place/log" 2>&1 || fail "a project of Meson cannot be built"
    "$place/meson/build/consumer" "$source/glib/start/teapot.glib" >"$place/log" 2>&1 || fail "a program of Meson"
fi

# The book's classes: in a program with a loader of its own, and the examples in a window.
# shellcheck disable=SC2046
${CXX:-c++} -std=c++20 -Wall -Wextra -Werror -I"$place/prefix/include" "$source/tests/install/classic.cpp" -o "$place/classic" \
    -L"$(dirname "$library")" -lglibra -Wl,-rpath,"$(dirname "$library")" >"$place/log" 2>&1 || fail "a program with a loader of its own"
"$place/classic" >"$place/log" 2>&1 || fail "the classes beside a loader of the program"
grep -q glm "$place"/prefix/include/glibra/classic/*.h && fail "the headers of the classes need GLM"
if pkg-config --exists glfw3 && command -v xvfb-run >"$place/log"; then
    cp -r "$source/docs/examples/classic" "$place/examples"
    for each in cube grid instances; do
        # shellcheck disable=SC2046
        ${CXX:-c++} -std=c++20 -Wall -Wextra -Werror -I"$place/prefix/include" "$place/examples/$each.cpp" -o "$place/examples/$each" \
            -L"$(dirname "$library")" -lglibra -Wl,-rpath,"$(dirname "$library")" $(pkg-config --cflags --libs glfw3) -lGL \
            >"$place/log" 2>&1 || fail "the example $each"
        (cd "$place/examples" && xvfb-run -a "./$each" 2) >"$place/log" 2>&1 || fail "the example $each ends with another status"
        grep -q ' [1-9][0-9] % of the window' "$place/log" || fail "the example $each draws nothing"
    done
fi

# Scenes in windows of other libraries: something else than the program's own colour is in the middle of each.
for each in glfw:glfw3 sdl:sdl2; do
    name=${each%:*}
    if ! pkg-config --exists "${each#*:}" || ! command -v xvfb-run >"$place/log"; then continue; fi
    # shellcheck disable=SC2046
    ${CXX:-c++} -std=c++20 -Wall -Wextra -Werror -I"$place/prefix/include" "$source/docs/examples/windows/$name.cpp" -o "$place/$name" \
        -L"$(dirname "$library")" -lglibra -Wl,-rpath,"$(dirname "$library")" $(pkg-config --cflags --libs "${each#*:}") -lGL \
        >"$place/log" 2>&1 || fail "the example $name"
    printf 'WindowSize 64 64\nBackground 1 .5 0\n' >"$place/orange.glib"
    # shellcheck disable=SC2016
    xvfb-run -a sh -c '"$1" "$2" & shown=$!
        for i in $(seq 100); do
            sleep .1
            import -window root "$3" && convert "$3" -unique-colors txt:- | grep -qi "#ff8000" && break
        done
        kill $shown' sh "$place/$name" "$place/orange.glib" "$place/$name.png" >"$place/log" 2>&1
    convert "$place/$name.png" -unique-colors txt:- | grep -qi '#ff8000' || fail "the example $name shows no scene"
    xvfb-run -a "$place/$name" "$source/glib/start/teapot.glib" 3 >"$place/log" 2>&1 || fail "the example $name ends with another status"
done

# Pages for shells and manuals are those of the program, and none is missing.
for each in $("$place/prefix/bin/glibra" manual | sed -n 's/^\\fBglibra\\-\([a-z]*\).*/\1/p'); do
    test -s "$place/prefix/share/man/man1/glibra-$each.1" || fail "no manual page of $each"
done
for each in man/man1/glibra.1 bash-completion/completions/glibra zsh/vendor-completions/_glibra \
    fish/vendor_completions.d/glibra.fish applications/glibra.desktop metainfo/glibra.metainfo.xml mime/packages/glibra.xml \
    thumbnailers/glibra.thumbnailer icons/hicolor/256x256/apps/glibra.png; do
    [ -s "$place/prefix/share/$each" ] || [ ! -f "$build/glibra-view" ] || fail "not installed: $each"
done
cmake -S "$source/tests/install" -B "$place/consumer" -DCMAKE_PREFIX_PATH="$place/prefix" \
    -DSCENES="$place/scenes" >>"$place/log" || fail "the consumer cannot be configured"
cmake --build "$place/consumer" >>"$place/log" || fail "the consumer cannot be built"
LD_LIBRARY_PATH=$(dirname "$(find "$place/prefix" -name 'libglibra.so')") \
    "$place/consumer/consumer" "$source/glib/start/teapot.glib"

cd "$place"
# The module for picture formats is found from where it was installed to.
"$place/prefix/bin/glibra" render "$source/glib/start/teapot.glib" --size 64x48 -o teapot.jpg
test -s teapot.jpg
test -f "$place/prefix/share/glibra/shaders/builtin/flat.vert"
# The examples are whole where they are installed.
"$place/prefix/bin/glibra" check "$place/prefix"/share/glibra/glib/*/*.glib >>"$place/log" 2>&1 || fail "an example lacks a file"

# An installed program loads nothing from the folder in which it was built: without its own module it has none.
mkdir "$place/aside"
find "$place/prefix" -name glibra_openimageio.so -exec mv {} "$place/aside" \;
"$place/prefix/bin/glibra" render "$source/glib/start/teapot.glib" --size 64x48 -o built.jpg 2>"$place/log" &&
    fail "the module of the build tree"
grep -q 'is not installed' "$place/log" || fail "no word about the module"
mv "$place/aside/glibra_openimageio.so" "$(dirname "$(find "$place/prefix" -name glibra-view -o -name glibra-bench | head -n 1)")"

# An installation that has moved is whole: it finds its module, its programs and its library beside itself.
mv "$place/prefix" "$place/elsewhere"
moved="$place/elsewhere/bin/glibra"
LD_DEBUG=files "$moved" render "$source/glib/start/teapot.glib" --size 64x48 -o moved.jpg 2>"$place/log"
test -s moved.jpg
grep "calling init: $place/elsewhere/.*/glibra_openimageio.so" "$place/log" >/dev/null || fail "the module of another place"
"$moved" check "$place"/elsewhere/share/glibra/glib/*/*.glib >"$place/log" 2>&1 || fail "a moved example lacks a file"
"$moved" view --help >"$place/log" 2>&1 || fail "the window is not found"
if [ -f "$build/glibra-bench" ]; then
    "$moved" bench --list >"$place/log" 2>&1 || fail "the benchmarks are not found"
fi
printf 'Vertex noise/solid.vert\nFragment noise/marble.frag\nProgram Marble\nSphere 1\n' >"$place/mine.glib"
"$moved" render "$place/mine.glib" --size 64x48 -o mine.png 2>"$place/log" && fail "a file of the library is found by itself"
grep -q -- "--library $place/elsewhere/share/glibra finds it" "$place/log" || fail "no word about the library"
"$moved" render "$place/mine.glib" --size 64x48 -o mine.png --library "$place/elsewhere/share/glibra" 2>"$place/log" ||
    fail "the library is not found"
mv "$place/elsewhere" "$place/prefix"

# Golden tests: red without goldens, green with them, red again for one changed shader, in both tests.
golden_tests() { ctest --test-dir "$place/consumer" -L glibra >>"$place/log" 2>&1; }
golden_tests && fail "golden tests pass without goldens"
cmake --build "$place/consumer" --target pictures-update >>"$place/log" || fail "no goldens were made"
test -s "$place/scenes/golden/pictures/red.png" || fail "no golden of the shot 'red'"
golden_tests || fail "golden tests fail on unchanged scenes"
# One test per shot: by name, with labels and processors; ctest sees a shot that has been added since.
ctest --test-dir "$place/consumer" -L single -N >"$place/log"
for each in sphere red; do grep -q "each.pictures/$each\$" "$place/log" || fail "no test of the shot '$each'"; done
grep -q 'each.pictures/far/away/blue$' "$place/log" || fail "no test of a shot in a folder"
grep -q 'Total Tests: 3' "$place/log" || fail "other tests than one per shot"
ctest --test-dir "$place/consumer" -R 'each.pictures/red$' >"$place/log" 2>&1 || fail "the test of one shot fails"
grep -q '<testcase name="red"' "$place/consumer/each-results/red/junit.xml" || fail "no JUnit file of one shot"
ctest --test-dir "$place/consumer" -L single --show-only=json-v1 >"$place/log"
grep -A 3 '"PROCESSORS"' "$place/log" | grep -q '"value" : 2' || fail "PROCESSORS is lost"
cp "$place/scenes/pictures.toml" "$place/pictures.toml"
printf '[[shot]]\nname = "green"\nscript = "sphere.glib"\nset = { uColor = [0, 1, 0] }\n' >>"$place/scenes/pictures.toml"
ctest --test-dir "$place/consumer" -L single >"$place/log" 2>&1 && fail "a shot without a golden passes"
grep -q 'each.pictures/green .*Failed' "$place/log" || fail "a shot that was added is not seen"
grep -q 'each.pictures/red .*Passed' "$place/log" || fail "the other shots do not pass"
printf '[[shot]]\nnaem = "x"\n' >>"$place/scenes/pictures.toml"
ctest --test-dir "$place/consumer" -R '^each' --output-on-failure >"$place/log" 2>&1 && fail "a broken suite passes"
grep -q "unknown key 'naem'" "$place/log" || fail "the mistake of the suite is not shown"
cp "$place/pictures.toml" "$place/scenes/pictures.toml"
test -f "$place/consumer/pictures-report/index.html" || fail "no report"
grep -q '<testcase' "$place/consumer/pictures-results/junit.xml" || fail "no JUnit file"
sed -i 's/vLight \* uColor/.9 * vLight * uColor/' "$place/scenes/plain.frag"
golden_tests && fail "golden tests do not see a changed shader"
ctest --test-dir "$place/consumer" -L quick >>"$place/log" 2>&1 && fail "the label or ONLY is lost"

# Wrong arguments are reported when the project is configured.
for wrong in "SUITE nowhere.toml" "" "SUITE ${place}/scenes/pictures.toml COLOR red"; do
    printf 'cmake_minimum_required(VERSION 3.25)\nproject(wrong NONE)\nfind_package(glibra REQUIRED)\nenable_testing()\n%s\n' \
        "glibra_add_golden_test(pictures $wrong)" >"$place/scenes/CMakeLists.txt"
    cmake -S "$place/scenes" -B "$place/wrong" -DCMAKE_PREFIX_PATH="$place/prefix" >"$place/log" 2>&1 &&
        fail "taken: glibra_add_golden_test(pictures $wrong)"
    grep -q 'glibra_add_golden_test(pictures)' "$place/log" || fail "no message for: $wrong"
done
exit 0
