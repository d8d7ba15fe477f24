#include "classroom/class_page.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "base/hash.h"
#include "base/page_template.h"
#include "base/text.h"
#include "base/utf8.h"
#include "classroom/grades.h"
#include "classroom/names.h"
#include "classroom/page_parts.h"
#include "embedded/class_page.h"
#include "embedded/report_page.h"
#include "suite/report/html_report.h"
#include "suite/results/figures.h"
#include "suite/write_below.h"

namespace glibra::classroom {
namespace {

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
    if (from.size() < 2) return;
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

}  // namespace

std::vector<std::string> studentFiles(const Classroom& room) {
    std::vector<std::string> files;
    for (const Entry& each : room.entries) files.push_back(each.submission.name);
    files = fileNames(std::move(files));
    for (std::string& each : files) each += ".html";
    return files;
}

std::string studentPage(const Classroom& room, std::size_t index, const std::filesystem::path& site) {
    const Entry& entry = room.entries[index];
    const PictureSource source{site, kMostStudentPictures};
    SourceLines sources;
    std::string body = "<p>" + stateHtml(entry) + "</p>" + marksHtml(room, entry, "");
    const std::string reason = reasonOf(entry);
    if (!reason.empty() && (entry.diagnostics.empty() || entry.drawsNothing))
        body += "<p class=\"reason\">" + base::escapeXml(base::printableText(reason)) + "</p>";
    body += messagesHtml(entry, sources) + picturesHtml(source, room, entry) + programsHtml(entry);
    const base::Slot slots[] = {
        {"title", base::escapeXml(base::printableText(entry.submission.name))},
        {"headline", nameHtml(entry.submission.name)},
        {"style", std::string(report_page::report_css()) + std::string(class_page::class_css())},
        {"body", body},
    };
    return base::filled(class_page::student_html(), slots);
}

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

namespace {

namespace fs = std::filesystem;
using base::escapeXml;

constexpr std::size_t kMostPassages = 30;  // of a pair
constexpr int kMostLines = 400;            // of a file beside another one

std::string anchor(std::size_t entry) {
    return fmt::format("s{:04}", entry + 1);
}

std::string link(const Classroom& room, std::size_t entry) {
    const std::string name = nameHtml(comparedEntry(room, entry).submission.name);
    return entry < room.entries.size() ? fmt::format("<a href=\"#{}\">{}</a>", anchor(entry), name) : name;
}

std::set<DeclaredUniform> uniformsOf(const Entry& entry) {
    std::set<DeclaredUniform> uniforms;
    for (const UsedProgram& each : entry.programs)
        uniforms.insert(each.uniforms.begin(), each.uniforms.end());
    return uniforms;
}

std::string factsHtml(const Classroom& room, const Entry& entry) {
    const std::set<DeclaredUniform> own = uniformsOf(entry);
    std::string missing;
    if (!entry.programs.empty())
        for (const DeclaredUniform& each : uniformsOf(room.reference))
            if (std::ranges::find(own, each.name, &DeclaredUniform::name) == own.end())
                missing +=
                    fmt::format("{}<code>{}</code>", missing.empty() ? "" : ", ", escapeXml(each.name));
    std::string html = programsHtml(entry);
    if (!missing.empty()) html += "<p>Only in the reference: " + missing + "</p>";
    if (!entry.submission.scene.empty())
        html += fmt::format(
            "<p>Scene: <code>{}</code></p>",
            escapeXml(entry.submission.scene.lexically_relative(entry.submission.folder).generic_string()));
    if (!entry.reproduce.empty())
        html += fmt::format("<div class=\"command\"><code>{}</code></div>", escapeXml(entry.reproduce));
    if (html.empty()) return html;
    return fmt::format("<details><summary>{}, {}</summary>{}</details>",
                       base::counted(entry.programs.size(), "program"), base::counted(own.size(), "uniform"),
                       html);
}

std::string cardHtml(const Classroom& room, std::size_t index, SourceLines& sources) {
    const Entry& entry = room.entries[index];
    std::string html =
        fmt::format("<article class=\"card\" id=\"{}\" data-name=\"{}\"><h3>{} {}</h3>", anchor(index),
                    escapeXml(entry.submission.name), nameHtml(entry.submission.name), stateHtml(entry));
    const std::string reason = reasonOf(entry);
    // The reason is one of the messages, unless the process ended or there is no scene.
    if (!reason.empty() && (entry.diagnostics.empty() || entry.drawsNothing))
        html += "<p class=\"reason\">" + escapeXml(reason) + "</p>";
    // What keeps a scene from being drawn comes before what is left of its pictures.
    const bool isDrawnWell = isDrawn(entry);
    const std::string messages = messagesHtml(entry, sources);
    if (!isDrawnWell) html += messages;
    html += picturesHtml({}, room, entry);
    if (isDrawnWell) html += messages;
    html += "<div class=\"grading\">" + marksHtml(room, entry, "pictures/") + "</div>";
    if (const std::string reactions = reactionsHtml(room, entry); !reactions.empty())
        html += "<p class=\"near\">Reacts: " + reactions + "</p>";
    if (const std::vector<std::string> alike = lookalikesOf(room, entry); !alike.empty())
        html += fmt::format("<p class=\"reason\">It reads a picture that looks like the reference's: {}</p>",
                            escapeXml(base::printableText(fmt::format("{}", fmt::join(alike, ", ")))));
    if (const std::optional<Nearest> nearest = nearestOf(room, index))
        html += fmt::format("<p class=\"near\">{} of its shader code is like that of {}</p>",
                            percentText(nearest->share), link(room, nearest->entry));
    if (!entry.notCompared.empty())
        html += fmt::format(
            "<p class=\"near\">Not compared with other submissions: {}</p>",
            escapeXml(base::printableText(fmt::format("{}", fmt::join(entry.notCompared, "; ")))));
    return html + factsHtml(room, entry) + "</article>\n";
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
std::string sideHtml(const Entry& entry, const MarkedLines& marked, SourceLines& sources) {
    std::string html = "<div>";
    for (const auto& [file, lines] : marked) {
        const std::string path = fs::path(file).lexically_relative(entry.submission.folder).generic_string();
        html += fmt::format("<h4>{}, {}</h4>", nameHtml(entry.submission.name),
                            escapeXml(path.empty() ? file : path));
        const int last = std::max(kMostLines, lines.rbegin()->first);
        const auto text = sources.lines(entry.submission, file, 1, std::min(last, 3 * kMostLines));
        if (!text) {
            html += "<p>the file cannot be read</p>";
            continue;
        }
        html += "<div class=\"source\"><ol>";
        for (std::size_t i = 0; i < text->size(); ++i) {
            const auto mark = lines.find(static_cast<int>(i) + 1);
            html += fmt::format("<li data-line=\"{}\"{}>{}</li>", i + 1,
                                mark == lines.end() ? "" : fmt::format(" class=\"p{}\"", mark->second % 6),
                                escapeXml((*text)[i]));
        }
        html += "</ol></div>";
    }
    return html + "</div>";
}

std::string pairHtml(const Classroom& room, const SimilarPair& pair, SourceLines& sources) {
    const Entry& a = comparedEntry(room, pair.a);
    const Entry& b = comparedEntry(room, pair.b);
    const std::vector<SharedPassage> passages = sharedPassages(a.files, room.fingerprints[pair.a], b.files,
                                                               room.fingerprints[pair.b], kMostPassages + 1);
    std::size_t tokens = 0;
    for (const SharedPassage& each : passages) tokens += each.tokens;
    std::string html =
        fmt::format("<details class=\"similar\"><summary>{} of {}, {} of {} <small>{}{}</small></summary>",
                    percentText(pair.ofA), nameHtml(a.submission.name), percentText(pair.ofB),
                    nameHtml(b.submission.name), passages.size() > kMostPassages ? "more than " : "",
                    base::counted(tokens, "equal token"));
    html += fmt::format("<p>{} and {}</p>", link(room, pair.a), link(room, pair.b));
    MarkedLines ofA, ofB;
    for (std::size_t i = 0; i < std::min(passages.size(), kMostPassages); ++i) {
        const SharedPassage& each = passages[i];
        if (!isInside(a, each.a, each.tokens) || !isInside(b, each.b, each.tokens)) continue;
        markLines(a, each.a, each.tokens, i, ofA);
        markLines(b, each.b, each.tokens, i, ofB);
    }
    if (!ofA.empty())
        html += "<div class=\"sides\">" + sideHtml(a, ofA, sources) + sideHtml(b, ofB, sources) + "</div>";
    if (passages.size() > kMostPassages) html += "<p>Shorter passages are not marked.</p>";
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

std::string openText(std::size_t count) {
    return count == 0 ? std::string() : fmt::format("{}", count);
}

/// "12 fields are not yet marked by hand", or nothing.
std::string openHtml(const Classroom& room) {
    std::size_t fields = 0, submissions = 0;
    for (const Entry& each : room.entries) {
        fields += openCount(each);
        submissions += openCount(each) > 0 ? 1 : 0;
    }
    return fmt::format("<p class=\"unmarked\" data-all=\"{}\">{}</p>", room.entries.size(),
                       fields == 0
                           ? std::string()
                           : fmt::format("Not yet marked by hand: {} of {}.", base::counted(fields, "field"),
                                         base::counted(submissions, "submission")));
}

std::string overviewHtml(const Classroom& room) {
    const bool scored = hasReference(room), marked = mostPoints(room) > 0, varied = !room.sliders.empty();
    const auto cell = [](const std::string& text) { return "<td>" + text + "</td>"; };
    std::string rows;
    for (std::size_t i = 0; i < room.entries.size(); ++i) {
        const Entry& entry = room.entries[i];
        const std::optional<Scores> scores = scoresOf(entry);
        const std::optional<Nearest> nearest = nearestOf(room, i);
        rows += "<tr><th>" + link(room, i) + "</th>" + cell(stateHtml(entry));
        if (marked)
            rows += fmt::format("<td class=\"points\">{:g}</td><td class=\"open\">{}</td>",
                                pointsOf(entry).value_or(0), openText(openCount(entry)));
        if (scored) rows += cell(scores ? figureText(scores->likeness) : "");
        if (varied) rows += cell(reactionsHtml(room, entry));
        if (scored)
            rows += cell(scores ? figureText(scores->flip) : "") +
                    cell(scores ? figureText(scores->structure) : "");
        rows += cell(fmt::format("{}", countOf(entry, Severity::error))) +
                cell(fmt::format("{}", countOf(entry, Severity::warning))) +
                cell(nearest ? percentText(nearest->share) + " like " +
                                   nameHtml(comparedEntry(room, nearest->entry).submission.name)
                             : "") +
                "</tr>\n";
    }
    return std::string("<table class=\"overview\"><thead><tr><th>submission</th><th>state</th>") +
           (marked ? "<th>points</th><th>to mark</th>" : "") + (scored ? "<th>likeness</th>" : "") +
           (varied ? "<th>reacts</th>" : "") + (scored ? "<th>FLIP</th><th>structure</th>" : "") +
           "<th>errors</th><th>warnings</th><th>most similar</th></tr></thead><tbody>\n" + rows +
           "</tbody></table>";
}

std::string referenceHtml(const Classroom& room, SourceLines& sources) {
    std::string html = "<div class=\"strip\">";
    for (std::size_t i = 0; i < room.reference.pictures.size(); ++i) {
        const Picture& picture = room.reference.pictures[i];
        html += pictureHtml({}, picture, picture, "the reference",
                            escapeXml(room.moments[i].label.empty()
                                          ? fmt::format("{} x {} pixels", picture.width, picture.height)
                                          : room.moments[i].label));
    }
    return html + "</div>" + messagesHtml(room.reference, sources) + programsHtml(room.reference);
}

/// The cards of all entries that are drawn, or of all others.
std::string cardsHtml(const Classroom& room, bool drawn, SourceLines& sources) {
    std::string html;
    for (std::size_t i = 0; i < room.entries.size(); ++i)
        if ((stateOf(room.entries[i]) == "drawn") == drawn) html += cardHtml(room, i, sources);
    return html;
}

std::string section(const char* id, const char* title, const std::string& content) {
    if (content.empty()) return {};
    return fmt::format("<section id=\"{}\"><h2>{}</h2>{}</section>\n", id, title, content);
}

std::string leftOutHtml(const Classroom& room) {
    const auto list = [](const char* title, const std::vector<std::string>& names) {
        std::string items;
        for (const std::string& each : names) items += "<li>" + nameHtml(each) + "</li>";
        return items.empty() ? items : fmt::format("<p>{}</p><ul>{}</ul>", title, items);
    };
    std::vector<std::string> earlier;
    for (const Entry& each : room.earlier)
        if (each.submission.scene.empty()) earlier.push_back(each.submission.name);
    return list("These files are no scenes, zip files or folders.", room.leftOut) +
           list("These earlier submissions are not compared, because they have no scene.", earlier) +
           list("These students of the roster handed in nothing that was found.", room.absent) +
           list("These points and comments of marks.json belong to no submission or check.", room.unplaced);
}

std::string detailsHtml(const Classroom& room) {
    std::string html = "<dl>";
    const auto add = [&](std::string_view title, const std::string& value) {
        if (!value.empty()) html += fmt::format("<dt>{}</dt><dd>{}</dd>", title, escapeXml(value));
    };
    if (!room.isAnonymous) add("Submissions", room.folder);
    add("Reference", room.reference.submission.scene.generic_string());
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

std::string_view classScript() {
    return class_page::class_js();
}

std::string_view gradeScript() {
    return class_page::grade_js();
}

std::string classPage(const Classroom& room, bool serves) {
    SourceLines sources;
    const std::string failed =
        section("failed", "Not drawn, or nothing to see", grid(cardsHtml(room, false, sources)));
    const std::string drawn = section("drawn", "Drawn", grid(cardsHtml(room, true, sources)));
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
        {"connect", serves ? "; connect-src 'self'" : ""},
        {"scripts", serves ? "\n<script src=\"grade.js\" defer></script>" : ""},
        {"reference",
         hasReference(room) ? section("reference", "Reference", referenceHtml(room, sources)) : ""},
        {"referenceLink", hasReference(room) ? "<a href=\"#reference\">Reference</a> " : ""},
        {"overview", (mostPoints(room) > 0 ? openHtml(room) : "") + overviewHtml(room)},
        {"failed", failed},
        {"drawn", drawn},
        {"similar", similarHtml(room)},
        {"common", fmt::format("{}", room.common)},
        {"leftOut", leftOut},
        {"gram", fmt::format("{}", kLongestUnseen + 1)},
    };
    return suite::loadingFirstScreen(base::filled(class_page::class_html(), slots));
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
