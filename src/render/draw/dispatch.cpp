#include "render/draw/dispatch.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace glibra::render {

std::string lackOfCompute(const gpu::Capabilities& driver) {
    if (driver.compute) return {};
    return fmt::format("OpenGL 4.3; this one has {}.{}", driver.major, driver.minor);
}

Result<std::array<unsigned, 3>> checkedGroups(const GroupCounts& groups, const gpu::Capabilities& driver,
                                              const Place& place) {
    std::array<unsigned, 3> checked{};
    constexpr const char* kAxes = "xyz";
    for (std::size_t axis = 0; axis < groups.size(); ++axis) {
        const auto most = static_cast<std::uint64_t>(std::max(0, driver.maxComputeGroups[axis]));
        if (groups[axis] > most)
            return diagnose("memory-E06",
                            fmt::format("Dispatch: {} groups along {}; this driver allows {}",
                                        base::groupedText(static_cast<long long>(
                                            std::min<std::uint64_t>(groups[axis], std::uint64_t{1} << 62))),
                                        kAxes[axis], base::groupedText(most)),
                            place);
        checked[axis] = static_cast<unsigned>(groups[axis]);
    }
    if (!driver.isSoftware) return checked;
    // llvmpipe: lp_cs_tpool_queue_task() takes an int.
    constexpr std::uint64_t kMostOfSoftware = (std::uint64_t{1} << 31) - 1;
    const std::uint64_t all = groups[0] * groups[1] * groups[2];  // each count has 16 bits there
    if (all <= kMostOfSoftware) return checked;
    return {
        checked,
        {diagnose("draw-W18",
                  fmt::format("Dispatch: {} groups in all; this driver counts at most {}, and may not run "
                              "the others; dispatch fewer groups, or divide them with tiles",
                              base::groupedText(all), base::groupedText(kMostOfSoftware)),
                  place)}};
}

}  // namespace glibra::render
