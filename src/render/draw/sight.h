#pragma once
// Whether any part of a mesh can reach a picture, decided by the box around its vertices. No GL.

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <string_view>

#include "geometry/mesh.h"
#include "glsl/types/translated_program.h"
#include "gpu/context/capabilities.h"
#include "render/draw/view_matrices.h"
#include "render/load/shared_parts.h"
#include "scene/scene.h"

namespace glibra::render {

enum class Sight { possible, left, right, below, above, nearer, farther, betweenPixels };

/// What decides where a draw's vertices land: its matrices and the target.
struct DrawView {
    glm::dmat4 modelView{1.0}, projection{1.0};  ///< gl_Position = projection * modelView * vertex
    int width = 1, height = 1;                   ///< of the whole picture or target, in pixels
    Tile tile;                                   ///< the part of it that is drawn into
    /// The pixels by which a primitive may extend beyond its vertices: half the width of lines and points.
    double reach = 0;
    bool depthClamp = false;  ///< the near and far plane do not clip
    bool filled = true;       ///< triangles, filled
    bool oneSample = false;   ///< pixels are sampled at their centres only
};

/// A target or picture, and the part of it that is drawn.
struct Screen {
    int width = 1, height = 1;  ///< pixels
    Tile tile;
    int samples = 1;
    bool mayShift = false;  ///< by up to a pixel in any direction (SceneRenderer::setShift)
};
/// For a draw whose program places vertices by the matrices alone.
DrawView drawViewOf(const scene::Draw& draw, geometry::Topology topology, const ViewMatrices& view,
                    const Screen& screen, const gpu::Capabilities& driver);
/// True if nothing but the program and the matrices decides where the vertices land, and clipping is as
/// sightOf() assumes: no depth clamping, no polygon mode, no viewport, no vertex inputs of the scene's own.
bool isPlacedByMatrices(const scene::Draw& draw);
/// The box as a program places it; unknown if it places vertices in another way.
VertexBox placed(const VertexBox& bounds, glsl::Placement placement);

/// Every answer but `possible` is proved for drivers that compute one or two matrix-vector products in 32-bit
/// floats: all vertices lie beyond one plane of the view volume (GL 4.6, section 13.7.1), or the triangles
/// lie in front of the eye and miss every pixel centre. Rounding errors are bounded by the sums of absolute
/// values (Higham, Accuracy and Stability of Numerical Algorithms, section 3.1), times ten for safety.
Sight sightOf(const VertexBox& bounds, const DrawView& drawView);

/// For --explain: "left of what is shown".
std::string_view describe(Sight sight);

}  // namespace glibra::render
