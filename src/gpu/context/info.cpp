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
    const auto count = [&](std::string key, std::string label, std::int64_t value) {
        if (!label.empty()) entries.push_back({std::move(key), std::move(label), value});
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

#define GLIBRA_LIMIT(type, member, initial, since, name, words) count(#member, words, driver.member);
#define GLIBRA_COMPUTE_LIMIT(...)
#define GLIBRA_AXIS_LIMIT(...)
#include "gpu/context/limits.def"
    truth("compute", "compute stages", driver.compute);
#define GLIBRA_LIMIT(...)
#define GLIBRA_COMPUTE_LIMIT(type, member, initial, since, name, words) \
    if (driver.compute) count(#member, words, driver.member);
#define GLIBRA_AXIS_LIMIT(member, since, name, words)                                    \
    for (std::size_t axis = 0; driver.compute && axis < 3; ++axis)                       \
        count(std::string(#member) + "XYZ"[axis], std::string(words ", ") + "xyz"[axis], \
              driver.member.at(axis));
#include "gpu/context/limits.def"
    truth("wideLines", "lines wider than 1 pixel", driver.wideLines);
    number("maxLineWidth", "widest line, pixels", driver.maxLineWidth);
    number("maxPointSize", "largest point, pixels", driver.maxPointSize);
    truth("debugOutput", "reports errors by callback", driver.debugOutput);
    truth("parallelCompile", "compiles in its own threads", driver.parallelCompile);
    count("extensions", "extensions", static_cast<std::int64_t>(driver.extensions.size()));
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
