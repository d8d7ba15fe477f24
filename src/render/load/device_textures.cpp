#include "render/load/device_textures.h"

#include <fmt/format.h>
#include <glibra/diagnostic.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "plan/texture_uses.h"
#include "render/load/reuse.h"
#include "scene/textures.h"

namespace glibra::render {
namespace {

std::uint64_t texelsOf(gpu::TextureSize size, scene::TextureTarget target) {
    return static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height) *
           static_cast<std::uint64_t>(size.depth) * (target == scene::TextureTarget::cube ? 6U : 1U);
}

/// "unit 5 / 3D", or "'brick'".
std::string textureLabel(const scene::Texture& texture) {
    if (!texture.name.empty()) return "'" + texture.name + "'";
    return "unit " + plan::slotText(texture.unit, texture.target);
}

/// True if the texture has the size that the scene declares now.
bool hasSizeOf(const gpu::Texture& texture, const scene::EmptySource& declared) {
    const gpu::TextureSize size = texture.size();
    return size.width == declared.width && size.height == declared.height && size.depth == declared.depth;
}

}  // namespace

std::optional<Diagnostic> DeviceTextures::charge(std::uint64_t bytes, const scene::Texture& texture) {
    image::Limits limits;
    limits.sceneBytesLeft = texelBytesLeft_;
    auto over = image::checkSceneBytes(
        bytes, limits, (texture.name.empty() ? "the texture of " : "texture ") + textureLabel(texture),
        texture.place);
    if (!over) texelBytesLeft_ -= bytes;
    return over;
}

void DeviceTextures::noteWrites(const plan::FramePlan& plan) {
    plan.visitStatements([this](const auto& planned, const auto&) {
        for (const plan::TextureUse& each : planned.textures)
            if (each.isImage && each.view.texture) made_[each.view.texture].mayBeWritten = true;
    });
    if (!scene_.isModern) return;
    for (const plan::PlannedPass& pass : plan.passes) {
        const scene::Pass& drawn = plan.passOf(pass);
        for (const scene::TextureIndex each : drawn.targets) made_[each].mayBeWritten = true;
        if (drawn.depth) made_[drawn.depth->texture].mayBeWritten = true;
    }
}

void DeviceTextures::drop(Made& made) {
    std::set<const gpu::Texture*> gone{made.texture.get()};
    if (made.copies)
        for (const Copies::Copy& each : made.copies->copies)
            gone.insert({each.texture.get(), each.resolved.get()});
    gone.erase(nullptr);
    std::erase_if(views_, [&](const auto& each) { return gone.contains(std::get<0>(each.first)); });
    gone_.merge(gone);
    made.sharing = {};
    made.copies.reset();
    made.texture.reset();
    made.state.isChanged = false;
    made.key.clear();
}

Diagnostics DeviceTextures::followSizes(bool& hasLost) {
    Diagnostics diagnostics;
    for (auto& [index, made] : made_) {
        const auto* empty = std::get_if<scene::EmptySource>(&scene_.textures[index].source);
        if (empty == nullptr || !made.copies || !made.copies->copies[0].texture ||
            hasSizeOf(*made.copies->copies[0].texture, *empty))
            continue;
        drop(made);
        if (!made.state.lasts) continue;
        hasLost = true;
        append(diagnostics, make(index));
    }
    return diagnostics;
}

bool DeviceTextures::isMade(scene::TextureIndex index, const std::string& key) {
    Made& made = made_[index];
    if (!made.texture) return false;
    const auto* empty = std::get_if<scene::EmptySource>(&scene_.textures[index].source);
    if (empty != nullptr ? hasSizeOf(*made.texture, *empty) : made.key == key) return true;
    texelBytesLeft_ += std::exchange(made.charged, 0);
    drop(made);
    return false;
}

Diagnostics DeviceTextures::prepare(const plan::FramePlan& plan) {
    Diagnostics diagnostics;
    const auto isShared = [&](scene::TextureIndex texture) {
        const auto planned = plan.sharing.find(texture);
        if (planned == plan.sharing.end()) return false;
        const Made& made = made_[texture];
        return made.sharing ? made.sharing == planned->second : !made.copies;
    };
    for (const scene::TextureIndex each : plan.textures) {
        if (isShared(each)) continue;
        Made& made = made_[each];
        if (made.sharing) drop(made);  // it needs memory of its own from now on
        const bool isCleared = std::ranges::find(plan.cleared, each) != plan.cleared.end();
        const bool isFilled = !isCleared || made.state.lasts;
        if (!isFilled && !made.copies) made.state.isChanged = made.state.isWritten = true;
        append(diagnostics, make(each, isFilled));
    }
    for (const scene::TextureIndex each : plan.textures) {
        Made& made = made_[each];
        if (!isShared(each) || made.sharing) continue;
        const scene::TextureIndex from = plan.sharing.at(each);
        const Copies* copies = copiesOf(from);
        if (copies == nullptr) continue;  // its diagnostics say why
        made.sharing = from;
        made.texture = copies->copies[0].texture;
        made.copies = *copies;
        stats_.add("textures that share memory", 1);
        stats_.skip("texture",
                    fmt::format("{}: uses the memory of {}, which is not needed at the same time",
                                textureLabel(scene_.textures[each]), textureLabel(scene_.textures[from])),
                    scene_.textures[each].place);
    }
    return diagnostics;
}

Diagnostics DeviceTextures::make(scene::TextureIndex index, bool isFilled) {
    const scene::Texture& texture = scene_.textures[index];
    const bool isNamed = !texture.name.empty();
    Made& kept = made_[index];
    // Animations and steps plan each moment anew; their textures stay.
    if (isNamed && (kept.copies || (kept.texture && !kept.mayBeWritten))) return {};
    const std::string key = reuseKey(scene_, texture);
    if (!isNamed && isMade(index, key)) return {};
    const bool isPicture = std::holds_alternative<scene::PictureSource>(texture.source);
    if (isPicture && !kept.texture && kept.key == key) return {};  // faulty files are reported once
    const std::uint64_t bytesLeft = texelBytesLeft_;
    kept.key = key;
    const bool isOwn = key.empty() || kept.mayBeWritten;
    if (sharesTextures_ && !isOwn && isPicture) {
        // Files used twice are read once: statements that name the same files share one texture.
        scene::TextureIndex& first = pictures_.try_emplace(key, index).first->second;
        const Made& owner = made_[first];
        if (first != index && owner.key == key && !owner.mayBeWritten) {
            kept.texture = owner.texture;  // null if the file is faulty, which the owner has reported
            stats_.skip("texture",
                        fmt::format("{}: shares the texture that line {} makes from the same file",
                                    textureLabel(texture), scene_.textures[first].place.line),
                        texture.place);
            return {};
        }
        first = index;
    }
    if (!isOwn)
        if (std::shared_ptr<const gpu::Texture> earlier = earlierTexture(key, texture)) {
            const std::uint64_t bytes =
                texelsOf(earlier->size(), texture.target) * gpu::bytesPerTexel(earlier->format());
            if (auto over = charge(bytes, texture)) return {*std::move(over)};
            kept.texture = std::move(earlier);
            kept.charged = bytesLeft - texelBytesLeft_;
            return {};
        }
    Result<gpu::Texture> made = create(texture, key, isFilled);
    if (!made) return std::move(made.diagnostics);
    const std::uint64_t texels = texelsOf(made->size(), texture.target);
    stats_.add("textures", 1);
    stats_.add("texels", texels);
    if (isNamed && (isOwn || texture.hasHistory)) {
        Diagnostics remarks = std::move(made.diagnostics);
        append(remarks, makeCopies(index, std::make_shared<gpu::Texture>(std::move(*made))));
        return remarks;
    }
    kept.texture = std::make_shared<const gpu::Texture>(std::move(*made));
    if (shared_ && !isOwn && made.diagnostics.empty())
        shared_->textures.add(key, kept.texture, texels * gpu::bytesPerTexel(kept.texture->format()));
    kept.charged = bytesLeft - texelBytesLeft_;
    return std::move(made.diagnostics);
}

std::shared_ptr<const gpu::Texture> DeviceTextures::earlierTexture(const std::string& key,
                                                                   const scene::Texture& texture) {
    if (previous_)
        for (const auto& [index, known] : previous_->made_)
            if (known.texture && known.key == key && !known.mayBeWritten) return known.texture;
    std::shared_ptr<const gpu::Texture> found =
        shared_ ? shared_->textures.find(key).value_or(nullptr) : nullptr;
    if (!found) return nullptr;
    stats_.add("textures kept", 1);
    const bool isNoise = std::holds_alternative<scene::NoiseSource>(texture.source);
    stats_.skip(isNoise ? "noise texture" : "texture", textureLabel(texture) + ": already on the device",
                texture.place);
    return found;
}

Diagnostics DeviceTextures::keepDeclared(scene::TextureIndex index, gpu::BindingTracker& bindings) {
    Copies* copies = copiesOf(index);
    const scene::Texture& texture = scene_.textures[index];
    if (copies == nullptr || copies->declared || std::holds_alternative<scene::EmptySource>(texture.source))
        return {};
    const gpu::Texture& now = *copies->copies[0].texture;
    if (auto over = charge(texelsOf(now.size(), texture.target) * gpu::bytesPerTexel(now.format()), texture))
        return {*std::move(over)};
    gpu::TextureLayout layout{now.shape(), now.format(), now.size(), now.levels()};
    layout.isFilled = false;
    Result<gpu::Texture> made = gpu::Texture::create(context_.capabilities(), layout);
    bindings.forgetWorkUnit();
    Diagnostics problems = std::move(made.diagnostics);
    if (made) {
        append(problems, gpu::copyTexture(context_.capabilities(), now, *made));
        copies->declared = std::make_shared<const gpu::Texture>(std::move(*made));
    }
    for (Diagnostic& each : problems) each.place = texture.place;
    return problems;
}

Diagnostics DeviceTextures::reset(scene::TextureIndex texture) {
    if (!std::holds_alternative<scene::EmptySource>(scene_.textures[texture].source)) {
        Copies* copies = copiesOf(texture);
        if (copies == nullptr || !copies->declared) return {};
        copies->copies[0].hasMipmaps = true;
        return gpu::copyTexture(context_.capabilities(), *copies->declared, *copies->copies[0].texture);
    }
    clear(texture);
    if (!scene_.textures[texture].hasHistory) return {};
    exchange(texture);
    clear(texture);
    return {};
}

const gpu::Texture* DeviceTextures::texture(scene::TextureIndex texture) const {
    const auto found = made_.find(texture);
    return found == made_.end() ? nullptr : found->second.texture.get();
}

}  // namespace glibra::render
