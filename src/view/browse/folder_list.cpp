#include "view/browse/folder_list.h"

#include <algorithm>
#include <ranges>
#include <system_error>
#include <tuple>

#include "glib/text.h"

namespace glibra::view {

namespace fs = std::filesystem;

namespace {

bool endsWithOneOf(const fs::path& file, std::string_view endings) {
    const std::string own = file.extension().string();
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
        const std::string name = each->path().filename().string();
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

}  // namespace glibra::view
