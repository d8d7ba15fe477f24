#include "render/draw/simulation_checks.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <variant>

namespace glibra::render {
namespace {

/// Calls `visit` with each program of a draw or dispatch of the plan and the place of the statement.
template <class Visit>
void visitUses(const plan::FramePlan& plan, Visit&& visit) {
    for (const plan::PlannedPass& pass : plan.passes)
        for (const auto& step : pass.steps)
            if (const auto* draw = std::get_if<plan::PlannedDraw>(&step))
                visit(plan.programs[draw->program], plan.drawOf(*draw).place);
    for (const plan::PlannedDispatch& each : plan.dispatches)
        visit(plan.programs[each.program], plan.dispatchOf(each).place);
}

/// What the frame writes, with the first place.
std::map<plan::Object, Place> writesOf(const plan::FramePlan& frame) {
    std::map<plan::Object, Place> writes;
    for (std::size_t node = 0; node < frame.order.size(); ++node)
        for (const plan::ObjectUse& each : usesOf(frame, node))
            if (each.writes)
                writes.try_emplace(plan::objectOf(each.object), nodePlaceOf(frame, frame.order[node]));
    return writes;
}

}  // namespace

std::string nameOf(const scene::Scene& scene, const scene::ObjectView& object) {
    if (const auto* buffer = std::get_if<scene::BufferView>(&object))
        return scene.buffers[buffer->buffer].name;
    const scene::Texture& texture = scene.textures[std::get<scene::TextureView>(object).texture];
    return texture.name.empty() ? fmt::format("unit {}", texture.unit) : texture.name;
}

const Place& nodePlaceOf(const plan::FramePlan& plan, const scene::NodeIndex& node) {
    switch (node.kind) {
        case scene::NodeIndex::Kind::dispatch:
            return plan.dispatchOf(plan.dispatches.at(node.index)).place;
        case scene::NodeIndex::Kind::clear:
            return plan.clearOf(plan.clears.at(node.index)).place;
        case scene::NodeIndex::Kind::pass:
            break;
    }
    return plan.passOf(plan.passes.at(node.index)).place;
}

Diagnostics timedReadsOfOnce(const scene::Scene& scene, const plan::FramePlan& once) {
    Diagnostics diagnostics;
    visitUses(once, [&](const plan::PlannedProgram& program, const Place& place) {
        for (const std::string& each : program.timed)
            diagnostics.push_back(
                diagnose("memory-E11",
                         fmt::format("Once: the uniform '{}' of program '{}' reads the variable of its name, "
                                     "which changes with time, but what Once writes stays; read it in Step",
                                     each, scene.programs[program.variant.program].name),
                         place));
    });
    return diagnostics;
}

Diagnostics readsOfFrame(const scene::Scene& scene, const CheckedBlock& block, const plan::FramePlan& frame,
                         const std::function<bool(const plan::Object&)>& lasts) {
    const std::map<plan::Object, Place> writes = writesOf(frame);
    std::set<plan::Object> seen;
    Diagnostics diagnostics;
    for (std::size_t node = 0; node < block.plan.order.size(); ++node)
        for (const plan::ObjectUse& each : usesOf(block.plan, node)) {
            const plan::Object object = plan::objectOf(each.object);
            const auto written = writes.find(object);
            if (!each.reads || written == writes.end() || lasts(object) || !seen.insert(object).second)
                continue;
            diagnostics.push_back(diagnose(
                "memory-W01",
                fmt::format("{0} reads '{1}', which only the frame writes (line {2}), so the result depends "
                            "on the pictures that were drawn before; write '{1}' in {0}",
                            block.word, nameOf(scene, each.object), written->second.line),
                nodePlaceOf(block.plan, block.plan.order[node])));
        }
    return diagnostics;
}

}  // namespace glibra::render
