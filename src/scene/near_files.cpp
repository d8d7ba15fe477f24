#include "scene/near_files.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/suggest.h"

namespace glibra::scene {

std::vector<std::string> nearestFiles(std::string_view name, std::span<const std::filesystem::path> folders,
                                      FolderListings& listings) {
    constexpr std::size_t kMostNames = 3;
    constexpr std::size_t kLongestName = 255;
    if (name.empty() || name.size() > kLongestName) return {};

    struct Candidate {
        std::size_t distance;
        std::filesystem::path path;
    };
    std::vector<Candidate> candidates;
    const std::size_t most = std::max<std::size_t>(2, name.size() / 3);
    for (const std::filesystem::path& folder : folders)
        for (const std::string& each : listings.names(folder)) {
            if (!listings.spend(2)) return {};
            const std::size_t difference =
                std::max(name.size(), each.size()) - std::min(name.size(), each.size());
            if (difference > most) continue;
            if (!listings.spend(20 + 3 * name.size() * each.size())) return {};
            const std::size_t distance = base::editDistance(name, each);
            if (distance <= most && distance < each.size() && listings.spend(500))
                candidates.push_back({distance, folder / each});
        }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
    std::vector<std::string> names;
    for (const Candidate& each : candidates) {
        std::string text = each.path.filename().string();
        if (std::find(names.begin(), names.end(), text) != names.end() || !isOrdinaryFile(each.path))
            continue;
        names.push_back(std::move(text));
        if (names.size() == kMostNames) break;
    }
    return names;
}

}  // namespace glibra::scene
