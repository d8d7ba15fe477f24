#include "render/live/live_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <set>
#include <variant>

#include "glib/number.h"
#include "glib/statement_table.h"
#include "plan/buffers.h"
#include "plan/loop_rounds.h"
#include "render/consequences.h"
#include "render/draw/axes.h"
#include "render/load/open_loops.h"

namespace glibra::render {

// ---- What a LiveScene holds

namespace {

using glib::Command;
using glib::CommandId;
using glib::Value;

bool isStage(CommandId id) {
    return (id >= CommandId::vertex && id <= CommandId::fragment) || id == CommandId::compute;
}

bool isControl(Value::Kind kind) {
    return kind == Value::Kind::range || kind == Value::Kind::color || kind == Value::Kind::truth;
}

void add(const Command& command, std::string& text) {
    const bool isLetOfControl = (command.id == CommandId::let || command.id == CommandId::bound) &&
                                std::any_of(command.values.begin(), command.values.end(),
                                            [](const Value& each) { return isControl(each.kind); });
    if (isLetOfControl) {
        text += "Let";
        for (const Value& each : command.values) text += " " + (isControl(each.kind) ? "?" : written(each));
        text += '\n';
        return;
    }
    text += written(command);
    for (const double each : command.numbers) text += " " + glib::numberText(each);
    for (const glib::UniformSpec& each : command.uniforms) {
        text += " " + each.tag;
        const bool isFixed = each.form == glib::UniformForm::number || each.form == glib::UniformForm::list;
        if (isFixed)
            for (const double value : each.values) text += " " + glib::numberText(value);
    }
    text += '\n';
}

}  // namespace

std::string stepText(std::span<const glib::Script* const> scripts) {
    std::string text;
    for (const glib::Script* script : scripts) {
        std::size_t blockEnd = 0;  // the command that ends the outermost open block, or is before the next
        for (std::size_t i = 0; i < script->commands.size(); ++i) {
            const Command& command = script->commands[i];
            const bool opens = command.partner != Command::kNoPartner && command.partner > i;
            const bool isInBlock = blockEnd > i || (blockEnd == i && i > 0);
            if (opens && command.id != CommandId::pass) blockEnd = std::max(blockEnd, command.partner);
            if (isStage(command.id) || (!isInBlock && !glib::restartsSimulation(command.id))) continue;
            add(command, text);
        }
        text += '\f';
    }
    return text;
}

bool hasTangents(const plan::PlannedMesh& mesh) {
    return std::ranges::find(mesh.attributes, geometry::kTangent) != mesh.attributes.end();
}

LiveState::LiveState(gpu::Context& context, RenderOptions options, InterpretedScene interpreted)
    : conductor(context, std::move(options), std::move(interpreted), loadStats,
                {.onError = OnError::leaveOut,
                 .interpreted =
                     [this] {
                         cameras = conductor.source->cameras();
                         lookThrough();
                     },
                 .request = [this] { return Result<PlanRequest>(request()); },
                 .adjustPlan = [this](plan::FramePlan& made) { apply(conductor.scene, changedKnobs, made); },
                 .planned =
                     [this](bool) {
                         // Picking draws the window's passes again, after the frame.
                         if (!texturesComeFirst(conductor.plan)) conductor.plan.sharing.clear();
                         isWireframe = conductor.drawer && conductor.drawer->isWireframe();
                         return Diagnostics();
                     },
                 .measure = [this] { return findBounds(); },
                 .equip =
                     [this](FrameDrawer& drawer) {
                         drawer.setWireframe(isWireframe);
                         drawer.cullToTile(drawsOutOfSight ? 0 : samples);
                     },
                 .drawStats = &drawStats}) {
    if (conductor.source) cameras = conductor.source->cameras();
    for (const scene::FileReference& each : conductor.scene.files) {
        std::error_code missing;
        fileTimes.emplace(each.path, std::filesystem::last_write_time(each.path, missing));
    }
}

Diagnostics LiveState::prepare(LiveState* previous) {
    if (previous) {
        conductor.programs.inherit(previous->conductor.programs);
        conductor.device.inherit(previous->conductor.device);
        keepsTextures = previous->keepsTextures;
    }
    Diagnostics diagnostics = makePlan();
    conductor.programs.forgetPrevious();
    return diagnostics;
}

/// What decides the content of what lasts, besides values that the window changes.
std::string LiveState::sourceOfSteps() const {
    const scene::Scene& scene = conductor.scene;
    if (!conductor.runsBlocks() || !conductor.source) return {};
    std::string text = stepText(conductor.source->scripts());
    const auto addFile = [&](scene::FileIndex index) {
        if (!index) return;
        const auto time = fileTimes.find(scene.files[index].path);
        text += fmt::format("{} {}\n", scene.files[index].path.generic_string(),
                            time == fileTimes.end() ? 0 : time->second.time_since_epoch().count());
    };
    for (const scene::Shape& each : scene.shapes) addFile(each.file);
    for (const plan::FramePlan* each : conductor.simulation->plans()) {
        for (const plan::PlannedProgram& planned : each->programs) {
            const BuiltProgram* built = conductor.programs.find(planned.variant);
            text += fmt::format("program {}\n", built && built->program ? built->program->id() : 0);
        }
        for (const scene::TextureIndex texture : each->textures)
            if (const auto* picture = std::get_if<scene::PictureSource>(&scene.textures[texture].source))
                for (const scene::FileIndex file : picture->files) addFile(file);
        for (const scene::BufferIndex buffer : each->buffers) addFile(scene.buffers[buffer].file);
    }
    return text;
}

PlanRequest LiveState::request() const {
    plan::PlanOptions options = planOptionsOf(conductor.context.capabilities());
    options.shareTargets = !keepsTextures;
    options.reportsNames = !conductor.hasBlocks();
    // Frames of a window may differ in what they read, so all nodes that write something are kept.
    return {std::move(options)};
}

Diagnostics LiveState::findBounds() {
    Diagnostics diagnostics;
    for (const plan::PlannedMesh& each : conductor.plan.meshes)
        conductor.device.meshes().bounds(each.shape, hasTangents(each), &diagnostics);
    return diagnostics;
}

Diagnostics LiveState::makePlan() {
    Diagnostics diagnostics = conductor.prepare(request());
    conductor.makeDrawer();
    append(diagnostics, conductor.context.debugLog().takeDiagnostics());
    return diagnostics;
}

/// Plans the same scene with other programs. Its diagnostics are known already.
void LiveState::planAgain() {
    conductor.forgetDrawn();
    const Condition before = conductor.condition;
    conductor.device.beginMoment(conductor.plan);
    makePlan();
    conductor.condition = before;
}

Diagnostics LiveState::drawFrame(const gpu::Target& target, bool axes) {
    const int width = target.width(), height = target.height();
    samples = target.samples();
    conductor.drawer->cullToTile(drawsOutOfSight ? 0 : samples);
    const bool records = conductor.recordsLoops();
    Diagnostics diagnostics;
    conductor.draw(target, {width, height, {0, 0, width, height}, true, axes}, diagnostics);
    conductor.noteDrawn(width, height, diagnostics);
    if (records) append(diagnostics, conductor.takeCutLoops());
    return diagnostics;
}

/// Replaces the camera of the passes that the window's transforms move.
void LiveState::lookThrough() {
    ownFrame.reset();
    untried.clear();
    const auto find = [&](const std::string& name) {
        return std::ranges::find(cameras, name, &scene::NamedCamera::name);
    };
    const auto wanted = find(camera);
    if (wanted == cameras.end()) return giveTried();
    scene::Scene& scene = conductor.scene;
    ownFrame = scene.frame;
    ownView = std::exchange(scene.view, wanted->view);
    for (scene::Pass& pass : scene.frame.passes) {
        if (!isMoved(*ownFrame, pass)) continue;
        const auto own = find(pass.camera.empty() ? "eye" : pass.camera);
        const bool isMirrored = own != cameras.end() && own->isMirrored;
        for (auto& step : pass.steps) {
            auto* draw = std::get_if<scene::Draw>(&step);
            if (draw == nullptr || std::holds_alternative<scene::ClipSpace>(*draw->projection)) continue;
            draw->modelView = wanted->view * draw->model;
            draw->projection = wanted->projection;
            if (wanted->isMirrored == isMirrored) continue;
            draw->raster.change().front = base::opposite(draw->raster->front);
        }
    }
    giveTried();
}

/// Gives the draws of the frame the states that are tried.
void LiveState::giveTried() {
    if (tried.empty()) return;
    auto& passes = conductor.scene.frame.passes;
    for (std::size_t pass = 0; pass < passes.size(); ++pass)
        for (std::size_t step = 0; step < passes[pass].steps.size(); ++step) {
            auto* draw = std::get_if<scene::Draw>(&passes[pass].steps[step]);
            const auto found = draw == nullptr ? tried.end() : tried.find(draw->id);
            if (found == tried.end() || draw->word != found->second.word ||
                *draw->raster != found->second.ofScene)
                continue;
            untried.emplace_back(scene::StepIndex{pass, step}, *draw->raster);
            draw->raster = found->second.wanted;
        }
}

void LiveState::takeTriedBack() {
    for (const auto& [at, raster] : untried)
        std::get<scene::Draw>(conductor.scene.frame.passes.at(at.pass).steps.at(at.step)).raster = raster;
    untried.clear();
}

// ---- The scene

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
            state->conductor.simulation->takeOver(*previous->state_->conductor.simulation);
        scene::hideTexts(loading.diagnostics, state->conductor.scene.hiddenFiles);
        applyStrict(loading.diagnostics, false);
        explainRemovedLoops(state->conductor.scene, state->conductor.plan, state->conductor.programs,
                            loading.diagnostics);
        loading.scene.reset(new LiveScene(std::move(state)));
        loading.isPreviousLost = false;
    } catch (const std::bad_alloc&) {
        loading.diagnostics.push_back(diagnose("draw-E05", "out of memory", {path.generic_string(), 1, 1}));
    }
    return loading;
}

std::vector<Knob> LiveScene::knobs() const {
    return knobsOf(state_->conductor.scene, state_->conductor.plans());
}
std::vector<Knob> LiveScene::unsetKnobs() const {
    return render::unsetKnobs(state_->conductor.scene, state_->conductor.plans());
}

std::vector<std::string> LiveScene::labels(std::span<const std::string> only) const {
    return onlyLabels(labelsOf(state_->conductor.scene, state_->conductor.plans()), only);
}

bool LiveScene::isAnimated() const {
    using expression::Depends;
    if (!state_->conductor.scene.steps.empty()) return true;
    if (state_->conductor.source &&
        any(state_->conductor.source->depends() & (Depends::time | Depends::frame | Depends::tick)))
        return true;
    for (const plan::PlannedProgram& program : state_->conductor.plan.programs)
        for (const plan::UniformBinding& each : program.values)
            if (const auto* supplied = std::get_if<plan::Supplied>(&each.value))
                if (supplied->value == glsl::Builtin::timer) return true;
    return false;
}

bool LiveScene::showsEarlierProgram(scene::ProgramIndex program) const {
    return std::ranges::any_of(state_->conductor.plan.programs, [&](const plan::PlannedProgram& each) {
        const BuiltProgram* built =
            each.variant.program == program ? state_->conductor.programs.find(each.variant) : nullptr;
        return built != nullptr && built->isLastGood;
    });
}

std::vector<std::filesystem::path> LiveScene::files() const {
    std::vector<std::filesystem::path> files{state_->conductor.scene.path};
    std::set<std::filesystem::path> known{state_->conductor.scene.path};
    const auto add = [&](const std::filesystem::path& file) {
        if (!file.empty() && known.insert(file).second) files.push_back(file);
    };
    for (const scene::FileReference& each : state_->conductor.scene.files) add(each.path);
    for (const std::filesystem::path& each : state_->conductor.programs.filesRead()) add(each);
    return files;
}

scene::SearchFolders LiveScene::searchFolders() const {
    return scene::searchFolders(state_->conductor.scene.path,
                                {.libraryRoots = state_->conductor.options.libraryRoots});
}

std::vector<std::filesystem::path> LiveScene::missingFiles() const {
    const std::set<std::filesystem::path>& included = state_->conductor.programs.filesMissing();
    std::vector<std::filesystem::path> paths(included.begin(), included.end());
    std::optional<scene::SearchFolders> folders;
    for (const scene::FileReference& each : state_->conductor.scene.files) {
        if (!each.path.empty()) continue;
        if (!folders) folders = searchFolders();
        for (std::filesystem::path& place : scene::placesOf(each.name, *folders))
            paths.push_back(std::move(place));
    }
    return paths;
}

bool LiveScene::keepTextures(Diagnostics& diagnostics) {
    LiveState& state = *state_;
    if (std::exchange(state.keepsTextures, true) || state.conductor.plan.sharing.empty()) return false;
    state.conductor.forgetDrawn();
    state.conductor.device.beginMoment(state.conductor.plan);
    append(diagnostics, state.makePlan());
    return true;
}

bool LiveScene::observe(const BuiltProgram& program, const glsl::MainWrapper& fragment) {
    if (!state_->conductor.programs.observe(program, fragment)) return false;
    state_->planAgain();
    return true;
}

void LiveScene::stopObserving() {
    state_->conductor.programs.stopObserving();
    state_->planAgain();
}

void LiveScene::drawOutOfSight(bool on) {
    state_->drawsOutOfSight = on;
    state_->conductor.drawer->cullToTile(on ? 0 : state_->samples);
}

void LiveScene::setValue(const Knob& knob) {
    LiveState& state = *state_;
    state.conductor.watchLoops(false);
    if (!knob.program) {
        state.variables[knob.tag] = knob.current;
        return;
    }
    std::erase_if(state.changedKnobs,
                  [&](const Knob& each) { return each.program == knob.program && each.tag == knob.tag; });
    state.changedKnobs.push_back(knob);
    state.conductor.changeValues(
        [&](plan::FramePlan& plan) { return apply(state.conductor.scene, {&knob, 1}, plan); });
}

Diagnostics LiveScene::longLoops() {
    Diagnostics diagnostics;
    for (const plan::PlannedProgram& each : state_->conductor.plan.programs)
        append(diagnostics, plan::reportLongLoops(each, [this] { return state_->conductor.loopLimit(); }));
    applyStrict(diagnostics, false);  // programs may share a file
    return diagnostics;
}

bool LiveScene::hasLoopsToWatch() {
    return std::ranges::any_of(state_->conductor.plans(), hasOpenLoops) && state_->conductor.loopLimit() > 0;
}

void LiveScene::watchLoops() {
    state_->conductor.watchLoops(true);
    state_->conductor.forgetDrawn();
    // What only Once makes is made once more in the same way.
    if (state_->conductor.simulation && state_->conductor.scene.steps.empty() &&
        std::ranges::any_of(state_->conductor.simulation->plans(), hasOpenLoops))
        state_->conductor.simulation->forget();
}

std::vector<Place> LiveScene::openLoops() {
    std::vector<Place> places;
    for (const plan::FramePlan* plan : state_->conductor.plans())
        for (const plan::PlannedProgram& each : plan->programs) {
            const glsl::TranslatedProgram* text = state_->conductor.programs.translated(each.variant);
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
            const bool isKnown = !state_->conductor.changesWithTime && !readsMouse();
            for (const glsl::TranslatedStage& stage : text->stages)
                for (Place& place : render::openLoops(
                         stage, isKnown ? glsl::UniformValue(value)
                                        : [](std::string_view) { return std::optional<double>(); }))
                    if (std::ranges::find(places, place) == places.end()) places.push_back(std::move(place));
        }
    return places;
}

bool LiveScene::moveTo(int width, int height, double time, Diagnostics& diagnostics) {
    if (!state_->conductor.source) return false;
    scene::FrameInputs wanted = state_->conductor.inputs;
    wanted.time = time;
    wanted.width = width;
    wanted.height = height;
    wanted.mouseX = state_->mouseX;
    wanted.mouseY = state_->mouseY;
    wanted.isMouseDown = state_->isMouseDown;
    for (const auto& [name, values] : state_->variables) wanted.variables[name] = values;
    if (!state_->conductor.moveTo(wanted, diagnostics, state_->drawStats)) return false;
    append(diagnostics, state_->conductor.context.debugLog().takeDiagnostics());
    return true;
}

bool LiveScene::look(int width, int height, const ViewState& view, double time, Diagnostics& diagnostics) {
    LiveState& state = *state_;
    const bool isNew = moveTo(width, height, time, diagnostics);
    state.conductor.placeEye(static_cast<double>(width) / height, diagnostics, state.drawStats);
    state.conductor.lookFrom(view);
    return isNew;
}

Diagnostics LiveScene::draw(const gpu::Target& target, const ViewState& view, double time, bool axes) {
    LiveState& state = *state_;
    Diagnostics diagnostics;
    look(target.width(), target.height(), view, time, diagnostics);
    state.conductor.inputs.time = time;
    append(diagnostics, state.conductor.simulate());
    append(diagnostics, state.drawFrame(target, axes));
    target.resolve();
    append(diagnostics, state.conductor.context.debugLog().takeDiagnostics());
    return diagnostics;
}

FrameDrawer& LiveScene::drawer() {
    state_->conductor.forgetDrawn();
    return *state_->conductor.drawer;
}
const VertexBox* LiveScene::boxOf(const plan::PlannedDraw& draw) {
    LiveState& state = *state_;
    const plan::PlannedMesh& mesh = state.conductor.plan.meshes[draw.mesh];
    const plan::ProgramVariant& variant = state.conductor.plan.programs[draw.program].variant;
    if (state.conductor.programs.placementOf(variant) == glsl::Placement::unknown) return nullptr;
    const VertexBox& box = state.conductor.device.meshes().bounds(mesh.shape, hasTangents(mesh), nullptr);
    return box.isKnown ? &box : nullptr;
}
const geometry::Mesh* LiveScene::meshOf(const plan::PlannedDraw& draw) {
    const plan::PlannedMesh& planned = state_->conductor.plan.meshes[draw.mesh];
    Diagnostics alreadyReported;
    return state_->conductor.device.meshes().mesh(planned.shape, hasTangents(planned), &alreadyReported);
}
const DeviceMesh* LiveScene::deviceMeshOf(const plan::PlannedDraw& draw) const {
    return state_->conductor.device.meshes().onDevice(state_->conductor.plan, draw.mesh);
}
const gpu::Texture* LiveScene::completed(scene::TextureIndex index, bool isPrevious) {
    return state_->conductor.device.textures().completed({.texture = index, .isPrevious = isPrevious});
}
Result<DeviceScene*> LiveScene::beginWrite(const plan::Object& object) {
    Conductor& conductor = state_->conductor;
    conductor.forgetDrawn();
    if (conductor.simulation && conductor.simulation->lasts(object) && !conductor.simulation->hasRun())
        if (Diagnostics failed = conductor.simulate(); hasError(failed)) return failed;
    return &conductor.device;
}

void LiveScene::setCamera(const std::string& name) {
    LiveState& state = *state_;
    state.conductor.forgetDrawn();
    state.takeTriedBack();
    if (state.ownFrame) {
        state.conductor.scene.frame = *state.ownFrame;
        state.conductor.scene.view = state.ownView;
    }
    state.camera = name;
    state.lookThrough();
    state.conductor.forgetView();
}

void LiveScene::tryStates(TriedStates states) {
    LiveState& state = *state_;
    state.takeTriedBack();
    state.tried = std::move(states);
    state.giveTried();
    state.planAgain();
}

void LiveScene::setMouse(double x, double y, bool isDown) {
    state_->mouseX = x;
    state_->mouseY = y;
    state_->isMouseDown = isDown;
}

bool LiveScene::readsMouse() const {
    return state_->conductor.source && any(state_->conductor.source->depends() & expression::Depends::mouse);
}

void LiveScene::restart() {
    if (state_->conductor.simulation) state_->conductor.simulation->forget();
}

std::vector<Simulation::Progress> LiveScene::steps() const {
    if (!state_->conductor.simulation) return {};
    return state_->conductor.simulation->progress();
}

void LiveScene::setRunHook(Simulation::RunHook hook) {
    if (state_->conductor.simulation) state_->conductor.simulation->setRunHook(std::move(hook));
}

}  // namespace glibra::render
