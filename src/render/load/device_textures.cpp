// The textures, samplers and targets of DeviceScene.

#include <fmt/format.h>
#include <glibra/diagnostic.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "image/cube_map.h"
#include "image/texel_block.h"
#include "image/texture_file.h"
#include "noise/noise.h"
#include "plan/texture_uses.h"
#include "render/load/device_scene.h"
#include "render/load/reuse.h"
#include "scene/texture_parts.h"
#include "scene/textures.h"

namespace glibra::render {
namespace {

gpu::TextureShape shapeOf(scene::TextureTarget target) {
    switch (target) {
        case scene::TextureTarget::texture1D:
            return gpu::TextureShape::texture1D;
        case scene::TextureTarget::texture2D:
            return gpu::TextureShape::texture2D;
        case scene::TextureTarget::texture3D:
            return gpu::TextureShape::texture3D;
        case scene::TextureTarget::texture1DArray:
            return gpu::TextureShape::array1D;
        case scene::TextureTarget::texture2DArray:
            return gpu::TextureShape::array2D;
        case scene::TextureTarget::rectangle:
            return gpu::TextureShape::rectangle;
        case scene::TextureTarget::cubeArray:
            return gpu::TextureShape::cubeArray;
        case scene::TextureTarget::cube:
            break;
    }
    return gpu::TextureShape::cube;
}

gpu::TextureShape multisampled(gpu::TextureShape shape) {
    return shape == gpu::TextureShape::array2D ? gpu::TextureShape::multisampledArray
                                               : gpu::TextureShape::multisampled;
}

int dimensionsOf(scene::TextureTarget target) {
    switch (target) {
        case scene::TextureTarget::texture1D:
        case scene::TextureTarget::texture1DArray:
            return 1;
        case scene::TextureTarget::texture3D:
        case scene::TextureTarget::texture2DArray:
            return 3;
        case scene::TextureTarget::texture2D:
        case scene::TextureTarget::rectangle:
        case scene::TextureTarget::cube:
        case scene::TextureTarget::cubeArray:
            break;
    }
    return 2;
}

gpu::TexelFormat formatOf(image::Component type) {
    switch (type) {
        case image::Component::u8:
            return gpu::TexelFormat::rgba8;
        case image::Component::u16:
            return gpu::TexelFormat::rgba16;
        case image::Component::f32:
            break;
    }
    return gpu::TexelFormat::rgba32f;
}

gpu::TexelType texelTypeOf(image::Component type) {
    switch (type) {
        case image::Component::u8:
            return gpu::TexelType::u8;
        case image::Component::u16:
            return gpu::TexelType::u16;
        case image::Component::f32:
            break;
    }
    return gpu::TexelType::f32;
}

/// Converts bytes to 16-bit texels with the same values in 0..1, because llvmpipe filters 8-bit textures with
/// 8-bit weights.
noise::TexelShorts widened(const noise::TexelBytes& bytes) {
    noise::TexelShorts wide(bytes.size());
    for (std::size_t i = 0; i < bytes.size(); ++i) wide[i] = static_cast<std::uint16_t>(bytes[i] * 257U);
    return wide;
}

std::uint64_t texelsOf(gpu::TextureSize size, scene::TextureTarget target) {
    return static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height) *
           static_cast<std::uint64_t>(size.depth) * (target == scene::TextureTarget::cube ? 6U : 1U);
}

/// "unit 5 / 3D", or "'brick'".
std::string textureLabel(const scene::Texture& texture) {
    if (!texture.name.empty()) return "'" + texture.name + "'";
    return "unit " + plan::slotText(texture.unit, texture.target);
}

/// The files of a picture, in order.
std::vector<base::FileSource> sourcesOf(const scene::Scene& scene, const scene::PictureSource& picture) {
    std::vector<base::FileSource> sources;
    for (const scene::FileIndex each : picture.files) sources.push_back(scene.files[each].source());
    return sources;
}

}  // namespace

DeviceScene::NoiseTexels DeviceScene::noiseTexels(const scene::NoiseSource& source, const Place& place) {
    const StageTimer timer(stats_, "noise");
    if (!source.file) {
        if (source.texels == scene::NoiseTexels::bytes)
            return widened(source.dimensions == 3 ? noise::noise3Texels(source.size)
                                                  : noise::noise2Texels(source.size));
        return source.dimensions == 3 ? noise::noise3Shorts(source.size) : noise::noise2Shorts(source.size);
    }
    stats_.add("files read", 1);
    const scene::FileReference& file = scene_.files[source.file];
    image::ReadOptions options;
    options.limits.sceneBytesLeft = texelBytesLeft_;
    Result<image::TexelBlock> read = image::readTexture(file.source(), source.dimensions, place, options);
    if (!read) return std::move(read.diagnostics);
    noise::TexelBytes bytes(read->data.size());
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = std::to_integer<std::uint8_t>(read->data[i]);
    return widened(bytes);
}

DeviceScene::PictureTexels DeviceScene::pictureTexels(const scene::Texture& texture,
                                                      const scene::PictureSource& picture) {
    const StageTimer timer(stats_, "read");
    const std::vector<base::FileSource> files = sourcesOf(scene_, picture);
    stats_.add("files read", files.size());
    image::ReadOptions options;
    options.limits.sceneBytesLeft = texelBytesLeft_;
    const auto read = [&]() -> PictureTexels {
        if (texture.target == scene::TextureTarget::cube)
            return files.size() == 1 ? image::readCubePicture(files.front(), texture.place, options)
                                     : image::readCubeMap(files, texture.place, options);
        if (texture.target == scene::TextureTarget::texture1DArray)
            return image::readLayers(files, 1, texture.place, options);
        const bool hasLayers =
            files.size() > 1 || (texture.target == scene::TextureTarget::texture2DArray &&
                                 scene::targetOfFile(files.front()) == scene::TextureTarget::texture2D);
        if (hasLayers) return image::readLayers(files, 2, texture.place, options);
        return image::readTexture(files.front(), dimensionsOf(texture.target), texture.place, options);
    };
    PictureTexels texels = read();
    if (texels) texelBytesLeft_ -= texels->data.size();
    return texels;
}

std::optional<Diagnostic> DeviceScene::charge(std::uint64_t bytes, const scene::Texture& texture) {
    image::Limits limits;
    limits.sceneBytesLeft = texelBytesLeft_;
    auto over = image::checkSceneBytes(
        bytes, limits, (texture.name.empty() ? "the texture of " : "texture ") + textureLabel(texture),
        texture.place);
    if (!over) texelBytesLeft_ -= bytes;
    return over;
}

void DeviceScene::readAhead(scene::TextureIndex index) {
    const scene::Texture& texture = scene_.textures[index];
    const std::string key = reuseKey(scene_, texture);
    if (key.empty() || (shared_ && shared_->textures.contains(key))) return;
    if (const auto* noise = std::get_if<scene::NoiseSource>(&texture.source)) {
        if (!noiseAhead_.contains(key)) noiseAhead_.emplace(key, noiseTexels(*noise, texture.place));
        return;
    }
    const auto& picture = std::get<scene::PictureSource>(texture.source);
    const bool areThere =
        std::none_of(picture.files.begin(), picture.files.end(),
                     [this](scene::FileIndex file) { return hasError(scene_.files[file].remarks); });
    if (areThere && !picturesAhead_.contains(key))
        picturesAhead_.emplace(key, pictureTexels(texture, picture));
}

Diagnostics DeviceScene::makeTextures(const plan::FramePlan& plan) {
    Diagnostics diagnostics;
    const auto isShared = [&](scene::TextureIndex texture) {
        const auto planned = plan.sharing.find(texture);
        const auto made = sharing_.find(texture);
        if (planned == plan.sharing.end()) return false;
        return made == sharing_.end() ? !copies_.contains(texture) : made->second == planned->second;
    };
    for (const scene::TextureIndex each : plan.textures) {
        if (isShared(each)) continue;
        if (sharing_.contains(each)) dropTexture(each);  // it needs memory of its own from now on
        const bool isCleared =
            std::find(plan.cleared.begin(), plan.cleared.end(), each) != plan.cleared.end();
        const bool isFilled = !isCleared || lasting_.contains(each);
        if (!isFilled && !copies_.contains(each)) {
            changed_.insert(each);
            stored_.insert(each);
        }
        append(diagnostics, makeTexture(each, isFilled));
    }
    for (const scene::TextureIndex each : plan.textures) {
        if (!isShared(each) || sharing_.contains(each)) continue;
        const auto from = copies_.find(plan.sharing.at(each));
        if (from == copies_.end()) continue;  // its diagnostics say why
        sharing_.emplace(each, from->first);
        textures_.insert_or_assign(each, from->second.copies[0].texture);
        copies_.insert_or_assign(each, from->second);
        stats_.add("textures that share memory", 1);
        stats_.skip(
            "texture",
            fmt::format("{}: uses the memory of {}, which is not needed at the same time",
                        textureLabel(scene_.textures[each]), textureLabel(scene_.textures[from->first])),
            scene_.textures[each].place);
    }
    return diagnostics;
}

Diagnostics DeviceScene::makeTexture(scene::TextureIndex index, bool isFilled) {
    const scene::Texture& texture = scene_.textures[index];
    const bool isNamed = !texture.name.empty();
    // Animations and steps plan each moment anew; their textures stay.
    if (isNamed && (copies_.contains(index) || (textures_.contains(index) && !written_.contains(index))))
        return {};
    const std::string key = reuseKey(scene_, texture);
    if (isNamed ? sameTexture_.contains(index) : isMade(index, key)) return {};
    const std::uint64_t bytesLeft = texelBytesLeft_;
    const auto* picture = std::get_if<scene::PictureSource>(&texture.source);
    if (picture && sharesTextures_ && !(isNamed && written_.contains(index))) {
        // Files used twice are read once: statements that name the same files share one texture.
        const auto [first, isNew] = pictures_.try_emplace(
            {picture->files, texture.target, texture.isFlipped, texture.isSrgb, texture.hasMipmaps}, index);
        if (!isNew) {
            sameTexture_[index] = first->second;
            stats_.skip("texture",
                        fmt::format("{}: shares the texture that line {} makes from the same file",
                                    textureLabel(texture), scene_.textures[first->second].place.line),
                        texture.place);
            return {};
        }
    }
    textureKeys_[index] = key;
    const bool isOwn = key.empty() || written_.contains(index);
    if (!isOwn)
        if (std::shared_ptr<const gpu::Texture> earlier = earlierTexture(key, texture)) {
            const std::uint64_t bytes =
                texelsOf(earlier->size(), texture.target) * gpu::bytesPerTexel(earlier->format());
            if (auto over = charge(bytes, texture)) return {*std::move(over)};
            textures_.emplace(index, std::move(earlier));
            charged_[index] = bytesLeft - texelBytesLeft_;
            return {};
        }
    Result<gpu::Texture> made = createTexture(texture, key, isFilled);
    if (!made) return std::move(made.diagnostics);
    const std::uint64_t texels = texelsOf(made->size(), texture.target);
    stats_.add("textures", 1);
    stats_.add("texels", texels);
    if (isNamed && (isOwn || texture.hasHistory)) {
        Diagnostics remarks = std::move(made.diagnostics);
        append(remarks, makeCopies(index, std::make_shared<gpu::Texture>(std::move(*made))));
        return remarks;
    }
    auto kept = std::make_shared<const gpu::Texture>(std::move(*made));
    if (shared_ && !isOwn && made.diagnostics.empty())
        shared_->textures.add(key, kept, texels * gpu::bytesPerTexel(kept->format()));
    textures_.emplace(index, std::move(kept));
    charged_[index] = bytesLeft - texelBytesLeft_;
    return std::move(made.diagnostics);
}

std::shared_ptr<const gpu::Texture> DeviceScene::earlierTexture(const std::string& key,
                                                                const scene::Texture& texture) {
    if (previous_)
        for (const auto& [index, known] : previous_->textures_)
            if (previous_->textureKeys_[index] == key && !previous_->written_.contains(index)) return known;
    std::shared_ptr<const gpu::Texture> found =
        shared_ ? shared_->textures.find(key).value_or(nullptr) : nullptr;
    if (!found) return nullptr;
    stats_.add("textures kept", 1);
    const bool isNoise = std::holds_alternative<scene::NoiseSource>(texture.source);
    stats_.skip(isNoise ? "noise texture" : "texture", textureLabel(texture) + ": already on the device",
                texture.place);
    return found;
}

Result<gpu::Texture> DeviceScene::createTexture(const scene::Texture& texture, const std::string& key,
                                                bool isFilled) {
    const gpu::Capabilities& capabilities = context_.capabilities();
    const gpu::TextureShape shape = shapeOf(texture.target);
    if (const auto* empty = std::get_if<scene::EmptySource>(&texture.source)) {
        gpu::TextureLayout layout{shape, empty->format, {empty->width, empty->height, empty->depth}};
        if (texture.name.empty()) return gpu::Texture::create(capabilities, layout);
        layout.levels = scene::levelsOf(texture).value_or(1);
        layout.samples = texture.samples;
        layout.isFilled = isFilled;
        if (texture.samples > 1) layout.shape = multisampled(shape);
        Result<gpu::Texture> made = gpu::Texture::create(capabilities, layout);
        for (Diagnostic& each : made.diagnostics) each.place = texture.place;
        return made;
    }

    if (const auto* noise = std::get_if<scene::NoiseSource>(&texture.source)) {
        const auto side = static_cast<std::uint64_t>(noise->size);
        if (auto over = charge(side * side * (noise->dimensions == 3 ? side : 1) *
                                   gpu::bytesPerTexel(gpu::TexelFormat::rgba16),
                               texture))
            return *std::move(over);
        auto ahead = noiseAhead_.extract(key);
        NoiseTexels texels = ahead ? std::move(ahead.mapped()) : noiseTexels(*noise, texture.place);
        const StageTimer timer(stats_, "noise");
        Diagnostics diagnostics = noise->remarks;
        append(diagnostics, std::move(texels.diagnostics));
        if (!texels) return diagnostics;
        const int depth = noise->dimensions == 3 ? noise->size : 1;
        Result<gpu::Texture> made = gpu::Texture::create(
            capabilities, shape, gpu::TexelFormat::rgba16, {noise->size, noise->size, depth},
            {std::as_bytes(std::span(std::as_const(*texels))), 4, gpu::TexelType::u16});
        append(diagnostics, std::move(made.diagnostics));
        made.diagnostics = std::move(diagnostics);
        return made;
    }

    const auto& picture = std::get<scene::PictureSource>(texture.source);
    Diagnostics diagnostics;
    for (const scene::FileIndex each : picture.files) append(diagnostics, scene_.files[each].remarks);
    if (hasError(diagnostics)) return diagnostics;
    auto ahead = picturesAhead_.extract(key);
    PictureTexels block = ahead ? std::move(ahead.mapped()) : pictureTexels(texture, picture);
    const StageTimer timer(stats_, "read");
    append(diagnostics, std::move(block.diagnostics));
    if (!block) return diagnostics;
    Result<gpu::Texture> made =
        texture.name.empty()
            ? gpu::Texture::create(capabilities, shape, formatOf(block->type),
                                   {block->width, block->height, block->depth},
                                   {block->data, block->components, texelTypeOf(block->type)})
            : createNamed(texture, std::move(*block));
    append(diagnostics, std::move(made.diagnostics));
    made.diagnostics = std::move(diagnostics);
    return made;
}

Result<gpu::Texture> DeviceScene::createNamed(const scene::Texture& texture, image::TexelBlock block) {
    if (texture.isFlipped) image::flipRows(block);
    // Only bytes have an sRGB format; wider texels are decoded here.
    const bool isSrgbFormat = texture.isSrgb && block.type == image::Component::u8;
    if (texture.isSrgb && !isSrgbFormat) image::decodeSrgb(block);
    gpu::TextureLayout layout{shapeOf(texture.target),
                              isSrgbFormat ? gpu::TexelFormat::srgb8_alpha8 : formatOf(block.type),
                              {block.width, block.height, block.depth}};
    if (texture.hasMipmaps) layout.levels = gpu::mostLevels(layout.shape, layout.size);
    Result<gpu::Texture> made = gpu::Texture::create(context_.capabilities(), layout);
    if (made)
        append(made.diagnostics, made->upload(0, {block.data, block.components, texelTypeOf(block.type)}));
    for (Diagnostic& each : made.diagnostics) each.place = texture.place;
    if (made && hasError(made.diagnostics)) return std::move(made.diagnostics);
    if (made && layout.levels > 1) made->generateMipmaps();
    return made;
}

Diagnostics DeviceScene::keepDeclared(scene::TextureIndex index, gpu::BindingTracker& bindings) {
    const auto found = copies_.find(index);
    const scene::Texture& texture = scene_.textures[index];
    if (found == copies_.end() || found->second.declared ||
        std::holds_alternative<scene::EmptySource>(texture.source))
        return {};
    const gpu::Texture& now = *found->second.copies[0].texture;
    if (auto over = charge(texelsOf(now.size(), texture.target) * gpu::bytesPerTexel(now.format()), texture))
        return {*std::move(over)};
    gpu::TextureLayout layout{now.shape(), now.format(), now.size(), now.levels()};
    layout.isFilled = false;
    Result<gpu::Texture> made = gpu::Texture::create(context_.capabilities(), layout);
    bindings.forgetWorkUnit();
    Diagnostics problems = std::move(made.diagnostics);
    if (made) {
        append(problems, gpu::copyTexture(context_.capabilities(), now, *made));
        found->second.declared = std::make_shared<const gpu::Texture>(std::move(*made));
    }
    for (Diagnostic& each : problems) each.place = texture.place;
    return problems;
}

Diagnostics DeviceScene::resetToFile(scene::TextureIndex index) {
    const auto found = copies_.find(index);
    if (found == copies_.end() || !found->second.declared) return {};
    Copies::Copy& copy = found->second.copies[0];
    copy.hasMipmaps = true;
    return gpu::copyTexture(context_.capabilities(), *found->second.declared, *copy.texture);
}

const gpu::Texture* DeviceScene::texture(scene::TextureIndex texture) const {
    const auto same = sameTexture_.find(texture);
    const auto found = textures_.find(same == sameTexture_.end() ? texture : same->second);
    return found == textures_.end() ? nullptr : found->second.get();
}

const gpu::Texture& DeviceScene::emptyTexture(scene::TextureTarget target) {
    const auto known = emptyTextures_.find(target);
    if (known != emptyTextures_.end()) return known->second;
    const bool areCubes = target == scene::TextureTarget::cubeArray;
    const std::size_t faces = areCubes || target == scene::TextureTarget::cube ? 6 : 1;
    std::vector<std::uint8_t> texels(faces * 4);
    for (std::size_t i = 3; i < texels.size(); i += 4) texels[i] = 255;
    Result<gpu::Texture> made =
        gpu::Texture::create(context_.capabilities(), shapeOf(target), gpu::TexelFormat::rgba8,
                             {1, 1, areCubes ? 6 : 1}, {std::as_bytes(std::span(texels)), 4});
    return emptyTextures_.emplace(target, made ? std::move(*made) : gpu::Texture{}).first->second;
}

}  // namespace glibra::render
