#include "render/load/shared_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <span>
#include <system_error>
#include <variant>
#include <vector>

#include "base/hash.h"
#include "geometry/mesh.h"
#include "scene/scene.h"

namespace glibra::render {
namespace {

template <std::size_t Components>
VertexBox boundsOfValues(const std::vector<float>& values) {
    constexpr float kMost = std::numeric_limits<float>::infinity();
    std::array<float, 4> low{kMost, kMost, kMost, kMost};
    std::array<float, 4> high{-kMost, -kMost, -kMost, -kMost};
    std::array<float, Components> zero{};  // becomes NaN where a value is not finite
    for (std::size_t i = 0; i + Components <= values.size(); i += Components)
        for (std::size_t k = 0; k < Components; ++k) {
            const float value = values[i + k];
            low[k] = value < low[k] ? value : low[k];
            high[k] = value > high[k] ? value : high[k];
            zero[k] += value * 0;
        }
    if constexpr (Components == 3) low[3] = high[3] = 1;
    VertexBox bounds;
    for (std::size_t k = 0; k < 4; ++k) {
        bounds.low[static_cast<int>(k)] = static_cast<double>(low[k]);
        bounds.high[static_cast<int>(k)] = static_cast<double>(high[k]);
    }
    bounds.isKnown = std::ranges::none_of(zero, [](float each) { return std::isnan(each); });
    return bounds;
}

}  // namespace

VertexBox boundsOf(const geometry::Mesh& mesh) {
    const geometry::Attribute* position = mesh.attribute(geometry::kPosition);
    if (position == nullptr || position->values.empty()) return {};
    switch (position->components) {
        case 3:
            return boundsOfValues<3>(position->values);
        case 4:
            return boundsOfValues<4>(position->values);
        default:
            return {};
    }
}

namespace {

std::string stampOf(const scene::Scene& scene, scene::FileIndex file) {
    if (!file) return "-";
    const std::filesystem::path& path = scene.files[file].path;
    if (const auto& content = scene.files[file].content) {
        const base::Hash hash = base::hashOf({std::as_bytes(std::span(*content))});
        return fmt::format("|{}|{:x}{:016x}", path.generic_string(), hash.high, hash.low);
    }
    std::error_code failure;
    const auto size = std::filesystem::file_size(path, failure);
    const auto changed = std::filesystem::last_write_time(path, failure).time_since_epoch().count();
    return fmt::format("|{}|{}|{}", path.generic_string(), failure ? 0 : size, failure ? 0 : changed);
}

}  // namespace

std::string reuseKey(const scene::Scene& scene, const scene::Shape& shape) {
    if (shape.list) return {};
    std::string key = fmt::format("{}", static_cast<int>(shape.command));
    for (const double each : shape.numbers) key += fmt::format(" {}", each);
    return key + stampOf(scene, shape.file);
}

std::string reuseKey(const scene::Scene& scene, const scene::Texture& texture) {
    std::string key = fmt::format("{}", static_cast<int>(texture.target));
    if (const auto* picture = std::get_if<scene::PictureSource>(&texture.source)) {
        for (const scene::FileIndex each : picture->files) key += stampOf(scene, each);
        if (texture.isFlipped) key += " flip";
        if (texture.isSrgb) key += " srgb";
        if (texture.hasMipmaps) key += " mipmaps";
        return key;
    }
    if (const auto* noise = std::get_if<scene::NoiseSource>(&texture.source))
        return fmt::format("{} noise {} {} {}{}", key, noise->dimensions, noise->size,
                           static_cast<int>(noise->texels), stampOf(scene, noise->file));
    return {};
}

}  // namespace glibra::render
