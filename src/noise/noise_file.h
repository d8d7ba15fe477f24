#pragma once
// Writes noise graphs, pictures and textures to files, and gives the command that writes the same file.

#include <glibra/diagnostic.h>

#include <array>
#include <filesystem>
#include <string>

#include "noise/graph.h"

namespace glibra::noise {

struct NoiseFile {
    GraphOptions options;
    ColorScale colors = ColorScale::grey;  ///< for two dimensions
    int width = 600, height = 300;         ///< pixels or texels, 1 to 16384
};

/// Writes the noise to a file. The extension selects the content: .svg is a graph, .tex a raw float texture,
/// any other a picture of the graph (one dimension) or of the coloured noise (two dimensions). Errors are
/// those of writing files and images.
Diagnostics writeNoise(const NoiseFile& noise, const std::filesystem::path& file);

/// Says which option changes nothing in the file, and why, as "--height 999=1: the points are 0 to 7". Empty
/// if there is none.
std::string uselessOption(const NoiseFile& noise, const std::filesystem::path& file);

/// The file's extension in lower case: ".png".
std::string endingOf(const std::filesystem::path& file);

/// Returns the command with the options that differ from their defaults:
/// "glibra noise 1 --lattice both --height 3=0.5 --size 600x300 -o noise.png".
std::string noiseCommand(const NoiseFile& noise, const std::string& file);

// The words of the command line, in the order of the enumerators.
inline constexpr std::array<const char*, 3> kLatticeWords{"value", "gradient", "both"};
inline constexpr std::array<const char*, 2> kSmoothnessWords{"cubic", "quintic"};
inline constexpr std::array<const char*, 2> kSlopesWords{"zero", "catmull-rom"};
inline constexpr std::array<const char*, 6> kColorWords{"grey",    "rainbow", "heated",
                                                        "uniform", "sky",     "fire"};

}  // namespace glibra::noise
