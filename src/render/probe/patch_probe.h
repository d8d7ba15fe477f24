#pragma once
// The vertices that the tessellation stages of a draw make of its patches, at other levels than the scene's.

#include <glibra/render.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "budget/budget.h"
#include "gpu/context/context.h"
#include "gpu/object/buffer.h"
#include "gpu/object/program.h"
#include "render/load/programs.h"
#include "render/load/shared_parts.h"
#include "render/scene_state.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace glibra::render {

/// Draws one draw of a scene in small pictures and captures the output of the evaluation stage.
class PatchProbe {
  public:
    /// Prepares the probe for a picture of `width` x `height` pixels. The context and the scene must outlive
    /// it.
    PatchProbe(gpu::Context& context, const scene::Scene& scene, const RenderOptions& options, int width,
               int height);
    PatchProbe(const PatchProbe&) = delete;
    PatchProbe& operator=(const PatchProbe&) = delete;

    /// The patches of the draw at Scene::passes[pass].steps[step], with these values in place of the scene's.
    /// If there are more than 64 patches, only every second, third ... is captured. Nothing if drawing or
    /// capturing fails.
    std::optional<std::vector<budget::Patch>> patches(std::size_t pass, std::size_t step,
                                                      std::span<const budget::LevelValue> values);

  private:
    /// Loads the scene at the first call. False if that fails.
    bool prepare();
    const gpu::Program* capturingFor(const BuiltProgram& built);
    std::optional<std::vector<budget::Patch>> capture(const plan::PlannedDraw& draw,
                                                      std::span<const budget::LevelValue> values);

    gpu::Context& context_;
    const scene::Scene& scene_;
    RenderOptions options_;
    Stats stats_;
    SharedParts parts_;
    std::unique_ptr<SceneState> loaded_;
    std::vector<std::pair<const BuiltProgram*, gpu::Program>> programs_;
    std::optional<gpu::Buffer> buffer_;
};

}  // namespace glibra::render
