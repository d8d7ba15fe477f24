#include "scene/file_lookup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <system_error>

#include "base/suggest.h"
#include "base/text.h"
#include "system/folder.h"

namespace glibra::scene {

// ---- Folders

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

// ---- Files

namespace {

namespace fs = std::filesystem;

/// The longest name that is looked up. No file system allows longer ones.
constexpr std::size_t kLongestName = 4096;
/// The most folder entries that one case-insensitive search visits.
constexpr int kMostVisits = 10'000;
/// How deep, and in how many folders, the library is searched for a name that its own folders do not have.
constexpr int kDeepestFolder = 4;
constexpr int kMostFolders = 200;
/// The most places of such a name that a message lists.
constexpr std::size_t kMostPlaces = 3;

/// A name from a scene, converted to the path syntax of this system.
struct CleanName {
    std::string path;                ///< with slashes only
    std::string root;                ///< of an absolute one; with a drive, where the system has drives
    std::vector<std::string> parts;  ///< after it, between slashes, without empty ones and "."
    bool isAbsolute = false;
    bool isNetwork = false;   ///< begins with two slashes: a path on another machine
    bool hasFolders = false;  ///< contains a slash or a drive letter
    std::string last;         ///< the last part, without a drive letter
};

CleanName clean(std::string_view written) {
    CleanName name;
    for (std::size_t i = 0; i < written.size(); ++i) {
        const bool isBackslash = written[i] == '\\';
        if (isBackslash && i > 1 && written[i - 1] == '\\') continue;  // a doubled backslash is one slash
        name.path += isBackslash ? '/' : written[i];
    }
    const bool hasDrive = name.path.size() > 1 && name.path[1] == ':' &&
                          std::isalpha(static_cast<unsigned char>(name.path[0])) != 0;
    if (hasDrive && fs::path(name.path).is_absolute())
        name.root = name.path.substr(0, 3);
    else if (name.path.starts_with('/'))
        name.root = "/";
    name.isAbsolute = !name.root.empty();
    name.isNetwork = name.path.starts_with("//");
    std::string part;
    for (std::size_t i = name.root.size(); i <= name.path.size(); ++i) {
        if (i < name.path.size() && name.path[i] != '/') {
            part += name.path[i];
            continue;
        }
        // A folder and the way back out of it are nothing, as for the program that these scenes were made
        // with.
        if (part == ".." && !name.parts.empty() && name.parts.back() != "..")
            name.parts.pop_back();
        else if (!part.empty() && part != ".")
            name.parts.push_back(part);
        part.clear();
    }
    name.last = name.parts.empty() ? std::string() : name.parts.back();
    name.hasFolders = name.path.find('/') != std::string::npos;
    if (hasDrive) {
        name.hasFolders = true;
        if (name.parts.size() == 1 && !name.isAbsolute) name.last.erase(0, 2);
    }
    return name;
}

bool isFolder(const fs::path& path) {
    std::error_code failure;
    return fs::is_directory(path, failure);
}

/// Finds the ordinary files below a folder whose paths equal `parts` except for case, in byte order.
class CaselessSearch {
  public:
    explicit CaselessSearch(FolderListings& listings) : listings_(listings) {}

    std::vector<fs::path> find(const fs::path& folder, const std::vector<std::string>& parts) {
        descend(folder, parts, 0);
        return std::move(found_);
    }

  private:
    void descend(const fs::path& folder, const std::vector<std::string>& parts, std::size_t next) {
        const std::string& part = parts[next];
        const bool isLast = next + 1 == parts.size();
        if (part == "..") {
            if (!isLast) descend(folder / part, parts, next + 1);
            return;
        }
        for (const std::string& name : listings_.namesWithoutCase(folder, part)) {
            if (++visits_ > kMostVisits || !listings_.spend(FolderListings::kPathWork)) return;
            const fs::path path = folder / name;
            if (!isLast && isFolder(path)) descend(path, parts, next + 1);
            if (isLast && isOrdinaryFile(path)) found_.push_back(path);
        }
    }

    FolderListings& listings_;
    std::vector<fs::path> found_;
    int visits_ = 0;
};

/// Searches folders by rules 2 and 3 (language, 8.6): all folders for the path as given, then all folders
/// for a path that differs only in case.
class FolderSearch {
  public:
    FolderSearch(FileReference& reference, const SearchFolders& all, FolderListings& listings)
        : reference_(reference), all_(all), listings_(listings) {}

    bool find(const std::vector<fs::path>& folders, const std::vector<std::string>& parts) {
        if (parts.empty()) return false;
        for (const fs::path& folder : folders) {
            fs::path path = folder;
            for (const std::string& part : parts) path /= part;
            base::FileSource source = all_.sourceAt(path);
            if (source.path.empty()) continue;
            if (!source.content && !isSpelledSo(path, parts.size()) && findCaseless(folder, parts))
                return true;
            reference_.path = std::move(source.path);
            reference_.content = std::move(source.content);
            return true;
        }
        return !listings_.isSpent() && std::ranges::any_of(folders, [&](const fs::path& folder) {
            return findCaseless(folder, parts);
        });
    }

  private:
    /// True if folders have the last names of the path in this case.
    static bool isSpelledSo(const fs::path& path, std::size_t count) {
        fs::path known = system::asInFolders(path), here = path;
        for (; count > 0; --count, known = known.parent_path(), here = here.parent_path())
            if (known.filename() != here.filename()) return false;
        return true;
    }

    bool findCaseless(const fs::path& folder, const std::vector<std::string>& parts) {
        const std::vector<fs::path> found = CaselessSearch(listings_).find(folder, parts);
        if (found.empty()) return false;
        base::FileSource source = all_.sourceAt(found.front());
        reference_.path = std::move(source.path);
        reference_.content = std::move(source.content);
        const auto shown = [&](const fs::path& path) {
            return folder.empty() || folder == folder.root_path()
                       ? path.generic_string()
                       : path.lexically_relative(folder).generic_string();
        };
        if (found.size() == 1) {
            reference_.remarks.push_back(
                diagnose("file-W01", fmt::format("'{}' found as '{}'", reference_.name, shown(found.front())),
                         reference_.place));
            return true;
        }
        std::string all = fmt::format("'{}'", shown(found[0]));
        for (std::size_t i = 1; i < found.size(); ++i)
            all += fmt::format("{} '{}'", i + 1 == found.size() ? " and" : ",", shown(found[i]));
        reference_.remarks.push_back(
            diagnose("file-W12",
                     fmt::format("'{}' matches {}; '{}' is used", reference_.name, all, shown(found.front())),
                     reference_.place));
        return true;
    }

    FileReference& reference_;
    const SearchFolders& all_;
    FolderListings& listings_;
};

void addRoot(SearchFolders& folders, const fs::path& root, const fs::path& sceneFolder) {
    const auto add = [&](const fs::path& folder) {
        if (std::ranges::find(folders.library, folder) != folders.library.end()) return;
        folders.library.push_back(folder);
        folders.roots.push_back(root);
    };
    std::error_code failure;
    const fs::path inside = fs::absolute(root, failure).lexically_normal() / "glib";
    const fs::path topic = sceneFolder.lexically_relative(inside);
    if (!topic.empty() && topic != "." && *topic.begin() != "..") add(root / "shaders" / topic);
    if (sceneFolder.has_filename()) add(root / "shaders" / sceneFolder.filename());
    add(root / "shaders");
    add(root / "textures");
    add(root / "scenes" / "models");
}

/// Finds the files of a name in the folders below those of the library.
class LibrarySearch {
  public:
    LibrarySearch(const SearchFolders& folders, FolderListings& listings)
        : folders_(folders), listings_(listings) {}

    /// The names by which a scene reaches the files, at most kMostPlaces, in the order of the search.
    std::vector<std::string> find(const std::string& name) {
        for (std::size_t i = 0; i < folders_.library.size() && found_.size() < kMostPlaces; ++i) {
            // The folder of a topic is searched as a part of its root.
            if (std::ranges::any_of(folders_.library, [&](const fs::path& each) {
                    const fs::path within = folders_.library[i].lexically_relative(each);
                    return !within.empty() && within != "." && *within.begin() != "..";
                }))
                continue;
            root_ = folders_.library[i];
            search(root_, name, 0);
        }
        return std::move(found_);
    }

  private:
    void search(const fs::path& folder, const std::string& name, int depth) {
        if (++visited_ > kMostFolders || listings_.isSpent()) return;
        for (const std::string& each : listings_.namesWithoutCase(folder, name)) {
            if (found_.size() == kMostPlaces || !listings_.spend(FolderListings::kPathWork)) return;
            if (isOrdinaryFile(folder / each) && folders_.mayRead(folder / each))
                found_.push_back((folder / each).lexically_relative(root_).generic_string());
        }
        if (depth == kDeepestFolder) return;
        for (const std::string& each : listings_.names(folder)) {
            if (found_.size() == kMostPlaces) return;
            if (each.find('.') != std::string::npos) continue;  // no folder, or a hidden one
            if (!listings_.spend(FolderListings::kPathWork)) return;
            std::error_code failure;
            if (fs::is_directory(fs::symlink_status(folder / each, failure)))
                search(folder / each, name, depth + 1);
        }
    }

    const SearchFolders& folders_;
    FolderListings& listings_;
    fs::path root_;
    std::vector<std::string> found_;
    int visited_ = 0;
};

Diagnostic notFound(const CleanName& name, std::string_view written, const SearchFolders& folders,
                    FolderListings& listings, const Place& place) {
    std::vector<fs::path> searched;
    if (name.isAbsolute && !name.isNetwork) searched.push_back(fs::path(name.path).parent_path());
    for (const fs::path& folder : folders.beside) {
        fs::path inside = folder;
        for (std::size_t i = 0; i + 1 < name.parts.size(); ++i) inside /= name.parts[i];
        if (name.parts.size() > 1 && !name.isAbsolute) searched.push_back(inside);
        searched.push_back(folder);
    }
    searched.insert(searched.end(), folders.library.begin(), folders.library.end());
    // The names in a folder whose files must not be read are not for the author of the scene either.
    constexpr std::size_t kSample = 8;
    if (folders.readable)
        std::erase_if(searched, [&](const fs::path& each) {
            const std::span names =
                std::span(listings.names(each)).first(std::min(listings.names(each).size(), kSample));
            return std::ranges::none_of(names,
                                        [&](const std::string& one) { return folders.mayRead(each / one); });
        });
    std::string text = fmt::format("cannot find '{}'", written);
    const auto problem = [&](const std::string& suggestion) {
        return about(diagnose("file-E01", text, place), std::string(written), suggestion);
    };
    if (!name.last.empty() && !name.isAbsolute) {
        const std::vector<std::string> elsewhere = LibrarySearch(folders, listings).find(name.last);
        for (std::size_t i = 0; i < elsewhere.size(); ++i)
            text += fmt::format("{} '{}'", i == 0 ? "; the library has it as" : " and", elsewhere[i]);
        if (!elsewhere.empty()) return problem(elsewhere.front());
    }
    const std::vector<std::string> near = nearestFiles(name.last, searched, listings);
    for (std::size_t i = 0; i < near.size(); ++i)
        text += fmt::format("{} '{}'", i == 0 ? "; nearest:" : ",", near[i]);
    return problem({});
}

}  // namespace

std::optional<fs::path> libraryAbove(const fs::path& folder, const fs::path& last) {
    for (fs::path each = folder;; each = each.parent_path()) {
        if (isFolder(each / "shaders") || isFolder(each / "textures")) return each;
        if (each == last || each == each.parent_path()) return std::nullopt;
    }
}

MemoryFiles memoryFiles(const std::map<fs::path, std::string>& texts,
                        const std::shared_ptr<const FileReader>& reader) {
    if (texts.empty() && !reader) return {};
    return [texts, reader](const fs::path& path) -> std::shared_ptr<const std::string> {
        if (reader)
            if (std::optional<std::string> content = (*reader)(path))
                return std::make_shared<const std::string>(std::move(*content));
        const auto text = texts.find(path);
        return text == texts.end() ? nullptr : std::make_shared<const std::string>(text->second);
    };
}

base::FileSource SearchFolders::sourceAt(const fs::path& path) const {
    if (inMemory)
        if (std::shared_ptr<const std::string> content = inMemory(path)) return {path, std::move(content)};
    return isOrdinaryFile(path) ? base::FileSource(path) : base::FileSource();
}

base::Roots shownRoots(const SearchFolders& folders) {
    base::Roots roots;
    if (!folders.beside.empty()) roots.add(folders.beside.back());
    // A folder of scenes may hold a link `shaders` to any place.
    for (std::size_t i = 0; i < folders.library.size(); ++i)
        roots.addBelow(folders.roots[i], folders.library[i]);
    return roots;
}

std::string whyHidden(const std::string& file) {
    return fmt::format(
        "'{}', which lies outside of the scene's folder and the library; add its folder to GLIBRA_PATH",
        file);
}

void hideTexts(Diagnostics& diagnostics, const std::set<std::string>& files) {
    for (Diagnostic& each : diagnostics)
        if (files.contains(each.place.file))
            each = {each.severity, each.id, std::string(kHiddenText) + whyHidden(each.place.file),
                    each.place};
}

SearchFolders searchFolders(const fs::path& scenePath, const InterpretOptions& options) {
    SearchFolders folders;
    folders.inMemory = options.inMemory;
    folders.beside.push_back(scenePath.parent_path());
    std::error_code failure;
    const fs::path absolute = fs::absolute(scenePath, failure).lexically_normal();
    const fs::path sceneFolder = absolute.parent_path();
    for (const fs::path& root : options.libraryRoots)
        if (!root.empty()) addRoot(folders, root, sceneFolder);
    fs::path last;
    if (!options.within.empty()) {
        last = fs::absolute(options.within, failure).lexically_normal();
        if (!last.has_filename()) last = last.parent_path();
        const fs::path inside = sceneFolder.lexically_relative(last);
        // A scene that lies elsewhere has no library above it.
        if (inside.empty() || *inside.begin() == "..") last = sceneFolder;
    }
    if (const auto root = libraryAbove(sceneFolder, last); !failure && root)
        addRoot(folders, *root, sceneFolder);
    if (!options.within.empty()) {
        folders.readable.emplace();
        folders.readable->add(options.within);
        for (std::size_t i = 0; i < folders.library.size(); ++i)
            folders.readable->addBelow(folders.roots[i], folders.library[i]);
    }
    return folders;
}

static FileReference lookUp(std::string_view written, const Place& place, const SearchFolders& folders,
                            FolderListings& listings) {
    FileReference reference{std::string(written), {}, {}, place};
    if (written.size() > kLongestName) {
        reference.remarks.push_back(
            diagnose("file-E01",
                     fmt::format("cannot find '{}...': the name is too long", written.substr(0, 64)), place));
        return reference;
    }
    const CleanName name = clean(written);
    FolderSearch search(reference, folders, listings);
    if (name.isAbsolute && !name.isNetwork && search.find({name.root}, name.parts)) return reference;
    if (!name.isAbsolute && search.find(folders.beside, name.parts)) return reference;
    if (name.hasFolders && !name.last.empty()) {
        FileReference beside = reference;
        if (FolderSearch(beside, folders, listings).find(folders.beside, {name.last})) {
            reference.path = beside.path;
            reference.content = beside.content;
            reference.remarks.push_back(diagnose("file-W02",
                                                 fmt::format("'{}' found as '{}' beside the scene", written,
                                                             beside.path.filename().generic_string()),
                                                 place));
            return reference;
        }
    }
    if (!name.isAbsolute)
        for (const fs::path& folder : folders.library)
            if (search.find({folder}, name.parts)) return reference;
    reference.remarks.push_back(notFound(name, written, folders, listings, place));
    if (listings.reportsSpent())
        reference.remarks.push_back(diagnose(
            "file-W13",
            "the scene names too many missing files; further names are looked up only as they are written",
            place));
    return reference;
}

FileReference findFile(std::string_view written, const Place& place, const SearchFolders& folders,
                       FolderListings& listings) {
    FileReference reference = lookUp(written, place, folders, listings);
    if (reference.path.empty() || reference.content || folders.mayRead(reference.path)) return reference;
    reference.path.clear();
    reference.remarks = {diagnose("file-E12",
                                  fmt::format("'{}' lies outside of the scene's folder and the library, and "
                                              "this scene may read only files inside",
                                              written),
                                  place)};
    return reference;
}

std::vector<fs::path> placesOf(std::string_view written, const SearchFolders& folders) {
    std::vector<fs::path> places;
    const CleanName name = clean(written.substr(0, kLongestName));
    if (name.parts.empty()) return places;
    const auto add = [&](const fs::path& folder, const std::vector<std::string>& parts) {
        fs::path& place = places.emplace_back(folder);
        for (const std::string& part : parts) place /= part;
    };
    if (name.isAbsolute && !name.isNetwork) add(name.root, name.parts);
    for (const fs::path& each : folders.beside) {
        if (!name.isAbsolute) add(each, name.parts);
        if (name.hasFolders && !name.last.empty()) add(each, {name.last});
    }
    if (!name.isAbsolute)
        for (const fs::path& each : folders.library) add(each, name.parts);
    return places;
}

SearchFolders includeFolders(std::string_view includingPath, std::string_view scenePath,
                             const InterpretOptions& options) {
    SearchFolders folders = searchFolders(scenePath, options);
    const fs::path including = fs::path(includingPath).parent_path();
    if (including != folders.beside.front()) folders.beside.insert(folders.beside.begin(), including);
    return folders;
}

FileReference findInclude(std::string_view name, std::string_view includingPath, std::string_view scenePath,
                          const InterpretOptions& options, FolderListings& listings) {
    return findFile(name, Place{std::string(includingPath), 1, 1},
                    includeFolders(includingPath, scenePath, options), listings);
}

}  // namespace glibra::scene
