// What a texture of a scene holds, as an image.

#include <fmt/format.h>
#include <glibra/diagnostic.h>

#include <cstring>
#include <utility>

#include "image/texel_block.h"
#include "plan/texture_binding.h"
#include "render/load/device_textures.h"

namespace glibra::render {
namespace {

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

Result<image::Image> DeviceTextures::imageOf(const scene::TextureView& view) {
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

}  // namespace glibra::render
