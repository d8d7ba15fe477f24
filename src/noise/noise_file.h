#pragma once
// Noise graphs, pictures and textures as files, and the command that writes the same.

#include <glibra/diagnostic.h>

#include <array>
#include <filesystem>
#include <string>

#include "noise/graph.h"

namespace glibra::noise {

struct NoiseFile {
    GraphOptions options;
    ColorScale colors = ColorScale::grey;  ///< of two dimensions
    int width = 600, height = 300;                       ///< pixels or texels, 1 to 16384
};

/// By the ending: .svg a graph, .tex a raw float texture, every other a picture of the graph (one dimension)
/// or of the coloured noise (two). Errors are those of writing images and files, and image-E.. for other
/// endings.
Diagnostics writeNoise(const NoiseFile& noise, const std::filesystem::path& file);

/// ".png" in small letters.
std::string endingOf(const std::filesystem::path& file);

/// "glibra noise 1 --lattice both --height 3=0.5 --size 600x300 -o noise.png": what differs from the
/// defaults.
std::string noiseCommand(const NoiseFile& noise, const std::string& file);

// The words of the command line, by the number of the enumerator.
inline constexpr std::array<const char*, 3> kLatticeWords{"value", "gradient", "both"};
inline constexpr std::array<const char*, 2> kSmoothnessWords{"cubic", "quintic"};
inline constexpr std::array<const char*, 2> kSlopesWords{"zero", "catmull-rom"};
inline constexpr std::array<const char*, 4> kColorWords{"grey", "rainbow", "heated", "uniform"};

}  // namespace glibra::noise
