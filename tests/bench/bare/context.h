#pragma once
// How the programs in plain OpenGL open their context.

namespace bare {

/// Opens an EGL context without a surface, OpenGL 4.5 core, and makes it current. Without one, prints why and
/// ends the process with status 1.
void openContext();

}  // namespace bare
