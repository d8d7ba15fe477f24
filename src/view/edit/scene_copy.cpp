#include "view/edit/scene_copy.h"

#include <algorithm>
#include <span>
#include <system_error>
#include <utility>

#include "image/file.h"
#include "scene/file_lookup.h"
#include "system/folder.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

bool isSameFile(const fs::path& a, const fs::path& b) {
    std::error_code failure;
    return a == b || fs::equivalent(a, b, failure);
}

/// The path relative to the folder; empty if it is not below it.
fs::path below(const fs::path& file, const fs::path& folder) {
    const fs::path inside = system::wholePath(file).lexically_relative(system::wholePath(folder));
    return inside.empty() || *inside.begin() == ".." ? fs::path() : inside;
}

/// The place of a file beside the copy, if a name in the scene leads to it.
fs::path placeByName(const scene::Scene& scene, const fs::path& file, const fs::path& folder) {
    for (const scene::FileReference& each : scene.files) {
        if (each.path.empty() || !isSameFile(each.path, file)) continue;
        std::string name = each.name;
        std::replace(name.begin(), name.end(), '\\', '/');
        const fs::path path = fs::path(name).lexically_normal();
        if (path.is_relative() && !path.empty() && *path.begin() != "..") return folder / path;
    }
    return {};
}

/// The place of an included file: relative to a copied file as the original is to that one.
fs::path placeByInclude(const std::vector<CopiedFile>& known, const fs::path& file) {
    for (const CopiedFile& each : known)
        if (const fs::path inside = below(file, each.from.parent_path()); !inside.empty())
            return each.to.parent_path() / inside;
    return {};
}

/// True if the copy finds the file by the scene's own name for it.
bool isFound(const scene::Scene& scene, const fs::path& file, const scene::SearchFolders& folders) {
    return std::any_of(scene.files.begin(), scene.files.end(), [&](const scene::FileReference& each) {
        if (each.path.empty() || !isSameFile(each.path, file)) return false;
        scene::FolderListings listings;
        return isSameFile(scene::findFile(each.name, each.place, folders, listings).path, file);
    });
}

Result<std::vector<std::byte>> bytesOf(const fs::path& file) {
    std::error_code failure;
    if (fs::is_regular_file(file, failure) && fs::is_empty(file, failure)) return std::vector<std::byte>();
    return image::readFile(file, {file.generic_string(), {}});
}

}  // namespace

std::vector<CopiedFile> filesOfCopy(const render::LiveScene& live, const fs::path& target, bool all,
                                    const std::vector<fs::path>& libraryRoots) {
    const scene::Scene& scene = live.scene();
    const fs::path from = system::wholePath(scene.path).parent_path();
    const fs::path to = system::wholePath(target).parent_path();
    if (from == to) return {};
    const scene::SearchFolders folders =
        scene::searchFolders(system::wholePath(target), {.libraryRoots = libraryRoots});
    std::vector<CopiedFile> copied;
    std::vector<fs::path> included;
    for (const fs::path& file : live.files()) {
        if (isSameFile(file, scene.path) || (!all && isFound(scene, file, folders))) continue;
        fs::path place = placeByName(scene, file, to);
        if (const fs::path inside = below(file, from); place.empty() && !inside.empty()) place = to / inside;
        if (place.empty())
            included.push_back(file);
        else
            copied.push_back({file, place});
    }
    for (const fs::path& file : included) {
        const fs::path place = placeByInclude(copied, file);
        copied.push_back({file, place.empty() ? to / file.filename() : place});
    }
    return copied;
}

Diagnostics writeCopy(std::string_view text, const fs::path& target, const std::vector<CopiedFile>& files) {
    std::vector<std::pair<fs::path, std::vector<std::byte>>> wanted;
    for (const CopiedFile& each : files) {
        Result<std::vector<std::byte>> content = bytesOf(each.from);
        if (!content) return content.diagnostics;
        std::error_code failure;
        if (fs::exists(each.to, failure)) {
            const Result<std::vector<std::byte>> there = bytesOf(each.to);
            if (there && *there == *content) continue;
            return {image::cannotWrite(each.to, "another file has this name; choose an empty folder")};
        }
        wanted.emplace_back(each.to, std::move(*content));
    }
    std::error_code failure;
    fs::create_directories(system::wholePath(target).parent_path(), failure);
    for (const auto& [file, content] : wanted) {
        fs::create_directories(file.parent_path(), failure);
        if (Diagnostics problems = image::writeFileAtomically(file, content, image::NamedBy::program);
            !problems.empty())
            return problems;
    }
    return image::writeFileAtomically(target, std::as_bytes(std::span(text)));
}

}  // namespace glibra::view
