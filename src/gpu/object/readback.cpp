#include "gpu/object/readback.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "gpu/context/driver_reports.h"
#include "gpu/context/errors.h"
#include "gpu/context/es_functions.h"

namespace glibra::gpu {
namespace {

/// Copies the first three of the four bytes of every pixel.
void dropFourth(std::span<const std::byte> rgba, std::byte* to) {
    const std::byte* from = rgba.data();
    const std::byte* const end = from + rgba.size();
    if constexpr (std::endian::native == std::endian::little)
        for (; from + 16 <= end; from += 16, to += 12) {
            std::uint64_t a = 0, b = 0;  // two pixels each
            std::memcpy(&a, from, sizeof a);
            std::memcpy(&b, from + sizeof a, sizeof b);
            const std::uint64_t first = (a & 0xffffffU) | (a >> 8U & 0xffffff000000U) | b << 48U;
            const auto last = static_cast<std::uint32_t>((b >> 16U & 0xffU) | (b >> 24U & 0xffffff00U));
            std::memcpy(to, &first, sizeof first);
            std::memcpy(to + sizeof first, &last, sizeof last);
        }
    for (; from < end; from += 4, to += 3) std::memcpy(to, from, 3);
}

/// Reads RGB bytes as RGBA, the drivers' own format, and packs them here. Mesa converts to three components
/// pixel by pixel, which takes five times as long. Reads parts of bounded size, from the top.
void readRgb(const PixelRectangle& rectangle, bool topFirst, std::span<std::byte> pixels) {
    constexpr std::size_t kMostBytes = std::size_t{16} << 20;
    const auto width = static_cast<std::size_t>(rectangle.width);
    const int most = static_cast<int>(std::clamp<std::size_t>(kMostBytes / (4 * width), 1, 1U << 20U));
    const int rowsAtOnce = std::min(most, rectangle.height);
    const auto part =
        std::make_unique_for_overwrite<std::byte[]>(4 * width * static_cast<std::size_t>(rowsAtOnce));
    std::byte* to = pixels.data();
    for (int done = 0; done < rectangle.height; done += rowsAtOnce) {
        const int rows = std::min(rowsAtOnce, rectangle.height - done);
        const int y = rectangle.y + (topFirst ? rectangle.height - done - rows : done);
        readBound({rectangle.x, y, rectangle.width, rows}, GL_RGBA, GL_UNSIGNED_BYTE, part.get());
        const std::size_t count = width * static_cast<std::size_t>(rows);
        dropFourth({part.get(), 4 * count}, to);
        to += 3 * count;
    }
}

/// The layout in which OpenGL ES gives pixels of the framebuffer that is read, and whether they are
/// normalized.
std::pair<Transfer, bool> readable() {
    GLint buffer = GL_COLOR_ATTACHMENT0, kind = GL_NONE;
    glGetIntegerv(GL_READ_BUFFER, &buffer);
    const GLenum point = buffer == GL_BACK ? GL_BACK : static_cast<GLenum>(buffer);
    glGetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, point,
                                          GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &kind);
    if (kind == GL_FLOAT) return {{GL_RGBA, GL_FLOAT}, false};
    if (kind == GL_INT) return {{GL_RGBA_INTEGER, GL_INT}, false};
    if (kind == GL_UNSIGNED_INT) return {{GL_RGBA_INTEGER, GL_UNSIGNED_INT}, false};
    return {{GL_RGBA, GL_UNSIGNED_BYTE}, true};
}

int componentsIn(GLenum format) {
    switch (format) {
        case GL_RED:
        case GL_RED_INTEGER:
        case GL_DEPTH_COMPONENT:
            return 1;
        case GL_RG:
        case GL_RG_INTEGER:
            return 2;
        case GL_RGB:
        case GL_RGB_INTEGER:
            return 3;
        default:
            return 4;
    }
}

}  // namespace

void readBound(const PixelRectangle& rectangle, GLenum format, GLenum type, std::byte* pixels) {
    const auto& [x, y, width, height] = rectangle;
    const auto [transfer, isNormalized] =
        isEs() ? readable() : std::pair<Transfer, bool>{{format, type}, false};
    const bool isDepth = format == GL_DEPTH_COMPONENT || format == GL_DEPTH_STENCIL;
    if (isDepth || (transfer.format == format && transfer.type == type))
        return glReadPixels(x, y, width, height, format, type, pixels);
    const TexelLayout from{4, typeOf(transfer.type)}, to{componentsIn(format), typeOf(type)};
    std::vector<std::byte> read(byteCount(rectangle, {4, from.type}));
    glReadPixels(x, y, width, height, transfer.format, transfer.type, read.data());
    std::ranges::copy(converted(read, from, to, isNormalized || to.type == TexelType::u8), pixels);
}

void flipRows(std::span<std::byte> pixels, std::size_t rowBytes) {
    if (rowBytes == 0) return;
    std::vector<std::byte> kept(rowBytes);
    const std::size_t rows = pixels.size() / rowBytes;
    for (std::size_t low = 0, high = rows; low + 1 < high; ++low) {
        --high;
        std::byte* lower = pixels.data() + low * rowBytes;
        std::byte* upper = pixels.data() + high * rowBytes;
        std::memcpy(kept.data(), lower, rowBytes);
        std::memcpy(lower, upper, rowBytes);
        std::memcpy(upper, kept.data(), rowBytes);
    }
}

std::size_t byteCount(const PixelRectangle& rectangle, const PixelLayout& layout) {
    if (rectangle.width <= 0 || rectangle.height <= 0) return 0;
    return static_cast<std::size_t>(rectangle.width) * static_cast<std::size_t>(rectangle.height) *
           layout.bytes();
}

Diagnostics readPixels(const Capabilities& capabilities, const Framebuffer& framebuffer, int index,
                       const PixelRectangle& rectangle, const PixelLayout& layout,
                       std::span<std::byte> pixels) {
    const std::size_t needed = byteCount(rectangle, layout);
    if (layout.components < 1 || layout.components > 4 || needed == 0 || needed != pixels.size())
        return {diagnose("gpu-E03", "reading " + std::to_string(rectangle.width) + " x " +
                                        std::to_string(rectangle.height) + " pixels takes " +
                                        std::to_string(needed) + " bytes, not " +
                                        std::to_string(pixels.size()))};
    if (index < 0 || index >= framebuffer.colorCount())
        return {diagnose("gpu-E03", "the framebuffer has no colour " + std::to_string(index))};

    // Without debug output nobody else has seen what a draw before has reported.
    if (const GLenum before = takeError(); before != GL_NO_ERROR && !capabilities.debugOutput)
        return {allocationError(before, "what was drawn")};
    framebuffer.bindForReading();
    settleClears(capabilities);
    glReadBuffer(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + index));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    if (capabilities.packInvert) glPixelStorei(GL_PACK_INVERT_MESA, GL_TRUE);
    if (layout.components == 3 && layout.type == TexelType::u8)
        readRgb(rectangle, capabilities.packInvert, pixels);
    else
        readBound(rectangle, glFormat(layout.components), glType(layout.type), pixels.data());
    if (capabilities.packInvert) glPixelStorei(GL_PACK_INVERT_MESA, GL_FALSE);
    if (const GLenum code = takeError(); code != GL_NO_ERROR)
        return {allocationError(code, "reading the picture back")};
    if (!capabilities.packInvert) flipRows(pixels, needed / static_cast<std::size_t>(rectangle.height));
    return {};
}

Result<std::vector<std::byte>> readPixels(const Capabilities& capabilities, const Framebuffer& framebuffer,
                                          int index, const PixelRectangle& rectangle,
                                          const PixelLayout& layout) {
    std::vector<std::byte> pixels(byteCount(rectangle, layout));
    Diagnostics problems = readPixels(capabilities, framebuffer, index, rectangle, layout, pixels);
    if (!problems.empty()) return problems;
    return pixels;
}

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
