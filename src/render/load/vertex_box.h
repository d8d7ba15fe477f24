#pragma once
// The box around the vertices of a mesh.

#include <glm/vec4.hpp>

namespace glibra::geometry {
struct Mesh;
}

namespace glibra::render {

/// The smallest and largest value of each coordinate of all vertices, in model space; w is 1 if the mesh has
/// none.
struct VertexBox {
    glm::dvec4 low{0.0}, high{0.0};
    bool isKnown = false;  ///< false: there are no vertices, or one is not finite
};
VertexBox boundsOf(const geometry::Mesh& mesh);

}  // namespace glibra::render
