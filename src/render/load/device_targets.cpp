#include "render/load/device_targets.h"

#include <fmt/format.h>
#include <glibra/diagnostic.h>

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "plan/texture_binding.h"

namespace glibra::render {
namespace {

/// Reports what is wrong with a target of that part of a texture.
std::optional<Diagnostic> problemOf(const scene::Texture& texture, const std::string& name,
                                    const gpu::Texture& made, const scene::TargetPart& part,
                                    const Place& place) {
    const auto say = [&](const std::string& why) {
        return diagnose("draw-E10",
                        fmt::format("{} does not exist: {} (line {})", name, why, texture.place.line), place);
    };
    const auto has = [&](int count, const char* things) {
        return say(fmt::format("'{}' has {}", texture.name, base::counted(count, things)));
    };
    const int level = part.level.value_or(0);
    if (level >= made.levels()) return has(made.levels(), "level");
    if (part.layer.value_or(0) >= made.layers(level)) return has(made.layers(level), "layer");
    return std::nullopt;
}

/// True if nothing of the pass tests or changes depth or stencil.
bool isWithoutDepth(const scene::Pass& pass) {
    return !pass.depth && !pass.clearDepth && !pass.clearStencil &&
           std::ranges::all_of(pass.steps, [](const auto& step) {
               const auto* draw = std::get_if<scene::Draw>(&step);
               return draw != nullptr && draw->isFill && !draw->raster.depthTest && !draw->raster.stencilTest;
           });
}

}  // namespace

void DeviceTargets::forget(const std::set<const gpu::Texture*>& gone) {
    std::set<int> depths;
    std::erase_if(made_, [&](const Made& each) {
        const bool isGone =
            std::ranges::any_of(each.textures, [&](const gpu::Texture* part) { return gone.contains(part); });
        if (isGone) depths.insert(each.depthBuffer);
        return isGone;
    });
    std::erase_if(depthBuffers_, [&](const auto& each) { return depths.contains(std::get<0>(each.first)); });
}

Result<gpu::Target> DeviceTargets::make(const scene::Pass& pass) {
    const gpu::Texture* first = pass.targets.empty() ? nullptr : textures_.texture(pass.targets.front());
    const gpu::TextureSize size = first == nullptr ? gpu::TextureSize{} : first->size();
    if (!scene_.isModern) {
        gpu::SharedDepth& depth = depthBuffers_[{pass.depthBuffer, size.width, size.height}];
        std::vector<const gpu::Texture*> textures;
        for (const scene::TextureIndex each : pass.targets) textures.push_back(textures_.texture(each));
        Result<gpu::Target> made = gpu::Target::textures(context_.capabilities(), textures, 1, depth);
        if (made) depth = made->depth();
        return made;
    }
    Diagnostics problems;
    const auto partOf = [&](scene::TextureIndex index, const scene::TargetPart& part) {
        const gpu::Texture& made = *textures_.texture(index);
        const scene::TextureView view{.texture = index, .level = part.level, .layer = part.layer};
        if (auto problem =
                problemOf(scene_.textures[index], plan::nameOf(scene_, view), made, part, pass.place))
            problems.push_back(*std::move(problem));
        return gpu::TexturePart{&made, part.level.value_or(0), part.layer};
    };
    std::vector<gpu::TexturePart> colors;
    for (std::size_t i = 0; i < pass.targets.size(); ++i)
        colors.push_back(
            partOf(pass.targets[i], i < pass.parts.size() ? pass.parts[i] : scene::TargetPart{}));
    std::optional<gpu::TexturePart> depthPart;
    if (pass.depth) depthPart = partOf(pass.depth->texture, {pass.depth->level, pass.depth->layer});
    if (!problems.empty()) return problems;
    if (isWithoutDepth(pass))
        return gpu::Target::parts(context_.capabilities(), colors, std::nullopt, {}, std::nullopt);
    gpu::SharedDepth& depth = depthBuffers_[{pass.depthBuffer, size.width, size.height}];
    Result<gpu::Target> made =
        gpu::Target::parts(context_.capabilities(), colors, depthPart, depth, depthFormat(scene_));
    if (made && made->depth()) depth = made->depth();
    return made;
}

Result<const gpu::Target*> DeviceTargets::of(const scene::Pass& pass) {
    const bool needsDepth = !scene_.isModern || !isWithoutDepth(pass);
    // This runs in every frame, so it compares without making a key.
    const auto isSame = [&](const Made& known) {
        if (known.depthBuffer != pass.depthBuffer || known.targets != pass.targets ||
            known.parts != pass.parts || known.depth != pass.depth || (needsDepth && !known.hasDepth))
            return false;
        for (std::size_t i = 0; i < pass.targets.size(); ++i)
            if (known.textures[i] != textures_.texture(pass.targets[i])) return false;
        return !pass.depth || known.textures.back() == textures_.texture(pass.depth->texture);
    };
    for (const Made& known : made_)
        if (isSame(known)) return &known.target;
    Result<gpu::Target> made = make(pass);
    if (!made) {
        for (Diagnostic& each : made.diagnostics) each.place = pass.place;
        return std::move(made.diagnostics);
    }
    Made kept{pass.targets, pass.parts, pass.depth, pass.depthBuffer, needsDepth, {}, std::move(*made)};
    for (const scene::TextureIndex each : pass.targets) kept.textures.push_back(textures_.texture(each));
    if (pass.depth) kept.textures.push_back(textures_.texture(pass.depth->texture));
    return &made_.emplace_back(std::move(kept)).target;
}

}  // namespace glibra::render
