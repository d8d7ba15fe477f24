#include "render/simulation/block_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <variant>

#include "scene/view.h"

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

/// Calls `visit` with each draw of the plan that covers its target and reads the camera.
template <class Visit>
void visitFills(const plan::FramePlan& plan, Visit&& visit) {
    for (const plan::PlannedPass& pass : plan.passes)
        for (const auto& step : pass.steps)
            if (const auto* draw = std::get_if<plan::PlannedDraw>(&step);
                draw != nullptr && std::holds_alternative<scene::ClipSpace>(plan.drawOf(*draw).projection) &&
                plan::readsCamera(plan.programs[draw->program]))
                visit(*draw);
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

void addReads(const plan::FramePlan& plan, std::vector<scene::ObjectView>& to) {
    for (std::size_t node = 0; node < plan.order.size(); ++node)
        for (const plan::ObjectUse& each : usesOf(plan, node))
            if (each.reads && std::find(to.begin(), to.end(), each.object) == to.end())
                to.push_back(each.object);
}

std::vector<scene::ObjectView> allObjects(const scene::Scene& scene) {
    std::vector<scene::ObjectView> objects;
    for (const scene::TextureIndex each : scene.textures.indices())
        objects.emplace_back(scene::TextureView{.texture = each});
    for (const scene::BufferIndex each : scene.buffers.indices())
        objects.emplace_back(scene::BufferView{each});
    return objects;
}

bool readsTimedVariable(const plan::FramePlan& plan) {
    const auto& all = plan.programs;
    return std::any_of(all.begin(), all.end(), [](const auto& each) { return !each.timed.empty(); });
}

bool readsCamera(const plan::FramePlan& plan) {
    bool reads = false;
    visitFills(plan, [&](const plan::PlannedDraw&) { reads = true; });
    return reads;
}

void addCameras(const plan::FramePlan& plan, const scene::NodeList& now, std::vector<double>& to) {
    visitFills(plan, [&](const plan::PlannedDraw& planned) {
        const auto [pass, step] = planned.step;
        if (pass >= now.passes.size() || step >= now.passes[pass].steps.size()) return;
        const auto* draw = std::get_if<scene::Draw>(&now.passes[pass].steps[step]);
        const auto* space = draw != nullptr ? std::get_if<scene::ClipSpace>(&draw->projection) : nullptr;
        if (space == nullptr) return;
        scene::Projection projection;
        std::visit([&](const auto& each) { projection = each; }, space->projection);
        for (const glm::dmat4& matrix : {space->view, scene::projectionMatrix(projection, 1)})
            to.insert(to.end(), &matrix[0][0], &matrix[0][0] + 16);
    });
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
