#pragma once
// What a confined process can reach: the value that Landlock (base/landlock.h) and the sandbox take.

#include <filesystem>
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

}  // namespace glibra::base
