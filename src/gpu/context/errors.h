#pragma once
// GL errors as values, for calls that a user's scene can make fail.

#include <glad/gl.h>
#include <glibra/diagnostic.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace glibra::gpu {

/// "GL_OUT_OF_MEMORY" and so on; an unknown code as a number.
std::string errorName(GLenum code);

/// Discards the pending errors of earlier calls.
void clearErrors();

/// The first error since clearErrors, or GL_NO_ERROR.
GLenum takeError();

/// draw-E05 for lack of memory, gpu-E02 for every other error. `what` is a noun phrase: "a 16384 x 16384
/// texture".
Diagnostic allocationError(GLenum code, std::string_view what);

}  // namespace glibra::gpu
