#include "plan/still.h"

#include <algorithm>
#include <map>
#include <optional>

#include "plan/needs.h"

namespace glibra::plan {
namespace {

/// The numbers of a plan's nodes that write each object.
std::map<Object, std::vector<std::size_t>> writersOf(const FramePlan& plan) {
    std::map<Object, std::vector<std::size_t>> writers;
    for (std::size_t node = 0; node < plan.accesses.size(); ++node)
        for (const Object& each : plan.accesses[node].written) writers[each].push_back(node);
    return writers;
}

bool isShared(const FramePlan& plan, const Object& object) {
    const auto* texture = std::get_if<scene::TextureIndex>(&object);
    return texture != nullptr && std::ranges::any_of(plan.sharing, [&](const auto& each) {
               return each.first == *texture || each.second == *texture;
           });
}

bool followsTimer(const PlannedProgram& program) {
    return std::ranges::any_of(program.values, [](const UniformBinding& each) {
        const auto* supplied = std::get_if<Supplied>(&each.value);
        return supplied != nullptr && supplied->value == glsl::Builtin::timer;
    });
}

bool isSameProgram(const PlannedProgram& a, const PlannedProgram& b) {
    const auto haveOneBuffer = [](const BlockUse& one, const BlockUse& other) {
        return one.kind == other.kind && one.index == other.index && one.buffer == other.buffer;
    };
    return a.variant == b.variant && a.interface == b.interface && a.values == b.values && !followsTimer(a) &&
           std::equal(a.blocks.begin(), a.blocks.end(), b.blocks.begin(), b.blocks.end(), haveOneBuffer);
}

bool isSameDraw(const PlannedScene& before, const PlannedDraw& a, const PlannedScene& now,
                const PlannedDraw& b) {
    const auto meshOf = [](const PlannedScene& in, const PlannedDraw& draw) -> const PlannedMesh& {
        return in.plan.meshes[draw.mesh];
    };
    const PlannedMesh &mesh = meshOf(before, a), &other = meshOf(now, b);
    if (a.submission != b.submission || a.textures != b.textures || bool(a.inputs) != bool(b.inputs) ||
        mesh.attributes != other.attributes || mesh.adjacency != other.adjacency ||
        mesh.isExpanded != other.isExpanded ||
        before.scene.shapes[mesh.shape] != now.scene.shapes[other.shape] ||
        !isSameProgram(before.plan.programs[a.program], now.plan.programs[b.program]))
        return false;
    if (a.inputs && before.plan.inputs[a.inputs].sources != now.plan.inputs[b.inputs].sources) return false;
    // The plans have resolved what these indices refer to.
    scene::Draw draw = before.plan.drawOf(a);
    const scene::Draw& same = now.plan.drawOf(b);
    draw.shape = same.shape;
    draw.slots = same.slots;
    draw.uniforms = same.uniforms;
    draw.attributes = same.attributes;
    return draw == same;
}

bool isSamePass(const PlannedScene& before, const PlannedPass& a, const PlannedScene& now,
                const PlannedPass& b) {
    const auto isSameStep = [&](const auto& step, const auto& same) {
        if (step.index() != same.index()) return false;
        if (const auto* draw = std::get_if<PlannedDraw>(&step))
            return isSameDraw(before, *draw, now, std::get<PlannedDraw>(same));
        return before.plan.clearOf(std::get<PlannedClear>(step)) ==
               now.plan.clearOf(std::get<PlannedClear>(same));
    };
    const scene::PassSetup &one = before.plan.passOf(a), &other = now.plan.passOf(b);
    return one == other &&
           std::equal(a.steps.begin(), a.steps.end(), b.steps.begin(), b.steps.end(), isSameStep);
}

bool isSameNode(const PlannedScene& before, const scene::NodeIndex& a, const PlannedScene& now,
                const scene::NodeIndex& b) {
    if (a.kind != b.kind) return false;
    if (a.kind == scene::NodeIndex::Kind::pass)
        return isSamePass(before, before.plan.passes.at(a.index), now, now.plan.passes.at(b.index));
    if (a.kind == scene::NodeIndex::Kind::clear)
        return before.plan.clearOf(before.plan.clears.at(a.index)).object ==
               now.plan.clearOf(now.plan.clears.at(b.index)).object;
    const PlannedDispatch &one = before.plan.dispatches.at(a.index), &other = now.plan.dispatches.at(b.index);
    const scene::Dispatch &first = before.plan.dispatchOf(one), &second = now.plan.dispatchOf(other);
    return one.textures == other.textures && first.groups == second.groups && first.tiles == second.tiles &&
           first.discards == second.discards &&
           isSameProgram(before.plan.programs[one.program], now.plan.programs[other.program]);
}

/// True if the pass reads or writes its depth or stencil.
bool usesDepth(const scene::Pass& pass) {
    return pass.depth || pass.clearDepth || pass.clearStencil || usesStencil(pass) ||
           std::ranges::any_of(pass.steps, [](const auto& step) {
               const auto* draw = std::get_if<scene::Draw>(&step);
               return draw != nullptr ? draw->raster->depthTest : std::get<scene::Clear>(step).depth;
           });
}

/// True if nothing outside the pass decides its depth and stencil, and no other pass goes on with them.
bool hasOwnDepth(const FramePlan& plan, const scene::Pass& pass) {
    if (!usesDepth(pass)) return true;
    if (!pass.clearDepth || (!pass.clearStencil && usesStencil(pass))) return false;
    return pass.depth || std::ranges::none_of(plan.passes, [&](const PlannedPass& each) {
               const scene::Pass& other = plan.passOf(each);
               return &other != &pass && !other.isWindow && !other.depth &&
                      other.depthBuffer == pass.depthBuffer;
           });
}

}  // namespace

bool mayStandStill(const FramePlan& plan) {
    const auto isTimed = [&](const PlannedProgramIndex each) { return followsTimer(plan.programs[each]); };
    return !plan.clears.empty() || std::ranges::any_of(plan.dispatches, [&](const PlannedDispatch& each) {
        return !isTimed(each.program);
    }) || std::ranges::any_of(plan.passes, [&](const PlannedPass& pass) {
        return !plan.passOf(pass).isWindow && std::ranges::none_of(pass.steps, [&](const auto& step) {
            const auto* draw = std::get_if<PlannedDraw>(&step);
            return draw != nullptr && isTimed(draw->program);
        });
    });
}

StillNodes stillNodes(const PlannedScene& before, const PlannedScene& now,
                      const std::function<bool(const Object&)>& changed) {
    StillNodes still;
    const auto writersBefore = writersOf(before.plan), writers = writersOf(now.plan);
    const auto onlyWriter = [](const auto& list, const Object& object) -> std::optional<std::size_t> {
        const auto found = list.find(object);
        if (found == list.end() || found->second.size() != 1) return std::nullopt;
        return found->second.front();
    };
    const auto isUnchanged = [&](const Object& object) {
        if (hasHistory(now.scene, object) || changed(object)) return false;
        if (writers.contains(object)) return still.contents.contains(object);
        if (writersBefore.contains(object)) return false;
        const auto* buffer = std::get_if<scene::BufferIndex>(&object);
        return buffer == nullptr || before.scene.buffers[*buffer].values == now.scene.buffers[*buffer].values;
    };
    still.nodes.assign(now.plan.order.size(), false);
    for (std::size_t node = 0; node < now.plan.order.size(); ++node) {
        const scene::NodeIndex& at = now.plan.order[node];
        if (at.kind == scene::NodeIndex::Kind::pass) {
            const scene::Pass& pass = now.plan.passOf(now.plan.passes.at(at.index));
            if (pass.isWindow || !hasOwnDepth(now.plan, pass)) continue;
        }
        const std::vector<ObjectUse>& uses = now.plan.accesses[node].uses;
        const std::set<Object>& written = now.plan.accesses[node].written;
        std::optional<std::size_t> earlier;
        const bool isAlone = std::ranges::all_of(written, [&](const Object& each) {
            const auto writer = onlyWriter(writersBefore, each);
            if (!writer || (earlier && *earlier != *writer)) return false;
            earlier = writer;
            const auto* buffer = std::get_if<scene::BufferIndex>(&each);
            if (buffer != nullptr &&
                before.scene.buffers[*buffer].values != now.scene.buffers[*buffer].values)
                return false;
            return onlyWriter(writers, each) == node && !hasHistory(now.scene, each) &&
                   !isShared(now.plan, each) && !isShared(before.plan, each);
        });
        if (!isAlone || !earlier) continue;
        const std::set<Object>& cleared = now.plan.accesses[node].overwritten;
        if (now.scene.goesOn && !std::ranges::includes(cleared, written)) continue;
        // What it writes begins as declared or is cleared by the node, in both frames.
        const bool readsOnlyStill = std::ranges::all_of(uses, [&](const ObjectUse& each) {
            const Object object = objectOf(each.object);
            return written.contains(object) || isUnchanged(object);
        });
        if (!readsOnlyStill || !isSameNode(before, before.plan.order[*earlier], now, at)) continue;
        still.nodes[node] = true;
        still.contents.insert(written.begin(), written.end());
    }
    if (still.contents.empty()) still.nodes.clear();
    return still;
}

}  // namespace glibra::plan
