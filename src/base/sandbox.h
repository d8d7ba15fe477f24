#pragma once
// Confines a process that reads files of strangers (Linux). Files are confined by Landlock, everything else
// by a seccomp filter that lets through only the system calls that drawing needs.

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace glibra::base {

/// A file or folder that a rule of a sandbox opens.
struct Reach {
    /// A path that the user, or this program, has named. It may be a link, or lead through links.
    Reach(std::filesystem::path named) : path(std::move(named)) {}
    Reach(const char* named) : path(named) {}
    /// A path below a folder that the user has named; only the way to `root` may lead through links. Whoever
    /// made the files below could otherwise put a link to any place where a rule will be made.
    Reach(std::filesystem::path above, std::filesystem::path below)
        : root(std::move(above)), path(std::move(below)) {}

    std::filesystem::path root{};  ///< empty for a path that was named
    std::filesystem::path path;    ///< relative to `root` if there is one

    [[nodiscard]] std::filesystem::path whole() const { return root.empty() ? path : root / path; }
    friend auto operator<=>(const Reach&, const Reach&) = default;
};

/// What a confined process can reach. Paths that do not exist, and those below a root that are links or lead
/// through some, are left out. Links inside of a folder lead nowhere else.
struct Sandbox {
    std::vector<Reach> readable;  ///< files, and folders with all that is below
    std::vector<Reach> writable;  ///< folders in which files can be made and replaced
    std::vector<Reach> listable;  ///< folders whose names can be listed
    std::vector<Reach> devices;   ///< devices that can be read, written and controlled
    bool standardOutput = false;  ///< descriptor 1 stays what it is
};

/// Returns an empty text, or what this system lacks for a sandbox.
std::string missingForSandbox();

/// Confines this process for the rest of its life; it must have one thread. Afterwards it has the descriptors
/// `kept` and 0, 1 and 2, which are /dev/null. No program can be started, no process be signalled, traced or
/// forked, no socket be opened, no link be made, no limit be raised, and no mode, owner or time of a file be
/// changed. A process of the superuser keeps of its rights only those to read and write files of others.
/// Landlock does not hide whether a file exists. Returns an empty text, or what failed; then the process must
/// not go on.
std::string enterSandbox(const Sandbox& sandbox, std::span<const int> kept);

}  // namespace glibra::base
