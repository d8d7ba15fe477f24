#include "classroom/page_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <ranges>
#include <tuple>
#include <utility>

#include "base/contained.h"
#include "base/files.h"
#include "base/text.h"
#include "base/utf8.h"
#include "classroom/review.h"
#include "suite/report/report_pictures.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostMessages = 30;  // of a submission
constexpr std::size_t kMostQuoted = 5;     // errors with their lines
constexpr std::size_t kLongestLine = 400;  // bytes of a source line
constexpr int kContext = 2;                // lines around that of a message
constexpr std::uint64_t kLargestEmbedded = std::uint64_t{64} << 20U;

std::string addressOf(const PictureSource& source, const Picture& picture) {
    if (!source.embeddedFrom) return picture.file;
    if (!picture.small.empty()) return picture.small;
    const auto bytes = base::bytesIn(base::openBeneath(*source.embeddedFrom, picture.file), kLargestEmbedded);
    return bytes ? "data:image/png;base64," + suite::base64(*bytes) : std::string();
}

/// The line that a message names, between its neighbours.
std::vector<base::Fields> quoteRows(const Entry& entry, const Place& place, SourceLines& sources) {
    if (place.line < 1 || place.file.empty() || entry.submission.folder.empty()) return {};
    const int from = std::max(1, place.line - kContext);
    const auto lines = sources.lines(entry.submission, place.file, from, place.line + kContext);
    if (!lines || static_cast<int>(lines->size()) <= place.line - from) return {};
    return lineRows(*lines, from, [&](int number) { return number == place.line ? "named" : ""; });
}

/// The message, with its file relative to the submission.
std::string messageText(const Entry& entry, const Diagnostic& message) {
    Diagnostic shown = message;
    const fs::path inside = fs::path(shown.place.file).lexically_relative(entry.submission.folder);
    if (!inside.empty() && *inside.begin() != "..") shown.place.file = inside.generic_string();
    return toString(shown);
}

}  // namespace

std::string figureText(double value) {
    return fmt::format("{:.3f}", value);
}

std::string percentText(double share) {
    return fmt::format("{:.0f} %", 100 * share);
}

std::optional<std::vector<std::string>> SourceLines::lines(const Submission& submission,
                                                           const std::string& path, int from, int to) {
    const auto [known, isNew] = texts_.try_emplace(path);
    if (isNew) {
        base::Roots folder;
        folder.add(submission.folder);
        known->second = base::textIn(folder.open(path), kLargestSource);
    }
    if (!known->second) return std::nullopt;
    std::vector<std::string> found;
    std::string_view rest = *known->second;
    for (int line = 1; line <= to && !rest.empty(); ++line) {
        const std::string_view one = base::nextLine(rest);
        if (line >= from) found.emplace_back(one.substr(0, kLongestLine));
    }
    return found;
}

std::vector<base::Fields> lineRows(const std::vector<std::string>& lines, int first,
                                   const std::function<std::string(int)>& lookOf) {
    std::vector<base::Fields> rows;
    for (const std::string& each : lines) {
        const int number = first + static_cast<int>(rows.size());
        rows.push_back({{"number", number}, {"look", lookOf(number)}, {"text", each}});
    }
    return rows;
}

namespace {

/// Rows of messages, the first of them with the lines that they name.
std::vector<base::Fields> messageRows(const Entry& entry, const std::vector<const Diagnostic*>& messages,
                                      std::size_t quoted, SourceLines& sources) {
    std::vector<base::Fields> rows;
    for (const Diagnostic* each : messages | std::views::take(kMostMessages))
        rows.push_back({{"severity", name(each->severity)},
                        {"text", messageText(entry, *each)},
                        {"lines", rows.size() < quoted ? quoteRows(entry, each->place, sources)
                                                       : std::vector<base::Fields>()}});
    return rows;
}

/// The errors with the lines that they name, then the warnings, one line for each kind.
base::Fields messageFields(const Entry& entry, SourceLines& sources) {
    std::vector<const Diagnostic*> errors;
    // In the order of their first occurrence, those of one kind together.
    std::vector<std::pair<std::string, std::vector<const Diagnostic*>>> kinds;
    for (const Diagnostic& each : entry.diagnostics) {
        if (each.severity == Severity::error) {
            errors.push_back(&each);
            continue;
        }
        const std::string kind = each.id.empty() ? "others" : each.id;
        auto known = std::ranges::find_if(kinds, [&](const auto& one) { return one.first == kind; });
        if (known == kinds.end()) known = kinds.insert(kinds.end(), {kind, {}});
        known->second.push_back(&each);
    }
    const auto kindFields = [&](const auto& each) {
        const auto& [kind, all] = each;
        return base::Fields{{"kind", kind},
                            {"severity", name(all[0]->severity)},
                            {"text", all[0]->text},
                            {"times", all.size() > 1 ? std::to_string(all.size()) : ""},
                            {"all", messageRows(entry, all, 1, sources)},
                            {"more", base::leftOut(all.size(), kMostMessages)}};
    };
    return {{"hasMessages", !entry.diagnostics.empty()},
            {"errors", messageRows(entry, errors, kMostQuoted, sources)},
            {"moreErrors", base::leftOut(errors.size(), kMostMessages)},
            {"kinds", base::rowsOf(kinds, kindFields)}};
}

/// Each picture beside the reference's. Nothing for a submission without any picture: the reference is on the
/// page once.
base::Fields picturesFields(const PictureSource& source, const Classroom& room, const Entry& entry) {
    if (std::ranges::all_of(entry.pictures, [](const Picture& each) { return each.file.empty(); })) return {};
    const std::string name = base::printableText(entry.submission.name);
    std::vector<base::Fields> rows;
    for (std::size_t i = 0; i < std::min(entry.pictures.size(), source.most); ++i) {
        const Picture& picture = entry.pictures[i];
        const std::string& label = room.moments[i].label;
        const std::string caption =
            picture.score
                ? fmt::format("likeness {}{}, FLIP {}, structure {}", figureText(picture.score->likeness),
                              picture.score->effect ? ", effect " + figureText(*picture.score->effect) : "",
                              figureText(picture.score->flip), figureText(picture.score->structure))
            : picture.isIncomplete   ? std::string("incomplete: the scene has errors")
            : picture.reason.empty() ? std::string()
                                     : std::string("not drawn");
        // Where there is no picture, there is nothing to compare.
        const bool isPair = hasReference(room) && !picture.file.empty();
        Picture shape = hasReference(room) ? room.reference.pictures[i] : picture;
        std::vector<base::Fields> figures;
        if (isPair)
            figures.push_back(
                figureFields(source, shape, shape, "the reference", label.empty() ? "reference" : label));
        if (shape.height == 0) std::tie(shape.width, shape.height) = std::pair(4, 3);
        const char* between = label.empty() || caption.empty() ? "" : ": ";
        figures.push_back(
            figureFields(source, picture, shape, name, isPair ? caption : label + between + caption));
        rows.push_back({{"isPair", isPair}, {"figures", std::move(figures)}});
    }
    return {{"pictures", std::move(rows)},
            {"morePictures", base::leftOut(entry.pictures.size(), source.most)}};
}

/// The points by check, with reasons.
base::Fields markFields(const Classroom& room, const Entry& entry, bool linksPictures) {
    const auto row = [&](const Mark& each) {
        const bool isLinked = linksPictures && each.moment && *each.moment < entry.pictures.size();
        const std::string label = isLinked ? room.moments[*each.moment].label : "";
        return base::Fields{{"look", each.isOwn                     ? "own"
                                     : each.isOpen && !each.isBonus ? "open"
                                                                    : ""},
                            {"check", each.check},
                            {"isBonus", each.isBonus},
                            {"most", each.most},
                            {"given", each.isOpen ? "" : fmt::format("{:g}", each.points)},
                            {"reason", each.reason},
                            {"picture", isLinked ? entry.pictures[*each.moment].file : ""},
                            {"label", label.empty() ? "picture" : label}};
    };
    return {{"marks", base::rowsOf(entry.marks, row)},
            {"points", pointsOf(entry).value_or(0)},
            {"mostPoints", mostPoints(room)},
            {"lateReason", entry.lateReason},
            {"comment", entry.comment}};
}

/// "uTol yes, uAd no", with the figures of both.
std::vector<base::Fields> reactionRows(const Classroom& room, const Entry& entry) {
    std::vector<base::Fields> rows;
    for (std::size_t i = 0; i < room.sliders.size(); ++i) {
        const Reacts reacts = reactsOf(room, entry, i);
        if (reacts == Reacts::unknown) continue;
        const std::optional<Change> expected =
            i < room.reference.reactions.size() ? room.reference.reactions[i] : std::nullopt;
        rows.push_back({{"slider", room.sliders[i].name},
                        {"reacts", name(reacts)},
                        {"strength", figureText(entry.reactions[i]->strength)},
                        {"expected", expected ? figureText(expected->strength) : ""}});
    }
    return rows;
}

base::Fields programFields(const UsedProgram& program) {
    const auto uniform = [](const DeclaredUniform& each) {
        return base::Fields{{"uniform", each.name}, {"type", each.type}};
    };
    return {{"program", program.name},
            {"stages", fmt::format("{}", fmt::join(program.stages, ", "))},
            {"uniforms", base::rowsOf(program.uniforms, uniform)}};
}

/// The words of a state, and its class in report.css.
base::Fields stateFields(const Entry& entry) {
    const std::string state = stateOf(entry);
    const char* look = state == "drawn"                            ? "passed"
                       : state == "no-scene" || state == "nothing" ? "missing"
                                                                   : state.c_str();
    std::string words = state == "no-scene" ? "no scene" : state == "nothing" ? "draws nothing" : state;
    if (const std::size_t drawn = drawnCount(entry); drawn > 0 && drawn < entry.pictures.size())
        words = fmt::format("{} of {} drawn", drawn, entry.pictures.size());
    return {{"look", look}, {"state", words}};
}

}  // namespace

base::Fields figureFields(const PictureSource& source, const Picture& picture, const Picture& shape,
                          const std::string& alternative, const std::string& caption) {
    const std::string address = picture.file.empty() ? std::string() : addressOf(source, picture);
    const Picture& sized = address.empty() ? shape : picture;
    return {{"address", address},         {"isLinked", !source.embeddedFrom},
            {"alternative", alternative}, {"caption", caption},
            {"width", sized.width},       {"height", sized.height}};
}

base::Fields entryFields(const PictureSource& source, const Classroom& room, const Entry& entry,
                         SourceLines& sources) {
    const std::string reason = reasonOf(entry);
    // The reason is one of the messages, unless the process ended or there is no scene.
    const bool isMessage = !entry.diagnostics.empty() && !entry.drawsNothing;
    base::Fields fields = {{"name", base::printableText(entry.submission.name)},
                           {"why", isMessage ? "" : base::printableText(reason)},
                           {"reactions", reactionRows(room, entry)},
                           {"programs", base::rowsOf(entry.programs, programFields)}};
    base::append(fields, stateFields(entry));
    base::append(fields, messageFields(entry, sources));
    base::append(fields, picturesFields(source, room, entry));
    base::append(fields, markFields(room, entry, !source.embeddedFrom));
    return fields;
}

}  // namespace glibra::classroom
