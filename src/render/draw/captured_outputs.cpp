#include "render/draw/captured_outputs.h"

#include <algorithm>
#include <array>
#include <utility>

#include "gpu/object/uniform.h"

namespace glibra::render {

void setOwnUniform(const BuiltProgram& built, std::string_view name, double value) {
    const auto uniform = std::ranges::find(built.interface.uniforms, name, &base::ActiveUniform::emittedName);
    if (uniform != built.interface.uniforms.end())
        gpu::setUniform(*built.program, *uniform, std::array<double, 1>{value});
}

bool CapturedOutputs::read(const BuiltProgram& built, const Switch& tells, int count, std::span<std::byte> to,
                           Diagnostics& problems) {
    if (!room_ || room_->size() < to.size()) {
        Result<gpu::Buffer> room = gpu::Buffer::create(to.size(), GL_STREAM_READ);
        append(problems, std::move(room.diagnostics));
        if (!room) return false;
        room_ = std::move(*room);
    }
    setOwnUniform(built, tells.uniform, tells.value);
    room_->bindBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
    // WebGL writes into no buffer that is bound for something else, too.
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArraysInstanced(GL_POINTS, 0, 1, count);
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    setOwnUniform(built, tells.uniform, 0);
    room_->read(0, to);
    return true;
}

}  // namespace glibra::render
