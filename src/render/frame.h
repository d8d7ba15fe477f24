#pragma once
// Draws a FramePlan: the passes in order, each draw with its complete state.

#include <cstddef>
#include <limits>
#include <set>

#include "gpu/context.h"
#include "gpu/target.h"
#include "plan/frame_plan.h"
#include "render/device_scene.h"
#include "render/programs.h"
#include "render/stats.h"
#include "scene/view.h"

namespace glibra::render {

/// The part of the picture that the window's target shows, in pixels from the picture's lower left corner.
struct Tile {
    int x = 0, y = 0, width = 0, height = 0;
};

class FrameDrawer {
  public:
    FrameDrawer(const gpu::Context& context, const scene::Scene& scene, const plan::FramePlan& plan,
                const ProgramLibrary& programs, DeviceScene& device, Stats& stats);

    /// Size of the whole picture, which the window's aspect comes from.
    void setPictureSize(int width, int height);
    /// Distance the view policy moves the eye back, for draws with a perspective projection.
    void setEyeDistance(double distance) { eyeDistance_ = distance; }

    /// Of the plan's draws, counted over all passes in their order, only the first `draws` are drawn. Passes
    /// still begin with their implicit clears.
    void setDrawLimit(std::size_t draws) { drawLimit_ = draws; }

    /// Draws one frame into `window`, which shows `tile`. With `texturePasses` false only the window's passes
    /// are drawn.
    Diagnostics draw(const gpu::Target& window, const Tile& tile, double time, bool texturePasses);

    /// True if every pass into textures comes before every pass into the window, so that tiles can share
    /// them.
    [[nodiscard]] bool texturesComeFirst() const;

  private:
    /// What a program keeps between draws: uniform values that never change are set once.
    struct ProgramState {
        bool literalsSet = false;
        std::vector<gpu::Buffer> blocks;
    };

    void beginPass(const plan::PlannedPass& pass, const gpu::Target& target) const;
    void clear(const gpu::Target& target, const scene::Clear& clear) const;
    Diagnostics drawOne(const plan::PlannedDraw& planned, const gpu::Target& target, bool isWindow,
                        double time);
    void setLiterals(int program, const BuiltProgram& built);
    void setSupplied(const plan::PlannedDraw& planned, const BuiltProgram& built, const scene::Draw& draw,
                     double aspect, bool isWindow, double time);
    void setConstantInputs(const plan::PlannedDraw& planned, const BuiltProgram& built,
                           const scene::Draw& draw) const;
    void bindTextures(const plan::PlannedDraw& planned, const BuiltProgram& built);
    void setRaster(const plan::PlannedDraw& planned, const BuiltProgram& built, bool isWindow,
                   Diagnostics& diagnostics);

    const gpu::Context& context_;
    const scene::Scene& scene_;
    const plan::FramePlan& plan_;
    const ProgramLibrary& programs_;
    DeviceScene& device_;
    Stats& stats_;
    std::vector<ProgramState> states_;
    int width_ = 1, height_ = 1;
    double eyeDistance_ = 0;
    std::size_t drawLimit_ = std::numeric_limits<std::size_t>::max();
    Tile tile_;
    int clipDistances_ = 0;
    bool lineWidthTold_ = false;
};

}  // namespace glibra::render
