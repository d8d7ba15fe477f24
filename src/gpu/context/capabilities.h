#pragma once
// What the driver can do, as numbers that are read once when a context is opened. Reading them needs no GL
// call. limits.def is the table of the limits.

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::gpu {

struct Capabilities {
    std::string vendor, renderer, version, shadingLanguage;  ///< the driver's own words
    /// One word for the family of drivers, for choosing tolerances and work-arounds: "llvmpipe", "softpipe",
    /// "osmesa-llvmpipe", "osmesa-softpipe", "nvidia", "amd", "intel", "apple", "zink", "d3d12", "other".
    std::string family;
    bool isSoftware = false;  ///< Mesa draws on the processor: llvmpipe or softpipe, through EGL or OSMesa
    /// Mesa's software rasterizer draws, also below zink: it tessellates with the limits of drawPatches().
    bool tessellatesInSoftware = false;
    bool isEs = false;         ///< OpenGL ES 3.0, which does what OpenGL 4.1 does as far as it can
    int major = 0, minor = 0;  ///< of GL; 4.1 for ES
    int glslVersion = 0;       ///< the number for #version, 410..460

#define GLIBRA_LIMIT(type, member, initial, ...) type member = initial;
#define GLIBRA_COMPUTE_LIMIT GLIBRA_LIMIT
#define GLIBRA_AXIS_LIMIT(member, ...) std::array<int, 3> member{};
#include "gpu/context/limits.def"
    bool compute = false;  ///< compute stages, storage buffers, indirect dispatches: GL 4.3

    double minLineWidth = 1, maxLineWidth = 1;  ///< pixels, not antialiased
    bool wideLines = false;                     ///< false: a width above 1 is an error in this context
    [[nodiscard]] double widestLine() const { return wideLines ? maxLineWidth : 1; }  ///< that can be set
    double minPointSize = 1, maxPointSize = 1;                                        ///< pixels

    bool packInvert = false;       ///< GL_MESA_pack_invert: rows can be read top first
    bool parallelCompile = false;  ///< GL_KHR_parallel_shader_compile
    bool debugOutput = false;      ///< KHR_debug or GL 4.3
    bool clipControl = false;      ///< z may go from 0 to w: GL 4.5, or an extension
    bool defersClears = false;     ///< zink: see gpu/object/framebuffer.h
    bool persistentMaps = false;   ///< buffers can stay mapped while the device uses them: GL 4.4
    int timerBits = 0;             ///< of GL_TIMESTAMP queries; 0: the driver has no timer

    std::vector<std::string> extensions;  ///< sorted
    [[nodiscard]] bool hasExtension(std::string_view name) const;
    [[nodiscard]] bool atLeast(int wantedMajor, int wantedMinor) const {
        return major > wantedMajor || (major == wantedMajor && minor >= wantedMinor);
    }
};

/// Queries the current context for everything above. `throughOsmesa` affects the family's name only.
Capabilities readCapabilities(bool throughOsmesa);

// One word for drivers that draw alike.

/// "llvmpipe", "softpipe", "zink", "d3d12", "nvidia", "apple", "intel", "amd" or "other", from what a driver
/// says of itself: its vendor and renderer, in any order and with other words.
std::string familyOf(std::string_view words);

}  // namespace glibra::gpu
