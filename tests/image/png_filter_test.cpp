// PNG's filters, reversed by the formulas of the specification, and the choice among them.

#include "image/png/png_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "support.h"

namespace glibra::image {
namespace {

using Row = std::vector<std::uint8_t>;

Row noisyRow(std::size_t count, std::uint32_t seed) {
    Row row(count);
    for (std::size_t i = 0; i < count; ++i)
        row[i] = static_cast<std::uint8_t>(testing::hash(seed + static_cast<std::uint32_t>(i)) >> 20U);
    return row;
}

/// The row that a reader reconstructs from a filtered row (PNG specification, 9.2).
Row unfiltered(const Row& filtered, const Row& above, std::size_t pixel) {
    Row row;
    for (std::size_t i = 0; i + 1 < filtered.size(); ++i) {
        const int left = i < pixel ? 0 : row[i - pixel], up = above[i],
                  corner = i < pixel ? 0 : above[i - pixel];
        const int initial = left + up - corner;
        const int toLeft = std::abs(initial - left), toUp = std::abs(initial - up),
                  toCorner = std::abs(initial - corner);
        int guess = 0;
        if (filtered[0] == 1) guess = left;
        if (filtered[0] == 2) guess = up;
        if (filtered[0] == 3) guess = (left + up) / 2;
        if (filtered[0] == 4)
            guess = toLeft <= toUp && toLeft <= toCorner ? left : toUp <= toCorner ? up : corner;
        row.push_back(static_cast<std::uint8_t>(filtered[i + 1] + guess));
    }
    return row;
}

TEST(PngRowFilter, EveryFilterIsUndoneByTheSpecificationsFormulas) {
    for (const std::size_t pixel : {1U, 2U, 3U, 4U, 6U, 8U})
        for (std::size_t pixels = 1; pixels < 90; pixels += 1 + pixels / 8) {
            const std::size_t count = pixel * pixels;
            const Row row = noisyRow(count, 1), above = noisyRow(count, 2);
            const PngRowFilter filter(count, pixel);
            for (const PngFilter each : {PngFilter::none, PngFilter::sub, PngFilter::up, PngFilter::paeth}) {
                Row to(count + 1);
                filter.write(each, row.data(), above.data(), to.data());
                EXPECT_EQ(to[0], static_cast<int>(each));
                EXPECT_EQ(unfiltered(to, above, pixel), row) << pixel << ' ' << pixels << ' ' << int{to[0]};
            }
        }
}

int bestOf(const Row& row, const Row& above) {
    PngRowFilter filter(row.size(), 1);
    Row to(row.size() + 1);
    filter.writeBest(row.data(), above.data(), to.data());
    EXPECT_EQ(unfiltered(to, above, 1), row);
    return to[0];
}

TEST(PngRowFilter, ChoosesTheFilterThatSuitsTheRow) {
    const Row zeros(64);
    Row ramp(64), slope(64), points(64), otherPoints(64);
    for (std::size_t x = 0; x < 64; ++x) {
        ramp[x] = static_cast<std::uint8_t>(3 * x);
        slope[x] = static_cast<std::uint8_t>(5 * x + 11);
        points[x] = x % 9 == 2 ? 40 : 0;
        otherPoints[x] = x % 7 == 3 ? 40 : 0;
    }
    EXPECT_EQ(bestOf(ramp, zeros), 1) << "sub: 3 a pixel";
    EXPECT_EQ(bestOf(slope, slope), 2) << "up: the row above again";
    EXPECT_EQ(bestOf(Row(64, 147), Row(64, 140)), 4) << "Paeth: 7 for the first pixel, then 0";
    EXPECT_EQ(bestOf(points, otherPoints), 0) << "none: every difference shows single points twice";
}

TEST(PngRowFilter, LeavesTheLeastSumOfDifferencesInRowsOfAnyLength) {
    for (const std::size_t count : {1U, 31U, 32U, 33U, 600U, 32 * 511U, 32 * 512 + 5U}) {
        const Row row = noisyRow(count, 3);
        Row above = row;
        for (std::size_t i = 0; i < count; ++i)
            above[i] = static_cast<std::uint8_t>(row[i] + testing::hash(static_cast<std::uint32_t>(i)) % 90);
        PngRowFilter filter(count, 1);
        const auto sum = [](const Row& filtered) {
            long all = 0;
            for (std::size_t i = 1; i < filtered.size(); ++i)
                all += std::abs(int{static_cast<std::int8_t>(filtered[i])});
            return all;
        };
        Row best(count + 1), to(count + 1);
        filter.writeBest(row.data(), above.data(), best.data());
        for (const PngFilter each : {PngFilter::none, PngFilter::sub, PngFilter::up, PngFilter::paeth}) {
            filter.write(each, row.data(), above.data(), to.data());
            EXPECT_LE(sum(best), sum(to)) << count << ' ' << int{to[0]};
        }
    }
}

}  // namespace
}  // namespace glibra::image
