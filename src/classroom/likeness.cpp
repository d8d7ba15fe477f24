#include "classroom/likeness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <numbers>
#include <vector>

namespace glibra::classroom {
namespace {

using Color = std::array<float, 3>;

constexpr int kSide = 128;    // pixels of the longer side of what is compared
constexpr int kScales = 4;    // each half as large as the one before
constexpr int kCompared = 3;  // in the last one, shading looks like an edge
constexpr int kTurns = 12;    // directions of edges in half a turn
constexpr float kBackground = 6.0F / 255;
/// An edge between two colours has about 1 per pixel, where colours have the deviation 1; shading that goes
/// over the whole object has at most 0.25.
constexpr float kEdge = 0.5F;
constexpr float kShading = 0.15F;  // what the correlation of edges leaves out

/// Colours, row by row, top row first.
struct Colors {
    int width = 0, height = 0;
    std::vector<Color> at;
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] const Color& pixel(int x, int y) const { return at[index(x, y)]; }
};

float component(const image::Image& image, const std::byte* at) {
    switch (image.type) {
        case image::Component::u8:
            return static_cast<float>(std::to_integer<int>(*at)) / 255;
        case image::Component::u16: {
            std::uint16_t value = 0;
            std::memcpy(&value, at, sizeof value);
            return static_cast<float>(value) / 65535;
        }
        case image::Component::f32:
            break;
    }
    float value = 0;
    std::memcpy(&value, at, sizeof value);
    return std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 0;
}

Colors colorsOf(const image::Image& image) {
    Colors colors{image.width, image.height, {}};
    colors.at.reserve(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    const std::size_t bytes = image::bytesOf(image.type);
    for (int y = 0; y < image.height; ++y) {
        const std::byte* at = image.row(y).data();
        for (int x = 0; x < image.width; ++x, at += bytes * static_cast<std::size_t>(image.components)) {
            Color color{};
            for (std::size_t i = 0; i < 3; ++i)
                color[i] = component(image, at + (image.components < 3 ? 0 : i) * bytes);
            colors.at.push_back(color);
        }
    }
    return colors;
}

float colorDistance(const Color& a, const Color& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// The most frequent colour of the pixels at the border.
Color backgroundOf(const Colors& colors) {
    std::map<std::array<int, 3>, std::pair<int, Color>> counts;
    const auto count = [&](int x, int y) {
        const Color& color = colors.pixel(x, y);
        std::array<int, 3> key{};
        for (std::size_t i = 0; i < 3; ++i) key[i] = static_cast<int>(color[i] * 63.5F);
        auto& [number, first] = counts[key];
        if (number++ == 0) first = color;
    };
    for (int x = 0; x < colors.width; ++x) {
        count(x, 0);
        count(x, colors.height - 1);
    }
    for (int y = 0; y < colors.height; ++y) {
        count(0, y);
        count(colors.width - 1, y);
    }
    return std::max_element(counts.begin(), counts.end(),
                            [](const auto& a, const auto& b) { return a.second.first < b.second.first; })
        ->second.second;
}

/// Adds gaps between parts of an object: pixels between two of its pixels in the row and in the column that
/// are near to each other. A shader that discards its dots leaves such.
void closeGaps(const Colors& colors, std::vector<char>& isObject) {
    int left = colors.width, right = -1, top = colors.height, bottom = -1;
    for (int y = 0; y < colors.height; ++y)
        for (int x = 0; x < colors.width; ++x) {
            if (isObject[colors.index(x, y)] == 0) continue;
            left = std::min(left, x);
            right = std::max(right, x);
            top = std::min(top, y);
            bottom = std::max(bottom, y);
        }
    const int nearby = std::max(right - left, bottom - top) * 3 / 10;
    std::vector<char> between(isObject.size(), 0);
    const auto scan = [&](int lines, int length, const auto& index) {
        for (int line = 0; line < lines; ++line) {
            int last = -1;
            for (int i = 0; i < length; ++i) {
                if (isObject[index(line, i)] == 0) continue;
                if (last >= 0 && i - last <= nearby)
                    for (int gap = last + 1; gap < i; ++gap) ++between[index(line, gap)];
                last = i;
            }
        }
    };
    scan(colors.height, colors.width, [&](int line, int i) { return colors.index(i, line); });
    scan(colors.width, colors.height, [&](int line, int i) { return colors.index(line, i); });
    for (std::size_t i = 0; i < isObject.size(); ++i)
        if (between[i] == 2) isObject[i] = 1;
}

/// 1 for each pixel that cannot be reached from the border over pixels of the background: a dot in the colour
/// of the background belongs to the object that is around it.
std::vector<char> objectPixels(const Colors& colors, const Color& background) {
    std::vector<char> isObject(colors.at.size(), 1);
    std::vector<std::pair<int, int>> open;
    const auto reach = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= colors.width || y >= colors.height) return;
        char& pixel = isObject[colors.index(x, y)];
        if (pixel == 0 || colorDistance(colors.pixel(x, y), background) > kBackground) return;
        pixel = 0;
        open.emplace_back(x, y);
    };
    for (int x = 0; x < colors.width; ++x) {
        reach(x, 0);
        reach(x, colors.height - 1);
    }
    for (int y = 0; y < colors.height; ++y) {
        reach(0, y);
        reach(colors.width - 1, y);
    }
    while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        reach(x + 1, y);
        reach(x - 1, y);
        reach(x, y + 1);
        reach(x, y - 1);
    }
    closeGaps(colors, isObject);
    return isObject;
}

/// A picture in one scale: its colours, and which pixels belong to the objects (0 to 1).
struct Scale {
    int side = 0;
    std::vector<Color> colors;
    std::vector<float> inside;
    std::vector<float> edges{};   ///< strength of the edge at each pixel, 0 outside of the objects
    std::vector<float> angles{};  ///< direction of the change, 0 to pi
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x);
    }
};

/// The objects of a picture, cut out and scaled so that their longer side is kSide.
std::optional<Scale> objectsOf(const Colors& colors) {
    if (colors.width < 2 || colors.height < 2) return std::nullopt;
    const Color background = backgroundOf(colors);
    const std::vector<char> isObject = objectPixels(colors, background);
    int left = colors.width, right = -1, top = colors.height, bottom = -1;
    for (int y = 0; y < colors.height; ++y)
        for (int x = 0; x < colors.width; ++x) {
            if (isObject[colors.index(x, y)] == 0) continue;
            left = std::min(left, x);
            right = std::max(right, x);
            top = std::min(top, y);
            bottom = std::max(bottom, y);
        }
    if (right < left) return std::nullopt;
    const double width = right - left + 1, height = bottom - top + 1;
    const double step = std::max(width, height) / kSide;
    const double x0 = left + width / 2 - step * kSide / 2, y0 = top + height / 2 - step * kSide / 2;
    Scale made{kSide, {}, {}};
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            // The mean of the pixels whose centres are in the cell; of the nearest one if there is none.
            Color sum{};
            float inside = 0;
            int count = 0;
            const auto first = [](double from) { return static_cast<int>(std::ceil(from - 0.5)); };
            int beginX = first(x0 + x * step), endX = first(x0 + (x + 1) * step);
            int beginY = first(y0 + y * step), endY = first(y0 + (y + 1) * step);
            if (beginX == endX) endX = (beginX = static_cast<int>(std::floor(x0 + (x + 0.5) * step))) + 1;
            if (beginY == endY) endY = (beginY = static_cast<int>(std::floor(y0 + (y + 0.5) * step))) + 1;
            for (int v = std::max(beginY, 0); v < std::min(endY, colors.height); ++v)
                for (int u = std::max(beginX, 0); u < std::min(endX, colors.width); ++u) {
                    const Color& color = colors.pixel(u, v);
                    for (std::size_t i = 0; i < 3; ++i) sum[i] += color[i];
                    inside += isObject[colors.index(u, v)];
                    ++count;
                }
            if (count > 0)
                for (float& each : sum) each /= static_cast<float>(count);
            made.colors.push_back(count > 0 ? sum : background);
            made.inside.push_back(count > 0 ? inside / static_cast<float>(count) : 0);
        }
    return made;
}

/// Divides the colours of the objects by their deviation. False if they have one colour.
bool normalize(Scale& scale) {
    Color mean{};
    double count = 0;
    for (std::size_t i = 0; i < scale.colors.size(); ++i) {
        if (scale.inside[i] < 1) continue;
        for (std::size_t k = 0; k < 3; ++k) mean[k] += scale.colors[i][k];
        ++count;
    }
    if (count < 16) return false;
    for (float& each : mean) each /= static_cast<float>(count);
    double variance = 0;
    for (std::size_t i = 0; i < scale.colors.size(); ++i)
        if (scale.inside[i] >= 1)
            for (std::size_t k = 0; k < 3; ++k)
                variance += std::pow(static_cast<double>(scale.colors[i][k] - mean[k]), 2);
    const double deviation = std::sqrt(variance / count);
    if (deviation < 2.0 / 255) return false;
    for (Color& each : scale.colors)
        for (std::size_t k = 0; k < 3; ++k) each[k] = (each[k] - mean[k]) / static_cast<float>(deviation);
    return true;
}

Scale halved(const Scale& from) {
    Scale made{from.side / 2, {}, {}};
    for (int y = 0; y < made.side; ++y)
        for (int x = 0; x < made.side; ++x) {
            Color sum{};
            float inside = 0;
            for (const std::size_t each : {from.index(2 * x, 2 * y), from.index(2 * x + 1, 2 * y),
                                           from.index(2 * x, 2 * y + 1), from.index(2 * x + 1, 2 * y + 1)}) {
                for (std::size_t k = 0; k < 3; ++k) sum[k] += from.colors[each][k] / 4;
                inside += from.inside[each] / 4;
            }
            made.colors.push_back(sum);
            made.inside.push_back(inside);
        }
    return made;
}

/// The edges inside of the objects: outlines are those of the model, which is free.
void findEdges(Scale& scale) {
    scale.edges.assign(scale.colors.size(), 0);
    scale.angles.assign(scale.colors.size(), 0);
    for (int y = 1; y + 1 < scale.side; ++y)
        for (int x = 1; x + 1 < scale.side; ++x) {
            bool isInside = true;
            for (int v = -1; v <= 1; ++v)
                for (int u = -1; u <= 1; ++u)
                    isInside = isInside && scale.inside[scale.index(x + u, y + v)] >= 1;
            if (!isInside) continue;
            // Di Zenzo: the direction in which the colour changes most.
            double xx = 0, xy = 0, yy = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const double dx =
                    (scale.colors[scale.index(x + 1, y)][k] - scale.colors[scale.index(x - 1, y)][k]) / 2;
                const double dy =
                    (scale.colors[scale.index(x, y + 1)][k] - scale.colors[scale.index(x, y - 1)][k]) / 2;
                xx += dx * dx;
                xy += dx * dy;
                yy += dy * dy;
            }
            const double most = (xx + yy + std::hypot(xx - yy, 2 * xy)) / 2;
            double angle = std::atan2(2 * xy, xx - yy) / 2;
            if (angle < 0) angle += std::numbers::pi;
            scale.edges[scale.index(x, y)] = static_cast<float>(std::sqrt(most));
            scale.angles[scale.index(x, y)] = static_cast<float>(angle);
        }
}

/// What is measured of one picture.
struct Pattern {
    std::vector<Scale> scales;
    std::array<double, kScales> edges{};  ///< share of the pixels inside that have an edge
    std::array<double, kTurns> turns{};   ///< shares of the directions of edges
    double minority = 0;                  ///< share of the rarer of the two main colours, up to 0.5
    bool isPlain = false;                 ///< the objects have one colour
};

/// The share of the rarer of two colours that divide the objects best (k-means, from the colours at both ends
/// of the widest component).
double minorityOf(const Scale& scale) {
    std::array<Color, 2> centres{};
    float range = -1;
    for (std::size_t k = 0; k < 3; ++k) {
        float least = 1e9F, largest = -1e9F;
        std::array<Color, 2> ends{};
        for (std::size_t i = 0; i < scale.colors.size(); ++i) {
            if (scale.inside[i] < 1) continue;
            if (scale.colors[i][k] < least) least = (ends[0] = scale.colors[i])[k];
            if (scale.colors[i][k] > largest) largest = (ends[1] = scale.colors[i])[k];
        }
        if (largest - least > range) {
            range = largest - least;
            centres = ends;
        }
    }
    std::array<double, 2> counts{};
    for (int round = 0; round < 8; ++round) {
        std::array<std::array<double, 3>, 2> sums{};
        counts = {};
        for (std::size_t i = 0; i < scale.colors.size(); ++i) {
            if (scale.inside[i] < 1) continue;
            const auto squared = [&](const Color& centre) {
                double sum = 0;
                for (std::size_t k = 0; k < 3; ++k)
                    sum += std::pow(static_cast<double>(scale.colors[i][k] - centre[k]), 2);
                return sum;
            };
            const std::size_t own = squared(centres[0]) <= squared(centres[1]) ? 0 : 1;
            for (std::size_t k = 0; k < 3; ++k) sums[own][k] += scale.colors[i][k];
            ++counts[own];
        }
        for (std::size_t own = 0; own < 2; ++own)
            for (std::size_t k = 0; k < 3 && counts[own] > 0; ++k)
                centres[own][k] = static_cast<float>(sums[own][k] / counts[own]);
    }
    const double all = counts[0] + counts[1];
    return all > 0 ? std::min(counts[0], counts[1]) / all : 0;
}

Pattern patternOf(Scale objects) {
    Pattern pattern;
    pattern.isPlain = !normalize(objects);
    pattern.scales.push_back(std::move(objects));
    for (int i = 1; i < kScales; ++i) pattern.scales.push_back(halved(pattern.scales.back()));
    if (pattern.isPlain) return pattern;
    pattern.minority = minorityOf(pattern.scales[0]);
    double directed = 0;
    for (std::size_t s = 0; s < pattern.scales.size(); ++s) {
        Scale& scale = pattern.scales[s];
        findEdges(scale);
        double inside = 0, found = 0;
        for (std::size_t i = 0; i < scale.edges.size(); ++i) {
            inside += scale.inside[i] >= 1 ? 1 : 0;
            if (scale.edges[i] < kEdge) continue;
            ++found;
            if (s > 1) continue;
            const int turn = std::min(kTurns - 1, static_cast<int>(static_cast<double>(scale.angles[i]) /
                                                                   std::numbers::pi * kTurns));
            pattern.turns[static_cast<std::size_t>(turn)] += scale.edges[i];
            directed += scale.edges[i];
        }
        pattern.edges[s] = inside > 0 ? found / inside : 0;
    }
    if (directed > 0)
        for (double& each : pattern.turns) each /= directed;
    return pattern;
}

constexpr double kOtherSize = 0.8;  // what a pattern keeps that is twice or half as large

double ratio(double a, double b, double least) {
    return (std::min(a, b) + least) / (std::max(a, b) + least);
}

/// How alike the patterns are, wherever they are.
double patternLikeness(const Pattern& a, const Pattern& b) {
    if (a.isPlain || b.isPlain) return a.isPlain && b.isPlain ? 1 : 0;
    // A pattern of half the size has in one scale what the other has in the next.
    double density = 0;
    for (int shift = -1; shift <= 1; ++shift) {
        double sum = 0;
        int count = 0;
        for (int i = 0; i < kCompared; ++i) {
            const int k = i + shift;
            if (k < 0 || k >= kCompared) continue;
            sum += ratio(a.edges[static_cast<std::size_t>(i)], b.edges[static_cast<std::size_t>(k)], 0.004);
            ++count;
        }
        density = std::max(density, std::pow(kOtherSize, std::abs(shift)) * sum / count);
    }
    double turns = 0;
    for (std::size_t by = 0; by < kTurns; ++by) {
        double common = 0;
        for (std::size_t i = 0; i < kTurns; ++i) common += std::min(a.turns[i], b.turns[(i + by) % kTurns]);
        turns = std::max(turns, common);
    }
    return density * (0.3 + 0.45 * turns + 0.25 * ratio(a.minority, b.minority, 0.05));
}

/// The correlation of the edges of two pictures in one scale, at the best shift.
double correlation(const Scale& a, const Scale& b) {
    constexpr int kShift = 3;
    double best = 0;
    for (int v = -kShift; v <= kShift; ++v)
        for (int u = -kShift; u <= kShift; ++u) {
            double n = 0, sumA = 0, sumB = 0, aa = 0, bb = 0, ab = 0;
            for (int y = std::max(0, -v); y < std::min(a.side, a.side - v); ++y)
                for (int x = std::max(0, -u); x < std::min(a.side, a.side - u); ++x) {
                    const std::size_t i = a.index(x, y), k = b.index(x + u, y + v);
                    if (a.inside[i] < 1 && b.inside[k] < 1) continue;
                    const double p = std::clamp(a.edges[i] - kShading, 0.0F, 1.0F);
                    const double q = std::clamp(b.edges[k] - kShading, 0.0F, 1.0F);
                    ++n;
                    sumA += p;
                    sumB += q;
                    aa += p * p;
                    bb += q * q;
                    ab += p * q;
                }
            if (n < 16) continue;
            const double varianceA = aa - sumA * sumA / n, varianceB = bb - sumB * sumB / n;
            if (varianceA <= 0 || varianceB <= 0) continue;
            best = std::max(best, (ab - sumA * sumB / n) / std::sqrt(varianceA * varianceB));
        }
    return best;
}

double overlap(const Scale& a, const Scale& b) {
    double both = 0, any = 0;
    for (std::size_t i = 0; i < a.inside.size(); ++i) {
        both += std::min(a.inside[i], b.inside[i]);
        any += std::max(a.inside[i], b.inside[i]);
    }
    return any > 0 ? both / any : 0;
}

double alignedLikeness(const Pattern& a, const Pattern& b) {
    if (a.isPlain || b.isPlain) return a.isPlain && b.isPlain ? overlap(a.scales[0], b.scales[0]) : 0;
    return (correlation(a.scales[1], b.scales[1]) + correlation(a.scales[2], b.scales[2])) / 2 *
           overlap(a.scales[0], b.scales[0]);
}

}  // namespace

bool showsNothing(const image::Image& picture) {
    const Colors colors = colorsOf(picture);
    if (colors.at.empty()) return true;
    // The most frequent colour of the border: a stray pixel in a corner is no background.
    const Color background = backgroundOf(colors);
    const auto others = std::count_if(colors.at.begin(), colors.at.end(), [&](const Color& each) {
        return colorDistance(each, background) > 2.5F / 255;
    });
    return static_cast<std::size_t>(others) <= colors.at.size() / 5'000;
}

double likeness(const image::Image& expected, const image::Image& got) {
    const bool nothing = showsNothing(expected);
    if (nothing || showsNothing(got)) return nothing && showsNothing(got) ? 1 : 0;
    std::optional<Scale> a = objectsOf(colorsOf(expected)), b = objectsOf(colorsOf(got));
    if (!a || !b) return 0;
    const Pattern expectedPattern = patternOf(std::move(*a)), gotPattern = patternOf(std::move(*b));
    return std::clamp(std::max(alignedLikeness(expectedPattern, gotPattern),
                               0.9 * patternLikeness(expectedPattern, gotPattern)),
                      0.0, 1.0);
}

}  // namespace glibra::classroom
