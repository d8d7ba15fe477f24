#include "base/contained.h"

#include <algorithm>
#include <cerrno>
#include <new>
#include <system_error>
#include <utility>

#include "system/folder.h"

namespace glibra::base {
namespace {

namespace fs = std::filesystem;
using system::File;
using system::FolderUse;

/// The parts of a path that leads downwards; none if it does not.
std::vector<std::string> downwards(const fs::path& path) {
    std::vector<std::string> parts;
    if (path.is_absolute()) return {};
    for (const fs::path& each : path) {
        if (each == "..") return {};
        if (each.native().find('\0') != std::string::npos) return {};
        if (!each.empty() && each != ".") parts.push_back(each.generic_string());
    }
    return parts;
}

/// Goes down the folders of `parts`, all but the last. Each is opened from the one before, so that nobody can
/// put a link in between. errno says why there is no value.
File enter(const fs::path& root, const std::vector<std::string>& parts, bool make,
           FolderUse use = FolderUse::listed) {
    if (parts.empty()) {
        errno = EINVAL;
        return {};
    }
    std::error_code unmade;
    if (make && !root.empty()) fs::create_directories(root, unmade);
    File folder = system::openFolder(root, use);
    if (!folder && unmade) errno = unmade.value();
    for (std::size_t i = 0; folder && i + 1 < parts.size(); ++i) {
        const int problem = make ? makeFolderIn(folder, parts[i]) : 0;
        File next = openFolderIn(folder, parts[i], use);
        if (!next && problem != 0 && errno != ELOOP) errno = problem;
        folder = std::move(next);
    }
    return folder;
}

bool isHidden(const fs::path& path) {
    return std::any_of(path.begin(), path.end(),
                       [](const fs::path& part) { return part.native().starts_with('.'); });
}

}  // namespace

File openBeneath(const fs::path& root, const fs::path& path) {
    const std::vector<std::string> parts = downwards(path);
    const File folder = enter(root, parts, false, FolderUse::passed);
    return folder ? openFileIn(folder, parts.back()) : File();
}

int readAll(const File& file, std::uint64_t largest, std::vector<std::byte>& bytes) {
    system::FileFacts facts;
    if (const int problem = factsOf(file, facts); problem != 0) return problem;
    if (facts.size > largest) return EFBIG;
    try {
        bytes.resize(static_cast<std::size_t>(facts.size));
    } catch (const std::bad_alloc&) {
        return ENOMEM;
    }
    std::size_t count = 0;  // fewer if the file has become shorter meanwhile
    const int problem = readFull(file, bytes, count);
    if (problem == 0) bytes.resize(count);
    return problem;
}

int makeFoldersBeneath(const fs::path& root, const fs::path& path) {
    std::vector<std::string> parts = downwards(path);
    if (parts.empty() && !path.empty() && path != ".") return EINVAL;
    parts.emplace_back();  // the name of a file in the last folder
    return enter(root, parts, true) ? 0 : errno;
}

int writeBeneath(const fs::path& root, const fs::path& path, std::span<const std::byte> bytes) {
    const std::vector<std::string> parts = downwards(path);
    const File folder = enter(root, parts, true);
    return folder ? replaceIn(folder, parts.back(), bytes) : errno;
}

int prepareBeneath(const fs::path& root, const fs::path& path) {
    const std::vector<std::string> parts = downwards(path);
    const File folder = enter(root, parts, true);
    return folder ? clearNameIn(folder, parts.back()) : errno;
}

int removeBeneath(const fs::path& root, const fs::path& path) {
    const std::vector<std::string> parts = downwards(path);
    const File folder = enter(root, parts, false);
    return folder ? removeIn(folder, parts.back()) : errno;
}

void Roots::add(const fs::path& folder) {
    const auto put = [&](const fs::path& each) {
        if (std::find(folders_.begin(), folders_.end(), each) == folders_.end()) folders_.push_back(each);
    };
    std::error_code failed;
    const fs::path resolved = fs::canonical(folder.empty() ? "." : folder, failed);
    if (failed || !fs::is_directory(resolved, failed)) return;
    put(resolved);
    fs::path named = fs::absolute(folder, failed).lexically_normal();
    if (!named.has_filename()) named = named.parent_path();
    if (!failed) put(named);
}

void Roots::addBelow(const fs::path& root, const fs::path& folder) {
    Roots outer;
    outer.add(root);
    if (outer.contains(folder)) add(folder);
}

bool Roots::contains(const fs::path& file) const {
    std::error_code failed;
    const fs::path resolved = fs::canonical(file, failed);
    if (failed) return false;
    return std::any_of(folders_.begin(), folders_.end(), [&](const fs::path& root) {
        const fs::path inside = resolved.lexically_relative(root);
        return !inside.empty() && !isHidden(inside);  // "." and ".." begin with a dot too
    });
}

File Roots::open(const fs::path& file) const {
    std::error_code failed;
    const fs::path named = fs::absolute(file, failed).lexically_normal();
    int problem = EACCES;
    for (const fs::path& root : folders_) {
        const fs::path inside = named.lexically_relative(root);
        if (failed || inside.empty() || isHidden(inside)) continue;
        if (File opened = openBeneath(root, inside)) return opened;
        problem = errno;
    }
    errno = problem;
    return {};
}

}  // namespace glibra::base
