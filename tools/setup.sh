# Sourced by tools/glibra and tools/test: installs what Debian 12 lacks, configures and builds.
# Sets nothing but functions; the caller has done `set -eu` and stands in the repository root.

# What building and running needs.
build_packages="g++ cmake ninja-build ccache pkg-config python3-glad libglm-dev libfmt-dev libcli11-dev
 nlohmann-json3-dev libtomlplusplus-dev libdeflate-dev libspng-dev libxxhash-dev libopenimageio-dev libegl1
 libegl-mesa0 libgl1-mesa-dri libosmesa6 libglfw3-dev libimgui-dev libstb-dev fonts-dejavu-core libboost-dev"
# What testing needs besides.
test_packages="libgtest-dev libtinyobjloader-dev libpng-dev libegl-dev glslang-tools clang-format clang-tidy python3
 chromium chromium-driver imagemagick procps xvfb xdotool openbox libx11-dev"

say() { printf 'glibra: %s\n' "$*" >&2; }

# install_packages NAME...: those that are missing, with one line that names them.
install_packages() {
    missing=
    for package in "$@"; do
        [ "$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null)" = "install ok installed" ] ||
            missing="$missing $package"
    done
    [ -n "$missing" ] || return 0
    root=
    if [ "$(id -u)" != 0 ]; then
        command -v sudo >/dev/null || { say "please install as root:$missing"; exit 4; }
        root=sudo
    fi
    say "installing$missing"
    log=$(mktemp)
    # shellcheck disable=SC2086
    if ! { $root apt-get update && $root env DEBIAN_FRONTEND=noninteractive \
           apt-get install -y --no-install-recommends $missing; } >"$log" 2>&1 </dev/null; then
        cat "$log" >&2
        rm -f "$log"
        say "could not install the packages"
        exit 4
    fi
    rm -f "$log"
}

# configure PRESET OPTION...: with the tests or without them, as the options say.
configure() {
    preset=$1
    shift
    mkdir -p build
    say "configuring ($preset)"
    cmake --preset "$preset" "$@" >"build/$preset.log" 2>&1 || { cat "build/$preset.log" >&2; exit 4; }
}

# build PRESET TARGET...: prints the compiler's output only if it fails.
build() {
    preset=$1
    shift
    say "building ($preset)"
    cmake --build "build/$preset" --target "$@" >"build/$preset.log" 2>&1 ||
        { tail -n 100 "build/$preset.log" >&2; exit 4; }
}
