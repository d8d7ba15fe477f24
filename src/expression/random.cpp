#include "expression/random.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "base/hash.h"

namespace glibra::expression {
namespace {

std::optional<std::uint64_t> wholeNumber(double value) {
    constexpr double kBound = 0x1p63;
    if (!(value > -kBound && value < kBound)) return std::nullopt;
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(value));
}

/// The scalar product of an offset with the gradient that the hash chooses.
double slope(std::uint64_t hash, const double* offset, int dimensions) {
    if (dimensions == 1) {
        // A slope in -1..1.
        const auto signedHash = static_cast<std::int64_t>(hash);
        return static_cast<double>(signedHash >> 11U) * 0x1p-52 * offset[0];
    }
    if (dimensions == 2) {
        // Eight directions of length 1.
        constexpr double kDiagonal = 0.70710678118654752440;
        const std::uint64_t direction = hash >> 61U;
        const bool first = (direction & 1U) != 0;
        const bool second = (direction & 2U) != 0;
        if ((direction & 4U) != 0)
            return kDiagonal * ((first ? -offset[0] : offset[0]) + (second ? -offset[1] : offset[1]));
        const double along = first ? offset[0] : offset[1];
        return second ? -along : along;
    }
    // The directions to the middles of the twelve edges of a cube, four of them twice.
    const std::uint64_t edge = hash >> 60U;
    const double u = edge < 8 ? offset[0] : offset[1];
    const double v = edge < 4 ? offset[1] : (edge == 12 || edge == 14 ? offset[0] : offset[2]);
    return ((edge & 1U) != 0 ? -u : u) + ((edge & 2U) != 0 ? -v : v);
}

double fade(double t) {
    return t * t * t * (t * (t * 6 - 15) + 10);
}

/// Brings the largest absolute value to 1 or a little less.
constexpr std::array<double, 3> kScale{2, 1.41421356237309504880, 0.96};

}  // namespace

std::optional<double> random(double i, double seed) {
    const auto index = wholeNumber(i);
    const auto first = wholeNumber(seed);
    if (!index || !first) return std::nullopt;
    const std::uint64_t hash =
        base::splitMixed(base::splitMixed(*first + base::kGolden) + *index * base::kGolden);
    return static_cast<double>(hash >> 11U) * 0x1p-53;
}

double gradientNoise(const double* point, int dimensions) {
    constexpr double kLargest = 0x1p52;  // from here on all numbers are whole
    const auto count = static_cast<std::size_t>(dimensions);
    std::array<std::uint64_t, 3> cell{};
    std::array<double, 3> inside{}, weight{};
    for (std::size_t k = 0; k < count; ++k) {
        if (!(std::abs(point[k]) < kLargest)) return 0;
        const double low = std::floor(point[k]);
        cell[k] = static_cast<std::uint64_t>(static_cast<std::int64_t>(low));
        inside[k] = point[k] - low;
        weight[k] = fade(inside[k]);
    }
    // The corners in the order of their bits, then averaged along x, y, z.
    std::array<double, 8> corner{};
    const std::size_t corners = std::size_t{1} << count;
    for (std::size_t c = 0; c < corners; ++c) {
        std::uint64_t hash = count;
        std::array<double, 3> offset{};
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t side = (c >> k) & 1U;
            hash = base::splitMixed(hash + base::kGolden + cell[k] + side);
            offset[k] = inside[k] - static_cast<double>(side);
        }
        corner[c] = slope(hash, offset.data(), dimensions);
    }
    for (std::size_t k = 0; k < count; ++k)
        for (std::size_t c = 0; c < corners >> (k + 1); ++c)
            corner[c] = corner[2 * c] + weight[k] * (corner[2 * c + 1] - corner[2 * c]);
    return kScale[count - 1] * corner[0] + 0.0;
}

}  // namespace glibra::expression
