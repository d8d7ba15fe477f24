#include "scene/folder_listings.h"

#include <algorithm>
#include <system_error>

#include "base/suggest.h"
#include "base/text.h"

namespace glibra::scene {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kEntryWork = 1'000;  ///< for reading one entry of a folder

}  // namespace

bool isOrdinaryFile(const fs::path& path) {
    std::error_code failure;
    return fs::is_regular_file(path, failure);
}

bool FolderListings::spend(std::size_t work) {
    budget_ -= std::min(work, budget_);
    return budget_ > 0;
}

FolderListings::Listing& FolderListings::listing(const fs::path& folder) {
    const auto known = listings_.find(folder.generic_string());
    if (known != listings_.end()) return known->second;
    if (!spend(kPathWork)) return nothing_;
    Listing& listing = listings_[folder.generic_string()];
    std::error_code failure;
    fs::directory_iterator each(folder.empty() ? fs::path(".") : folder, failure);
    for (; !failure && each != fs::directory_iterator() && listing.names.size() < kLargestFolder;
         each.increment(failure)) {
        if (!spend(kEntryWork)) break;
        listing.names.push_back(each->path().filename().generic_string());
    }
    std::ranges::sort(listing.names);
    return listing;
}

const std::vector<std::string>& FolderListings::names(const fs::path& folder) {
    return listing(folder).names;
}

std::vector<std::string> FolderListings::namesWithoutCase(const fs::path& folder, std::string_view name) {
    Listing& found = listing(folder);
    if (found.byLowerCase.size() != found.names.size()) {
        for (std::size_t i = 0; i < found.names.size(); ++i)
            found.byLowerCase.emplace_back(base::lower(found.names[i]), i);
        std::ranges::sort(found.byLowerCase);
    }
    const std::string lower = base::lower(name);
    std::vector<std::string> names;
    for (auto each = std::ranges::lower_bound(found.byLowerCase, std::pair(lower, std::size_t{0}));
         each != found.byLowerCase.end() && each->first == lower; ++each)
        names.push_back(found.names[each->second]);
    return names;
}

std::vector<std::string> nearestFiles(std::string_view name, std::span<const fs::path> folders,
                                      FolderListings& listings) {
    constexpr std::size_t kMostNames = 3;
    constexpr std::size_t kLongestEntry = 255;
    if (name.empty() || name.size() > kLongestEntry) return {};

    struct Candidate {
        std::size_t distance;
        fs::path path;
    };
    std::vector<Candidate> candidates;
    const std::size_t most = std::max<std::size_t>(2, name.size() / 3);
    for (const fs::path& folder : folders)
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
    std::ranges::stable_sort(candidates,
                             [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
    std::vector<std::string> names;
    for (const Candidate& each : candidates) {
        std::string text = each.path.filename().generic_string();
        if (std::ranges::find(names, text) != names.end() || !isOrdinaryFile(each.path)) continue;
        names.push_back(std::move(text));
        if (names.size() == kMostNames) break;
    }
    return names;
}

}  // namespace glibra::scene
