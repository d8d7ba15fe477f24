#include "classroom/teacher_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>
#include <utility>

#include "base/contained.h"
#include "base/files.h"
#include "classroom/json_members.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::uint64_t kLargestMarks = 16u << 20u;
constexpr std::size_t kLongestComment = 10'000;

std::string textOf(const Json& object, const char* key) {
    return object.contains(key) ? valueOf<std::string>(object, key) : std::string();
}

/// The only entry that fits, or nothing.
std::optional<std::size_t> onlyEntry(const Classroom& room, const auto& fits) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < room.entries.size(); ++i) {
        if (!fits(room.entries[i].submission)) continue;
        if (found) return std::nullopt;
        found = i;
    }
    return found;
}

bool hasNumber(const Submission& submission, const std::string& number) {
    return std::ranges::any_of(membersOf(submission),
                               [&](const Member& each) { return each.number == number; });
}

std::optional<std::size_t> entryOf(const Classroom& room, const std::string& name, const OwnMarks& marks) {
    std::optional<std::size_t> found;
    if (!marks.number.empty())
        found = onlyEntry(room, [&](const Submission& each) { return hasNumber(each, marks.number); });
    if (!found && !marks.folder.empty())
        found = onlyEntry(room, [&](const Submission& each) { return each.key == marks.folder; });
    // Somebody else may have the name of a student who has a number.
    const auto hasOther = [&](const Submission& each) {
        return !marks.number.empty() && !each.number.empty() && !hasNumber(each, marks.number);
    };
    if (!found)
        found = onlyEntry(room, [&](const Submission& each) { return each.name == name && !hasOther(each); });
    if (!found)
        found = onlyEntry(room, [&](const Submission& each) {
            const std::vector<std::string> all = identitiesOf(each);
            return std::ranges::find(all, name) != all.end() && !hasOther(each);
        });
    return found;
}

/// "3 points for 'report'".
std::string pointsText(double points, const std::string& check) {
    return fmt::format("{:g} {} for '{}'", points, points == 1 ? "point" : "points", check);
}

OwnMarks ownMarksIn(const Json& json) {
    OwnMarks own;
    own.comment = textOf(objectIn(json), "comment").substr(0, kLongestComment);
    own.number = textOf(json, "number");
    own.folder = textOf(json, "folder");
    if (json.contains("points"))
        inMember("points", [&, &points = json.at("points")] {
            for (const auto& [check, each] : objectIn(points).items())
                own.points[check] = valueOf<double>(points, check);
        });
    if (json.contains("handedIn")) own.handedIn = valueOf<decltype(own.handedIn)>(json, "handedIn");
    return own;
}

}  // namespace

Result<TeacherMarks> parseTeacherMarks(std::string_view text, const std::string& file) try {
    TeacherMarks marks;
    const Json json = Json::parse(text);
    for (const auto& [name, each] : objectIn(json).items())
        marks[name] = inMember(name, [&] { return ownMarksIn(each); });
    return marks;
} catch (const std::exception& problem) {
    return wrongFile("suite-E27", "this is no file of marks: ", problem, text, file);
}

std::string toText(const TeacherMarks& marks) {
    Json json = Json::object();
    for (const auto& [name, each] : marks) {
        if (each.points.empty() && each.comment.empty()) continue;
        Json& one = json[name] = {{"comment", each.comment}, {"points", each.points}};
        if (!each.number.empty()) one["number"] = each.number;
        if (!each.folder.empty()) one["folder"] = each.folder;
        if (!each.handedIn.empty()) one["handedIn"] = each.handedIn;
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<TeacherMarks> readTeacherMarks(const fs::path& site) {
    std::error_code failure;
    if (!fs::exists(fs::symlink_status(site / kMarksFile, failure))) return TeacherMarks{};
    const auto text = base::textIn(base::openBeneath(site, kMarksFile), kLargestMarks);
    if (!text)
        return diagnose("suite-E27", fmt::format("cannot read '{}'", (site / kMarksFile).generic_string()));
    return parseTeacherMarks(*text, (site / kMarksFile).generic_string());
}

int writeTeacherMarks(const TeacherMarks& marks, const fs::path& site) {
    const std::string text = toText(marks);
    return base::writeBeneath(site, kMarksFile, std::as_bytes(std::span(text)));
}

Digests readDigests(const fs::path& site) try {
    const auto text = base::textIn(base::openBeneath(site, kDigestsFile), kLargestMarks);
    return text ? Json::parse(*text).get<Digests>() : Digests{};
} catch (const Json::exception&) {
    return {};
}

void writeDigests(const Classroom& room, const fs::path& site) {
    Digests digests;
    for (const Entry& each : room.entries)
        if (!each.digest.empty()) digests[each.submission.key] = each.digest;
    const std::string text = Json(digests).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    // Without it, points count as typed for what is there now.
    base::writeBeneath(site, kDigestsFile, std::as_bytes(std::span(text)));
}

void addDigests(TeacherMarks& marks, const Classroom& room, const Digests& last) {
    const std::vector<std::string> places = placesOf(marks, room);
    for (std::size_t i = 0; i < room.entries.size(); ++i) {
        if (places[i].empty()) continue;
        const auto known = last.find(room.entries[i].submission.key);
        const std::string& digest = known == last.end() ? room.entries[i].digest : known->second;
        OwnMarks& own = marks.at(places[i]);
        for (const auto& [check, points] : own.points)
            if (!digest.empty()) own.handedIn.try_emplace(check, digest);
    }
}

std::vector<std::string> placesOf(const TeacherMarks& marks, const Classroom& room) {
    std::vector<std::string> places(room.entries.size());
    // Those with a number or folder of their own come first.
    for (const bool hasKey : {true, false})
        for (const auto& [name, each] : marks) {
            if (hasKey != (!each.number.empty() || !each.folder.empty())) continue;
            const std::optional<std::size_t> entry = entryOf(room, name, each);
            if (entry && places[*entry].empty()) places[*entry] = name;
        }
    return places;
}

OwnMarks& marksOf(TeacherMarks& marks, const Classroom& room, std::size_t entry) {
    const Submission& submission = room.entries[entry].submission;
    std::string name = placesOf(marks, room)[entry];
    if (name.empty()) {
        // The name may be that of marks which belong to nobody here.
        name = submission.name;
        for (int number = 2; marks.contains(name); ++number)
            name = fmt::format("{} {}", submission.name, number);
    }
    OwnMarks& own = marks[name];
    own.number = submission.number;
    own.folder = submission.key;
    return own;
}

void typePoints(OwnMarks& marks, const Entry& entry, const std::string& check,
                const std::optional<double>& points) {
    marks.handedIn.erase(check);
    if (!points) {
        marks.points.erase(check);
        return;
    }
    marks.points[check] = *points;
    if (!entry.digest.empty()) marks.handedIn[check] = entry.digest;
}

Diagnostics applyTeacherMarks(const TeacherMarks& marks, Classroom& room) {
    Diagnostics remarks;
    const auto remark = [&](const std::string& text) { remarks.push_back(diagnose("suite-W05", text)); };
    const auto nowhere = [&](const std::string& text) {
        room.unplaced.push_back(text);
        remark(fmt::format("{}: {}; it stays in the file", kMarksFile, text));
    };
    room.unplaced.clear();
    const std::vector<std::string> places = placesOf(marks, room);
    for (const auto& [name, each] : marks) {
        if (std::ranges::find(places, name) != places.end()) continue;
        std::string what;
        for (const auto& [check, points] : each.points)
            what += (what.empty() ? "" : ", ") + pointsText(points, check);
        if (!each.comment.empty()) what += what.empty() ? "a comment" : " and a comment";
        if (!what.empty()) nowhere(fmt::format("no submission is '{}', which has {}", name, what));
    }
    for (std::size_t i = 0; i < room.entries.size(); ++i) {
        Entry& entry = room.entries[i];
        entry.comment.clear();
        if (places[i].empty()) continue;
        const OwnMarks& own = marks.at(places[i]);
        entry.comment = own.comment;
        for (const auto& [check, points] : own.points) {
            const auto mark = std::ranges::find(entry.marks, check, &Mark::check);
            if (!std::isfinite(points)) continue;
            if (mark == entry.marks.end()) {
                if (!entry.marks.empty())
                    nowhere(fmt::format("the rubric has no check for the {} of '{}'",
                                        pointsText(points, check), entry.submission.name));
                continue;
            }
            const auto typedFor = own.handedIn.find(check);
            const bool isEarlier =
                typedFor != own.handedIn.end() && !entry.digest.empty() && typedFor->second != entry.digest;
            if (isEarlier) {
                remark(fmt::format("'{}' was handed in again after you typed {}: {}", entry.submission.name,
                                   pointsText(points, check),
                                   mark->isOpen ? "they stay" : "those of the check count again"));
                if (!mark->isOpen) {
                    mark->reason += fmt::format("{}you typed {:g} for an earlier hand-in",
                                                mark->reason.empty() ? "" : "; ", points);
                    continue;
                }
            }
            mark->points = std::clamp(points, 0.0, mark->most);
            mark->isOwn = true;
            mark->isOpen = false;
            mark->reason =
                isEarlier ? "the teacher's own points, for an earlier hand-in" : "the teacher's own points";
        }
    }
    return remarks;
}

}  // namespace glibra::classroom
