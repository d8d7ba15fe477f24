#pragma once
// Landlock: the files that a process can open (landlock(7)).

#include <string>

#include "system/sandbox.h"

namespace glibra::system {

/// Returns an empty text, or why there is no Landlock.
std::string missingLandlock();

/// Confines this thread, and those that it will start, to the files of the sandbox. Returns an empty text, or
/// what failed. The process must have no_new_privs.
std::string confineFiles(const Sandbox& sandbox);

}  // namespace glibra::system
