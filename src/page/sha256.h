#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace glibra::page {

/// SHA-256 (FIPS 180-4), by which a Content-Security-Policy names the scripts that may run.
std::array<std::byte, 32> sha256(std::span<const std::byte> bytes);

}  // namespace glibra::page
