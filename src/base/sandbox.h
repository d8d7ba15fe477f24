#pragma once
// Confines a process that reads files of strangers (Linux). Files are confined by Landlock, everything else
// by a seccomp filter that lets through only the system calls that drawing needs.

#include <cstdint>
#include <span>
#include <string>

#include "base/reach.h"

namespace glibra::base {

/// Bytes of one file that a confined process may write.
inline constexpr std::uint64_t kLargestWritten = std::uint64_t{1} << 30U;
/// Bytes that a confined worker (workers.h) may write for one piece, into all files.
inline constexpr std::uint64_t kMostWritten = std::uint64_t{4} << 30U;

/// Returns an empty text, or what this system lacks for a sandbox.
std::string missingForSandbox();

/// Confines this process for the rest of its life; it must have one thread. Afterwards it has the descriptors
/// `kept` and 0, 1 and 2, which are /dev/null. No program can be started, no process be signalled, traced or
/// forked, no socket be opened, no link be made, no limit be raised, and no mode, owner or time of a file be
/// changed. A process of the superuser keeps of its rights only those to read and write files of others.
/// No memory can be shared with other processes or made as a file, so that limits of memory hold, and no file
/// can grow beyond kLargestWritten. Landlock does not hide whether a file exists. Returns an empty text, or
/// what failed; then the process must not go on.
std::string enterSandbox(const Sandbox& sandbox, std::span<const int> kept);

}  // namespace glibra::base
