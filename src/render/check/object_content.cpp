#include "render/check/object_content.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>

namespace glibra::render {
namespace {

/// The values of a level as doubles, its layers after one another.
template <class T>
std::vector<double> doublesOf(std::span<const std::byte> bytes) {
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return {values.begin(), values.end()};
}

/// The distance of neighbouring values of a normalised format; 0 for floats and integers.
double stepOf(base::TexelFormat format) {
    const base::TexelFormatRow& row = base::rowOf(format);
    if (row.bits == 0 || base::isInteger(format)) return 0;
    const double largest = std::exp2(row.bits) - 1;
    return row.kind == base::TexelClass::signedNormalized ? 2 / (largest - 1) : 1 / largest;
}

Result<Content> textureContent(const scene::Scene& scene, DeviceScene& device,
                               const scene::TextureView& view) {
    const scene::Texture& declared = scene.textures[view.texture];
    const gpu::Texture* texture = device.textures().texture(view);
    const auto refuse = [&](const std::string& why) {
        return diagnose("check-E02", fmt::format("'{}' {}", declared.name, why), declared.place);
    };
    if (texture == nullptr) return refuse("was not drawn");
    if (texture->samples() > 1) return refuse("has several samples per texel and cannot be read");
    const int level = view.level.value_or(0);
    if (level >= texture->levels()) return refuse(fmt::format("has no level {}", level));
    if (level > 0)
        texture = device.textures().completed(view);  // its mipmaps may not have been needed so far
    if (view.layer && *view.layer >= texture->layers(level))
        return refuse(fmt::format("has no layer {}", *view.layer));
    Result<Content> content = contentOf(*texture, level, view.layer);
    if (!content) return content;
    content->name = declared.name;
    content->isCube = declared.target == scene::TextureTarget::cube;
    return content;
}

Result<Content> bufferContent(const scene::Scene& scene, const DeviceBuffers& buffers,
                              const scene::BufferView& view) {
    const scene::Buffer& declared = scene.buffers[view.buffer];
    const plan::BufferLayout* layout = buffers.layout(view.buffer);
    if (layout == nullptr || buffers.buffer(view) == nullptr)
        return diagnose("check-E02", fmt::format("'{}' is not used by anything that was run", declared.name),
                        declared.place);
    Content content;
    content.name = declared.name;
    // What a block has before its array is no element; a block without an array is one.
    const plan::MemoryPattern& pattern = layout->pattern;
    const bool hasArray = !pattern.element.empty();
    content.values =
        buffers.read(view, hasArray ? pattern.head.size() : 0, std::numeric_limits<std::uint64_t>::max());
    content.components =
        static_cast<int>(std::max<std::size_t>(1, hasArray ? pattern.element.size() : pattern.head.size()));
    content.width = static_cast<int>(content.values.size() / static_cast<std::size_t>(content.components));
    content.isOfDoubles =
        std::ranges::any_of(hasArray ? pattern.element : pattern.head,
                            [](const auto& each) { return each.kind == plan::NumberKind::doublePrecision; });
    return content;
}

}  // namespace

Result<Content> contentOf(const gpu::Texture& texture, int level, std::optional<int> layer) {
    const gpu::TextureSize size = gpu::sizeOfLevel(texture.shape(), texture.size(), level);
    Content content;
    content.width = size.width;
    content.height = size.height;
    content.depth = texture.layers(level);
    const base::TexelFormatRow& row = base::rowOf(texture.format());
    content.components = base::hasDepth(texture.format()) ? 1 : row.components;
    content.step = stepOf(texture.format());
    const gpu::TexelType type = row.kind == base::TexelClass::integer           ? gpu::TexelType::i32
                                : row.kind == base::TexelClass::unsignedInteger ? gpu::TexelType::u32
                                                                                : gpu::TexelType::f32;
    const auto bytes = texture.read(level, content.components, type);
    if (!bytes) return bytes.diagnostics;
    std::span<const std::byte> wanted = *bytes;
    if (layer) {
        const std::size_t layerBytes = wanted.size() / static_cast<std::size_t>(content.depth);
        wanted = wanted.subspan(layerBytes * static_cast<std::size_t>(*layer), layerBytes);
        content.depth = 1;
    }
    content.values = type == gpu::TexelType::i32   ? doublesOf<std::int32_t>(wanted)
                     : type == gpu::TexelType::u32 ? doublesOf<std::uint32_t>(wanted)
                                                   : doublesOf<float>(wanted);
    return content;
}

Result<Content> contentOf(const scene::Scene& scene, DeviceScene& device, const scene::ObjectView& object) {
    if (const auto* texture = std::get_if<scene::TextureView>(&object))
        return textureContent(scene, device, *texture);
    return bufferContent(scene, device.buffers(), std::get<scene::BufferView>(object));
}

}  // namespace glibra::render
