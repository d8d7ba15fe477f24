#pragma once
// The PNG of the floor and of the bare programs.

#include <cstdint>
#include <vector>

namespace bare {

/// Writes RGBA pixels, bottom row first, as opaque RGB; every row is the difference from the row above. False
/// if the file cannot be written.
bool writePng(const char* name, const std::vector<std::uint8_t>& pixels, std::size_t width,
              std::size_t height);

}  // namespace bare
