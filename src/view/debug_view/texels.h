#pragma once
// Reads texels of textures and targets, and turns them into bytes that a screen can show.

#include <cstdint>
#include <string>
#include <vector>

#include "gpu/object/target.h"
#include "gpu/object/texture.h"
#include "scene/scene.h"

namespace glibra::view {

/// Red, green, blue, alpha as the device has them, bottom row first.
struct TexelImage {
    int width = 0, height = 0;
    std::vector<float> rgba;
};

/// The texels of one slice of a 3D texture (along p), one face of a cube map (+x -x +y -y +z -z), or a whole
/// 2D or 1D texture, which has one row. `slice` is clamped to the existing ones. Empty if the driver cannot
/// read the texture's format.
TexelImage texelsOf(const gpu::Texture& texture, int slice);
int sliceCount(const gpu::Texture& texture);

/// The colours of a picture.
TexelImage colorTexels(const gpu::Target& picture);
/// The window depth of a picture, 0..1, in red, green and blue; alpha is 1.
TexelImage depthTexels(const gpu::Target& picture);

/// How numbers become bytes: channel * gain; all channels in colour or one channel in grey.
enum class Channels { rgb, red, green, blue, alpha };
struct TexelDisplay {
    Channels channels = Channels::rgb;
    float gain = 1;
};

/// Opaque RGBA bytes, bottom row first. Texels with NaN are magenta and texels with infinity cyan, in a
/// checkerboard pattern, whatever `display` is.
std::vector<std::uint8_t> screenBytes(const TexelImage& image, const TexelDisplay& display);

/// How many texels have a component that is NaN, and how many others one that is infinite.
struct NonFiniteTexels {
    int nan = 0, infinite = 0;
};
NonFiniteTexels countNonFinite(const TexelImage& image);

/// A scene's texture as named in lists: "unit 5 / 2D: wood.bmp, line 12", "unit 6 / 2D: target, line 8".
std::string textureTitle(const scene::Scene& scene, scene::TextureIndex texture);

}  // namespace glibra::view
