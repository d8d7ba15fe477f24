#pragma once
// Reads pixels from the device into memory, top row first.

#include <glibra/result.h>

#include <cstddef>
#include <span>
#include <vector>

#include "gpu/context/capabilities.h"
#include "gpu/format/texels.h"
#include "gpu/object/framebuffer.h"

namespace glibra::gpu {

/// A rectangle of a framebuffer in window coordinates: (0, 0) is the lower left pixel.
struct PixelRectangle {
    int x = 0, y = 0, width = 0, height = 0;
};

using PixelLayout = TexelLayout;

/// Copies the first three of the four bytes of every pixel.
void dropFourth(std::span<const std::byte> rgba, std::byte* to);

/// Reverses the order of the rows.
void flipRows(std::span<std::byte> pixels, std::size_t rowBytes);

/// The bytes of such a rectangle with tightly packed rows.
std::size_t byteCount(const PixelRectangle& rectangle, const PixelLayout& layout);

/// glReadPixels from the framebuffer that is bound for reading. OpenGL ES gives few layouts, from which the
/// pixels are converted.
void readBound(const PixelRectangle& rectangle, GLenum format, GLenum type, std::byte* pixels);

/// Reads colour `index` of the framebuffer into `pixels`, which must have byteCount bytes. Rows are tightly
/// packed, from top to bottom; parts outside the framebuffer are undefined. Waits for pending draws. GL
/// rounds normalised formats to nearest (u8: 1/255); float formats read as u8 or u16 are first limited to
/// 0..1. Reports gpu-E03 if the sizes do not fit, draw-E05 or gpu-E02 for errors of the driver.
Diagnostics readPixels(const Capabilities& capabilities, const Framebuffer& framebuffer, int index,
                       const PixelRectangle& rectangle, const PixelLayout& layout,
                       std::span<std::byte> pixels);

/// The same, into newly allocated memory.
Result<std::vector<std::byte>> readPixels(const Capabilities& capabilities, const Framebuffer& framebuffer,
                                          int index, const PixelRectangle& rectangle,
                                          const PixelLayout& layout);

}  // namespace glibra::gpu
