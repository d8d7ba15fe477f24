#include "gpu/context/info.h"

#include <fmt/format.h>

#include <algorithm>

namespace glibra::gpu {
namespace {

std::string toText(const InfoEntry& entry) {
    if (const auto* text = std::get_if<std::string>(&entry.value)) return *text;
    if (const auto* number = std::get_if<std::int64_t>(&entry.value)) return std::to_string(*number);
    if (const auto* truth = std::get_if<bool>(&entry.value)) return *truth ? "yes" : "no";
    return fmt::format("{:g}", std::get<double>(entry.value));
}

}  // namespace

std::vector<InfoEntry> describe(const Context& context) {
    const Capabilities& driver = context.capabilities();
    std::vector<InfoEntry> entries;
    const auto add = [&](std::string key, std::string label, auto value) {
        if (!label.empty()) entries.push_back({std::move(key), std::move(label), std::move(value)});
    };

    add("driver", "driver option", std::string(word(context.driver())));
    add("context", "opened as", context.howOpened());
    if (const auto& ways = context.failedWays(); !ways.empty())
        add("failed", "tried before", fmt::format("{}", fmt::join(ways, "; ")));
    add("vendor", "vendor", driver.vendor);
    add("renderer", "renderer", driver.renderer);
    add("family", "family", driver.family);
    add("version", "OpenGL", driver.version);
    add("shadingLanguage", "GLSL", driver.shadingLanguage);
    add("glslVersion", "shaders compiled as #version", driver.glslVersion);

#define GLIBRA_LIMIT(type, member, initial, since, name, words) add(#member, words, driver.member);
#define GLIBRA_COMPUTE_LIMIT(...)
#define GLIBRA_AXIS_LIMIT(...)
#include "gpu/context/limits.def"
    add("compute", "compute stages", driver.compute);
#define GLIBRA_LIMIT(...)
#define GLIBRA_COMPUTE_LIMIT(type, member, initial, since, name, words) \
    if (driver.compute) add(#member, words, driver.member);
#define GLIBRA_AXIS_LIMIT(member, since, name, words)                                  \
    for (std::size_t axis = 0; driver.compute && axis < 3; ++axis)                     \
        add(std::string(#member) + "XYZ"[axis], std::string(words ", ") + "xyz"[axis], \
            driver.member.at(axis));
#include "gpu/context/limits.def"
    add("wideLines", "lines wider than 1 pixel", driver.wideLines);
    add("maxLineWidth", "widest line, pixels", driver.maxLineWidth);
    add("maxPointSize", "largest point, pixels", driver.maxPointSize);
    add("debugOutput", "reports errors by callback", driver.debugOutput);
    add("parallelCompile", "compiles in its own threads", driver.parallelCompile);
    add("extensions", "extensions", static_cast<std::int64_t>(driver.extensions.size()));
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
