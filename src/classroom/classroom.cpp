#include "classroom/classroom.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <system_error>
#include <unordered_map>
#include <unordered_set>

#include "base/text.h"
#include "system/folder.h"

namespace glibra::classroom {

using suite::Verdict;

bool hasReference(const Classroom& classroom) {
    return !classroom.reference.submission.scene.empty() || !classroom.reference.pictures.empty();
}

std::optional<double> pointsOf(const Entry& entry) {
    if (entry.marks.empty()) return std::nullopt;
    double points = 0;
    for (const Mark& each : entry.marks) points += each.points;
    return points * entry.lateFactor;
}

double mostPoints(const Classroom& classroom) {
    double most = 0;
    if (!classroom.entries.empty())
        for (const Mark& each : classroom.entries.front().marks) most += each.isBonus ? 0 : each.most;
    return most;
}

std::size_t openCount(const Entry& entry) {
    return static_cast<std::size_t>(
        std::ranges::count_if(entry.marks, [](const Mark& each) { return each.isOpen && !each.isBonus; }));
}

std::size_t drawnCount(const Entry& entry) {
    return static_cast<std::size_t>(std::ranges::count(entry.pictures, Verdict::passed, &Picture::verdict));
}

bool isDrawn(const Entry& entry) {
    return !entry.pictures.empty() && drawnCount(entry) == entry.pictures.size();
}

std::string stateOf(const Entry& entry) {
    if (entry.submission.scene.empty()) return "no-scene";
    for (const Verdict each : {Verdict::crashed, Verdict::timedOut})
        if (std::ranges::find(entry.pictures, each, &Picture::verdict) != entry.pictures.end())
            return suite::name(each);
    if (!isDrawn(entry)) return suite::name(Verdict::failed);
    return entry.drawsNothing ? "nothing" : "drawn";
}

std::string reasonOf(const Entry& entry) {
    if (!entry.submission.problem.empty()) return entry.submission.problem;
    for (const Picture& each : entry.pictures)
        if (each.verdict != Verdict::passed && !each.reason.empty()) return each.reason;
    if (entry.drawsNothing) return "it draws nothing that is seen: its pictures have one colour";
    return {};
}

std::size_t countOf(const Entry& entry, Severity severity) {
    return static_cast<std::size_t>(std::ranges::count(entry.diagnostics, severity, &Diagnostic::severity));
}

std::optional<Scores> scoresOf(const Entry& entry) {
    Scores scores;
    double count = 0;
    for (const Picture& each : entry.pictures) {
        if (!each.score) continue;
        ++count;
        scores.flip += each.score->flip;
        scores.structure += each.score->structure;
        scores.likeness += each.score->likeness;
        scores.worstFlip = std::max(scores.worstFlip, each.score->flip);
        scores.worstStructure = std::max(scores.worstStructure, each.score->structure);
    }
    if (count == 0) return std::nullopt;
    scores.flip /= count;
    scores.structure /= count;
    scores.likeness /= count;
    return scores;
}

Reacts reactsOf(const Classroom& classroom, const Entry& entry, std::size_t slider) {
    const auto measured = [&](const Entry& one) {
        return slider < one.reactions.size() ? one.reactions[slider] : std::nullopt;
    };
    const std::optional<Change> own = measured(entry);
    if (!own) return Reacts::unknown;
    if (!hasReference(classroom)) return own->mean >= kLeastReaction ? Reacts::yes : Reacts::no;
    const std::optional<Change> expected = measured(classroom.reference);
    if (!expected || expected->mean < kLeastReaction) return Reacts::unknown;
    if (own->strength >= expected->strength / 4 && !own->isOtherwise) return Reacts::yes;
    return own->strength >= expected->strength / 20 ? Reacts::weakly : Reacts::no;
}

const char* name(Reacts reacts) {
    constexpr const char* kNames[] = {"", "no", "weakly", "yes"};
    return kNames[static_cast<std::size_t>(reacts)];
}

const Entry& comparedEntry(const Classroom& classroom, std::size_t index) {
    const std::size_t count = classroom.entries.size();
    return index < count ? classroom.entries[index] : classroom.earlier.at(index - count);
}

std::optional<Nearest> nearestOf(const Classroom& classroom, std::size_t entry) {
    std::optional<Nearest> nearest;
    for (const SimilarPair& each : classroom.pairs) {
        if (each.a != entry && each.b != entry) continue;
        const Nearest one = each.a == entry ? Nearest{each.b, each.ofA} : Nearest{each.a, each.ofB};
        if (!nearest || one.share > nearest->share) nearest = one;
    }
    return nearest;
}

std::vector<std::string> lookalikesOf(const Classroom& classroom, const Entry& entry) {
    const std::vector<ReadPicture>& expected = classroom.reference.readPictures;
    std::vector<std::string> names;
    for (const ReadPicture& each : entry.readPictures)
        if (each.isLikeReference &&
            std::ranges::find(expected, each.digest, &ReadPicture::digest) == expected.end())
            names.push_back(each.name);
    return names;
}

std::string summary(const Classroom& classroom) {
    std::string text = base::counted(classroom.entries.size(), "submission") + ": ";
    bool first = true;
    for (const char* state : {"drawn", "nothing", "failed", "crashed", "timed-out", "no-scene"}) {
        const auto count = std::ranges::count_if(classroom.entries,
                                                 [&](const Entry& each) { return stateOf(each) == state; });
        if (count == 0) continue;
        text += fmt::format("{}{} {}", first ? "" : ", ", count,
                            std::string_view(state) == "no-scene"  ? "without a scene"
                            : std::string_view(state) == "nothing" ? "drawn without anything to see"
                                                                   : state);
        first = false;
    }
    return text;
}

namespace {

namespace fs = std::filesystem;

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
    for (SourceFile& file : entry.files)
        places.push_back(file.place = system::realPath(file.path).generic_string());
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
    for (const SourceFile& each : room.reference.files)
        ofReference.insert(system::realPath(each.path).generic_string());
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
