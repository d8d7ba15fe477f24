#include "render/load/reuse.h"

#include <fmt/format.h>

#include <filesystem>
#include <span>
#include <system_error>
#include <variant>

#include "base/hash.h"

namespace glibra::render {
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
