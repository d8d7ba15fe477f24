#pragma once
// Draws a FramePlan: the passes in order, each draw with its complete state.

#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>
#include <limits>
#include <set>

#include "gpu/context.h"
#include "gpu/target.h"
#include "plan/frame_plan.h"
#include "render/device_scene.h"
#include "render/programs.h"
#include "render/stats.h"
#include "render/supplied.h"
#include "render/tile.h"
#include "render/view_matrices.h"
#include "scene/view.h"

namespace glibra::render {

/// The value of Timer: the fraction of the period that has passed, 0..1, less than 1 as a float.
double timerAt(double time, double period);

class FrameDrawer {
  public:
    FrameDrawer(const gpu::Context& context, const scene::Scene& scene, const plan::FramePlan& plan,
                const ProgramLibrary& programs, DeviceScene& device, Stats& stats);

    /// Size of the whole picture, which the window's aspect comes from.
    void setPictureSize(int width, int height);
    void setView(ViewMatrices view) { view_ = std::move(view); }
    /// Triangles as their edges.
    void setWireframe(bool on) { wireframe_ = on; }
    /// Called before (`begins`) and after the GL call of every draw, its program and state being bound.
    using DrawHook = std::function<void(const plan::PlannedDraw& draw, bool isWindow, bool begins)>;
    void setDrawHook(DrawHook hook) { hook_ = std::move(hook); }
    /// The GL calls of that draw alone, with whatever program and vertex array are bound: for hooks.
    void submit(const plan::PlannedDraw& planned) const;
    /// What the draw's program is, or stands for it; null if nothing is drawn.
    [[nodiscard]] const BuiltProgram* programOf(const plan::PlannedDraw& planned) const;
    /// The plan's literals of this program are others than before.
    void forgetLiterals(plan::PlannedProgramIndex program);
    /// Draws of programs that did not link are drawn by this one, in magenta; without it they are left out.
    void setFallback(const BuiltProgram* builtin) { fallback_ = builtin; }

    /// Moves the window's pictures right and up by parts of a pixel, and passes into textures, in their
    /// order, by parts of a texel; what shaders see as gl_FragCoord moves with them. For programs made for
    /// tiles; others stay.
    void setShift(const glm::dvec2& window, std::vector<glm::dvec2> textures) {
        shift_ = window;
        textureShifts_ = std::move(textures);
    }

    /// Leaves out what provably does not reach the tile, or the texture drawn into, as far as the device
    /// knows the bounds of its mesh; `samples`: of the window's target, 0: draws everything.
    void leaveOutOfTile(int samples) { windowSamples_ = samples; }
    /// From now on draws whose programs always write 1 for alpha are not blended. The window's colours must
    /// be bytes: floats would keep the sign of a zero that blending loses.
    void leaveOutBlending();

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

    [[nodiscard]] const BuiltProgram* ownProgramOf(const plan::PlannedDraw& planned) const;
    void beginPass(const plan::PlannedPass& pass, const gpu::Target& target) const;
    void clear(const gpu::Target& target, const scene::Clear& clear, bool isWindow) const;
    [[nodiscard]] glm::dvec4 clearColor(const glm::dvec4& color, bool isWindow) const;
    Diagnostics drawOne(const plan::PlannedDraw& planned, const gpu::Target& target, bool isWindow,
                        double time);
    void setLiterals(plan::PlannedProgramIndex program, const BuiltProgram& built);
    [[nodiscard]] bool isOutOfTile(const plan::PlannedDraw& planned, const BuiltProgram& built,
                                   const gpu::Target& target, bool isWindow) const;
    [[nodiscard]] DrawFacts factsOf(const scene::Draw& draw, double aspect, double time) const;
    void setSupplied(const plan::PlannedDraw& planned, const BuiltProgram& built, const DrawFacts& facts,
                     bool isWindow);
    void setBuiltins(const BuiltProgram& built, const DrawFacts& facts);
    void setConstantInputs(const plan::PlannedDraw& planned, const BuiltProgram& built,
                           const glm::dvec4& color) const;
    void bindTextures(const plan::PlannedDraw& planned, const BuiltProgram& built);
    void setRaster(const plan::PlannedDraw& planned, const BuiltProgram& built, bool isWindow,
                   Diagnostics& diagnostics);

    const gpu::Context& context_;
    const scene::Scene& scene_;
    const plan::FramePlan& plan_;
    const ProgramLibrary& programs_;
    DeviceScene& device_;
    Stats& stats_;
    scene::List<ProgramState, plan::PlannedProgram> states_;
    int width_ = 1, height_ = 1;
    std::size_t drawLimit_ = std::numeric_limits<std::size_t>::max();
    ViewMatrices view_;
    bool wireframe_ = false;
    bool blendsOpaque_ = true;
    int windowSamples_ = 0;  ///< 0: all draws are drawn
    DrawHook hook_;
    const BuiltProgram* fallback_ = nullptr;
    Tile tile_;
    glm::dvec2 shift_{0.0};
    std::vector<glm::dvec2> textureShifts_;  ///< of passes into textures, in their order
    Tile texture_;                           ///< the whole of what a pass into a texture draws into
    glm::dvec2 textureShift_{0.0};           ///< of that pass
    int clipDistances_;                      ///< those below may be on
    bool lineWidthTold_ = false;
};

}  // namespace glibra::render
