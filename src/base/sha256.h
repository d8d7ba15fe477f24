#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>

namespace glibra::base {

/// SHA-256 (FIPS 180-4): by it a Content-Security-Policy names the scripts that may run, and Git LFS the
/// content of a file.
std::array<std::byte, 32> sha256(std::span<const std::byte> bytes);
/// The same as 64 hexadecimal digits.
std::string sha256Text(std::span<const std::byte> bytes);

}  // namespace glibra::base
