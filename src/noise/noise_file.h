#pragma once
// Lattice noise for graphs and pictures in teaching: its values, and files of them.

#include <glibra/diagnostic.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace glibra::noise {

// Lattice noise in one and two dimensions with adjustable parts, for graphs and pictures in teaching. The
// noise of scenes is in noise.h.

/// The random quantities at lattice points. `value`: heights; Slopes selects the gradients. `gradient`:
/// gradients; all heights are 0. `both`: heights and gradients.
enum class Lattice { value, gradient, both };
/// Hermite interpolation between lattice points: cubic, or quintic with curvature 0 at the points (Perlin,
/// Improving Noise, 2002).
enum class Smoothness { cubic, quintic };
/// Gradients of value noise: flat points, or the Catmull-Rom slope (half the difference of the neighbours).
enum class Slopes { zero, catmullRom };

struct GraphOptions {
    int dimensions = 1;  ///< 1 or 2
    int cells = 8;       ///< cells of the first octave per period, 2..256
    std::uint32_t seed = 0;
    Lattice lattice = Lattice::value;
    Smoothness smoothness = Smoothness::quintic;
    Slopes slopes = Slopes::zero;
    int octaves = 1;          ///< 1..8; each has half the height and twice the frequency of the one before
    bool turbulence = false;  ///< add the absolute values of the octaves
    std::map<int, double> heights{};    ///< by point of the first octave; replace the random ones in -1..1
    std::map<int, double> gradients{};  ///< likewise, along x, in height per cell
    /// Second derivatives along x by point of the first octave, in height per cell squared; 0 for all other
    /// points. Only quintics use them, since heights and gradients determine a cubic.
    std::map<int, double> curvatures{};
    friend bool operator==(const GraphOptions&, const GraphOptions&) = default;
};

inline constexpr int kMostGraphOctaves = 8;
inline constexpr int kMostGraphCells = 256;

/// The noise at x (and y), measured in cells of the first octave, with period `cells`. Point i of a 2D
/// lattice is (i mod cells, i / cells).
double graphNoise(const GraphOptions& options, double x, double y = 0);
/// The first octave at one of its lattice points: height, and gradient and curvature along x.
struct GraphPoint {
    double height = 0, gradient = 0, curvature = 0;
};
GraphPoint graphPoint(const GraphOptions& options, int point);

/// Graphs and pictures show values in -range..range, or 0..range for turbulence. The range is the largest sum
/// of all octaves for heights and gradients in -1..1: gradients 1 and -1 at the ends of a cell lift its
/// middle by 1/4 in a cubic and by 5/16 in a quintic, and in two dimensions both axes do so.
double graphRange(const GraphOptions& options);

enum class ColorScale { grey, rainbow, heated, uniform, sky, fire };
/// Returns red, green and blue in 0..1 for t in 0..1. `rainbow`: from blue over green to red. `heated`: from
/// black over red and yellow to white, like hot metal. `uniform`: the lightness in OKLab (Ottosson, 2020)
/// rises evenly. `sky`: from blue to white. `fire`: from red to yellow.
std::array<double, 3> colorOf(ColorScale scale, double t);

/// Returns the graph over one period as the text of an SVG file of this size, with axis, points and curve.
std::string graphSvg(const GraphOptions& options, int width, int height);
/// Returns the graph as RGB bytes, top row first. The curve is antialiased.
std::vector<std::uint8_t> graphPixels(const GraphOptions& options, int width, int height);
/// Returns coloured 2D noise over one period as RGB bytes, top row first. graphRange() is mapped to the whole
/// scale.
std::vector<std::uint8_t> noisePixels(const GraphOptions& options, ColorScale scale, int width, int height);
/// Returns a raw float texture (language, 8.3) of one or two dimensions: the noise in red, green and blue,
/// alpha 1.
std::vector<std::byte> noiseTexture(const GraphOptions& options, int width, int height);

// Writes noise graphs, pictures and textures to files, and gives the command that writes the same file.

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
