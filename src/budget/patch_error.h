#pragma once
// How far tessellated patches lie from where finer ones show the same places of the surface.

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

/// What became of one patch: lines or triangles, one after the other.
struct Patch {
    std::size_t corners = 3;  ///< of a primitive: 2 or 3
    std::vector<PatchVertex> vertices;
};

/// The largest distance in pixels, of a picture of that size, between a vertex of `fine` and the point that
/// `coarse` shows for the vertex's coordinates; places outside the picture do not count. An upper bound of
/// the distance between the two surfaces there. Infinity where a vertex is behind the eye. Nothing if some
/// coordinates are on no primitive of `coarse`: isolines of another number.
std::optional<double> patchError(const Patch& coarse, const Patch& fine, const glm::dvec2& size);

}  // namespace glibra::budget
