#include "classroom/effect.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace glibra::classroom {
namespace {

constexpr int kEffectSide = 32;
constexpr float kVisible = 8.0F / 255;           // of a component of a reduced pixel
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

}  // namespace

Colors reduced(const image::Image& picture) {
    const Colors whole = colorsOf(picture);
    const int longer = std::max({whole.width, whole.height, 1});
    return cells(whole, std::max(1, whole.width * kEffectSide / std::max(longer, kEffectSide)),
                 std::max(1, whole.height * kEffectSide / std::max(longer, kEffectSide)));
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
    Colors b = centred(other);
    const double norm = std::sqrt(square(a) * square(b));
    if (norm < 1e-3 * static_cast<double>(a.at.size())) return false;
    if (cosine(a, b, 0, 0, norm) >= kAlike) return true;
    for (int y = 0; y < b.height / 2; ++y)
        for (int x = 0; x < b.width; ++x) std::swap(b.at[b.index(x, y)], b.at[b.index(x, b.height - 1 - y)]);
    return cosine(a, b, 0, 0, norm) >= kAlike;
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
    if (std::ranges::none_of(got.at, isVisible)) return effect;
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
