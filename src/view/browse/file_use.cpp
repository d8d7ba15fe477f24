#include "view/browse/file_use.h"

#include <algorithm>
#include <system_error>

#include "view/edit/source_files.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

bool isMadeOf(const scene::Texture& texture, scene::FileIndex file) {
    if (const auto* noise = std::get_if<scene::NoiseSource>(&texture.source)) return noise->file == file;
    const auto* picture = std::get_if<scene::PictureSource>(&texture.source);
    return picture != nullptr && std::ranges::find(picture->files, file) != picture->files.end();
}

bool isEquivalent(const fs::path& a, const fs::path& b) {
    std::error_code failure;
    return !a.empty() && fs::equivalent(a, b, failure);
}

}  // namespace

FileUse useOf(const render::LiveScene& live, const fs::path& file) {
    for (const SourceFile& each : sourceFiles(live))
        if (isEquivalent(each.path, file))
            return {FileUse::Kind::text, {}, {each.path.generic_string(), 1, 1}};
    const scene::Scene& scene = live.scene();
    FileUse use;
    for (const scene::FileIndex i : scene.files.indices()) {
        if (!isEquivalent(scene.files[i].path, file)) continue;
        use = {FileUse::Kind::data, {}, scene.files[i].place};
        for (const scene::TextureIndex texture : scene.textures.indices())
            if (isMadeOf(scene.textures[texture], i) && live.texture(texture))
                return {FileUse::Kind::texture, texture, scene.textures[texture].place};
    }
    return use;
}

}  // namespace glibra::view
