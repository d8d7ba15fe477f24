#pragma once
// Finds the files that a scene names (language, 8.6). Only ordinary files are found: folders, pipes and
// devices count as missing, and so does a file in a folder that cannot be read. No file is opened, and no
// function throws.

#include <glibra/render.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/contained.h"
#include "base/files.h"
#include "scene/objects.h"

namespace glibra::scene {

// ---- Folders

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

// ---- Files

/// The content of a file that the calling program has in memory, or null. May be empty.
using MemoryFiles = std::function<std::shared_ptr<const std::string>(const std::filesystem::path& path)>;

/// Both together: what `reader` has, else what `texts` has. `reader` may be null.
MemoryFiles memoryFiles(const std::map<std::filesystem::path, std::string>& texts,
                        const std::shared_ptr<const FileReader>& reader);

/// Folders that are searched after the scene's own (language, 8.6): normally those in GLIBRA_PATH.
struct InterpretOptions {
    std::vector<std::filesystem::path> libraryRoots;
    /// If it is not empty, only files below this folder and below the library folders are found.
    std::filesystem::path within{};
    MemoryFiles inMemory{};  ///< these files need not exist, and may lie outside of `within`
    bool runsAll = false;    ///< Interpretation::mistakesLeftOut
};

/// The folders that names are relative to, in the order of the search.
struct SearchFolders {
    std::vector<std::filesystem::path>
        beside;  ///< the folder of the including file (if any), then the scene's
    std::vector<std::filesystem::path>
        library;  ///< folders of the library roots: shaders/TOPIC, shaders, textures ...
    std::vector<std::filesystem::path> roots;  ///< for each of `library` the library root that it belongs to
    /// If given, the folders whose files may be read (InterpretOptions::within).
    std::optional<base::Roots> readable{};
    MemoryFiles inMemory{};  ///< InterpretOptions::inMemory

    /// The file at a path as it is in memory or on the disk; without a path if there is none.
    [[nodiscard]] base::FileSource sourceAt(const std::filesystem::path& path) const;
    [[nodiscard]] bool mayRead(const std::filesystem::path& file) const {
        return !readable || readable->contains(file);
    }
};

/// The nearest folder, from a whole path upwards, that has `shaders` or `textures`: the library of its
/// scenes, which may read its files although they lie outside of their folder. The search ends at `last`, if
/// that is not empty.
std::optional<std::filesystem::path> libraryAbove(const std::filesystem::path& folder,
                                                  const std::filesystem::path& last = {});

/// Returns the folders to search for a scene's files: the scene's own folder, the given library roots, then
/// libraryAbove(), with InterpretOptions::within only up to that folder. TOPIC is the path of the scene's
/// folder below `glib` of that root, or else the last part of that path. A relative `scenePath` starts at the
/// current folder.
SearchFolders searchFolders(const std::filesystem::path& scenePath, const InterpretOptions& options = {});

/// The folders whose files may be shown to others: the scene's own, and those of the library. A scene may
/// read other files, as "../a.frag" or "/usr/share/a.frag", but their text is not quoted in messages, reports
/// and translated shaders, because a scene of somebody else can name any file of this machine.
base::Roots shownRoots(const SearchFolders& folders);

/// How the text of a message about a place in a file that is not shown begins. The line is not quoted either.
inline constexpr std::string_view kHiddenText =
    "the text of this message is not shown, because it may quote ";
/// "'a.glib', which lies outside of the scene's folder and the library; add its folder to GLIBRA_PATH"
std::string whyHidden(const std::string& file);
/// Replaces the texts of messages about places in these files.
void hideTexts(Diagnostics& diagnostics, const std::set<std::string>& files);

/// Looks up a file. "a/../b" is looked up as "b". The result contains file-E01 if the file is
/// missing, with the names by which the library has it in other folders, or else the nearest existing names;
/// file-W01 if the case differs, file-W02 if only the last part of the name was found beside the scene,
/// file-W12 if several names differ only in case, and file-W13, once per scene, if the budget of `listings`
/// is spent: from then on names are found only as they are written, and messages name no others. A file that
/// must not be read (SearchFolders::readable) is file-E12 and has no path.
FileReference findFile(std::string_view name, const Place& place, const SearchFolders& folders,
                       FolderListings& listings);

/// The paths at which a file that is missing would be found as it is named.
std::vector<std::filesystem::path> placesOf(std::string_view name, const SearchFolders& folders);

/// The folders for a file that another file includes: searchFolders(), and the folder of that file first.
SearchFolders includeFolders(std::string_view includingPath, std::string_view scenePath,
                             const InterpretOptions& options);

/// Looks up a file for #include: like findFile, but first beside the including file.
FileReference findInclude(std::string_view name, std::string_view includingPath, std::string_view scenePath,
                          const InterpretOptions& options, FolderListings& listings);

}  // namespace glibra::scene
