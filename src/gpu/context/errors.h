#pragma once
// GL errors as values, for calls that a user's scene can make fail, and the places of the scene that they
// belong to.

#include <glad/gl.h>
#include <glibra/diagnostic.h>

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

// The statements of a scene that the device works for.

class WorkPlaces {
  public:
    /// What is asked of the device from now on is for this place.
    void set(const Place& place);
    [[nodiscard]] const Place& current() const { return current_; }

    /// The places since the device was known to be idle.
    struct Unfinished {
        Place first;       ///< without a file: none
        int lastLine = 0;  ///< the last one in the same file
    };
    [[nodiscard]] Unfinished unfinished() const { return isFinished_ ? Unfinished{} : unfinished_; }
    /// The device has done all that it was given.
    void finish() { isFinished_ = true; }

  private:
    Place current_;
    Unfinished unfinished_;
    bool isFinished_ = true;  ///< the next place is the first unfinished one
};

}  // namespace glibra::gpu
