#pragma once
// Reads texels of pictures, and turns numbers into bytes that a screen can show.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "gpu/object/framebuffer.h"
#include "render/check/object_content.h"
#include "scene/scene.h"

namespace glibra::view {

/// Red, green, blue, alpha as the device has them, bottom row first.
struct TexelImage {
    int width = 0, height = 0;
    std::vector<float> rgba;
};

/// The colours of a picture.
TexelImage colorTexels(const gpu::Target& picture);
/// The same as numbers with a name; `isDepth`: its window depth, 0..1, in place of its colours.
render::Content contentOf(const gpu::Target& picture, bool isDepth);

/// 0..1 as 0..255, rounded; numbers beyond are limited to it.
inline std::uint8_t asByte(double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255));
}

/// How numbers become bytes: `low` is black and `high` is white; all channels in colour or one channel in
/// grey. What has one component is grey.
enum class Channels { rgb, red, green, blue, alpha };
struct TexelDisplay {
    Channels channels = Channels::rgb;
    double low = 0, high = 1;
    friend bool operator==(const TexelDisplay&, const TexelDisplay&) = default;
};

/// Opaque RGBA bytes of the first layer, bottom row first. Texels with NaN are magenta and texels with
/// infinity cyan, in a checkerboard pattern, whatever `display` is.
std::vector<std::uint8_t> screenBytes(const render::Content& content, const TexelDisplay& display);

/// The least and the largest finite value that those channels show; 0 and 1 if there is none.
std::pair<double, double> rangeOf(const render::Content& content, Channels channels);

/// How many texels have a component that is NaN, and how many others one that is infinite.
struct NonFiniteTexels {
    int nan = 0, infinite = 0;
};
NonFiniteTexels countNonFinite(const render::Content& content);

/// A scene's texture as named in lists: "glow: 2D, 512 x 512, rgba16f, line 8", "unit 5 / 2D: wood.bmp, line
/// 12".
std::string textureTitle(const scene::Scene& scene, scene::TextureIndex texture);

/// What tells the textures of a scene apart: the name, or "#2" for texture 2, which has none.
std::string textureKey(const scene::Scene& scene, scene::TextureIndex texture);

}  // namespace glibra::view
