#include "view/edit/source_files.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <system_error>

namespace glibra::view {
namespace {

SourceFile* find(std::vector<SourceFile>& files, const std::filesystem::path& path) {
    const auto found = std::ranges::find(files, path, &SourceFile::path);
    return found == files.end() ? nullptr : &*found;
}

namespace fs = std::filesystem;

/// The last parts of a path.
fs::path tailOf(const fs::path& file, std::size_t count) {
    const std::vector<fs::path> parts(file.begin(), file.end());
    fs::path tail;
    for (std::size_t i = parts.size() - std::min(count, parts.size()); i < parts.size(); ++i)
        tail /= parts[i];
    return tail;
}

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

std::vector<SourceFile> sourceFiles(const render::LiveScene& live) {
    const scene::Scene& scene = live.scene();
    std::vector<SourceFile> files{{scene.path, {}, "scene"}};
    std::set<std::filesystem::path> data;
    for (const scene::FileReference& each : scene.files) data.insert(each.path);
    for (std::size_t i = 0; i < std::size_t{glsl::kStageCount}; ++i)
        for (const scene::Program& program : scene.programs)
            for (const scene::StageFile& each : program.stages) {
                const std::filesystem::path& path = scene.files[each.file].path;
                if (each.stage != static_cast<glsl::Stage>(i) || path.empty()) continue;
                const std::string role = std::string(glsl::stageName(each.stage)) + " shader of ";
                SourceFile* known = find(files, path);
                if (!known)
                    files.push_back({path, {}, role + program.name});
                else if (known->role.starts_with(role))
                    known->role += ", " + program.name;
                else
                    known->role += "; " + role + program.name;
            }
    for (const std::filesystem::path& each : live.files())
        if (!data.contains(each) && !find(files, each)) files.push_back({each, {}, "included"});
    std::vector<std::filesystem::path> paths;
    for (const SourceFile& each : files) paths.push_back(each.path);
    const std::vector<std::string> names = namesApart(paths);
    for (std::size_t i = 0; i < files.size(); ++i) files[i].label = names[i];
    return files;
}

std::vector<std::string> namesApart(std::span<const fs::path> files) {
    std::vector<std::string> names;
    for (const fs::path& file : files) {
        std::size_t count = 1;
        const auto isTaken = [&](const fs::path& other) {
            return other != file && tailOf(other, count) == tailOf(file, count);
        };
        while (tailOf(file, count) != file && std::any_of(files.begin(), files.end(), isTaken)) ++count;
        names.push_back(tailOf(file, count).generic_string());
    }
    return names;
}

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
