#include "view/scene/live_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <new>
#include <set>
#include <system_error>
#include <utility>

#include "gpu/context/loop_limit.h"
#include "plan/accesses.h"
#include "plan/loop_rounds.h"
#include "plan/still.h"
#include "render/draw/axes.h"
#include "render/draw/dispatch.h"
#include "render/file/labels.h"
#include "render/load/device_scene.h"
#include "render/load/programs.h"
#include "render/scene_renderer.h"
#include "scene/view.h"
#include "view/scene/step_text.h"

namespace glibra::view {
namespace {

/// A uniform block and counters are described as a storage block with the same members.
base::StorageBlock blockOf(const plan::BlockUse& use, const plan::ProgramInterface& interface) {
    if (use.kind == plan::BlockUse::Kind::storage) return interface.storageBlocks.at(use.index);
    base::StorageBlock block;
    const auto add = [&](std::string name, int offset) -> base::StorageMember& {
        base::StorageMember& member = block.members.emplace_back();
        member.name = std::move(name);
        member.offset = offset;
        return member;
    };
    if (use.kind == plan::BlockUse::Kind::counters) {
        constexpr int kCounterBytes = 4;
        for (const std::string& each : interface.counterBuffers.at(use.index).counters)
            add(each, static_cast<int>(block.members.size()) * kCounterBytes);
        return block;
    }
    block.name = interface.blocks.at(use.index).name;
    for (const base::ActiveUniform& each : interface.uniforms) {
        if (each.block != static_cast<int>(use.index)) continue;
        base::StorageMember& member = add(each.isArray ? each.name + "[0]" : each.name, each.offset);
        member.arraySize = each.arraySize;
        member.arrayStride = each.arrayStride;
    }
    return block;
}

/// True if no node comes after a pass into the window.
bool texturesComeFirst(const plan::FramePlan& plan) {
    const auto isOfWindow = [&](const scene::NodeIndex& node) {
        return node.kind == scene::NodeIndex::Kind::pass && plan.passOf(plan.passes[node.index]).isWindow;
    };
    return std::is_partitioned(plan.order.begin(), plan.order.end(), std::not_fn(isOfWindow));
}

bool hasTangents(const plan::PlannedMesh& mesh) {
    return std::find(mesh.attributes.begin(), mesh.attributes.end(), geometry::kTangent) !=
           mesh.attributes.end();
}

}  // namespace

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

Diagnostics LiveScene::State::prepare(State* previous) {
    if (previous) {
        programs.inherit(previous->programs);
        device.inherit(previous->device);
        keepsTextures = previous->keepsTextures;
    }
    Diagnostics diagnostics = makePlan();
    programs.forgetPrevious();
    return diagnostics;
}

/// Interprets the scene for other inputs, if it depends on what has changed.
bool LiveScene::State::moveTo(const scene::FrameInputs& wanted, Diagnostics& diagnostics) {
    using expression::Depends;
    if (!source || wanted == inputs) return false;
    const Depends depends = source->depends();
    const auto changes = [&](Depends on, auto... member) {
        return any(depends & on) && ((wanted.*member != inputs.*member) || ...);
    };
    using Inputs = scene::FrameInputs;
    const bool isOther = changes(Depends::time | Depends::frame | Depends::tick, &Inputs::time) ||
                         changes(Depends::window | Depends::camera, &Inputs::width, &Inputs::height) ||
                         changes(Depends::mouse, &Inputs::mouseX, &Inputs::mouseY, &Inputs::isMouseDown) ||
                         wanted.variables != inputs.variables;
    const bool variablesDiffer = wanted.variables != inputs.variables;
    inputs = wanted;
    if (!isOther) return false;
    noteChange(true);
    scene = source->at(inputs);
    cameras = source->cameras();
    lookThrough();
    append(diagnostics, std::move(scene.diagnostics));
    scene.diagnostics.clear();
    device.beginMoment(plan);
    bool hasLost = false;
    append(diagnostics, device.followSizes(hasLost));
    if (hasLost && simulation) {
        // Its blocks may run over the texels of what has another size now, so makePlan() plans them anew.
        simulation.reset();
        isDrawn = false;
    }
    append(diagnostics, makePlan(variablesDiffer));
    isViewSet = false;
    return true;
}

Diagnostics LiveScene::State::makePlan(bool variablesDiffer) {
    plan::PlanOptions planOptions;
    planOptions.maxTextureUnits = context.capabilities().combinedTextureUnits;
    planOptions.lacksCompute = render::lackOfCompute(context.capabilities());
    planOptions.loopLimit = [this] { return measuredLoopLimit(); };
    planOptions.shareTargets = !keepsTextures;
    plan = planList(scene.frame, planOptions);
    // Picking draws the window's passes again, after the frame.
    if (!texturesComeFirst(plan)) plan.sharing.clear();
    Diagnostics diagnostics = std::move(plan.diagnostics);
    plan.diagnostics.clear();
    const bool isNew = !simulation;
    append(diagnostics, planSimulation(planOptions));
    const auto findBounds = [&] {
        for (const plan::PlannedMesh& each : plan.meshes)
            device.bounds(each.shape, hasTangents(each), &diagnostics);
    };
    findBounds();
    append(diagnostics, device.prepare(plan, programs));
    if (variablesDiffer && !isNew && !isSimulationWrong) {
        const Diagnostics found = simulation->variablesChanged();
        isSimulationWrong = hasError(found);
        append(diagnostics, found);
        findBounds();
    }
    if (isNew && simulation && !isSimulationWrong) append(diagnostics, simulation->make());
    const bool isWireframe = drawer && drawer->isWireframe();
    drawer.emplace(context, plan, programs, device, drawStats);
    drawer->setWireframe(isWireframe);
    drawer->cullToTile(drawsOutOfSight ? 0 : samples);
    prepareFallback();
    append(diagnostics, context.debugLog().takeDiagnostics());
    return diagnostics;
}

/// Plans the same scene with other programs. Its diagnostics are known already.
void LiveScene::State::planAgain() {
    isDrawn = false;
    drawnBefore.reset();
    const bool wasSimulationWrong = isSimulationWrong;
    device.beginMoment(plan);
    makePlan();
    isSimulationWrong = wasSimulationWrong;
}

plan::FramePlan LiveScene::State::planList(const scene::NodeList& nodes,
                                           const plan::PlanOptions& planOptions) {
    plan::FramePlan made = plan::planFrame(
        scene, nodes,
        [this](const plan::ProgramVariant& variant) -> const plan::ProgramInterface& {
            return programs.interfaceOf(variant);
        },
        [this](scene::ProgramIndex program) { return programs.mayWriteImages(program); }, planOptions);
    apply(scene, changedKnobs, made);
    return made;
}

std::vector<const plan::FramePlan*> LiveScene::State::plans() const {
    std::vector<const plan::FramePlan*> all{&plan};
    if (!simulation) return all;
    const std::vector<const plan::FramePlan*> blocks = simulation->plans();
    all.insert(all.end(), blocks.begin(), blocks.end());
    return all;
}

/// What decides the content of what lasts, besides values that the window changes.
std::string LiveScene::State::sourceOfSteps() const {
    if (!simulation || isSimulationWrong || !source) return {};
    std::string text = stepText(source->scripts());
    const auto addFile = [&](scene::FileIndex index) {
        if (!index) return;
        const auto time = fileTimes.find(scene.files[index].path);
        text += fmt::format("{} {}\n", scene.files[index].path.string(),
                            time == fileTimes.end() ? 0 : time->second.time_since_epoch().count());
    };
    for (const scene::Shape& each : scene.shapes) addFile(each.file);
    for (const plan::FramePlan* each : simulation->plans()) {
        for (const plan::PlannedProgram& planned : each->programs) {
            const render::BuiltProgram* built = programs.find(planned.variant);
            text += fmt::format("program {}\n", built && built->program ? built->program->id() : 0);
        }
        for (const scene::TextureIndex texture : each->textures)
            if (const auto* picture = std::get_if<scene::PictureSource>(&scene.textures[texture].source))
                for (const scene::FileIndex file : picture->files) addFile(file);
        for (const scene::BufferIndex buffer : each->buffers) addFile(scene.buffers[buffer].file);
    }
    return text;
}

/// Replaces the camera of the passes that the window's transforms move.
void LiveScene::State::lookThrough() {
    ownFrame.reset();
    const auto find = [&](const std::string& name) {
        return std::find_if(cameras.begin(), cameras.end(),
                            [&](const scene::NamedCamera& each) { return each.name == name; });
    };
    const auto wanted = find(camera);
    if (wanted == cameras.end()) return;
    ownFrame = scene.frame;
    ownView = std::exchange(scene.view, wanted->view);
    for (scene::Pass& pass : scene.frame.passes) {
        if (!render::isMoved(*ownFrame, pass)) continue;
        const auto own = find(pass.camera.empty() ? "eye" : pass.camera);
        const bool isMirrored = own != cameras.end() && own->isMirrored;
        for (auto& step : pass.steps) {
            auto* draw = std::get_if<scene::Draw>(&step);
            if (draw == nullptr || std::holds_alternative<scene::ClipSpace>(draw->projection)) continue;
            draw->modelView = wanted->view * draw->model;
            draw->projection = wanted->projection;
            if (wanted->isMirrored == isMirrored) continue;
            draw->raster.front =
                draw->raster.front == base::Winding::ccw ? base::Winding::cw : base::Winding::ccw;
        }
    }
}

/// Plans the Once and Step blocks when the scene is loaded. Frames of a window may differ in what they read,
/// so all nodes that write something are kept.
Diagnostics LiveScene::State::planSimulation(const plan::PlanOptions& planOptions) {
    if (scene.once.empty() && scene.steps.empty()) return {};
    Diagnostics diagnostics;
    if (simulation) {
        diagnostics = simulation->check(plan);
    } else {
        plan::PlanOptions listOptions = planOptions;
        listOptions.shareTargets = false;
        simulation.emplace(
            render::SimulationParts{context, scene, source.get(), programs, device, loadStats,
                                    [this, listOptions](const scene::NodeList& nodes,
                                                        std::vector<scene::ObjectView> roots) mutable {
                                        listOptions.roots = std::move(roots);
                                        return planList(nodes, listOptions);
                                    }},
            options.steps);
        diagnostics = simulation->plan(plan, true, {});
    }
    isSimulationWrong = hasError(diagnostics);
    return diagnostics;
}

/// Keeps what was drawn, for comparison with the next frame. Call it before the values in `plan` change, or
/// before `scene` and `plan` (`ofScene`) are replaced.
void LiveScene::State::noteChange(bool ofScene) {
    if (!isDrawn || !scene.isModern || (drawnBefore && (!ofScene || drawnBefore->scene))) return;
    if (!ofScene) {
        drawnBefore = Drawn{{}, plan};
        return;
    }
    if (!drawnBefore) drawnBefore = Drawn{{}, std::move(plan)};
    drawnBefore->scene = std::move(scene);
    drawnBefore->plan.nodes = &drawnBefore->scene->frame;
}

/// What of the frame is the same as in the frame before. A pass that the window's transforms move is the same
/// only while they stay.
plan::StillNodes LiveScene::State::stillNodes(int width, int height) const {
    const ViewState& now = view.state();
    const bool isComparable = isDrawn && scene.isModern && drawer->drawsPlainly() && width == drawnWidth &&
                              height == drawnHeight && now.projection == ProjectionMode::scene &&
                              drawnView.projection == ProjectionMode::scene &&
                              now.objects == drawnView.objects && now.texture == drawnView.texture;
    if (!isComparable) return {};
    std::set<plan::Object> moved;
    std::vector<bool> isMovedNode(plan.order.size());
    if (now.scene != drawnView.scene || now.eye != drawnView.eye)
        for (std::size_t node = 0; node < plan.order.size(); ++node) {
            const scene::NodeIndex& at = plan.order[node];
            if (at.kind != scene::NodeIndex::Kind::pass) continue;
            const scene::Pass& pass = plan.passOf(plan.passes[at.index]);
            isMovedNode[node] = !pass.isWindow && render::isMoved(*plan.nodes, pass);
            if (!isMovedNode[node]) continue;
            for (const plan::ObjectUse& each : plan::usesOf(plan, node))
                if (each.writes) moved.insert(plan::objectOf(each.object));
        }
    const bool hasRun = simulation && simulation->changes() != drawnChanges;
    const plan::PlannedScene before =
        drawnBefore ? plan::PlannedScene{drawnBefore->scene ? *drawnBefore->scene : scene, drawnBefore->plan}
                    : plan::PlannedScene{scene, plan};
    plan::StillNodes still = plan::stillNodes(before, {scene, plan}, [&](const plan::Object& each) {
        return moved.contains(each) || (hasRun && simulation->lasts(each));
    });
    for (std::size_t node = 0; node < still.nodes.size(); ++node)
        if (isMovedNode[node]) still.nodes[node] = false;
    for (const plan::Object& each : moved) still.contents.erase(each);
    return still;
}

Diagnostics LiveScene::State::drawFrame(const gpu::Target& target, double time) {
    const int width = target.width(), height = target.height();
    samples = target.samples();
    drawer->cullToTile(drawsOutOfSight ? 0 : samples);
    const plan::StillNodes still = stillNodes(width, height);
    Diagnostics diagnostics =
        drawer->draw(target, {view, width, height, {0, 0, width, height}, time, true, &still});
    drawnBefore.reset();
    isDrawn = scene.isModern && drawer->drawsPlainly() && !hasError(diagnostics);
    if (!isDrawn) return diagnostics;
    drawnView = view.state();
    drawnWidth = width;
    drawnHeight = height;
    drawnChanges = simulation ? simulation->changes() : 0;
    return diagnostics;
}

void LiveScene::State::prepareFallback() {
    const bool isNeeded =
        std::any_of(plan.programs.begin(), plan.programs.end(),
                    [](const plan::PlannedProgram& each) { return !each.interface->usable; });
    if (!isNeeded) return;
    const plan::ProgramVariant builtin{{}, false, 1};
    programs.interfaceOf(builtin);
    drawer->setFallback(programs.find(builtin));
}

int LiveScene::State::measuredLoopLimit() {
    if (!loopLimit) loopLimit = gpu::measureLoopLimit(context);
    return *loopLimit;
}

void LiveScene::State::placeEye(double aspect, Diagnostics& diagnostics) {
    if (eyeAspect == aspect) return;
    eyeAspect = aspect;
    eyeDistance = 0;
    if (options.view == ViewPolicy::glman || scene.usesLookAt) return;
    scene::ViewMove move = scene::autoView(
        scene, [&](scene::ShapeIndex shape) { return device.mesh(shape, false, &diagnostics); }, aspect);
    eyeDistance = move.distance;
    append(diagnostics, std::move(move.diagnostics));
}

LiveScene::LiveScene(std::unique_ptr<State> state) : state_(std::move(state)) {}
LiveScene::~LiveScene() = default;

LiveScene::Loading LiveScene::load(gpu::Context& context, const std::filesystem::path& path,
                                   const RenderOptions& options, LiveScene* previous) {
    Loading loading;
    try {
        render::Stats stats;
        Result<render::InterpretedScene> interpreted = render::interpretFile(path, options, stats);
        loading.diagnostics = std::move(interpreted.diagnostics);
        if (!interpreted) return loading;
        auto state = std::make_unique<State>(context, options, std::move(*interpreted));
        // Before the new scene takes programs away.
        const std::string earlierSteps = previous ? previous->state_->sourceOfSteps() : std::string();
        loading.isPreviousLost = previous != nullptr;  // until the new scene is complete
        append(loading.diagnostics, state->prepare(previous ? previous->state_.get() : nullptr));
        if (!earlierSteps.empty() && state->sourceOfSteps() == earlierSteps)
            state->simulation->takeOver(*previous->state_->simulation);
        render::applyStrict(loading.diagnostics, false);
        loading.scene.reset(new LiveScene(std::move(state)));
        loading.isPreviousLost = false;
    } catch (const std::bad_alloc&) {
        loading.diagnostics.push_back(diagnose("draw-E05", "out of memory", {path.string(), 1, 1}));
    }
    return loading;
}

const scene::Scene& LiveScene::scene() const {
    return state_->scene;
}
const plan::FramePlan& LiveScene::plan() const {
    return state_->plan;
}
std::vector<Knob> LiveScene::knobs() const {
    return knobsOf(state_->scene, state_->plans());
}

std::vector<std::string> LiveScene::labels() const {
    return render::labelsOf(state_->scene, state_->plans());
}

bool LiveScene::isAnimated() const {
    using expression::Depends;
    if (!state_->scene.steps.empty()) return true;
    if (state_->source && any(state_->source->depends() & (Depends::time | Depends::frame | Depends::tick)))
        return true;
    for (const plan::PlannedProgram& program : state_->plan.programs)
        for (const plan::UniformBinding& each : program.values)
            if (const auto* supplied = std::get_if<plan::Supplied>(&each.value))
                if (supplied->value == glsl::Builtin::timer) return true;
    return false;
}

bool LiveScene::showsEarlierProgram(scene::ProgramIndex program) const {
    for (const plan::PlannedProgram& each : state_->plan.programs) {
        const render::BuiltProgram* built =
            each.variant.program == program ? state_->programs.find(each.variant) : nullptr;
        if (built != nullptr && built->isLastGood) return true;
    }
    return false;
}

std::vector<std::filesystem::path> LiveScene::files() const {
    std::vector<std::filesystem::path> files{state_->scene.path};
    std::set<std::filesystem::path> known{state_->scene.path};
    const auto add = [&](const std::filesystem::path& file) {
        if (!file.empty() && known.insert(file).second) files.push_back(file);
    };
    for (const scene::FileReference& each : state_->scene.files) add(each.path);
    for (const std::filesystem::path& each : state_->programs.filesRead()) add(each);
    return files;
}

std::vector<glsl::EmittedLine> LiveScene::translatedLines(const Place& place) const {
    return state_->programs.refusedLines(place);
}

const render::Stats& LiveScene::loadStats() const {
    return state_->loadStats;
}

const render::Stats& LiveScene::drawStats() const {
    return state_->drawStats;
}

bool LiveScene::keepTextures(Diagnostics& diagnostics) {
    State& state = *state_;
    if (std::exchange(state.keepsTextures, true) || state.plan.sharing.empty()) return false;
    state.isDrawn = false;
    state.device.beginMoment(state.plan);
    append(diagnostics, state.makePlan());
    return true;
}

bool LiveScene::observe(const render::BuiltProgram& program, const glsl::MainWrapper& fragment) {
    if (!state_->programs.observe(program, fragment)) return false;
    state_->planAgain();
    return true;
}

void LiveScene::stopObserving() {
    state_->programs.stopObserving();
    state_->planAgain();
}

void LiveScene::drawOutOfSight(bool on) {
    state_->drawsOutOfSight = on;
    state_->drawer->cullToTile(on ? 0 : state_->samples);
}

void LiveScene::setValue(const Knob& knob) {
    State& state = *state_;
    if (!knob.program) {
        state.variables[knob.tag] = knob.current;
        return;
    }
    std::erase_if(state.changedKnobs,
                  [&](const Knob& each) { return each.program == knob.program && each.tag == knob.tag; });
    state.changedKnobs.push_back(knob);
    state.noteChange(false);
    const auto change = [&](plan::FramePlan& plan) { return apply(state.scene, {&knob, 1}, plan); };
    for (const plan::PlannedProgramIndex each : change(state.plan)) state.drawer->forgetLiterals(each);
    if (state.simulation) state.simulation->changeValues(change);
}

Diagnostics LiveScene::longLoops() {
    Diagnostics diagnostics;
    for (const plan::PlannedProgram& each : state_->plan.programs)
        append(diagnostics, plan::reportLongLoops(each, [this] { return state_->measuredLoopLimit(); }));
    render::applyStrict(diagnostics, false);  // programs may share a file
    return diagnostics;
}

bool LiveScene::moveTo(int width, int height, double time, Diagnostics& diagnostics) {
    if (!state_->source) return false;
    scene::FrameInputs wanted = state_->inputs;
    wanted.time = time;
    wanted.width = width;
    wanted.height = height;
    wanted.mouseX = state_->mouseX;
    wanted.mouseY = state_->mouseY;
    wanted.isMouseDown = state_->isMouseDown;
    for (const auto& [name, values] : state_->variables) wanted.variables[name] = values;
    return state_->moveTo(wanted, diagnostics);
}

Diagnostics LiveScene::draw(const gpu::Target& target, const ViewState& view, double time, bool axes) {
    State& state = *state_;
    Diagnostics diagnostics;
    moveTo(target.width(), target.height(), time, diagnostics);
    const double aspect = static_cast<double>(target.width()) / target.height();
    state.placeEye(aspect, diagnostics);
    // Setting a view copies the transforms of objects, which allocates memory. An unchanged view is not set
    // again.
    if (!state.isViewSet || view != state.view.state() || state.setEyeDistance != state.eyeDistance) {
        state.view = render::ViewMatrices(view, state.scene.view, state.eyeDistance);
        state.setEyeDistance = state.eyeDistance;
        state.isViewSet = true;
    }
    const render::Tile whole{0, 0, target.width(), target.height()};
    if (state.simulation && !state.isSimulationWrong) {
        state.inputs.time = time;
        append(diagnostics, state.simulation->advance(state.inputs));
    }
    append(diagnostics, state.drawFrame(target, time));
    if (axes && !state.axes) {
        Result<render::Axes> made = render::Axes::create(state.context);
        append(diagnostics, std::move(made.diagnostics));
        state.axes = std::move(made.value);
    }
    if (axes && state.axes)
        state.axes->draw(target, state.scene, state.view, whole, target.width(), target.height());
    target.resolve();
    append(diagnostics, state.context.debugLog().takeDiagnostics());
    return diagnostics;
}

const render::ViewMatrices& LiveScene::view() const {
    return state_->view;
}
double LiveScene::eyeDistance() const {
    return state_->eyeDistance;
}
render::FrameDrawer& LiveScene::drawer() {
    state_->isDrawn = false;
    return *state_->drawer;
}
const render::VertexBox* LiveScene::boxOf(const plan::PlannedDraw& draw) {
    State& state = *state_;
    const plan::PlannedMesh& mesh = state.plan.meshes[draw.mesh];
    const plan::ProgramVariant& variant = state.plan.programs[draw.program].variant;
    if (state.programs.placementOf(variant) == glsl::Placement::unknown) return nullptr;
    const render::VertexBox& box = state.device.bounds(mesh.shape, hasTangents(mesh), nullptr);
    return box.isKnown ? &box : nullptr;
}
const geometry::Mesh* LiveScene::meshOf(const plan::PlannedDraw& draw) {
    const plan::PlannedMesh& planned = state_->plan.meshes[draw.mesh];
    Diagnostics alreadyReported;
    return state_->device.mesh(planned.shape, hasTangents(planned), &alreadyReported);
}
const render::DeviceMesh* LiveScene::deviceMeshOf(const plan::PlannedDraw& draw) const {
    return state_->device.deviceMesh(state_->plan, draw.mesh);
}
const gpu::Texture* LiveScene::texture(scene::TextureIndex index) const {
    return state_->device.texture(index);
}
const gpu::Texture* LiveScene::completed(scene::TextureIndex index, bool isPrevious) {
    return state_->device.completed({.texture = index, .isPrevious = isPrevious});
}
const render::DeviceBuffers& LiveScene::buffers() const {
    return state_->device.buffers();
}

const base::StorageBlock* LiveScene::blockOf(scene::BufferIndex buffer) const {
    for (const plan::FramePlan* plan : state_->plans())
        for (const plan::PlannedProgram& program : plan->programs)
            for (const plan::BlockUse& each : program.blocks)
                if (each.buffer.buffer == buffer)
                    return &state_->askedBlocks
                                .insert_or_assign(buffer, view::blockOf(each, *program.interface))
                                .first->second;
    return nullptr;
}

void LiveScene::setCamera(const std::string& name) {
    State& state = *state_;
    state.isDrawn = false;
    if (state.ownFrame) {
        state.scene.frame = *state.ownFrame;
        state.scene.view = state.ownView;
    }
    state.camera = name;
    state.lookThrough();
    state.isViewSet = false;
}

const std::vector<scene::NamedCamera>& LiveScene::cameras() const {
    return state_->cameras;
}

void LiveScene::setMouse(double x, double y, bool isDown) {
    state_->mouseX = x;
    state_->mouseY = y;
    state_->isMouseDown = isDown;
}

bool LiveScene::readsMouse() const {
    return state_->source && any(state_->source->depends() & expression::Depends::mouse);
}

void LiveScene::restart() {
    if (state_->simulation) state_->simulation->forget();
}

std::vector<render::Simulation::Progress> LiveScene::steps() const {
    if (!state_->simulation) return {};
    return state_->simulation->progress();
}

void LiveScene::setRunHook(render::Simulation::RunHook hook) {
    if (state_->simulation) state_->simulation->setRunHook(std::move(hook));
}

}  // namespace glibra::view
