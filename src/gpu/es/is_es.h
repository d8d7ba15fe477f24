#pragma once
// Whether the process's table of GL functions is that of OpenGL ES 3.0, and what its textures can be.

namespace glibra::gpu {

/// False until loadEsFunctions() (functions.h) has filled the table.
bool isEs();
/// True if OpenGL ES has normalized texels of 16 bits (EXT_texture_norm16).
bool hasWideTexels();

// Of functions.cpp alone.
void setEs(bool is, bool hasWide);

}  // namespace glibra::gpu
