// What a texture of a scene holds, as an image.

#include <fmt/format.h>
#include <glibra/diagnostic.h>

#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

#include "gpu/object/readback.h"
#include "plan/texture_binding.h"
#include "render/load/device_textures.h"

namespace glibra::render {

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

}  // namespace glibra::render
