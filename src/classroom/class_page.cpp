#include "classroom/class_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "base/page_template.h"
#include "base/utf8.h"
#include "classroom/grades.h"
#include "classroom/review.h"
#include "embedded/class_page.h"
#include "embedded/report_page.h"
#include "glib/text.h"
#include "suite/report/escape_xml.h"
#include "suite/report/plain_page.h"
#include "suite/results/figures.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;
using suite::escapeXml;

constexpr std::size_t kMostPassages = 10;      // of a pair
constexpr std::size_t kMostPassageLines = 60;  // of a passage, on each side
constexpr std::size_t kMostMessages = 30;      // of a submission
constexpr std::size_t kLongestLine = 400;      // bytes of a source line

/// A name that a stranger chose. <bdi> keeps its direction to itself.
std::string nameHtml(std::string_view name) {
    return "<bdi>" + escapeXml(base::printableText(name)) + "</bdi>";
}

std::string anchor(std::size_t entry) {
    return fmt::format("s{:04}", entry + 1);
}

std::string link(const Classroom& room, std::size_t entry) {
    return fmt::format("<a href=\"#{}\">{}</a>", anchor(entry),
                       nameHtml(room.entries[entry].submission.name));
}

std::string percent(double share) {
    return fmt::format("{:.0f} %", 100 * share);
}

std::string figure(double value) {
    return fmt::format("{:.3f}", value);
}

/// The words of a state, and its class in report.css.
std::string stateHtml(const Entry& entry) {
    const std::string state = stateOf(entry);
    const char* look = state == "drawn" ? "passed" : state == "no-scene" ? "missing" : state.c_str();
    std::string words = state == "no-scene" ? "no scene" : state;
    if (const std::size_t drawn = drawnCount(entry); drawn > 0 && drawn < entry.pictures.size())
        words = fmt::format("{} of {} drawn", drawn, entry.pictures.size());
    return fmt::format("<span class=\"verdict {}\">{}</span>", look, words);
}

/// `shape` has the width and height of the place of a picture that is missing.
std::string pictureHtml(const Picture& picture, const Picture& shape, const std::string& alternative,
                        const std::string& caption) {
    if (picture.file.empty())
        return fmt::format(
            "<figure><div class=\"none\" style=\"aspect-ratio: {} / {}\">no picture</div>"
            "<figcaption>{}</figcaption></figure>",
            shape.width, shape.height, caption);
    return fmt::format(
        "<figure><a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\" width=\"{2}\" height=\"{3}\" "
        "loading=\"lazy\" decoding=\"async\"></a><figcaption>{4}</figcaption></figure>",
        picture.file, alternative, picture.width, picture.height, caption);
}

std::string messagesHtml(const Diagnostics& diagnostics) {
    std::string items;
    for (std::size_t i = 0; i < std::min(diagnostics.size(), kMostMessages); ++i)
        items += fmt::format("<li class=\"remark {}\">{}</li>", name(diagnostics[i].severity),
                             escapeXml(toString(diagnostics[i])));
    if (diagnostics.size() > kMostMessages)
        items += fmt::format("<li>{} more messages</li>", diagnostics.size() - kMostMessages);
    return items.empty() ? items : "<ul class=\"messages\">" + items + "</ul>";
}

std::set<DeclaredUniform> uniformsOf(const Entry& entry) {
    std::set<DeclaredUniform> uniforms;
    for (const UsedProgram& each : entry.programs)
        uniforms.insert(each.uniforms.begin(), each.uniforms.end());
    return uniforms;
}

std::string programsHtml(const Entry& entry) {
    std::string rows;
    for (const UsedProgram& each : entry.programs) {
        std::string uniforms;
        for (const DeclaredUniform& one : each.uniforms)
            uniforms += fmt::format("{}<code>{}</code> <small>{}</small>", uniforms.empty() ? "" : ", ",
                                    escapeXml(one.name), escapeXml(one.type));
        rows += fmt::format("<tr><th>{}</th><td>{}</td><td>{}</td></tr>", escapeXml(each.name),
                            escapeXml(fmt::format("{}", fmt::join(each.stages, ", "))),
                            uniforms.empty() ? "no uniforms" : uniforms);
    }
    return rows.empty()
               ? rows
               : "<table class=\"programs\"><thead><tr><th>program</th><th>stages</th><th>uniforms</th></tr>"
                 "</thead>" +
                     rows + "</table>";
}

std::string factsHtml(const Classroom& room, const Entry& entry) {
    const std::set<DeclaredUniform> own = uniformsOf(entry);
    std::string missing;
    if (!entry.programs.empty())
        for (const DeclaredUniform& each : uniformsOf(room.reference))
            if (std::none_of(own.begin(), own.end(),
                             [&](const DeclaredUniform& one) { return one.name == each.name; }))
                missing +=
                    fmt::format("{}<code>{}</code>", missing.empty() ? "" : ", ", escapeXml(each.name));
    std::string html = programsHtml(entry);
    if (!missing.empty()) html += "<p>Only in the reference: " + missing + "</p>";
    if (!entry.submission.scene.empty())
        html += fmt::format(
            "<p>Scene: <code>{}</code></p>",
            escapeXml(entry.submission.scene.lexically_relative(entry.submission.folder).string()));
    if (!entry.reproduce.empty())
        html += fmt::format("<div class=\"command\"><code>{}</code></div>", escapeXml(entry.reproduce));
    if (html.empty()) return html;
    return fmt::format("<details><summary>{}, {}</summary>{}</details>",
                       glib::counted(entry.programs.size(), "program"), glib::counted(own.size(), "uniform"),
                       html);
}

std::string picturesHtml(const Classroom& room, const Entry& entry) {
    std::string html;
    for (std::size_t i = 0; i < entry.pictures.size(); ++i) {
        const Picture& picture = entry.pictures[i];
        const std::string label = escapeXml(room.moments[i].label);
        std::string caption = picture.score
                                  ? fmt::format("FLIP {}, structure {}", figure(picture.score->flip),
                                                figure(picture.score->structure))
                                  : escapeXml(picture.reason.empty() ? "" : "not drawn");
        html += fmt::format("<div class=\"pair\">{}{}</div>",
                            pictureHtml(room.reference.pictures[i], room.reference.pictures[i],
                                        "the reference", label.empty() ? "reference" : label),
                            pictureHtml(picture, room.reference.pictures[i],
                                        escapeXml(base::printableText(entry.submission.name)), caption));
    }
    return html;
}

std::string cardHtml(const Classroom& room, std::size_t index) {
    const Entry& entry = room.entries[index];
    std::string html = fmt::format("<article class=\"card\" id=\"{}\"><h3>{} {}</h3>", anchor(index),
                                   nameHtml(entry.submission.name), stateHtml(entry));
    html += picturesHtml(room, entry);
    const std::string reason = reasonOf(entry);
    // The reason is one of the messages, unless the process ended or there is no scene.
    if (!reason.empty() && entry.diagnostics.empty())
        html += "<p class=\"reason\">" + escapeXml(reason) + "</p>";
    html += messagesHtml(entry.diagnostics);
    if (const std::optional<Nearest> nearest = nearestOf(room, index))
        html += fmt::format("<p class=\"near\">{} of its shader code is like that of {}</p>",
                            percent(nearest->share), link(room, nearest->entry));
    if (!entry.notCompared.empty())
        html += fmt::format(
            "<p class=\"near\">Not compared with other submissions: {}</p>",
            escapeXml(base::printableText(fmt::format("{}", fmt::join(entry.notCompared, "; ")))));
    return html + factsHtml(room, entry) + "</article>\n";
}

/// The lines of files of submissions, each read once.
class SourceLines {
  public:
    /// The lines from..to of a file in the folder; nothing if it cannot be read.
    std::optional<std::vector<std::string>> lines(const Submission& submission, const std::string& path,
                                                  int from, int to) {
        const auto [known, isNew] = texts_.try_emplace(path);
        if (isNew) known->second = read(submission.folder, path);
        if (!known->second) return std::nullopt;
        std::vector<std::string> found;
        std::string_view rest = *known->second;
        for (int line = 1; line <= to && !rest.empty(); ++line) {
            const std::size_t end = rest.find('\n');
            std::string_view one = rest.substr(0, end);
            if (one.ends_with('\r')) one.remove_suffix(1);
            if (line >= from) found.emplace_back(one.substr(0, kLongestLine));
            if (end == std::string_view::npos) break;
            rest.remove_prefix(end + 1);
        }
        return found;
    }

  private:
    static std::optional<std::string> read(const fs::path& folder, const std::string& path) {
        base::Roots roots;
        roots.add(folder);
        const base::Descriptor file = roots.open(path);
        std::vector<std::byte> bytes;
        if (!file || base::readAll(file, kLargestSource, bytes) != 0) return std::nullopt;
        return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    }

    std::map<std::string, std::optional<std::string>> texts_;
};

/// One side of a passage.
std::string sideHtml(const Entry& entry, const TokenPlace& place, std::size_t tokens, SourceLines& sources) {
    const SourceFile& file = entry.files[place.file];
    const int from = file.tokens[place.token].line;
    const int last = file.tokens[place.token + tokens - 1].line;
    const int to = std::min(last, from + static_cast<int>(kMostPassageLines) - 1);
    const std::string path = fs::path(file.path).lexically_relative(entry.submission.folder).string();
    std::string html = fmt::format("<div><h4>{}, {}{} {}{}</h4>", nameHtml(entry.submission.name),
                                   escapeXml(path.empty() ? file.path : path), ":", from,
                                   last > from ? fmt::format(" to {}", last) : "");
    const std::optional<std::vector<std::string>> lines =
        sources.lines(entry.submission, file.path, from, to);
    if (!lines) return html + "<p>the file cannot be read</p></div>";
    html += "<div class=\"source\"><ol>";
    for (std::size_t i = 0; i < lines->size(); ++i)
        html += fmt::format("<li data-line=\"{}\">{}</li>", static_cast<std::size_t>(from) + i,
                            escapeXml((*lines)[i]));
    return html + "</ol></div></div>";
}

/// False for places that the tokens do not have: a worker may have sent anything.
bool isInside(const Entry& entry, const TokenPlace& place, std::size_t tokens) {
    return tokens > 0 && place.file < entry.files.size() &&
           place.token + tokens <= entry.files[place.file].tokens.size();
}

std::string pairHtml(const Classroom& room, const SimilarPair& pair, SourceLines& sources) {
    const Entry& a = room.entries[pair.a];
    const Entry& b = room.entries[pair.b];
    const std::vector<SharedPassage> passages = sharedPassages(a.files, room.fingerprints[pair.a], b.files,
                                                               room.fingerprints[pair.b], kMostPassages + 1);
    std::size_t tokens = 0;
    for (const SharedPassage& each : passages) tokens += each.tokens;
    std::string html = fmt::format(
        "<details class=\"similar\"><summary>{} of {}, {} of {} <small>{}{}</small></summary>",
        percent(pair.ofA), nameHtml(a.submission.name), percent(pair.ofB), nameHtml(b.submission.name),
        passages.size() > kMostPassages ? "more than " : "", glib::counted(tokens, "equal token"));
    html += fmt::format("<p>{} and {}</p>", link(room, pair.a), link(room, pair.b));
    for (std::size_t i = 0; i < std::min(passages.size(), kMostPassages); ++i) {
        const SharedPassage& each = passages[i];
        if (isInside(a, each.a, each.tokens) && isInside(b, each.b, each.tokens))
            html += "<div class=\"sides\">" + sideHtml(a, each.a, each.tokens, sources) +
                    sideHtml(b, each.b, each.tokens, sources) + "</div>";
    }
    if (passages.size() > kMostPassages) html += "<p>Shorter passages are not shown.</p>";
    return html + "</details>\n";
}

std::string similarHtml(const Classroom& room) {
    if (room.pairs.empty()) return "<p>No two submissions share much code.</p>";
    SourceLines sources;
    std::string html;
    for (std::size_t i = 0; i < std::min(room.pairs.size(), kMostListedPairs); ++i)
        html += pairHtml(room, room.pairs[i], sources);
    if (room.pairs.size() > kMostListedPairs)
        html += fmt::format("<p>{} more pairs are less similar.</p>", room.pairs.size() - kMostListedPairs);
    return html;
}

std::string overviewHtml(const Classroom& room) {
    std::string rows;
    for (std::size_t i = 0; i < room.entries.size(); ++i) {
        const Entry& entry = room.entries[i];
        const std::optional<Scores> scores = scoresOf(entry);
        const std::optional<Nearest> nearest = nearestOf(room, i);
        const auto cell = [](const std::string& text) { return "<td>" + text + "</td>"; };
        rows += "<tr><th>" + link(room, i) + "</th>" + cell(stateHtml(entry)) +
                cell(scores ? figure(scores->flip) : "") + cell(scores ? figure(scores->structure) : "") +
                cell(fmt::format("{}", countOf(entry, Severity::error))) +
                cell(fmt::format("{}", countOf(entry, Severity::warning))) +
                cell(nearest ? percent(nearest->share) + " like " +
                                   nameHtml(room.entries[nearest->entry].submission.name)
                             : "") +
                "</tr>\n";
    }
    return "<table "
           "class=\"overview\"><thead><tr><th>submission</th><th>state</th><th>FLIP</th><th>structure</th>"
           "<th>errors</th><th>warnings</th><th>most similar</th></tr></thead><tbody>\n" +
           rows + "</tbody></table>";
}

std::string referenceHtml(const Classroom& room) {
    std::string html = "<div class=\"strip\">";
    for (std::size_t i = 0; i < room.reference.pictures.size(); ++i) {
        const Picture& picture = room.reference.pictures[i];
        html += pictureHtml(picture, picture, "the reference",
                            escapeXml(room.moments[i].label.empty()
                                          ? fmt::format("{} x {} pixels", picture.width, picture.height)
                                          : room.moments[i].label));
    }
    return html + "</div>" + messagesHtml(room.reference.diagnostics) + programsHtml(room.reference);
}

/// The cards of all entries that are drawn, or of all others.
std::string cardsHtml(const Classroom& room, bool drawn) {
    std::string html;
    for (std::size_t i = 0; i < room.entries.size(); ++i)
        if (isDrawn(room.entries[i]) == drawn) html += cardHtml(room, i);
    return html;
}

std::string section(const char* id, const char* title, const std::string& content) {
    if (content.empty()) return {};
    return fmt::format("<section id=\"{}\"><h2>{}</h2>{}</section>\n", id, title, content);
}

std::string leftOutHtml(const Classroom& room) {
    std::string items;
    for (const std::string& each : room.leftOut) items += "<li>" + nameHtml(each) + "</li>";
    return items.empty() ? items : "<p>These files are neither scenes nor folders.</p><ul>" + items + "</ul>";
}

std::string detailsHtml(const Classroom& room) {
    std::string html = "<dl>";
    const auto add = [&](std::string_view title, const std::string& value) {
        if (!value.empty()) html += fmt::format("<dt>{}</dt><dd>{}</dd>", title, escapeXml(value));
    };
    add("Submissions", room.folder);
    add("Reference", room.reference.submission.scene.string());
    add("Driver", room.driver);
    add("Machine", room.machine);
    add("Command", room.command);
    add("Began", room.began);
    add("Time", suite::readableTime(room.seconds));
    return html + "</dl>";
}

std::string grid(const std::string& cards) {
    return cards.empty() ? cards : "<div class=\"cards\">" + cards + "</div>";
}

}  // namespace

std::string classPage(const Classroom& room) {
    const std::string failed = section("failed", "Not drawn", grid(cardsHtml(room, false)));
    const std::string drawn = section("drawn", "Drawn", grid(cardsHtml(room, true)));
    const std::string leftOut = section("leftout", "Left out", leftOutHtml(room));
    std::string parts;
    for (const auto& [id, title, content] : {std::tuple{"failed", "Not drawn", &failed},
                                             {"drawn", "Drawn", &drawn},
                                             {"leftout", "Left out", &leftOut}})
        if (!content->empty()) parts += fmt::format("<a href=\"#{}\">{}</a> ", id, title);
    const base::Slot slots[] = {
        {"title", escapeXml(summary(room) + " - glibra")},
        {"headline", escapeXml(summary(room))},
        {"runDetails", detailsHtml(room)},
        {"style", std::string(report_page::report_css()) + std::string(class_page::class_css())},
        {"parts", parts},
        {"reference", referenceHtml(room)},
        {"overview", overviewHtml(room)},
        {"failed", failed},
        {"drawn", drawn},
        {"similar", similarHtml(room)},
        {"leftOut", leftOut},
        {"gram", fmt::format("{}", kLongestUnseen + 1)},
    };
    return suite::loadingFirstScreen(base::filled(class_page::class_html(), slots));
}

Diagnostics writeSite(const Classroom& room, const fs::path& site) {
    const auto write = [&](const char* name, const std::string& text) -> Diagnostics {
        const int problem = base::writeBeneath(site, name, std::as_bytes(std::span(text)));
        if (problem == 0) return {};
        return {diagnose("file-E10", fmt::format("cannot write '{}': {}", (site / name).string(),
                                                 std::generic_category().message(problem)))};
    };
    Diagnostics problems = write("grades.csv", gradesCsv(room));
    if (problems.empty()) problems = write("index.html", classPage(room));
    return problems;
}

}  // namespace glibra::classroom
