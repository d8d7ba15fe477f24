#pragma once
// A scene on the device whose values, matrices and size change while it is shown. When its files change it is
// loaded again and reuses whatever is still the same. A faulty statement is left out; the rest is drawn.

#include <glibra/draw_id.h>
#include <glibra/render.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/raster_state.h"
#include "glib/script.h"
#include "glsl/emit/emit.h"
#include "gpu/context/context.h"
#include "gpu/object/framebuffer.h"
#include "image/image.h"
#include "plan/frame_plan.h"
#include "render/conductor.h"
#include "render/draw/frame.h"
#include "render/live/knobs.h"
#include "render/load/shared_parts.h"
#include "render/simulation/simulation.h"
#include "render/stats.h"
#include "scene/file_lookup.h"
#include "scene/scene.h"

namespace glibra::render {

// ---- What a LiveScene holds
// The scene as it is now, its plan, its simulation and what was drawn last.

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

// ---- The scene

class LiveScene {
  public:
    struct Loading {
        std::unique_ptr<LiveScene> scene;  ///< null if the file cannot be read, or memory runs out
        Diagnostics diagnostics;
        bool isPreviousLost = false;  ///< memory ran out; `previous` must not be drawn any more
    };
    /// Loads the scene. `previous` is the earlier state of the same scene, or null: unchanged programs,
    /// meshes and textures are moved out of it. If loading succeeds, `previous` must not be drawn any more.
    static Loading load(gpu::Context& context, const std::filesystem::path& path,
                        const RenderOptions& options, LiveScene* previous);
    LiveScene(const LiveScene&) = delete;
    LiveScene& operator=(const LiveScene&) = delete;
    ~LiveScene();

    [[nodiscard]] const scene::Scene& scene() const { return state_->conductor.scene; }
    [[nodiscard]] const plan::FramePlan& plan() const { return state_->conductor.plan; }
    [[nodiscard]] std::vector<Knob> knobs() const;
    /// Knobs of uniforms that nothing sets, until setValue() does so.
    [[nodiscard]] std::vector<Knob> unsetKnobs() const;
    /// The current values as text, see labelsOf and onlyLabels.
    [[nodiscard]] std::vector<std::string> labels(std::span<const std::string> only = {}) const;
    /// True if a program that draws something reads Timer.
    [[nodiscard]] bool isAnimated() const;
    /// True if the program does not compile and its last good version is shown.
    [[nodiscard]] bool showsEarlierProgram(scene::ProgramIndex program) const;
    /// Every file that was read for it, the scene first. Missing files are left out.
    [[nodiscard]] std::vector<std::filesystem::path> files() const;
    /// Where its files are looked for.
    [[nodiscard]] scene::SearchFolders searchFolders() const;
    /// The paths at which files that are missing would be found (scene::placesOf).
    [[nodiscard]] std::vector<std::filesystem::path> missingFiles() const;
    /// The core GLSL that was made from a shader's line, if the driver rejected that shader; otherwise empty.
    [[nodiscard]] std::vector<glsl::EmittedLine> translatedLines(const Place& place) const {
        return state_->conductor.programs.refusedLines(place);
    }
    /// Times and counts of the last loading: translating, compiling, reading files.
    [[nodiscard]] const Stats& loadStats() const { return state_->loadStats; }

    /// Counts over all frames: "draws", "draws out of their tile", which were skipped, and passes and
    /// dispatches that were not repeated because they are as in the frame before (plan::StillNodes).
    [[nodiscard]] const Stats& drawStats() const { return state_->drawStats; }

    void setValue(const Knob& knob);
    /// The camera that the picture is seen from in place of the scene's own, where the window's transforms
    /// act; expressions keep the scene's. Empty, or a name that the scene does not declare: the scene's own.
    void setCamera(const std::string& name);
    /// From now on these draws have the states that are tried, while their words and states in the scene are
    /// those. Indices into an earlier plan are not valid any more.
    void tryStates(TriedStates states);
    /// The cameras that the scene declares, sorted by name.
    [[nodiscard]] const std::vector<scene::NamedCamera>& cameras() const { return state_->cameras; }
    /// Where the mouse is, 0..1 from the lower left corner, and whether its left button is down.
    void setMouse(double x, double y, bool isDown);
    /// True if the scene reads `mouse`.
    [[nodiscard]] bool readsMouse() const;
    /// What lasts begins anew with the next frame.
    void restart();
    /// How far the Step blocks have run.
    [[nodiscard]] std::vector<Simulation::Progress> steps() const;
    /// Calls `hook` around every run of a Once or Step block.
    void setRunHook(Simulation::RunHook hook);
    /// The warnings about loops that the driver would end too early with the current values (draw-W08).
    Diagnostics longLoops();
    /// True if the driver ends loops, and the text and the values of a program do not show that its loops are
    /// short: with watchLoops() the next draw() and some later ones report those that the driver ends, until
    /// a value is set. It takes another program for each, and draws twice what stores nothing.
    [[nodiscard]] bool hasLoopsToWatch();
    void watchLoops();
    /// The loops of its shaders that may not end with the current values, or only after a long time; see
    /// open_loops.h.
    [[nodiscard]] std::vector<Place> openLoops();
    /// Makes the plan and the matrices of a frame without drawing it. Returns what moveTo() does.
    bool look(int width, int height, const ViewState& view, double time, Diagnostics& diagnostics);
    /// From now on no texture shares memory with another one, so that each keeps its content after a frame.
    /// Also holds for scenes that are loaded with this one as `previous`. Returns true if the plan is a new
    /// one.
    bool keepTextures(Diagnostics& diagnostics);
    /// Makes a plan in which draws with that program (FrameDrawer::programOf) have more in their fragment
    /// stage, and all inputs, uniforms and textures that they then read. Returns false, and changes nothing,
    /// if the driver does not link it. Indices into an earlier plan are not valid any more.
    bool observe(const BuiltProgram& program, const glsl::MainWrapper& fragment);
    /// Makes the plan as it was.
    void stopObserving();
    /// With `on`, objects outside the picture are drawn too: debug views may show parts of them inside it.
    void drawOutOfSight(bool on);
    /// Makes the scene that of this time and size, if it depends on them or a variable has changed. draw()
    /// does so too. Returns true if the plan is a new one: indices into an earlier plan are not valid any
    /// more.
    bool moveTo(int width, int height, double time, Diagnostics& diagnostics);
    /// Draws a frame into the target, in the target's size. `time` is in seconds.
    Diagnostics draw(const gpu::Target& target, const ViewState& view, double time, bool axes);
    /// The matrices of the last frame.
    [[nodiscard]] const ViewMatrices& view() const { return state_->conductor.view; }
    /// How far the view policy moved the eye back in the last frame, in units of eye space.
    [[nodiscard]] double eyeDistance() const { return state_->conductor.eyeDistance; }
    /// Gives access to single draws; see FrameDrawer. It may draw anything, so the next frame is drawn whole.
    FrameDrawer& drawer();
    /// The box around what the draw draws, in model space, without what its shaders do; nothing if it is not
    /// known or the program places vertices in another way than by the matrices.
    [[nodiscard]] const VertexBox* boxOf(const plan::PlannedDraw& draw);
    /// The mesh of a draw in memory, and on the device; null if there is none.
    const geometry::Mesh* meshOf(const plan::PlannedDraw& draw);
    [[nodiscard]] const DeviceMesh* deviceMeshOf(const plan::PlannedDraw& draw) const;
    /// Null if it is not on the device.
    [[nodiscard]] const gpu::Texture* texture(scene::TextureIndex index) const {
        return state_->conductor.device.textures().texture(index);
    }
    /// What samplers read of the texture: with its samples resolved and its mipmaps made. Null if it is not
    /// on the device. `isPrevious`: the other copy of a texture with history.
    const gpu::Texture* completed(scene::TextureIndex index, bool isPrevious);
    /// What DeviceTextures::write and DeviceBuffers::write, for that object, come after: a Once block that
    /// has yet to run must not replace what they give. The next frame is drawn whole.
    Result<DeviceScene*> beginWrite(const plan::Object& object);
    /// DeviceTextures::numbersOf.
    Result<TexelNumbers> numbersOf(const scene::TextureView& view) {
        return state_->conductor.device.textures().numbersOf(view);
    }
    [[nodiscard]] const DeviceBuffers& buffers() const { return state_->conductor.device.buffers(); }
    [[nodiscard]] const DeviceScene& device() const { return state_->conductor.device; }

  private:
    explicit LiveScene(std::unique_ptr<LiveState> state);
    std::unique_ptr<LiveState> state_;
};

}  // namespace glibra::render
