#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/contained.h"
#include "base/files.h"
#include "classroom/class_page.h"
#include "classroom/grades.h"
#include "cli/class_input.h"
#include "cli/commands.h"
#include "suite/golden/hash_list.h"
#include "suite/serve/loopback_server.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using suite::WebReply;
using suite::WebRequest;

constexpr std::uint64_t kLargestPicture = std::uint64_t{1} << 28U;
constexpr std::size_t kLongestComment = 10'000;
constexpr std::size_t kMostUndone = 200, kMostKept = 200;
/// The file beside the marks that keeps comments for reuse: a list of texts.
constexpr const char* kCommentsFile = "comments.json";

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
    const system::File opened = base::openBeneath(site, file);
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

/// For each entry the others that have the same pixels in all their pictures; entries without a picture have
/// none.
std::vector<std::vector<std::size_t>> entriesAlike(const classroom::Classroom& room, const fs::path& site) {
    std::map<std::string, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < room.entries.size(); ++i) {
        std::string key;
        bool isWhole = classroom::isDrawn(room.entries[i]);
        for (const classroom::Picture& each : room.entries[i].pictures) {
            const auto bytes = base::bytesIn(base::openBeneath(site, each.file), kLargestPicture);
            isWhole = isWhole && bytes;
            if (bytes) key += suite::toText(suite::hashOf(*bytes));
        }
        if (isWhole) groups[key].push_back(i);
    }
    std::vector<std::vector<std::size_t>> alike(room.entries.size());
    for (const auto& [key, members] : groups)
        for (const std::size_t each : members)
            for (const std::size_t other : members)
                if (other != each) alike[each].push_back(other);
    return alike;
}

Json readComments(const fs::path& site) {
    const auto text = base::textIn(base::openBeneath(site, kCommentsFile), kLargestPicture);
    const Json json = text ? Json::parse(*text, nullptr, false) : Json();
    Json comments = Json::array();
    if (json.is_array())
        for (const Json& each : json)
            if (each.is_string() && comments.size() < kMostKept) comments.push_back(each);
    return comments;
}

std::string textOf(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The marks of a class while they are typed.
class Marking {
  public:
    explicit Marking(const ClassService& service)
        : service_(service),
          alike_(entriesAlike(service.room, service.site)),
          comments_(readComments(service.site)) {}

    /// What the page needs besides itself: {"alike": [[numbers on the page], ...], "comments", "canUndo"}.
    [[nodiscard]] WebReply facts() const {
        const std::vector<std::string> names = shownBy(service_).names;
        Json alike = Json::array();
        for (std::size_t shown = 0; shown < names.size(); ++shown) {
            Json others = Json::array();
            const std::optional<std::size_t> entry = entryOf({{"entry", shown}}, service_);
            if (entry)
                for (const std::size_t other : alike_[*entry]) others.push_back(shownNumber(other));
            alike.push_back(std::move(others));
        }
        return {200, "application/json",
                textOf({{"alike", std::move(alike)}, {"comments", comments_}, {"canUndo", !steps_.empty()}})};
    }

    /// Changes points or the comment of an entry; with "alike": true gives what was typed for it to those
    /// with the same pictures.
    WebReply take(const WebRequest& request) {
        const Json asked = Json::parse(request.body, nullptr, false);
        const std::optional<std::size_t> index = entryOf(asked, service_);
        if (!index) return wrong("expected the number of an entry");
        Step step{service_.own, {*index}};
        classroom::TeacherMarks changed = service_.own;
        if (asked.value("alike", Json()) == true) {
            step.entries = alike_[*index];
            if (step.entries.empty()) return wrong("no other submission has the same pictures");
            giveToOthers(*index, changed);
        } else if (const std::string problem = change(asked, service_.room.entries[*index],
                                                      classroom::marksOf(changed, service_.room, *index));
                   !problem.empty()) {
            return wrong(problem);
        }
        if (std::optional<WebReply> problem = keep(std::move(changed))) return *problem;
        steps_.push_back(std::move(step));
        if (steps_.size() > kMostUndone) steps_.erase(steps_.begin());
        return marksReply(steps_.back().entries);
    }

    /// Takes the last change back, whoever made it.
    WebReply undo() {
        if (steps_.empty()) return wrong("nothing was changed since the page is served");
        const Step last = steps_.back();
        if (std::optional<WebReply> problem = keep(last.before)) return *problem;
        steps_.pop_back();
        return marksReply(last.entries);
    }

    /// {"add": TEXT} or {"remove": TEXT} changes the comments that are kept for reuse.
    WebReply changeComments(const WebRequest& request) {
        const Json asked = Json::parse(request.body, nullptr, false);
        const char* const verb = asked.is_object() && asked.contains("add") ? "add" : "remove";
        if (!asked.is_object() || !asked.contains(verb) || !asked[verb].is_string())
            return wrong("expected a comment to add or to remove");
        const auto text = asked[verb].get<std::string>();
        if (text.empty() || text.size() > kLongestComment)
            return wrong("expected a comment of 1 to 10,000 bytes");
        Json changed = comments_;
        std::erase_if(changed.get_ref<Json::array_t&>(), [&](const Json& each) { return each == text; });
        if (verb == std::string_view("add")) changed.push_back(text);
        if (changed.size() > kMostKept) return wrong(fmt::format("{} comments are kept already", kMostKept));
        const std::string file = changed.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
        if (base::writeBeneath(service_.site, kCommentsFile, std::as_bytes(std::span(file))) != 0)
            return {500, "application/json", textOf({{"error", "cannot write comments.json"}})};
        comments_ = std::move(changed);
        return {200, "application/json", textOf({{"comments", comments_}})};
    }

  private:
    struct Step {
        classroom::TeacherMarks before;
        std::vector<std::size_t> entries;  ///< that it changed
    };

    /// The number of an entry on the page.
    [[nodiscard]] std::size_t shownNumber(std::size_t entry) const {
        const std::vector<std::string> names = shownBy(service_).names;
        const auto found = std::ranges::find(names, service_.room.entries[entry].submission.name);
        return static_cast<std::size_t>(found - names.begin());
    }

    void giveToOthers(std::size_t from, classroom::TeacherMarks& marks) const {
        const classroom::OwnMarks given = classroom::marksOf(marks, service_.room, from);
        for (const std::size_t each : alike_[from]) {
            classroom::OwnMarks& own = classroom::marksOf(marks, service_.room, each);
            own.comment = given.comment;
            for (const classroom::Mark& mark : service_.room.entries[each].marks) {
                const auto typed = given.points.find(mark.check);
                if (typed != given.points.end())
                    classroom::typePoints(own, service_.room.entries[each], mark.check, typed->second);
            }
        }
    }

    /// Writes the marks and makes page and tables anew. Nothing if all is well.
    std::optional<WebReply> keep(classroom::TeacherMarks marks) {
        const auto failed = [](const char* why) {
            return WebReply{500, "application/json", textOf({{"error", why}})};
        };
        if (classroom::writeTeacherMarks(marks, service_.site) != 0) return failed("cannot write marks.json");
        service_.own = std::move(marks);
        service_.mark();
        if (!service_.write()) return failed("cannot write the page");
        return std::nullopt;
    }

    [[nodiscard]] WebReply marksReply(const std::vector<std::size_t>& entries) const {
        Json reply = {{"entries", Json::array()}, {"canUndo", !steps_.empty()}};
        for (const std::size_t index : entries) {
            const classroom::Entry& entry = service_.room.entries[index];
            Json one = {{"entry", shownNumber(index)}, {"marks", Json::array()}, {"comment", entry.comment}};
            for (const classroom::Mark& each : entry.marks)
                one["marks"].push_back({{"check", each.check},
                                        {"points", each.points},
                                        {"own", each.isOwn},
                                        {"open", each.isOpen && !each.isBonus}});
            if (const std::optional<double> points = classroom::pointsOf(entry)) one["points"] = *points;
            reply["entries"].push_back(std::move(one));
        }
        return {200, "application/json", textOf(reply)};
    }

    const ClassService& service_;
    std::vector<std::vector<std::size_t>> alike_;
    Json comments_;
    std::vector<Step> steps_;
};

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
    Marking marking(service);
    server.get("facts", [&](const WebRequest&) { return marking.facts(); });
    server.post("marks", [&](const WebRequest& request) { return marking.take(request); });
    server.post("undo", [&](const WebRequest&) { return marking.undo(); });
    server.post("comments", [&](const WebRequest& request) { return marking.changeComments(request); });
    printLine("points and comments: " + server.address());
    printLine("they are kept in " + (service.site / classroom::kMarksFile).generic_string() +
              "; Ctrl-C ends the server");
    server.run(service.stop);
    return kDone;
}

}  // namespace glibra::cli
