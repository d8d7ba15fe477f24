#pragma once
// Draws what a geometry stage emits where the driver has none and the vertex stage does its work
// (glsl/es/geometry.h): each emitted vertex is computed once, and no more of them than are emitted.

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "gpu/object/buffer.h"
#include "render/draw/captured_outputs.h"

namespace glibra::render {

/// What a geometry stage emits for one primitive: a bit for each vertex that begins a strip, and how many
/// vertices there are.
struct EmittedStrips {
    std::array<std::uint32_t, 8> begins{};
    std::uint32_t vertices = 0;
    friend auto operator<=>(const EmittedStrips&, const EmittedStrips&) = default;
};

/// The vertices of points, lines or triangles (1, 2 or 3 `corners`) in the order in which strips have them:
/// every second triangle has its first two in the other order (OpenGL 4.6 Core, 10.1.8).
std::vector<std::uint32_t> indicesOf(const EmittedStrips& strips, int corners);

class StripDrawer {
  public:
    /// Draws `count` instances with the program and the vertex array that are bound. `asEdges`: of
    /// triangles. `quads`: of lines, or null.
    void draw(const BuiltProgram& built, int count, bool asEdges, const QuadDrawer& quads);
    /// What has prevented draws since the last call: gpu-E04.
    Diagnostics takeProblems() { return std::exchange(problems_, {}); }

  private:
    struct Indices {
        gpu::Buffer buffer;
        int count = 0;
    };
    const Indices* indicesFor(const EmittedStrips& strips, int corners);

    CapturedOutputs captured_;
    std::map<std::pair<EmittedStrips, int>, Indices> known_;
    gpu::EdgeBuffers edges_;
    Diagnostics problems_;
};

}  // namespace glibra::render
