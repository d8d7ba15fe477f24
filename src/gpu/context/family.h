#pragma once
// One word for drivers that draw alike.

#include <string>
#include <string_view>

namespace glibra::gpu {

/// "llvmpipe", "softpipe", "zink", "d3d12", "nvidia", "apple", "intel", "amd" or "other", from what a driver
/// says of itself: its vendor and renderer, in any order and with other words.
std::string familyOf(std::string_view words);

}  // namespace glibra::gpu
