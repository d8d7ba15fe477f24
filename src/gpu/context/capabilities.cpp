#include "gpu/context/capabilities.h"

#include <glad/gl.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "base/text.h"
#include "gpu/context/errors.h"
#include "gpu/context/es_functions.h"

namespace glibra::gpu {

std::string familyOf(std::string_view words) {
    // Layered drivers name the device below them too, so they come first; so do renderers in software, whose
    // processor may be named.
    using Row = std::pair<std::string_view, const char*>;
    constexpr std::array kFamilies{
        Row{"zink", "zink"},         Row{"d3d12", "d3d12"},   Row{"llvmpipe", "llvmpipe"},
        Row{"softpipe", "softpipe"}, Row{"nvidia", "nvidia"}, Row{"apple", "apple"},
        Row{"intel", "intel"},       Row{"amd", "amd"},       Row{"ati ", "amd"},
        Row{"radeon", "amd"},
    };
    const std::string all = base::lower(words);
    const auto* const found = std::ranges::find_if(
        kFamilies, [&](const Row& row) { return all.find(row.first) != std::string::npos; });
    return found == kFamilies.end() ? "other" : found->second;
}

namespace {

int integerOf(GLenum what) {
    std::array<GLint, 2> values{};  // GL_MAX_VIEWPORT_DIMS has two
    glGetIntegerv(what, values.data());
    return values[0];
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

void readExtensions(Capabilities& driver) {
    const int count = integerOf(GL_NUM_EXTENSIONS);
    driver.extensions.reserve(static_cast<std::size_t>(std::max(count, 0)));
    for (GLuint i = 0; i < static_cast<GLuint>(std::max(count, 0)); ++i)
        if (const auto* name = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, i)))
            driver.extensions.emplace_back(name);
    std::sort(driver.extensions.begin(), driver.extensions.end());
}

void read(GLenum what, int& value) {
    const int given = integerOf(what);
    if (given != 0 || !isEs()) value = given;  // ES does not know all of them
}

void read(GLenum what, std::int64_t& value) {
    glGetInteger64v(what, &value);
}

void read(GLenum what, std::array<int, 3>& byAxis) {
    for (GLuint axis = 0; axis < 3; ++axis) glGetIntegeri_v(what, axis, &byAxis.at(axis));
}

void readLimits(Capabilities& driver) {
#define GLIBRA_LIMIT(type, member, initial, since, name, words) \
    if (driver.atLeast((since) / 10, (since) % 10)) read(name, driver.member);
#define GLIBRA_COMPUTE_LIMIT GLIBRA_LIMIT
#define GLIBRA_AXIS_LIMIT(member, since, name, words) GLIBRA_LIMIT(, member, , since, name, words)
#include "gpu/context/limits.def"
    std::array<GLint, 2> viewport{};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    driver.maxViewportWidth = viewport[0];
    driver.maxViewportHeight = viewport[1];
    if (driver.hasExtension("GL_ARB_texture_filter_anisotropic") ||
        driver.hasExtension("GL_EXT_texture_filter_anisotropic"))
        read(GL_MAX_TEXTURE_MAX_ANISOTROPY, driver.maxAnisotropy);
    for (int* least1 : {&driver.maxSamples, &driver.maxIntegerSamples, &driver.maxAnisotropy})
        *least1 = std::max(1, *least1);
    driver.compute = driver.atLeast(4, 3);
}

constexpr GLenum kAliasedPointSizeRange = 0x846D;  // of ES alone

void readRaster(Capabilities& driver) {
    std::array<GLfloat, 2> range{1, 1};
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range.data());
    driver.minLineWidth = static_cast<double>(range[0]);
    driver.maxLineWidth = static_cast<double>(range[1]);
    const bool forwardCompatible =
        !driver.isEs && (integerOf(GL_CONTEXT_FLAGS) & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT) != 0;
    driver.wideLines = !forwardCompatible && driver.maxLineWidth > 1;
    glGetFloatv(driver.isEs ? kAliasedPointSizeRange : GL_POINT_SIZE_RANGE, range.data());
    driver.minPointSize = static_cast<double>(range[0]);
    driver.maxPointSize = static_cast<double>(range[1]);
}

}  // namespace

bool Capabilities::hasExtension(std::string_view name) const {
    return std::ranges::binary_search(extensions, name);
}

Capabilities readCapabilities(bool throughOsmesa) {
    Capabilities driver;
    driver.vendor = text(GL_VENDOR);
    driver.renderer = text(GL_RENDERER);
    driver.version = text(GL_VERSION);
    driver.shadingLanguage = text(GL_SHADING_LANGUAGE_VERSION);
    driver.isEs = isEs();
    driver.major = driver.isEs ? 4 : integerOf(GL_MAJOR_VERSION);
    driver.minor = driver.isEs ? 1 : integerOf(GL_MINOR_VERSION);
    // Mesa with a lowered version of OpenGL still reports its own version of GLSL.
    driver.glslVersion = std::min(glslNumber(driver.shadingLanguage), 100 * driver.major + 10 * driver.minor);
    driver.family = familyOf(driver.vendor + " " + driver.renderer);
    if (throughOsmesa && driver.family.ends_with("pipe")) driver.family.insert(0, "osmesa-");
    driver.isSoftware = driver.family.ends_with("llvmpipe") || driver.family.ends_with("softpipe");
    driver.tessellatesInSoftware = driver.isSoftware || driver.renderer.find("llvmpipe") != std::string::npos;
    driver.defersClears = driver.family == "zink";
    readExtensions(driver);
    readLimits(driver);
    readRaster(driver);
    driver.packInvert = driver.hasExtension("GL_MESA_pack_invert");
    driver.parallelCompile = driver.hasExtension("GL_KHR_parallel_shader_compile");
    driver.debugOutput = driver.atLeast(4, 3) || (!driver.isEs && driver.hasExtension("GL_KHR_debug"));
    driver.clipControl = glad_glClipControl != nullptr &&
                         (driver.atLeast(4, 5) || driver.hasExtension("GL_ARB_clip_control") ||
                          driver.hasExtension("GL_EXT_clip_control"));
    driver.persistentMaps = driver.atLeast(4, 4);
    if (!driver.isEs) glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &driver.timerBits);
    clearErrors();
    return driver;
}

}  // namespace glibra::gpu
