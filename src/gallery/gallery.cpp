#include "gallery/gallery.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/text.h"
#include "glib/text.h"

namespace glibra::gallery {
namespace {

namespace fs = std::filesystem;

/// A name for files and links that every file system and browser takes as it is.
std::string plainName(const std::string& path) {
    constexpr std::size_t kLongest = 120;
    const std::string stem = fs::path(path).replace_extension().generic_string();
    std::string name;
    for (const char each : stem)
        name += glib::isLetter(each) || glib::isDigit(each) || each == '_' || (each == '.' && !name.empty())
                    ? each
                    : '-';
    return name.substr(0, kLongest);
}

}  // namespace

std::string folderOf(const GalleryScene& scene) {
    const std::string folder = fs::path(scene.path).parent_path().generic_string();
    return folder.empty() ? "." : folder;
}

void connect(Gallery& gallery) {
    std::set<std::string> taken;  // without case, for file systems that ignore it
    std::map<std::string, std::size_t> byPath;
    for (std::size_t i = 0; i < gallery.scenes.size(); ++i) {
        GalleryScene& scene = gallery.scenes[i];
        const std::string plain = plainName(scene.path);
        scene.name = plain;
        for (int number = 2; !taken.insert(glib::lower(scene.name)).second; ++number)
            scene.name = fmt::format("{}-{}", plain, number);
        byPath.emplace(scene.path, i);
    }
    for (std::size_t i = 0; i < gallery.scenes.size(); ++i) {
        GalleryScene& scene = gallery.scenes[i];
        const auto found = byPath.find(scene.description.solution);
        if (found == byPath.end() || found->second == i) continue;
        scene.solution = found->second;
        gallery.scenes[found->second].tasks.push_back(i);
    }
}

std::string summary(const Gallery& gallery) {
    const auto drawn = static_cast<std::size_t>(std::ranges::count_if(gallery.scenes, isDrawn));
    std::string text = fmt::format("{}: {} drawn", base::counted(gallery.scenes.size(), "scene"), drawn);
    if (drawn < gallery.scenes.size()) text += fmt::format(", {} not", gallery.scenes.size() - drawn);
    return text;
}

}  // namespace glibra::gallery
