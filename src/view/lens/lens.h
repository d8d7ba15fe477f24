#pragma once
// Views into the pipeline instead of the picture: what each shows, as numbers and as colours.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "view/lens/texel_view.h"

namespace glibra::view {

/// `picture`: none. `normals`: the picture with normals as lines. The others show a number of every pixel
/// that something is drawn on, made by the scene's own stages up to the rasteriser and by what its fragment
/// stages discard; alpha is 0 where there is nothing.
enum class Lens {
    picture,
    normals,
    coordinates,  ///< texture coordinates s, t, p
    facing,       ///< red: 1 front, 0 back
    overdraw,     ///< red: fragments that passed the depth test, in the order of drawing
    layers,       ///< red: all fragments, without a depth test
    depth,        ///< red: window depth 0..1; green: distance from the eye's plane, in units of eye space
};
inline constexpr int kLensCount = 7;

/// "picture", "normals", "texture coordinates", "facing", "overdraw", "layers", "depth".
std::string_view nameOf(Lens lens);

/// What the legend says.
struct LensRange {
    double lowest = 0, highest = 0;  ///< of the number shown, over all pixels that something is drawn on
    bool isEmpty = true;
};
LensRange rangeOf(Lens lens, const TexelImage& numbers);

/// Red, green, blue of a count of fragments: black for 0, then from blue to red, white from 8 on.
std::array<std::uint8_t, 3> colorOfCount(double count);

/// RGBA bytes, opaque, bottom row first. Texture coordinates: s in red, t in green, the fraction of both
/// where they leave 0..1, which blue tells. Facing: front blue, back orange. Depth: from white (nearest) to
/// dark (farthest) by the distance from the eye.
std::vector<std::uint8_t> colorsOf(Lens lens, const TexelImage& numbers);

/// The numbers of one pixel in words: "s 0.25, t 0.5, p 0", "front", "3 fragments", "depth 0.98, 4.2 from the
/// eye", "nothing is drawn here".
std::string wordsOf(Lens lens, const float* rgba);

}  // namespace glibra::view
