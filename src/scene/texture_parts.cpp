#include "scene/texture_parts.h"

#include <algorithm>
#include <bit>
#include <iterator>

namespace glibra::scene {

bool isArray(TextureTarget target) {
    return target == TextureTarget::texture1DArray || target == TextureTarget::texture2DArray ||
           target == TextureTarget::cubeArray;
}

std::size_t sideCount(TextureTarget target) {
    if (target == TextureTarget::texture1D || target == TextureTarget::texture1DArray) return 1;
    return target == TextureTarget::texture3D ? 3 : 2;
}

std::optional<int> levelsOf(const Texture& texture) {
    const auto* empty = std::get_if<EmptySource>(&texture.source);
    if (empty == nullptr) {
        if (texture.hasMipmaps) return std::nullopt;
        return 1;
    }
    // A texture with mipmaps has all of them, unless the scene says how many.
    const int wanted = texture.hasMipmaps && texture.levels == 1 ? 0 : texture.levels;
    if (wanted > 0) return wanted;
    const int depth = texture.target == TextureTarget::texture3D ? empty->depth : 1;
    const int height = sideCount(texture.target) > 1 ? empty->height : 1;
    return static_cast<int>(
        std::bit_width(static_cast<unsigned>(std::max({1, empty->width, height, depth}))));
}

std::optional<std::array<int, 3>> sizeOfLevel(const Texture& texture, int level) {
    const auto* empty = std::get_if<EmptySource>(&texture.source);
    if (empty == nullptr) return std::nullopt;
    const auto smaller = [&](int side) { return std::max(1, side >> std::clamp(level, 0, 30)); };
    std::array<int, 3> size{smaller(empty->width), smaller(empty->height), 1};
    if (sideCount(texture.target) == 1) size[1] = 1;
    if (texture.target == TextureTarget::cube) size[2] = 6;
    if (isArray(texture.target)) size[2] = std::max(1, empty->depth);
    if (texture.target == TextureTarget::texture3D) size[2] = smaller(empty->depth);
    return size;
}

std::optional<int> layersOf(const Texture& texture, int level) {
    if (const auto size = sizeOfLevel(texture, level)) return (*size)[2];
    if (texture.target == TextureTarget::cube) return 6;
    const auto* picture = std::get_if<PictureSource>(&texture.source);
    if (picture == nullptr || picture->files.size() < 2) return std::nullopt;
    return static_cast<int>(picture->files.size());
}

std::optional<std::array<int, 2>> targetSize(const Scene& scene, const Pass& pass) {
    if (pass.isWindow) return std::nullopt;
    TextureIndex texture;
    int level = 0;
    if (!pass.targets.empty()) {
        texture = pass.targets.front();
        if (!pass.parts.empty()) level = pass.parts.front().level.value_or(0);
    } else if (pass.depth) {
        texture = pass.depth->texture;
        level = pass.depth->level.value_or(0);
    }
    if (!texture) return std::nullopt;
    const auto size = sizeOfLevel(scene.textures[texture], level);
    if (!size) return std::nullopt;
    return std::array{(*size)[0], (*size)[1]};
}

std::optional<int> faceNamed(std::string_view word) {
    static constexpr std::string_view kFaces[] = {"+x", "-x", "+y", "-y", "+z", "-z"};
    const auto* const found = std::ranges::find(kFaces, word);
    if (found == std::end(kFaces)) return std::nullopt;
    return static_cast<int>(found - std::begin(kFaces));
}

std::string_view wordOf(TextureTarget target) {
    switch (target) {
        case TextureTarget::texture1D:
            return "1D";
        case TextureTarget::texture2D:
            return "2D";
        case TextureTarget::texture3D:
            return "3D";
        case TextureTarget::cube:
            return "cube";
        case TextureTarget::cubeArray:
            return "cubeArray";
        case TextureTarget::rectangle:
            return "rectangle";
        case TextureTarget::texture1DArray:
            return "1DArray";
        case TextureTarget::texture2DArray:
            break;
    }
    return "2DArray";
}

}  // namespace glibra::scene
