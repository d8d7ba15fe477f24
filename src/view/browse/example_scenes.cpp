#include "view/browse/example_scenes.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string_view>
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

/// True for an exercise number: "SH030", "D09", "G14.7a", "Gx9.4".
bool isExercise(const std::string& word) {
    constexpr std::string_view kDigits = "0123456789";
    std::size_t at = 0;
    while (at < word.size() && word[at] >= 'A' && word[at] <= 'Z') ++at;
    if (at == 0 || at > 2) return false;
    if (word.substr(0, 2) == "Gx") at = 2;
    return at < word.size() && kDigits.find(word[at]) != std::string_view::npos &&
           std::all_of(
               word.begin() + static_cast<std::ptrdiff_t>(at), word.end(),
               [](char c) { return c == '.' || std::isalnum(static_cast<unsigned char>(c)) != 0; });
}

/// The last column of the table of scenes, by the file that its first column links to.
std::map<std::string, std::string> sourcesIn(const fs::path& page) {
    std::map<std::string, std::string> sources;
    std::ifstream file(page);
    for (std::string line; std::getline(file, line);) {
        // | [topic/name](topic/name.glib) | what it shows | source |
        const std::size_t link = line.find("](");
        const std::size_t end = line.find(')', link);
        const std::size_t last = line.size() < 4 ? std::string::npos : line.rfind(" | ", line.size() - 3);
        if (!line.starts_with("| [") || end == std::string::npos || last == std::string::npos || last < end)
            continue;
        const std::string source = line.substr(last + 3, line.size() - last - 5);
        if (source != "-") sources[line.substr(link + 2, end - link - 2)] = source;
    }
    return sources;
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

std::vector<ExampleScene> exampleScenes(const fs::path& root) {
    std::vector<ExampleScene> scenes;
    const fs::path folder = root / "glib";
    std::map<std::string, std::string> sources = sourcesIn(folder / "README.md");
    std::error_code failure;
    for (fs::recursive_directory_iterator
             each(folder, fs::directory_options::skip_permission_denied, failure),
         end;
         !failure && each != end; each.increment(failure)) {
        const fs::path& file = each->path();
        std::error_code unknown;
        if (!glib::sameWord(file.extension().string(), ".glib") || !each->is_regular_file(unknown)) continue;
        const fs::path topic = file.parent_path().lexically_relative(folder);
        scenes.push_back({file, topic == "." ? "" : topic.string(), file.stem().string(), summaryOf(file),
                          sources[file.lexically_relative(folder).generic_string()]});
    }
    std::sort(scenes.begin(), scenes.end(), [](const ExampleScene& a, const ExampleScene& b) {
        return std::tuple(a.topic != "start", a.topic, a.name) <
               std::tuple(b.topic != "start", b.topic, b.name);
    });
    return scenes;
}

}  // namespace glibra::view
