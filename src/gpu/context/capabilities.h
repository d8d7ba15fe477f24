#pragma once
// What the driver can do, as numbers that are read once when a context is opened. Reading them needs no GL
// call.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::gpu {

struct Capabilities {
    std::string vendor, renderer, version, shadingLanguage;  ///< the driver's own words
    /// One word for the family of drivers, for choosing tolerances and work-arounds: "llvmpipe", "softpipe",
    /// "osmesa-llvmpipe", "osmesa-softpipe", "nvidia", "amd", "intel", "apple", "zink", "d3d12", "other".
    std::string family;
    bool isSoftware = false;   ///< Mesa draws on the processor: llvmpipe or softpipe, through EGL or OSMesa
    int major = 0, minor = 0;  ///< of GL
    int glslVersion = 0;       ///< the number for #version, 410..460

    int max1DTextureSide = 0;  ///< GL has one limit for 1D and 2D
    int max2DTextureSide = 0;
    int max3DTextureSide = 0;
    int maxCubeSide = 0;
    int maxRectangleSide = 0;
    int maxArrayLayers = 256;
    int maxBufferTexels = 65536;  ///< of a buffer that is read as a texture
    int maxRenderbufferSide = 0;
    int maxViewportWidth = 0, maxViewportHeight = 0;
    int maxSamples = 1;  ///< of colour and depth renderbuffers
    int maxIntegerSamples = 1;
    int maxDrawBuffers = 8;
    int maxColorAttachments = 8;

    int vertexTextureUnits = 0, tessControlTextureUnits = 0, tessEvaluationTextureUnits = 0;
    int geometryTextureUnits = 0, fragmentTextureUnits = 0;
    int combinedTextureUnits = 0;  ///< all stages together
    int imageUnits = 0;            ///< 0 below GL 4.2
    int maxAnisotropy = 1;         ///< 1: not supported

    int maxVertexAttributes = 16;
    int maxGeometryOutputVertices = 256;
    int maxGeometryTotalOutputComponents = 1024;
    int maxTessellationLevel = 64;
    int maxPatchVertices = 32;
    int maxControlInputComponents = 0, maxControlOutputComponents = 0;  ///< per vertex, control stage
    int maxControlPatchComponents = 0;        ///< per-patch outputs of the control stage
    int maxControlTotalOutputComponents = 0;  ///< of all vertices and the patch
    int maxEvaluationInputComponents = 0, maxEvaluationOutputComponents = 0;
    int maxClipDistances = 8;
    int maxVertexUniformComponents = 0, maxFragmentUniformComponents = 0;
    int maxUniformBlockBytes = 16384;
    int maxUniformBufferBindings = 0;
    int maxStorageBufferBindings = 0;  ///< 0 below GL 4.3
    std::int64_t maxStorageBlockBytes = 0;
    int maxAtomicCounterBindings = 0;  ///< 0 below GL 4.2

    bool compute = false;                   ///< compute stages, storage buffers, indirect dispatches: GL 4.3
    std::array<int, 3> maxComputeGroups{};  ///< per dispatch
    std::array<int, 3> maxComputeLocalSize{};  ///< invocations per group, by axis
    int maxComputeInvocations = 0;             ///< per group, all axes together
    int maxComputeSharedBytes = 0;

    double minLineWidth = 1, maxLineWidth = 1;  ///< pixels, not antialiased
    bool wideLines = false;                     ///< false: a width above 1 is an error in this context
    double minPointSize = 1, maxPointSize = 1;  ///< pixels

    bool packInvert = false;       ///< GL_MESA_pack_invert: rows can be read top first
    bool parallelCompile = false;  ///< GL_KHR_parallel_shader_compile
    bool debugOutput = false;      ///< KHR_debug or GL 4.3
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

}  // namespace glibra::gpu
