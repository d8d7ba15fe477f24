#pragma once
// The state of a draw as text: what is drawn, the tests, blending, textures and matrices.

#include <string>
#include <vector>

#include "plan/frame_plan.h"
#include "render/draw/view_matrices.h"
#include "scene/scene.h"

namespace glibra::view {

struct StateLine {
    std::string name;               ///< "depth test"
    std::string value;              ///< "lequal, writes"; the rows of a matrix as lines
    bool isChanged = false;         ///< differs from the state at the beginning of a pass
    scene::TextureIndex texture{};  ///< that the line is about; none
};

/// `aspect`: width / height of what is drawn into. `view`: of its pass.
std::vector<StateLine> stateOf(const scene::Scene& scene, const plan::FramePlan& plan,
                               const plan::PlannedDraw& draw, const render::ViewMatrices& view,
                               double aspect);

/// The matrix as lines with its rows.
std::string matrixText(const glm::dmat4& matrix);

}  // namespace glibra::view
