#pragma once
// Confines a process that reads files of strangers (Linux). Files are confined by Landlock, everything else
// by a seccomp filter that lets through only the system calls that drawing needs.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace glibra::base {

/// What a confined process can reach. Paths that do not exist are left out. A path that is a link stands for
/// its target; links inside of a folder lead nowhere else.
struct Sandbox {
    std::vector<std::filesystem::path> readable;  ///< files, and folders with all that is below
    std::vector<std::filesystem::path> writable;  ///< folders in which files can be made and replaced
    std::vector<std::filesystem::path> listable;  ///< folders whose names can be listed
    std::vector<std::filesystem::path> devices;   ///< devices that can be read, written and controlled
    bool standardOutput = false;                  ///< descriptor 1 stays what it is
};

/// Returns an empty text, or what this system lacks for a sandbox.
std::string missingForSandbox();

/// Confines this process for the rest of its life; it must have one thread. Afterwards it has the descriptors
/// `kept` and 0, 1 and 2, which are /dev/null. No program can be started, no process be signalled, traced or
/// forked, no socket be opened, no link be made, and no mode, owner or time of a file be changed. Landlock
/// does not hide whether a file exists. Returns an empty text, or what failed; then the process must not go
/// on.
std::string enterSandbox(const Sandbox& sandbox, std::span<const int> kept);

}  // namespace glibra::base
