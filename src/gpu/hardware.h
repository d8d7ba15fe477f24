#pragma once
// Whether a graphics card may draw: asked where a context would be too dear for the answer.

#include <filesystem>

#include "gpu/context.h"

namespace glibra::gpu {

/// False if openContext(driver) will draw on the processor. It looks for the device files that drivers of
/// graphics cards open (`devices` is their folder) and at LIBGL_ALWAYS_SOFTWARE, and loads no library. True
/// is no promise: a device may have no driver.
bool mayUseHardware(Driver driver, const std::filesystem::path& devices = "/dev");

}  // namespace glibra::gpu
