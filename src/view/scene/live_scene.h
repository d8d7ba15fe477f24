#pragma once
// A scene on the device that goes on living: its values, matrices and size change, and when its files do it
// is read again and keeps what is still the same. Errors leave out what is wrong and draw the rest.

#include <glibra/render.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "gpu/context.h"
#include "gpu/target.h"
#include "plan/frame_plan.h"
#include "render/frame.h"
#include "render/stats.h"
#include "scene/scene.h"
#include "view/scene/knobs.h"

namespace glibra::view {

class LiveScene {
  public:
    struct Loading {
        std::unique_ptr<LiveScene> scene;  ///< null only if the file cannot be read
        Diagnostics diagnostics;
    };
    /// Reads the scene. `previous` is the same scene as it was read before, or null: programs, meshes and
    /// textures that have not changed are taken out of it, and it must not be drawn any more unless nothing
    /// came of this.
    static Loading load(gpu::Context& context, const std::filesystem::path& path,
                        const RenderOptions& options, LiveScene* previous);
    LiveScene(const LiveScene&) = delete;
    LiveScene& operator=(const LiveScene&) = delete;
    ~LiveScene();

    [[nodiscard]] const scene::Scene& scene() const;
    [[nodiscard]] const plan::FramePlan& plan() const;
    [[nodiscard]] std::vector<Knob> knobs() const;
    /// True if some program that is drawn with reads Timer.
    [[nodiscard]] bool isAnimated() const;
    /// True if a program is shown in an earlier state because its sources fail.
    [[nodiscard]] bool showsEarlierProgram(scene::ProgramIndex program) const;
    /// Every file it was made from, the scene first; those that were not found are left out.
    [[nodiscard]] std::vector<std::filesystem::path> files() const;
    /// The core GLSL that a line of a shader has become, if the driver refused that shader; else nothing.
    [[nodiscard]] std::vector<glsl::EmittedLine> translatedLines(const Place& place) const;
    /// What translating, compiling, reading and the rest of loading took.
    [[nodiscard]] const render::Stats& loadStats() const;

    /// Counts of all frames: "draws", and "draws out of their tile", which were left out.
    [[nodiscard]] const render::Stats& drawStats() const;

    void setValue(const Knob& knob);
    /// The warnings about loops that the driver ends too early with the present values (draw-W08).
    Diagnostics longLoops();
    /// Draws also what provably reaches no pixel, for views that show more of it than its surface.
    void drawOutOfSight(bool on);
    /// Draws a frame of the target's size.
    Diagnostics draw(const gpu::Target& target, const ViewState& view, double time, bool axes);
    /// Matrices of the frame drawn last.
    [[nodiscard]] const render::ViewMatrices& view() const;
    /// How far the view policy has moved the eye back for it.
    [[nodiscard]] double eyeDistance() const;
    /// For looking at single draws; see FrameDrawer.
    render::FrameDrawer& drawer();
    /// The vertices of a draw in memory, and on the device; null if there are none.
    const geometry::Mesh* meshOf(const plan::PlannedDraw& draw);
    [[nodiscard]] const render::DeviceMesh* deviceMeshOf(const plan::PlannedDraw& draw) const;
    /// Null if it is not on the device.
    [[nodiscard]] const gpu::Texture* texture(scene::TextureIndex index) const;

  private:
    struct State;
    explicit LiveScene(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace glibra::view
