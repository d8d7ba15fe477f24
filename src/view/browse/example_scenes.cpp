#include "view/browse/example_scenes.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <system_error>
#include <tuple>

#include "glib/text.h"
#include "source/scene_head.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

bool isRoot(const fs::path& folder) {
    std::error_code failure;
    return fs::is_directory(folder / "glib", failure) && fs::is_directory(folder / "shaders", failure);
}

fs::path rootAbove(const fs::path& file) {
    std::error_code failure;
    fs::path folder = fs::absolute(file, failure).lexically_normal().parent_path();
    for (;; folder = folder.parent_path()) {
        if (isRoot(folder)) return folder;
        if (isRoot(folder / "share/glibra")) return folder / "share/glibra";
        if (!folder.has_relative_path()) return {};
    }
}

std::string textOf(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

fs::path exampleRoot(const std::vector<fs::path>& roots, const fs::path& scene, const fs::path& program) {
    for (const fs::path& each : roots)
        if (isRoot(each)) return each;
    for (const fs::path& each : {program, scene})
        if (!each.empty())
            if (fs::path root = rootAbove(each); !root.empty()) return root;
    return {};
}

fs::path programFile() {
    std::error_code failure;
    return fs::read_symlink("/proc/self/exe", failure);
}

bool isExample(const fs::path& file) {
    static const fs::path kRoot = rootAbove(programFile());
    if (kRoot.empty() || file.empty()) return false;
    std::error_code failure;
    const fs::path inside = fs::weakly_canonical(file, failure).lexically_relative(kRoot);
    const fs::path first = inside.empty() ? inside : *inside.begin();
    return first == "glib" || first == "shaders" || first == "textures" ||
           (first == "scenes" && *std::next(inside.begin()) == "models");
}

Diagnostics writingProblem(const fs::path& file) {
    if (!isExample(file)) return {};
    return {diagnose("view-E03", "the folders of the examples are not written to; choose another one")};
}

std::vector<ExampleScene> exampleScenes(const fs::path& root) {
    std::vector<ExampleScene> scenes;
    const fs::path folder = root / "glib";
    std::map<std::string, std::string> sources = source::chapterColumn(textOf(folder / "README.md"));
    std::error_code failure;
    for (fs::recursive_directory_iterator
             each(folder, fs::directory_options::skip_permission_denied, failure),
         end;
         !failure && each != end; each.increment(failure)) {
        const fs::path& file = each->path();
        std::error_code unknown;
        if (!glib::sameWord(file.extension().string(), ".glib") || !each->is_regular_file(unknown)) continue;
        const fs::path topic = file.parent_path().lexically_relative(folder);
        scenes.push_back({file, topic == "." ? "" : topic.string(), file.stem().string(),
                          source::headOf(textOf(file)).summary,
                          sources[file.lexically_relative(folder).generic_string()]});
    }
    std::sort(scenes.begin(), scenes.end(), [](const ExampleScene& a, const ExampleScene& b) {
        return std::tuple(a.topic != "start", a.topic, a.name) <
               std::tuple(b.topic != "start", b.topic, b.name);
    });
    return scenes;
}

}  // namespace glibra::view
