# Sourced by tools/glibra and tools/test-web, after tools/setup.sh and tools/sources.sh: installs clang's WebAssembly parts, and builds the libraries of the runtime of live
# pages from the sources of their Debian packages, into build/web-libraries.
# shellcheck shell=sh disable=SC2034,SC2154

web_packages="clang-19 lld-19 llvm-19 libc++-19-dev-wasm32 libc++abi-19-dev-wasm32 libclang-rt-19-dev-wasm32 wasi-libc
 libfast-float-dev dpkg-dev binaryen"
web_sources="fmtlib libspng libdeflate xxhash zlib"

# web_libraries: builds what build/web-libraries lacks; made again when one of its own files changes.
web_libraries() (
    web_folder=$root/build/web-libraries
    stamp=$(cat "$root/tools/web/setup.sh" "$root/tools/sources.sh" "$root/tools/web/libraries/CMakeLists.txt" \
                "$root/tools/cmake/libraries.cmake" "$root/tools/cmake/web.cmake" | sha256sum)
    [ "$(cat "$web_folder/stamp" 2>/dev/null)" != "$stamp" ] || return 0
    rm -rf "$web_folder" "$root/build/web"
    mkdir -p "$web_folder/sources"
    say "fetching the sources of the libraries of live pages"
    # shellcheck disable=SC2086
    fetch_sources "$web_folder/sources" $web_sources
    # Headers that are the same on all systems, without those of this one beside them.
    mkdir -p "$web_folder/include" "$web_folder/share/cmake"
    for each in glm nlohmann fast_float; do ln -s "/usr/include/$each" "$web_folder/include/$each"; done
    for each in glm nlohmann_json; do cp -r "/usr/share/cmake/$each" "$web_folder/share/cmake"; done
    say "building the libraries of live pages"
    log=$web_folder/log
    if ! { cmake -S tools/web/libraries -B "$web_folder/build" -G Ninja -DCMAKE_BUILD_TYPE=MinSizeRel \
               -DCMAKE_TOOLCHAIN_FILE="$root/tools/cmake/web.cmake" -DCMAKE_INSTALL_PREFIX="$web_folder" \
               -DCMAKE_INSTALL_LIBDIR=lib -DBUILD_SHARED_LIBS=OFF -DSOURCES="$web_folder/sources" &&
           ninja -C "$web_folder/build" install; } >"$log" 2>&1; then
        tail -n 40 "$log" >&2
        say "cannot build the libraries of live pages"
        exit 4
    fi
    blanks_for_pkg_config "$web_folder"
    printf '%s\n' "$stamp" >"$web_folder/stamp"
)

# web_runtime: builds build/web/glibra.wasm.
web_runtime() (
    web_libraries
    configure web
    build web glibra_page_runtime
)
