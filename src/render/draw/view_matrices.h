#pragma once
// The matrices of a draw, with the transforms of a window (language, 6.2).

#include <glibra/render.h>

#include <glm/mat4x4.hpp>
#include <set>
#include <string>

#include "scene/scene.h"

namespace glibra::render {

glm::dmat4 asMatrix(const Matrix& numbers);
Matrix asNumbers(const glm::dmat4& matrix);

/// True if the window's transforms move what the pass draws: it is seen by the camera of a pass into the
/// window, or both cameras are derived from one. In classic scenes all passes are.
bool isMoved(const scene::NodeList& nodes, const scene::Pass& pass);

/// PassSetup::rootCamera of the passes that isMoved() is true for.
std::set<std::string> movedCameras(const scene::NodeList& nodes);

class ViewMatrices {
  public:
    ViewMatrices() = default;
    /// `eyeDistance`: how far the view policy moves the eye back, for draws with a perspective projection.
    /// `clipsFromZero`: z of reversed draws goes from 0 to w (Capabilities::clipControl).
    ViewMatrices(const ViewState& state, const glm::dmat4& sceneView, double eyeDistance,
                 bool clipsFromZero = false);

    /// Projection * scene transform. `aspect`: width / height of what is drawn into.
    [[nodiscard]] glm::dmat4 projection(const scene::Projection& projection, double aspect) const;
    /// The same for what the draw's shaders compute with: mirrored where its pass is reversed.
    [[nodiscard]] glm::dmat4 projection(const scene::Draw& draw, double aspect) const;
    /// eye transform * view policy * ModelView * object transform.
    [[nodiscard]] glm::dmat4 modelView(const scene::Draw& draw) const;
    /// The two factors of modelView(): the transforms below the camera, and the camera's view. A singular
    /// model matrix leaves no view.
    [[nodiscard]] glm::dmat4 model(const scene::Draw& draw) const;
    [[nodiscard]] glm::dmat4 view(const scene::Draw& draw) const;
    /// The same view without the transforms of the window, for passes that it does not move.
    [[nodiscard]] ViewMatrices unmoved() const;
    /// The same for a camera whose view is `shift` times that of the camera that the window moves.
    [[nodiscard]] ViewMatrices shifted(const glm::dmat4& shift) const;
    /// The same without a draw: for the axes, which are in world space.
    [[nodiscard]] glm::dmat4 worldView() const;
    [[nodiscard]] glm::dmat4 texture() const { return asMatrix(state_.texture); }
    [[nodiscard]] const ViewState& state() const { return state_; }

  private:
    ViewState state_;
    glm::dmat4 sceneView_{1.0};
    double eyeDistance_ = 0;
    bool clipsFromZero_ = false;
};

}  // namespace glibra::render
