#pragma once
// What can change the bits of a picture: the driver, its version and, for software drivers, the processor.

#include <string>
#include <string_view>
#include <vector>

#include "gpu/context/capabilities.h"

namespace glibra::suite {

/// Returns one line: GL_RENDERER, GL_VERSION and, if the processor draws, its vendor, the features that
/// shader compilers use, and the environment variables that choose between them.
std::string driverKey(const gpu::Capabilities& driver);

/// The words of golden variants that apply to a family of drivers, the nearest first: "osmesa-llvmpipe" gives
/// "osmesa-llvmpipe" and "llvmpipe". The golden for all drivers comes after them.
std::vector<std::string> variantsFor(std::string_view family);

/// Processor model and system, for reports: "Intel(R) Xeon(R), Linux 6.1 x86_64".
std::string describeMachine();

}  // namespace glibra::suite
