#pragma once
// Whether a graphics card may draw, found without the cost of opening a context, and how many processes
// should draw with it.

#include <cstddef>
#include <filesystem>

#include "gpu/context/context.h"

namespace glibra::gpu {

/// False if openContext(driver) will draw on the processor. It looks at LIBGL_ALWAYS_SOFTWARE and for
/// graphics cards (system/places.h: in the folder `devices` if that is not empty), and loads no library. True
/// is not a guarantee: a device may lack a driver.
bool mayUseHardware(Driver driver, const std::filesystem::path& devices = {});

/// The number of processes that draw `pieces` scenes soonest, if each opens a context of its own. Where the
/// processor draws, that is one per processor. Contexts of a graphics card are made one after the other, and
/// making one takes as long as four scenes (NVIDIA H100, driver 580: 92 ms and 23 ms), so few pieces are
/// drawn by one process, and many by at most four.
int usualWorkers(Driver driver, std::size_t pieces, int processors,
                 const std::filesystem::path& devices = {});

}  // namespace glibra::gpu
