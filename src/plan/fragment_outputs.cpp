#include "plan/fragment_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "plan/inputs.h"
#include "plan/texture_binding.h"
#include "scene/texture_parts.h"

namespace glibra::plan {
namespace {

/// What the texels of a colour target are for a shader. The window's are floating-point numbers.
BaseType texelKindOf(const scene::Scene& scene, const scene::Pass& pass, std::size_t target) {
    if (target >= pass.targets.size()) return BaseType::floating;
    return texelsOf(scene.textures[pass.targets[target]]);
}

std::string_view texelWords(BaseType kind) {
    if (kind == BaseType::integer) return "signed integers";
    return kind == BaseType::unsignedInteger ? "unsigned integers" : "floating-point numbers";
}

/// The GLSL type of that kind with as many components: "uvec3".
std::string glslTypeOf(BaseType kind, int components) {
    if (components > 1) return fmt::format("{}vec{}", prefixOf(kind), components);
    return kind == BaseType::integer ? "int" : kind == BaseType::unsignedInteger ? "uint" : "float";
}

bool isWritten(const scene::Draw& draw, std::size_t target) {
    const base::ColorMask& mask = draw.raster.write.at(target);
    return !draw.raster.discard && (mask.red || mask.green || mask.blue || mask.alpha);
}

}  // namespace

Diagnostics outputProblems(const scene::Scene& scene, const scene::Draw& draw, const scene::Pass& pass,
                           const ProgramInterface& interface) {
    Diagnostics problems;
    if (!scene.isModern) return problems;
    const std::size_t count = pass.isWindow ? 1 : pass.targets.size();
    for (const base::ActiveOutput& output : interface.outputs) {
        for (int i = 0; i < output.arraySize; ++i) {
            const int location = output.location + i;
            if (location < 0 || static_cast<std::size_t>(location) >= count) continue;
            const auto target = static_cast<std::size_t>(location);
            const BaseType kind = texelKindOf(scene, pass, target);
            if (kind == output.type.base || !isWritten(draw, target)) continue;
            problems.push_back(diagnose(
                "draw-E11",
                fmt::format("fragment output '{}' is of type {}, but {} holds {}; declare the output as {}",
                            userNameOf(interface, output.name), output.type.word,
                            describeTarget(scene, pass, target), texelWords(kind),
                            glslTypeOf(kind, output.type.components())),
                draw.place));
            break;
        }
    }
    return problems;
}

std::bitset<base::kRasterTargets> targetsWithoutOutput(const scene::Scene& scene, const scene::Draw& draw,
                                                       const scene::Pass& pass,
                                                       const ProgramInterface& interface) {
    std::bitset<base::kRasterTargets> missing;
    if (!scene.isModern || interface.isBuiltin) return missing;
    const std::size_t count = pass.isWindow ? 1 : std::min(pass.targets.size(), base::kRasterTargets);
    for (std::size_t target = 0; target < count; ++target) missing[target] = isWritten(draw, target);
    for (const base::ActiveOutput& output : interface.outputs)
        for (int i = 0; i < std::max(output.arraySize, 1); ++i)
            if (const int location = output.location + i;
                location >= 0 && location < static_cast<int>(base::kRasterTargets))
                missing.reset(static_cast<std::size_t>(location));
    return missing;
}

std::optional<LayeredTarget> layeredTarget(const scene::Scene& scene, const scene::Pass& pass) {
    if (pass.isWindow) return std::nullopt;
    scene::TextureIndex texture{};
    scene::TargetPart part;
    if (!pass.targets.empty()) {
        texture = pass.targets.front();
        if (!pass.parts.empty()) part = pass.parts.front();
    } else if (pass.depth) {
        texture = pass.depth->texture;
        part = {pass.depth->level, pass.depth->layer};
    }
    if (!texture || part.layer) return std::nullopt;
    const scene::Texture& target = scene.textures[texture];
    const int count = layersOf(target, part.level.value_or(0)).value_or(1);
    if (count < 2) return std::nullopt;
    return LayeredTarget{target.name, count, target.target == scene::TextureTarget::cube};
}

std::string describeTarget(const scene::Scene& scene, const scene::Pass& pass, std::size_t target) {
    if (pass.isWindow) return "the window";
    const scene::Texture& texture = scene.textures[pass.targets[target]];
    return texture.name.empty() ? fmt::format("the target of line {}", pass.place.line)
                                : fmt::format("target '{}' (line {})", texture.name, texture.place.line);
}

}  // namespace glibra::plan
