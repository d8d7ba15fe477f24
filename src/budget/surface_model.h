#pragma once
// How far the mesh of a primitive lies from its surface, as a function of its counts: the primitive's row as
// --max-error reads it.

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/shapes/primitive.h"
#include "scene/scene.h"

namespace glibra::budget {

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
