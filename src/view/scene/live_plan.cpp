// The scene for other inputs, and the plan of its frame and of its Once and Step blocks.

#include <algorithm>
#include <functional>
#include <utility>

#include "gpu/context/loop_limit.h"
#include "render/draw/dispatch.h"
#include "view/scene/live_state.h"

namespace glibra::view {
namespace {

/// True if no node comes after a pass into the window.
bool texturesComeFirst(const plan::FramePlan& plan) {
    const auto isOfWindow = [&](const scene::NodeIndex& node) {
        return node.kind == scene::NodeIndex::Kind::pass && plan.passOf(plan.passes[node.index]).isWindow;
    };
    return std::is_partitioned(plan.order.begin(), plan.order.end(), std::not_fn(isOfWindow));
}

}  // namespace

bool hasTangents(const plan::PlannedMesh& mesh) {
    return std::find(mesh.attributes.begin(), mesh.attributes.end(), geometry::kTangent) !=
           mesh.attributes.end();
}

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
    planOptions.cutsDispatches = !context.capabilities().isSoftware;
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

}  // namespace glibra::view
