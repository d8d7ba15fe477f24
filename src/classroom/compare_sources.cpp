#include "classroom/compare_sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <unordered_map>
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

/// Removes fingerprints that more than `most` submissions have, and counts them.
void removeCommon(Classroom& room, std::size_t most) {
    std::unordered_map<std::uint64_t, std::pair<std::size_t, std::size_t>>
        owners;  // the last one, and how many
    for (std::size_t i = 0; i < room.fingerprints.size(); ++i)
        for (const Fingerprint& each : room.fingerprints[i]) {
            auto& [last, count] = owners[each.hash];
            if (count > 0 && last == i) continue;
            last = i;
            ++count;
        }
    room.common = most;
    for (const auto& [hash, owner] : owners) room.commonFingerprints += owner.second > most ? 1 : 0;
    for (std::vector<Fingerprint>& each : room.fingerprints)
        std::erase_if(each, [&](const Fingerprint& one) { return owners[one.hash].second > most; });
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
        places.emplace_back();
        for (SourceFile& file : room.entries[i].files) {
            file.place = placeOf(file.path);
            places.back().push_back(file.place);
            std::vector<std::size_t>& of = users[places.back().back()];
            if (of.empty() || of.back() != i) of.push_back(i);
        }
        room.fingerprints.push_back(fingerprintsOf(room.entries[i].files, code));
    }
    // Scenes that lie in one folder may share a shader. Between those that read it, it is no copy.
    for (const auto& [place, of] : users)
        for (const std::size_t each : of) nameShared(room, each, place, of, ofReference.contains(place));
    removeCommon(room, common > 0 ? common : usualCommon(room.entries.size()));
    room.pairs = similarPairs(room.fingerprints, places);
}

}  // namespace glibra::classroom
