#include "view/browse/example_scenes.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <system_error>
#include <tuple>

#include "glib/text.h"

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

/// True for an exercise number: "SH030", "D09", "GX03".
bool isExercise(const std::string& word) {
    std::size_t at = 0;
    while (at < word.size() && word[at] >= 'A' && word[at] <= 'Z') ++at;
    return at > 0 && at < word.size() &&
           std::all_of(word.begin() + static_cast<std::ptrdiff_t>(at), word.end(),
                       [](char c) { return c >= '0' && c <= '9'; });
}

std::string summaryOf(const fs::path& scene) {
    std::ifstream file(scene);
    std::string line;
    std::getline(file, line);
    if (!line.starts_with('#')) return {};
    std::istringstream words(line.substr(1));
    std::string summary;
    for (std::string word; words >> word;)
        if (!summary.empty() || !isExercise(word)) summary += (summary.empty() ? "" : " ") + word;
    return summary;
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

std::vector<ExampleScene> exampleScenes(const fs::path& root) {
    std::vector<ExampleScene> scenes;
    const fs::path folder = root / "glib";
    std::error_code failure;
    for (fs::recursive_directory_iterator
             each(folder, fs::directory_options::skip_permission_denied, failure),
         end;
         !failure && each != end; each.increment(failure)) {
        const fs::path& file = each->path();
        std::error_code unknown;
        if (!glib::sameWord(file.extension().string(), ".glib") || !each->is_regular_file(unknown)) continue;
        const fs::path topic = file.parent_path().lexically_relative(folder);
        scenes.push_back({file, topic == "." ? "" : topic.string(), file.stem().string(), summaryOf(file)});
    }
    std::sort(scenes.begin(), scenes.end(), [](const ExampleScene& a, const ExampleScene& b) {
        return std::tuple(a.topic != "start", a.topic, a.name) <
               std::tuple(b.topic != "start", b.topic, b.name);
    });
    return scenes;
}

}  // namespace glibra::view
