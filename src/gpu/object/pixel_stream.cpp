#include "gpu/object/pixel_stream.h"

#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include "gpu/context/errors.h"
#include "gpu/context/reset.h"

namespace glibra::gpu {
namespace {

/// RGB bytes are read as RGBA, the drivers' own format (see readPixels).
PixelLayout layoutInBuffer(const PixelLayout& layout) {
    return layout.components == 3 && layout.type == TexelType::u8 ? PixelLayout{4, TexelType::u8} : layout;
}

}  // namespace

PixelStream::~PixelStream() {
    for (const Slot& each : slots_)
        if (each.done != nullptr) glDeleteSync(each.done);
}

/// False if there is no memory.
bool PixelStream::makeBuffer(Slot& slot, std::size_t bytes) const {
    Name<glDeleteBuffers> buffer(glGenBuffers);
    slot = {};
    slot.buffer = std::move(buffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, slot.buffer.get());
    const auto size = static_cast<GLsizeiptr>(bytes);
    if (capabilities_.persistentMaps) {
        constexpr GLbitfield kMap = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
        glBufferStorage(GL_PIXEL_PACK_BUFFER, size, nullptr, kMap | GL_CLIENT_STORAGE_BIT);
        if (takeError() != GL_NO_ERROR) return false;
        const NothingFinished notYet;
        slot.mapped = static_cast<const std::byte*>(glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, size, kMap));
        if (takeError() != GL_NO_ERROR || slot.mapped == nullptr) return false;
    } else {
        glBufferData(GL_PIXEL_PACK_BUFFER, size, nullptr, GL_STREAM_READ);
        if (takeError() != GL_NO_ERROR) return false;
    }
    slot.bytes = bytes;
    return true;
}

Diagnostics PixelStream::begin(const Framebuffer& framebuffer, int index, const PixelRectangle& rectangle,
                               const PixelLayout& layout) {
    const PixelLayout stored = layoutInBuffer(layout);
    const std::size_t bytes = byteCount(rectangle, stored);
    if (underWay() == kMost || bytes == 0 || index < 0 || index >= framebuffer.colorCount())
        return {diagnose("gpu-E03", "colour " + std::to_string(index) + " cannot be read now")};
    if (const GLenum before = takeError(); before != GL_NO_ERROR && !capabilities_.debugOutput)
        return {allocationError(before, "what was drawn")};
    Slot& slot = slots_.at(begun_ % kMost);
    if (slot.bytes != bytes && !makeBuffer(slot, bytes)) {
        slot = {};
        glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        return {diagnose("draw-E05", "out of memory while reading the picture back")};
    }
    framebuffer.bindForReading();
    glReadBuffer(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + index));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, slot.buffer.get());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    {
        const NothingFinished notYet;
        glReadPixels(rectangle.x, rectangle.y, rectangle.width, rectangle.height, glFormat(stored.components),
                     glType(stored.type), nullptr);
    }
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    if (const GLenum code = takeError(); code != GL_NO_ERROR)
        return {allocationError(code, "reading the picture back")};
    slot.done = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush();  // or else nothing is drawn while the processor does other work
    slot.rectangle = rectangle;
    slot.layout = layout;
    ++begun_;
    return {};
}

Diagnostics PixelStream::take(std::span<std::byte> pixels) {
    if (underWay() == 0) return {diagnose("gpu-E03", "no picture is being read")};
    Slot& slot = slots_.at(taken_++ % kMost);
    glClientWaitSync(slot.done, GL_SYNC_FLUSH_COMMANDS_BIT, std::numeric_limits<GLuint64>::max());
    glDeleteSync(slot.done);
    slot.done = nullptr;
    if (pixels.size() != byteCount(slot.rectangle, slot.layout))
        return {diagnose("gpu-E03", "a picture of another size is being read")};
    const std::byte* from = slot.mapped;
    if (slot.mapped == nullptr) {
        const NothingFinished notYet;
        glBindBuffer(GL_PIXEL_PACK_BUFFER, slot.buffer.get());
        from = static_cast<const std::byte*>(
            glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, static_cast<GLsizeiptr>(slot.bytes), GL_MAP_READ_BIT));
    }
    if (from == nullptr) {
        glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        return {allocationError(takeError(), "reading the picture back")};
    }
    // The lowest row comes first.
    const auto rows = static_cast<std::size_t>(slot.rectangle.height);
    const std::size_t rowBytes = pixels.size() / rows, storedBytes = slot.bytes / rows;
    for (std::size_t row = 0; row < rows; ++row) {
        const std::byte* stored = from + (rows - 1 - row) * storedBytes;
        std::byte* to = pixels.data() + row * rowBytes;
        if (rowBytes == storedBytes)
            std::memcpy(to, stored, rowBytes);
        else
            dropFourth({stored, storedBytes}, to);
    }
    if (slot.mapped == nullptr) {
        glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
        glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    }
    return {};
}

}  // namespace glibra::gpu
