# Sourced by tools/glibra and tools/test: installs what a bare Debian 12 or 13 lacks, configures and builds.
# Defines functions, package lists and what ccache needs. Each function runs in a subshell, so that its variables stay
# its own; one that fails ends the calling script, which has done `set -eu` and stands in the repository root.
# shellcheck shell=sh disable=SC2034

# What every build needs, then what each part needs besides (parts: window, images, bench, server; see CMakeLists.txt). A name that
# ends with a question mark is installed where the system has it: Mesa 25.1 and later have no OSMesa, and Chromium is a snap
# on Ubuntu.
core_packages="g++ cmake ninja-build ccache pkg-config python3-glad libglm-dev libfmt-dev libcli11-dev
 nlohmann-json3-dev libtomlplusplus-dev libdeflate-dev libspng-dev libminizip-dev libxxhash-dev libseccomp-dev libegl1 libegl-mesa0 libgl1-mesa-dri
 libosmesa6?"
window_packages="libglfw3-dev libimgui-dev libstb-dev fonts-dejavu-core"
images_packages="libopenimageio-dev libopenexr-dev libwebp-dev"
bench_packages="libboost-dev"
server_packages="libcpp-httplib-dev"
# What tools/package-portable needs besides.
portable_packages="patchelf xz-utils"
# What tools/package needs besides.
debian_packages="build-essential debhelper dpkg-dev fakeroot libegl-dev lintian python3-dev pybind11-dev python3-numpy dh-python
 appstream desktop-file-utils"
# What tools/package-python needs besides.
python_packages="python3-dev pybind11-dev python3-numpy python3-pip python3-setuptools python3-wheel libegl-dev twine
 patchelf libjpeg-dev libtiff-dev"
# What the tests need besides all of these.
test_packages="clang-19 libclang-rt-19-dev clang-format-19 clang-tidy-19 libgtest-dev libtinyobjloader-dev libpng-dev libegl-dev
 meson glslang-tools mesa-vulkan-drivers python3 python3-pil python3-yaml chromium? chromium-driver? imagemagick
 curl procps xvfb xauth x11-utils xdotool openbox libx11-dev libsdl2-dev shellcheck git python3-dev pybind11-dev python3-numpy python3-pytest python3-pip mypy
 node-typescript python3-venv python3-setuptools python3-wheel zsh fish mandoc vim neovim emacs-nox elpa-eglot? $portable_packages"

# ccache takes precompiled headers only with these.
export CCACHE_SLOPPINESS=pch_defines,time_macros

say() { printf 'glibra: %s\n' "$*" >&2; }

# package_of FILE: the package that has installed it. Its list may say /lib where the file is in /usr/lib.
package_of() (
    file=$(realpath "$1")
    dpkg -S "*${file#/usr}" | sed -n '1s/:.*//p'
)

# install_packages NAME...: installs those that are missing, and names them in one line.
install_packages() (
    if ! command -v dpkg-query >/dev/null; then
        say "this system has no dpkg, so nothing is installed; CONTRIBUTING.md lists what glibra needs"
        return
    fi
    missing=
    wanted=
    for package in "$@"; do
        [ "$(dpkg-query -W -f='${Status}' "${package%\?}" 2>/dev/null)" = "install ok installed" ] && continue
        case $package in
            *\?) wanted="$wanted ${package%\?}" ;;
            *) missing="$missing $package" ;;
        esac
    done
    known() { for each in $wanted; do ! apt-cache show "$each" >/dev/null 2>&1 || printf ' %s' "$each"; done; }
    [ -n "$missing$(known)" ] || return 0
    as_root=
    if [ "$(id -u)" != 0 ]; then
        command -v sudo >/dev/null || { say "cannot install packages without root or sudo; missing:$missing"; exit 4; }
        as_root=sudo
    fi
    say "installing$missing$(known)"
    log=$(mktemp)
    trap 'rm -f "$log"' EXIT
    # shellcheck disable=SC2046,SC2086
    if ! { $as_root apt-get update && $as_root env DEBIAN_FRONTEND=noninteractive \
           apt-get install -y --no-install-recommends $missing $(known); } >"$log" 2>&1 </dev/null; then
        cat "$log" >&2
        say "cannot install the packages (above: what apt-get printed)"
        exit 4
    fi
)

# configure PRESET OPTION...
configure() (
    preset=$1
    shift
    mkdir -p build
    say "configuring ($preset)"
    if ! cmake --preset "$preset" "$@" >"build/$preset.log" 2>&1; then
        cat "build/$preset.log" >&2
        say "cannot configure the build; CONTRIBUTING.md lists what glibra needs"
        exit 4
    fi
)

# expected FOLDER TARGET...: what is to be built there, and how long that took the last time: "41 steps, about 3 minutes".
expected() (
    expected_in=$1
    shift
    # Without the step that looks for new files, at which a dry run ends.
    sed '/^build build\.ninja:/,/^$/d' "$expected_in/build.ninja" >"$expected_in/dry.ninja"
    { cat "$expected_in/.ninja_log" 2>/dev/null || true; ninja -C "$expected_in" -f dry.ninja -n "$@"; } | awk -v jobs="$(nproc)" '
        NF == 5 && $2 ~ /^[0-9]+$/ { took[$4] = $2 - $1; next }
        /^\[[0-9]+\// { ++steps; seconds += ($NF in took ? took[$NF] : 10000) / 1000 }
        END {
            minutes = int(seconds / jobs / 60 + .5)
            about = minutes < 1 ? "less than a minute" : "about " minutes (minutes == 1 ? " minute" : " minutes")
            print steps ? steps (steps == 1 ? " step, " : " steps, ") about : "nothing new"
        }'
)

# build PRESET TARGET...: shows progress on standard error: ninja's line on a terminal, else a line per tenth. If the
# build fails, it prints the end of what the compiler printed.
build() (
    preset=$1
    shift
    build_folder=build/$preset
    [ "$preset" != test ] || build_folder=build/release  # as CMakePresets.json says
    say "building ($preset): $(expected "$build_folder" "$@")"
    if [ -t 2 ]; then
        NINJA_STATUS='glibra: building %p ' ninja -C "$build_folder" "$@" >&2 || exit 4
        return
    fi
    failed=$(mktemp)
    trap 'rm -f "$failed"' EXIT
    shown=0
    { NINJA_STATUS='@%p ' ninja -C "$build_folder" "$@" 2>&1 || echo failed >"$failed"; } | tee "build/$preset.log" |
        while IFS= read -r line; do  # awk may wait for more than a line
            case $line in "@"*"%"*) now=${line%%\%*} ;; *) continue ;; esac
            now=${now##*[@ ]}
            case $now in "" | *[!0-9]*) continue ;; esac
            [ "$now" -lt $((shown + 10)) ] || { shown=$((now - now % 10)); say "built $shown%"; }
        done
    if [ -s "$failed" ]; then
        tail -n 100 "build/$preset.log" >&2
        exit 4
    fi
)
