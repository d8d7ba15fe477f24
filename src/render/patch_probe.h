#pragma once
// What the tessellation stages of a draw make of its patches, for other levels than the scene's.

#include <glibra/render.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "budget/budget.h"
#include "gpu/context.h"
#include "scene/scene.h"

namespace glibra::render {

/// Draws one draw of a scene in small pictures and captures the vertices behind the evaluation stage.
class PatchProbe {
  public:
    /// Of a scene in a picture of `width` x `height`; both must outlive the probe.
    PatchProbe(gpu::Context& context, const scene::Scene& scene, const RenderOptions& options, int width,
               int height);
    PatchProbe(const PatchProbe&) = delete;
    PatchProbe& operator=(const PatchProbe&) = delete;
    ~PatchProbe();

    /// The patches of the draw at Scene::passes[pass].steps[step], with values of uniforms in place of the
    /// scene's: all of them, or of more than 64 every second, third ... Nothing if it cannot be drawn or
    /// captured.
    std::optional<std::vector<budget::Patch>> patches(std::size_t pass, std::size_t step,
                                                      std::span<const budget::LevelValue> values);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace glibra::render
