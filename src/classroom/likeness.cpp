#include "classroom/likeness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "classroom/cut_objects.h"
#include "classroom/pattern_points.h"
#include "image/compare/flip.h"

namespace glibra::classroom {
namespace {

// How alike the statistics of two patterns are, which tells random ones apart: clouds, marble, stains.

/// Kinds of places: flat, slope, dark and light blob, dark and light line, saddle.
inline constexpr std::size_t kPlaceKinds = 7;

/// The shares of pixels that are of one kind in a scale and of another in the scale that is twice as coarse;
/// nothing for a scale in which too few pixels are known.
using KindShares = std::array<double, kPlaceKinds * kPlaceKinds>;
struct PatternKinds {
    std::vector<std::optional<KindShares>> scales;
};

constexpr float kFlat = 0.15F;           // response of a flat place, in deviations of the tone
constexpr std::size_t kCoarser = 2;      // scales between the two that are looked at together
constexpr double kPerScale = 0.93;       // what a pattern keeps whose size differs by one scale
constexpr std::uint8_t kUnknown = 0xFF;  // a place at the outline

/// The kind of each pixel in one scale.
std::vector<std::uint8_t> kindsOf(const ToneScales& tones, std::size_t scale) {
    const int side = tones.side;
    const Plane& tone = tones.levels[scale];
    std::vector<std::uint8_t> kinds(tone.size(), kUnknown);
    const float deviation = toneDeviation(static_cast<float>(scale));
    const int step = std::max(1, static_cast<int>(std::lround(deviation / 2)));
    const float unit = deviation / static_cast<float>(step);
    for (int y = step; y + step < side; ++y)
        for (int x = step; x + step < side; ++x) {
            const auto index = [&](int u, int v) {
                return static_cast<std::size_t>((y + v * step) * side + x + u * step);
            };
            const auto isInside = [&](int u, int v) { return tones.inside[index(u, v)] > 0; };
            if (tones.known[scale][index(0, 0)] < 0.8F || !isInside(0, 0) || !isInside(1, 0) ||
                !isInside(-1, 0) || !isInside(0, 1) || !isInside(0, -1))
                continue;
            const auto at = [&](int u, int v) { return tone[index(u, v)]; };
            const float dx = unit * (at(1, 0) - at(-1, 0)) / 2, dy = unit * (at(0, 1) - at(0, -1)) / 2;
            const float xx = unit * unit * (at(1, 0) - 2 * at(0, 0) + at(-1, 0));
            const float yy = unit * unit * (at(0, 1) - 2 * at(0, 0) + at(0, -1));
            const float xy = unit * unit * (at(1, 1) - at(-1, 1) - at(1, -1) + at(-1, -1)) / 4;
            const float sum = xx + yy, spread = std::hypot(xx - yy, 2 * xy), root = std::sqrt(0.5F);
            const std::array<float, kPlaceKinds> responses{
                kFlat, 2 * std::hypot(dx, dy), sum, -sum, root * (spread + sum), root * (spread - sum),
                spread};
            kinds[index(0, 0)] =
                static_cast<std::uint8_t>(std::ranges::max_element(responses) - responses.begin());
        }
    return kinds;
}

/// The kind after dark and light are exchanged.
std::size_t exchanged(std::size_t kind) {
    constexpr std::array<std::size_t, kPlaceKinds> kOther{0, 1, 3, 2, 5, 4, 6};
    return kOther[kind];
}

/// Each place is of the kind whose response is the largest (M. Crosier, L. Griffin: "Using Basic Image
/// Features for Texture Classification", IJCV 2010). Neither a turn nor contrast changes that.
PatternKinds patternKindsOf(const ToneScales& tones) {
    std::vector<std::vector<std::uint8_t>> kinds;
    for (std::size_t i = 0; i < tones.levels.size(); ++i) kinds.push_back(kindsOf(tones, i));
    PatternKinds made;
    for (std::size_t scale = 0; scale + kCoarser < kinds.size(); ++scale) {
        KindShares shares{};
        double count = 0;
        for (std::size_t i = 0; i < kinds[scale].size(); ++i) {
            const std::uint8_t fine = kinds[scale][i], coarse = kinds[scale + kCoarser][i];
            if (fine == kUnknown || coarse == kUnknown) continue;
            ++shares[fine * kPlaceKinds + coarse];
            ++count;
        }
        constexpr double kLeast = 100;  // pixels
        for (double& each : shares) each /= std::max(count, 1.0);
        made.scales.push_back(count < kLeast ? std::nullopt : std::optional(shares));
    }
    return made;
}

/// The Bhattacharyya coefficient of the shares, from 0 to 1, at the best change of scale (by up to four,
/// which costs a little), and with dark and light exchanged if that fits better.
double commonKinds(const PatternKinds& a, const PatternKinds& b) {
    constexpr int kMostScales = 4;
    const auto count = static_cast<int>(std::min(a.scales.size(), b.scales.size()));
    double best = 0;
    for (int shift = -kMostScales; shift <= kMostScales; ++shift)
        for (const bool exchanges : {false, true}) {
            double sum = 0, weights = 0;
            for (int scale = std::max(0, -shift); scale < std::min(count, count - shift); ++scale) {
                const auto& own = a.scales[static_cast<std::size_t>(scale)];
                const auto& other = b.scales[static_cast<std::size_t>(scale + shift)];
                if (!own || !other) continue;
                double common = 0;
                for (std::size_t i = 0; i < own->size(); ++i) {
                    const std::size_t k =
                        exchanges ? exchanged(i / kPlaceKinds) * kPlaceKinds + exchanged(i % kPlaceKinds) : i;
                    common += std::sqrt((*own)[i] * (*other)[k]);
                }
                // Scales in which all is flat say little.
                const double weight = 1 - std::min(own->front(), other->front());
                sum += weight * common;
                weights += weight;
            }
            if (weights > 0.5) best = std::max(best, sum / weights * std::pow(kPerScale, std::abs(shift)));
        }
    return best;
}

constexpr int kScales = 3;         // each half as large as the one before
constexpr std::size_t kBends = 6;  // in a right angle
/// An edge between two colours has about 1 per pixel, where colours have the deviation 1; shading that goes
/// over the whole object has at most 0.25.
constexpr float kEdge = 0.5F;
constexpr float kShading = 0.15F;   // what the correlation of edges leaves out
constexpr double kSameSize = 0.3;   // octaves by which the size of a pattern may differ
constexpr double kOtherSize = 0.6;  // what a pattern keeps that is twice or half as large
constexpr double kFiner = 0.4;      // octaves from which on the finer pattern is looked at more closely

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
    std::vector<PatternPoint> points;
    PatternKinds kinds;
    std::array<double, kBends> bends{};  ///< findBends
    double sharp = 0;                    ///< 1 if there are many edges, 0 if there is shading alone
    double minority = 0;                 ///< share of the rarer of the two main tones, up to 0.5
    double repeats = 0;                  ///< repetition of its points
    bool isPlain = false;                ///< the objects have one colour
};

/// The share of the rarer of the two tones that divide the objects best (k-means in one dimension).
double minorityOf(const ToneScales& tones) {
    std::vector<float> values;
    for (std::size_t i = 0; !tones.levels.empty() && i < tones.inside.size(); ++i)
        if (tones.inside[i] > 0) values.push_back(tones.levels[0][i]);
    if (values.empty()) return 0;
    std::ranges::sort(values);
    const std::size_t stray = values.size() / 50;
    double low = values[stray], high = values[values.size() - 1 - stray];
    const auto count = static_cast<double>(values.size());
    double lower = 0;  // number of values that are nearer to the lower centre
    for (int round = 0; round < 10; ++round) {
        const auto limit = std::ranges::upper_bound(values, static_cast<float>((low + high) / 2));
        lower = static_cast<double>(limit - values.begin());
        if (lower > 0) low = std::accumulate(values.begin(), limit, 0.0) / lower;
        if (lower < count) high = std::accumulate(limit, values.end(), 0.0) / (count - lower);
    }
    return std::min(lower, count - lower) / count;
}

/// The differences between the directions of edges that are near to each other, in the unit of the size of
/// the pattern: of lines they are 0, of squares also a right angle, of discs anything.
void findBends(const Scale& scale, Pattern& pattern) {
    std::array<double, kBends>& bends = pattern.bends;
    std::vector<float> radii;
    for (const PatternPoint& each : pattern.points) radii.push_back(each.radius);
    if (radii.empty()) return;
    std::nth_element(radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2),
                     radii.end());
    const float unit = std::max(radii[radii.size() / 2], 1.5F);
    struct Edge {
        float x, y, angle, strength;
    };
    std::vector<Edge> edges;
    for (int y = 0; y < scale.side; ++y)
        for (int x = 0; x < scale.side; ++x)
            if (const std::size_t at = scale.index(x, y); scale.edges[at] >= kEdge)
                edges.push_back(
                    {static_cast<float>(x), static_cast<float>(y), scale.angles[at], scale.edges[at]});
    const auto inside = std::ranges::count_if(scale.inside, [](float each) { return each >= 1; });
    constexpr double kManyEdges = 0.08;  // of the pixels
    pattern.sharp =
        std::min(1.0, static_cast<double>(edges.size()) / (kManyEdges * static_cast<double>(inside)));
    constexpr std::size_t kMostEdges = 500;
    const std::size_t step = edges.size() / kMostEdges + 1;
    double all = 0;
    for (std::size_t i = 0; i < edges.size(); i += step)
        for (std::size_t k = 0; k < i; k += step) {
            const float distance = std::hypot(edges[i].x - edges[k].x, edges[i].y - edges[k].y);
            if (distance < unit || distance > 2 * unit) continue;
            float bend = std::abs(edges[i].angle - edges[k].angle);
            bend = std::min(bend, std::numbers::pi_v<float> - bend);
            const auto bin = static_cast<std::size_t>(bend / (std::numbers::pi_v<float> / 2) * kBends);
            const double weight = static_cast<double>(edges[i].strength) * edges[k].strength;
            bends[std::min(bin, kBends - 1)] += weight;
            all += weight;
        }
    if (all > 0)
        for (double& each : bends) each /= all;
}

Pattern patternOf(Scale objects) {
    Pattern pattern;
    const ToneScales tones = toneScalesOf(objects);
    pattern.points = findPatternPoints(tones);
    pattern.repeats = repetition(pattern.points);
    pattern.kinds = patternKindsOf(tones);
    pattern.minority = minorityOf(tones);
    pattern.isPlain = !normalize(objects);
    pattern.scales.push_back(std::move(objects));
    for (int i = 1; i < kScales; ++i) pattern.scales.push_back(halved(pattern.scales.back()));
    if (pattern.isPlain) return pattern;
    for (Scale& each : pattern.scales) findEdges(each);
    findBends(pattern.scales[0], pattern);
    return pattern;
}

double ratio(double a, double b, double least) {
    return (std::min(a, b) + least) / (std::max(a, b) + least);
}

/// The part of a range that a figure has, 0 to 1.
double partOf(double value, double none, double full) {
    return std::clamp((value - none) / (full - none), 0.0, 1.0);
}

/// How alike the shares of bends are; 1 where there are too few edges to tell.
double bendsLikeness(const Pattern& a, const Pattern& b) {
    double common = 0;
    for (std::size_t i = 0; i < kBends; ++i) common += std::min(a.bends[i], b.bends[i]);
    return 1 - std::min(a.sharp, b.sharp) * (1 - common);
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

/// How alike the patterns are, wherever they are, if their sizes differ by these octaves. The limits are
/// where patterns that have nothing in common and patterns on other models end (docs/class.md).
double patternLikeness(const Pattern& a, const Pattern& b, const FoundAgain& found, double octaves,
                       double sameOutline) {
    if (a.isPlain || b.isPlain) return a.isPlain && b.isPlain ? 1 : 0;
    // Where the outlines are the same, so are model and camera, and another size is a mistake.
    const double size = std::max(0.0, std::abs(octaves) - kSameSize);
    // Dots are like each other; patches that the triangles of a model cut out of dots are not.
    constexpr double kSameRepetition = 0.06, kOtherRepetition = 0.16, kLost = 0.85;
    const double repeats =
        1 - kLost * partOf(std::abs(a.repeats - b.repeats), kSameRepetition, kOtherRepetition);
    const double product = partOf(found.correlation, 0.72, 0.86) *
                           std::pow(partOf(commonKinds(a.kinds, b.kinds), 0.5, 1), 0.4) *
                           bendsLikeness(a, b) * std::pow(ratio(a.minority, b.minority, 0.05), 0.35) *
                           std::pow(kOtherSize, size * sameOutline) * repeats;
    return std::pow(product, 0.8);
}

}  // namespace

bool showsNothing(const image::Image& picture) {
    const Colors colors = colorsOf(picture);
    if (colors.at.empty()) return true;
    // The most frequent colour of the border: a stray pixel in a corner is no background.
    const Color background = backgroundOf(colors);
    const auto others = std::ranges::count_if(
        colors.at, [&](const Color& each) { return colorDistance(each, background) > 2.5F / 255; });
    return static_cast<std::size_t>(others) <= colors.at.size() / 5'000;
}

double likeness(const image::Image& expected, const image::Image& got) {
    if (expected.width == got.width && expected.height == got.height &&
        expected.components == got.components && expected.data == got.data)
        return 1;
    const bool nothing = showsNothing(expected);
    if (nothing || showsNothing(got)) return nothing && showsNothing(got) ? 1 : 0;
    const Colors colorsA = colorsOf(expected), colorsB = colorsOf(got);
    const std::optional<Objects> objectsA = findObjects(colorsA), objectsB = findObjects(colorsB);
    if (!objectsA || !objectsB) return 0;
    const auto patterns = [&](const Objects& a, const Objects& b) {
        // A small object has less detail than a large one; both are compared with that of the smaller.
        constexpr int kLeastDetail = 24;
        const int detail = std::clamp(std::min(a.longerSide(), b.longerSide()), kLeastDetail, kSide);
        return std::pair(patternOf(cutOut(colorsA, a, detail)), patternOf(cutOut(colorsB, b, detail)));
    };
    const auto [a, b] = patterns(*objectsA, *objectsB);
    const double sameOutline = std::pow(overlap(a.scales[0], b.scales[0]), 2);
    const FoundAgain found = foundAgain(a.points, b.points);
    double best = patternLikeness(a, b, found, found.octaves, sameOutline);
    if (std::abs(found.octaves) > kFiner) {
        const bool isGotFiner = found.octaves < 0;
        const auto [nearA, nearB] = isGotFiner ? patterns(*objectsA, closer(colorsB, *objectsB))
                                               : patterns(closer(colorsA, *objectsA), *objectsB);
        const FoundAgain closely = foundAgain(nearA.points, nearB.points);
        const double octaves = closely.octaves + (isGotFiner ? -1 : 1);
        best = std::max(best, patternLikeness(nearA, nearB, closely, octaves, sameOutline));
    }
    return std::clamp(std::max(alignedLikeness(a, b), 0.95 * best), 0.0, 1.0);
}

Reaction reaction(const image::Image& one, const image::Image& other) {
    constexpr float kChange = .01F;
    constexpr double kLeastPart = .002;
    const image::FlipResult flip = image::flip(one, other, {.threads = 1});
    if (one.width != other.width || one.height != other.height) return {flip.mean, flip.mean};
    const Colors colorsA = colorsOf(one), colorsB = colorsOf(other);
    const std::optional<Objects> objectsA = findObjects(colorsA), objectsB = findObjects(colorsB);
    const auto all = static_cast<double>(colorsA.at.size());
    double shown = all;
    if (objectsA && objectsB && colorDistance(objectsA->background, objectsB->background) <= 2.5F / 255) {
        shown = 0;
        for (std::size_t i = 0; i < colorsA.at.size(); ++i)
            shown += objectsA->isObject[i] != 0 || objectsB->isObject[i] != 0 ? 1 : 0;
    }
    double changed = 0, sum = 0;
    for (const float each : flip.errors)
        if (each > kChange) {
            ++changed;
            sum += each;
        }
    return {std::min(1.0, flip.mean * all / shown), sum / std::max({1.0, changed, kLeastPart * shown})};
}

}  // namespace glibra::classroom
