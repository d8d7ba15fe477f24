#pragma once
// Whether anything of a mesh can reach a picture, by the box around its vertices. No GL.

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <string_view>

#include "geometry/mesh.h"
#include "glsl/types/translated_program.h"
#include "gpu/capabilities.h"
#include "render/tile.h"
#include "render/view_matrices.h"
#include "scene/scene.h"

namespace glibra::render {

/// Smallest and largest of each coordinate of all vertices, model space; w is 1 where the mesh has none.
struct Bounds {
    glm::dvec4 low{0.0}, high{0.0};
    bool isKnown = false;  ///< false: there are no vertices, or one that is no finite number
};
Bounds boundsOf(const geometry::Mesh& mesh);
enum class Sight { possible, left, right, below, above, nearer, farther, betweenPixels };

/// What a mesh is drawn with, and into.
struct Lens {
    glm::dmat4 modelView{1.0}, projection{1.0};  ///< gl_Position = projection * modelView * vertex
    int width = 1, height = 1;                   ///< of the whole picture or target, pixels
    Tile tile;                                   ///< the part of it that is drawn into
    /// Pixels by which a primitive may reach beyond its vertices: half the width of lines and points.
    double reach = 0;
    bool filled = true;      ///< triangles, filled
    bool oneSample = false;  ///< pixels are sampled at their centres alone
};

/// A target or picture, and the part of it that is drawn.
struct Screen {
    int width = 1, height = 1;  ///< pixels
    Tile tile;
    int samples = 1;
    bool mayShift = false;  ///< by up to a pixel in any direction (SceneRenderer::setShift)
};
/// The lens of a draw whose program places vertices by the matrices alone.
Lens lensOf(const scene::Draw& draw, geometry::Topology topology, const ViewMatrices& view,
            const Screen& screen, const gpu::Capabilities& driver);
/// The bounds of what that program places; unknown if it places them otherwise.
Bounds placed(const Bounds& bounds, glsl::Placement placement);

/// Anything but `possible` is proved for a driver that computes in 32-bit floats, in one or two products of
/// matrix and vector: all vertices lie beyond one plane of the view volume (GL 4.6, section 13.7.1), or the
/// triangles, which lie before the eye, miss every pixel's centre. Errors of rounding are bounded by the sums
/// of absolute values (Higham, Accuracy and Stability of Numerical Algorithms, section 3.1) with tenfold
/// allowance.
Sight sightOf(const Bounds& bounds, const Lens& lens);

/// For --explain: "left of what is shown".
std::string_view describe(Sight sight);

}  // namespace glibra::render
