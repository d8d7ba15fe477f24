#include "classroom/compare_sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <system_error>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;

std::string placeOf(const std::string& path) {
    std::error_code failure;
    const fs::path place = fs::weakly_canonical(path, failure);
    return failure ? path : place.generic_string();
}

/// Names a file of an entry that others use, too.
void nameShared(Classroom& room, std::size_t index, const std::string& place,
                const std::vector<std::size_t>& users, bool isOfReference) {
    constexpr std::size_t kMostNames = 3;
    Entry& entry = room.entries[index];
    const std::string name = fs::path(place).filename().generic_string();
    if (isOfReference) entry.notCompared.push_back(fmt::format("'{}' is a file of the reference", name));
    if (users.size() < 2) return;
    std::string others;
    std::size_t named = 0;
    for (const std::size_t each : users) {
        if (each == index) continue;
        if (named++ == kMostNames) break;
        others += (others.empty() ? "" : ", ") + room.entries[each].submission.name;
    }
    if (users.size() - 1 > kMostNames) others += fmt::format(" and {} more", users.size() - 1 - kMostNames);
    entry.notCompared.push_back(fmt::format("'{}' with {}, which {} the same file", name, others,
                                            users.size() == 2 ? "uses" : "use"));
}

/// The hashes that more than `most` of these submissions have.
std::unordered_set<std::uint64_t> commonHashes(std::span<const std::vector<Fingerprint>> submissions,
                                               std::size_t most) {
    std::unordered_map<std::uint64_t, std::pair<std::size_t, std::size_t>>
        owners;  // the last one, and how many
    std::unordered_set<std::uint64_t> common;
    for (std::size_t i = 0; i < submissions.size(); ++i)
        for (const Fingerprint& each : submissions[i]) {
            auto& [last, count] = owners[each.hash];
            if (count > 0 && last == i) continue;
            last = i;
            if (++count > most) common.insert(each.hash);
        }
    return common;
}

/// Removes fingerprints that many of the class have, or many of the earlier submissions.
void removeCommon(Classroom& room, std::size_t wanted) {
    const std::span<const std::vector<Fingerprint>> all(room.fingerprints);
    const auto most = [&](std::size_t count) { return wanted > 0 ? wanted : usualCommon(count); };
    room.common = most(room.entries.size());
    std::unordered_set<std::uint64_t> common = commonHashes(all.first(room.entries.size()), room.common);
    room.commonFingerprints = common.size();
    common.merge(commonHashes(all.subspan(room.entries.size()), most(room.earlier.size())));
    for (std::vector<Fingerprint>& each : room.fingerprints)
        std::erase_if(each, [&](const Fingerprint& one) { return common.contains(one.hash); });
}

/// Sets the places of the files of an entry, and returns them.
std::vector<std::string> setPlaces(Entry& entry) {
    std::vector<std::string> places;
    for (SourceFile& file : entry.files) places.push_back(file.place = placeOf(file.path));
    return places;
}

}  // namespace

std::size_t usualCommon(std::size_t submissions) {
    return std::clamp<std::size_t>(submissions / 3, 4, 10);
}

void compareSources(Classroom& room, const std::vector<SourceFile>& given, std::size_t common) {
    GivenCode code;
    for (const SourceFile& each : room.reference.files) addGivenCode(code, each.tokens);
    for (const SourceFile& each : given) addGivenCode(code, each.tokens);
    std::set<std::string> ofReference;
    for (const SourceFile& each : room.reference.files) ofReference.insert(placeOf(each.path));
    std::map<std::string, std::vector<std::size_t>> users;
    std::vector<std::vector<std::string>> places;
    for (std::size_t i = 0; i < room.entries.size(); ++i) {
        places.push_back(setPlaces(room.entries[i]));
        for (const std::string& place : places.back()) {
            std::vector<std::size_t>& of = users[place];
            if (of.empty() || of.back() != i) of.push_back(i);
        }
        room.fingerprints.push_back(fingerprintsOf(room.entries[i].files, code));
    }
    // Scenes that lie in one folder may share a shader. Between those that read it, it is no copy.
    for (const auto& [place, of] : users)
        for (const std::size_t each : of) nameShared(room, each, place, of, ofReference.contains(place));
    for (Entry& each : room.earlier) {
        places.push_back(setPlaces(each));
        room.fingerprints.push_back(fingerprintsOf(each.files, code));
    }
    removeCommon(room, common);
    room.pairs = similarPairs(room.fingerprints, places);
    std::erase_if(room.pairs, [&](const SimilarPair& each) { return each.a >= room.entries.size(); });
}

}  // namespace glibra::classroom
