#pragma once
// Texels of the device in memory, and as bytes that a screen can show: for looking into textures and targets.

#include <cstdint>
#include <string>
#include <vector>

#include "gpu/target.h"
#include "gpu/texture.h"
#include "view/scene/live_scene.h"

namespace glibra::view {

/// Red, green, blue, alpha as the device has them, bottom row first.
struct TexelImage {
    int width = 0, height = 0;
    std::vector<float> rgba;
};

/// A slice of a 3D texture (along p), a face of a cube map (+x -x +y -y +z -z), or the whole of another; the
/// slice is limited to those there are. A 1D texture has one row. Empty if the driver cannot read that
/// format.
TexelImage texelsOf(const gpu::Texture& texture, int slice);
int sliceCount(const gpu::Texture& texture);

/// Of the picture drawn last: its colour, or its depth as a distance from the near plane, 0..1, in all
/// components.
TexelImage colorOf(const gpu::Target& picture);
TexelImage depthOf(const gpu::Target& picture);

/// How numbers become bytes: channel * gain, one channel as grey or all.
enum class Channels { rgb, red, green, blue, alpha };
struct Showing {
    Channels channels = Channels::rgb;
    float gain = 1;
};

/// RGBA bytes, opaque, bottom row first. NaN is magenta and infinity cyan in a checkerboard, whatever the
/// showing.
std::vector<std::uint8_t> shown(const TexelImage& image, const Showing& showing);

/// NaN and infinite texels, for a warning.
struct NonFiniteTexels {
    int nan = 0, infinite = 0;
};
NonFiniteTexels countNonFinite(const TexelImage& image);

/// What a scene's texture is called in a list: "5 / 2D: wood.bmp, line 12", "target 6 / 2D, line 8".
std::string textureTitle(const scene::Scene& scene, scene::TextureIndex texture);

}  // namespace glibra::view
