// What the textures of a scene are filled with: nothing, noise, or pictures.

#include <glibra/diagnostic.h>

#include <algorithm>
#include <utility>

#include "image/image.h"
#include "image/texture_file.h"
#include "noise/noise.h"
#include "render/load/device_textures.h"
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

gpu::TexelFormat formatOf(image::Component type) {
    if (type == image::Component::u8) return gpu::TexelFormat::rgba8;
    return type == image::Component::u16 ? gpu::TexelFormat::rgba16 : gpu::TexelFormat::rgba32f;
}

gpu::TexelType texelTypeOf(image::Component type) {
    if (type == image::Component::u8) return gpu::TexelType::u8;
    return type == image::Component::u16 ? gpu::TexelType::u16 : gpu::TexelType::f32;
}

/// Converts bytes to 16-bit texels with the same values in 0..1, because llvmpipe filters 8-bit textures with
/// 8-bit weights.
noise::TexelShorts widened(const noise::TexelBytes& bytes) {
    noise::TexelShorts wide(bytes.size());
    for (std::size_t i = 0; i < bytes.size(); ++i) wide[i] = static_cast<std::uint16_t>(bytes[i] * 257U);
    return wide;
}

}  // namespace

DeviceTextures::NoiseTexels DeviceTextures::noiseTexels(const scene::NoiseSource& source,
                                                        const Place& place) {
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

DeviceTextures::PictureTexels DeviceTextures::pictureTexels(const scene::Texture& texture,
                                                            const scene::PictureSource& picture) {
    const StageTimer timer(stats_, "read");
    std::vector<base::FileSource> files;
    for (const scene::FileIndex each : picture.files) files.push_back(scene_.files[each].source());
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
        // A file of an array whose layers it holds itself has them as its depth.
        const int dimensions = texture.target == scene::TextureTarget::texture2DArray
                                   ? 3
                                   : static_cast<int>(scene::sideCount(texture.target));
        return image::readTexture(files.front(), dimensions, texture.place, options);
    };
    PictureTexels texels = read();
    if (texels) texelBytesLeft_ -= texels->data.size();
    return texels;
}

void DeviceTextures::readAhead(scene::TextureIndex index) {
    const scene::Texture& texture = scene_.textures[index];
    const std::string key = reuseKey(scene_, texture);
    if (key.empty() || (shared_ && shared_->textures.contains(key))) return;
    if (const auto* noise = std::get_if<scene::NoiseSource>(&texture.source)) {
        if (!noiseAhead_.contains(key)) noiseAhead_.emplace(key, noiseTexels(*noise, texture.place));
        return;
    }
    const auto& picture = std::get<scene::PictureSource>(texture.source);
    const bool areThere = std::ranges::none_of(
        picture.files, [this](scene::FileIndex file) { return hasError(scene_.files[file].remarks); });
    if (areThere && !picturesAhead_.contains(key))
        picturesAhead_.emplace(key, pictureTexels(texture, picture));
}

Result<gpu::Texture> DeviceTextures::create(const scene::Texture& texture, const std::string& key,
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

Result<gpu::Texture> DeviceTextures::createNamed(const scene::Texture& texture, image::TexelBlock block) {
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

const gpu::Texture& DeviceTextures::emptyTexture(scene::TextureTarget target) {
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
