#pragma once

#include <glibra/diagnostic.h>

#include <cstddef>
#include <filesystem>
#include <span>

namespace glibra::suite {

/// Writes a file below a folder (base::writeBeneath). Returns nothing, or one file-E10.
Diagnostics writeBelow(const std::filesystem::path& folder, const std::filesystem::path& name,
                       std::span<const std::byte> bytes);
/// The file-E10 for a file that the system has not written.
Diagnostic cannotWrite(const std::filesystem::path& file, int problem);

}  // namespace glibra::suite
