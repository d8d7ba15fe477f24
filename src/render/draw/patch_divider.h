#pragma once
// Draws patches where the driver has no tessellation: it measures their levels, divides them on the processor
// and gives the coordinates to the vertex stage, which does the work of the stages (glsl/es/tessellation.h).

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "gpu/context/capabilities.h"
#include "gpu/object/buffer.h"
#include "gpu/object/texture.h"
#include "gpu/state/state_tracker.h"
#include "plan/frame_plan.h"
#include "render/draw/captured_outputs.h"
#include "render/load/programs.h"

namespace glibra::render {

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

}  // namespace glibra::render
