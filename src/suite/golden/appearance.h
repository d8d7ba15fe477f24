#pragma once
// Pictures of a suite that somebody accepts by looking at them: goldens and masks.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

namespace glibra::suite {

/// suite-E32 if a browser may show another picture of the file than the one that is decoded: of a PNG file
/// for the reasons of image::shownOtherwise(), and of a file whose content is of another format than its name
/// says. `what` is "golden" or "mask".
std::optional<Diagnostic> shownOtherwise(std::string_view what, const std::filesystem::path& file,
                                         std::span<const std::byte> bytes, const Place& place);

}  // namespace glibra::suite
