#include "gpu/context/family.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.h"

namespace glibra::gpu {

std::string familyOf(std::string_view words) {
    // Layered drivers name the device below them too, so they come first; so do renderers in software, whose
    // processor may be named.
    using Row = std::pair<std::string_view, const char*>;
    constexpr std::array kFamilies{
        Row{"zink", "zink"},         Row{"d3d12", "d3d12"},   Row{"llvmpipe", "llvmpipe"},
        Row{"softpipe", "softpipe"}, Row{"nvidia", "nvidia"}, Row{"apple", "apple"},
        Row{"intel", "intel"},       Row{"amd", "amd"},       Row{"ati ", "amd"},
        Row{"radeon", "amd"},
    };
    const std::string all = base::lower(words);
    const auto* const found = std::ranges::find_if(
        kFamilies, [&](const Row& row) { return all.find(row.first) != std::string::npos; });
    return found == kFamilies.end() ? "other" : found->second;
}

}  // namespace glibra::gpu
