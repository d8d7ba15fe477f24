#include "render/live/live_scene.h"

#include <algorithm>
#include <new>
#include <set>
#include <utility>
#include <variant>

#include "plan/buffers.h"
#include "plan/loop_rounds.h"
#include "render/consequences.h"
#include "render/draw/axes.h"
#include "render/live/live_state.h"
#include "render/load/open_loops.h"

namespace glibra::render {
namespace {

bool hasOpenLoops(const plan::FramePlan* plan) {
    return std::ranges::any_of(plan->programs, &plan::PlannedProgram::hasOpenLoops);
}

}  // namespace

LiveScene::LiveScene(std::unique_ptr<LiveState> state) : state_(std::move(state)) {}
LiveScene::~LiveScene() = default;

LiveScene::Loading LiveScene::load(gpu::Context& context, const std::filesystem::path& path,
                                   const RenderOptions& options, LiveScene* previous) {
    Loading loading;
    try {
        Stats stats;
        Result<InterpretedScene> interpreted = interpretFile(path, options, stats);
        loading.diagnostics = std::move(interpreted.diagnostics);
        if (!interpreted) return loading;
        auto state = std::make_unique<LiveState>(context, options, std::move(*interpreted));
        // Before the new scene takes programs away.
        const std::string earlierSteps = previous ? previous->state_->sourceOfSteps() : std::string();
        loading.isPreviousLost = previous != nullptr;  // until the new scene is complete
        append(loading.diagnostics, state->prepare(previous ? previous->state_.get() : nullptr));
        if (!earlierSteps.empty() && state->sourceOfSteps() == earlierSteps)
            state->simulation->takeOver(*previous->state_->simulation);
        applyStrict(loading.diagnostics, false);
        explainRemovedLoops(state->scene, state->plan, state->programs, loading.diagnostics);
        loading.scene.reset(new LiveScene(std::move(state)));
        loading.isPreviousLost = false;
    } catch (const std::bad_alloc&) {
        loading.diagnostics.push_back(diagnose("draw-E05", "out of memory", {path.generic_string(), 1, 1}));
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
std::vector<Knob> LiveScene::unsetKnobs() const {
    return render::unsetKnobs(state_->scene, state_->plans());
}

std::vector<std::string> LiveScene::labels(std::span<const std::string> only) const {
    return onlyLabels(labelsOf(state_->scene, state_->plans()), only);
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
    return std::ranges::any_of(state_->plan.programs, [&](const plan::PlannedProgram& each) {
        const BuiltProgram* built =
            each.variant.program == program ? state_->programs.find(each.variant) : nullptr;
        return built != nullptr && built->isLastGood;
    });
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

scene::SearchFolders LiveScene::searchFolders() const {
    return scene::searchFolders(state_->scene.path, {.libraryRoots = state_->options.libraryRoots});
}

std::vector<std::filesystem::path> LiveScene::missingFiles() const {
    const std::set<std::filesystem::path>& included = state_->programs.filesMissing();
    std::vector<std::filesystem::path> paths(included.begin(), included.end());
    std::optional<scene::SearchFolders> folders;
    for (const scene::FileReference& each : state_->scene.files) {
        if (!each.path.empty()) continue;
        if (!folders) folders = searchFolders();
        for (std::filesystem::path& place : scene::placesOf(each.name, *folders))
            paths.push_back(std::move(place));
    }
    return paths;
}

std::vector<glsl::EmittedLine> LiveScene::translatedLines(const Place& place) const {
    return state_->programs.refusedLines(place);
}

const Stats& LiveScene::loadStats() const {
    return state_->loadStats;
}

const Stats& LiveScene::drawStats() const {
    return state_->drawStats;
}

bool LiveScene::keepTextures(Diagnostics& diagnostics) {
    LiveState& state = *state_;
    if (std::exchange(state.keepsTextures, true) || state.plan.sharing.empty()) return false;
    state.forgetDrawn();
    state.device.beginMoment(state.plan);
    append(diagnostics, state.makePlan());
    return true;
}

bool LiveScene::observe(const BuiltProgram& program, const glsl::MainWrapper& fragment) {
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
    LiveState& state = *state_;
    state.watchLoops(false);
    if (!knob.program) {
        state.variables[knob.tag] = knob.current;
        return;
    }
    std::erase_if(state.changedKnobs,
                  [&](const Knob& each) { return each.program == knob.program && each.tag == knob.tag; });
    state.changedKnobs.push_back(knob);
    state.changeValues([&](plan::FramePlan& plan) { return apply(state.scene, {&knob, 1}, plan); });
}

Diagnostics LiveScene::longLoops() {
    Diagnostics diagnostics;
    for (const plan::PlannedProgram& each : state_->plan.programs)
        append(diagnostics, plan::reportLongLoops(each, [this] { return state_->loopLimit(); }));
    applyStrict(diagnostics, false);  // programs may share a file
    return diagnostics;
}

bool LiveScene::hasLoopsToWatch() {
    return std::ranges::any_of(state_->plans(), hasOpenLoops) && state_->loopLimit() > 0;
}

void LiveScene::watchLoops() {
    state_->watchLoops(true);
    state_->forgetDrawn();
    // What only Once makes is made once more in the same way.
    if (state_->simulation && state_->scene.steps.empty() &&
        std::ranges::any_of(state_->simulation->plans(), hasOpenLoops))
        state_->simulation->forget();
}

std::vector<Place> LiveScene::openLoops() {
    std::vector<Place> places;
    for (const plan::FramePlan* plan : state_->plans())
        for (const plan::PlannedProgram& each : plan->programs) {
            const glsl::TranslatedProgram* text = state_->programs.translated(each.variant);
            if (text == nullptr || !each.interface->usable) continue;
            const auto value = [&](std::string_view name) -> std::optional<double> {
                const auto& uniforms = each.interface->uniforms;
                for (const plan::UniformBinding& binding : each.values) {
                    const auto* literal = std::get_if<plan::Literal>(&binding.value);
                    if (literal != nullptr && !literal->values.empty() &&
                        at(uniforms, binding.uniform).name == name)
                        return literal->values.front();
                }
                return std::nullopt;
            };
            // An expression may give another value in the next frame.
            const bool isKnown = !state_->changesWithTime && !readsMouse();
            for (const glsl::TranslatedStage& stage : text->stages)
                for (Place& place : render::openLoops(
                         stage, isKnown ? glsl::UniformValue(value)
                                        : [](std::string_view) { return std::optional<double>(); }))
                    if (std::ranges::find(places, place) == places.end()) places.push_back(std::move(place));
        }
    return places;
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

bool LiveScene::look(int width, int height, const ViewState& view, double time, Diagnostics& diagnostics) {
    LiveState& state = *state_;
    const bool isNew = moveTo(width, height, time, diagnostics);
    state.placeEye(static_cast<double>(width) / height, diagnostics, state.drawStats);
    state.lookFrom(view);
    return isNew;
}

Diagnostics LiveScene::draw(const gpu::Target& target, const ViewState& view, double time, bool axes) {
    LiveState& state = *state_;
    Diagnostics diagnostics;
    look(target.width(), target.height(), view, time, diagnostics);
    const Tile whole{0, 0, target.width(), target.height()};
    if (state.simulation && !state.isSimulationWrong) {
        state.inputs.time = time;
        append(diagnostics, state.simulation->advance(state.inputs));
    }
    append(diagnostics, state.drawFrame(target, time));
    if (axes) append(diagnostics, state.makeAxes());
    if (axes && state.axes)
        state.axes->draw(target, state.scene, state.view, whole, target.width(), target.height());
    target.resolve();
    append(diagnostics, state.context.debugLog().takeDiagnostics());
    return diagnostics;
}

const ViewMatrices& LiveScene::view() const {
    return state_->view;
}
double LiveScene::eyeDistance() const {
    return state_->eyeDistance;
}
FrameDrawer& LiveScene::drawer() {
    state_->forgetDrawn();
    return *state_->drawer;
}
const VertexBox* LiveScene::boxOf(const plan::PlannedDraw& draw) {
    LiveState& state = *state_;
    const plan::PlannedMesh& mesh = state.plan.meshes[draw.mesh];
    const plan::ProgramVariant& variant = state.plan.programs[draw.program].variant;
    if (state.programs.placementOf(variant) == glsl::Placement::unknown) return nullptr;
    const VertexBox& box = state.device.meshes().bounds(mesh.shape, hasTangents(mesh), nullptr);
    return box.isKnown ? &box : nullptr;
}
const geometry::Mesh* LiveScene::meshOf(const plan::PlannedDraw& draw) {
    const plan::PlannedMesh& planned = state_->plan.meshes[draw.mesh];
    Diagnostics alreadyReported;
    return state_->device.meshes().mesh(planned.shape, hasTangents(planned), &alreadyReported);
}
const DeviceMesh* LiveScene::deviceMeshOf(const plan::PlannedDraw& draw) const {
    return state_->device.meshes().onDevice(state_->plan, draw.mesh);
}
const gpu::Texture* LiveScene::texture(scene::TextureIndex index) const {
    return state_->device.textures().texture(index);
}
const gpu::Texture* LiveScene::completed(scene::TextureIndex index, bool isPrevious) {
    return state_->device.textures().completed({.texture = index, .isPrevious = isPrevious});
}
Result<TexelNumbers> LiveScene::numbersOf(const scene::TextureView& view) {
    return state_->device.textures().numbersOf(view);
}
const DeviceScene& LiveScene::device() const {
    return state_->device;
}
const DeviceBuffers& LiveScene::buffers() const {
    return state_->device.buffers();
}

const base::StorageBlock* LiveScene::blockOf(scene::BufferIndex buffer) const {
    for (const plan::FramePlan* each : state_->plans())
        if (std::optional<base::StorageBlock> found = plan::blockOf(*each, buffer))
            return &state_->askedBlocks.insert_or_assign(buffer, std::move(*found)).first->second;
    return nullptr;
}

void LiveScene::setCamera(const std::string& name) {
    LiveState& state = *state_;
    state.forgetDrawn();
    state.takeTriedBack();
    if (state.ownFrame) {
        state.scene.frame = *state.ownFrame;
        state.scene.view = state.ownView;
    }
    state.camera = name;
    state.lookThrough();
    state.forgetView();
}

void LiveScene::tryStates(TriedStates states) {
    LiveState& state = *state_;
    state.takeTriedBack();
    state.tried = std::move(states);
    state.giveTried();
    state.planAgain();
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

std::vector<Simulation::Progress> LiveScene::steps() const {
    if (!state_->simulation) return {};
    return state_->simulation->progress();
}

void LiveScene::setRunHook(Simulation::RunHook hook) {
    if (state_->simulation) state_->simulation->setRunHook(std::move(hook));
}

}  // namespace glibra::render
