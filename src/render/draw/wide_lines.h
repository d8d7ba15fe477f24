#pragma once
// Draws lines that are wider than the lines of a driver of OpenGL ES, as quads (glsl::WideLines): the vertex
// stage runs once for each vertex, its outputs are captured and go into a texture, and it runs again for the
// corners of the quads, which read both ends there.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "gpu/context/capabilities.h"
#include "gpu/object/buffer.h"
#include "gpu/object/texture.h"
#include "gpu/state/state_tracker.h"
#include "plan/frame_plan.h"
#include "render/load/programs.h"

namespace glibra::render {

class LineWidener {
  public:
    /// Of the draw whose state is set.
    struct Look {
        const plan::PlannedDraw* draw = nullptr;  ///< whose texture is kept for the next frame
        const BuiltProgram* built = nullptr;
        double viewportWidth = 1, viewportHeight = 1, lineWidth = 1;  ///< pixels
        bool hasSamples = false;                                      ///< the target has several
        glsl::WideMode mode = glsl::WideMode::fromMinusW;
        const gpu::VertexArray* vertices = nullptr;
        /// Binds what the draw reads on gpu::kWorkUnit, where textures are made.
        std::function<void()> bindAgain{};
    };
    /// The vertices of lines, or of triangles whose edges are drawn.
    struct Lines {
        const gpu::Buffer* indices = nullptr;  ///< null: the vertices in order
        std::uint64_t offset = 0;              ///< bytes before the first index
        int count = 0;                         ///< of indices or vertices
        GLenum mode = GL_LINES;                ///< one of gpu::edgesOf
        int instances = 1;
    };

    LineWidener(const gpu::Capabilities& capabilities, gpu::BindingTracker& bindings)
        : capabilities_(capabilities), bindings_(bindings) {}

    /// The program that is bound, which has WideLines, finds its texture, whatever is drawn with it. Before
    /// other textures are bound.
    void prepare(const BuiltProgram& built);
    /// Draws with the program and the vertex array of `look`, which are bound, and leaves both. False: it
    /// cannot, and nothing is drawn; takeProblems() then says why.
    bool draw(const Look& look, const Lines& lines);
    /// What has prevented wide lines since the last call: draw-W04, gpu-E04, draw-E05.
    Diagnostics takeProblems() { return std::exchange(problems_, {}); }

  private:
    using Key = std::tuple<std::uint64_t, std::uint64_t, int, GLenum>;  ///< what lines depend on
    struct Ends {
        Key key{};
        std::vector<std::uint32_t> vertexPairs{};  ///< two for each line, then zeros to the end of a row
        int pairs = 0;
        std::int64_t vertices = 0;
        std::optional<gpu::Texture> texture{};
        bool isFilled = false;  ///< the texture has the pairs
    };
    /// The last ones are those of PatchDivider and FetchedInputs.
    [[nodiscard]] int unit() const { return capabilities_.combinedTextureUnits - 3; }
    /// Leaves the texture bound, and its unit active. False if the device lacks memory.
    bool makeTexture(std::optional<gpu::Texture>& texture, int rows);
    /// Finds the pairs of vertices. Waits for the device if the indices are new.
    static void list(Ends& ends, const Lines& lines);
    /// Captures the outputs, which fill so many rows at most.
    bool capture(const Ends& ends, const BuiltProgram& built, int instances, std::size_t rows);

    const gpu::Capabilities& capabilities_;
    gpu::BindingTracker& bindings_;
    std::map<const plan::PlannedDraw*, Ends> ends_;
    std::set<const BuiltProgram*> prepared_;
    std::optional<gpu::Texture> nothing_;  ///< for draws without wide lines
    std::optional<gpu::Buffer> outputs_;
    std::optional<gpu::VertexArray> noInputs_;
    bool isReported_ = false;  ///< that lines are too many
    Diagnostics problems_;
};

}  // namespace glibra::render
