# Sourced by tools/package-windows and tools/test-windows, after tools/sources.sh: installs the cross-compiler, and builds the libraries for Windows
# from the sources of their Debian packages, into build/windows-libraries.
# shellcheck shell=sh disable=SC2034,SC2154

windows_packages="g++-mingw-w64-x86-64-posix libz-mingw-w64-dev dpkg-dev nasm"
windows_test_packages="wine64 xvfb xauth"
# Debian's sources of what is linked, besides minizip's, and the packages that consist of headers.
windows_sources="glfw3 imgui fmtlib libspng libdeflate xxhash cpp-httplib
 libjpeg-turbo libwebp tiff imath openexr"
windows_headers="libglm-dev nlohmann-json3-dev libcli11-dev libtomlplusplus-dev libstb-dev libboost-dev"

# windows_libraries: builds what build/windows-libraries lacks; made again when this file or the list of libraries changes.
windows_libraries() (
    folder=$root/build/windows-libraries
    stamp=$(cat "$root/tools/windows/setup.sh" "$root/tools/sources.sh" "$root/tools/cmake/libraries.cmake" "$root/tools/windows/libraries/CMakeLists.txt" \
                "$root/tools/cmake/windows.cmake" | sha256sum)
    [ "$(cat "$folder/stamp" 2>/dev/null)" != "$stamp" ] || return 0
    rm -rf "$folder" "$root/build/windows"  # headers have the times of their sources
    mkdir -p "$folder/sources"
    say "fetching the sources of the libraries for Windows"
    # shellcheck disable=SC2016,SC2086
    fetch_sources "$folder/sources" $windows_sources "$(dpkg-query -W -f '${source:Package}' libminizip-dev)"  # minizip or zlib
    # Headers that are the same on all systems, without those of this one beside them.
    mkdir -p "$folder/include" "$folder/share/cmake"
    for each in glm CLI nlohmann toml++ stb boost; do ln -s "/usr/include/$each" "$folder/include/$each"; done
    for each in glm nlohmann_json CLI11; do cp -r "/usr/share/cmake/$each" "$folder/share/cmake"; done
    install -D -m 644 /usr/x86_64-w64-mingw32/lib/libz.a "$folder/lib/libz.a"  # not the one beside it, of a DLL
    say "building the libraries for Windows"
    log=$folder/log
    if ! { cmake -S tools/windows/libraries -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
               -DCMAKE_TOOLCHAIN_FILE="$root/tools/cmake/windows.cmake" -DCMAKE_INSTALL_PREFIX="$folder" \
               -DCMAKE_INSTALL_LIBDIR=lib -DBUILD_SHARED_LIBS=OFF -DSOURCES="$folder/sources" &&
           ninja -C "$folder/build" install; } >"$log" 2>&1; then
        tail -n 40 "$log" >&2
        say "cannot build the libraries for Windows"
        exit 4
    fi
    blanks_for_pkg_config "$folder"
    printf '%s\n' "$stamp" >"$folder/stamp"
)

windows_programs="glibra_program glibra_window glibra_bench_program glibra_server glibra_openimageio glibra"
