#pragma once
// What other meshes and noise textures do to a picture, measured on small pictures of the scene.

#include <glibra/render.h>

#include <optional>

#include "budget/budget.h"
#include "gpu/context.h"
#include "render/shared_parts.h"
#include "render/view_matrices.h"
#include "scene/scene.h"

namespace glibra::render {

/// Of a scene in a picture of `width` x `height`, seen by `view` whatever the meshes are.
struct PictureProbe {
    gpu::Context& context;
    const scene::Scene& scene;
    const RenderOptions& options;
    int width = 0, height = 0;
    const ViewMatrices& view;
    SharedParts* parts = nullptr;  ///< what the pictures have in common, or null

    /// How far contours move from the scene's picture with the shapes, noise and samples of `from` to that
    /// with those of `to`, in pixels of the whole picture. It is measured on small pictures: for noise of at
    /// most 200 pixels a side, for meshes of 320, or up to 800 where a tenth of a pixel is more than the
    /// bound. Nothing if they cannot be drawn: whoever draws the scene itself is told why.
    [[nodiscard]] std::optional<budget::ContourShifts> shift(const budget::Choice& from,
                                                             const budget::Choice& to) const;
};

}  // namespace glibra::render
