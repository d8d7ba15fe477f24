#pragma once
// Programs of their own that a subcommand of glibra starts: glibra-view and glibra-bench. They are separate
// so that glibra neither links nor builds their libraries.

#include <string>
#include <vector>

namespace glibra::cli {

struct SisterProgram {
    const char* name;     ///< file name: "glibra-view"
    const char* missing;  ///< end of the error message if the file is missing: what to do instead
};

/// Replaces this process by the program, found beside glibra (in a build folder) or in lib/glibra
/// (installed). Returns only if that fails: prints one error line and returns kNoDriver.
int becomeProgram(const SisterProgram& program, const std::vector<std::string>& arguments);

}  // namespace glibra::cli
