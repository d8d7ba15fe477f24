#include "image/png/png_filter.h"

#include <algorithm>
#include <array>
#include <cstring>

// The compiler generates the loops below for several kinds of processor, and the loader chooses the best one.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__linux__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define GLIBRA_FOR_EACH_PROCESSOR [[gnu::target_clones("default", "avx2")]]
#else
#define GLIBRA_FOR_EACH_PROCESSOR
#endif

namespace glibra::image {
namespace {

// The loops below are written so that compilers vectorise them: no branches, at most 16 bits, no overlap of
// input and output.

GLIBRA_FOR_EACH_PROCESSOR
void subtractLeft(const std::uint8_t* row, std::size_t count, std::size_t pixel,
                  std::uint8_t* __restrict to) {
    std::copy_n(row, pixel, to);
    for (std::size_t i = pixel; i < count; ++i) to[i] = static_cast<std::uint8_t>(row[i] - row[i - pixel]);
}

GLIBRA_FOR_EACH_PROCESSOR
void subtractAbove(const std::uint8_t* row, const std::uint8_t* above, std::size_t count,
                   std::uint8_t* __restrict to) {
    for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<std::uint8_t>(row[i] - above[i]);
}

GLIBRA_FOR_EACH_PROCESSOR
void subtractPaeth(const std::uint8_t* row, const std::uint8_t* above, std::size_t count, std::size_t pixel,
                   std::uint8_t* __restrict to) {
    const auto magnitude = [](std::int16_t a) { return static_cast<std::int16_t>(a < 0 ? -a : a); };
    for (std::size_t i = 0; i < pixel; ++i) to[i] = static_cast<std::uint8_t>(row[i] - above[i]);
    for (std::size_t i = pixel; i < count; ++i) {
        const std::int16_t left = row[i - pixel], up = above[i], corner = above[i - pixel];
        const auto overLeft = static_cast<std::int16_t>(up - corner);
        const auto overUp = static_cast<std::int16_t>(left - corner);
        const std::int16_t toLeft = magnitude(overLeft), toUp = magnitude(overUp);
        const std::int16_t toCorner = magnitude(static_cast<std::int16_t>(overLeft + overUp));
        const std::int16_t second = toUp <= toCorner ? up : corner;
        const std::int16_t guess = toLeft <= std::min(toUp, toCorner) ? left : second;
        to[i] = static_cast<std::uint8_t>(row[i] - guess);
    }
}

/// The sum of the absolute values of signed bytes.
GLIBRA_FOR_EACH_PROCESSOR
std::uint64_t sumOfSizes(const std::uint8_t* bytes, std::size_t count) {
    constexpr std::size_t kLanes = 32;
    constexpr std::size_t kMostAdded = 511;  // this many values of at most 128 fit into 16 bits
    std::uint64_t sum = 0;
    const auto size = [](std::uint8_t a) { return std::min<std::uint8_t>(a, static_cast<std::uint8_t>(-a)); };
    std::size_t i = 0;
    while (i + kLanes <= count) {
        std::array<std::uint16_t, kLanes> sums{};
        const std::size_t rounds = std::min((count - i) / kLanes, kMostAdded);
        for (std::size_t round = 0; round < rounds; ++round, i += kLanes)
            for (std::size_t lane = 0; lane < kLanes; ++lane)
                sums[lane] = static_cast<std::uint16_t>(sums[lane] + size(bytes[i + lane]));
        for (const std::uint16_t each : sums) sum += each;
    }
    for (; i < count; ++i) sum += size(bytes[i]);
    return sum;
}

std::uint8_t number(PngFilter filter) {
    return static_cast<std::uint8_t>(filter);
}

}  // namespace

PngRowFilter::PngRowFilter(std::size_t rowBytes, std::size_t pixelBytes)
    : rowBytes_(rowBytes), pixelBytes_(pixelBytes), other_(rowBytes) {}

void PngRowFilter::writeBest(const std::uint8_t* row, const std::uint8_t* above, std::uint8_t* to) {
    std::uint8_t* best = to + 1;
    subtractAbove(row, above, rowBytes_, best);
    *to = number(PngFilter::up);
    std::uint64_t least = sumOfSizes(best, rowBytes_);
    const auto compare = [&](PngFilter filter) {
        const std::uint64_t sum = sumOfSizes(other_.data(), rowBytes_);
        if (sum >= least) return;
        least = sum;
        *to = number(filter);
        std::copy_n(other_.data(), rowBytes_, best);
    };
    if (least == 0) return;
    std::copy_n(row, rowBytes_, other_.data());
    compare(PngFilter::none);
    subtractLeft(row, rowBytes_, pixelBytes_, other_.data());
    compare(PngFilter::sub);
    subtractPaeth(row, above, rowBytes_, pixelBytes_, other_.data());
    compare(PngFilter::paeth);
}

void PngRowFilter::write(PngFilter filter, const std::uint8_t* row, const std::uint8_t* above,
                         std::uint8_t* to) const {
    *to++ = number(filter);
    switch (filter) {
        case PngFilter::none:
            std::copy_n(row, rowBytes_, to);
            return;
        case PngFilter::sub:
            return subtractLeft(row, rowBytes_, pixelBytes_, to);
        case PngFilter::up:
            return subtractAbove(row, above, rowBytes_, to);
        case PngFilter::paeth:
            return subtractPaeth(row, above, rowBytes_, pixelBytes_, to);
    }
}

}  // namespace glibra::image
