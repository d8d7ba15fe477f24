#pragma once
// What a LiveScene holds (live_scene.h): the scene as it is now, its plan, its simulation and what was drawn
// last.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "gpu/context/context.h"
#include "gpu/object/target.h"
#include "plan/frame_plan.h"
#include "plan/still.h"
#include "render/draw/axes.h"
#include "render/draw/frame.h"
#include "render/draw/simulation.h"
#include "render/load/device_scene.h"
#include "render/load/programs.h"
#include "render/scene_renderer.h"
#include "render/stats.h"
#include "scene/scene.h"
#include "view/scene/knobs.h"
#include "view/scene/live_scene.h"

namespace glibra::view {

/// True if the mesh is made with tangents.
bool hasTangents(const plan::PlannedMesh& mesh);

/// The members are in order of dependence: later ones refer to earlier ones.
struct LiveScene::State {
    State(gpu::Context& usedContext, RenderOptions usedOptions, render::InterpretedScene interpreted)
        : context(usedContext),
          options(std::move(usedOptions)),
          source(std::move(interpreted.source)),
          inputs(std::move(interpreted.inputs)),
          scene(std::move(interpreted.scene)),
          programs(context, scene, options, false, loadStats),
          device(context, scene, loadStats) {
        if (source) cameras = source->cameras();
        for (const scene::FileReference& each : scene.files) {
            std::error_code missing;
            fileTimes.emplace(each.path, std::filesystem::last_write_time(each.path, missing));
        }
    }

    gpu::Context& context;
    RenderOptions options;
    std::shared_ptr<scene::Interpretation> source;  ///< null: the scene is the same for all inputs
    scene::FrameInputs inputs;                      ///< of `scene`
    scene::Scene scene;
    render::Stats loadStats, drawStats;
    render::ProgramLibrary programs;
    render::DeviceScene device;
    plan::FramePlan plan;
    std::optional<render::Simulation> simulation;  ///< of a scene with Once or Step
    bool isSimulationWrong = false;                ///< its blocks have errors; they do not run
    std::optional<render::FrameDrawer> drawer;
    std::optional<render::Axes> axes;
    render::ViewMatrices view;
    std::optional<double> eyeAspect;  ///< the aspect ratio that eyeDistance was computed for
    double eyeDistance = 0;
    std::optional<int> loopLimit;
    bool isViewSet = false;     ///< `view` is the view of the last frame
    double setEyeDistance = 0;  ///< the eyeDistance in `view`

    std::map<std::string, std::vector<double>, std::less<>> variables;  ///< as the user set them
    std::vector<Knob> changedKnobs;  ///< of programs, set by the user; a new plan does not know them
    bool drawsOutOfSight = false;
    int samples = 1;             ///< per pixel of the last frame
    bool keepsTextures = false;  ///< textures do not share memory

    /// What was drawn last, if `scene` or `plan` has changed since.
    struct Drawn {
        std::optional<scene::Scene> scene;  ///< empty: only the plan has changed
        plan::FramePlan plan;
    };
    std::optional<Drawn> drawnBefore;
    bool isDrawn = false;  ///< the last frame was drawn whole, and nothing else since
    ViewState drawnView;
    int drawnWidth = 0, drawnHeight = 0;
    std::int64_t drawnChanges = 0;  ///< Simulation::changes() of that frame

    /// When the files were last written, as they were read.
    std::map<std::filesystem::path, std::filesystem::file_time_type> fileTimes;
    std::vector<scene::NamedCamera> cameras;  ///< of `scene`
    std::string camera;                       ///< LiveScene::setCamera
    std::optional<scene::NodeList> ownFrame;  ///< `scene.frame` and `scene.view` without that camera
    glm::dmat4 ownView{1.0};
    std::map<scene::BufferIndex, base::StorageBlock> askedBlocks;  ///< that blockOf() has been asked for
    double mouseX = .5, mouseY = .5;
    bool isMouseDown = false;

    Diagnostics prepare(State* previous);
    Diagnostics makePlan(bool variablesDiffer = false);
    void planAgain();
    [[nodiscard]] plan::FramePlan planList(const scene::NodeList& nodes,
                                           const plan::PlanOptions& planOptions);
    Diagnostics planSimulation(const plan::PlanOptions& planOptions);
    [[nodiscard]] std::vector<const plan::FramePlan*> plans() const;
    [[nodiscard]] std::string sourceOfSteps() const;
    void lookThrough();
    bool moveTo(const scene::FrameInputs& wanted, Diagnostics& diagnostics);
    void prepareFallback();
    void noteChange(bool ofScene);
    [[nodiscard]] plan::StillNodes stillNodes(int width, int height) const;
    Diagnostics drawFrame(const gpu::Target& target, double time);
    int measuredLoopLimit();
    void placeEye(double aspect, Diagnostics& diagnostics);
};

}  // namespace glibra::view
