#pragma once
// Runs patches through the driver's tessellation stages and returns the vertices.

#include <glibra/result.h>

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "gpu/context/capabilities.h"
#include "gpu/object/buffer.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/program.h"

namespace glibra::bench {

enum class Spacing { equal, fractionalEven, fractionalOdd };
inline constexpr std::array kSpacings{Spacing::equal, Spacing::fractionalEven, Spacing::fractionalOdd};
/// "equal spacing" and so on.
std::string_view name(Spacing spacing);

/// What the evaluation shader computes. The first three are bicubic patches of 16 control points, rows along
/// v: by a sum of Bernstein polynomials, by repeated interpolation, and by a sum of symmetric pairs marked
/// `precise`, which gives an edge the same bits from both ends (after I. Castano, Water-tight, textured,
/// displaced subdivision surface tessellation, NVIDIA, 2008). An octant of the unit sphere is a triangle
/// whose points are normalised. PN triangles take three corners and three normals (A. Vlachos et al., Curved
/// PN Triangles, 2001).
enum class Evaluation { bernstein, interpolated, symmetric, sphereOctant, pnTriangle };

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
    static Result<Tessellator> create(const gpu::Capabilities& capabilities, Evaluation evaluation,
                                      Spacing spacing, std::span<const glm::vec3> points);

    /// Three vertices per triangle.
    Result<std::vector<TessellatedVertex>> capture(const Levels& levels,
                                                   int patchesPerDraw = kPatchesPerDraw) const;
    [[nodiscard]] int patches() const { return patches_; }
    /// Draws all patches into the bound target, seen along -z, grey by height, and waits.
    void draw(const Levels& levels) const;

  private:
    explicit Tessellator(gpu::Program program, gpu::Buffer points)
        : program_(std::move(program)), points_(std::move(points)) {}
    void prepare(const Levels& levels) const;

    const gpu::Capabilities* capabilities_ = nullptr;
    gpu::Program program_;
    gpu::Buffer points_;
    int patches_ = 1;
};

}  // namespace glibra::bench
