#include "suite/file/glob.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "glib/text.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

/// How one element of a pattern matches a character: the length of the element, and whether the character is
/// in it.
struct Element {
    std::size_t length = 1;
    bool fits = false;
};

/// The set that begins at `pattern[0] == '['`, or nothing if it has no closing ']'. A ']' right after the
/// opening bracket is a member of the set.
std::optional<Element> setElement(std::string_view pattern, char c) {
    std::size_t at = 1;
    const bool inverted = at < pattern.size() && (pattern[at] == '!' || pattern[at] == '^');
    if (inverted) ++at;
    const std::size_t first = at;
    bool found = false;
    for (; at < pattern.size() && (pattern[at] != ']' || at == first); ++at) {
        const auto low = static_cast<unsigned char>(pattern[at]);
        auto high = low;
        if (at + 2 < pattern.size() && pattern[at + 1] == '-' && pattern[at + 2] != ']') {
            high = static_cast<unsigned char>(pattern[at + 2]);
            at += 2;
        }
        found = found || (low <= static_cast<unsigned char>(c) && static_cast<unsigned char>(c) <= high);
    }
    if (at >= pattern.size()) return std::nullopt;
    return Element{at + 1, found != inverted};
}

Element element(std::string_view pattern, char c) {
    if (pattern.front() == '?') return {1, true};
    if (pattern.front() == '[')
        if (const auto set = setElement(pattern, c)) return *set;
    return {1, pattern.front() == c};
}

std::vector<std::string> parts(std::string_view pattern) {
    std::vector<std::string> result;
    while (!pattern.empty()) {
        const std::size_t slash = std::min(pattern.find('/'), pattern.size());
        if (slash > 0) result.emplace_back(pattern.substr(0, slash));
        pattern.remove_prefix(std::min(slash + 1, pattern.size()));
    }
    return result;
}

/// Lists folders and counts the entries.
class Walk {
  public:
    /// The entries of a folder that match one part; all of them for "**".
    std::vector<fs::path> entries(const fs::path& folder, const std::string& part) {
        std::vector<fs::path> found;
        std::error_code failure;
        const fs::path from = folder.empty() ? fs::path(".") : folder;
        fs::directory_iterator each(from, failure);
        for (const fs::directory_iterator end; !failure && each != end && !isTooMuch();
             each.increment(failure)) {
            ++seen_;
            const std::string name = each->path().filename().generic_string();
            if (name.starts_with('.') && !part.starts_with('.')) continue;
            if (part == "**" || fits(part, name)) found.push_back(folder / name);
        }
        if (failure && !isMissing(failure)) reportFolder(from, failure);
        return found;
    }

    [[nodiscard]] bool isFile(const fs::path& path) {
        std::error_code failure;
        const fs::file_type type = fs::status(path, failure).type();
        const bool isDanglingLink = type == fs::file_type::not_found && fs::is_symlink(path, failure) &&
                                    glib::sameWord(path.extension().generic_string(), ".glib");
        if (type == fs::file_type::none || isDanglingLink)
            problems_.push_back(diagnose(
                "suite-E22",
                fmt::format("cannot look at '{}': {}; it would be left out", path.generic_string(),
                            isDanglingLink ? "the target of the link is missing" : failure.message()),
                {path.generic_string(), 1, 1}));
        return type == fs::file_type::regular;
    }
    [[nodiscard]] bool isFolder(const fs::path& path) {
        return typeOf(path, true) == fs::file_type::directory;
    }

    /// The folder and all folders below it.
    void addTree(const fs::path& root, std::set<fs::path>& folders) {
        std::vector<std::pair<fs::path, int>> open{{root, 0}};
        while (!open.empty() && !isTooMuch()) {
            const auto [folder, depth] = std::move(open.back());
            open.pop_back();
            if (!folders.insert(folder).second) continue;
            for (fs::path& each : entries(folder, "**")) {
                if (typeOf(each, false) != fs::file_type::directory) continue;
                if (depth == kDeepestSearch) {
                    tooDeep_ = true;
                    return;
                }
                open.emplace_back(std::move(each), depth + 1);
            }
        }
    }

    [[nodiscard]] bool isTooMuch() const { return tooDeep_ || seen_ > kMostSearched; }
    [[nodiscard]] const Diagnostics& problems() const { return problems_; }

  private:
    /// A pattern may name a folder that does not exist, or a file where it needs a folder. Both match
    /// nothing.
    static bool isMissing(const std::error_code& failure) {
        return failure == std::errc::no_such_file_or_directory || failure == std::errc::not_a_directory;
    }

    /// "**" looks at a folder twice: for the folders in it, and for the files.
    void reportFolder(const fs::path& folder, const std::error_code& failure) {
        if (!reported_.insert(folder).second) return;
        problems_.push_back(
            diagnose("suite-E22",
                     fmt::format("cannot list the folder '{}': {}; its scenes would be left out",
                                 folder.generic_string(), failure.message()),
                     {folder.generic_string(), 1, 1}));
    }

    fs::file_type typeOf(const fs::path& path, bool followsLinks) {
        std::error_code failure;
        const fs::file_type type =
            (followsLinks ? fs::status(path, failure) : fs::symlink_status(path, failure)).type();
        if (type == fs::file_type::none && !isMissing(failure)) reportFolder(path, failure);
        return type;
    }

    Diagnostics problems_;
    std::set<fs::path> reported_;
    bool tooDeep_ = false;
    std::size_t seen_ = 0;
};

}  // namespace

bool isPattern(std::string_view text) {
    return text.find_first_of("*?[") != std::string_view::npos;
}

bool fits(std::string_view pattern, std::string_view text) {
    // The position of the last '*', and the start of the text after what it matches so far. Only the last '*'
    // needs to be tried again.
    std::optional<std::size_t> star;
    std::size_t retry = 0;
    std::size_t p = 0;
    std::size_t t = 0;
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            retry = t;
            continue;
        }
        if (p < pattern.size()) {
            const Element next = element(pattern.substr(p), text[t]);
            if (next.fits) {
                p += next.length;
                ++t;
                continue;
            }
        }
        if (!star) return false;
        p = *star + 1;
        t = ++retry;
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

Result<std::vector<fs::path>> filesThatFit(const fs::path& folder, std::string_view pattern) {
    std::vector<std::string> all = parts(pattern);
    if (all.empty()) return std::vector<fs::path>{};
    if (all.back() == "**") all.emplace_back("*");
    Walk walk;
    std::set<fs::path> here{pattern.starts_with('/') ? fs::path("/") : folder};
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        std::set<fs::path> next;
        for (const fs::path& each : here) {
            if (all[i] == "**") {
                walk.addTree(each, next);
            } else if (isPattern(all[i])) {
                for (const fs::path& entry : walk.entries(each, all[i]))
                    if (walk.isFolder(entry)) next.insert(entry);
            } else {
                next.insert(each / all[i]);
            }
        }
        here = std::move(next);
    }
    std::vector<fs::path> files;
    for (const fs::path& each : here) {
        const std::vector<fs::path> found =
            isPattern(all.back()) ? walk.entries(each, all.back()) : std::vector<fs::path>{each / all.back()};
        for (const fs::path& entry : found)
            if (walk.isFile(entry)) files.push_back(entry);
    }
    if (walk.isTooMuch()) return {};
    if (!walk.problems().empty()) return walk.problems();
    std::ranges::sort(files, [](const fs::path& a, const fs::path& b) { return a.native() < b.native(); });
    return files;
}

Result<std::vector<fs::path>> scenesBelow(const fs::path& folder) {
    return filesThatFit(folder, "**/*.[gG][lL][iI][bB]");
}

std::string fixedFolder(std::string_view pattern) {
    std::size_t end = 0;
    for (std::size_t slash = pattern.find('/'); slash != std::string_view::npos;
         slash = pattern.find('/', slash + 1)) {
        if (isPattern(pattern.substr(0, slash))) break;
        end = slash;
        if (slash == 0) end = 1;
    }
    return std::string(pattern.substr(0, end));
}

}  // namespace glibra::suite
