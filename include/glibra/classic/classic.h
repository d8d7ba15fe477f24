#pragma once
// The classes of the appendices of "Graphics Shaders", on a core profile: docs/classic.md.

#include <glibra/classic/glsl_program.h>
#include <glibra/classic/matrix4.h>
#include <glibra/classic/vec3.h>
#include <glibra/classic/vertex_array.h>
