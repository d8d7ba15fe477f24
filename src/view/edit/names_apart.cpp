#include "view/edit/names_apart.h"

#include <algorithm>

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

/// The last parts of a path.
fs::path tailOf(const fs::path& file, std::size_t count) {
    const std::vector<fs::path> parts(file.begin(), file.end());
    fs::path tail;
    for (std::size_t i = parts.size() - std::min(count, parts.size()); i < parts.size(); ++i)
        tail /= parts[i];
    return tail;
}

}  // namespace

std::vector<std::string> namesApart(std::span<const fs::path> files) {
    std::vector<std::string> names;
    for (const fs::path& file : files) {
        std::size_t count = 1;
        const auto isTaken = [&](const fs::path& other) {
            return other != file && tailOf(other, count) == tailOf(file, count);
        };
        while (tailOf(file, count) != file && std::any_of(files.begin(), files.end(), isTaken)) ++count;
        names.push_back(tailOf(file, count).generic_string());
    }
    return names;
}

}  // namespace glibra::view
