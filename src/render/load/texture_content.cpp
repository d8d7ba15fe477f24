// What the textures of a scene are filled with: nothing, noise, or pictures.

#include <fmt/format.h>
#include <glibra/diagnostic.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <utility>

#include "gpu/object/texture.h"
#include "image/image.h"
#include "image/texture_file.h"
#include "noise/noise.h"
#include "plan/texture_binding.h"
#include "render/load/device_textures.h"
#include "render/load/shared_parts.h"
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

// What a texture of a scene holds, as an image.

gpu::TexelType numberTypeOf(const base::TexelFormatRow& row) {
    using enum gpu::TexelType;
    switch (row.kind) {
        case base::TexelClass::normalized:
            return row.bits == 8 ? u8 : u16;
        case base::TexelClass::integer:
            return row.bits == 8 ? i8 : row.bits == 16 ? i16 : i32;
        case base::TexelClass::unsignedInteger:
            return row.bits == 8 ? u8 : row.bits == 16 ? u16 : u32;
        default:
            return f32;
    }
}

namespace {

/// Returns a number that no float has, if there is one.
template <class Integer>
std::optional<std::int64_t> toFloats(std::vector<std::byte>& numbers) {
    std::optional<std::int64_t> lost;
    for (std::size_t i = 0; i < numbers.size(); i += sizeof(Integer)) {
        Integer number = 0;
        std::memcpy(&number, numbers.data() + i, sizeof number);
        const auto value = static_cast<float>(number);
        if (static_cast<double>(value) != static_cast<double>(number)) lost = number;
        std::memcpy(numbers.data() + i, &value, sizeof value);
    }
    return lost;
}

}  // namespace

Result<TexelNumbers> DeviceTextures::numbersOf(const scene::TextureView& view) {
    const gpu::Texture* made = completed(view);
    if (made == nullptr) return read(view, 4, gpu::TexelType::f32);  // reports why
    const base::TexelFormatRow& row = base::rowOf(made->format());
    return read(view, hasDepth(made->format()) ? 1 : row.components, numberTypeOf(row));
}

Result<image::Image> DeviceTextures::imageOf(const scene::TextureView& view) {
    const gpu::Texture* made = completed(view);
    const base::TexelFormatRow& row =
        base::rowOf(made != nullptr ? made->format() : gpu::TexelFormat::rgba32f);
    // Pictures of two components would be grey and alpha. Integers are no shares of a largest one, as the
    // numbers of pictures are.
    const int components = hasDepth(row.format) ? 1 : row.components == 2 ? 3 : row.components;
    const gpu::TexelType type = row.kind == base::TexelClass::integer           ? gpu::TexelType::i32
                                : row.kind == base::TexelClass::unsignedInteger ? gpu::TexelType::u32
                                                                                : numberTypeOf(row);
    Result<TexelNumbers> numbers = read(view, components, type);
    if (!numbers) return std::move(numbers.diagnostics);
    image::Image image{numbers->width, numbers->height, components, image::Component::f32,
                       std::move(numbers->data)};
    if (type == gpu::TexelType::u8) image.type = image::Component::u8;
    if (type == gpu::TexelType::u16) image.type = image::Component::u16;
    std::optional<std::int64_t> lost;
    if (type == gpu::TexelType::i32) lost = toFloats<std::int32_t>(image.data);
    if (type == gpu::TexelType::u32) lost = toFloats<std::uint32_t>(image.data);
    if (!lost) return image;
    return diagnose(
        "draw-E10",
        fmt::format("{} cannot be saved: it has the number {}, which no 32-bit float has; the libraries "
                    "for C++ and Python give such numbers",
                    plan::nameOf(scene_, view), *lost),
        scene_.textures[view.texture].place);
}

Result<TexelNumbers> DeviceTextures::read(const scene::TextureView& view, int components,
                                          gpu::TexelType type) {
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

    Result<std::vector<std::byte>> texels = made->read(level, components, type);
    if (!texels) return std::move(texels.diagnostics);
    const gpu::TextureSize size = gpu::sizeOfLevel(made->shape(), made->size(), level);
    TexelNumbers numbers{size.width, size.height, components, type, {}};
    const std::size_t bytes = texels->size() / static_cast<std::size_t>(layers);
    const auto first = texels->begin() +
                       static_cast<std::ptrdiff_t>(bytes * static_cast<std::size_t>(view.layer.value_or(0)));
    numbers.data.assign(first, first + static_cast<std::ptrdiff_t>(bytes));
    if (!gpu::isCube(made->shape()))
        gpu::flipRows(numbers.data, bytes / static_cast<std::size_t>(size.height));
    return numbers;
}

// The copies of DeviceTextures, and the parts and samplers that shaders read them by.

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
