#include "gpu/readback.h"

#include <cstring>
#include <string>

#include "gpu/errors.h"

namespace glibra::gpu {
namespace {

/// Exchanges rows, first with last and so on.
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

}  // namespace

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
        return {error("gpu-E03", "reading " + std::to_string(rectangle.width) + " x " +
                                     std::to_string(rectangle.height) + " pixels takes " +
                                     std::to_string(needed) + " bytes, not " +
                                     std::to_string(pixels.size()))};
    if (index < 0 || index >= framebuffer.colorCount())
        return {error("gpu-E03", "there is no colour " + std::to_string(index) + " to read")};

    clearErrors();
    framebuffer.bindForReading();
    glReadBuffer(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + index));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    if (capabilities.packInvert) glPixelStorei(GL_PACK_INVERT_MESA, GL_TRUE);
    glReadPixels(rectangle.x, rectangle.y, rectangle.width, rectangle.height, glFormat(layout.components),
                 glType(layout.type), pixels.data());
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

}  // namespace glibra::gpu
