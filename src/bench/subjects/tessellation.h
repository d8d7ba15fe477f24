#pragma once
// Patches through the driver's tessellation stages, and a curved PN triangle in double.

#include <array>
#include <glm/vec3.hpp>

#include "bench/core/device.h"

namespace glibra::bench {

/// "equal_spacing", "fractional_even_spacing" and "fractional_odd_spacing", as GLSL's layouts name them.
inline constexpr std::array<std::string_view, 3> kSpacings{"equal_spacing", "fractional_even_spacing",
                                                           "fractional_odd_spacing"};

/// What the evaluation shader computes.
struct Surface {
    const char* name;
    const char* layout;             ///< "quads" or "triangles"
    std::size_t points;             ///< control points of a patch
    std::string_view glsl, more{};  ///< functions, among them `vec3 surface()`
};
/// Bicubic patches of 16 control points, rows along v: by a sum of Bernstein polynomials, by repeated
/// interpolation, and by a sum of symmetric pairs marked `precise`, which gives an edge the same bits from
/// both ends (after I. Castano, Water-tight, textured, displaced subdivision surface tessellation, NVIDIA,
/// 2008).
extern const Surface kBernstein, kInterpolated, kSymmetric;
/// An octant of the unit sphere is a triangle whose points are normalised. PN triangles take three corners
/// and three normals (A. Vlachos et al., Curved PN Triangles, 2001).
extern const Surface kSphereOctant, kPnTriangle;

struct TessellatedVertex {
    glm::vec3 position{0};
    glm::vec3 coordinate{0};  ///< gl_TessCoord
    int patch = 0;
};

/// Levels of all patches. The outer levels are equal; the inner ones may grow from patch to patch, by 0, 1,
/// 2, 0, 1 ... steps.
struct Levels {
    float outer = 1, inner = 1, innerStep = 0;
};

class Tessellator {
  public:
    /// llvmpipe (Mesa 22.3) numbers the vertices of one draw with 16 bits and repeats the first patches
    /// beyond that; 8 patches of level 64 stay below.
    static constexpr int kPatchesPerDraw = 8;

    /// `points`: the control points of all patches, at most 1024.
    Tessellator(Bench& bench, const Surface& surface, std::string_view spacing,
                std::span<const glm::vec3> points);

    /// Three vertices per triangle.
    [[nodiscard]] std::vector<TessellatedVertex> capture(const Levels& levels,
                                                         int patchesPerDraw = kPatchesPerDraw) const;
    [[nodiscard]] int patches() const { return patches_; }
    /// Draws all patches into a cleared picture of 256 x 256 pixels, seen along -z, grey by height, and
    /// waits.
    [[nodiscard]] Timing timeDrawing(const Levels& levels) const;

  private:
    /// Calls visit(count) for the patches of each draw.
    template <class Visit>
    void forEachDraw(const Levels& levels, int patchesPerDraw, const Visit& visit) const;
    Bench& bench_;
    Shader shader_;
    gpu::Buffer points_;
    int patches_;
};

/// The cubic Bezier triangle through three corners with normals (A. Vlachos et al., Curved PN Triangles,
/// 2001), evaluated by de Casteljau's algorithm.
class PnTriangle {
  public:
    PnTriangle(const std::array<glm::dvec3, 3>& corners, const std::array<glm::dvec3, 3>& normals);

    /// The point at barycentric coordinates, which add up to 1.
    [[nodiscard]] glm::dvec3 at(const glm::dvec3& barycentric) const;
    /// The distance of a point from the surface, searched by Gauss-Newton steps from the given coordinates.
    /// The surface continues beyond its edges.
    [[nodiscard]] double distance(const glm::dvec3& point, const glm::dvec3& start) const;

  private:
    struct Near {
        glm::dvec3 position{0};
        std::array<glm::dvec3, 3>
            last{};  ///< the last triangle of the algorithm: its plane is tangent to the surface
    };
    [[nodiscard]] Near deCasteljau(const glm::dvec3& barycentric) const;

    std::array<glm::dvec3, 10> points_{};  ///< b(i,j,k), i falling, then j falling
};

std::vector<Figure> measureTessellation(Bench& bench);

}  // namespace glibra::bench
