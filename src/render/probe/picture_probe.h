#pragma once
// Measures how other meshes and noise textures change a scene's picture.

#include <optional>
#include <vector>

#include "budget/budget.h"
#include "render/scene_state.h"

namespace glibra::render {

/// The scene of a state, as its picture shows it. The view is fixed: it does not depend on the meshes.
struct PictureProbe {
    const SceneState& state;
    const std::vector<double>& moments;  ///< seconds; at least one

    /// How far contours move, in pixels of the whole picture, between the scene's picture with the shapes,
    /// noise and samples of `from` and that with those of `to`, at the moment that shows most. The longer
    /// side of the small pictures has at most 200 pixels for noise; for meshes 320, or up to 800 if the bound
    /// is less than a tenth of a pixel. Nothing if they cannot be drawn; drawing the scene itself then
    /// reports why.
    [[nodiscard]] std::optional<budget::ContourShifts> shift(const budget::Choice& from,
                                                             const budget::Choice& to) const;
};

}  // namespace glibra::render
