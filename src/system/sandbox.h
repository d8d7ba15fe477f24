#pragma once
// Confines a process that reads files of strangers. On Linux, files are confined by Landlock, everything else
// by a seccomp filter that lets through only the system calls that drawing needs; other systems may say that
// they cannot.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "system/process.h"

namespace glibra::system {

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

/// Bytes of one file that a confined process may write.
inline constexpr std::uint64_t kLargestWritten = std::uint64_t{1} << 30U;
/// Bytes that a confined worker (workers.h) may write for one piece, into all files.
inline constexpr std::uint64_t kMostWritten = std::uint64_t{4} << 30U;

/// Returns an empty text, or what this system lacks for a sandbox, in words.
std::string missingForSandbox();

/// Confines this process for the rest of its life; it must have one thread. Afterwards it has the files
/// `kept`, and standard input, output and error, which are the null device. No program can be started, no
/// process be signalled, traced or forked, no socket be opened, no link be made, no limit be raised, and no
/// mode, owner or time of a file be changed. A process of the superuser keeps of its rights only those to
/// read and write files of others. No memory can be shared with other processes or made as a file, so that
/// limits of memory hold, and no file can grow beyond kLargestWritten. Whether a file exists is not hidden.
/// Returns an empty text, or what failed; then the process must not go on.
std::string enterSandbox(const Sandbox& sandbox, std::span<const File* const> kept);

/// Adds what drivers of graphics cards open.
void addGraphicsDevices(Sandbox& sandbox);

/// What a confined process has done, so that its parent can end it: bytes that it has written, by calls or
/// through mapped files, and the time that the system has worked for it, as for each file that it makes, in
/// any unit. 0 if the system does not tell.
std::uint64_t bytesWrittenBy(const Process& process);
std::uint64_t systemWorkFor(const Process& process);

}  // namespace glibra::system
