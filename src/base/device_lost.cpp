#include "base/device_lost.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

namespace glibra::base {

std::string whileDrawn(const DeviceLost& lost) {
    if (lost.place.file.empty()) return {};
    if (lost.lastLine <= lost.place.line) return fmt::format(" while line {} was drawn", lost.place.line);
    return fmt::format(" while lines {} to {} were drawn", lost.place.line, lost.lastLine);
}

std::string toText(const DeviceLost& lost) {
    return fmt::format("{} {} {} {} {}", static_cast<int>(lost.cause), lost.place.line, lost.place.column,
                       lost.lastLine, lost.place.file);
}

std::optional<DeviceLost> parseDeviceLost(std::string_view text) {
    std::array<int, 4> numbers{};
    for (int& each : numbers) {
        const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), each);
        if (failure != std::errc{} || end == text.data() + text.size() || *end != ' ') return std::nullopt;
        text.remove_prefix(static_cast<std::size_t>(end - text.data()) + 1);
    }
    if (numbers[0] < 0 || numbers[0] > static_cast<int>(ResetCause::unknown)) return std::nullopt;
    DeviceLost lost;
    lost.cause = static_cast<ResetCause>(numbers[0]);
    lost.place = {std::string(text), numbers[1], numbers[2]};
    lost.lastLine = numbers[3];
    return lost;
}

Diagnostic diagnosticOf(const DeviceLost& lost, const std::string& scene) {
    const Place place = lost.place.file.empty() ? Place{scene, 1, 1} : lost.place;
    if (lost.cause == ResetCause::other)
        return diagnose("gpu-E07",
                        "another program made the graphics driver reset the device, again and again; the "
                        "scene is not to blame, but there is no picture of it",
                        place);
    return diagnose(
        "gpu-E06",
        fmt::format("the graphics driver reset the device{}: a shader ran for too long or reached "
                    "memory that is not its own; bound its loops, or cut the work ('Dispatch ... "
                    "tiles', --tile, smaller draws)",
                    whileDrawn(lost)),
        place);
}

}  // namespace glibra::base
