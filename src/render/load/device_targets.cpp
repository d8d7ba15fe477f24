// The copies, parts and samplers of DeviceScene's textures, and its targets.

#include <fmt/format.h>
#include <glibra/diagnostic.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <utility>

#include "image/texel_block.h"
#include "plan/texture_binding.h"
#include "render/load/device_scene.h"
#include "scene/texture_parts.h"

namespace glibra::render {
namespace {

bool isColor(gpu::TexelFormat format) {
    return !hasDepth(format) && !isInteger(format);
}

/// Reports what is wrong with a target of that part of a texture.
std::optional<Diagnostic> problemOf(const scene::Texture& texture, const std::string& name,
                                    const gpu::Texture& made, const scene::TargetPart& part,
                                    const Place& place) {
    const auto say = [&](const std::string& why) {
        return diagnose("draw-E10",
                        fmt::format("{} does not exist: {} (line {})", name, why, texture.place.line), place);
    };
    if (part.level.value_or(0) >= made.levels())
        return say(
            fmt::format("'{}' has {} level{}", texture.name, made.levels(), made.levels() == 1 ? "" : "s"));
    if (part.layer.value_or(0) >= made.layers(part.level.value_or(0)))
        return say(fmt::format("'{}' has {} layer{}", texture.name, made.layers(part.level.value_or(0)),
                               made.layers(part.level.value_or(0)) == 1 ? "" : "s"));
    return std::nullopt;
}

/// The components and type of a picture of texels of that format, and the type in which GL gives them.
struct PictureLayout {
    int components = 4;
    image::Component type = image::Component::f32;
    gpu::TexelType texels = gpu::TexelType::f32;
};
PictureLayout layoutOf(gpu::TexelFormat format) {
    const base::TexelFormatRow& row = base::rowOf(format);
    PictureLayout layout;
    // Pictures of two components would be grey and alpha.
    layout.components = hasDepth(format) ? 1 : row.components == 2 ? 3 : row.components;
    if (row.kind == base::TexelClass::normalized) {
        const bool isBytes = row.bits == 8;
        layout.type = isBytes ? image::Component::u8 : image::Component::u16;
        layout.texels = isBytes ? gpu::TexelType::u8 : gpu::TexelType::u16;
    }
    if (row.kind == base::TexelClass::integer) layout.texels = gpu::TexelType::i32;
    if (row.kind == base::TexelClass::unsignedInteger) layout.texels = gpu::TexelType::u32;
    return layout;
}

template <class Integer>
void toFloats(std::vector<std::byte>& numbers) {
    for (std::size_t i = 0; i < numbers.size(); i += sizeof(Integer)) {
        Integer number = 0;
        std::memcpy(&number, numbers.data() + i, sizeof number);
        const auto value = static_cast<float>(number);
        std::memcpy(numbers.data() + i, &value, sizeof value);
    }
}

}  // namespace

Result<image::Image> DeviceScene::imageOf(const scene::TextureView& view) {
    const std::string name = plan::nameOf(scene_, view);
    const auto bad = [&](const std::string& why) {
        return diagnose("draw-E10", fmt::format("{} cannot be saved: {}", name, why),
                        scene_.textures[view.texture].place);
    };
    const gpu::Texture* made = completed(view);
    if (made == nullptr) return bad("it has not been made");
    if (made->samples() > 1) return bad("its samples cannot be resolved");
    const int level = view.level.value_or(0);
    if (level >= made->levels()) return bad(fmt::format("it has {} levels", made->levels()));
    const int layers = made->layers(level);
    if (!view.layer && layers > 1)
        return bad(fmt::format("it has {} {}; name one, as {}{}(0)", layers,
                               gpu::isCube(made->shape()) ? "faces" : "layers",
                               scene_.textures[view.texture].name,
                               made->shape() == gpu::TextureShape::cubeArray ? ".layer(0).face"
                               : made->shape() == gpu::TextureShape::cube    ? ".face"
                                                                             : ".layer"));
    if (view.layer.value_or(0) >= layers) return bad(fmt::format("it has {} layers", layers));

    const PictureLayout layout = layoutOf(made->format());
    Result<std::vector<std::byte>> texels = made->read(level, layout.components, layout.texels);
    if (!texels) return std::move(texels.diagnostics);
    if (layout.texels == gpu::TexelType::i32) toFloats<std::int32_t>(*texels);
    if (layout.texels == gpu::TexelType::u32) toFloats<std::uint32_t>(*texels);
    const gpu::TextureSize size = gpu::sizeOfLevel(made->shape(), made->size(), level);
    image::TexelBlock block;
    block.width = size.width;
    block.height = size.height;
    block.components = layout.components;
    block.type = layout.type;
    const std::size_t bytes = texels->size() / static_cast<std::size_t>(layers);
    const auto first = texels->begin() +
                       static_cast<std::ptrdiff_t>(bytes * static_cast<std::size_t>(view.layer.value_or(0)));
    block.data.assign(first, first + static_cast<std::ptrdiff_t>(bytes));
    if (!gpu::isCube(made->shape())) image::flipRows(block);
    return image::Image{block.width, block.height, block.components, block.type, std::move(block.data)};
}

Diagnostics DeviceScene::makeCopies(scene::TextureIndex index, std::shared_ptr<gpu::Texture> first) {
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
    for (Copies::Copy& each : copies.copies) {
        if (!each.texture || !gpu::isMultisampled(layout.shape) || !isColor(layout.format)) continue;
        gpu::TextureLayout single{
            gpu::isArray(layout.shape) ? gpu::TextureShape::array2D : gpu::TextureShape::texture2D,
            layout.format, layout.size};
        if (texture.hasMipmaps) single.levels = gpu::mostLevels(single.shape, single.size);
        Result<gpu::Texture> resolved = gpu::Texture::create(driver, single);
        append(problems, std::move(resolved.diagnostics));
        if (resolved) each.resolved = std::make_shared<gpu::Texture>(std::move(*resolved));
    }
    for (Diagnostic& each : problems) each.place = texture.place;
    textures_.insert_or_assign(index, copies.copies[0].texture);
    copies_.insert_or_assign(index, std::move(copies));
    return problems;
}

const gpu::Texture* DeviceScene::texture(const scene::TextureView& view) const {
    const auto copies = copies_.find(view.texture);
    if (copies == copies_.end()) return texture(view.texture);
    const Copies& both = copies->second;
    return both.copies[view.isPrevious ? 1 - both.current : both.current].texture.get();
}

const gpu::Texture* DeviceScene::completed(const scene::TextureView& view) {
    plan::TextureUse use;
    use.view = {.texture = view.texture, .isPrevious = view.isPrevious};
    complete(use);
    return readable(use);
}

void DeviceScene::takeOver(DeviceScene& previous, const scene::ObjectView& object) {
    stored_.insert(plan::objectOf(object));
    if (const auto* buffer = std::get_if<scene::BufferView>(&object))
        return buffers_.takeOver(previous.buffers_, buffer->buffer);
    const scene::TextureIndex texture = std::get<scene::TextureView>(object).texture;
    const auto found = previous.copies_.find(texture);
    if (found == previous.copies_.end() || !copies_.contains(texture)) return;
    copies_.insert_or_assign(texture, std::move(found->second));
    previous.copies_.erase(found);
    textures_.insert_or_assign(texture, copies_.at(texture).copies[copies_.at(texture).current].texture);
}

void DeviceScene::exchange(scene::TextureIndex texture) {
    const auto found = copies_.find(texture);
    if (found == copies_.end() || !found->second.copies[1].texture) return;
    Copies& both = found->second;
    both.current = 1 - both.current;
    textures_.insert_or_assign(texture, both.copies[both.current].texture);
}

Diagnostics DeviceScene::copyFromPrevious(scene::TextureIndex texture, gpu::BindingTracker& bindings) {
    const auto found = copies_.find(texture);
    if (found == copies_.end() || !found->second.copies[1].texture) return {};
    Copies& both = found->second;
    both.copies[both.current].isResolved = both.copies[1 - both.current].isResolved;
    both.copies[both.current].hasMipmaps = both.copies[1 - both.current].hasMipmaps;
    const gpu::Texture& from = *both.copies[1 - both.current].texture;
    stats_.add("histories copied", 1);
    stats_.add("bytes copied", gpu::bytesOf(from));
    Diagnostics diagnostics;
    if (copier_.copy(context_.capabilities(), from, *both.copies[both.current].texture, diagnostics))
        bindings.forget();
    return diagnostics;
}

void DeviceScene::clear(scene::TextureIndex texture) {
    const auto found = copies_.find(texture);
    if (found == copies_.end()) return;
    Copies::Copy& copy = found->second.copies[found->second.current];
    copy.texture->clear(context_.capabilities());
    copy.isResolved = !copy.resolved;
    copy.hasMipmaps = !copy.resolved || !scene_.textures[texture].hasMipmaps;
}

void DeviceScene::wasWritten(scene::TextureIndex texture) {
    const auto found = copies_.find(texture);
    if (found == copies_.end()) return;
    Copies::Copy& copy = found->second.copies[found->second.current];
    if (copy.resolved) copy.isResolved = false;
    if (scene_.textures[texture].hasMipmaps) copy.hasMipmaps = false;
}

bool DeviceScene::isIncomplete(const plan::TextureUse& use) const {
    const auto found = copies_.find(use.view.texture);
    if (found == copies_.end() || use.readsSamples) return false;
    const Copies& both = found->second;
    const Copies::Copy& copy = both.copies[use.view.isPrevious ? 1 - both.current : both.current];
    return !copy.isResolved || (use.readsMipmaps && !copy.hasMipmaps);
}

void DeviceScene::complete(const plan::TextureUse& use) {
    if (!isIncomplete(use)) return;
    Copies& both = copies_.at(use.view.texture);
    Copies::Copy& copy = both.copies[use.view.isPrevious ? 1 - both.current : both.current];
    if (!copy.isResolved) gpu::resolveSamples(*copy.texture, *copy.resolved);
    copy.isResolved = true;
    if (!use.readsMipmaps || copy.hasMipmaps) return;
    copy.hasMipmaps = true;
    (copy.resolved ? *copy.resolved : *copy.texture).generateMipmaps();
    stats_.add("mipmaps made", 1);
}

const gpu::Sampler& DeviceScene::sampler(const base::SamplerState& state, bool compares) {
    for (const MadeSampler& each : samplers_)
        if (each.compares == compares && each.state == state) return each.sampler;
    base::SamplerState possible = state;
    possible.anisotropy = std::min<double>(state.anisotropy, context_.capabilities().maxAnisotropy);
    const auto compare = compares ? std::optional(state.compare) : std::nullopt;
    return samplers_.emplace_back(MadeSampler{state, compares, gpu::Sampler(possible, compare)}).sampler;
}

const gpu::Texture* DeviceScene::readable(const plan::TextureUse& use) {
    const gpu::Texture* whole = texture(use.view);
    if (const auto copies = copies_.find(use.view.texture); copies != copies_.end() && !use.readsSamples) {
        const Copies& both = copies->second;
        const auto& copy = both.copies[use.view.isPrevious ? 1 - both.current : both.current];
        if (copy.resolved) whole = copy.resolved.get();
    }
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
const gpu::Texture* DeviceScene::layerCopy(const gpu::Texture& whole, const scene::TextureView& view) {
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

void DeviceScene::bind(const plan::TextureUse& use, gpu::BindingTracker& bindings) {
    if (use.buffer.buffer) return bindBuffer(use, bindings);
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

Diagnostics DeviceScene::checkParts(const plan::FramePlan& plan) const {
    Diagnostics problems;
    if (!scene_.isModern || context_.capabilities().atLeast(4, 3)) return problems;
    for (const plan::PlannedPass& pass : plan.passes)
        for (const auto& step : pass.steps) {
            const auto* draw = std::get_if<plan::PlannedDraw>(&step);
            if (draw == nullptr) continue;
            std::map<scene::TextureIndex, std::optional<int>> levels;
            for (const plan::TextureUse& use : draw->textures) {
                if (use.isImage || !use.view.texture) continue;
                const auto [known, isNew] = levels.try_emplace(use.view.texture, use.view.level);
                if (!use.view.layer && known->second == use.view.level) continue;
                problems.push_back(diagnose(
                    "draw-E10",
                    fmt::format("{} cannot be sampled {}: that needs OpenGL 4.3, this driver has {}.{}",
                                plan::nameOf(scene_, use.view),
                                use.view.layer ? "alone" : "together with another level",
                                context_.capabilities().major, context_.capabilities().minor),
                    plan.drawOf(*draw).place));
            }
        }
    return problems;
}

Result<gpu::Target> DeviceScene::makeTarget(const scene::Pass& pass) {
    const gpu::Texture* first = pass.targets.empty() ? nullptr : texture(pass.targets.front());
    const gpu::TextureSize size = first == nullptr ? gpu::TextureSize{} : first->size();
    gpu::SharedDepth& depth = depthBuffers_[{pass.depthBuffer, size.width, size.height}];
    if (!scene_.isModern) {
        std::vector<const gpu::Texture*> textures;
        for (const scene::TextureIndex each : pass.targets) textures.push_back(texture(each));
        Result<gpu::Target> made = gpu::Target::textures(context_.capabilities(), textures, 1, depth);
        if (made) depth = made->depth();
        return made;
    }
    Diagnostics problems;
    const auto partOf = [&](scene::TextureIndex index, const scene::TargetPart& part) {
        const gpu::Texture& made = *texture(index);
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
    Result<gpu::Target> made =
        gpu::Target::parts(context_.capabilities(), colors, depthPart, depth, depthFormat(scene_));
    if (made && made->depth()) depth = made->depth();
    return made;
}

Result<const gpu::Target*> DeviceScene::target(const scene::Pass& pass) {
    // This runs in every frame, so it compares without making a key.
    const auto isSame = [&](const MadeTarget& known) {
        if (known.depthBuffer != pass.depthBuffer || known.targets != pass.targets ||
            known.parts != pass.parts || known.depth != pass.depth)
            return false;
        for (std::size_t i = 0; i < pass.targets.size(); ++i)
            if (known.textures[i] != texture(pass.targets[i])) return false;
        return !pass.depth || known.textures.back() == texture(pass.depth->texture);
    };
    for (const MadeTarget& known : targets_)
        if (isSame(known)) return &known.target;
    Result<gpu::Target> made = makeTarget(pass);
    if (!made) {
        for (Diagnostic& each : made.diagnostics) each.place = pass.place;
        return std::move(made.diagnostics);
    }
    MadeTarget kept{pass.targets, pass.parts, pass.depth, pass.depthBuffer, {}, std::move(*made)};
    for (const scene::TextureIndex each : pass.targets) kept.textures.push_back(texture(each));
    if (pass.depth) kept.textures.push_back(texture(pass.depth->texture));
    return &targets_.emplace_back(std::move(kept)).target;
}

}  // namespace glibra::render
