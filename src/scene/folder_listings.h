#pragma once
// The names in folders, and the files whose names come closest to one that does not exist. No file is opened,
// and no function throws.

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glibra::scene {

/// True if the path leads to an ordinary file. Links are followed.
bool isOrdinaryFile(const std::filesystem::path& path);

/// A cache of folder listings, with a budget of work. Use one for all look-ups of a scene: a scene of
/// somebody else may name so many files that comparing their names with those of large folders would take
/// minutes.
class FolderListings {
  public:
    /// The names in the folder ("" is the current one) in byte order, kLargestFolder at most; none if it
    /// cannot be read or the budget is spent.
    const std::vector<std::string>& names(const std::filesystem::path& folder);
    /// Those names that equal `name` except for case, in byte order.
    std::vector<std::string> namesWithoutCase(const std::filesystem::path& folder, std::string_view name);

    /// Takes units of work from the budget, about a nanosecond each. False once it is spent.
    bool spend(std::size_t work);
    [[nodiscard]] bool isSpent() const { return budget_ == 0; }
    /// True at the first call after the budget was spent, for one message about it.
    bool reportsSpent() { return isSpent() && !std::exchange(reported_, true); }

    static constexpr std::size_t kLargestFolder = 65'536;
    static constexpr std::size_t kBudget = 500'000'000;
    static constexpr std::size_t kPathWork = 5'000;  ///< for asking the system about a path

  private:
    struct Listing {
        std::vector<std::string> names;
        std::vector<std::pair<std::string, std::size_t>> byLowerCase;  ///< sorted; the index is in `names`
    };
    Listing& listing(const std::filesystem::path& folder);

    std::map<std::string, Listing> listings_;
    Listing nothing_;
    std::size_t budget_ = kBudget;
    bool reported_ = false;
};

/// Returns up to three names of ordinary files in these folders, nearest first by base::editDistance. Equal
/// distances are ordered by folder, then by bytes. A name is near if at most a third of it differs, or two
/// bytes.
std::vector<std::string> nearestFiles(std::string_view name, std::span<const std::filesystem::path> folders,
                                      FolderListings& listings);

}  // namespace glibra::scene
