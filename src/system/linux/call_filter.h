#pragma once
// A seccomp filter: the system calls that a process can make (seccomp(2)).

#include <string>

namespace glibra::system {

/// Returns an empty text, or why there are no filters of system calls.
std::string missingCallFilter();

/// Lets this process make only the system calls that reading files, drawing with a driver, threads and
/// writing files need; other calls fail with ENOSYS, and ioctl, fcntl and open with forbidden arguments with
/// EPERM. The process must have one thread and no_new_privs. Returns an empty text, or what failed.
std::string filterCalls();

}  // namespace glibra::system
