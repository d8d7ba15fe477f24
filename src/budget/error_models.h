#pragma once
// The errors that finite numbers cause on a picture: of cells of a mesh, of patches, of samples and of
// texels.

#include <fmt/format.h>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/shapes/primitive.h"
#include "scene/scene.h"

namespace glibra::budget {

// How long a small step in model space can become on a picture.

/// How far outside the picture a place may lie and still count: a mesh reaches further in than its surface.
inline constexpr double kPictureMargin = 1.05;

/// The largest factor, in pixels per model unit, by which a step between two points of the extent is
/// lengthened on the picture, over all directions and all places that can be seen; 0 if no place can be seen.
/// `clipFromModel` is Projection * ModelView; width and height are those of the picture in pixels. Nothing if
/// there is no bound: the matrix is not finite, or a place that can be seen is at w <= 0.
///
/// At window coordinates (x, y) = (width X/w, height Y/w)/2 the Jacobian's rows are
/// width/2 (a_X - X/w a_w) / w and height/2 (a_Y - Y/w a_w) / w, a the rows of the matrix without their last
/// column. Its norm is convex in X/w and Y/w, so it is largest at a corner of the rectangle that the extent
/// and the view share, at the smallest w.
std::optional<double> pixelsPerUnit(const glm::dmat4& clipFromModel, const geometry::Extent& extent,
                                    double width, double height);

// Errors in words.

/// Returns "0.249 px", with enough digits to distinguish it from a bound.
inline std::string pixelText(double pixels) {
    return fmt::format("{:.3g} px", pixels);
}

/// The share of the pixels of a picture, 0..1, that may have another colour for another reason than contours
/// that are off.
inline constexpr double kMostColored = .001;

/// "about 0.2 px off, and 3 of 1000 pixels have another colour"
inline std::string changeText(double pixels, double colored) {
    std::string text = fmt::format("about {} off", pixelText(pixels));
    if (colored <= kMostColored) return text;
    return text + fmt::format(", and {:.2g} of 1000 pixels have another colour", 1000 * colored);
}

// The distance between tessellated patches and finer ones of the same surface.

struct PatchVertex {
    glm::dvec4 clip{0, 0, 0, 1};  ///< gl_Position
    glm::dvec3 coordinate{0};     ///< gl_TessCoord
};

/// One tessellated patch: lines or triangles, one after the other.
struct Patch {
    std::size_t corners = 3;  ///< per primitive: 2 or 3
    std::vector<PatchVertex> vertices;
};

/// Returns the largest distance, in pixels of a picture of that size, between a vertex of `fine` and the
/// point of `coarse` with the same coordinates. This is an upper bound of the distance between the two
/// surfaces. Places outside the picture do not count. Infinity if a vertex is behind the eye. Nothing if some
/// coordinates are on no primitive of `coarse`, as with another number of isolines.
std::optional<double> patchError(const Patch& coarse, const Patch& fine, const glm::dvec2& size);

// The errors that a number of samples per pixel and the texels of a noise texture cause.

/// Returns how many pixels an edge may lie away from where the samples show it, for a regular pattern of that
/// many samples: half the distance of its rows, 1 / (2 sqrt n).
double edgeError(int samples);

/// Returns the smallest power of two whose edgeError is at most maxError (pixels), but no more than `most`.
int leastSamples(double maxError, int most);

/// The sizes among which noise textures are chosen: whole numbers of texels per cell of the finest octave.
std::span<const int> noiseSizes(int dimensions);

/// The size and the texels of a noise texture.
struct NoiseFormat {
    int size = 64;
    scene::NoiseTexels texels = scene::NoiseTexels::bytes;
    friend bool operator==(const NoiseFormat&, const NoiseFormat&) = default;
};

/// Returns the distance, in periods of the texture, that 999 of 1000 contours of the four octaves' sum do not
/// exceed with linear filtering: the error of the value divided by the root mean square of the gradient, 2.57
/// and 2.17 per period. The first part is the interpolation between texels, which falls with size^2 once the
/// finest octave (32 cells per period) is resolved; the second is the rounding of the texels. dimensions is 2
/// or 3, the size at least 32. Floats would round less than 16 bits do, but at all these sizes the rounding
/// of 16 bits is 70 times smaller than the interpolation error.
double noiseError(int dimensions, NoiseFormat format);

/// Two sizes that are quickly made; the difference between their pictures shows how a program uses noise.
inline constexpr std::array kNoiseProbeSizes{48, 64};

/// Returns how many periods contours move on average from a texture of the first of kNoiseProbeSizes to one
/// of the second, both with 16 bits: the mean change of the value divided by the mean gradient, measured.
double meanNoiseStep(int dimensions);

/// Returns the smallest of noiseSizes, with bytes or else with 16 bits, for which errorOf is at most
/// maxError; if there is none, the largest size with 16 bits. 16 bits cost little compared with the next
/// size, which may have up to eight times as many texels.
NoiseFormat leastNoise(int dimensions, double maxError, const std::function<double(NoiseFormat)>& errorOf);

// How far the mesh of a primitive lies from its surface, as a function of its counts: the primitive's row as
// --max-error reads it.

using geometry::Fidelity;
using geometry::kAsGiven;

/// A count among the numbers of a shape.
struct CountArgument {
    std::size_t index = 0;
    int least = 1;  ///< the shape's own minimum
    int smooth =
        1;  ///< least with which light computed at the vertices looks smooth; kAsGiven: never lowered
    bool isFixed = false;  ///< no scene can state it
    std::string_view name{};
};

struct SurfaceModel {
    glib::CommandId command{};
    const geometry::PrimitiveSpec* spec = nullptr;
    std::array<CountArgument, 2> counts{};
    std::size_t countsUsed = 0;

    /// Where the surface lies. `numbers` are complete.
    [[nodiscard]] geometry::Extent extent(geometry::Numbers numbers) const { return spec->extent(numbers); }
    /// An upper bound of the distance between mesh and surface in model units. It does not rise with any
    /// count. `numbers` are complete.
    [[nodiscard]] double deviation(geometry::Numbers numbers, Fidelity fidelity) const {
        return spec->deviation(numbers, fidelity);
    }
    [[nodiscard]] std::span<const CountArgument> usedCounts() const {
        return std::span(counts).first(countsUsed);
    }
    /// All numbers of the shape, those that the language fixes included.
    [[nodiscard]] std::vector<double> complete(const scene::Shape& shape) const {
        return geometry::completeNumbers(*spec, shape.numbers);
    }
};

/// Null if the command's row has no deviation: shapes without counts, shapes whose counts are what they show,
/// and shapes whose vertices come from a file or from the scene's text.
const SurfaceModel* surfaceModel(glib::CommandId command);

}  // namespace glibra::budget
