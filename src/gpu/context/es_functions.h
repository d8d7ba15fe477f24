#pragma once
// OpenGL ES 3.0, which browsers have as WebGL 2, in place of OpenGL 4.1: what the rooms above call and ES
// lacks is expressed in what it has. Geometry, tessellation and compute stages, and textures that ES does not
// know, have no counterpart; the translation of shaders (glsl/es) reports them.

#include <functional>

namespace glibra::gpu {

/// True if the process's table of GL functions is that of OpenGL ES.
bool isEs();
/// True if OpenGL ES has normalized texels of 16 bits (EXT_texture_norm16).
bool hasWideTexels();

/// Fills the table from a context of OpenGL ES that is current; `address` returns a function of GL or null.
/// False if functions of ES 3.0 are missing.
bool loadEsFunctions(const std::function<void*(const char*)>& address);
/// The next functions that are loaded are again those of OpenGL.
void leaveEs();

}  // namespace glibra::gpu
