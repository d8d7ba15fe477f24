// Buffers that samplers and images read as textures (language, 12.7).

#include <fmt/format.h>

#include <set>

#include "base/text.h"
#include "plan/uniform_names.h"
#include "render/load/device_buffers.h"

namespace glibra::render {

void DeviceBuffers::bind(const plan::TextureUse& use, gpu::BindingTracker& bindings) {
    const gpu::Buffer* buffer = this->buffer(use.buffer);
    if (buffer == nullptr) return;
    const gpu::BufferTexture& texture =
        textures_[{use.buffer.buffer, use.buffer.isPrevious, use.bufferFormat}];
    // The buffer is attached anew each time, since those with history change their places.
    if (!use.isImage) return texture.bind(use.driverUnit, *buffer, use.bufferFormat);
    texture.bindImage(use.driverUnit, *buffer, use.bufferFormat, use.imageFormat.value_or(use.bufferFormat));
    bindings.forgetImages();
}

Diagnostics DeviceBuffers::checkTexels(const plan::FramePlan& plan) const {
    Diagnostics problems;
    std::set<scene::BufferIndex> reported;
    const auto most = static_cast<std::uint64_t>(context_.capabilities().maxBufferTexels);
    const auto check = [&](plan::PlannedProgramIndex program, const std::vector<plan::TextureUse>& uses) {
        for (const plan::TextureUse& each : uses) {
            const gpu::Buffer* buffer = each.buffer.buffer ? this->buffer(each.buffer) : nullptr;
            if (buffer == nullptr) continue;
            const std::uint64_t texels = buffer->size() / base::bytesPerTexel(each.bufferFormat);
            if (texels <= most || !reported.insert(each.buffer.buffer).second) continue;
            const scene::Buffer& declared = scene_.buffers[each.buffer.buffer];
            const base::ActiveUniform& uniform = at(plan.programs[program].interface->uniforms, each.uniform);
            problems.push_back(
                diagnose("memory-E17",
                         fmt::format("buffer '{}' has {} texels for {} '{}'; this driver allows {}",
                                     declared.name, base::groupedText(texels), uniform.type.word,
                                     uniform.name, base::groupedText(most)),
                         declared.place));
        }
    };
    plan.visitDraws(
        [&](const plan::PlannedDraw& each, const auto&...) { check(each.program, each.textures); });
    for (const plan::PlannedDispatch& each : plan.dispatches) check(each.program, each.textures);
    return problems;
}

}  // namespace glibra::render
