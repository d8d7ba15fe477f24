#include "render/draw/dispatch.h"

#include <fmt/format.h>

#include <algorithm>

#include "glib/number.h"
#include "gpu/object/compute.h"
#include "render/draw/frame.h"

namespace glibra::render {
namespace {

GroupCounts sizeOf(const DeviceScene& device, const scene::ObjectView& object) {
    if (const auto* buffer = std::get_if<scene::BufferView>(&object)) {
        const plan::BufferLayout* layout = device.buffers().layout(buffer->buffer);
        return {layout ? std::max<std::uint64_t>(1, layout->elements) : 0, 1, 1};
    }
    const auto& view = std::get<scene::TextureView>(object);
    const gpu::Texture* texture = device.texture(view);
    if (!texture) return {0, 1, 1};
    const int level = view.level.value_or(0);
    const gpu::TextureSize size = gpu::sizeOfLevel(texture->shape(), texture->size(), level);
    const int layers = view.layer ? 1 : std::max(texture->layers(level), size.depth);
    return {static_cast<std::uint64_t>(size.width), static_cast<std::uint64_t>(size.height),
            static_cast<std::uint64_t>(layers)};
}

}  // namespace

std::string lackOfCompute(const gpu::Capabilities& driver) {
    if (driver.compute) return {};
    return fmt::format("OpenGL 4.3; this one has {}.{}", driver.major, driver.minor);
}

Result<std::array<unsigned, 3>> checkedGroups(const GroupCounts& groups, const gpu::Capabilities& driver,
                                              const Place& place) {
    std::array<unsigned, 3> checked{};
    constexpr const char* kAxes = "xyz";
    for (std::size_t axis = 0; axis < groups.size(); ++axis) {
        const auto most = static_cast<std::uint64_t>(std::max(0, driver.maxComputeGroups[axis]));
        if (groups[axis] > most)
            return diagnose("memory-E06",
                            fmt::format("Dispatch: {} groups along {}; this driver allows {}",
                                        glib::groupedText(static_cast<long long>(
                                            std::min<std::uint64_t>(groups[axis], std::uint64_t{1} << 62))),
                                        kAxes[axis], glib::groupedText(static_cast<long long>(most))),
                            place);
        checked[axis] = static_cast<unsigned>(groups[axis]);
    }
    return checked;
}

Diagnostics FrameDrawer::dispatch(const plan::PlannedDispatch& planned) {
    const scene::Dispatch& dispatch = plan_.dispatchOf(planned);
    const BuiltProgram* built = programs_.find(plan_.programs[planned.program].variant);
    if (!built || !built->program) return {};
    context_.debugLog().setPlace(dispatch.place);
    completeReads(planned.textures);
    built->program->use();
    setLiterals(planned.program, *built);
    DrawFacts facts;
    facts.timer = timerAt(frame_->time, dispatch.timerPeriod);
    setSupplied(planned.program, *built, facts);
    bindBlocks(planned.program, *built);
    bindTextures(planned.textures, *built);
    if (const auto* from = std::get_if<scene::GroupsFrom>(&dispatch.groups)) {
        if (const gpu::Buffer* counts = device_.buffers().buffer(from->buffer))
            gpu::dispatchFrom(*built->program, *counts);
    } else {
        GroupCounts groups{};
        if (const auto* counts = std::get_if<std::array<std::uint64_t, 3>>(&dispatch.groups))
            groups = *counts;
        if (const auto* over = std::get_if<scene::Over>(&dispatch.groups)) {
            const auto* object = std::get_if<scene::ObjectView>(&over->what);
            groups = gpu::groupsOver(
                object ? sizeOf(device_, *object) : std::get<std::array<std::uint64_t, 3>>(over->what),
                gpu::localSizeOf(*built->program));
        }
        const Result<std::array<unsigned, 3>> checked =
            checkedGroups(groups, context_.capabilities(), dispatch.place);
        if (!checked) return checked.diagnostics;
        gpu::dispatch(*built->program, *checked);
    }
    finishWrites(planned.program, planned.textures);
    stats_.add("dispatches", 1);
    return {};
}

void FrameDrawer::clearObject(const scene::ClearObject& clear) {
    context_.debugLog().setPlace(clear.place);
    if (const auto* buffer = std::get_if<scene::BufferIndex>(&clear.object)) {
        device_.buffers().clear(*buffer);
    } else {
        device_.clear(std::get<scene::TextureIndex>(clear.object));
    }
}

}  // namespace glibra::render
