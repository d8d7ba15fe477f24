#include "suite/golden/appearance.h"

#include <fmt/format.h>

#include <string>

#include "image/format.h"
#include "image/png/png_reader.h"

namespace glibra::suite {

std::optional<Diagnostic> shownOtherwise(std::string_view what, const std::filesystem::path& file,
                                         std::span<const std::byte> bytes, const Place& place) {
    const image::Format format = image::formatOf(bytes);
    std::string why;
    if (format != image::formatOfSuffix(file))
        why = fmt::format("by its content it is {}", image::describe(format));
    else if (format == image::Format::png)
        why = image::shownOtherwise(bytes);
    if (why.empty()) return std::nullopt;
    return diagnose(
        "suite-E32",
        fmt::format("the {} '{}' may be shown as another picture than the one that is compared: {}", what,
                    file.filename().string(), why),
        place);
}

}  // namespace glibra::suite
