#include "render/file/scene_inputs.h"

#include <set>
#include <string>
#include <utility>

#include "image/file.h"
#include "render/draw/frame.h"
#include "render/scene_renderer.h"
#include "render/stats.h"

namespace glibra::render {

namespace fs = std::filesystem;

std::vector<fs::path> includedFiles(std::string_view text, const fs::path& file, const scene::Scene& scene,
                                    const RenderOptions& options, scene::FolderListings& listings) {
    constexpr std::string_view kInclude = "#include";
    std::vector<fs::path> files;
    for (std::size_t at = text.find(kInclude); at != std::string_view::npos;
         at = text.find(kInclude, at + 1)) {
        const std::string_view rest = text.substr(at, text.find('\n', at) - at);
        const std::size_t begin = rest.find_first_of("\"<");
        if (begin == std::string_view::npos) continue;
        const std::size_t end = rest.find_first_of("\">", begin + 1);
        if (end == std::string_view::npos) continue;
        scene::FileReference found =
            scene::findInclude(rest.substr(begin + 1, end - begin - 1), file.string(), scene.path,
                               {options.libraryRoots, options.within}, listings);
        if (!found.path.empty()) files.push_back(std::move(found.path));
    }
    return files;
}

std::vector<fs::path> filesReadBy(const fs::path& path, const RenderOptions& options) {
    std::set<fs::path> files;
    if (!options.sceneText) files.insert(path);
    Stats stats;
    const Result<InterpretedScene> interpreted = interpretFile(path, options, stats);
    if (!interpreted) return {files.begin(), files.end()};
    const scene::Scene& scene = interpreted->scene;
    if (interpreted->source)
        for (const glib::Script* each : interpreted->source->scripts())
            if (each->path != path) files.insert(each->path);
    scene::FolderListings listings;
    std::vector<std::pair<fs::path, std::string>> open;  // shaders whose text is to be searched
    const auto addShader = [&](const fs::path& file) {
        if (file.empty() || !files.insert(file).second) return;
        const auto bytes = image::readFile(file, {file.string(), {}}, kLargestSource);
        if (bytes)
            open.emplace_back(file, std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()));
    };
    for (const scene::Program& program : scene.programs)
        for (const scene::StageFile& each : program.stages) {
            const scene::FileReference& file = scene.files[each.file];
            if (file.text)
                open.emplace_back(file.path, *file.text);
            else
                addShader(file.path);
        }
    while (!open.empty()) {
        const auto [file, text] = std::move(open.back());
        open.pop_back();
        for (const fs::path& each : includedFiles(text, file, scene, options, listings)) addShader(each);
    }
    for (const scene::FileReference& each : scene.files)
        if (!each.path.empty()) files.insert(each.path);
    return {files.begin(), files.end()};
}

}  // namespace glibra::render
