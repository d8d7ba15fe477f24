#pragma once
// The loss of a graphics device, for the rooms that know no GL.

#include <glibra/diagnostic.h>

#include <exception>
#include <string>

namespace glibra::base {

/// Whose work has made the driver reset the device, as the driver says.
enum class ResetCause { own, other, unknown };

/// Thrown where the driver has reset the device. What was drawn since the last answer of the device is lost,
/// and so is all that this process goes on to draw with the same context.
class DeviceLost : public std::exception {
  public:
    ResetCause cause = ResetCause::unknown;
    /// The first statement of the scene whose work was not finished. Without a file none is known.
    Place place{};
    int lastLine = 0;  ///< of the last one

    [[nodiscard]] const char* what() const noexcept override {
        return "the graphics driver has reset the device";
    }
};

/// " while line 7 was drawn", or nothing if no statement is known.
std::string whileDrawn(const DeviceLost& lost);

/// What the author of a scene is told: gpu-E06 if the scene has caused the reset, gpu-E07 if not. `scene` is
/// the place if no statement is known.
Diagnostic diagnosticOf(const DeviceLost& lost, const std::string& scene);

}  // namespace glibra::base
