#include "view/edit/source_files.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "view/edit/names_apart.h"

namespace glibra::view {
namespace {

/// In the order of glsl::Stage.
constexpr std::array<const char*, glsl::kStageCount> kStageWords{
    "vertex", "tessellation control", "tessellation evaluation", "geometry", "fragment", "compute"};

SourceFile* find(std::vector<SourceFile>& files, const std::filesystem::path& path) {
    const auto found = std::ranges::find(files, path, &SourceFile::path);
    return found == files.end() ? nullptr : &*found;
}

}  // namespace

std::vector<SourceFile> sourceFiles(const render::LiveScene& live) {
    const scene::Scene& scene = live.scene();
    std::vector<SourceFile> files{{scene.path, {}, "scene"}};
    std::set<std::filesystem::path> data;
    for (const scene::FileReference& each : scene.files) data.insert(each.path);
    for (std::size_t i = 0; i < kStageWords.size(); ++i)
        for (const scene::Program& program : scene.programs)
            for (const scene::StageFile& each : program.stages) {
                const std::filesystem::path& path = scene.files[each.file].path;
                if (each.stage != static_cast<glsl::Stage>(i) || path.empty()) continue;
                const std::string role = std::string(kStageWords.at(i)) + " shader of ";
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

}  // namespace glibra::view
