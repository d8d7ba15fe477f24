#include "gpu/context/info.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

namespace glibra::gpu {
namespace {

std::string toText(const InfoEntry& entry) {
    if (const auto* text = std::get_if<std::string>(&entry.value)) return *text;
    if (const auto* number = std::get_if<std::int64_t>(&entry.value)) return std::to_string(*number);
    if (const auto* truth = std::get_if<bool>(&entry.value)) return *truth ? "yes" : "no";
    std::array<char, 32> buffer{};
    (void)std::snprintf(buffer.data(), buffer.size(), "%g", std::get<double>(entry.value));
    return buffer.data();
}

}  // namespace

std::vector<InfoEntry> describe(const Context& context) {
    const Capabilities& driver = context.capabilities();
    std::vector<InfoEntry> entries;
    const auto words = [&](const char* key, const char* label, std::string value) {
        entries.push_back({key, label, std::move(value)});
    };
    const auto count = [&](const char* key, const char* label, int value) {
        entries.push_back({key, label, static_cast<std::int64_t>(value)});
    };
    const auto number = [&](const char* key, const char* label, double value) {
        entries.push_back({key, label, value});
    };
    const auto truth = [&](const char* key, const char* label, bool value) {
        entries.push_back({key, label, value});
    };

    words("driver", "driver option", std::string(word(context.driver())));
    words("context", "opened as", context.howOpened());
    std::string failed;
    for (const std::string& each : context.failedWays()) failed += (failed.empty() ? "" : "; ") + each;
    if (!failed.empty()) words("failed", "tried before", failed);
    words("vendor", "vendor", driver.vendor);
    words("renderer", "renderer", driver.renderer);
    words("family", "family", driver.family);
    words("version", "OpenGL", driver.version);
    words("shadingLanguage", "GLSL", driver.shadingLanguage);
    count("glslVersion", "shaders compiled as #version", driver.glslVersion);

    count("max2DTextureSide", "largest 1D and 2D texture side", driver.max2DTextureSide);
    count("max3DTextureSide", "largest 3D texture side", driver.max3DTextureSide);
    count("maxCubeSide", "largest cube map side", driver.maxCubeSide);
    count("maxRenderbufferSide", "largest target side", driver.maxRenderbufferSide);
    count("maxViewportWidth", "largest viewport width", driver.maxViewportWidth);
    count("maxViewportHeight", "largest viewport height", driver.maxViewportHeight);
    count("maxSamples", "samples per pixel", driver.maxSamples);
    count("maxDrawBuffers", "colour targets at once", driver.maxDrawBuffers);
    count("vertexTextureUnits", "texture units, vertex stage", driver.vertexTextureUnits);
    count("tessControlTextureUnits", "texture units, tessellation control stage",
          driver.tessControlTextureUnits);
    count("tessEvaluationTextureUnits", "texture units, tessellation evaluation stage",
          driver.tessEvaluationTextureUnits);
    count("geometryTextureUnits", "texture units, geometry stage", driver.geometryTextureUnits);
    count("fragmentTextureUnits", "texture units, fragment stage", driver.fragmentTextureUnits);
    count("combinedTextureUnits", "texture units, all stages", driver.combinedTextureUnits);
    count("imageUnits", "image units", driver.imageUnits);
    count("maxAnisotropy", "anisotropy", driver.maxAnisotropy);
    count("maxVertexAttributes", "vertex inputs", driver.maxVertexAttributes);
    count("maxGeometryOutputVertices", "geometry stage, vertices out", driver.maxGeometryOutputVertices);
    count("maxGeometryTotalOutputComponents", "geometry stage, components out",
          driver.maxGeometryTotalOutputComponents);
    count("maxTessellationLevel", "tessellation level", driver.maxTessellationLevel);
    count("maxPatchVertices", "vertices per patch", driver.maxPatchVertices);
    count("maxControlInputComponents", "control stage, components in per vertex",
          driver.maxControlInputComponents);
    count("maxControlOutputComponents", "control stage, components out per vertex",
          driver.maxControlOutputComponents);
    count("maxControlPatchComponents", "control stage, components out per patch",
          driver.maxControlPatchComponents);
    count("maxControlTotalOutputComponents", "control stage, components out in all",
          driver.maxControlTotalOutputComponents);
    count("maxEvaluationInputComponents", "evaluation stage, components in per vertex",
          driver.maxEvaluationInputComponents);
    count("maxEvaluationOutputComponents", "evaluation stage, components out per vertex",
          driver.maxEvaluationOutputComponents);
    count("maxClipDistances", "clip distances", driver.maxClipDistances);
    count("maxVertexUniformComponents", "uniform components, vertex stage",
          driver.maxVertexUniformComponents);
    count("maxFragmentUniformComponents", "uniform components, fragment stage",
          driver.maxFragmentUniformComponents);
    count("maxUniformBlockBytes", "bytes of a uniform block", driver.maxUniformBlockBytes);
    truth("compute", "compute stages", driver.compute);
    if (driver.compute) {
        constexpr std::array<const char*, 3> kAxes{"X", "Y", "Z"};
        constexpr std::array<const char*, 3> kGroups{
            "work groups per dispatch, x", "work groups per dispatch, y", "work groups per dispatch, z"};
        constexpr std::array<const char*, 3> kSizes{"invocations per work group, x",
                                                    "invocations per work group, y",
                                                    "invocations per work group, z"};
        for (std::size_t axis = 0; axis < kAxes.size(); ++axis)
            entries.push_back({std::string("maxComputeGroups") + kAxes[axis], kGroups[axis],
                               static_cast<std::int64_t>(driver.maxComputeGroups.at(axis))});
        for (std::size_t axis = 0; axis < kAxes.size(); ++axis)
            entries.push_back({std::string("maxComputeLocalSize") + kAxes[axis], kSizes[axis],
                               static_cast<std::int64_t>(driver.maxComputeLocalSize.at(axis))});
        count("maxComputeInvocations", "invocations per work group, all axes", driver.maxComputeInvocations);
        count("maxComputeSharedBytes", "bytes of shared variables", driver.maxComputeSharedBytes);
        count("maxStorageBufferBindings", "storage buffers at once", driver.maxStorageBufferBindings);
        entries.push_back({"maxStorageBlockBytes", "bytes of a storage block", driver.maxStorageBlockBytes});
        count("maxAtomicCounterBindings", "atomic counter buffers at once", driver.maxAtomicCounterBindings);
    }
    truth("wideLines", "lines wider than 1 pixel", driver.wideLines);
    number("maxLineWidth", "widest line, pixels", driver.maxLineWidth);
    number("maxPointSize", "largest point, pixels", driver.maxPointSize);
    truth("debugOutput", "reports errors by callback", driver.debugOutput);
    truth("parallelCompile", "compiles in its own threads", driver.parallelCompile);
    count("extensions", "extensions", static_cast<int>(driver.extensions.size()));
    return entries;
}

std::string toText(const std::vector<InfoEntry>& entries) {
    std::size_t widest = 0;
    for (const InfoEntry& each : entries) widest = std::max(widest, each.label.size());
    std::string text;
    for (const InfoEntry& each : entries)
        text += each.label + ":" + std::string(widest - each.label.size() + 1, ' ') + toText(each) + "\n";
    return text;
}

}  // namespace glibra::gpu
