#include "gpu/context/hardware.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/text.h"
#include "system/places.h"

namespace glibra::gpu {
namespace {

namespace fs = std::filesystem;

/// True if the variable holds what Mesa reads as yes, in upper or lower case.
bool mesaMustUseSoftware() {
    const char* value = std::getenv("LIBGL_ALWAYS_SOFTWARE");
    const std::string word = base::lower(value ? value : "");
    constexpr std::array<std::string_view, 4> kYes{"1", "true", "y", "yes"};
    return std::ranges::find(kYes, word) != kYes.end();
}

}  // namespace

bool mayUseHardware(Driver driver, const fs::path& devices) {
    if (driver == Driver::osmesa) return false;
    const system::GraphicsCard card = system::graphicsCard(devices);
    if (card == system::GraphicsCard::ownDriver) return true;
    return card == system::GraphicsCard::mesa && !mesaMustUseSoftware();
}

int usualWorkers(Driver driver, std::size_t pieces, int processors, const fs::path& devices) {
    if (processors <= 1 || !mayUseHardware(driver, devices)) return std::max(1, processors);
    // n workers take n contexts and pieces / n scenes, which is least where both take as long.
    constexpr double kScenesPerContext = 4;
    constexpr double kMost = 4;  // as measured: 131 scenes take 3.0 s with 1, 1.03 with 4, 1.57 with 16
    const double best = std::round(std::sqrt(static_cast<double>(pieces) / kScenesPerContext));
    return static_cast<int>(std::clamp(best, 1., std::min<double>(kMost, processors)));
}

}  // namespace glibra::gpu
