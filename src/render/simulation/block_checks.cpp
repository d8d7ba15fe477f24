#include "render/simulation/block_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <variant>

#include "scene/view.h"

namespace glibra::render {
namespace {

/// Calls `visit` with each draw of the plan that covers its target and reads the camera.
template <class Visit>
void visitFills(const plan::FramePlan& plan, Visit&& visit) {
    plan.visitDraws([&](const plan::PlannedDraw& planned, const scene::Draw& draw, const auto&) {
        if (std::holds_alternative<scene::ClipSpace>(*draw.projection) &&
            plan::readsCamera(plan.programs[planned.program]))
            visit(planned);
    });
}

/// What the frame writes, with the first place.
std::map<plan::Object, Place> writesOf(const plan::FramePlan& frame) {
    std::map<plan::Object, Place> writes;
    for (std::size_t node = 0; node < frame.order.size(); ++node)
        for (const plan::Object& each : frame.accesses[node].written)
            writes.try_emplace(each, frame.placeOf(frame.order[node]));
    return writes;
}

}  // namespace

std::string nameOf(const scene::Scene& scene, const scene::ObjectView& object) {
    if (const auto* buffer = std::get_if<scene::BufferView>(&object))
        return scene.buffers[buffer->buffer].name;
    const scene::Texture& texture = scene.textures[std::get<scene::TextureView>(object).texture];
    return texture.name.empty() ? fmt::format("unit {}", texture.unit) : texture.name;
}

void addReads(const plan::FramePlan& plan, std::vector<scene::ObjectView>& to) {
    for (const plan::NodeAccess& node : plan.accesses)
        for (const plan::ObjectUse& each : node.uses)
            if (each.reads && std::ranges::find(to, each.object) == to.end()) to.push_back(each.object);
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
    return std::ranges::any_of(all, [](const auto& each) { return !each.timed.empty(); });
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
        const auto* space = draw != nullptr ? std::get_if<scene::ClipSpace>(&*draw->projection) : nullptr;
        if (space == nullptr) return;
        scene::Projection projection;
        std::visit([&](const auto& each) { projection = each; }, space->projection);
        for (const glm::dmat4& matrix : {space->view, scene::projectionMatrix(projection, 1)})
            to.insert(to.end(), &matrix[0][0], &matrix[0][0] + 16);
    });
}

Diagnostics timedReadsOfOnce(const scene::Scene& scene, const plan::FramePlan& once) {
    Diagnostics diagnostics;
    const auto check = [&](const auto& planned, const auto& statement, const auto&...) {
        const plan::PlannedProgram& program = once.programs[planned.program];
        for (const std::string& each : program.timed)
            diagnostics.push_back(
                diagnose("memory-E11",
                         fmt::format("Once: the uniform '{}' of program '{}' reads the variable of its name, "
                                     "which changes with time, but what Once writes stays; read it in Step",
                                     each, scene.programs[program.variant.program].name),
                         statement.place));
    };
    once.visitDraws(check);
    for (const plan::PlannedDispatch& each : once.dispatches) check(each, once.dispatchOf(each));
    return diagnostics;
}

Diagnostics readsOfFrame(const scene::Scene& scene, const CheckedBlock& block, const plan::FramePlan& frame,
                         const std::function<bool(const plan::Object&)>& lasts) {
    const std::map<plan::Object, Place> writes = writesOf(frame);
    std::set<plan::Object> seen;
    Diagnostics diagnostics;
    for (std::size_t node = 0; node < block.plan.order.size(); ++node)
        for (const plan::ObjectUse& each : block.plan.accesses[node].uses) {
            const plan::Object object = plan::objectOf(each.object);
            const auto written = writes.find(object);
            if (!each.reads || written == writes.end() || lasts(object) || !seen.insert(object).second)
                continue;
            diagnostics.push_back(diagnose(
                "memory-W01",
                fmt::format("{0} reads '{1}', which only the frame writes (line {2}), so the result depends "
                            "on the pictures that were drawn before; write '{1}' in {0}",
                            block.word, nameOf(scene, each.object), written->second.line),
                block.plan.placeOf(block.plan.order[node])));
        }
    return diagnostics;
}

}  // namespace glibra::render
