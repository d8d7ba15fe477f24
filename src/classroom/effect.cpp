#include "classroom/effect.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace glibra::classroom {
namespace {

constexpr float kVisible = 8.0F / 255;           // of a component of a reduced pixel
constexpr float kAny = 1.0F / 255;               // of the same: more than rounding
constexpr double kNoEffect = .15, kEffect = .6;  // unrelated changes have up to 0.15
constexpr double kLocal = .4, kEverywhere = .6;  // of the objects
constexpr double kOtherwise = .35;

Colors change(const Colors& before, const Colors& after) {
    Colors made = after;
    for (std::size_t i = 0; i < made.at.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) made.at[i][k] -= before.at[i][k];
    return made;
}

bool isVisible(const Color& change) {
    return colorDistance(change, {}) > kVisible;
}

bool isAny(const Color& change) {
    return colorDistance(change, {}) > kAny;
}

double product(const Color& a, const Color& b) {
    return static_cast<double>(a[0]) * b[0] + static_cast<double>(a[1]) * b[1] +
           static_cast<double>(a[2]) * b[2];
}

double square(const Colors& change) {
    double sum = 0;
    for (const Color& each : change.at) sum += product(each, each);
    return sum;
}

/// The cosine of two changes, of which the second is shifted.
double cosine(const Colors& a, const Colors& b, int u, int v, double norm) {
    double sum = 0;
    for (int y = std::max(0, -v); y < std::min(a.height, a.height - v); ++y)
        for (int x = std::max(0, -u); x < std::min(a.width, a.width - u); ++x)
            sum += product(a.pixel(x, y), b.pixel(x + u, y + v));
    return sum / norm;
}

/// The means of the cells of a grid.
Colors cells(const Colors& whole, int width, int height) {
    Colors made{width, height, {}};
    if (whole.at.empty()) return made;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto from = [](int cell, int side, int number) { return cell * side / number; };
            const int left = from(x, whole.width, width), top = from(y, whole.height, height);
            const int right = std::max(left + 1, from(x + 1, whole.width, width));
            const int bottom = std::max(top + 1, from(y + 1, whole.height, height));
            Color sum{};
            for (int v = top; v < bottom; ++v)
                for (int u = left; u < right; ++u)
                    for (std::size_t k = 0; k < 3; ++k) sum[k] += whole.pixel(u, v)[k];
            for (float& each : sum) each /= static_cast<float>((right - left) * (bottom - top));
            made.at.push_back(sum);
        }
    return made;
}

Colors upsideDown(Colors colors) {
    for (int y = 0; y < colors.height / 2; ++y)
        for (int x = 0; x < colors.width; ++x)
            std::swap(colors.at[colors.index(x, y)], colors.at[colors.index(x, colors.height - 1 - y)]);
    return colors;
}

}  // namespace

Colors reduced(const image::Image& picture, int most) {
    const Colors whole = colorsOf(picture);
    const int longer = std::max({whole.width, whole.height, most});
    return cells(whole, std::max(1, whole.width * most / longer), std::max(1, whole.height * most / longer));
}

bool looksLike(const Colors& reference, const image::Image& picture) {
    constexpr double kAlike = .97;  // correlation
    const Colors other = cells(colorsOf(picture), reference.width, reference.height);
    if (other.at.size() != reference.at.size()) return false;
    const auto centred = [](Colors colors) {
        Color mean{};
        for (const Color& each : colors.at)
            for (std::size_t k = 0; k < 3; ++k) mean[k] += each[k] / static_cast<float>(colors.at.size());
        for (Color& each : colors.at)
            for (std::size_t k = 0; k < 3; ++k) each[k] -= mean[k];
        return colors;
    };
    const Colors a = centred(reference);
    const Colors b = centred(other);
    const double norm = std::sqrt(square(a) * square(b));
    if (norm < 1e-3 * static_cast<double>(a.at.size())) return false;
    return cosine(a, b, 0, 0, norm) >= kAlike || cosine(a, upsideDown(b), 0, 0, norm) >= kAlike;
}

bool isCutFrom(const image::Image& reference, const image::Image& picture) {
    constexpr int kLeastSide = 32, kLeastShare = 25;
    constexpr int kPlaces = 8, kMostTried = 2'000;
    constexpr double kLeastDetail = 4. / 255, kNoise = .15;  // mean difference from the mean, and of that
    if (picture.width > reference.width || picture.height > reference.height ||
        std::min(picture.width, picture.height) < kLeastSide ||
        std::int64_t{picture.width} * picture.height * kLeastShare <
            std::int64_t{reference.width} * reference.height)
        return false;
    const Colors whole = colorsOf(reference), plain = colorsOf(picture), turned = upsideDown(plain);
    const Color mean = cells(plain, 1, 1).at.front();
    const auto distance = [](const Color& a, const Color& b) {
        return static_cast<double>(std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2])) / 3;
    };
    double detail = 0;
    for (const Color& each : plain.at) detail += distance(each, mean);
    detail /= static_cast<double>(plain.at.size());
    if (detail < kLeastDetail) return false;
    // Nearly all offsets fail at a few places already.
    const auto differs = [&](const Colors& part, int left, int top, int columns, int rows, double most) {
        const int across = part.width / columns, down = part.height / rows;
        const double limit = most * detail * columns * rows;
        double sum = 0;
        for (int y = down / 2; y < rows * down; y += down)
            for (int x = across / 2; x < columns * across; x += across) {
                sum += distance(part.pixel(x, y), whole.pixel(left + x, top + y));
                if (sum > limit) return true;
            }
        return false;
    };
    int tried = 0;
    for (const Colors* part : {&plain, &turned})
        for (int top = 0; top <= whole.height - part->height; ++top)
            for (int left = 0; left <= whole.width - part->width && tried < kMostTried; ++left) {
                if (differs(*part, left, top, kPlaces, kPlaces, 3 * kNoise)) continue;
                ++tried;
                if (!differs(*part, left, top, part->width, part->height, kNoise)) return true;
            }
    return false;
}

double differenceOf(const Colors& one, const Colors& other) {
    double sum = 0;
    for (std::size_t i = 0; i < std::min(one.at.size(), other.at.size()); ++i)
        sum += colorDistance(one.at[i], other.at[i]);
    return sum;
}

std::optional<Effect> effectOf(const Colors& referenceBefore, const Colors& referenceAfter,
                               const Colors& before, const Colors& after) {
    for (const Colors* each : {&referenceAfter, &before, &after})
        if (each->width != referenceBefore.width || each->height != referenceBefore.height)
            return std::nullopt;
    const Colors wanted = change(referenceBefore, referenceAfter);
    if (std::ranges::none_of(wanted.at, isVisible)) return std::nullopt;
    Effect effect;
    const std::optional<Objects> first = findObjects(referenceBefore), second = findObjects(referenceAfter);
    double changed = 0, shown = 0;
    for (std::size_t i = 0; i < wanted.at.size(); ++i) {
        const bool isChanged = isVisible(wanted.at[i]);
        changed += isChanged ? 1 : 0;
        shown +=
            isChanged || (first && first->isObject[i] != 0) || (second && second->isObject[i] != 0) ? 1 : 0;
    }
    effect.share = changed / shown;
    const Colors got = change(before, after);
    // The cosine does not depend on the strength: a weaker change than the reference's is not another one.
    if (std::ranges::none_of(got.at, isAny)) return effect;
    const double norm = std::sqrt(square(wanted) * square(got));
    for (int v = -wanted.height / 4; v <= wanted.height / 4; ++v)
        for (int u = -wanted.width / 4; u <= wanted.width / 4; ++u)
            effect.likeness = std::max(effect.likeness, cosine(wanted, got, u, v, norm));
    Colors inside = wanted;
    for (std::size_t i = 0; i < inside.at.size(); ++i)
        if (!isVisible(got.at[i])) inside.at[i] = {};
    const double insideNorm = std::sqrt(square(inside) * square(got));
    if (insideNorm > 0) effect.inside = std::max(0.0, cosine(inside, got, 0, 0, insideNorm));
    return effect;
}

double keptLikeness(const Effect& effect) {
    const double part = std::clamp((effect.likeness - kNoEffect) / (kEffect - kNoEffect), 0.0, 1.0);
    const double local = std::clamp((kEverywhere - effect.share) / (kEverywhere - kLocal), 0.0, 1.0);
    return 1 - local * (1 - part);
}

bool changesOtherwise(const Effect& effect) {
    return effect.share < (kLocal + kEverywhere) / 2 && std::max(effect.likeness, effect.inside) < kOtherwise;
}

}  // namespace glibra::classroom
