#include "render/simulation/simulation.h"

#include <fmt/format.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "base/text.h"
#include "render/draw/view_matrices.h"
#include "render/simulation/block_checks.h"
#include "scene/conditions.h"

namespace glibra::render {
namespace {

constexpr std::int64_t kVeryMany = std::int64_t{1} << 62;

/// True if the list has the object, whole or a part of it.
bool writes(const std::vector<scene::ObjectView>& list, const scene::ObjectView& object) {
    return std::ranges::any_of(
        list, [&](const auto& each) { return plan::objectOf(each) == plan::objectOf(object); });
}

/// True if the values are the same. One that is not a number is equal to itself.
bool isSame(const std::vector<double>& a, const std::vector<double>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

}  // namespace

/// A block with its plan. The nodes are a copy: the scene is interpreted again for other times.
struct Simulation::Block {
    std::size_t index = 0;  ///< in the scene
    bool isOnce = false;
    double rate = 0;
    Place place;
    bool dependsOnTick = false;
    scene::NodeList nodes;
    plan::FramePlan plan;
    std::optional<FrameDrawer> drawer;
    std::vector<scene::ObjectView> written;     ///< by any of its plans so far
    std::optional<std::vector<double>> resets;  ///< StepBlock::resets at the last step
    std::int64_t firstTick = 0;                 ///< of the step since which it runs
    bool isOfStep = false;                      ///< a Once that was planned while a step ran
    glm::dmat4 view{1.0};
    std::optional<ViewMatrices> seen;  ///< by `view`; made when the block first runs
    std::uint64_t runs = 0;            ///< with these values

    [[nodiscard]] const char* word() const { return isOnce ? "Once" : "Step"; }
};

Simulation::Simulation(SimulationParts parts, std::int64_t mostSteps)
    : parts_(std::move(parts)), mostSteps_(mostSteps) {}
Simulation::~Simulation() {
    for (const auto* list : {&once_, &steps_})
        for (const auto& each : *list) parts_.device.forget(each->plan);
}

Diagnostics Simulation::plan(const plan::FramePlan& frame, bool framesDiffer,
                             std::vector<scene::ObjectView> roots) {
    const scene::Scene& scene = parts_.scene;
    bool dependsOnTick = false;
    const auto add = [&](std::vector<std::unique_ptr<Block>>& to, bool isOnce, const scene::NodeList& nodes,
                         const Place& place) -> Block& {
        Block& block = *to.emplace_back(std::make_unique<Block>());
        block.index = to.size() - 1;
        block.isOnce = isOnce;
        block.place = place;
        block.nodes = nodes;
        block.view = scene.view;
        return block;
    };
    for (const scene::OnceBlock& each : scene.once) add(once_, true, each.nodes, each.place);
    for (const scene::StepBlock& each : scene.steps) {
        Block& block = add(steps_, false, each.nodes, each.place);
        block.rate = each.rate;
        noteDepends(block, each);
        dependsOnTick = dependsOnTick || block.dependsOnTick;
    }
    done_.assign(steps_.size(), 0);
    roots_ = framesDiffer || dependsOnTick ? allObjects(scene) : std::move(roots);
    addReads(frame, roots_);
    Diagnostics diagnostics = planAll();
    // Now it is known whose programs read the camera, or variables that change with time.
    for (const auto& each : steps_) {
        const bool did = each->dependsOnTick;
        noteDepends(*each, scene.steps[each->index]);
        if (did || !each->dependsOnTick || dependsOnTick) continue;
        dependsOnTick = true;
        roots_ = allObjects(scene);
        diagnostics = planAll();
    }
    for (const auto& each : once_) append(diagnostics, timedReadsOfOnce(scene, each->plan));
    append(diagnostics, check(frame));
    append(diagnostics, checkReads());
    for (const plan::FramePlan* each : plans()) parts_.device.noteWrites(*each);
    return diagnostics;
}

void Simulation::noteDepends(Block& block, const scene::StepBlock& now) const {
    block.dependsOnTick = parts_.source != nullptr &&
                          (now.dependsOnTick || (now.fillsDependOnTick && readsCamera(block.plan)) ||
                           readsTimedVariable(block.plan));
}

/// What a needed node of a block reads is needed of the other blocks, and of its own next step.
Diagnostics Simulation::planAll() {
    Diagnostics diagnostics;
    for (std::size_t before = roots_.size() + 1; before != roots_.size();) {
        before = roots_.size();
        diagnostics.clear();
        for (const auto* list : {&once_, &steps_})
            for (const auto& block : *list) {
                for (const scene::Until& until : block->nodes.untils)
                    for (const scene::BufferIndex each : until.reads)
                        if (!writes(roots_, scene::BufferView{each}))
                            roots_.emplace_back(scene::BufferView{each});
                block->plan = parts_.planList(block->nodes, roots_);
                append(diagnostics, block->plan.diagnostics);
                addReads(block->plan, roots_);
            }
    }
    // Every block says so once.
    const auto lacks = [](const Diagnostic& each) { return each.id == "memory-E01"; };
    if (const auto first = std::ranges::find_if(diagnostics, lacks); first != diagnostics.end())
        diagnostics.erase(std::remove_if(first + 1, diagnostics.end(), lacks), diagnostics.end());
    for (const auto* list : {&once_, &steps_})
        for (const auto& block : *list) {
            for (const scene::Pass& pass : block->nodes.passes)
                if (pass.isWindow)
                    diagnostics.push_back(diagnose(
                        "memory-E09",
                        fmt::format("{0}: what is drawn into the window does not last; draw into a texture, "
                                    "or move the pass out of {0}",
                                    block->word()),
                        pass.place));
            noteWrites(*block);
        }
    return diagnostics;
}

void Simulation::noteWrites(Block& block) {
    for (const plan::NodeAccess& node : block.plan.accesses)
        for (const plan::ObjectUse& each : node.uses) {
            if (!each.writes) continue;
            if (!writes(block.written, each.object)) block.written.push_back(each.object);
            if (lasts(plan::objectOf(each.object))) continue;
            lasting_.push_back({each.object, block.place, block.word()});
            parts_.device.state(plan::objectOf(each.object)).setLasting();
        }
}

/// The first draw of the node whose shaders write the object; null if the node does not write it by a draw. A
/// pass that no statement begins has no place of its own.
static const scene::Draw* writerOf(const plan::FramePlan& frame, const scene::NodeIndex& node,
                                   const scene::ObjectView& object) {
    if (node.kind != scene::NodeIndex::Kind::pass) return nullptr;
    const plan::Object wanted = plan::objectOf(object);
    for (const auto& step : frame.passes.at(node.index).steps) {
        const auto* draw = std::get_if<plan::PlannedDraw>(&step);
        if (draw == nullptr) continue;
        const auto uses = plan::shaderUses(frame.programs[draw->program], draw->textures);
        if (std::ranges::any_of(uses, [&](const plan::ObjectUse& each) {
                return each.writes && plan::objectOf(each.object) == wanted;
            }))
            return &frame.drawOf(*draw);
    }
    return nullptr;
}

Diagnostics Simulation::check(const plan::FramePlan& frame) const {
    Diagnostics diagnostics;
    for (std::size_t node = 0; node < frame.order.size(); ++node)
        for (const plan::ObjectUse& each : frame.accesses[node].uses) {
            if (!each.writes) continue;
            const auto lasts = std::ranges::find_if(lasting_, [&](const Lasting& known) {
                return plan::objectOf(known.object) == plan::objectOf(each.object);
            });
            if (lasts == lasting_.end()) continue;
            const scene::Draw* const writer = writerOf(frame, frame.order[node], each.object);
            diagnostics.push_back(diagnose(
                "memory-E07",
                fmt::format("'{}' lasts, because {} writes it (line {}), so the frame may only read it; {}",
                            nameOf(parts_.scene, each.object), lasts->word, lasts->place.line,
                            each.stores ? "write it in Step, or declare it readonly in the shaders here, "
                                          "because what is not readonly counts as written"
                                        : "write it in Step"),
                writer != nullptr ? writer->place : frame.placeOf(frame.order[node])));
            return diagnostics;
        }
    return diagnostics;
}

/// The frame is planned once more, with the dispatches that only a block would need.
Diagnostics Simulation::checkReads() const {
    std::vector<scene::ObjectView> reads;
    for (const plan::FramePlan* each : plans()) addReads(*each, reads);
    std::erase_if(reads, [this](const auto& each) { return lasts(plan::objectOf(each)); });
    if (reads.empty() || parts_.scene.frame.isEmpty()) return {};
    const plan::FramePlan frame = parts_.planList(parts_.scene.frame, std::move(reads));
    Diagnostics diagnostics;
    for (const auto* list : {&once_, &steps_})
        for (const auto& each : *list)
            append(diagnostics, readsOfFrame(parts_.scene, {each->word(), each->plan}, frame,
                                             [this](const plan::Object& object) { return lasts(object); }));
    return diagnostics;
}

Diagnostics Simulation::make() {
    Diagnostics diagnostics;
    for (const plan::FramePlan* each : plans()) append(diagnostics, parts_.prepare(*each));
    return diagnostics;
}

std::vector<std::int64_t> Simulation::stepsAt(double time) const {
    std::vector<std::int64_t> steps;
    for (const auto& each : steps_) {
        const bool isNeeded = !each->plan.order.empty() || each->dependsOnTick;
        steps.push_back(isNeeded ? render::stepsAt(time, each->rate) : 0);
    }
    return steps;
}

bool Simulation::lasts(const plan::Object& object) const {
    return std::ranges::any_of(lasting_,
                               [&](const Lasting& each) { return plan::objectOf(each.object) == object; });
}

std::vector<const plan::FramePlan*> Simulation::plans() const {
    std::vector<const plan::FramePlan*> plans;
    for (const auto* list : {&once_, &steps_})
        for (const auto& each : *list) plans.push_back(&each->plan);
    return plans;
}

std::vector<std::vector<double>> Simulation::onceReads() const {
    std::vector<std::vector<double>> reads;
    for (const scene::OnceBlock& each : parts_.scene.once) reads.push_back(each.reads);
    for (const auto& block : once_) {
        std::vector<double>& literals = reads.emplace_back();
        if (block->index < parts_.scene.once.size())
            addCameras(block->plan, parts_.scene.once[block->index].nodes, literals);
        for (const plan::PlannedProgram& program : block->plan.programs)
            for (const plan::UniformBinding& each : program.values)
                if (const auto* literal = std::get_if<plan::Literal>(&each.value))
                    literals.insert(literals.end(), literal->values.begin(), literal->values.end());
    }
    return reads;
}

Diagnostics Simulation::variablesChanged() {
    Diagnostics diagnostics;
    for (const auto& block : steps_) {
        if (block->index >= parts_.scene.steps.size()) continue;
        const scene::StepBlock& now = parts_.scene.steps[block->index];
        hasRun_ = hasRun_ && block->rate == now.rate;
        block->rate = now.rate;
        noteDepends(*block, now);
        if (!block->dependsOnTick) append(diagnostics, planAgain(*block, now.nodes));
    }
    return diagnostics;
}

void Simulation::changeValues(
    const std::function<std::vector<plan::PlannedProgramIndex>(plan::FramePlan&)>& change) {
    for (const auto* list : {&once_, &steps_})
        for (const auto& block : *list)
            for (const plan::PlannedProgramIndex each : change(block->plan)) {
                block->runs = 0;
                if (block->drawer) block->drawer->forgetLiterals(each);
            }
}

void Simulation::forget() {
    hasRun_ = false;
    for (const auto* list : {&once_, &steps_})
        for (const auto& block : *list) block->runs = 0;
}

void Simulation::takeOver(Simulation& previous) {
    if (!previous.hasRun_ || previous.done_.size() != done_.size()) return;
    for (const Lasting& each : lasting_)
        parts_.device.takeOver(previous.parts_.device, plan::objectOf(each.object));
    done_ = previous.done_;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        steps_[i]->resets = previous.steps_[i]->resets;
        steps_[i]->firstTick = previous.steps_[i]->firstTick;
    }
    onceReads_ = previous.onceReads_;
    hasRun_ = true;
}

std::vector<Simulation::Progress> Simulation::progress() const {
    std::vector<Progress> progress;
    for (const auto& each : steps_)
        progress.push_back({each->place, each->rate, hasRun_ ? done_[progress.size()] : 0});
    return progress;
}

Diagnostics Simulation::advance(const scene::FrameInputs& inputs) {
    const StageTimer timer(parts_.stats, "simulate");
    const std::vector<std::vector<double>> reads = onceReads();
    const std::vector<std::int64_t> to = stepsAt(inputs.time);
    std::vector<double> rates;
    for (const auto& each : steps_) rates.push_back(each->rate);
    Diagnostics diagnostics;
    if (!hasRun_ || reads != onceReads_ || !canGoOn(rates, done_, to)) {
        append(diagnostics, restart(!onceReads_.empty() && reads != onceReads_));
        onceReads_ = onceReads();  // blocks that were planned again may have other literals
        if (hasError(diagnostics)) return diagnostics;
    }
    std::int64_t steps = 0;
    for (std::size_t i = 0; i < to.size(); ++i)
        steps = to[i] - done_[i] > kVeryMany - steps ? kVeryMany : steps + (to[i] - done_[i]);
    if (steps > mostSteps_) {
        const auto slowest = std::ranges::max_element(to);
        diagnostics.push_back(diagnose(
            "memory-E08",
            fmt::format("the picture at {} s needs {} steps; the limit is {} (--steps N allows more)",
                        inputs.time, base::groupedText(steps), base::groupedText(mostSteps_)),
            steps_[static_cast<std::size_t>(slowest - to.begin())]->place));
        return diagnostics;
    }
    std::vector<std::vector<double>> resets;  // of blocks whose steps have the scene of the frame
    for (const scene::StepBlock& each : parts_.scene.steps) resets.push_back(each.resets);
    resets.resize(steps_.size());
    // Steps that depend on their tick need a scene of their own.
    std::optional<scene::Scene> frame;
    inOrderOfTime(rates, done_, to, [&](const StepNumber& step) {
        if (steps_[step.block]->dependsOnTick && !frame) {
            frame = std::exchange(parts_.scene, {});
            parts_.device.meshes().forgetShapes();
        }
        if (Block& block = *steps_[step.block];
            !block.dependsOnTick && hasOtherResets(block, resets[step.block]))
            append(diagnostics, beginAnew(block, step.tick));
        append(diagnostics, runStep(step, inputs));
        if (!parts_.context.capabilities().isSoftware) queue_.endStep();
        return !hasError(diagnostics);
    });
    closeDrawer();
    if (frame) {
        parts_.scene = std::move(*frame);
        parts_.device.meshes().forgetShapes();
    }
    if (hasError(diagnostics))
        hasRun_ = false;
    else
        done_ = to;
    return diagnostics;
}

/// What lasts becomes as declared, and the Once blocks run.
Diagnostics Simulation::restart(bool plansAgain) {
    Diagnostics diagnostics;
    ++changes_;
    hasRun_ = true;
    done_.assign(steps_.size(), 0);
    for (const auto& each : steps_) {
        each->resets.reset();
        each->firstTick = 0;
    }
    for (const Lasting& each : lasting_)
        if (parts_.device.state(plan::objectOf(each.object)).isWritten)
            append(diagnostics, parts_.device.reset(plan::objectOf(each.object)));
    for (const auto& block : once_) {
        if ((plansAgain || std::exchange(block->isOfStep, false)) && block->index < parts_.scene.once.size())
            append(diagnostics, planAgain(*block, parts_.scene.once[block->index].nodes));
        if (!hasError(diagnostics)) append(diagnostics, run(*block, 0));
    }
    return diagnostics;
}

bool Simulation::hasOtherResets(Block& block, const std::vector<double>& now) {
    const bool isOther = block.resets && !isSame(*block.resets, now);
    block.resets = now;
    return isOther;
}

/// What the block writes becomes as declared, and the Once blocks run that write any of it.
Diagnostics Simulation::beginAnew(Block& step, std::int64_t tick) {
    step.firstTick = tick;
    std::vector<scene::ObjectView> objects = step.written;
    std::vector<bool> runs(once_.size());
    for (bool grows = true; grows;) {
        grows = false;
        for (const auto& each : once_) {
            const auto isShared = [&](const scene::ObjectView& object) { return writes(objects, object); };
            if (runs[each->index] || std::ranges::none_of(each->written, isShared)) continue;
            runs[each->index] = grows = true;
            objects.insert(objects.end(), each->written.begin(), each->written.end());
        }
    }
    closeDrawer();
    Diagnostics diagnostics;
    std::vector<scene::ObjectView> done;
    for (const scene::ObjectView& each : objects) {
        if (writes(done, each)) continue;
        done.push_back(each);
        if (parts_.device.state(plan::objectOf(each)).isWritten)
            append(diagnostics, parts_.device.reset(plan::objectOf(each)));
    }
    for (const auto& each : once_) {
        if (!runs[each->index] || each->index >= parts_.scene.once.size() || hasError(diagnostics)) continue;
        each->isOfStep = true;  // the scene may be that of the step
        append(diagnostics, planAgain(*each, parts_.scene.once[each->index].nodes));
        if (!hasError(diagnostics)) append(diagnostics, run(*each, 0));
    }
    return diagnostics;
}

Diagnostics Simulation::planAgain(Block& block, const scene::NodeList& nodes) {
    closeDrawer();
    parts_.device.beginMoment(block.plan);
    block.drawer.reset();
    block.seen.reset();
    block.nodes = nodes;
    block.view = parts_.scene.view;
    block.plan = parts_.planList(block.nodes, roots_);
    Diagnostics diagnostics = std::move(block.plan.diagnostics);
    noteWrites(block);
    parts_.device.noteWrites(block.plan);
    if (!hasError(diagnostics)) append(diagnostics, parts_.prepare(block.plan));
    return diagnostics;
}

Diagnostics Simulation::run(Block& block, double time) {
    if (block.plan.order.empty()) return {};
    if (!block.drawer) {
        closeDrawer();  // the limit of loops may be measured
        parts_.recordLoops(block.plan);
        block.drawer.emplace(parts_.context, block.plan, parts_.programs, parts_.device, parts_.stats);
    }
    if (!block.seen)
        block.seen.emplace(ViewState(), block.view, 0, parts_.context.capabilities().clipControl);
    if (open_ != &*block.drawer) closeDrawer();
    const Run run{block.isOnce, block.rate, block.place, block.plan, *block.drawer};
    if (hook_) hook_(run, true);
    // Steps of one block come one after the other, and nothing else uses the context between them.
    const bool staysOpen = !hook_ && !block.isOnce;
    if (staysOpen) open_ = &*block.drawer;
    Diagnostics ofRounds;
    Diagnostics diagnostics =
        block.drawer->run({.view = *block.seen,
                           .tile = {0, 0, 1, 1},
                           .time = time,
                           .staysOpen = staysOpen,
                           .recordsLoops = std::has_single_bit(++block.runs),
                           .holds = [&](const scene::Until& until) { return holds(until, ofRounds); }});
    append(diagnostics, std::move(ofRounds));
    if (hook_) hook_(run, false);
    return diagnostics;
}

bool Simulation::holds(const scene::Until& until, Diagnostics& diagnostics) {
    const scene::Question& question = until.condition.condition;
    scene::ConditionNames names = *question.names;
    names.readBuffers([&](const scene::BufferView& view) {
        const DeviceBuffers& buffers = parts_.device.buffers();
        const plan::BufferLayout* layout = buffers.layout(view.buffer);
        if (layout == nullptr) return std::vector<double>();
        const std::size_t head = layout->pattern.element.empty() ? 0 : layout->pattern.head.size();
        return buffers.read(view, head, std::numeric_limits<std::uint64_t>::max());
    });
    const Result<scene::Answer> answer = scene::answerTo(
        *question.expression, names, until.condition.place.file, {.types = scene::kConditionTypes});
    append(diagnostics, answer.diagnostics);
    const bool isLast = until.round == until.rounds;
    const bool ends = !answer || answer->value.truth();
    if (!ends && !isLast) return false;
    parts_.stats.skip(
        "rounds",
        fmt::format("Repeat until {}: {} of {} rounds", until.condition.text, until.round, until.rounds),
        until.condition.place);
    if (!ends && notReached_.insert({until.condition.place.file, until.condition.place.line}).second)
        diagnostics.push_back(scene::notReached(until.condition, until.rounds, answer->found));
    return ends;
}

void Simulation::closeDrawer() {
    if (open_ != nullptr) std::exchange(open_, nullptr)->close();
}

Diagnostics Simulation::runStep(const StepNumber& step, scene::FrameInputs inputs) {
    Block& block = *steps_[step.block];
    const double time = static_cast<double>(step.tick) / block.rate;
    parts_.stats.add("steps", 1);
    ++changes_;
    if (!block.dependsOnTick) return run(block, time);
    inputs.time = time;
    inputs.ticks.assign(steps_.size(), 0);
    inputs.ticks[step.block] = step.tick;
    inputs.firstTicks.assign(steps_.size(), 0);
    inputs.firstTicks[step.block] = block.firstTick;
    inputs.sinceStepBefore = 1 / block.rate;
    parts_.scene = parts_.source->at(inputs);
    Diagnostics diagnostics = std::move(parts_.scene.diagnostics);
    const auto isLost = [&] { return step.block >= parts_.scene.steps.size() || hasError(diagnostics); };
    if (isLost()) return diagnostics;
    if (hasOtherResets(block, parts_.scene.steps[step.block].resets)) {
        append(diagnostics, beginAnew(block, step.tick));
        inputs.firstTicks[step.block] = step.tick;
        parts_.scene = parts_.source->at(inputs);
        if (isLost()) return diagnostics;
    }
    append(diagnostics, planAgain(block, parts_.scene.steps[step.block].nodes));
    if (!hasError(diagnostics)) append(diagnostics, run(block, time));
    return diagnostics;
}

// How many steps a time has seen, and in which order those of several blocks run (language, 12.8).

namespace {

constexpr std::int64_t kLastStep = std::int64_t{1} << 62;

/// When a step is due, times the rates of both: exact for the rates and ticks of real scenes.
bool isEarlier(std::span<const double> rates, const StepNumber& a, const StepNumber& b) {
    const auto dueA = (static_cast<long double>(a.tick) + 1) * static_cast<long double>(rates[b.block]);
    const auto dueB = (static_cast<long double>(b.tick) + 1) * static_cast<long double>(rates[a.block]);
    return dueA != dueB ? dueA < dueB : a.block < b.block;
}

}  // namespace

std::int64_t stepsAt(double time, double rate) {
    const double steps = std::floor(std::fma(time, rate, 0x1p-20));
    if (!(steps > 0)) return 0;
    return steps < static_cast<double>(kLastStep) ? static_cast<std::int64_t>(steps) : kLastStep;
}

void inOrderOfTime(std::span<const double> rates, std::span<const std::int64_t> from,
                   std::span<const std::int64_t> to, const std::function<bool(StepNumber)>& run) {
    std::vector<std::int64_t> next(from.begin(), from.end());
    while (true) {
        std::optional<StepNumber> first;
        for (std::size_t block = 0; block < next.size(); ++block) {
            const StepNumber step{block, next[block]};
            if (next[block] < to[block] && (!first || isEarlier(rates, step, *first))) first = step;
        }
        if (!first || !run(*first)) return;
        ++next[first->block];
    }
}

bool canGoOn(std::span<const double> rates, std::span<const std::int64_t> done,
             std::span<const std::int64_t> to) {
    for (std::size_t ran = 0; ran < done.size(); ++ran) {
        if (to[ran] < done[ran]) return false;
        for (std::size_t comes = 0; comes < done.size(); ++comes)
            if (done[ran] > 0 && done[comes] < to[comes] &&
                isEarlier(rates, {comes, done[comes]}, {ran, done[ran] - 1}))
                return false;
    }
    return true;
}

}  // namespace glibra::render
