#include "bench/reference/test_card.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "gpu/context/errors.h"

namespace glibra::bench {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes asRgba(const Bytes& grey) {
    Bytes rgba;
    rgba.reserve(grey.size() * 4);
    for (const std::uint8_t each : grey) rgba.insert(rgba.end(), {each, each, each, 255});
    return rgba;
}

/// level and side of every level below the card itself.
template <class Visit>
void forEachLevel(const Visit& visit) {
    Bytes texels = testCard();
    int level = 0;
    for (int side = kCardSide; side > 1; side /= 2) {
        texels = halved(texels, side);
        visit(++level, side / 2, texels);
    }
}

}  // namespace

std::vector<std::uint8_t> testCard() {
    constexpr int kSquare = 8, kStripe = 3;
    Bytes texels;
    for (int t = 0; t < kCardSide; ++t)
        for (int s = 0; s < kCardSide; ++s) {
            const bool isStriped = (s / kSquare + t / kSquare) % 2 == 0;
            const bool isLight = isStriped ? (s + t) / kStripe % 2 == 0 : s / (2 * kSquare) % 2 == 0;
            texels.push_back(
                static_cast<std::uint8_t>(isLight ? 160 + 95 * std::abs(2 * s - kCardSide) / kCardSide : 20));
        }
    return texels;
}

std::vector<std::uint8_t> halved(const std::vector<std::uint8_t>& texels, int side) {
    const auto columns = static_cast<std::size_t>(side);
    Bytes smaller;
    for (std::size_t t = 0; t < columns; t += 2)
        for (std::size_t s = 0; s < columns; s += 2) {
            const std::size_t first = t * columns + s;
            const int sum =
                texels[first] + texels[first + 1] + texels[first + columns] + texels[first + columns + 1];
            smaller.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
        }
    return smaller;
}

double bilinear(const std::vector<std::uint8_t>& texels, int side, const glm::dvec2& place) {
    const double s = place.x - .5, t = place.y - .5;
    const double left = std::floor(s), low = std::floor(t);
    const auto at = [&](double column, double row) {
        const auto wrapped = [side](double index) {
            return static_cast<std::size_t>(index - std::floor(index / side) * side);
        };
        return static_cast<double>(texels[wrapped(row) * static_cast<std::size_t>(side) + wrapped(column)]);
    };
    const double x = s - left, y = t - low;
    return std::lerp(std::lerp(at(left, low), at(left + 1, low), x),
                     std::lerp(at(left, low + 1), at(left + 1, low + 1), x), y) /
           255;
}

Result<CardTexture> CardTexture::create() {
    CardTexture made;
    GLuint name = 0;
    glGenTextures(1, &name);
    made.name_ = gpu::Name<glDeleteTextures>(name);
    made.bind(0);
    gpu::clearErrors();
    const auto load = [](int level, int side, const Bytes& texels) {
        const Bytes rgba = asRgba(texels);
        glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    };
    load(0, kCardSide, testCard());
    forEachLevel(load);
    if (const GLenum code = gpu::takeError(); code != GL_NO_ERROR)
        return gpu::allocationError(code, "a texture with mipmaps");
    return made;
}

void CardTexture::bind(int unit) const {
    glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, name_.get());
}

double CardTexture::differenceOfDriversLevels() const {
    bind(0);
    glGenerateMipmap(GL_TEXTURE_2D);
    int largest = 0;
    forEachLevel([&largest](int level, int side, const Bytes& texels) {
        Bytes rgba(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * 4);
        glGetTexImage(GL_TEXTURE_2D, level, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        for (std::size_t i = 0; i < texels.size(); ++i)
            largest = std::max(largest, std::abs(rgba[i * 4] - texels[i]));
    });
    return largest;
}

}  // namespace glibra::bench
