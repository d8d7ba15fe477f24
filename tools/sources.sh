# Sourced: fetches the sources of Debian packages, for libraries that are built for other systems.
# shellcheck shell=sh

# fetch_sources FOLDER PACKAGE...: unpacks source packages of this Debian, with Debian's changes: of each the newest version
# whose files are all there. A mirror may list an update whose files it has not yet, or no longer. Of a package whose changes it
# lacks in all versions, the authors' own archive is taken. Ends with status 69 if a mirror lacks that, too.
fetch_sources() (
    fetched=$1
    shift
    mkdir -p "$fetched/apt/lists/partial" "$fetched/apt/cache/archives/partial"
    for each in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
        [ ! -f "$each" ] || sed -n 's/^deb /deb-src /p' "$each"
    done >"$fetched/apt/one.list"
    for each in /etc/apt/sources.list.d/*.sources; do
        [ ! -f "$each" ] || { sed 's/^Types:.*/Types: deb-src/' "$each"; echo; }
    done >"$fetched/apt/two.sources"
    mkdir -p "$fetched/apt/parts"
    cp "$fetched/apt/one.list" "$fetched/apt/two.sources" "$fetched/apt/parts"
    export APT_CONFIG="$fetched/apt/apt.conf"
    cat >"$APT_CONFIG" <<END
Dir::Etc::SourceList "/dev/null";
Dir::Etc::SourceParts "$fetched/apt/parts";
Dir::State::Lists "$fetched/apt/lists";
Dir::Cache "$fetched/apt/cache";
APT::Sandbox::User "";
Acquire::Retries "2";
END
    log=$fetched/apt/log
    cd "$fetched" || exit
    apt-get update >"$log" 2>&1 || true  # without a source of somebody else, too
    for package in "$@"; do
        found=false
        for version in $(apt-cache showsrc --only-source "$package" 2>>"$log" | sed -n 's/^Version: //p' | sort -urV); do
            rm -f ./*.dsc
            if { apt-get source --download-only --only-source "$package=$version" && dpkg-source --no-check -x ./*.dsc; } \
                   >>"$log" 2>&1; then
                found=true
                break
            fi
        done
        $found && continue
        apt-get source --download-only --tar-only --only-source "$package" >>"$log" 2>&1 || true
        for archive in "$package"_*.orig.tar.?z; do
            [ -f "$archive" ] || { cat "$log" >&2; say "cannot fetch the source of $package (above: what apt-get printed)"; exit 69; }
            version=${archive#*_}
            mkdir "$package-${version%.orig.*}"
            tar -x -C "$package-${version%.orig.*}" --strip-components=1 -f "$archive"
        done
        say "the mirror lacks Debian's changes to $package: it is built without them"
    done
)

# blanks_for_pkg_config FOLDER: where pkg-config reads of the libraries there, the folder gets a backslash before each blank.
blanks_for_pkg_config() (
    python3 -c 'import pathlib, sys
folder = sys.argv[1]
for each in pathlib.Path(folder, "lib/pkgconfig").glob("*.pc"):
    each.write_text(each.read_text().replace(folder, folder.replace(" ", "\\ ")))' "$1"
)
