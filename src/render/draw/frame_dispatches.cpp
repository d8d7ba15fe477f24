// One dispatch, and one clear of an object.

#include <algorithm>

#include "gpu/object/program.h"
#include "gpu/object/uniform.h"
#include "render/draw/frame.h"

namespace glibra::render {
namespace {

GroupCounts objectSizeOf(const DeviceScene& device, const scene::ObjectView& object) {
    if (const auto* buffer = std::get_if<scene::BufferView>(&object)) {
        const plan::BufferLayout* layout = device.buffers().layout(buffer->buffer);
        return {layout ? std::max<std::uint64_t>(1, layout->elements) : 0, 1, 1};
    }
    const auto& view = std::get<scene::TextureView>(object);
    const gpu::Texture* texture = device.textures().texture(view);
    if (!texture) return {0, 1, 1};
    const int level = view.level.value_or(0);
    const gpu::TextureSize size = gpu::sizeOfLevel(texture->shape(), texture->size(), level);
    const int layers = view.layer ? 1 : std::max(texture->layers(level), size.depth);
    const auto count = [](int number) { return static_cast<std::uint64_t>(number); };
    // Images of 1D arrays have the coordinates texel and layer.
    if (texture->shape() == gpu::TextureShape::array1D) return {count(size.width), count(layers), 1};
    return {count(size.width), count(size.height), count(layers)};
}

/// Sets what a piece of a dispatch knows of the whole.
void setPiece(const BuiltProgram& built, const GroupCounts& first, const GroupCounts& all) {
    const std::array piece{first, all};
    if (built.piece == piece) return;
    built.piece = piece;
    const std::array<int, 3>& localSize = built.program->localSize();
    const auto set = [&](const char* name, auto&& valueOf) {
        for (const base::ActiveUniform& uniform : built.interface.uniforms)
            if (uniform.emittedName == name)
                gpu::setUniform(*built.program, uniform, std::array{valueOf(0), valueOf(1), valueOf(2)});
    };
    set("glibra_FirstGroup", [&](std::size_t axis) { return static_cast<double>(first.at(axis)); });
    set("glibra_FirstInvocation",
        [&](std::size_t axis) { return static_cast<double>(first.at(axis)) * localSize.at(axis); });
    set("glibra_GroupCount", [&](std::size_t axis) { return static_cast<double>(all.at(axis)); });
}

}  // namespace

Diagnostics FrameDrawer::dispatch(const plan::PlannedDispatch& planned, const Frame& frame) {
    const scene::Dispatch& dispatch = plan_.dispatchOf(planned);
    const BuiltProgram* built = programs_.find(plan_.programs[planned.program].variant);
    if (!built || !built->program) return {};
    context_.debugLog().setPlace(dispatch.place);
    completeReads(planned.textures);
    setLiterals(planned.program, *built);
    DrawFacts facts;
    facts.timer = timerAt(frame.time, dispatch.timerPeriod);
    setSupplied(planned.program, *built, facts);
    bindings_.use(*built->program);
    bindBlocks(planned.program, *built);
    bindTextures(planned.textures, *built);
    const bool recordsLoops = loopCounterOf(planned.program, *built, frame) != nullptr;
    if (recordsLoops) useCounter(*built);
    Diagnostics remarks;
    if (const auto* from = std::get_if<scene::GroupsFrom>(&dispatch.groups)) {
        if (const gpu::Buffer* counts = device_.buffers().buffer(from->first.buffer)) {
            GroupCounts groups{};
            for (std::size_t axis = 0; axis < groups.size(); ++axis)
                groups.at(axis) = countIn(from->first, axis);
            const auto checked = checkedGroups(groups, context_.capabilities(), dispatch.place);
            if (!checked) return checked.diagnostics;
            append(remarks, checked.diagnostics);
            gpu::dispatchFrom(*counts, from->first.word * sizeof(GLuint));
        }
    } else {
        remarks = dispatchPieces(*built, groupsOf(planned, *built), dispatch, recordsLoops);
        if (hasError(remarks)) return remarks;
    }
    noteStores(planned.program, planned.textures);
    stats_.add("dispatches", 1);
    return remarks;
}

Diagnostics FrameDrawer::dispatchPieces(const BuiltProgram& built, const GroupCounts& groups,
                                        const scene::Dispatch& dispatch, bool recordsLoops) {
    if (!built.interface.facts.inPieces) {
        const Result<std::array<unsigned, 3>> checked =
            checkedGroups(groups, context_.capabilities(), dispatch.place);
        if (checked) gpu::dispatch(*checked);
        return checked.diagnostics;
    }
    std::size_t axis = 2;
    while (axis > 0 && groups.at(axis) <= 1) --axis;
    const std::uint64_t pieces =
        std::clamp<std::uint64_t>(groups.at(axis), 1, static_cast<std::uint64_t>(dispatch.tiles));
    Diagnostics remarks;
    const auto run = [&](std::uint64_t begin, std::uint64_t end) -> Diagnostics {
        GroupCounts first{}, part = groups;
        first.at(axis) = begin;
        part.at(axis) = end - begin;
        const Result<std::array<unsigned, 3>> checked =
            checkedGroups(part, context_.capabilities(), dispatch.place);
        if (!checked) return checked.diagnostics;
        if (remarks.empty()) remarks = checked.diagnostics;  // once for all pieces
        setPiece(built, first, groups);
        if (recordsLoops) useCounter(built);
        context_.debugLog().setPlace(dispatch.place);  // waiting has ended what was dispatched before
        gpu::dispatch(*checked);
        return {};
    };
    if (dispatch.tiles == 1) {
        const Diagnostics refused = dispatchInShares(built, groups, axis, run);
        return refused.empty() ? remarks : refused;
    }
    for (std::uint64_t piece = 0; piece < pieces; ++piece) {
        // The counts are below 2^32 and the pieces at most 65,536, so the products fit.
        Diagnostics refused = run(groups.at(axis) * piece / pieces, groups.at(axis) * (piece + 1) / pieces);
        if (!refused.empty()) return refused;
        if (pieces > 1) glFlush();
    }
    if (pieces > 1) stats_.add("pieces of dispatches", pieces);
    return remarks;
}

const GroupCounts& FrameDrawer::groupsOf(const plan::PlannedDispatch& planned, const BuiltProgram& built) {
    const auto [known, isNew] = groups_.try_emplace(&planned);
    if (!isNew) return known->second;
    const scene::Dispatch& dispatch = plan_.dispatchOf(planned);
    GroupCounts& groups = known->second;
    if (const auto* counts = std::get_if<std::array<std::uint64_t, 3>>(&dispatch.groups)) groups = *counts;
    if (const auto* over = std::get_if<scene::Over>(&dispatch.groups)) {
        const auto* object = std::get_if<scene::ObjectView>(&over->what);
        groups = gpu::groupsOver(
            object ? objectSizeOf(device_, *object) : std::get<std::array<std::uint64_t, 3>>(over->what),
            built.program->localSize());
    }
    return groups;
}

bool FrameDrawer::coversWhole(const plan::PlannedDispatch& planned, const plan::PlannedExchange& exchange) {
    const BuiltProgram* built = programs_.find(plan_.programs[planned.program].variant);
    if (built == nullptr || !built->program) return false;
    const GroupCounts& groups = groupsOf(planned, *built);
    const std::array<int, 3>& localSize = built->program->localSize();
    scene::ObjectView whole;
    if (const auto* buffer = std::get_if<scene::BufferIndex>(&exchange.object))
        whole = scene::BufferView{*buffer};
    else
        whole = scene::TextureView{.texture = std::get<scene::TextureIndex>(exchange.object)};
    const GroupCounts size = objectSizeOf(device_, whole);
    const std::vector<scene::ObjectView>& limits = exchange.whole->sizes;
    for (std::size_t axis = 0; axis < size.size(); ++axis) {
        const bool isUsed = axis < static_cast<std::size_t>(exchange.whole->axes);
        // The counts have at most 32 bits each.
        if (groups.at(axis) * static_cast<std::uint64_t>(localSize.at(axis)) < (isUsed ? size.at(axis) : 1) ||
            size.at(axis) == 0 || (!isUsed && size.at(axis) != 1))
            return false;
        if (isUsed && std::ranges::any_of(limits, [&](const scene::ObjectView& each) {
                return objectSizeOf(device_, each).at(axis) < size.at(axis);
            }))
            return false;
    }
    return true;
}

void FrameDrawer::clearObject(const scene::ClearObject& clear) {
    context_.debugLog().setPlace(clear.place);
    if (const auto* buffer = std::get_if<scene::BufferIndex>(&clear.object)) {
        device_.buffers().clear(*buffer);
    } else {
        device_.textures().clear(std::get<scene::TextureIndex>(clear.object));
        bindings_.forgetWorkUnit();
    }
}

}  // namespace glibra::render
