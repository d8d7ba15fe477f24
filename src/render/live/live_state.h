#pragma once
// What a LiveScene holds (live_scene.h): the scene as it is now, its plan, its simulation and what was drawn
// last.

#include <glibra/draw_id.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/raster_state.h"
#include "glib/script.h"
#include "gpu/context/context.h"
#include "gpu/object/framebuffer.h"
#include "plan/frame_plan.h"
#include "render/conductor.h"
#include "render/live/knobs.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace glibra::render {

/// A draw of the frame that is drawn with another state than the scene says, to try that.
struct TriedState {
    std::string word;           ///< the command that draws
    base::RasterState ofScene;  ///< as the scene says
    base::RasterState wanted;
    friend bool operator==(const TriedState&, const TriedState&) = default;
};
using TriedStates = std::map<DrawId, TriedState>;

// What of a script decides what its Once and Step blocks make, as a text that can be compared.

/// The statements of the scripts without those that only draw the frame, without the text of shaders, and
/// without values that the window changes: sliders, choices, check boxes, colours. Places and comments do not
/// count.
std::string stepText(std::span<const glib::Script* const> scripts);

/// True if the mesh is made with tangents.
bool hasTangents(const plan::PlannedMesh& mesh);

struct LiveState {
    LiveState(gpu::Context& context, RenderOptions options, InterpretedScene interpreted);
    LiveState(const LiveState&) = delete;
    LiveState& operator=(const LiveState&) = delete;

    Stats loadStats, drawStats;
    Conductor conductor;
    std::map<std::string, std::vector<double>, std::less<>> variables;  ///< as the user set them
    std::vector<Knob> changedKnobs;  ///< of programs, set by the user; a new plan does not know them
    bool drawsOutOfSight = false;
    int samples = 1;             ///< per pixel of the last frame
    bool keepsTextures = false;  ///< textures do not share memory
    bool isWireframe = false;    ///< as the drawer of the plan before was

    /// When the files were last written, as they were read.
    std::map<std::filesystem::path, std::filesystem::file_time_type> fileTimes;
    std::vector<scene::NamedCamera> cameras;  ///< of `scene`
    std::string camera;                       ///< LiveScene::setCamera
    std::optional<scene::NodeList> ownFrame;  ///< `scene.frame` and `scene.view` without that camera
    glm::dmat4 ownView{1.0};
    TriedStates tried;  ///< LiveScene::tryStates
    /// The draws that have a tried state, with that of the scene.
    std::vector<std::pair<scene::StepIndex, base::RasterState>> untried;
    std::map<scene::BufferIndex, base::StorageBlock> askedBlocks;  ///< that blockOf() has been asked for
    double mouseX = .5, mouseY = .5;
    bool isMouseDown = false;

    Diagnostics prepare(LiveState* previous);
    Diagnostics makePlan();
    void planAgain();
    [[nodiscard]] std::string sourceOfSteps() const;
    void lookThrough();
    void giveTried();
    void takeTriedBack();
    Diagnostics drawFrame(const gpu::Target& target, bool axes);

  private:
    [[nodiscard]] PlanRequest request() const;
    Diagnostics findBounds();
};

}  // namespace glibra::render
