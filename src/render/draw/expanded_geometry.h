#pragma once
// Draws with a vertex stage that does the work of the stages which a driver lacks (glsl::ExpandedGeometry).

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "gpu/context/capabilities.h"
#include "gpu/object/buffer.h"
#include "gpu/object/texture.h"
#include "gpu/state/state_tracker.h"
#include "plan/frame_plan.h"
#include "render/load/device_meshes.h"
#include "render/load/programs.h"

namespace glibra::render {

// ---- What such a vertex stage tells of its instances before they are drawn (glsl/es)

/// Sets a uniform that the translation added, if the program has it.
void setOwnUniform(const BuiltProgram& built, std::string_view name, double value);

/// Draws lines, or the edges of triangles, as quads: so many vertices in each of so many instances. False: it
/// cannot (LineWidener).
using QuadDrawer = std::function<bool(GLenum mode, int vertices, int instances)>;

class CapturedOutputs {
  public:
    /// The uniform that makes a program tell, 0 otherwise.
    struct Switch {
        const char* uniform;
        double value;
    };
    /// Runs the program and the vertex array that are bound once for each of `count` instances, and reads
    /// the outputs that the program captures, instance after instance. Waits for the device. False if the
    /// device lacks memory, which `problems` then says (gpu-E04).
    bool read(const BuiltProgram& built, const Switch& tells, int count, std::span<std::byte> to,
              Diagnostics& problems);

  private:
    std::optional<gpu::Buffer> room_;
};

// ---- Lists of numbers that a vertex stage fetches from a texture, where a driver lacks buffers for them.

using ListTexel = std::array<float, 4>;

/// The list by rows in a texture whose width is the least that OpenGL ES 3.0 has, as glsl/es fetches it.
/// Errors: those of gpu::Texture::create.
inline Result<gpu::Texture> listTexture(const gpu::Capabilities& capabilities,
                                        std::vector<ListTexel> texels) {
    constexpr std::size_t kRow = 2048;
    const std::size_t rows = std::max<std::size_t>(1, (texels.size() + kRow - 1) / kRow);
    texels.resize(rows * kRow);
    return gpu::Texture::create(capabilities, gpu::TextureShape::texture2D, gpu::TexelFormat::rgba32f,
                                {static_cast<int>(kRow), static_cast<int>(rows)},
                                {std::as_bytes(std::span(std::as_const(texels))), 4, gpu::TexelType::f32});
}

// ---- Inputs
// Vertex data that the vertex stage fetches from a texture, because it has too few attributes for the corners
// of a patch or primitive (glsl::ExpandedGeometry).

class FetchedInputs {
  public:
    /// Data of the mesh, or the same value for all vertices.
    using Source = std::variant<std::array<double, 4>, const DeviceMesh::Attribute*>;

    /// Binds the texture for a draw with the program that is bound. `sources`: in the order of
    /// ExpandedGeometry::fetched. Errors: those of gpu::Texture::create; nothing is bound then.
    Diagnostics bind(const gpu::Capabilities& capabilities, gpu::BindingTracker& bindings,
                     const BuiltProgram& built, const plan::PlannedDraw& draw, const DeviceMesh& mesh,
                     const std::vector<Source>& sources);

  private:
    struct Made {
        std::vector<Source> sources;
        std::optional<gpu::Texture> texture;
    };
    std::map<const plan::PlannedDraw*, Made> made_;
};

// ---- Patches
// Draws patches where the driver has no tessellation: it measures their levels, divides them on the processor
// and gives the coordinates to the vertex stage, which does the work of the stages (glsl/es/parts.h).

using TessellationLevels = std::array<float, 6>;  ///< four outer ones, two inner ones
inline constexpr TessellationLevels kOneLevel{1, 1, 1, 1, 1, 1};

class PatchDivider {
  public:
    /// What a draw submits: instances from `first` on, each with `patches`.
    struct Work {
        const plan::PlannedDraw* draw = nullptr;  ///< whose coordinates are kept for the next frame
        int patches = 0, first = 0, instances = 1;
        TessellationLevels levels{};  ///< where the program has no control stage
        bool asEdges = false;         ///< of triangles
        /// Binds what the draw reads on gpu::kWorkUnit, where textures are made.
        std::function<void()> bindAgain{};
        QuadDrawer quads{};  ///< of lines
    };
    /// Draws with the program and the vertex array that are bound. Draws nothing if the device lacks memory,
    /// which takeProblems() then says.
    void submit(const gpu::Capabilities& capabilities, gpu::BindingTracker& bindings,
                const BuiltProgram& built, const Work& work);
    /// What has prevented draws since the last call: draw-E05, gpu-E02, gpu-E04.
    Diagnostics takeProblems() { return std::exchange(problems_, {}); }

  private:
    struct Divided {
        std::vector<TessellationLevels> levels;
        std::optional<gpu::Texture> coordinates;
        int vertices = 0;  ///< of an instance: of all patches, or the most of one
    };
    /// Asks the program for the levels of each patch. False if the device lacks memory.
    bool measure(const BuiltProgram& built, std::vector<TessellationLevels>& levels);
    Divided divide(const gpu::Capabilities& capabilities, const BuiltProgram& built,
                   std::vector<TessellationLevels> levels);

    std::map<std::pair<const plan::PlannedDraw*, int>, Divided> divided_;  ///< by draw and first instance
    std::map<const BuiltProgram*, GLint> locations_;                       ///< of the coordinates
    CapturedOutputs captured_;
    gpu::EdgeBuffers edges_;
    Diagnostics problems_;
};

// ---- Emitted vertices
// Draws what a geometry stage emits where the driver has none and the vertex stage does its work
// (glsl/es/parts.h): each emitted vertex is computed once, and no more of them than are emitted.

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
