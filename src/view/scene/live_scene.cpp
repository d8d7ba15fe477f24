#include "view/scene/live_scene.h"

#include <algorithm>
#include <map>
#include <new>
#include <set>
#include <utility>

#include "gpu/context/loop_limit.h"
#include "plan/loop_rounds.h"
#include "render/draw/axes.h"
#include "render/draw/dispatch.h"
#include "render/load/device_scene.h"
#include "render/load/programs.h"
#include "render/scene_renderer.h"
#include "scene/view.h"

namespace glibra::view {
namespace {

constexpr int kSamples = 1;  ///< per pixel of the pictures that a window shows

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
          device(context, scene, loadStats) {}

    gpu::Context& context;
    RenderOptions options;
    std::shared_ptr<scene::Interpretation> source;  ///< null: the scene is the same for all inputs
    scene::FrameInputs inputs;                      ///< of `scene`
    scene::Scene scene;
    render::Stats loadStats, drawStats;
    render::ProgramLibrary programs;
    render::DeviceScene device;
    plan::FramePlan plan;
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

    Diagnostics prepare(State* previous);
    Diagnostics makePlan();
    void applyKnobs();
    bool moveTo(const scene::FrameInputs& wanted, Diagnostics& diagnostics);
    void prepareFallback();
    int measuredLoopLimit();
    void placeEye(double aspect, Diagnostics& diagnostics);
};

Diagnostics LiveScene::State::prepare(State* previous) {
    if (previous) {
        programs.inherit(previous->programs);
        device.inherit(previous->device);
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
    inputs = wanted;
    if (!isOther) return false;
    scene = source->at(inputs);
    append(diagnostics, std::move(scene.diagnostics));
    scene.diagnostics.clear();
    device.beginMoment(plan);
    append(diagnostics, makePlan());
    applyKnobs();
    isViewSet = false;
    return true;
}

/// Writes the values that the user has set into the plan, whose indices may be new.
void LiveScene::State::applyKnobs() {
    if (changedKnobs.empty()) return;
    for (Knob& knob : knobsOf(scene, plan))
        for (const Knob& each : changedKnobs) {
            if (each.program != knob.program || each.tag != knob.tag) continue;
            knob.current = each.current;
            for (const plan::PlannedProgramIndex program : apply(knob, plan)) drawer->forgetLiterals(program);
        }
}

Diagnostics LiveScene::State::makePlan() {
    plan::PlanOptions planOptions;
    planOptions.maxTextureUnits = context.capabilities().combinedTextureUnits;
    planOptions.lacksCompute = render::lackOfCompute(context.capabilities());
    planOptions.loopLimit = [this] { return measuredLoopLimit(); };
    plan = plan::planFrame(
        scene, scene.frame,
        [this](const plan::ProgramVariant& variant) -> const plan::ProgramInterface& {
            return programs.interfaceOf(variant);
        },
        [this](scene::ProgramIndex program) { return programs.mayWriteImages(program); }, planOptions);
    Diagnostics diagnostics = std::move(plan.diagnostics);
    plan.diagnostics.clear();
    for (const plan::PlannedMesh& each : plan.meshes)
        device.bounds(each.shape, hasTangents(each), &diagnostics);
    append(diagnostics, device.prepare(plan, programs));
    const bool isWireframe = drawer && drawer->isWireframe();
    drawer.emplace(context, plan, programs, device, drawStats);
    drawer->setWireframe(isWireframe);
    drawer->cullToTile(drawsOutOfSight ? 0 : kSamples);
    prepareFallback();
    append(diagnostics, context.debugLog().takeDiagnostics());
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
        loading.isPreviousLost = previous != nullptr;  // until the new scene is complete
        append(loading.diagnostics, state->prepare(previous ? previous->state_.get() : nullptr));
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
    return knobsOf(state_->scene, state_->plan);
}

bool LiveScene::isAnimated() const {
    using expression::Depends;
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

void LiveScene::drawOutOfSight(bool on) {
    state_->drawsOutOfSight = on;
    state_->drawer->cullToTile(on ? 0 : kSamples);
}

void LiveScene::setValue(const Knob& knob) {
    State& state = *state_;
    if (!knob.program) {
        state.variables[knob.tag] = knob.current;
        return;
    }
    if (!state.source) {
        for (const plan::PlannedProgramIndex program : apply(knob, state.plan))
            state.drawer->forgetLiterals(program);
        return;
    }
    std::erase_if(state.changedKnobs,
                  [&](const Knob& each) { return each.program == knob.program && each.tag == knob.tag; });
    state.changedKnobs.push_back(knob);
    state.applyKnobs();
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
    append(diagnostics,
           state.drawer->draw(target, {state.view, target.width(), target.height(), whole, time}));
    if (axes && !state.axes) {
        Result<render::Axes> made = render::Axes::create(state.context);
        append(diagnostics, std::move(made.diagnostics));
        state.axes = std::move(made.value);
    }
    if (axes && state.axes) state.axes->draw(state.scene, state.view, whole, target.width(), target.height());
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
    return *state_->drawer;
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

}  // namespace glibra::view
