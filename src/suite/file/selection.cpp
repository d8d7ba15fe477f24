#include "suite/file/selection.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <unordered_map>

#include "base/suggest.h"
#include "glib/text.h"
#include "suite/file/glob.h"

namespace glibra::suite {
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
