#pragma once
// Whether a graphics card may draw, found without the cost of opening a context.

#include <filesystem>

#include "gpu/context/context.h"

namespace glibra::gpu {

/// False if openContext(driver) will draw on the processor. It looks at LIBGL_ALWAYS_SOFTWARE and for the
/// device files that drivers of graphics cards open, in the folder `devices`, and loads no library. True is
/// not a guarantee: a device may lack a driver.
bool mayUseHardware(Driver driver, const std::filesystem::path& devices = "/dev");

}  // namespace glibra::gpu
