#include "render/load/device_textures.h"

#include <glibra/diagnostic.h>

#include <fmt/format.h>
#include <algorithm>

#include "base/text.h"
#include "plan/texture_binding.h"

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

Diagnostics DeviceTextures::followSizes(Resized& resized) {
    Diagnostics diagnostics;
    for (auto& [index, made] : made_) {
        const auto* empty = std::get_if<scene::EmptySource>(&scene_.textures[index].source);
        if (empty == nullptr || !made.copies || !made.copies->copies[0].texture ||
            hasSizeOf(*made.copies->copies[0].texture, *empty))
            continue;
        drop(made);
        resized.isAny = true;
        if (!made.state.lasts) continue;
        resized.hasLost = true;
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
    const bool isEmpty = std::holds_alternative<scene::EmptySource>(texture.source);
    if (copies == nullptr || copies->declared || (isEmpty && !copies->isGiven)) return {};
    Diagnostics problems = makeDeclared(index);
    bindings.forgetWorkUnit();
    if (copies->declared)
        append(problems,
               gpu::copyTexture(context_.capabilities(), *copies->copies[0].texture, *copies->declared));
    for (Diagnostic& each : problems) each.place = texture.place;
    return problems;
}

Diagnostics DeviceTextures::makeDeclared(scene::TextureIndex index) {
    const scene::Texture& texture = scene_.textures[index];
    Copies& copies = *copiesOf(index);
    const gpu::Texture& now = *copies.copies[0].texture;
    if (auto over = charge(texelsOf(now.size(), texture.target) * gpu::bytesPerTexel(now.format()), texture))
        return {*std::move(over)};
    gpu::TextureLayout layout{now.shape(), now.format(), now.size(), now.levels()};
    layout.isFilled = false;
    Result<gpu::Texture> made = gpu::Texture::create(context_.capabilities(), layout);
    if (made) copies.declared = std::make_shared<gpu::Texture>(std::move(*made));
    return std::move(made.diagnostics);
}

Diagnostics DeviceTextures::write(scene::TextureIndex index, const gpu::Texels& texels) {
    const scene::Texture& texture = scene_.textures[index];
    Made& made = made_.at(index);
    Diagnostics problems;
    if (!made.copies) {
        const gpu::Texture& shared = *made.texture;
        Result<gpu::Texture> own = gpu::Texture::create(
            context_.capabilities(), {shared.shape(), shared.format(), shared.size(), shared.levels()});
        if (!own) return std::move(own.diagnostics);
        drop(made);
        made.mayBeWritten = true;
        append(problems, makeCopies(index, std::make_shared<gpu::Texture>(std::move(*own))));
    }
    Copies& copies = *made.copies;
    if (made.state.isWritten && !copies.declared) append(problems, makeDeclared(index));
    copies.isGiven = true;
    for (Copies::Copy& each : copies.copies) {
        if (!each.texture) continue;
        append(problems, each.texture->upload(0, texels));
        each.hasMipmaps = !texture.hasMipmaps;
    }
    if (copies.declared) append(problems, copies.declared->upload(0, texels));
    for (Diagnostic& each : problems) each.place = texture.place;
    return problems;
}

Diagnostics DeviceTextures::giveWritten(DeviceTextures& copy) const {
    Diagnostics problems;
    for (const auto& [index, made] : made_) {
        const auto other = copy.made_.find(index);
        if (!made.copies || !made.copies->isGiven || other == copy.made_.end() || !other->second.texture)
            continue;
        const gpu::Texture& from =
            made.copies->declared ? *made.copies->declared : *made.copies->copies[0].texture;
        const base::TexelFormatRow& row = base::rowOf(from.format());
        const int components = hasDepth(row.format) ? 1 : row.components;
        const Result<std::vector<std::byte>> texels = from.read(0, components, numberTypeOf(row));
        append(problems,
               texels ? copy.write(index, {*texels, components, numberTypeOf(row)}) : texels.diagnostics());
    }
    return problems;
}

Diagnostics DeviceTextures::reset(scene::TextureIndex texture) {
    if (Copies* copies = copiesOf(texture); copies != nullptr && copies->declared) {
        Diagnostics problems;
        for (Copies::Copy& each : copies->copies) {
            if (!each.texture) continue;
            each.hasMipmaps = !copies->isGiven || !scene_.textures[texture].hasMipmaps;
            append(problems, gpu::copyTexture(context_.capabilities(), *copies->declared, *each.texture));
        }
        return problems;
    }
    if (!std::holds_alternative<scene::EmptySource>(scene_.textures[texture].source)) return {};
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
               return draw != nullptr && draw->isFill && !draw->raster->depthTest &&
                      !draw->raster->stencilTest;
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
    gpu::SharedDepth& depth = depthBuffers_[{pass.depthBuffer, size.width, size.height, pass.isReversed}];
    Result<gpu::Target> made =
        gpu::Target::parts(context_.capabilities(), colors, depthPart, depth, depthFormat(pass.isReversed));
    if (made && made->depth()) depth = made->depth();
    return made;
}

Result<const gpu::Target*> DeviceTargets::of(const scene::Pass& pass) {
    const bool needsDepth = !isWithoutDepth(pass);
    // This runs in every frame, so it compares without making a key.
    const auto isSame = [&](const Made& known) {
        if (known.depthBuffer != pass.depthBuffer || known.targets != pass.targets ||
            known.parts != pass.parts || known.depth != pass.depth ||
            (needsDepth && (!known.hasDepth || known.isReversed != pass.isReversed)))
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
    Made kept{pass.targets, pass.parts,      pass.depth, pass.depthBuffer,
              needsDepth,   pass.isReversed, {},         std::move(*made)};
    for (const scene::TextureIndex each : pass.targets) kept.textures.push_back(textures_.texture(each));
    if (pass.depth) kept.textures.push_back(textures_.texture(pass.depth->texture));
    return &made_.emplace_back(std::move(kept)).target;
}

}  // namespace glibra::render
