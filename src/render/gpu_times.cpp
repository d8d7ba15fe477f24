#include "render/gpu_times.h"

#include <fmt/format.h>

#include <variant>

#include "render/simulation/block_checks.h"

namespace glibra::render {
namespace {

std::string targetsOf(const scene::Scene& scene, const scene::Pass& pass) {
    if (pass.isWindow) return "window";
    std::string targets;
    for (std::size_t i = 0; i < pass.targets.size(); ++i) {
        targets += (targets.empty() ? "" : ", ") + nameOf(scene, scene::TextureView{pass.targets[i]});
        if (i >= pass.parts.size()) continue;
        if (pass.parts[i].level) targets += fmt::format(" level {}", *pass.parts[i].level);
        if (pass.parts[i].layer) targets += fmt::format(" layer {}", *pass.parts[i].layer);
    }
    if (!pass.depth) return targets;
    targets += (targets.empty() ? "" : ", ") + nameOf(scene, scene::TextureView{pass.depth->texture});
    if (pass.depth->layer) targets += fmt::format(" layer {}", *pass.depth->layer);
    return targets;
}

}  // namespace

NodeName nameOf(const scene::Scene& scene, const plan::FramePlan& plan, std::size_t node) {
    const scene::NodeIndex& at = plan.order[node];
    const int line = plan.placeOf(at).line;
    if (at.kind == scene::NodeIndex::Kind::pass)
        return {"pass into " + targetsOf(scene, plan.passOf(plan.passes[at.index])), line};
    if (at.kind == scene::NodeIndex::Kind::dispatch)
        return {"dispatch of " + scene.programs[plan.dispatchOf(plan.dispatches[at.index]).program].name,
                line};
    const scene::ClearObject& clear = plan.clearOf(plan.clears[at.index]);
    const auto* buffer = std::get_if<scene::BufferIndex>(&clear.object);
    return {
        "clear of " + (buffer != nullptr
                           ? nameOf(scene, scene::BufferView{*buffer})
                           : nameOf(scene, scene::TextureView{std::get<scene::TextureIndex>(clear.object)})),
        line};
}

GpuTimes::GpuTimes(const gpu::Capabilities& capabilities)
    : timer_(capabilities, [this](std::size_t piece, double milliseconds) {
          ++entries_[piece].times;
          entries_[piece].milliseconds += milliseconds;
      }) {}

std::size_t GpuTimes::entryOf(NodeName name) {
    const auto [known, isNew] = known_.try_emplace({name.line, std::move(name.what)}, entries_.size());
    if (isNew) entries_.push_back({known->first.second, known->first.first});
    return known->second;
}

void GpuTimes::watch(FrameDrawer& drawer, const scene::Scene& scene, const plan::FramePlan& plan) {
    if (!measures()) return;
    drawer.setNodeHook([this, &scene, &plan](std::size_t node, bool begins) {
        // A plan that is made again for another time may have other nodes.
        begins ? timer_.begin(entryOf(nameOf(scene, plan, node))) : timer_.end();
    });
}

void GpuTimes::watch(Simulation& simulation, const scene::Scene& scene) {
    if (!measures()) return;
    simulation.setRunHook([this, &scene](const Simulation::Run& run, bool begins) {
        if (begins) watch(run.drawer, scene, run.plan);
    });
}

void GpuTimes::beginWork(const NodeName& name) {
    if (measures()) timer_.begin(entryOf(name));
}

std::vector<Stats::GpuTime> GpuTimes::finish() {
    timer_.finish();
    return entries_;
}

}  // namespace glibra::render
