// The noise functions, compared with a second implementation of language, 9 that adds corner by corner.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "noise/noise.h"
#include "noise/tables.h"

namespace glibra::noise {
namespace {

/// A counter-based hash, which gives the same points on every machine.
double unitAt(std::uint32_t index) {
    std::uint32_t h = index * 0x9e3779b9U + 0x85ebca6bU;
    h ^= h >> 16;
    h *= 0x7feb352dU;
    h ^= h >> 15;
    h *= 0x846ca68bU;
    h ^= h >> 16;
    return static_cast<double>(h) / 4294967296.0;
}

double powersN(int end, double t) {
    const double n0 = 1 - 10 * std::pow(t, 3) + 15 * std::pow(t, 4) - 6 * std::pow(t, 5);
    return end == 0 ? n0 : 1 - n0;
}
double powersG(int end, double t) {
    return end == 0 ? t - 6 * std::pow(t, 3) + 8 * std::pow(t, 4) - 3 * std::pow(t, 5)
                    : -4 * std::pow(t, 3) + 7 * std::pow(t, 4) - 3 * std::pow(t, 5);
}
int modulo(int a, int n) {
    return ((a % n) + n) % n;
}

double plain3(double x, double y, double z, int octave) {
    const auto& table = tables::kOctaves3[static_cast<std::size_t>(octave)];
    const int n = table.cells;
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y)),
              k = static_cast<int>(std::floor(z));
    double value = .5;
    for (int corner = 0; corner < 8; ++corner) {
        const int a = corner & 1, b = corner >> 1 & 1, c = corner >> 2;
        const int inner = table.q[static_cast<std::size_t>(modulo(k + c, n))];
        const int outer = table.p[static_cast<std::size_t>(modulo(modulo(j + b, n) + inner, n))];
        const auto& g = table.gradients[static_cast<std::size_t>(modulo(modulo(i + a, n) + outer, n))];
        const double u = x - i, v = y - j, w = z - k;
        value += g[0] * powersG(a, u) * powersN(b, v) * powersN(c, w);
        value += g[1] * powersN(a, u) * powersG(b, v) * powersN(c, w);
        value += g[2] * powersN(a, u) * powersN(b, v) * powersG(c, w);
    }
    return value;
}

double plain2(double x, double y, int octave) {
    const auto& table = tables::kOctaves2[static_cast<std::size_t>(octave)];
    const int n = table.cells;
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
    double value = .5;
    for (int corner = 0; corner < 4; ++corner) {
        const int a = corner & 1, b = corner >> 1;
        const int row = table.p[static_cast<std::size_t>(modulo(j + b, n))];
        const auto& g = table.gradients[static_cast<std::size_t>(modulo(i + a + row, n))];
        value += g[0] * powersG(a, x - i) * powersN(b, y - j) + g[1] * powersN(a, x - i) * powersG(b, y - j);
    }
    return value;
}

TEST(NoiseFunction, EqualsTheSumOverCornersIn3D) {
    for (int octave = 0; octave < kOctaves; ++octave)
        for (std::uint32_t at = 0; at < 3000; at += 3) {
            const double x = 80 * unitAt(at) - 40, y = 80 * unitAt(at + 1) - 40, z = 80 * unitAt(at + 2) - 40;
            EXPECT_NEAR(noise3(x, y, z, octave), plain3(x, y, z, octave), 1e-13);
        }
}

TEST(NoiseFunction, EqualsTheSumOverCornersIn2D) {
    for (int octave = 0; octave < kOctaves; ++octave)
        for (std::uint32_t at = 0; at < 2000; at += 2) {
            const double x = 80 * unitAt(at) - 40, y = 80 * unitAt(at + 1) - 40;
            EXPECT_NEAR(noise2(x, y, octave), plain2(x, y, octave), 1e-13);
        }
}

TEST(NoiseFunction, IsExactlyOneHalfAtLatticePoints) {
    for (int octave = 0; octave < kOctaves; ++octave)
        for (int at = -40; at <= 40; ++at) {
            EXPECT_EQ(noise3(at, at + 3, -at, octave), .5);
            EXPECT_EQ(noise2(at, 7 - at, octave), .5);
        }
}

TEST(NoiseFunction, RepeatsExactlyAfterOnePeriod) {
    for (int octave = 0; octave < kOctaves; ++octave) {
        const double period = cellsOf(octave);
        for (int at = 0; at < 200; ++at) {
            const double x = at * .171875, y = at * .421875,
                         z = at * .296875;  // binary fractions: adding is exact
            const double value = noise3(x, y, z, octave);
            EXPECT_EQ(value, noise3(x + period, y, z, octave));
            EXPECT_EQ(value, noise3(x, y - 2 * period, z, octave));
            EXPECT_EQ(value, noise3(x, y, z + 3 * period, octave));
            EXPECT_EQ(noise2(x, y, octave), noise2(x - period, y + period, octave));
        }
    }
}

TEST(NoiseFunction, IsSmoothAcrossCellBorders) {
    // Value and slope agree on both sides of a lattice plane. The step is much larger than rounding errors
    // and much smaller than a cell.
    constexpr double h = 1e-6;
    for (int octave = 0; octave < kOctaves; ++octave)
        for (int at = 0; at < 50; ++at) {
            const double y = at * .37, z = at * .59;
            const double left = (noise3(3, y, z, octave) - noise3(3 - h, y, z, octave)) / h;
            const double right = (noise3(3 + h, y, z, octave) - noise3(3, y, z, octave)) / h;
            EXPECT_NEAR(left, right, 1e-5);
        }
}

TEST(NoiseFunction, HasTheTablesGradientAtALatticePoint) {
    // At lattice point (0, 0, 0) the tables give gradient number (0 + P[Q[0]]) = P[0] = 0.
    constexpr double h = 1e-6;
    for (int octave = 0; octave < kOctaves; ++octave) {
        const auto& g = tables::kOctaves3[static_cast<std::size_t>(octave)].gradients[0];
        EXPECT_NEAR((noise3(h, 0, 0, octave) - noise3(-h, 0, 0, octave)) / (2 * h), g[0], 1e-9);
        EXPECT_NEAR((noise3(0, h, 0, octave) - noise3(0, -h, 0, octave)) / (2 * h), g[1], 1e-9);
        EXPECT_NEAR((noise3(0, 0, h, octave) - noise3(0, 0, -h, octave)) / (2 * h), g[2], 1e-9);
    }
}

TEST(NoiseFunction, PermutationsHoldEveryNumberOnce) {
    for (const auto& table : tables::kOctaves3) {
        ASSERT_EQ(table.gradients.size(), static_cast<std::size_t>(table.cells));
        for (const auto& permutation : {table.p, table.q}) {
            std::vector<int> seen(static_cast<std::size_t>(table.cells));
            for (const std::uint8_t each : permutation) ++seen.at(each);
            EXPECT_EQ(seen, std::vector<int>(static_cast<std::size_t>(table.cells), 1));
        }
    }
}

TEST(NoiseFunction, IsOneHalfWhereACoordinateIsNotFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(noise3(nan, 0, 0, 0), .5);
    EXPECT_EQ(noise3(.3, infinity, .2, 1), .5);
    EXPECT_EQ(noise2(.3, -infinity, 2), .5);
    EXPECT_EQ(noise3(1e300, -1e300, .25, 3),
              noise3(0, 0, .25, 3));  // all doubles of this size are lattice points
}

}  // namespace
}  // namespace glibra::noise
