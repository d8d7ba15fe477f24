#include "view/browse/file_use.h"

#include <algorithm>
#include <system_error>

#include "view/edit/source_files.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

bool isMadeOf(const scene::Texture& texture, int file) {
    if (const auto* noise = std::get_if<scene::NoiseSource>(&texture.source)) return noise->file == file;
    const auto* picture = std::get_if<scene::PictureSource>(&texture.source);
    return picture != nullptr &&
           std::find(picture->files.begin(), picture->files.end(), file) != picture->files.end();
}

bool isSame(const fs::path& a, const fs::path& b) {
    std::error_code failure;
    return !a.empty() && fs::equivalent(a, b, failure);
}

}  // namespace

FileUse useOf(const LiveScene& live, const fs::path& file) {
    for (const SourceFile& each : sourceFiles(live))
        if (isSame(each.path, file)) return {FileUse::Kind::text, scene::kNone, {each.path.string(), 1, 1}};
    const scene::Scene& scene = live.scene();
    FileUse use;
    for (std::size_t i = 0; i < scene.files.size(); ++i) {
        if (!isSame(scene.files[i].path, file)) continue;
        use = {FileUse::Kind::data, scene::kNone, scene.files[i].place};
        for (std::size_t texture = 0; texture < scene.textures.size(); ++texture) {
            const auto number = static_cast<int>(texture);
            if (isMadeOf(scene.textures[texture], static_cast<int>(i)) && live.texture(number))
                return {FileUse::Kind::texture, number, scene.textures[texture].place};
        }
    }
    return use;
}

}  // namespace glibra::view
