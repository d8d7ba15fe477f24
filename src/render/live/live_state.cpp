#include "render/live/live_state.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>

#include "glib/number.h"
#include "glib/statement_table.h"

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

}  // namespace glibra::render
