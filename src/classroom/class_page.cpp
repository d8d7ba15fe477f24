#include "classroom/class_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <ranges>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "base/contained.h"
#include "base/files.h"
#include "base/hash.h"
#include "base/page_template.h"
#include "base/text.h"
#include "base/utf8.h"
#include "classroom/names.h"
#include "classroom/review.h"
#include "embedded/class_page.h"
#include "embedded/report_page.h"
#include "suite/report/report_files.h"
#include "suite/report/report_pictures.h"
#include "suite/results/results.h"
#include "suite/write_below.h"

namespace glibra::classroom {
namespace {

/// Pairs of similar submissions that the page lists with their passages; the others are counted.
constexpr std::size_t kMostListedPairs = 50;

constexpr const char* kStudentPages = "students";

// What the page of a class and the page of one student have in common.

/// The lines of files of submissions, each read once. No link is followed.
class SourceLines {
  public:
    /// The lines from..to of a file in the submission's folder; nothing if it cannot be read.
    std::optional<std::vector<std::string>> lines(const Submission& submission, const std::string& path,
                                                  int from, int to);

  private:
    std::map<std::string, std::optional<std::string>> texts_;
};

/// Where the pictures of a page are.
struct PictureSource {
    /// If given, pictures are read from this folder and are part of the page.
    std::optional<std::filesystem::path> embeddedFrom{};
    std::size_t most = 100;  ///< moments that are shown
};

// Fields of the templates in page/parts.html.

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

/// A picture with its caption. `shape` has the width and height of the place of a picture that is missing.
base::Fields figureFields(const PictureSource& source, const Picture& picture, const Picture& shape,
                          const std::string& alternative, const std::string& caption) {
    const std::string address = picture.file.empty() ? std::string() : addressOf(source, picture);
    const Picture& sized = address.empty() ? shape : picture;
    return {{"address", address},         {"isLinked", !source.embeddedFrom},
            {"alternative", alternative}, {"caption", caption},
            {"width", sized.width},       {"height", sized.height}};
}

/// `lookOf` gives the class of a line by its number; `first` is that of the first line.
std::vector<base::Fields> lineRows(const std::vector<std::string>& lines, int first,
                                   const std::function<std::string(int)>& lookOf) {
    std::vector<base::Fields> rows;
    for (const std::string& each : lines) {
        const int number = first + static_cast<int>(rows.size());
        rows.push_back({{"number", number}, {"look", lookOf(number)}, {"text", each}});
    }
    return rows;
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

/// Name, state, messages, pictures beside the reference's, points and programs of a submission.
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

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
    if (from.size() < 2) return;
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

std::string styleOfPages() {
    return std::string(report_page::report_css()) + std::string(class_page::class_css());
}

std::string withParts(std::string_view page) {
    return std::string(class_page::parts_html()) + std::string(page);
}

/// The names of the files of all: "Ana Lee.html".
std::vector<std::string> studentFiles(const Classroom& room) {
    std::vector<std::string> files;
    for (const Entry& each : room.entries) files.push_back(each.submission.name);
    files = fileNames(std::move(files));
    for (std::string& each : files) each += ".html";
    return files;
}

/// The page of one submission, to send back: its pictures beside the reference's, points, comment and
/// messages, all in one file. It has nothing of other submissions.
std::string studentPage(const Classroom& room, std::size_t index, const std::filesystem::path& site) {
    const PictureSource source{site, kMostStudentPictures};
    SourceLines sources;
    base::Fields fields = entryFields(source, room, room.entries[index], sources);
    fields.emplace_back("style", styleOfPages());
    return base::filled(withParts(class_page::student_html()), fields);
}

constexpr std::size_t kMostPassages = 30;  // of a pair
constexpr int kMostLines = 400;            // of a file beside another one

std::string anchorOf(std::size_t entry) {
    return fmt::format("s{:04}", entry + 1);
}

base::Fields linkFields(const Classroom& room, std::size_t entry) {
    return {{"name", base::printableText(comparedEntry(room, entry).submission.name)},
            {"anchor", entry < room.entries.size() ? anchorOf(entry) : ""}};
}

std::set<DeclaredUniform> uniformsOf(const Entry& entry) {
    std::set<DeclaredUniform> uniforms;
    for (const UsedProgram& each : entry.programs)
        uniforms.insert(each.uniforms.begin(), each.uniforms.end());
    return uniforms;
}

/// The uniforms of the reference that a submission does not have.
std::vector<std::string> missingUniforms(const Classroom& room, const Entry& entry) {
    const std::set<DeclaredUniform> own = uniformsOf(entry);
    std::vector<std::string> missing;
    if (entry.programs.empty()) return missing;
    for (const DeclaredUniform& each : uniformsOf(room.reference))
        if (std::ranges::find(own, each.name, &DeclaredUniform::name) == own.end())
            missing.push_back(each.name);
    return missing;
}

/// A submission's card, and its row of the table.
base::Fields cardFields(const Classroom& room, std::size_t index, SourceLines& sources) {
    const Entry& entry = room.entries[index];
    const std::optional<Scores> scores = scoresOf(entry);
    const std::vector<std::string> missing = missingUniforms(room, entry);
    const auto nearestFields = [&](const Nearest& each) {
        base::Fields fields = linkFields(room, each.entry);
        fields.emplace_back("share", percentText(each.share));
        return fields;
    };
    const fs::path& scene = entry.submission.scene;
    base::Fields fields = entryFields({}, room, entry, sources);
    base::append(
        fields,
        {
            {"anchor", anchorOf(index)},
            {"key", entry.submission.name},
            {"isDrawn", isDrawn(entry)},
            {"lookalikes",
             base::printableText(fmt::format("{}", fmt::join(lookalikesOf(room, entry), ", ")))},
            {"nearest", base::rowsOf(nearestOf(room, index), nearestFields)},
            {"notCompared", base::printableText(fmt::format("{}", fmt::join(entry.notCompared, "; ")))},
            {"hasFacts",
             !entry.programs.empty() || !missing.empty() || !scene.empty() || !entry.reproduce.empty()},
            {"programCount", base::counted(entry.programs.size(), "program")},
            {"uniformCount", base::counted(uniformsOf(entry).size(), "uniform")},
            {"missing", missing},
            {"scene",
             scene.empty() ? "" : scene.lexically_relative(entry.submission.folder).generic_string()},
            {"reproduce", entry.reproduce},
            {"open", openCount(entry) == 0 ? "" : std::to_string(openCount(entry))},
            {"likeness", scores ? figureText(scores->likeness) : ""},
            {"flip", scores ? figureText(scores->flip) : ""},
            {"structure", scores ? figureText(scores->structure) : ""},
            {"errorCount", countOf(entry, Severity::error)},
            {"warningCount", countOf(entry, Severity::warning)},
        });
    return fields;
}

/// False for places that the tokens do not have: a worker may have sent anything.
bool isInside(const Entry& entry, const TokenPlace& place, std::size_t tokens) {
    return tokens > 0 && place.file < entry.files.size() &&
           place.token + tokens <= entry.files[place.file].tokens.size();
}

/// For each file of one side the lines with tokens of passages, and the numbers of these.
using MarkedLines = std::map<std::string, std::map<int, std::size_t>>;

void markLines(const Entry& entry, const TokenPlace& place, std::size_t tokens, std::size_t number,
               MarkedLines& marked) {
    // Tokens are in normal form, so their lines may go back and forth.
    const SourceFile& file = entry.files[place.file];
    for (std::size_t i = 0; i < tokens; ++i) {
        const SourceToken& token = file.tokens[place.token + i];
        marked[file.pathOf(token)].try_emplace(token.line, number);
    }
}

/// The files of one side that have passages, with these marked.
base::Fields sideFields(const Entry& entry, const MarkedLines& marked, SourceLines& sources) {
    std::vector<base::Fields> files;
    for (const auto& [file, passages] : marked) {
        const std::string path = fs::path(file).lexically_relative(entry.submission.folder).generic_string();
        const int last = std::max(kMostLines, passages.rbegin()->first);
        const auto text = sources.lines(entry.submission, file, 1, std::min(last, 3 * kMostLines));
        const auto lookOf = [&](int line) {
            const auto mark = passages.find(line);
            return mark == passages.end() ? "" : fmt::format("p{}", mark->second % 6);
        };
        files.push_back({{"owner", base::printableText(entry.submission.name)},
                         {"file", path.empty() ? file : path},
                         {"isRead", text.has_value()},
                         {"lines", text ? lineRows(*text, 1, lookOf) : std::vector<base::Fields>()}});
    }
    return {{"files", std::move(files)}};
}

base::Fields pairFields(const Classroom& room, const SimilarPair& pair, SourceLines& sources) {
    const Entry& a = comparedEntry(room, pair.a);
    const Entry& b = comparedEntry(room, pair.b);
    const std::vector<SharedPassage> passages = sharedPassages(a.files, room.fingerprints[pair.a], b.files,
                                                               room.fingerprints[pair.b], kMostPassages + 1);
    std::size_t tokens = 0;
    for (const SharedPassage& each : passages) tokens += each.tokens;
    MarkedLines ofA, ofB;
    for (std::size_t i = 0; i < std::min(passages.size(), kMostPassages); ++i) {
        const SharedPassage& each = passages[i];
        if (!isInside(a, each.a, each.tokens) || !isInside(b, each.b, each.tokens)) continue;
        markLines(a, each.a, each.tokens, i, ofA);
        markLines(b, each.b, each.tokens, i, ofB);
    }
    std::vector<base::Fields> sides;
    if (!ofA.empty()) sides = {sideFields(a, ofA, sources), sideFields(b, ofB, sources)};
    return {{"ofA", percentText(pair.ofA)},
            {"nameA", base::printableText(a.submission.name)},
            {"ofB", percentText(pair.ofB)},
            {"nameB", base::printableText(b.submission.name)},
            {"isCut", passages.size() > kMostPassages},
            {"tokens", base::counted(tokens, "equal token")},
            {"ends", std::vector{linkFields(room, pair.a), linkFields(room, pair.b)}},
            {"sides", std::move(sides)}};
}

std::vector<base::Fields> referenceRow(const Classroom& room, SourceLines& sources) {
    if (!hasReference(room)) return {};
    std::vector<base::Fields> figures;
    for (std::size_t i = 0; i < room.reference.pictures.size(); ++i) {
        const Picture& picture = room.reference.pictures[i];
        const std::string& label = room.moments[i].label;
        figures.push_back(figureFields(
            {}, picture, picture, "the reference",
            label.empty() ? fmt::format("{} x {} pixels", picture.width, picture.height) : label));
    }
    base::Fields fields = entryFields({}, room, room.reference, sources);
    fields.emplace_back("figures", std::move(figures));
    return {std::move(fields)};
}

std::vector<base::Fields> leftOutRows(const Classroom& room) {
    std::vector<std::string> earlier;
    for (const Entry& each : room.earlier)
        if (each.submission.scene.empty()) earlier.push_back(each.submission.name);
    std::vector<base::Fields> rows;
    const auto add = [&](const char* title, std::vector<std::string> names) {
        for (std::string& each : names) each = base::printableText(each);
        if (!names.empty()) rows.push_back({{"title", title}, {"names", names}});
    };
    add("These files are no scenes, zip files or folders.", room.leftOut);
    add("These earlier submissions are not compared, because they have no scene.", earlier);
    add("These students of the roster handed in nothing that was found.", room.absent);
    add("These students handed something in and are not in the roster.", room.strangers);
    add("These points and comments of marks.json belong to no submission or check.", room.unplaced);
    return rows;
}

}  // namespace

Classroom anonymous(const Classroom& room, std::vector<std::string>& keys) {
    std::vector<std::size_t> order(room.entries.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        const auto key = [&](std::size_t i) {
            const std::string& name = room.entries[i].submission.name;
            return std::pair(base::murmurMixed(base::fnv1a(name)), name);
        };
        return key(a) < key(b);
    });
    std::vector<std::size_t> numberOf(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) numberOf[order[i]] = i;
    const auto nameOf = [](std::size_t number) { return fmt::format("Submission {:02}", number + 1); };
    Classroom made = room;
    made.command.clear();
    made.leftOut.clear();
    made.absent.clear();
    made.strangers.clear();
    made.unplaced.clear();
    keys.clear();
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Entry& from = room.entries[order[i]];
        Entry& to = made.entries[i];
        to = from;
        keys.push_back(from.submission.name);
        if (order[i] < room.fingerprints.size()) made.fingerprints[i] = room.fingerprints[order[i]];
        to.submission.name = nameOf(i);
        to.submission.number.clear();
        to.submission.email.clear();
        to.submission.members.clear();
        to.submission.key.clear();
        to.reproduce.clear();
        // Messages name the folder, and whoever made it put a name there.
        const auto clean = [&](std::string& text) {
            replaceAll(text, from.submission.folder.generic_string() + "/", "");
            for (std::size_t other = 0; other < order.size(); ++other) {
                const Submission& one = room.entries[other].submission;
                replaceAll(text, one.name, nameOf(numberOf[other]));
                for (const Member& each : one.members) replaceAll(text, each.name, nameOf(numberOf[other]));
                replaceAll(text, one.key, nameOf(numberOf[other]));
            }
        };
        clean(to.submission.problem);
        for (std::string& each : to.notCompared) clean(each);
        for (Picture& each : to.pictures) clean(each.reason);
        for (Mark& each : to.marks) clean(each.reason);
        for (Diagnostic& each : to.diagnostics) clean(each.text);
    }
    for (std::size_t i = 0; i < made.earlier.size(); ++i) {
        made.earlier[i].submission.name = fmt::format("Earlier submission {:02}", i + 1);
        made.earlier[i].submission.problem.clear();
    }
    for (SimilarPair& each : made.pairs) {
        each.a = numberOf[each.a];
        if (each.b < numberOf.size()) each.b = numberOf[each.b];
        if (each.a > each.b) {
            std::swap(each.a, each.b);
            std::swap(each.ofA, each.ofB);
        }
    }
    made.isAnonymous = true;
    return made;
}

std::string_view classScript() {
    return class_page::class_js();
}

std::string_view gradeScript() {
    return class_page::grade_js();
}

std::string classPage(const Classroom& room, bool serves) {
    SourceLines sources, sourcesOfPairs;
    std::vector<base::Fields> entries, failed, drawn;
    std::size_t openFields = 0, openEntries = 0;
    for (std::size_t i = 0; i < room.entries.size(); ++i) {
        entries.push_back(cardFields(room, i, sources));
        (stateOf(room.entries[i]) == "drawn" ? drawn : failed).push_back(entries.back());
        openFields += openCount(room.entries[i]);
        openEntries += openCount(room.entries[i]) > 0 ? 1 : 0;
    }
    const auto pair = [&](const SimilarPair& each) { return pairFields(room, each, sourcesOfPairs); };
    const base::Fields fields = {
        {"headline", summary(room)},
        {"style", styleOfPages()},
        {"serves", serves},
        {"details", base::titledRows({{"Submissions", room.isAnonymous ? "" : room.folder},
                                      {"Reference", room.reference.submission.scene.generic_string()},
                                      {"Driver", room.driver},
                                      {"Machine", room.machine},
                                      {"Command", room.command},
                                      {"Began", room.began},
                                      {"Time", suite::readableTime(room.seconds)}})},
        {"reference", referenceRow(room, sources)},
        {"count", room.entries.size()},
        {"openFields", openFields == 0 ? "" : base::counted(openFields, "field")},
        {"openEntries", base::counted(openEntries, "submission")},
        {"isScored", hasReference(room)},
        {"isMarked", mostPoints(room) > 0},
        {"isVaried", !room.sliders.empty()},
        {"entries", std::move(entries)},
        {"failed", std::move(failed)},
        {"drawn", std::move(drawn)},
        {"pairs", base::rowsOf(room.pairs | std::views::take(kMostListedPairs), pair)},
        {"morePairs", base::leftOut(room.pairs.size(), kMostListedPairs)},
        {"common", room.common},
        {"gram", kLongestUnseen + 1},
        {"leftOut", leftOutRows(room)},
    };
    return suite::loadingFirstScreen(base::filled(withParts(class_page::class_html()), fields));
}

Diagnostics writeSite(const Classroom& room, const fs::path& site, const SiteFiles& files) {
    Diagnostics problems;
    const auto write = [&](const std::string& name, std::string_view text) {
        if (!problems.empty()) return;
        problems = suite::writeBelow(site, name, std::as_bytes(std::span(text)));
    };
    write("grades.csv", gradesCsv(room));
    if (files.import.book != GradeBook::none)
        write(importFile(files.import.book), importTable(room, files.import));
    const std::vector<std::string> pages =
        files.studentPages ? studentFiles(room) : std::vector<std::string>();
    for (std::size_t i = 0; i < pages.size(); ++i)
        write(fmt::format("{}/{}", kStudentPages, pages[i]), studentPage(room, i, site));
    write("class.js", class_page::class_js());
    if (!files.isAnonymous) {
        write("index.html", classPage(room));
        return problems;
    }
    std::vector<std::string> keys;
    const Classroom shown = anonymous(room, keys);
    std::string names = "page,submission\r\n";
    for (std::size_t i = 0; i < keys.size(); ++i)
        names += shown.entries[i].submission.name + "," + csvField(keys[i]) + "\r\n";
    write("names.csv", names);
    write("index.html", classPage(shown));
    return problems;
}

}  // namespace glibra::classroom
