#pragma once
// The matrices of a draw, with the transforms of a window (language, 6.2), and the tiles of a picture.

#include <glibra/render.h>

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace glibra::image {
struct Image;
}

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

// ---- Tiles
// Pictures larger than the driver or its memory allows are drawn in parts, which join without a seam.

/// A rectangle of the picture, in pixels from the picture's lower left corner.
struct Tile {
    int x = 0, y = 0, width = 0, height = 0;
};

/// Tiles of one size, and the part of each tile that goes into the picture. A tile is larger than its part by
/// a margin, as far as the picture reaches, because points and lines that begin outside the part may extend
/// into it.
struct TileGrid {
    std::vector<Tile> tiles;
    std::vector<Tile> parts;
};

/// Returns one tile if the picture fits into `largest` (pixels per side) and `mostPixels`, and `wanted` (the
/// side of a part) is 0.
TileGrid tileGrid(int width, int height, int wanted, int largest, std::int64_t mostPixels);

/// Copies the pixels of a part (top row first) to its place in the picture.
void pasteTile(std::span<const std::byte> pixels, const Tile& part, image::Image& picture);

}  // namespace glibra::render
