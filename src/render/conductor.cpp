#include "render/conductor.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <set>
#include <utility>

#include "glsl/es/additions.h"
#include "gpu/object/loop_limit.h"
#include "plan/overrides.h"
#include "render/consequences.h"
#include "render/draw/work_share.h"
#include "scene/view.h"

namespace glibra::render {

plan::PlanOptions planOptionsOf(const gpu::Capabilities& driver) {
    plan::PlanOptions made;
    made.maxTextureUnits = driver.combinedTextureUnits;
    made.maxImageUnits = driver.imageUnits;
    made.clipsFromZero = driver.clipControl;
    made.lacksCompute = lackOfCompute(driver);
    made.cutsDispatches = !driver.isSoftware;
    return made;
}

Conductor::Conductor(gpu::Context& usedContext, RenderOptions usedOptions, InterpretedScene interpreted,
                     Stats& stats, Direction given)
    : context(usedContext),
      loadStats(stats),
      options(std::move(usedOptions)),
      changesWithTime(interpreted.changesWithTime()),
      source(std::move(interpreted.source)),
      inputs(std::move(interpreted.inputs)),
      scene(std::move(interpreted.scene)),
      ownParts(given.hasProbes && !given.shared ? std::make_unique<SharedParts>() : nullptr),
      parts(ownParts ? ownParts.get() : given.shared),
      programs(context, scene, options, given.isTiled, stats, parts),
      device(context, scene, stats, parts, options.skip),
      direction_(std::move(given)) {}

int Conductor::loopLimit() {
    if (!loopLimit_)
        loopLimit_ = context.capabilities().isEs ? glsl::kMostRounds : gpu::measureLoopLimit(context);
    return *loopLimit_;
}

plan::FramePlan Conductor::planList(const scene::NodeList& nodes, const plan::PlanOptions& planOptions,
                                    const OutOfSight& outOfSight) {
    const auto answer = [&](const plan::Questions& asked, plan::Answers& answers) {
        for (const plan::ProgramVariant& each : asked.interfaces)
            answers.interfaces.emplace(each, &programs.interfaceOf(each));
        for (const scene::ProgramIndex each : asked.writers)
            answers.writers.emplace(each, programs.mayWriteImages(each));
        if (asked.loopLimit) answers.loopLimit = loopLimit();
        for (const scene::StepIndex& each : asked.unseen)
            answers.sight.add(each, outOfSight(nodes.draw(each), nodes.passes[each.pass]));
    };
    plan::Answers known;
    known.seesAll = !outOfSight;
    plan::FramePlan made = plan::planFrame(scene, nodes, std::move(known), planOptions, answer);
    if (direction_.adjustPlan) direction_.adjustPlan(made);
    return made;
}

Diagnostics Conductor::planSimulation(const PlanRequest& asked) {
    if (!hasBlocks()) return {};
    if (simulation) return simulation->check(plan);
    plan::PlanOptions listOptions = asked.options;
    listOptions.shareTargets = false;
    simulation.emplace(
        SimulationParts{
            context, scene, source.get(), programs, device, loadStats,
            [this, listOptions](const scene::NodeList& nodes, std::vector<scene::ObjectView> roots) mutable {
                listOptions.roots = std::move(roots);
                return planList(nodes, listOptions);
            },
            [this](const plan::FramePlan& of) { return device.prepare(of, programs, plans()); },
            [this](const plan::FramePlan& of) { recordLoops(of); }},
        options.steps);
    Diagnostics diagnostics = simulation->plan(plan, asked.framesDiffer, asked.options.roots);
    std::vector<const plan::FramePlan*> all = simulation->plans();
    all.push_back(&plan);
    append(diagnostics, plan::reportNames(scene, all, asked.options.overrides));
    return diagnostics;
}

std::vector<const plan::FramePlan*> Conductor::plans() const {
    std::vector<const plan::FramePlan*> all{&plan};
    if (simulation) std::ranges::copy(simulation->plans(), std::back_inserter(all));
    return all;
}

void Conductor::recordLoops(const plan::FramePlan& of) {
    const bool isOpen = std::ranges::any_of(of.programs, &plan::PlannedProgram::hasOpenLoops);
    if (direction_.watchesLoops && isOpen && loopLimit() > 0) programs.countLoops(of);
}

void Conductor::watchLoops(bool on) {
    direction_.watchesLoops = on;
    if (!on) return;
    frames_ = 0;
    programs.forgetCutLoops();
    for (const plan::FramePlan* each : plans()) recordLoops(*each);
}

bool Conductor::recordsLoops() const {
    return direction_.watchesLoops && std::has_single_bit(frames_ + 1);
}

Diagnostics Conductor::takeCutLoops() {
    return loopLimit_.value_or(0) > 0 ? programs.takeCutLoops(*loopLimit_) : Diagnostics();
}

bool Conductor::moveTo(const scene::FrameInputs& wanted, Diagnostics& diagnostics, Stats& stats) {
    const bool inputsDiffer = wanted.variables != inputs.variables || wanted.width != inputs.width ||
                              wanted.height != inputs.height;
    if (!interpret(wanted, diagnostics, stats)) return false;
    if (direction_.interpreted) direction_.interpreted();
    append(diagnostics, prepare(direction_.request(), inputsDiffer));
    if (!stopsWith(diagnostics)) makeDrawer();
    return true;
}

Diagnostics Conductor::prepare(Result<PlanRequest> asked, bool inputsDiffer) {
    Diagnostics diagnostics = std::move(asked.diagnostics);
    if (!asked) {
        condition = Condition::stopped;
        return diagnostics;
    }
    const bool isMarked = condition == Condition::incomplete ||
                          (condition == Condition::stopped && direction_.onError == OnError::mark);
    condition = isMarked ? Condition::incomplete : Condition::whole;
    note(diagnostics);
    const auto add = [&](Diagnostics found, bool ofBlocks = false) {
        note(found, ofBlocks);
        append(diagnostics, std::move(found));
    };
    const auto measure = [&] { return direction_.measure ? direction_.measure() : Diagnostics(); };
    const bool isFirstPlan = !hasPlan(), isFirst = !simulation;
    plan = planList(scene.frame, asked->options, asked->outOfSight);
    add(std::exchange(plan.diagnostics, {}));
    if (direction_.planned) add(direction_.planned(isFirstPlan));
    if (!stopsWith(diagnostics)) {
        add(planSimulation(*asked), true);
        if (isFirst && simulation && direction_.simulationPlanned) direction_.simulationPlanned();
    }
    if (stopsWith(diagnostics)) return diagnostics;
    add(measure());
    add(device.prepare(plan, programs, plans()));
    if (inputsDiffer && !isFirst && runsBlocks()) {
        add(simulation->variablesChanged(), true);
        add(measure());
    }
    if (isFirst && runsBlocks() && !stopsWith(diagnostics)) add(simulation->make(), true);
    return diagnostics;
}

void Conductor::makeDrawer() {
    drawer.emplace(context, plan, programs, device, direction_.drawStats ? *direction_.drawStats : loadStats);
    const bool isUsable = std::ranges::all_of(
        plan.programs, [](const plan::PlannedProgram& each) { return each.interface->usable; });
    if (!isUsable) {
        const plan::ProgramVariant builtin{{}, false, 1};
        programs.interfaceOf(builtin);
        drawer->setFallback(programs.find(builtin));
    }
    if (direction_.equip) direction_.equip(*drawer);
}

Diagnostics Conductor::simulate() {
    return runsBlocks() ? simulation->advance(inputs) : Diagnostics();
}

void Conductor::draw(const gpu::Target& target, const Shot& shot, Diagnostics& diagnostics) {
    const plan::StillNodes still =
        hasError(diagnostics) ? plan::StillNodes() : stillNodes(shot.width, shot.height);
    append(diagnostics, drawer->draw(target, {.view = view,
                                              .width = shot.width,
                                              .height = shot.height,
                                              .tile = shot.tile,
                                              .time = inputs.time,
                                              .texturePasses = shot.isFirst || !texturesComeFirst(plan),
                                              .still = &still,
                                              .recordsLoops = recordsLoops()}));
    if (!shot.axes) return;
    append(diagnostics, makeAxes());
    if (axes) axes->draw(target, scene, view, shot.tile, shot.width, shot.height);
}

bool Conductor::stopsWith(const Diagnostics& diagnostics) const {
    return hasError(diagnostics) && (condition == Condition::stopped || direction_.onError == OnError::stop);
}

void Conductor::note(const Diagnostics& diagnostics, bool ofBlocks) {
    if (!hasError(diagnostics)) return;
    if (ofBlocks)
        condition = direction_.onError == OnError::leaveOut ? Condition::withoutSteps : Condition::stopped;
    else if (direction_.onError == OnError::mark && condition == Condition::whole)
        condition = Condition::incomplete;
}

Diagnostics Conductor::makeAxes() {
    if (axes) return {};
    Result<Axes> made = Axes::create(context);
    axes = std::move(made.value);
    return std::move(made.diagnostics);
}

void Conductor::judge(Diagnostics& diagnostics) const {
    scene::hideTexts(diagnostics, scene.hiddenFiles);
    applyStrict(diagnostics, options.strict);
}

bool Conductor::interpret(const scene::FrameInputs& wanted, Diagnostics& diagnostics, Stats& stats) {
    using expression::Depends;
    using Inputs = scene::FrameInputs;
    if (!source || wanted == inputs) return false;
    const Depends depends = source->depends();
    const auto changes = [&](Depends on, auto... member) {
        return any(depends & on) && ((wanted.*member != inputs.*member) || ...);
    };
    const bool isOther = changes(Depends::time | Depends::frame | Depends::tick, &Inputs::time) ||
                         changes(Depends::window | Depends::camera, &Inputs::width, &Inputs::height) ||
                         changes(Depends::mouse, &Inputs::mouseX, &Inputs::mouseY, &Inputs::isMouseDown) ||
                         wanted.variables != inputs.variables;
    inputs = wanted;
    if (!isOther) return false;
    {
        const StageTimer timer(stats, "interpret");
        noteChange(true);
        scene = source->at(inputs);
    }
    append(diagnostics, std::move(scene.diagnostics));
    scene.diagnostics.clear();
    forgetView();
    device.beginMoment(plan);
    Resized resized;
    append(diagnostics, device.followSizes(resized));
    if (resized.isAny) forgetDrawn();  // nodes may be as before, but what they drew is gone
    // Its blocks may run over the texels of what has another size now, so they are planned anew.
    if (resized.hasLost) simulation.reset();
    return true;
}

void Conductor::placeEye(double aspect, Diagnostics& diagnostics, Stats& stats) {
    if (eyeAspect_ == aspect) return;
    eyeAspect_ = aspect;
    eyeDistance = 0;
    if (options.view == ViewPolicy::glman || scene.usesLookAt) return;
    const StageTimer timer(stats, "view");
    scene::ViewMove move = scene::autoView(
        scene, [&](scene::ShapeIndex shape) { return device.meshes().mesh(shape, false, &diagnostics); },
        aspect);
    eyeDistance = move.distance;
    append(diagnostics, std::move(move.diagnostics));
}

/// Setting a view copies the transforms of objects, which allocates memory. An unchanged view is not set
/// again.
void Conductor::lookFrom(const ViewState& state) {
    if (isViewSet_ && state == view.state() && setEyeDistance_ == eyeDistance) return;
    view = ViewMatrices(state, scene.view, eyeDistance, context.capabilities().clipControl);
    setEyeDistance_ = eyeDistance;
    isViewSet_ = true;
}

void Conductor::changeValues(
    const std::function<std::vector<plan::PlannedProgramIndex>(plan::FramePlan&)>& change) {
    noteChange(false);
    frames_ = 0;
    for (const plan::PlannedProgramIndex each : change(plan)) drawer->forgetLiterals(each);
    if (simulation) simulation->changeValues(change);
}

void Conductor::noteChange(bool ofScene) {
    if (!isDrawn_ || (drawnBefore_ && (!ofScene || drawnBefore_->scene))) return;
    if (!ofScene) {
        drawnBefore_ = Drawn{{}, plan};
        return;
    }
    if (!drawnBefore_) drawnBefore_ = Drawn{{}, std::move(plan)};
    drawnBefore_->scene = std::move(scene);
    drawnBefore_->plan.nodes = &drawnBefore_->scene->frame;
}

plan::StillNodes Conductor::stillNodes(int width, int height) const {
    const ViewState& now = view.state();
    const bool isComparable = options.skip && isDrawn_ && drawer->drawsPlainly() && width == drawnWidth_ &&
                              height == drawnHeight_ && now.projection == ProjectionMode::scene &&
                              drawnView_.projection == ProjectionMode::scene &&
                              now.objects == drawnView_.objects && now.texture == drawnView_.texture &&
                              plan::mayStandStill(plan);
    if (!isComparable) return {};
    std::set<plan::Object> moved;
    std::vector<bool> isMovedNode(plan.order.size());
    if (now.scene != drawnView_.scene || now.eye != drawnView_.eye) {
        const std::set<std::string> cameras = movedCameras(*plan.nodes);
        for (std::size_t node = 0; node < plan.order.size(); ++node) {
            const scene::NodeIndex& at = plan.order[node];
            if (at.kind != scene::NodeIndex::Kind::pass) continue;
            const scene::Pass& pass = plan.passOf(plan.passes[at.index]);
            isMovedNode[node] = !pass.isWindow && cameras.contains(pass.rootCamera);
            if (!isMovedNode[node]) continue;
            moved.insert(plan.accesses[node].written.begin(), plan.accesses[node].written.end());
        }
    }
    const bool hasRun = simulation && simulation->changes() != drawnChanges_;
    const plan::PlannedScene before =
        drawnBefore_
            ? plan::PlannedScene{drawnBefore_->scene ? *drawnBefore_->scene : scene, drawnBefore_->plan}
            : plan::PlannedScene{scene, plan};
    plan::StillNodes still = plan::stillNodes(before, {scene, plan}, [&](const plan::Object& each) {
        return moved.contains(each) || (hasRun && simulation->lasts(each));
    });
    for (std::size_t node = 0; node < still.nodes.size(); ++node)
        if (isMovedNode[node]) still.nodes[node] = false;
    for (const plan::Object& each : moved) still.contents.erase(each);
    return still;
}

void Conductor::noteDrawn(int width, int height, const Diagnostics& diagnostics) {
    ++frames_;
    drawnBefore_.reset();
    isDrawn_ = drawer && drawer->drawsPlainly() && !hasError(diagnostics);
    if (!isDrawn_) return;
    drawnView_ = view.state();
    drawnWidth_ = width;
    drawnHeight_ = height;
    drawnChanges_ = simulation ? simulation->changes() : 0;
}

void Conductor::forgetDrawn() {
    isDrawn_ = false;
    drawnBefore_.reset();
}

}  // namespace glibra::render
