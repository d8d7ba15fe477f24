#include "gpu/context/capabilities.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "base/text.h"

namespace glibra::gpu {
namespace {

constexpr GLenum kMaxAnisotropy = GL_MAX_TEXTURE_MAX_ANISOTROPY;

int integerOf(GLenum what) {
    GLint value = 0;
    glGetIntegerv(what, &value);
    return value;
}

std::string text(GLenum what) {
    const auto* value = reinterpret_cast<const char*>(glGetString(what));
    return value ? value : "";
}

/// "4.50 NVIDIA ..." -> 450.
int glslNumber(std::string_view words) {
    int major = 0;
    int minor = 0;
    const char* end = words.data() + words.size();
    const auto [dot, failed] = std::from_chars(words.data(), end, major);
    if (failed != std::errc{} || dot == end || *dot != '.') return 410;
    std::from_chars(dot + 1, end, minor);
    return major * 100 + (minor < 10 ? minor * 10 : minor);
}

std::string familyOf(const Capabilities& driver, bool throughOsmesa) {
    const std::string renderer = base::lower(driver.renderer);
    const std::string vendor = base::lower(driver.vendor);
    const auto in = [](const std::string& words, std::string_view word) {
        return words.find(word) != std::string::npos;
    };
    const std::string prefix = throughOsmesa ? "osmesa-" : "";
    // Layered drivers name the device below them too, so they come first.
    if (in(renderer, "zink")) return "zink";
    if (in(renderer, "d3d12")) return "d3d12";
    if (in(renderer, "llvmpipe")) return prefix + "llvmpipe";
    if (in(renderer, "softpipe")) return prefix + "softpipe";
    if (in(vendor, "nvidia") || in(renderer, "nvidia")) return "nvidia";
    if (in(vendor, "apple")) return "apple";
    if (in(vendor, "intel") || in(renderer, "intel")) return "intel";
    if (in(vendor, "amd") || in(vendor, "ati ") || in(renderer, "amd") || in(renderer, "radeon"))
        return "amd";
    return "other";
}

void readExtensions(Capabilities& driver) {
    const int count = integerOf(GL_NUM_EXTENSIONS);
    driver.extensions.reserve(static_cast<std::size_t>(std::max(count, 0)));
    for (GLuint i = 0; i < static_cast<GLuint>(std::max(count, 0)); ++i)
        if (const auto* name = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, i)))
            driver.extensions.emplace_back(name);
    std::sort(driver.extensions.begin(), driver.extensions.end());
}

void readSizes(Capabilities& driver) {
    driver.max2DTextureSide = integerOf(GL_MAX_TEXTURE_SIZE);
    driver.max1DTextureSide = driver.max2DTextureSide;
    driver.max3DTextureSide = integerOf(GL_MAX_3D_TEXTURE_SIZE);
    driver.maxArrayLayers = integerOf(GL_MAX_ARRAY_TEXTURE_LAYERS);
    driver.maxBufferTexels = integerOf(GL_MAX_TEXTURE_BUFFER_SIZE);
    driver.maxCubeSide = integerOf(GL_MAX_CUBE_MAP_TEXTURE_SIZE);
    driver.maxRectangleSide = integerOf(GL_MAX_RECTANGLE_TEXTURE_SIZE);
    driver.maxRenderbufferSide = integerOf(GL_MAX_RENDERBUFFER_SIZE);
    std::array<GLint, 2> viewport{};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    driver.maxViewportWidth = viewport[0];
    driver.maxViewportHeight = viewport[1];
    driver.maxSamples = std::max(1, integerOf(GL_MAX_SAMPLES));
    driver.maxIntegerSamples = std::max(1, integerOf(GL_MAX_INTEGER_SAMPLES));
    driver.maxDrawBuffers = integerOf(GL_MAX_DRAW_BUFFERS);
    driver.maxColorAttachments = integerOf(GL_MAX_COLOR_ATTACHMENTS);
}

void readUnits(Capabilities& driver) {
    driver.vertexTextureUnits = integerOf(GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS);
    driver.tessControlTextureUnits = integerOf(GL_MAX_TESS_CONTROL_TEXTURE_IMAGE_UNITS);
    driver.tessEvaluationTextureUnits = integerOf(GL_MAX_TESS_EVALUATION_TEXTURE_IMAGE_UNITS);
    driver.geometryTextureUnits = integerOf(GL_MAX_GEOMETRY_TEXTURE_IMAGE_UNITS);
    driver.fragmentTextureUnits = integerOf(GL_MAX_TEXTURE_IMAGE_UNITS);
    driver.combinedTextureUnits = integerOf(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
    if (driver.atLeast(4, 2)) driver.imageUnits = integerOf(GL_MAX_IMAGE_UNITS);
    if (driver.atLeast(4, 6) || driver.hasExtension("GL_ARB_texture_filter_anisotropic") ||
        driver.hasExtension("GL_EXT_texture_filter_anisotropic"))
        driver.maxAnisotropy = std::max(1, integerOf(kMaxAnisotropy));
}

void readStages(Capabilities& driver) {
    driver.maxVertexAttributes = integerOf(GL_MAX_VERTEX_ATTRIBS);
    driver.maxGeometryOutputVertices = integerOf(GL_MAX_GEOMETRY_OUTPUT_VERTICES);
    driver.maxGeometryTotalOutputComponents = integerOf(GL_MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS);
    driver.maxTessellationLevel = integerOf(GL_MAX_TESS_GEN_LEVEL);
    driver.maxPatchVertices = integerOf(GL_MAX_PATCH_VERTICES);
    driver.maxControlInputComponents = integerOf(GL_MAX_TESS_CONTROL_INPUT_COMPONENTS);
    driver.maxControlOutputComponents = integerOf(GL_MAX_TESS_CONTROL_OUTPUT_COMPONENTS);
    driver.maxControlPatchComponents = integerOf(GL_MAX_TESS_PATCH_COMPONENTS);
    driver.maxControlTotalOutputComponents = integerOf(GL_MAX_TESS_CONTROL_TOTAL_OUTPUT_COMPONENTS);
    driver.maxEvaluationInputComponents = integerOf(GL_MAX_TESS_EVALUATION_INPUT_COMPONENTS);
    driver.maxEvaluationOutputComponents = integerOf(GL_MAX_TESS_EVALUATION_OUTPUT_COMPONENTS);
    driver.maxClipDistances = integerOf(GL_MAX_CLIP_DISTANCES);
    driver.maxVertexUniformComponents = integerOf(GL_MAX_VERTEX_UNIFORM_COMPONENTS);
    driver.maxFragmentUniformComponents = integerOf(GL_MAX_FRAGMENT_UNIFORM_COMPONENTS);
    driver.maxUniformBlockBytes = integerOf(GL_MAX_UNIFORM_BLOCK_SIZE);
    driver.maxUniformBufferBindings = integerOf(GL_MAX_UNIFORM_BUFFER_BINDINGS);
    if (driver.atLeast(4, 3))
        driver.maxStorageBufferBindings = integerOf(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS);
}

void readCompute(Capabilities& driver) {
    if (driver.atLeast(4, 2))
        driver.maxAtomicCounterBindings = integerOf(GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS);
    driver.compute = driver.atLeast(4, 3);
    if (!driver.compute) return;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &driver.maxStorageBlockBytes);
    for (GLuint axis = 0; axis < 3; ++axis) {
        glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, axis, &driver.maxComputeGroups.at(axis));
        glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_SIZE, axis, &driver.maxComputeLocalSize.at(axis));
    }
    driver.maxComputeInvocations = integerOf(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS);
    driver.maxComputeSharedBytes = integerOf(GL_MAX_COMPUTE_SHARED_MEMORY_SIZE);
}

void readRaster(Capabilities& driver) {
    std::array<GLfloat, 2> range{1, 1};
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range.data());
    driver.minLineWidth = static_cast<double>(range[0]);
    driver.maxLineWidth = static_cast<double>(range[1]);
    const bool forwardCompatible =
        (integerOf(GL_CONTEXT_FLAGS) & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT) != 0;
    driver.wideLines = !forwardCompatible && driver.maxLineWidth > 1;
    glGetFloatv(GL_POINT_SIZE_RANGE, range.data());
    driver.minPointSize = static_cast<double>(range[0]);
    driver.maxPointSize = static_cast<double>(range[1]);
}

}  // namespace

bool Capabilities::hasExtension(std::string_view name) const {
    return std::binary_search(extensions.begin(), extensions.end(), name);
}

Capabilities readCapabilities(bool throughOsmesa) {
    Capabilities driver;
    driver.vendor = text(GL_VENDOR);
    driver.renderer = text(GL_RENDERER);
    driver.version = text(GL_VERSION);
    driver.shadingLanguage = text(GL_SHADING_LANGUAGE_VERSION);
    driver.major = integerOf(GL_MAJOR_VERSION);
    driver.minor = integerOf(GL_MINOR_VERSION);
    // Mesa with a lowered version of OpenGL still reports its own version of GLSL.
    driver.glslVersion = std::min(glslNumber(driver.shadingLanguage), 100 * driver.major + 10 * driver.minor);
    driver.family = familyOf(driver, throughOsmesa);
    driver.isSoftware = driver.family.ends_with("llvmpipe") || driver.family.ends_with("softpipe");
    readExtensions(driver);
    readSizes(driver);
    readUnits(driver);
    readStages(driver);
    readCompute(driver);
    readRaster(driver);
    driver.packInvert = driver.hasExtension("GL_MESA_pack_invert");
    driver.parallelCompile = driver.hasExtension("GL_KHR_parallel_shader_compile");
    driver.debugOutput = driver.atLeast(4, 3) || driver.hasExtension("GL_KHR_debug");
    driver.persistentMaps = driver.atLeast(4, 4);
    glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &driver.timerBits);
    return driver;
}

}  // namespace glibra::gpu
