#pragma once
// OpenGL ES 3.0, which browsers have as WebGL 2, in place of OpenGL 4.1: what the rooms above call and ES
// lacks is expressed in what it has. Geometry, tessellation and compute stages, and textures that ES does not
// know, have no counterpart; the translation of shaders (glsl/es) reports them.

#include <glad/gl.h>

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "gpu/format/pixel_format.h"

namespace glibra::gpu {

/// True if the process's table of GL functions is that of OpenGL ES.
bool isEs();

/// Fills the table from a context of OpenGL ES that is current; `address` returns a function of GL or null.
/// False if functions of ES 3.0 are missing.
bool loadEsFunctions(const std::function<void*(const char*)>& address);
/// The next functions that are loaded are again those of OpenGL.
void leaveEs();

/// How texels lie in memory.
struct TexelLayout {
    int components = 4;
    TexelType type = TexelType::u8;
    friend bool operator==(const TexelLayout&, const TexelLayout&) = default;
};

/// Texels in another layout. Missing components become 0, alpha 1. `isNormalized`: whole numbers stand for
/// 0..1 or -1..1, and are rounded to nearest; otherwise numbers stay themselves.
std::vector<std::byte> converted(std::span<const std::byte> texels, TexelLayout from, TexelLayout to,
                                 bool isNormalized);

/// GL's number of a format where ES has another one, or GL_NONE: without EXT_texture_norm16, normalized
/// formats of 16 bits are 32-bit floats.
GLenum esInternalFormat(TexelFormat format);
/// The layout in which ES takes texels of that format, if it is another one than OpenGL's; else GL_NONE.
Transfer esTransfer(TexelFormat format);
/// The texels in the layout of esTransfer().
std::vector<std::byte> forEs(std::span<const std::byte> texels, TexelLayout layout, TexelFormat format);

}  // namespace glibra::gpu
