#include "render/live/live_state.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>

#include "glib/modern/statement_table.h"
#include "glib/number.h"

namespace glibra::render {
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
    text += " " + command.text;
    for (const std::string& each : command.files) text += " " + each;
    for (const glib::PointGroup& group : command.points)
        for (const double each : group.values) text += " " + glib::numberText(each);
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

Diagnostics LiveState::prepare(LiveState* previous) {
    if (previous) {
        programs.inherit(previous->programs);
        device.inherit(previous->device);
        keepsTextures = previous->keepsTextures;
    }
    Diagnostics diagnostics = makePlan();
    programs.forgetPrevious();
    return diagnostics;
}

/// What decides the content of what lasts, besides values that the window changes.
std::string LiveState::sourceOfSteps() const {
    if (!simulation || isSimulationWrong || !source) return {};
    std::string text = stepText(source->scripts());
    const auto addFile = [&](scene::FileIndex index) {
        if (!index) return;
        const auto time = fileTimes.find(scene.files[index].path);
        text += fmt::format("{} {}\n", scene.files[index].path.generic_string(),
                            time == fileTimes.end() ? 0 : time->second.time_since_epoch().count());
    };
    for (const scene::Shape& each : scene.shapes) addFile(each.file);
    for (const plan::FramePlan* each : simulation->plans()) {
        for (const plan::PlannedProgram& planned : each->programs) {
            const BuiltProgram* built = programs.find(planned.variant);
            text += fmt::format("program {}\n", built && built->program ? built->program->id() : 0);
        }
        for (const scene::TextureIndex texture : each->textures)
            if (const auto* picture = std::get_if<scene::PictureSource>(&scene.textures[texture].source))
                for (const scene::FileIndex file : picture->files) addFile(file);
        for (const scene::BufferIndex buffer : each->buffers) addFile(scene.buffers[buffer].file);
    }
    return text;
}

/// Interprets the scene for other inputs, if it depends on what has changed, and plans it.
bool LiveState::moveTo(const scene::FrameInputs& wanted, Diagnostics& diagnostics) {
    // A step may read the size of the window.
    const bool variablesDiffer = wanted.variables != inputs.variables || wanted.width != inputs.width ||
                                 wanted.height != inputs.height;
    if (!interpret(wanted, diagnostics, drawStats)) return false;
    cameras = source->cameras();
    lookThrough();
    append(diagnostics, makePlan(variablesDiffer));
    return true;
}

Diagnostics LiveState::makePlan(bool variablesDiffer) {
    plan::PlanOptions planOptions = planOptionsOf(context.capabilities());
    planOptions.shareTargets = !keepsTextures;
    planOptions.reportsNames = !hasBlocks();
    plan = planList(scene.frame, planOptions);
    // Picking draws the window's passes again, after the frame.
    if (!texturesComeFirst(plan)) plan.sharing.clear();
    Diagnostics diagnostics = std::move(plan.diagnostics);
    plan.diagnostics.clear();
    const bool isNew = !simulation;
    if (hasBlocks()) {
        // Frames of a window may differ in what they read, so all nodes that write something are kept.
        const Diagnostics ofSteps = planSimulation(planOptions, true);
        isSimulationWrong = hasError(ofSteps);
        append(diagnostics, ofSteps);
    }
    const auto findBounds = [&] {
        for (const plan::PlannedMesh& each : plan.meshes)
            device.meshes().bounds(each.shape, hasTangents(each), &diagnostics);
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
    makeDrawer(drawStats);
    drawer->setWireframe(isWireframe);
    drawer->cullToTile(drawsOutOfSight ? 0 : samples);
    append(diagnostics, context.debugLog().takeDiagnostics());
    return diagnostics;
}

/// Plans the same scene with other programs. Its diagnostics are known already.
void LiveState::planAgain() {
    forgetDrawn();
    const bool wasSimulationWrong = isSimulationWrong;
    device.beginMoment(plan);
    makePlan();
    isSimulationWrong = wasSimulationWrong;
}

Diagnostics LiveState::drawFrame(const gpu::Target& target, double time) {
    const int width = target.width(), height = target.height();
    samples = target.samples();
    drawer->cullToTile(drawsOutOfSight ? 0 : samples);
    const plan::StillNodes still = stillNodes(width, height);
    const bool records = recordsLoops();
    Diagnostics diagnostics = drawer->draw(target, {.view = view,
                                                    .width = width,
                                                    .height = height,
                                                    .tile = {0, 0, width, height},
                                                    .time = time,
                                                    .still = &still,
                                                    .recordsLoops = records});
    noteDrawn(width, height, diagnostics);
    if (records) append(diagnostics, takeCutLoops());
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
    auto& passes = scene.frame.passes;
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
        std::get<scene::Draw>(scene.frame.passes.at(at.pass).steps.at(at.step)).raster = raster;
    untried.clear();
}

}  // namespace glibra::render
