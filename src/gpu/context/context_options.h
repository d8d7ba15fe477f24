#pragma once
// Which context is opened, and how.

#include <glibra/driver.h>

#include <string>
#include <vector>

namespace glibra::gpu {

using glibra::Driver;

struct ContextOptions {
    Driver driver = Driver::automatic;
    bool debugContext =
        false;  ///< requests the driver's own checks as well; errors are collected in any case
    /// Makes llvmpipe filter byte textures in float, as hardware does. This sets the environment variable
    /// GALLIVM_PERF unless the user has set it, and takes effect at the first context of a process.
    bool floatFiltering = true;
    std::string eglLibrary = "libEGL.so.1";
    std::vector<std::string> osmesaLibraries = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
};

}  // namespace glibra::gpu
