#pragma once
// How far the mesh of a primitive lies from the surface it stands for, by its counts: one row a command.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "budget/pixel_scale.h"
#include "scene/scene.h"

namespace glibra::budget {

/// What of a surface is drawn in its place.
enum class Fidelity {
    shape,   ///< every point of the mesh lies near the surface
    pattern  ///< ... near the point of the surface with its texture coordinates
};

/// A count among the numbers of a shape.
struct CountArgument {
    std::size_t index = 0;
    int least = 1;   ///< the shape's own minimum
    int smooth = 1;  ///< least with which light computed at the vertices looks smooth; kAsGiven: do not lower
    int byDefault = 0;  ///< of a count that stands behind the command's arguments; 0: an argument
};
/// Rows along straight lines: the shape does not need them, but what a program computes at vertices may.
inline constexpr int kAsGiven = 0;

struct SurfaceModel {
    glib::CommandId command{};
    std::array<CountArgument, 2> counts{};
    std::size_t countsUsed = 0;
    /// Both for the numbers that `complete` gives.
    Bounds (*bounds)(std::span<const double> numbers) = nullptr;
    /// Upper bound of the distance in model units; does not rise with any count.
    double (*deviation)(std::span<const double> numbers, Fidelity fidelity) = nullptr;

    [[nodiscard]] std::span<const CountArgument> usedCounts() const {
        return std::span(counts).first(countsUsed);
    }
    /// The shape's numbers with those counts behind them that the language fixes.
    [[nodiscard]] std::vector<double> complete(const scene::Shape& shape) const;
};

/// Null for what has no counts (Box), whose counts are what it shows (wires, clouds, QuadBox), or whose
/// vertices come from a file or the scene's text.
const SurfaceModel* surfaceModel(glib::CommandId command);

}  // namespace glibra::budget
