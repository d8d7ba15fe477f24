#include "suite/file/selection.h"

#include <fmt/format.h>
#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>

#include "base/hash.h"
#include "base/suggest.h"
#include "glib/text.h"
#include "suite/file/glob.h"
#include "suite/number_of.h"

namespace glibra::suite {
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
