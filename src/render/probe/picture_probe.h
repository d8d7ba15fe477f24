#pragma once
// Measures on small pictures how other meshes and noise textures change a scene's picture.

#include <glibra/render.h>

#include <optional>

#include "budget/budget.h"
#include "gpu/context/context.h"
#include "render/draw/view_matrices.h"
#include "render/load/shared_parts.h"
#include "scene/scene.h"

namespace glibra::render {

/// The scene, in a picture of `width` x `height` pixels. The view is fixed: it does not depend on the meshes.
struct PictureProbe {
    gpu::Context& context;
    const scene::Scene& scene;
    const RenderOptions& options;
    int width = 0, height = 0;
    const ViewMatrices& view;
    SharedParts* parts = nullptr;  ///< parts that the pictures share, or null

    /// How far contours move, in pixels of the whole picture, between the scene's picture with the shapes,
    /// noise and samples of `from` and that with those of `to`. The longer side of the small pictures has at
    /// most 200 pixels for noise; for meshes 320, or up to 800 if the bound is less than a tenth of a pixel.
    /// Nothing if they cannot be drawn; drawing the scene itself then reports why.
    [[nodiscard]] std::optional<budget::ContourShifts> shift(const budget::Choice& from,
                                                             const budget::Choice& to) const;
};

}  // namespace glibra::render
