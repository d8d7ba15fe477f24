#include "view/browse/example_scenes.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <ranges>
#include <system_error>
#include <tuple>

#include "glib/text.h"
#include "source/scene_head.h"

namespace glibra::view {

namespace fs = std::filesystem;

namespace {

bool endsWithOneOf(const fs::path& file, std::string_view endings) {
    const std::string own = file.extension().generic_string();
    return endings.empty() || std::ranges::any_of(std::views::split(endings, ' '), [&](const auto& each) {
               return glib::sameWord(own, std::string_view(each.begin(), each.end()));
           });
}

}  // namespace

FolderList listFolder(const fs::path& folder, std::string_view endings) {
    FolderList list;
    std::error_code failure;
    list.folder = fs::absolute(folder.empty() ? "." : folder, failure).lexically_normal();
    if (!list.folder.has_filename() && list.folder.has_relative_path())
        list.folder = list.folder.parent_path();
    fs::directory_iterator each(list.folder, fs::directory_options::none, failure);
    if (failure) {
        list.problem = "Cannot read this folder: " + failure.message() + ".";
        return list;
    }
    for (const fs::directory_iterator end; !failure && each != end; each.increment(failure)) {
        const std::string name = each->path().filename().generic_string();
        std::error_code unknown;
        if (name.starts_with('.')) continue;
        if (each->is_directory(unknown))
            list.entries.push_back({name, true});
        else if (each->is_regular_file(unknown) && endsWithOneOf(each->path(), endings))
            list.entries.push_back({name, false});
    }
    std::sort(list.entries.begin(), list.entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
        return std::tuple(!a.isFolder, glib::lower(a.name), a.name) <
               std::tuple(!b.isFolder, glib::lower(b.name), b.name);
    });
    return list;
}

namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

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
        if (!glib::sameWord(file.extension().generic_string(), ".glib") || !each->is_regular_file(unknown))
            continue;
        const fs::path topic = file.parent_path().lexically_relative(folder);
        scenes.push_back({file, topic == "." ? "" : topic.generic_string(), file.stem().generic_string(),
                          source::headOf(textOf(file)).summary,
                          sources[file.lexically_relative(folder).generic_string()]});
    }
    std::sort(scenes.begin(), scenes.end(), [](const ExampleScene& a, const ExampleScene& b) {
        return std::tuple(a.topic != "start", a.topic, a.name) <
               std::tuple(b.topic != "start", b.topic, b.name);
    });
    return scenes;
}

std::vector<std::string> chaptersOf(std::span<const ExampleScene> scenes) {
    std::vector<std::string> chapters;
    for (const ExampleScene& scene : scenes)
        for (std::string& each : source::chaptersIn(scene.source)) chapters.push_back(std::move(each));
    std::sort(chapters.begin(), chapters.end(), source::isBefore);
    chapters.erase(std::unique(chapters.begin(), chapters.end()), chapters.end());
    return chapters;
}

bool isOfChapter(const ExampleScene& scene, const std::string& chapter) {
    if (chapter.empty()) return true;
    const std::vector<std::string> own = source::chaptersIn(scene.source);
    return std::ranges::find(own, chapter) != own.end();
}

}  // namespace glibra::view
