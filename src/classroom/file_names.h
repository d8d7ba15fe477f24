#pragma once
// Files and folders that are named after students.

#include <string>
#include <vector>

namespace glibra::classroom {

/// For each name a name of a file or folder that Linux, macOS and Windows accept. Where two would be one on a
/// disk that ignores upper and lower case, and where a name is hidden or that of a device, the number of the
/// submission, counted from 1, stands before it: "0012 ana".
std::vector<std::string> fileNames(std::vector<std::string> names);

}  // namespace glibra::classroom
