#include "view/edit/source_files.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "view/edit/names_apart.h"

namespace glibra::view {
namespace {

const char* stageWord(glsl::Stage stage) {
    switch (stage) {
        case glsl::Stage::vertex:
            return "vertex";
        case glsl::Stage::tessControl:
            return "tessellation control";
        case glsl::Stage::tessEvaluation:
            return "tessellation evaluation";
        case glsl::Stage::geometry:
            return "geometry";
        case glsl::Stage::compute:
            return "compute";
        case glsl::Stage::fragment:
            break;
    }
    return "fragment";
}

SourceFile* find(std::vector<SourceFile>& files, const std::filesystem::path& path) {
    const auto found =
        std::find_if(files.begin(), files.end(), [&](const SourceFile& each) { return each.path == path; });
    return found == files.end() ? nullptr : &*found;
}

}  // namespace

std::vector<SourceFile> sourceFiles(const LiveScene& live) {
    const scene::Scene& scene = live.scene();
    std::vector<SourceFile> files{{scene.path, {}, "scene"}};
    std::set<std::filesystem::path> data;
    for (const scene::FileReference& each : scene.files) data.insert(each.path);
    for (int i = 0; i < glsl::kStageCount; ++i)
        for (const scene::Program& program : scene.programs)
            for (const scene::StageFile& each : program.stages) {
                const std::filesystem::path& path = scene.files[each.file].path;
                if (each.stage != static_cast<glsl::Stage>(i) || path.empty()) continue;
                const std::string role = stageWord(each.stage) + std::string(" shader of ");
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
