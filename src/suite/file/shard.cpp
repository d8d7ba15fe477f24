#include "suite/file/shard.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <unordered_map>

#include "glib/text.h"
#include "suite/number_of.h"

namespace glibra::suite {
namespace {

constexpr int kMostShards = 1'000'000;

std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash) {
    for (const char c : bytes) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3U;
    }
    return hash;
}

std::uint64_t finalized(std::uint64_t h) {
    h ^= h >> 33U;
    h *= 0xff51afd7ed558ccdU;
    h ^= h >> 33U;
    h *= 0xc4ceb9fe1a85ec53U;
    h ^= h >> 33U;
    return h;
}

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
    constexpr std::uint64_t kOffsetBasis = 0xcbf29ce484222325U;
    std::uint64_t hash = fnv1a(suiteName, kOffsetBasis);
    hash = fnv1a(std::string_view("\0", 1), hash);
    hash = fnv1a(shardName, hash);
    return static_cast<int>(finalized(hash) % static_cast<std::uint64_t>(count));
}

}  // namespace glibra::suite
