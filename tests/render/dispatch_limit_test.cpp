// What a driver leaves undone of a dispatch is reported.

#include <gtest/gtest.h>

#include <vector>

#include "render/draw/work_share.h"

namespace glibra::render {
namespace {

TEST(DispatchLimit, SoftwareDriversCountTheGroupsOfAllAxesTogether) {
    gpu::Capabilities driver;
    driver.maxComputeGroups = {65535, 65535, 65535};
    const std::vector<std::uint64_t> counts{0, 1, 2, 3, 1290, 1291, 32767, 32768, 32769, 65535, 65536};
    int reported = 0;
    for (const bool isSoftware : {false, true})
        for (const std::uint64_t x : counts)
            for (const std::uint64_t y : counts)
                for (const std::uint64_t z : counts) {
                    driver.isSoftware = isSoftware;
                    const auto checked = checkedGroups({x, y, z}, driver, {"a.glib", 3, 1});
                    if (x > 65535 || y > 65535 || z > 65535) {
                        ASSERT_FALSE(checked);
                        EXPECT_EQ(checked.diagnostics.front().id, "memory-E06");
                        continue;
                    }
                    ASSERT_TRUE(checked);
                    EXPECT_EQ(*checked,
                              (std::array<unsigned, 3>{static_cast<unsigned>(x), static_cast<unsigned>(y),
                                                       static_cast<unsigned>(z)}));
                    const bool isTooMany = static_cast<long double>(x) * y * z > 2147483647.L;
                    EXPECT_EQ(!checked.diagnostics.empty(), isSoftware && isTooMany)
                        << x << " " << y << " " << z;
                    if (!checked.diagnostics.empty()) {
                        EXPECT_EQ(checked.diagnostics.front().id, "draw-W18");
                        EXPECT_EQ(checked.diagnostics.front().place.line, 3);
                        ++reported;
                    }
                }
    EXPECT_GT(reported, 100);
}

}  // namespace
}  // namespace glibra::render
