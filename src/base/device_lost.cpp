#include "base/device_lost.h"

#include <fmt/format.h>

namespace glibra::base {

std::string whileDrawn(const DeviceLost& lost) {
    if (lost.place.file.empty()) return {};
    if (lost.lastLine <= lost.place.line) return fmt::format(" while line {} was drawn", lost.place.line);
    return fmt::format(" while lines {} to {} were drawn", lost.place.line, lost.lastLine);
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
