#pragma once
// What may change the bits of a picture: the driver, its version and, for software drivers, the processor.

#include <string>
#include <string_view>
#include <vector>

#include "gpu/capabilities.h"

namespace glibra::suite {

/// One line: GL_RENDERER, GL_VERSION and, where the processor draws, its maker, those of its features that
/// compilers of shaders use, and the environment variables that choose between them.
std::string driverKey(const gpu::Capabilities& driver);

/// The words of golden variants that fit a family of drivers, the nearest first: "osmesa-llvmpipe" takes
/// "osmesa-llvmpipe", then "llvmpipe". The golden for everybody comes after them.
std::vector<std::string> variantsFor(std::string_view family);

/// Processor model and system, for people: "Intel(R) Xeon(R), Linux 6.1 x86_64".
std::string describeMachine();

}  // namespace glibra::suite
