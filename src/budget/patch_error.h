#pragma once
// The distance between tessellated patches and finer ones of the same surface.

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

namespace glibra::budget {

struct PatchVertex {
    glm::dvec4 clip{0, 0, 0, 1};  ///< gl_Position
    glm::dvec3 coordinate{0};     ///< gl_TessCoord
};

/// One tessellated patch: lines or triangles, one after the other.
struct Patch {
    std::size_t corners = 3;  ///< per primitive: 2 or 3
    std::vector<PatchVertex> vertices;
};

/// Returns the largest distance, in pixels of a picture of that size, between a vertex of `fine` and the
/// point of `coarse` with the same coordinates. This is an upper bound of the distance between the two
/// surfaces. Places outside the picture do not count. Infinity if a vertex is behind the eye. Nothing if some
/// coordinates are on no primitive of `coarse`, as with another number of isolines.
std::optional<double> patchError(const Patch& coarse, const Patch& fine, const glm::dvec2& size);

}  // namespace glibra::budget
