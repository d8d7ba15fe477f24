#pragma once
// Files that the teacher names on the command line.

#include <glibra/result.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace glibra::classroom {

/// The content of a file, or of a pipe, as in --rubric <(...): it is the user's own, so waiting for it does
/// no harm. The errors of image::readFile.
Result<std::string> givenText(const std::filesystem::path& file, std::uint64_t largest);

}  // namespace glibra::classroom
