#pragma once

#include <cstdint>

namespace glibra::base {

/// A test of a new value against the stored one: `less` passes if the new value is less.
enum class Comparison : std::uint8_t { never, less, lequal, equal, gequal, greater, notequal, always };

}  // namespace glibra::base
