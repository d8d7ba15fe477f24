#include "cli/class_serve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/contained.h"
#include "classroom/class_page.h"
#include "classroom/grades.h"
#include "classroom/student_page.h"
#include "cli/commands.h"
#include "suite/serve/loopback_server.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using suite::WebReply;
using suite::WebRequest;

constexpr std::uint64_t kLargestPicture = std::uint64_t{1} << 28U;
constexpr std::size_t kLongestComment = 10'000;

WebReply wrong(const std::string& why) {
    return {400, "application/json", Json{{"error", why}}.dump()};
}

/// The class as the page shows it, and the names of its entries.
struct Shown {
    classroom::Classroom room;
    std::vector<std::string> names;
};

Shown shownBy(const ClassService& service) {
    Shown shown;
    if (service.isAnonymous) {
        shown.room = classroom::anonymous(service.room, shown.names);
        return shown;
    }
    shown.room = service.room;
    for (const classroom::Entry& each : service.room.entries) shown.names.push_back(each.submission.name);
    return shown;
}

WebReply pictureReply(const fs::path& site, const std::string& file) {
    const base::Descriptor opened = base::openBeneath(site, file);
    std::vector<std::byte> bytes;
    if (!opened || base::readAll(opened, kLargestPicture, bytes) != 0)
        return {404, "text/plain", "no picture"};
    return {200, "image/png", std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size())};
}

/// What one POST changes: {"entry": 3, "check": "is drawn", "points": 1.5} or {"entry": 3, "comment": "..."}.
/// Points null: those of the check again.
std::string change(const Json& asked, const classroom::Entry& entry, classroom::OwnMarks& marks) {
    if (asked.contains("comment")) {
        if (!asked["comment"].is_string() || asked["comment"].get<std::string>().size() > kLongestComment)
            return "expected a comment of at most 10,000 bytes";
        marks.comment = asked["comment"].get<std::string>();
    }
    if (!asked.contains("check")) return {};
    if (!asked["check"].is_string() || !asked.contains("points")) return "expected a check and its points";
    const auto check = asked["check"].get<std::string>();
    const auto mark = std::find_if(entry.marks.begin(), entry.marks.end(),
                                   [&](const classroom::Mark& each) { return each.check == check; });
    if (mark == entry.marks.end()) return "there is no such check";
    if (asked["points"].is_null()) {
        classroom::typePoints(marks, entry, check, std::nullopt);
        return {};
    }
    if (!asked["points"].is_number() || !std::isfinite(asked["points"].get<double>()))
        return "expected points as a number";
    const auto points = asked["points"].get<double>();
    if (points < 0 || points > mark->most)
        return fmt::format("expected points from 0 to {:g}, found {:g}", mark->most, points);
    classroom::typePoints(marks, entry, check, points);
    return {};
}

/// The number of the entry that a request names; nothing if there is none.
std::optional<std::size_t> entryOf(const Json& asked, const ClassService& service) {
    if (!asked.is_object() || !asked.contains("entry") || !asked["entry"].is_number_unsigned())
        return std::nullopt;
    const auto index = asked["entry"].get<std::size_t>();
    const std::vector<std::string> names = shownBy(service).names;
    if (index >= names.size()) return std::nullopt;
    const std::vector<classroom::Entry>& all = service.room.entries;
    const auto entry = std::find_if(all.begin(), all.end(), [&](const classroom::Entry& each) {
        return each.submission.name == names[index];
    });
    if (entry == all.end()) return std::nullopt;
    return static_cast<std::size_t>(entry - all.begin());
}

WebReply takeMarks(const ClassService& service, const WebRequest& request) {
    const Json asked = Json::parse(request.body, nullptr, false);
    const std::optional<std::size_t> index = entryOf(asked, service);
    if (!index) return wrong("expected the number of an entry");
    const classroom::Entry* const entry = &service.room.entries[*index];
    classroom::TeacherMarks changed = service.own;
    if (const std::string problem = change(asked, *entry, classroom::marksOf(changed, service.room, *index));
        !problem.empty())
        return wrong(problem);
    if (classroom::writeTeacherMarks(changed, service.site) != 0)
        return {500, "application/json", Json{{"error", "cannot write marks.json"}}.dump()};
    service.own = std::move(changed);
    service.mark();
    if (!service.write()) return {500, "application/json", Json{{"error", "cannot write the page"}}.dump()};
    Json reply = {{"marks", Json::array()}, {"comment", entry->comment}};
    for (const classroom::Mark& each : entry->marks)
        reply["marks"].push_back({{"check", each.check},
                                  {"points", each.points},
                                  {"own", each.isOwn},
                                  {"open", each.isOpen && !each.isBonus}});
    if (const std::optional<double> points = classroom::pointsOf(*entry)) reply["points"] = *points;
    return {200, "application/json", reply.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

}  // namespace

int serveClass(const ClassService& service) {
    Result<suite::LoopbackServer> opened = suite::LoopbackServer::open();
    print(opened.diagnostics);
    if (!opened) return kSceneIsWrong;
    suite::LoopbackServer& server = *opened;
    server.get("", [&](const WebRequest&) {
        return WebReply{200, "text/html; charset=utf-8", classroom::classPage(shownBy(service).room, true)};
    });
    server.get("class.js", [](const WebRequest&) {
        return WebReply{200, "text/javascript", std::string(classroom::classScript())};
    });
    server.get("grade.js", [](const WebRequest&) {
        return WebReply{200, "text/javascript", std::string(classroom::gradeScript())};
    });
    server.get("grades.csv", [&](const WebRequest&) {
        return WebReply{200, "text/csv; charset=utf-8", classroom::gradesCsv(service.room)};
    });
    const auto addPictures = [&](const classroom::Entry& entry) {
        for (const classroom::Picture& each : entry.pictures)
            if (!each.file.empty())
                server.get(each.file, [&service, file = each.file](const WebRequest&) {
                    return pictureReply(service.site, file);
                });
    };
    addPictures(service.room.reference);
    for (const classroom::Entry& each : service.room.entries) addPictures(each);
    server.post("marks", [&](const WebRequest& request) { return takeMarks(service, request); });
    printLine("points and comments: " + server.address());
    printLine("they are kept in " + (service.site / classroom::kMarksFile).string() +
              "; Ctrl-C ends the server");
    server.run(service.stop);
    return kDone;
}

}  // namespace glibra::cli
