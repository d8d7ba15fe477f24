#pragma once
// Debug views show something of the pipeline in place of the picture: as numbers and as colours. The window
// offers them as "Show".

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "view/debug_view/texels.h"

namespace glibra::view {

/// `picture` is no debug view. `normals` is the picture with normals as lines. The others show a number for
/// every pixel that something is drawn on. The scene's own stages decide which pixels these are, including
/// what its fragment stages discard. Alpha is 0 where nothing is drawn.
enum class DebugView {
    picture,
    normals,
    coordinates,  ///< texture coordinates s, t, p
    facing,       ///< red: 1 front, 0 back
    overdraw,     ///< red: fragments that passed the depth test, in drawing order
    layers,       ///< red: all fragments, without depth test
    depth,        ///< red: window depth 0..1; green: distance from the eye's plane, in units of eye space
};
inline constexpr int kDebugViewCount = 7;

/// "picture", "normals", "texture coordinates", "facing", "overdraw", "layers", "depth".
std::string_view nameOf(DebugView kind);

/// The range of the shown numbers, for the legend.
struct ValueRange {
    double lowest = 0, highest = 0;  ///< over all pixels that something is drawn on
    bool isEmpty = true;
};
ValueRange rangeOf(DebugView kind, const TexelImage& numbers);

/// The colour (red, green, blue) for a number of fragments: black for 0, then from blue to red, white from 8.
std::array<std::uint8_t, 3> colorOfCount(double count);

/// Opaque RGBA bytes, bottom row first. Texture coordinates: s is red and t is green; outside 0..1 their
/// fractions are shown and blue is added. Facing: front blue, back orange. Depth: white (nearest) to dark
/// (farthest), by the distance from the eye.
std::vector<std::uint8_t> colorsOf(DebugView kind, const TexelImage& numbers);

/// The numbers of one pixel as text: "s 0.25, t 0.5, p 0", "front", "3 fragments", "depth 0.98, 4.2 from the
/// eye", "nothing is drawn here". `rgba` points to its four numbers.
std::string wordsOf(DebugView kind, const float* rgba);

}  // namespace glibra::view
