#include "suite/file/selection.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <system_error>
#include <unordered_map>
#include <utility>

#include "base/hash.h"
#include "base/suggest.h"
#include "glib/text.h"
#include "suite/number_of.h"

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

namespace {

constexpr int kMostShards = 1'000'000;

/// Disjoint sets of numbers.
class Groups {
  public:
    explicit Groups(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    std::size_t find(std::size_t i) {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }
    void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

  private:
    std::vector<std::size_t> parent_;
};

}  // namespace

Result<Shard> parseShard(std::string_view text) {
    const std::size_t slash = std::min(text.find('/'), text.size());
    const auto index = numberOf<int>(text.substr(0, slash));
    const auto count = numberOf<int>(text.substr(std::min(slash + 1, text.size())));
    if (!index || !count || text.find('-') != text.npos)
        return diagnose("suite-E16", "--shard: expected I/N, as 2/8, found " + glib::inQuotes(text));
    const Shard shard{*index, *count};
    if (shard.index < 1 || shard.count > kMostShards || shard.index > shard.count)
        return diagnose("suite-E16",
                        "--shard: expected I/N with 1 <= I <= N <= 1,000,000, found " + glib::inQuotes(text));
    return shard;
}

std::vector<std::string_view> shardNames(const Suite& suite) {
    std::unordered_map<std::string_view, std::size_t> byName;
    for (std::size_t i = 0; i < suite.shots.size(); ++i) byName.emplace(suite.shots[i].name, i);
    Groups groups(suite.shots.size());
    std::vector<bool> namesAnother(suite.shots.size());
    for (std::size_t i = 0; i < suite.shots.size(); ++i)
        for (const std::string* each : {&suite.shots[i].match, &suite.shots[i].differ})
            if (const auto found = byName.find(*each); !each->empty() && found != byName.end()) {
                groups.join(i, found->second);
                namesAnother[i] = true;
            }
    std::vector<std::string_view> ofGroup(suite.shots.size());
    for (std::size_t i = 0; i < suite.shots.size(); ++i) {
        std::string_view& chosen = ofGroup[groups.find(i)];
        if (!namesAnother[i] && (chosen.empty() || suite.shots[i].name < chosen))
            chosen = suite.shots[i].name;
    }
    std::vector<std::string_view> names(suite.shots.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        names[i] = ofGroup[groups.find(i)];
        if (names[i].empty()) names[i] = suite.shots[i].name;  // a cycle, which readSuite reports
    }
    return names;
}

int shardOf(std::string_view suiteName, std::string_view shardName, int count) {
    std::uint64_t hash = base::fnv1a(suiteName);
    hash = base::fnv1a(std::string_view("\0", 1), hash);
    hash = base::fnv1a(shardName, hash);
    return static_cast<int>(base::murmurMixed(hash) % static_cast<std::uint64_t>(count));
}

namespace {

constexpr std::string_view kTag = "tag:";

std::string_view beforeSweep(std::string_view name) {
    return name.substr(0, name.find('@'));
}

/// True if only other shots compare the picture.
bool isPartnerOnly(const Shot& shot) {
    return !shot.golden && shot.match.empty() && shot.differ.empty();
}

/// Marks the shots that marked shots are compared with, until no more are added.
void markNamed(const Suite& suite, std::vector<bool>& marked) {
    std::unordered_map<std::string_view, std::size_t> byName;
    std::unordered_multimap<std::string_view, std::size_t> namedBy;
    for (std::size_t i = 0; i < suite.shots.size(); ++i) {
        byName.emplace(suite.shots[i].name, i);
        for (const std::string* each : {&suite.shots[i].match, &suite.shots[i].differ})
            if (!each->empty()) namedBy.emplace(*each, i);
    }
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < marked.size(); ++i)
        if (marked[i]) open.push_back(i);
    const auto mark = [&](std::size_t i) {
        if (!marked[i]) open.push_back(i);
        marked[i] = true;
    };
    while (!open.empty()) {
        const Shot& shot = suite.shots[open.back()];
        open.pop_back();
        const auto [begin, end] = namedBy.equal_range(shot.name);
        for (auto each = begin; isPartnerOnly(shot) && each != end; ++each) mark(each->second);
        for (const std::string* each : {&shot.match, &shot.differ})
            if (const auto found = byName.find(*each); !each->empty() && found != byName.end())
                mark(found->second);
    }
}

std::string nearest(std::span<const Suite> suites, std::string_view pattern) {
    const bool isTag = pattern.starts_with(kTag);
    std::set<std::string_view> names;
    for (const Suite& suite : suites)
        for (const Shot& shot : suite.shots) {
            if (isTag) {
                names.insert(shot.tags.begin(), shot.tags.end());
            } else {
                names.insert(shot.name);
                names.insert(beforeSweep(shot.name));
            }
        }
    const std::vector<std::string_view> all(names.begin(), names.end());
    const std::string near = base::nearestName(isTag ? pattern.substr(kTag.size()) : pattern, all);
    return near.empty() || !isTag ? near : std::string(kTag) + near;
}

}  // namespace

bool isMeant(const Shot& shot, std::string_view pattern) {
    if (pattern.starts_with(kTag))
        return std::ranges::any_of(
            shot.tags, [&](const std::string& tag) { return fits(pattern.substr(kTag.size()), tag); });
    return fits(pattern, shot.name) || fits(pattern, beforeSweep(shot.name));
}

std::vector<std::size_t> select(const Suite& suite, std::span<const std::string> onlyPatterns, Shard shard,
                                bool withNamed) {
    std::vector<bool> marked(suite.shots.size(), onlyPatterns.empty());
    for (std::size_t i = 0; i < marked.size(); ++i)
        for (const std::string& pattern : onlyPatterns)
            if (isMeant(suite.shots[i], pattern)) marked[i] = true;
    if (!onlyPatterns.empty() && withNamed) markNamed(suite, marked);
    const std::vector<std::string_view> names = shardNames(suite);
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < marked.size(); ++i)
        if (marked[i] && shardOf(suite.name, names[i], shard.count) == shard.index - 1) chosen.push_back(i);
    return chosen;
}

Diagnostics unmatchedPatterns(std::span<const Suite> suites, std::span<const std::string> onlyPatterns) {
    Diagnostics problems;
    for (const std::string& pattern : onlyPatterns) {
        const bool meansAny = std::ranges::any_of(suites, [&](const Suite& suite) {
            return std::ranges::any_of(suite.shots, [&](const Shot& shot) { return isMeant(shot, pattern); });
        });
        if (meansAny) continue;
        const std::string near = nearest(suites, pattern);
        problems.push_back(diagnose(
            "suite-E15", fmt::format("no shot matches --only {}{}", glib::inQuotes(pattern),
                                     near.empty() ? "" : fmt::format("; did you mean '{}'?", near))));
    }
    return problems;
}

}  // namespace glibra::suite
