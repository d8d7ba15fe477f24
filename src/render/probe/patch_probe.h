#pragma once
// The vertices that the tessellation stages of a draw make of its patches, at other levels than the scene's.

#include <glibra/render.h>

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "budget/budget.h"
#include "gpu/object/buffer.h"
#include "gpu/object/program.h"
#include "render/load/programs.h"
#include "render/load/shared_parts.h"
#include "render/scene_state.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace glibra::render {

// ---- Options

struct ProbeOptions {
    RenderOptions options;
    double shrink = 1;  ///< pixels of the picture per pixel of the probe, along one side; at least 1
};

/// Options for a small picture that is measured and not shown: of the same aspect, at most `largestSide`
/// pixels per side, with one sample, without error bound, tiles, axes and warnings.
ProbeOptions probeOptions(const RenderOptions& options, int width, int height, int largestSide);

/// The moments (seconds) at which a scene is measured: that of the picture, or the beginning, the middle and
/// the end of an animation.
std::vector<double> momentsOf(const RenderOptions& options);

// ---- Patches

/// Draws one draw of a scene in small pictures and captures the output of the evaluation stage.
class PatchProbe {
  public:
    /// Prepares the probe for the scene and the picture of a state, which must outlive it, seen at these
    /// moments (seconds; at least one).
    PatchProbe(const SceneState& state, std::vector<double> moments);
    PatchProbe(const PatchProbe&) = delete;
    PatchProbe& operator=(const PatchProbe&) = delete;

    /// The patches of the draw at Scene::passes[pass].steps[step] at all moments, in whatever form it states
    /// them: a list, a shape, vertices in order or by indices, instances. If there are more than 64, the 64
    /// that low levels show worst are captured; of more than 1024, every second, third ... is looked at.
    /// Nothing if drawing or capturing fails.
    std::optional<std::vector<budget::Patch>> patches(std::size_t pass, std::size_t step,
                                                      const budget::Levels& levels);

  private:
    /// A patch of a draw, in one of its instances.
    struct Place {
        int patch = 0, instance = 0;
    };
    using Captured = std::optional<std::vector<budget::Patch>>;

    /// Loads the scene at the first call. False if that fails.
    bool prepare();
    const gpu::Program* capturingFor(const BuiltProgram& built);
    /// Chooses the places at the first call for a draw.
    Captured captureChosen(const plan::PlannedDraw& draw, const budget::Levels& levels);
    Captured capture(const plan::PlannedDraw& draw, const budget::Levels& levels,
                     const FrameDrawer::Elements& elements, const std::vector<Place>& places);
    /// The most that are captured of many places.
    Captured worst(const plan::PlannedDraw& draw, const FrameDrawer::Elements& elements,
                   std::vector<Place>& places);

    const SceneState& state_;
    RenderOptions options_;
    std::vector<double> moments_;
    Stats stats_;
    SharedParts parts_;
    std::unique_ptr<SceneState> loaded_;
    std::vector<std::pair<const BuiltProgram*, gpu::Program>> programs_;
    std::optional<gpu::Buffer> buffer_;
    std::map<scene::StepIndex, std::vector<Place>> places_;
};

}  // namespace glibra::render
