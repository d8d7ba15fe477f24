// The copies of DeviceTextures, and the parts and samplers that shaders read them by.

#include <fmt/format.h>
#include <glibra/diagnostic.h>

#include <algorithm>
#include <map>
#include <utility>

#include "plan/texture_binding.h"
#include "render/load/device_textures.h"
#include "scene/texture_parts.h"

namespace glibra::render {

Diagnostics DeviceTextures::makeCopies(scene::TextureIndex index, std::shared_ptr<gpu::Texture> first) {
    const scene::Texture& texture = scene_.textures[index];
    const gpu::Capabilities& driver = context_.capabilities();
    const gpu::TextureLayout layout{first->shape(), first->format(), first->size(), first->levels(),
                                    first->samples()};
    Copies copies;
    Diagnostics problems;
    copies.copies[0].texture = std::move(first);
    if (texture.hasHistory) {
        Result<gpu::Texture> second = gpu::Texture::create(driver, layout);
        append(problems, std::move(second.diagnostics));
        if (second) {
            copies.copies[1].texture = std::make_shared<gpu::Texture>(std::move(*second));
            append(problems, gpu::copyTexture(driver, *copies.copies[0].texture, *copies.copies[1].texture));
        }
    }
    const bool isResolvable =
        gpu::isMultisampled(layout.shape) && !hasDepth(layout.format) && !isInteger(layout.format);
    for (Copies::Copy& each : copies.copies) {
        if (!each.texture || !isResolvable) continue;
        gpu::TextureLayout single{
            gpu::isArray(layout.shape) ? gpu::TextureShape::array2D : gpu::TextureShape::texture2D,
            layout.format, layout.size};
        if (texture.hasMipmaps) single.levels = gpu::mostLevels(single.shape, single.size);
        Result<gpu::Texture> resolved = gpu::Texture::create(driver, single);
        append(problems, std::move(resolved.diagnostics));
        if (resolved) each.resolved = std::make_shared<gpu::Texture>(std::move(*resolved));
    }
    for (Diagnostic& each : problems) each.place = texture.place;
    Made& made = made_[index];
    made.texture = copies.copies[0].texture;
    made.copies = std::move(copies);
    return problems;
}

const gpu::Texture* DeviceTextures::texture(const scene::TextureView& view) const {
    const Copies* copies = copiesOf(view.texture);
    return copies == nullptr ? texture(view.texture) : copies->of(view).texture.get();
}

const gpu::Texture* DeviceTextures::completed(const scene::TextureView& view) {
    plan::TextureUse use;
    use.view = {.texture = view.texture, .isPrevious = view.isPrevious};
    complete(use);
    return readable(use);
}

void DeviceTextures::takeOver(DeviceTextures& previous, scene::TextureIndex texture) {
    Copies* from = previous.copiesOf(texture);
    if (from == nullptr || copiesOf(texture) == nullptr) return;
    Made& made = made_.at(texture);
    made.copies = std::move(*from);
    previous.made_.at(texture).copies.reset();
    made.texture = made.copies->now().texture;
}

void DeviceTextures::exchange(scene::TextureIndex texture) {
    Copies* both = copiesOf(texture);
    if (both == nullptr || !both->copies[1].texture) return;
    both->current = 1 - both->current;
    made_.at(texture).texture = both->now().texture;
}

Diagnostics DeviceTextures::copyFromPrevious(scene::TextureIndex texture, gpu::BindingTracker& bindings) {
    Copies* both = copiesOf(texture);
    if (both == nullptr || !both->copies[1].texture) return {};
    both->now().isResolved = both->before().isResolved;
    both->now().hasMipmaps = both->before().hasMipmaps;
    const gpu::Texture& from = *both->before().texture;
    stats_.add("histories copied", 1);
    stats_.add("bytes copied", gpu::bytesOf(from));
    Diagnostics diagnostics;
    if (copier_.copy(context_.capabilities(), from, *both->now().texture, diagnostics)) bindings.forget();
    return diagnostics;
}

void DeviceTextures::clear(scene::TextureIndex texture) {
    Copies* both = copiesOf(texture);
    if (both == nullptr) return;
    Copies::Copy& copy = both->now();
    copy.texture->clear(context_.capabilities());
    copy.isResolved = !copy.resolved;
    copy.hasMipmaps = !copy.resolved || !scene_.textures[texture].hasMipmaps;
}

void DeviceTextures::wasWritten(scene::TextureIndex texture) {
    Copies* both = copiesOf(texture);
    if (both == nullptr) return;
    Copies::Copy& copy = both->now();
    if (copy.resolved) copy.isResolved = false;
    if (scene_.textures[texture].hasMipmaps) copy.hasMipmaps = false;
}

bool DeviceTextures::isIncomplete(const plan::TextureUse& use) const {
    const Copies* both = copiesOf(use.view.texture);
    if (both == nullptr || use.readsSamples) return false;
    const Copies::Copy& copy = both->of(use.view);
    return !copy.isResolved || (use.readsMipmaps && !copy.hasMipmaps);
}

void DeviceTextures::complete(const plan::TextureUse& use) {
    if (!isIncomplete(use)) return;
    Copies& both = *copiesOf(use.view.texture);
    Copies::Copy& copy = use.view.isPrevious ? both.before() : both.now();
    if (!copy.isResolved) gpu::resolveSamples(*copy.texture, *copy.resolved);
    copy.isResolved = true;
    if (!use.readsMipmaps || copy.hasMipmaps) return;
    copy.hasMipmaps = true;
    (copy.resolved ? *copy.resolved : *copy.texture).generateMipmaps();
    stats_.add("mipmaps made", 1);
}

const gpu::Sampler& DeviceTextures::sampler(const base::SamplerState& state, bool compares) {
    for (const MadeSampler& each : samplers_)
        if (each.compares == compares && each.state == state) return each.sampler;
    base::SamplerState possible = state;
    possible.anisotropy = std::min<double>(state.anisotropy, context_.capabilities().maxAnisotropy);
    const auto compare = compares ? std::optional(state.compare) : std::nullopt;
    return samplers_.emplace_back(MadeSampler{state, compares, gpu::Sampler(possible, compare)}).sampler;
}

const gpu::Texture* DeviceTextures::readable(const plan::TextureUse& use) {
    const gpu::Texture* whole = texture(use.view);
    if (const Copies* copies = copiesOf(use.view.texture); copies != nullptr && !use.readsSamples)
        if (const auto& resolved = copies->of(use.view).resolved) whole = resolved.get();
    const bool isPart = use.view.level || use.view.layer;
    if (!isPart || use.isImage || whole == nullptr) return whole;
    if (!context_.capabilities().atLeast(4, 3)) {
        if (use.view.level) whole->showLevels(*use.view.level, 1);
        return whole;
    }
    if (use.view.layer && whole->shape() == gpu::TextureShape::texture3D) return layerCopy(*whole, use.view);
    const std::tuple key{whole, use.view.level.value_or(-1), use.view.layer.value_or(-1)};
    if (const auto known = views_.find(key); known != views_.end()) return &known->second;
    Result<gpu::Texture> part = whole->view(use.view.level, use.view.layer);
    if (!part) return whole;
    return &views_.emplace(key, std::move(*part)).first->second;
}

/// GL shows no layer of a 3D texture as a 2D texture, so each reader gets a copy of its texels.
const gpu::Texture* DeviceTextures::layerCopy(const gpu::Texture& whole, const scene::TextureView& view) {
    const int level = view.level.value_or(0);
    const std::tuple key{&whole, level, *view.layer};
    auto known = views_.find(key);
    if (known == views_.end()) {
        const gpu::TextureSize size = gpu::sizeOfLevel(whole.shape(), whole.size(), level);
        Result<gpu::Texture> made = gpu::Texture::create(
            context_.capabilities(),
            {gpu::TextureShape::texture2D, whole.format(), {size.width, size.height, 1}});
        if (!made) return &emptyTexture(scene::TextureTarget::texture2D);
        known = views_.emplace(key, std::move(*made)).first;
    }
    known->second.copyLayer(whole, level, *view.layer);
    return &known->second;
}

void DeviceTextures::bind(const plan::TextureUse& use, gpu::BindingTracker& bindings) {
    const gpu::Texture* bound = use.view.texture ? readable(use) : nullptr;
    if (!bound || use.view.level || use.view.layer) bindings.forgetWorkUnit();  // it may have been made here
    if (!bound) bound = &emptyTexture(use.target);
    if (use.isImage)
        return bindings.bindImage(*bound, use.driverUnit, use.view.level.value_or(0), use.view.layer,
                                  GL_READ_WRITE, use.imageFormat);
    if (!use.view.level && !context_.capabilities().atLeast(4, 3) && bound->levels() > 1) {
        bound->showLevels(0, bound->levels());
        bindings.forgetWorkUnit();
    }
    bindings.bind(*bound, use.driverUnit);
    bindings.bind(sampler(use.sampler, use.compares), use.driverUnit);
}

Diagnostics DeviceTextures::checkParts(const plan::FramePlan& plan) const {
    Diagnostics problems;
    if (context_.capabilities().atLeast(4, 3)) return problems;
    plan.visitDraws([&](const plan::PlannedDraw& planned, const scene::Draw& draw, const auto&) {
        std::map<scene::TextureIndex, std::optional<int>> levels;
        for (const plan::TextureUse& use : planned.textures) {
            if (use.isImage || !use.view.texture) continue;
            const auto [known, isNew] = levels.try_emplace(use.view.texture, use.view.level);
            if (!use.view.layer && known->second == use.view.level) continue;
            problems.push_back(
                diagnose("draw-E10",
                         fmt::format("{} cannot be sampled {}: that needs OpenGL 4.3, this driver has {}.{}",
                                     plan::nameOf(scene_, use.view),
                                     use.view.layer ? "alone" : "together with another level",
                                     context_.capabilities().major, context_.capabilities().minor),
                         draw.place));
        }
    });
    return problems;
}

}  // namespace glibra::render
